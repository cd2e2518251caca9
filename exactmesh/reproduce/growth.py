"""How the degradation grows along a family, beside what the paper says of it.

The verdict is that of all rows, each checked exactly (`table1.check`). The fit is for reading: it is made with floats,
by least squares over the larger half of the sizes, and decides nothing.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import log, log2, sqrt
from statistics import linear_regression

from gmpy2 import mpq

from exactmesh.reproduce.families import Family
from exactmesh.reproduce.table1 import Made, Row, check, clause

# What Table 1 says; of classic meshes it is said family by family.
_PAPER: dict[Made, str] = {"nonproper": "Theta(1)", "proper": "O(log n)", "internal": "Theta(1)"}


@dataclass(frozen=True, slots=True)
class Law:
    """The rows of one family made in one way. `greatest` is the greatest squared degradation, None when a mesh is not
    valid; `holds` is None when there is nothing to check, and `failures` are the rows where it fails."""

    family: Family
    made: Made
    measure: str
    paper: str
    rows: int
    greatest: mpq | None
    fit: str
    clause: str
    holds: bool | None
    failures: tuple[str, ...]


def laws(rows: Iterable[Row]) -> list[Law]:
    """Return the law of each family and way of meshing, in the order in which they are first met."""
    groups: dict[tuple[str, Made], list[Row]] = {}
    for row in rows:
        groups.setdefault((row.family.name, row.made), []).append(row)
    return [_law(group) for group in groups.values()]


def fit(made: Made, against: str, points: Sequence[tuple[int, float]]) -> str:
    """Return in words how the degradations at rising places grow; empty where two places are not to be had.

    A power for classic meshes, a logarithm for proper ones; for the others, which must not grow, the last quotient.
    """
    half = points[-max(2, (len(points) + 1) // 2) :]
    if len({place for place, _ in half}) < 2:
        return ""
    if made in ("classic", "optimal"):
        line = linear_regression([log(place) for place, _ in half], [log(value) for _, value in half])
        return f"{against}^{line.slope:.3f}"
    if made == "proper":
        line = linear_regression([log2(place) for place, _ in half], [value for _, value in half])
        return f"{line.slope:+.2f} log2 {against}"
    return f"x {half[-1][1] / half[-2][1]:.3f} at the last step"


def _law(group: Sequence[Row]) -> Law:
    family, made = group[0].family, group[0].made
    verdicts = [(row, check(row)) for row in group]
    judged = [verdict for _, verdict in verdicts if verdict is not None]
    failures = tuple(f"{family.name} {family.variable} = {row.size}, {made}: {verdict.witness.clause}"
                     for row, verdict in verdicts if verdict is not None and not verdict.holds and verdict.witness)
    squares = [row.degradation_squared for row in group]
    known = [squared for squared in squares if squared is not None]
    points = [(row.place, sqrt(float(squared))) for row, squared in zip(group, squares, strict=True)
              if squared is not None]
    paper = _PAPER.get(made, family.paper)
    return Law(family, made, group[0].measure, paper, len(group), max(known) if len(known) == len(group) else None,
               fit(made, family.against, points), clause(family, made),
               all(verdict.holds for verdict in judged) if judged else None, failures)
