"""Decide whether a dissection, from anywhere, is one of the given polygons: from the definitions, exactly.

The clauses; the first that fails at a piece, or of all, is told:

figures    there is a scale for each polygon, each piece has a polygon for each and a motion to each but the first
scale      each scale is positive, that of the first polygon 1
areas      the scaled polygons have one area, and so have the pieces together
corners    the polygons of a piece have equally many corners, three or more
convex     its polygon in the first figure is strictly convex, counter-clockwise and goes round once
isometry   the matrix of a motion is orthogonal, and its determinant is 1: no reflection
image      a motion carries each corner in the first figure to the same corner in the other figure
tiling     in each figure the boundaries of the pieces add up to that of the polygon

Why they suffice: by `isometry` and `image` the polygons of a piece are congruent, and convex in each figure by
`convex`, so the winding number of each is 1 inside and 0 outside. By `tiling`, the sum of these minus that of the
polygon's boundary changes across no line; it is 0 far away, so it is 0 everywhere off the edges. So each point of the
polygon off the edges is in exactly one piece, and other points in none.

For `tiling`, each directed edge counts +1 at its start and -1 at its end, for the line it lies on. A chain of edges on
one line is zero exactly when its counts vanish at each point. No construction is imported here.
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from gmpy2 import mpq

from exactmesh.dissection.records import Dissection, Motion, Piece, Polygon, Vector
from exactmesh.errors import InputError
from exactmesh.numbers.algebraic import Real, total
from exactmesh.numbers.interval import sign_of
from exactmesh.numbers.radicals import TooManyRoots
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.pslg import Pslg

_REPORT_EVERY = 100


@dataclass(frozen=True, slots=True)
class Refusal:
    """The clause that fails and where, by name; pieces and figures are counted from 0."""

    clause: str
    place: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class DissectionVerdict:
    """Whether a dissection is one, how many pieces were looked at, and the exact areas before scaling."""

    refusal: Refusal | None
    pieces: int
    areas: tuple[mpq, ...]
    scales: tuple[Real, ...]

    @property
    def valid(self) -> bool:
        """Whether no clause fails."""
        return self.refusal is None


def verify_dissection(pslgs: Sequence[Pslg], dissection: Dissection,
                      progress: Callable[[str], None] = lambda step: None) -> DissectionVerdict:
    """Return the verdict on a dissection.

    Raises `InputError` when a polygon is none, and when numbers of the dissection mix more square roots than can be
    treated together: it is then not judged.
    """
    progress("validation")
    boundaries = [_boundary(domain_of(pslg)) for pslg in pslgs]
    areas = tuple(sum((p[0] * q[1] - p[1] * q[0] for p, q in edges), mpq(0)) / 2 for edges in boundaries)
    try:
        refusal = _refusal(boundaries, areas, dissection, progress)
    except TooManyRoots as error:
        raise InputError(f"the pieces cannot be judged: {error}") from None
    return DissectionVerdict(refusal, len(dissection.pieces), areas, dissection.scales)


_Edges = list[tuple[tuple[mpq, mpq], tuple[mpq, mpq]]]


def _boundary(subdivision: Subdivision) -> _Edges:
    """Return the directed edges with the domain on their left."""
    points, half = subdivision.pslg.vertices, subdivision.half_edges
    return [(points[half.origin[h]], points[half.target(h)])
            for face in subdivision.domain for walk in face.walks for h in walk]


def _refusal(boundaries: Sequence[_Edges], areas: Sequence[mpq], dissection: Dissection,
             progress: Callable[[str], None]) -> Refusal | None:
    count, scales, pieces = len(boundaries), dissection.scales, dissection.pieces
    if len(scales) != count:
        return Refusal("figures", {"polygons": count, "scales": len(scales)})
    for number, piece in enumerate(pieces):
        if len(piece.polygons) != count or len(piece.motions) != count - 1:
            return Refusal("figures", {"piece": number})
    for figure, scale in enumerate(scales):
        if scale.sign() <= 0 or (figure == 0 and scale != 1):
            return Refusal("scale", {"figure": figure})
    for figure, scale in enumerate(scales):
        if scale * scale * areas[figure] != areas[0]:
            return Refusal("areas", {"figure": figure})
    for number, piece in enumerate(pieces):
        if number % _REPORT_EVERY == 0:
            progress(f"pieces, {100 * number // len(pieces)} %")
        refusal = _piece_refusal(number, piece)
        if refusal is not None:
            return refusal
    if total(_doubled_area(piece.polygons[0]) for piece in pieces) != 2 * areas[0]:
        return Refusal("areas", {"figure": 0})
    for figure, scale in enumerate(scales):
        progress(f"tiling of polygon {figure + 1}")
        if not _tiles([piece.polygons[figure] for piece in pieces], boundaries[figure], scale):
            return Refusal("tiling", {"figure": figure})
    return None


def _piece_refusal(number: int, piece: Piece) -> Refusal | None:
    first = piece.polygons[0]
    if len(first) < 3 or any(len(polygon) != len(first) for polygon in piece.polygons):
        return Refusal("corners", {"piece": number})
    if not _is_convex(first):
        return Refusal("convex", {"piece": number})
    for figure, (polygon, motion) in enumerate(zip(piece.polygons[1:], piece.motions, strict=True), 1):
        if not _is_rotation(motion):
            return Refusal("isometry", {"piece": number, "figure": figure})
        for corner, (p, q) in enumerate(zip(first, polygon, strict=True)):
            if (motion.a * p.x + motion.b * p.y + motion.x != q.x
                    or motion.c * p.x + motion.d * p.y + motion.y != q.y):
                return Refusal("image", {"piece": number, "figure": figure, "corner": corner})
    return None


def _is_convex(polygon: Polygon) -> bool:
    """Return whether each corner turns left and the sides turn once around in all.

    With left turns alone, each of less than half a turn, the sides change from downwards to not downwards as often as
    they go round.
    """
    count = len(polygon)
    downwards = []
    for i in range(count):
        p, q, r = polygon[i - 1], polygon[i], polygon[(i + 1) % count]
        if sign_of(_turn, p.x, p.y, q.x, q.y, r.x, r.y) <= 0:
            return False
        downwards.append(p.y > q.y)
    return sum(downwards[i - 1] != downwards[i] for i in range(count)) == 2


def _turn(px: Any, py: Any, qx: Any, qy: Any, rx: Any, ry: Any) -> Any:
    return (qx - px) * (ry - py) - (qy - py) * (rx - px)


def _is_rotation(motion: Motion) -> bool:
    """Return whether the matrix is orthogonal with determinant 1: of a unit vector and this one turned left."""
    a, b, c, d = motion[:4]
    return a == d and b == -c and a * a + c * c == 1


def _doubled_area(polygon: Polygon) -> Real:
    base = polygon[0]
    return total(_turn(*base, *p, *q) for p, q in pairwise(polygon[1:]))


def _tiles(polygons: Sequence[Polygon], boundary: _Edges, scale: Real) -> bool:
    """Return whether the boundaries of the polygons add up to the scaled one."""
    chain = _Chain()
    for polygon in polygons:
        chain.add(polygon, 1)
    for p, q in boundary:
        chain.add((Vector(scale * p[0], scale * p[1]), Vector(scale * q[0], scale * q[1])), -1, closed=False)
    return chain.is_zero()


class _Chain:
    """A sum of directed edges. Equal numbers get one name, so that each is hashed once where it occurs."""

    def __init__(self) -> None:
        self._names: dict[Real, int] = {}
        self._counts: Counter[tuple[int, int, int]] = Counter()

    def add(self, path: Sequence[Vector], sign: int, closed: bool = True) -> None:
        """Add `sign` times the edges of a path, and the one back to its start when it is closed."""
        names = [(self._name(p.x), self._name(p.y)) for p in path]
        for i in range(0 if closed else 1, len(path)):
            p, q = path[i - 1], path[i]
            run = q.x - p.x
            # A point and a slope name a line; -1 is no name.
            slope = self._name((q.y - p.y) / run) if run else -1
            self._counts[slope, *names[i - 1]] += sign
            self._counts[slope, *names[i]] -= sign

    def is_zero(self) -> bool:
        """Return whether everything cancels."""
        return not any(self._counts.values())

    def _name(self, value: Real) -> int:
        return self._names.setdefault(value, len(self._names))
