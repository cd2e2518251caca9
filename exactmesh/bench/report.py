"""The measurements as tables, JSON and a picture. Nothing is decided here."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict

from exactmesh.bench.inputs import WHAT
from exactmesh.bench.measure import Beside, Results, Row, exponent
from exactmesh.bench.peers import PEERS
from exactmesh.bench.worker import STAGES
from exactmesh.errors import InputError
from exactmesh.report import table
from exactmesh.reproduce.plot import Panel, Series, svg_of

# Growth is fitted from here on, where there are two sizes.
_LARGE = 10_000
_MEBI, _GIBI = 2.0**20, 2.0**30
_MAKING = ("validate", "mfs", "construct")
_NOTES = """\
Times are of the processor, one process to a row; those of the clock are in the JSON. memory: the greatest of the
process. growth: the power of n, by least squares over the sizes from 10,000 on (all, where there are not two of them);
that of memory is of what the process had more than before it read the input. construct: the mesh; verify: the
independent verification; check: all step checkers; write, reread: the file of the mesh. exact: decisions left to exact
arithmetic, of all that floats were asked for. A peer's row: both in one process, one after the other."""


def bench_text(results: Results, machine: str) -> str:
    """Return all tables for reading."""
    parts = [machine]
    rows = [row for row in results.rows if not row.failure]
    stages = [stage for stage in STAGES if any(stage in row.cpu for row in rows)]
    if results.rows:
        parts.append("microseconds a vertex")
        parts.append(_sizes(results.rows, stages))
        parts.append("growth\n\n" + _growths(rows, stages))
        if any(row.decisions for row in rows):
            parts.append(_decisions(rows))
    if results.beside:
        parts.append(_peers(results.beside))
    families = dict.fromkeys(row.family for row in results.rows)
    parts.append("\n".join(f"{family}: {WHAT[family]}" for family in families))
    return "\n\n".join([*parts, _NOTES])


def _sizes(rows: Sequence[Row], stages: Sequence[str]) -> str:
    last = "verify/construct" if "verify" in stages else ""
    lines: list[Sequence[str]] = [("family", "n", *stages, "all, s", "memory, MiB", last, "")]
    for row in rows:
        if row.failure:
            lines.append((row.family, str(row.n), *("" for _ in stages), "", "", "", row.failure))
            continue
        each = [f"{1e6 * row.cpu[stage] / row.n:.1f}" if stage in row.cpu else "" for stage in stages]
        ratio = f"{row.cpu['verify'] / row.cpu['construct']:.2f}" if "verify" in row.cpu else ""
        lines.append((row.family, str(row.n), *each, f"{sum(row.cpu.values()):.1f}", f"{row.memory / _MEBI:.0f}", ratio,
                      "" if row.holds else "NOT VALID"))
    return table(lines, right=range(1, len(stages) + 5))


def _growths(rows: Sequence[Row], stages: Sequence[str]) -> str:
    lines: list[Sequence[str]] = [("family", *stages, "all", "memory")]
    for family in dict.fromkeys(row.family for row in rows):
        here = _fitted([row for row in rows if row.family == family])
        found = [exponent([(row.n, row.cpu[stage]) for row in here if stage in row.cpu]) for stage in stages]
        found.append(exponent([(row.n, sum(row.cpu.values())) for row in here]))
        found.append(exponent([(row.n, row.added_memory) for row in here]))
        lines.append((family, *("" if power is None else f"{power:.2f}" for power in found)))
    return table(lines, right=range(1, len(stages) + 3))


def _fitted(rows: Sequence[Row]) -> Sequence[Row]:
    large = [row for row in rows if row.n >= _LARGE]
    return large if len({row.n for row in large}) > 1 else rows


def _decisions(rows: Sequence[Row]) -> str:
    """Return how many decisions there were a vertex, and how many exact ones, at the greatest size of each family."""
    names = list(dict.fromkeys(name for row in rows for name in row.decisions))
    last = {row.family: row for row in rows}
    lines: list[Sequence[str]] = [("decisions a vertex, exact ones", *last)]
    for name in names:
        cells = []
        for row in last.values():
            by_floats, exactly = row.decisions.get(name, (0, 0))
            cells.append(f"{(by_floats + exactly) / row.n:.1f}, {exactly / row.n:.2f}")
        lines.append((name, *cells))
    return table(lines, right=range(1, len(last) + 1))


