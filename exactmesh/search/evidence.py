"""What a store says of claims: inputs, instances, violations and the worst value, summed over its runs."""

import json
from collections.abc import Mapping, Sequence
from html import escape

from exactmesh.report import table
from exactmesh.search.driver import Key, Sum, add_row, worst_text
from exactmesh.search.figure import Figure
from exactmesh.search.show import page_head
from exactmesh.search.store import Row, Store

_SHOWN = 60
Evidence = Mapping[Key, Sum]


def evidence_in(store: Store, runs: Sequence[int] | None = None) -> dict[Key, Sum]:
    """Return the sums of some runs of a store, or of all, by claim, construction and kind.

    An input that two runs judged counts twice.
    """
    found: dict[Key, Sum] = {}
    for run in [row["id"] for row in store.runs()] if runs is None else runs:
        for row in store.results(run):
            add_row(found, row)
    for find in store.finds():
        total = found.get((find["claim"], find["construction"], find["kind"]))
        # A run that met no violation is not refuted by the finds of others; the store as a whole is.
        if total is not None and find["label"] == "violation" and find["confirmed"] and (runs is None
                                                                                         or total.violations):
            total.confirmed += 1
    return found


def status_of(total: Sum) -> str:
    """Return what the ledger says of a claim on this evidence: refuted only by what the independent check confirms."""
    if total.violations or total.confirmed:
        fails = f"fails on {total.violations} of {total.judged} inputs"
        return f"refuted: {fails}, {total.confirmed} confirmed" if total.confirmed else f"{fails}, none confirmed"
    if total.crashes:
        return f"not shown: the program fails on {total.crashes} of {total.judged} inputs"
    return f"holds on {total.instances} instances" if total.instances else "open: no instance"


def evidence_records(found: Evidence) -> list[dict[str, object]]:
    """Return the sums as JSON, a record a claim, construction and kind."""
    records: list[dict[str, object]] = []
    for (claim, construction, kind), total in sorted(found.items()):
        worst = total.worst
        shown = json.loads(worst["shown"]) if worst else {}
        records.append({
            "id": claim, "construction": construction, "kind": kind, "status": status_of(total),
            "inputs": total.judged, "not_for": total.skipped, "instances": total.instances,
            "violations": total.violations, "confirmed": total.confirmed, "crashes": total.crashes,
            "worst": shown.get("worst"), "witness": None if worst is None else {
                "input": worst["input"], "figure": json.loads(worst["figure"]), "place": shown.get("witness")}})
    return records


def evidence_lines(found: Evidence, claim: str) -> list[str]:
    """Return what the ledger says of one claim, a line a construction and kind: status, worst value, witness."""
    lines = []
    for (name, construction, kind), total in sorted(found.items()):
        if name == claim:
            worst = f", worst {worst_text(total.worst)} on {_on(total.worst)}" if total.worst else ""
            lines.append(f"{status_of(total)} ({construction}, {kind}){worst}")
    return lines


def verification_record(found: Evidence, refused: list[str]) -> dict[str, object]:
    """Return an `exactmesh-verification-run/1` report."""
    return {"format": "exactmesh-verification-run/1", "claims": evidence_records(found), "refused": refused}


def evidence_text(found: Evidence) -> str:
    """Return the sums as a table."""
    lines = [("claim", "construction", "kind", "inputs", "status", "worst", "on")]
    for key, total in sorted(found.items()):
        on = _on(total.worst)
        lines.append((*key, str(total.judged), status_of(total), worst_text(total.worst),
                      on if len(on) <= _SHOWN else on[: _SHOWN - 3] + "..."))
    return table(lines, right=(3,))


def verification_text(found: Evidence, refused: list[str]) -> str:
    """Return the sums of a verification run as a table, and the inputs that were refused."""
    return "\n".join([evidence_text(found), *(f"refused: {text}" for text in refused)])


def verification_html(found: Evidence, refused: list[str]) -> str:
    """Return the sums of a verification run as a page."""
    parts = [page_head("Verification run"), "<table><tr><th>claim</th><th>construction</th><th>kind</th>"
             "<th>inputs</th><th>status</th><th>worst</th><th>on</th></tr>"]
    for key, total in sorted(found.items()):
        cells = (*key, total.judged, status_of(total), worst_text(total.worst), _on(total.worst))
        state = ' class="no"' if total.violations or total.crashes else ""
        parts.append(f"<tr{state}>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in cells) + "</tr>")
    parts += ["</table>", *(f"<p>refused: {escape(text)}</p>" for text in refused), "</body></html>", ""]
    return "\n".join(parts)


def _on(worst: Row | None) -> str:
    """Return the name of the input with the worst value, or the figure itself."""
    if worst is None:
        return ""
    return str(worst["input"]) or Figure.from_json(json.loads(worst["figure"])).text()
