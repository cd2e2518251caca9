"""The ledger of claims and the table of the paper's numbers, as JSON and as text."""

import json
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType

from exactmesh.claims.bounds import Row
from exactmesh.claims.status import Entry, Judged
from exactmesh.claims.unsettled import UNSETTLED
from exactmesh.report import claim_json, table

_WIDTH = 110


def ledger_json(entries: Iterable[Entry], evidence: Mapping[str, object] = MappingProxyType({})) -> str:
    """Return what `exactmesh claims --json` prints; `evidence` is what a store says, by claim."""
    return json.dumps({"claims": [{**_entry(entry), **({"evidence": evidence[entry.claim.id]}
                                                       if entry.claim.id in evidence else {})}
                                  for entry in entries]}, indent=1)


def ledger_text(entries: Iterable[Entry], evidence: Mapping[str, Sequence[str]] | None = None) -> str:
    """Return the ledger as a table; `evidence` is what a store says, by claim, and makes one more column."""
    rows = [("claim", "place", "status", "instances", "statement", *([] if evidence is None else ["in the store"]))]
    rows += [(entry.claim.id, entry.claim.paper, _status(entry), str(entry.instances), entry.claim.says,
              *([] if evidence is None else ["; ".join(evidence.get(entry.claim.id, ()))])) for entry in entries]
    return table(rows, right=(3,))


def entry_text(entry: Entry, evidence: Sequence[str] = ()) -> str:
    """Return all there is to say of one claim; `evidence` is what a store says."""
    claim = entry.claim
    lines = [claim.id, f"place       {claim.paper}", f"statement   {claim.says}"]
    lines += [f"given       {given}" for given in claim.given]
    if claim.bound:
        lines.append(f"bound       {claim.bound}")
    if entry.proved:
        lines.append(f"proved      for all inputs; re-checked now, as by: exactmesh prove {claim.id} --fast")
    elif entry.disproved:
        lines.append(f"refuted     by proof; re-checked now, as by: exactmesh prove {claim.id} --fast")
    for judged in entry.judged:
        met = f"in {judged.instances} instances ({judged.construction} construction)"
        lines.append(f"status      {judged.status} {met}")
        if judged.witness:
            lines.append(f"witness     {judged.witness}, {_worst(entry, judged)}")
            lines.append(f"shown by    {_command(entry, judged)}")
    lines += [f"in store    {line}" for line in evidence]
    unsettled = UNSETTLED.get(claim.id, "") if entry.status in ("open", "holds") else ""
    for name, text in (("unsettled   ", unsettled), ("corrected   ", claim.corrected), ("repair      ", claim.repair)):
        if text:
            lines += textwrap.wrap(text, _WIDTH, initial_indent=name, subsequent_indent=" " * len(name))
    return "\n".join(lines)


def bounds_json(rows: Iterable[Row]) -> str:
    """Return what `exactmesh reproduce bounds --json` prints."""
    return json.dumps({"bounds": [
        {"name": row.name, "paper": row.place, "stated": row.stated,
         "octagon": {"exact": row.octagon.expression(), "decimal": row.octagon.decimal(), "agrees": row.octagon_agrees},
         "tube": {"exact": row.tube.expression(), "decimal": row.tube.decimal(), "agrees": row.tube_agrees}}
        for row in rows]}, indent=1)


def bounds_text(rows: Iterable[Row]) -> str:
    """Return the paper's numbers beside their exact values as a table."""
    lines: list[Sequence[str]] = [("number", "place", "stated", "1/d3 = sin(pi/8)/2", "", "d3 = 4 sqrt(2)", "")]
    lines += [(row.name, row.place, row.stated, row.octagon.decimal(7), _agreement(row.octagon_agrees),
               row.tube.decimal(7), _agreement(row.tube_agrees)) for row in rows]
    return table(lines, right=(3, 5))


def _agreement(agrees: bool) -> str:
    return "agrees" if agrees else "DIFFERS"


def _status(entry: Entry) -> str:
    """Return the status, construction by construction where they differ."""
    statuses = {judged.status for judged in entry.judged}
    if len(statuses) < 2:
        return entry.status
    return ", ".join(f"{judged.status} ({judged.construction})" for judged in entry.judged)


def _worst(entry: Entry, judged: Judged) -> str:
    if judged.verdict is None:
        return ""
    shown = claim_json(entry.claim, judged.verdict)
    worst = shown["worst"]
    value = f"worst {worst['decimal']}" if isinstance(worst, dict) else "a clause that fails"
    clause = judged.verdict.witness.clause if judged.verdict.witness else ""
    return f"{value} ({clause})"


def _command(entry: Entry, judged: Judged) -> str:
    return f"exactmesh claims {entry.claim.id} --witness {judged.witness} --construction {judged.construction}"


def _entry(entry: Entry) -> dict[str, object]:
    claim = entry.claim
    return {
        "id": claim.id, "paper": claim.paper, "statement": claim.says, "given": list(claim.given),
        "bound": claim.bound, "status": entry.status, "instances": entry.instances,
        "runs": [{"construction": judged.construction, "status": judged.status, "instances": judged.instances,
                  "witness": None if judged.verdict is None else {
                      "file": judged.witness, "command": _command(entry, judged),
                      **{key: value for key, value in claim_json(claim, judged.verdict).items()
                         if key in ("worst", "witness")}}} for judged in entry.judged],
        "unsettled": UNSETTLED.get(claim.id, "") if entry.status in ("open", "holds") else "",
        "corrected": claim.corrected, "repair": claim.repair,
    }
