"""The paper's numbers against their exact values, under both readings of d3 (`exactmesh reproduce bounds`).

A number the paper rounds agrees when the exact value is less than one unit of its last digit away: the paper both
rounds and truncates. A bound agrees when it holds.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.measure.verdict import Relation, satisfies
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.rational import rational_from_text
from exactmesh.steps.reading import READINGS, Reading, sin_eighth


@dataclass(frozen=True, slots=True)
class Row:
    """A number of the paper: `stated` as there; the exact value and whether it agrees, under each reading."""

    name: str
    place: str
    stated: str
    octagon: Real
    octagon_agrees: bool
    tube: Real
    tube_agrees: bool


def bounds() -> Iterator[Row]:
    """Yield the rows of the table; lengths are in units of the input's mfs."""
    for name, place, stated, value in _NUMBERS:
        octagon, tube = (Real(value(READINGS[reading])) for reading in ("octagon", "tube"))
        yield Row(name, place, stated, octagon, _agrees(stated, octagon), tube, _agrees(stated, tube))


_RELATIONS: dict[str, Relation] = {"<": "<", ">": ">", ">=": ">=", "=": "=="}


def _agrees(stated: str, value: Real) -> bool:
    relation, _, number = stated.rpartition(" ")
    if number in _EXACT:
        bound: Real | mpq = _EXACT[number]
    else:
        bound = rational_from_text(number)
    if relation:
        return satisfies(value, _RELATIONS[relation], bound)
    digits = len(number.partition(".")[2])
    return bool(abs(value - bound) < mpq(1, 10**digits))


_EXACT = {"4*sqrt(2)": 4 * sqrt(2), "sqrt(2)/4": sqrt(2) / 4, "1/(16*sqrt(2))": 1 / (16 * sqrt(2))}
_CHORDS = 1 / (4 * sqrt(2))


def _g(reading: Reading) -> Real:
    """Return the granularity 1/(2 d3)."""
    return reading.inverse_d3 / 2


def _harmonic(a: Real, b: Real) -> Real:
    """Return the height of a right triangle with legs a and b over its longest side."""
    height: Real = a * b / (a * a + b * b).sqrt()
    return height


def _fan(reading: Reading) -> Real:
    """Return Lemma 3's f1 = w (h/6)/sqrt(w^2 + (h/6)^2) for w = 1/(2 d3), h = 1/4 - w."""
    return _harmonic(_g(reading), (mpq(1, 4) - _g(reading)) / 6)


def _literal_teeth(reading: Reading) -> Real:
    """Return the limit h w/sqrt(16 h^2 + 9 w^2) of what the teeth over the middles of the gaps leave."""
    w, h = _g(reading), mpq(1, 4) - _g(reading)
    limit: Real = h * w / (16 * h * h + 9 * w * w).sqrt()
    return limit


_Value = Callable[[Reading], "Real | mpq"]
_NUMBERS: tuple[tuple[str, str, str, _Value], ...] = (
    ("offset edge |e'| at a right angle, unit square", "Appendix A", "= 1/2", lambda r: mpq(1, 2)),
    ("infimum of |e'| over triangles", "Appendix A", ">= 1/2", lambda r: sqrt(3) / 6),
    ("feature size of P3, 1/d3", "section 2", "0.19", lambda r: r.inverse_d3),
    ("side of the octagon of diameter 1/4", "section 2", "0.19", lambda r: sin_eighth() / 4),
    ("side of the octagon of radius 1/4", "section 2", "0.19", lambda r: sin_eighth() / 2),
    ("d_tube3, chords of a half circle", "section 2", "= 4*sqrt(2)", lambda r: 1 / _CHORDS),
    ("reach of a prolonged edge", "section 2", "= sqrt(2)/4", lambda r: sqrt(2) / 4),
    ("what two such edges leave between", "section 2", "0.29", lambda r: 1 - sqrt(2) / 2),
    ("degradation by snapping", "section 2", "= 2", lambda r: sin_eighth() / 2 / (sin_eighth() / 2 - _g(r))),
    ("least distance of P and P4, less 1/(2 d3)", "section 2", "> 0", lambda r: _CHORDS - _g(r) / 2 - _g(r)),
    ("feature size of the Interior, 1/(2 d3 d6)", "section 2", "0.047", lambda r: _g(r) / 2),
    ("feature size of the fans, 1/(2 d3 sqrt 2)", "phase 1", "0.067", lambda r: _g(r) / sqrt(2)),
    ("sine of the least angle that snapping may leave", "phase 1", ">= 0.241922",
     lambda r: Real(mpq(1, 4))),
    ("how far snapping moves, 1/(4 d3)", "phase 2", "= 1/(16*sqrt(2))", lambda r: _g(r) / 2),
    ("how far snapping moves, 1/(4 d3)", "phase 2", "0.044", lambda r: _g(r) / 2),
    ("feature size of the Tube, 1/(8 d3)", "phase 3", "0.022", lambda r: _g(r) / 4),
    ("feature size of the Tube, 1/(8 d3)", "phase 3", ">= 0.022", lambda r: _g(r) / 4),
    ("Lemma 3 for w = 1/(2 d3), h = 1/4 - w", "phase 4", "> 0.024", _fan),
    ("the same with teeth over the middles, in the limit", "phase 4", "> 0.024", _literal_teeth),
    ("degradation of the Tube, 8 d3", "Theorem 1", "< 45", lambda r: 4 / _g(r)),
    ("the inverse of 0.022", "Theorem 1", "< 45", lambda r: mpq(500, 11)),
)