def _peers(beside: Sequence[Beside]) -> str:
    lines: list[Sequence[str]] = [("beside", "ours", "family", "n", "ours, s", "theirs, s", "ours/theirs", "at most",
                                   "")]
    for row in beside:
        peer = PEERS[row.peer]
        target = "" if row.target is None else f"{row.target:g}"
        if row.failure or row.ratio is None:
            lines.append((peer.name, peer.what, row.family, str(row.n), "", "", "", target, row.failure))
            continue
        met = "" if row.target is None else "met" if row.ratio <= row.target else "MISSED"
        lines.append((peer.name, peer.what, row.family, str(row.n), f"{row.ours:.3f}", f"{row.theirs:.3f}",
                      f"{row.ratio:.3g}", target, met))
    return table(lines, right=(3, 4, 5, 6, 7))


def bench_json(results: Results, machine: str) -> str:
    """Return all measurements: seconds, bytes, exponents."""
    rows = [row for row in results.rows if not row.failure]
    growth: dict[str, Mapping[str, float | None]] = {}
    for family in dict.fromkeys(row.family for row in rows):
        here = _fitted([row for row in rows if row.family == family])
        powers = {stage: exponent([(row.n, row.cpu[stage]) for row in here if stage in row.cpu]) for stage in STAGES}
        growth[family] = powers | {"all": exponent([(row.n, sum(row.cpu.values())) for row in here]),
                                   "memory": exponent([(row.n, row.added_memory) for row in here])}
    return json.dumps({"machine": machine, "rows": [asdict(row) for row in results.rows], "growth": growth,
                       "peers": [asdict(row) | {"ratio": row.ratio} for row in results.beside]}, indent=1)


def results_of(text: str, machine: str, path: str) -> Results:
    """Return the measurements that `bench_json` wrote to the file `path`.

    Raises `InputError` for another text, and for measurements of another machine.
    """
    try:
        found = json.loads(text)
        decisions = [{name: (by_floats, exactly) for name, (by_floats, exactly) in row["decisions"].items()}
                     for row in found["rows"]]
        rows = [Row(**row | {"decisions": each}) for row, each in zip(found["rows"], decisions, strict=True)]
        beside = [Beside(**{key: value for key, value in row.items() if key != "ratio"}) for row in found["peers"]]
        where = found["machine"]
        if not {row.family for row in rows} <= WHAT.keys() or not {row.peer for row in beside} <= PEERS.keys():
            raise ValueError
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"{path}: no measurements of exactmesh bench") from error
    if where != machine:
        raise InputError(f"{path}: measured on another machine: {where}")
    return Results(rows, beside)


def bench_svg(results: Results, machine: str) -> str:
    """Return log-log plots against n, a panel for each family: seconds, with the peers' lines, and GiB."""
    panels = []
    rows = [row for row in results.rows if not row.failure]
    beside = [row for row in results.beside if not row.failure]
    for family in dict.fromkeys([*(row.family for row in rows), *(row.family for row in beside)]):
        here = [row for row in rows if row.family == family]
        lines = {"mfs, s": [(row.n, row.cpu["mfs"]) for row in here if "mfs" in row.cpu],
                 "mesh, s": [(row.n, sum(row.cpu[stage] for stage in (*_MAKING, "verify", "check")))
                             for row in here if "check" in row.cpu],
                 "verify, s": [(row.n, row.cpu["verify"]) for row in here if "verify" in row.cpu],
                 "memory, GiB": [(row.n, row.memory / _GIBI) for row in here]}
        for other in beside:
            if other.family == family:
                lines.setdefault(f"{other.peer}, s", []).append((other.n, max(other.theirs, 1e-6)))
        panels.append(Panel(f"{family}: {WHAT[family]}", "vertices", tuple(
            Series(name, tuple(sorted((float(n), max(value, 1e-6)) for n, value in points)))
            for name, points in lines.items() if points)))
    return svg_of(f"Time and memory. {machine}", panels)
