"""The comparison with other meshers as text, CSV and JSON."""

import csv
import io
import json
import textwrap
from collections.abc import Sequence

from gmpy2 import mpq

from exactmesh.numbers.rational import sqrt_text, text_from_rational
from exactmesh.report import table
from exactmesh.reproduce.peer_inputs import HARD_GROUPS
from exactmesh.reproduce.peers import PeerRow

_WIDTH = 118
_DIGITS = 4
_COLUMNS = ("group", "input", "n", "mesher", "status", "message", "degradation_squared", "degradation", "is_mesh",
            "steiner", "boundary", "faces", "seconds")
_NOTES = (
    "Degradations are exact and rounded only here: mfs(input) / mfs(mesh). Inputs are rounded to doubles first. "
    "median, 95% and worst are over the inputs that the mesher took; a mesh whose faces cross counts as infinitely "
    "bad. exact: how many are exactly meshes of their input. boundary: vertices put on the boundary, in all.",
    "In the second table +b counts vertices on the boundary and ! says that the mesh is not exactly one of its input: "
    "its degradation is then that of its own edges; \"crossing\" where these are no planar graph.",
    "Seconds are of processor time, of the mesher alone; for exactmesh with exact verification. The other meshers are "
    "made for other aims too, such as angles and sizes, which are not looked at here.",
)


def peers_text(rows: Sequence[PeerRow]) -> str:
    """Return a table of figures over the ordinary inputs, and one of all hard inputs."""
    tools = list(dict.fromkeys(row.tool for row in rows))
    figures: list[Sequence[str]] = [("ordinary inputs", "taken", "exact", "median", "95%", "worst", "boundary",
                                     "Steiner", "faces", "seconds")]
    figures += [_figures(tool, [row for row in rows if row.tool == tool and row.group not in HARD_GROUPS])
                for tool in tools]
    cells: dict[tuple[str, str], dict[str, str]] = {}
    for row in rows:
        if row.group in HARD_GROUPS:
            cells.setdefault((row.group, row.name), {})[row.tool] = _cell(row)
    hard: list[Sequence[str]] = [("hard inputs", "", *tools)]
    hard += [(group, name, *(found.get(tool, "") for tool in tools)) for (group, name), found in cells.items()]
    return "\n\n".join([table(figures, right=range(1, 10)), table(hard, right=range(2, 2 + len(tools))),
                        "\n".join(textwrap.fill(note, _WIDTH) for note in _NOTES)])


def _figures(tool: str, rows: Sequence[PeerRow]) -> Sequence[str]:
    """Return the line of one mesher over the ordinary inputs."""
    if not rows or all(row.status == "not installed" for row in rows):
        return (tool, "not installed" if rows else "", *[""] * 8)
    made = [row.measured for row in rows if row.measured is not None]
    taken = [row for row in rows if row.status != "not taken"]
    # What failed, or crosses itself, comes last: as bad as can be.
    squares: list[mpq | None] = sorted(m.degradation_squared for m in made if m.degradation_squared is not None)
    squares += [None] * (len(taken) - len(squares))
    if not squares:
        return (tool, f"0 of {len(rows)}", *[""] * 8)

    def share(part: mpq) -> str:
        value = squares[min(len(squares) - 1, int(part * len(squares)))]
        return "infinite" if value is None else _root(value)

    return (tool, f"{len(taken)} of {len(rows)}", str(sum(m.is_mesh for m in made)), share(mpq(1, 2)),
            share(mpq(19, 20)), share(mpq(1)), str(sum(m.boundary for m in made)), str(sum(m.steiner for m in made)),
            str(sum(m.faces for m in made)), f"{sum(row.seconds for row in rows):.1f}")


def _root(squared: mpq) -> str:
    return sqrt_text(squared, _DIGITS) if squared < 10**14 else f"{float(sqrt_text(squared, _DIGITS)):.1e}"


def _cell(row: PeerRow) -> str:
    measured = row.measured
    if measured is None:
        return row.status
    squared = measured.degradation_squared
    return (("crossing" if squared is None else _root(squared))
            + (f" +{measured.boundary}" if measured.boundary else "") + ("" if measured.is_mesh else " !"))


def _record(row: PeerRow) -> dict[str, object]:
    measured = row.measured
    squared = None if measured is None else measured.degradation_squared
    return {
        "group": row.group, "input": row.name, "n": row.n, "mesher": row.tool, "status": row.status,
        "message": row.message, "degradation_squared": None if squared is None else text_from_rational(squared),
        "degradation": None if squared is None else sqrt_text(squared),
        "is_mesh": None if measured is None else measured.is_mesh,
        "steiner": None if measured is None else measured.steiner,
        "boundary": None if measured is None else measured.boundary,
        "faces": None if measured is None else measured.faces, "seconds": round(row.seconds, 3)}


def peers_csv(rows: Sequence[PeerRow]) -> str:
    """Return the rows as CSV; the degradation is exact as a square, and a decimal beside it."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, _COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(_record(row) for row in rows)
    return stream.getvalue()


def peers_json(rows: Sequence[PeerRow]) -> str:
    """Return the rows with exact squares."""
    return json.dumps({"peers": [_record(row) for row in rows]}, indent=1)
