"""The paper's P2 and P3 for drawing: their algebraic places as rationals near by, arcs as chains of chords."""

from collections.abc import Iterator, Sequence
from math import atan2, cos, degrees, pi, sin

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.curve_view import Corner
from exactmesh.steps.records import RealPoint

_BITS = 60
# The chords of an arc span at most this.
_SPAN = pi / 32


def near(place: RealPoint) -> Point:
    """Return a rational point near an algebraic one."""
    return Point(*((low + high) / 2 for low, high in (z.enclosure(_BITS) for z in place)))


def arcs(rings: Sequence[Sequence[Corner]]) -> Iterator[tuple[Corner, list[Point]]]:
    """Yield each corner of P with an arc of P2, and the arc from its first to its last end."""
    for ring in rings:
        for corner in ring:
            if corner.record.arc is not None:
                yield corner, _arc(corner.p, *map(near, corner.record.arc))


def span(corner: Corner) -> float:
    """Return the span of a corner's arc in degrees, rounded: the angle by which its two edges turn."""
    before, after = corner.before, corner.after
    size = max(map(abs, (*before, *after)))
    (ax, ay), (bx, by) = ([float(z / size) for z in v] for v in (before, after))
    return degrees(abs(atan2(ax * by - ay * bx, ax * bx + ay * by)))


def _arc(centre: Point, start: Point, end: Point) -> list[Point]:
    size = max(abs(start.x - centre.x), abs(start.y - centre.y))
    (ax, ay), (bx, by) = ((float((p.x - centre.x) / size), float((p.y - centre.y) / size)) for p in (start, end))
    # Around a reflex corner, with the inside on the left, an arc turns clockwise.
    turn = -abs(atan2(ax * by - ay * bx, ax * bx + ay * by))
    count = max(2, round(-turn / _SPAN))
    inner = [(cos(turn * i / count), sin(turn * i / count)) for i in range(1, count)]
    return [start, *(Point(centre.x + size * mpq(ax * c - ay * s), centre.y + size * mpq(ax * s + ay * c))
                     for c, s in inner), end]
