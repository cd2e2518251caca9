"""Triangulate a quadrilateral without T-vertices: a diagonal, or one Steiner vertex (in place of Lemma 1).

In      corners bottom left, bottom right, top right, top left, counter-clockwise; corners may coincide.
Out     `Piece` in which faces refer to the corners by 0 to 3.
Exact   every candidate is measured exactly; the first that reaches the wanted feature size is taken.
Paper   puts a vertex into every trapezoid and proves a factor of 2 (Lemma 1); a diagonal is better where it is good.
"""

from collections.abc import Iterator, Sequence

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.steps.constants import FEATURE_SQUARED
from exactmesh.steps.heights import height_squared
from exactmesh.steps.records import Piece

DIAGONALS = (((0, 1, 2), (0, 2, 3)), ((0, 1, 3), (1, 2, 3)))
_HEIGHTS = (mpq(3, 10), mpq(1, 2), mpq(7, 10))


def quad(corners: Sequence[Point], wanted_squared: mpq = FEATURE_SQUARED) -> Piece:
    """Return the better diagonal of the quadrilateral when its feature size is at least the wanted one, else the best
    of all diagonals and centres. With two corners coinciding it is a triangle, with fewer than three left nothing.
    """
    distinct = [i for i in range(4) if corners[i] != corners[i - 1]]
    if len(distinct) < 3:
        return Piece(())
    if len(distinct) == 3:
        return Piece((tuple(distinct),))
    best, diagonal = max(((_least(corners, faces), faces) for faces in DIAGONALS), key=lambda item: item[0])
    if best >= wanted_squared:
        return Piece(diagonal)
    chosen = Piece(diagonal)
    for centre in centres(corners):
        value = centre_value(corners, centre)
        if value > best:
            best, chosen = value, fan_about(4, centre)
    return chosen


def centres(corners: Sequence[Point]) -> Iterator[Point]:
    """Yield places for a Steiner vertex: the mean of the corners, then above the middle of the bottom, at three
    heights on the way to the line of the top, then the same from the top."""
    bl, br, tr, tl = corners
    yield Point((bl.x + br.x + tr.x + tl.x) / 4, (bl.y + br.y + tr.y + tl.y) / 4)
    for (a, b), (c, d) in (((bl, br), (tl, tr)), ((tl, tr), (bl, br))):
        if c == d:
            continue
        middle = Point((a.x + b.x) / 2, (a.y + b.y) / 2)
        along = minus(d, c)
        t = dot(minus(middle, c), along) / distance_squared(c, d)
        foot = Point(c.x + t * along.x, c.y + t * along.y)
        for height in _HEIGHTS:
            yield Point(middle.x + height * (foot.x - middle.x), middle.y + height * (foot.y - middle.y))


def centre_value(corners: Sequence[Point], centre: Point) -> mpq:
    """Return the signed squared feature size of the fan of `centre` to the corners."""
    return min(height_squared(corners[i - 1], corners[i], centre) for i in range(len(corners)))


def fan_about(count: int, centre: Point) -> Piece:
    """Return the fan that joins a new vertex at `centre` to `count` corners, counter-clockwise."""
    return Piece(tuple((i, (i + 1) % count, -1) for i in range(count)), (centre,))


def _least(corners: Sequence[Point], faces: Sequence[tuple[int, int, int]]) -> mpq:
    return min(height_squared(*(corners[i] for i in face)) for face in faces)
