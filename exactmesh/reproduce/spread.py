"""How the published construction's degradation grows with the spread, and the repaired one's does not.

Two families of rooms of length L: an L-shaped hexagon, and a rectangle with one spike near one end. A trapezoid as
long as the room has a T-vertex near its end, and the one vertex that the paper puts into it is far away.
"""

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from math import sqrt

from gmpy2 import mpq

from exactmesh.claims.run import ConstructionName, Run
from exactmesh.numbers.rational import sqrt_text, text_from_rational
from exactmesh.planar.pslg import Pslg, polygon
from exactmesh.report import table
from exactmesh.reproduce.plot import Panel, Series, svg_of
from exactmesh.steps.constants import DESIGN_DEGRADATION, PAPER_DEGRADATION

LENGTHS = (4, 16, 44, 96, 192, 1000, 10_000)


def l_shape(length: int) -> Pslg:
    """Return the hexagon (0,1), (2,1), (2,0), (L,0), (L,2), (0,2) of length L > 2; its mfs is 1."""
    return polygon([(0, 1), (2, 1), (2, 0), (length, 0), (length, 2), (0, 2)], f"L-shape of length {length}")


def spike_room(length: int) -> Pslg:
    """Return a room of length L > 2 and height 2 with a spike that hangs from its ceiling near the left end."""
    corners: list[tuple[int | str, int]] = [(0, 0), (length, 0), (length, 2), (2, 2), ("3/2", 1), (1, 2), (0, 2)]
    return polygon(corners, f"room of length {length} with a spike")


_FAMILIES: tuple[tuple[str, Callable[[int], Pslg]], ...] = (("L-shape", l_shape), ("spike room", spike_room))


@dataclass(frozen=True, slots=True)
class SpreadRow:
    """The squared degradations of one room by both constructions."""

    family: str
    length: int
    paper: mpq
    repaired: mpq


def spread_inputs() -> list[Pslg]:
    """Return the rooms of both families by length."""
    return [room(length) for _, room in _FAMILIES for length in LENGTHS]


def spread_rows(progress: Callable[[str], None]) -> Iterator[SpreadRow]:
    """Yield the rooms of each family by length; `progress` is told each."""
    for name, room in _FAMILIES:
        for length in LENGTHS:
            progress(f"{name}, L = {length}")
            pslg = room(length)
            yield SpreadRow(name, length, _degradation(pslg, "paper"), _degradation(pslg, "repaired"))


def _degradation(pslg: Pslg, construction: ConstructionName) -> mpq:
    squared = Run(pslg, construction).verification.degradation_squared
    if squared is None:
        raise AssertionError("the meshes of these rooms are valid")
    return squared


def spread_text(rows: Sequence[SpreadRow]) -> str:
    """Return the rows as a table; the last columns are the degradations over L."""
    lines: list[Sequence[str]] = [("family", "L", "paper", "repaired", "paper / L")]
    lines += [(row.family, str(row.length), sqrt_text(row.paper, 6), sqrt_text(row.repaired, 6),
               sqrt_text(row.paper / row.length**2, 4)) for row in rows]
    return table(lines, right=(1, 2, 3, 4))


def spread_svg(rows: Sequence[SpreadRow]) -> str:
    """Return log-log plots of the degradation against L, one for each family."""
    panels = []
    for family in dict.fromkeys(row.family for row in rows):
        mine = [row for row in rows if row.family == family]
        paper = tuple((float(row.length), sqrt(float(row.paper))) for row in mine)
        repaired = tuple((float(row.length), sqrt(float(row.repaired))) for row in mine)
        panels.append(Panel(family, "L", (Series("paper", paper), Series("repaired", repaired))))
    levels = [(float(bound), f"{float(bound):g}") for bound in (DESIGN_DEGRADATION, PAPER_DEGRADATION)]
    return svg_of("Degradation in rooms of length L", panels, levels)


def spread_json(rows: Sequence[SpreadRow]) -> str:
    """Return the rows with exact squares."""
    return json.dumps({"spread": [
        {"family": row.family, "length": row.length,
         "degradation_squared": {"paper": text_from_rational(row.paper), "repaired": text_from_rational(row.repaired)}}
        for row in rows]}, indent=1)
