"""Triangulate the trapezoids: the Interior (in place of paper §2, P6).

In      `Offset`, `Trapezoidation`, and the points of all vertices so far.
Out     `Patch`: the faces, Steiner vertices and feet; `on_edge` has the feet with the edges of Q they lie on.
Exact   rational throughout: feet and Steiner vertices are given by rational rules, candidates measured exactly.
Paper   joins one vertex to the corners of every trapezoid and leaves T-vertices on its sides, which makes the
        degradation unbounded; here T-vertices are absorbed.
Check   `patch_check.py`

A trapezoid without T-vertices goes to `quad`. From any other one wedges are cut off: a left leg that leans right on
its way down lies under part of the top side, and T-vertices there, more than X = 2H before the leg's lower end, get a
vertical segment down to the leg. Its foot becomes a vertex of the edge of Q, which the Tube absorbs. The corner at
the end of the side is dropped as well when it is a vertex of Q and as far before: without that the leftover can be
arbitrarily flat (a long spike with a ledge of length 1 near its tip). Then edges between consecutive opposite
T-vertices leave pieces with T-vertices on one side only.
"""

from collections.abc import Sequence
from itertools import groupby, takewhile

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.constants import LEVEL, WEDGE_HEIGHTS
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Patch, Trapezoid, Trapezoidation

# A trapezoid is seen from four sides: (1, 1) as it is, (-1, 1) with left and right exchanged, (1, -1) upside down.
# In each view the wedge over the left leg and under the top side is cut off.
_Flip = tuple[int, int]
_FLIPS: tuple[_Flip, ...] = ((1, 1), (1, -1), (-1, 1), (-1, -1))
_TOP, _BOTTOM = 1, -1
_LEFT, _RIGHT = 1, -1


def triangulate_interior(offset: Offset, trapezoidation: Trapezoidation, points: Sequence[Point],
                         proper: bool = False) -> Patch:
    """Return the triangulation of all trapezoids; `points` has the vertices of P, Q and the chord ends."""
    mesh = PatchBuilder(points, proper)
    of_q = range(offset.first, trapezoidation.first)
    for trapezoid in trapezoidation.trapezoids:
        _Face(mesh, of_q, trapezoid).triangulate()
    return mesh.finished()


class _Face:
    """One trapezoid on its way: cutting wedges moves its corners and shortens its sides.

    `corner[s, t]` is the left (s = 1) or right (s = -1) corner of the top (t = 1) or bottom (t = -1) side;
    `side[t]` lists the T-vertices of a side from left to right.
    """

    def __init__(self, mesh: PatchBuilder, of_q: range, z: Trapezoid) -> None:
        self.mesh = mesh
        self.of_q = of_q
        self.reach = WEDGE_HEIGHTS * (z.high - z.low) * LEVEL
        self.edge = {_LEFT: z.left, _RIGHT: z.right}
        self.corner = {(_LEFT, _TOP): z.tl, (_LEFT, _BOTTOM): z.bl, (_RIGHT, _TOP): z.tr, (_RIGHT, _BOTTOM): z.br}
        self.original = dict(self.corner)
        self.side = {_TOP: z.top, _BOTTOM: z.bottom}

    def triangulate(self) -> None:
        if self.side[_TOP] or self.side[_BOTTOM]:
            for flip in _FLIPS:
                self._cut_wedge(flip)
        if self.side[_TOP] or self.side[_BOTTOM]:
            self._absorb()
        else:
            self.mesh.add_quad([self.corner[place] for place in
                                ((_LEFT, _BOTTOM), (_RIGHT, _BOTTOM), (_RIGHT, _TOP), (_LEFT, _TOP))])

    def _x(self, v: int) -> mpq:
        return self.mesh.points[v].x

    def _cut_wedge(self, flip: _Flip) -> None:
        s, t = flip
        near, far, end = self.original[s, t], self.original[s, -t], self.original[-s, t]
        candidates = list(self.side[t][::s])
        if end in self.of_q and end != near:
            candidates.append(end)
        limit = s * self._x(far) - self.reach
        dropped = list(takewhile(lambda v: s * self._x(v) < limit, candidates))
        if not dropped:
            return
        feet = self._feet(dropped, near, far)
        self.mesh.on_edge += [(self.edge[s], foot) for foot in feet]
        self.mesh.add_triangle(near, feet[0], dropped[0])
        for i in range(1, len(feet)):
            # The legs of this quadrilateral are the verticals.
            seen = {(1, 1): dropped[i - 1], (1, -1): feet[i - 1], (-1, 1): dropped[i], (-1, -1): feet[i]}
            self.mesh.add_quad([seen[s, -t], seen[-s, -t], seen[-s, t], seen[s, t]])
        self.mesh.add_triangle(feet[-1], far, dropped[-1])
        self.side[t] = tuple(v for v in self.side[t] if v not in dropped)
        self.corner[flip] = dropped[-1]

    def _feet(self, dropped: list[int], near: int, far: int) -> list[int]:
        a, b = self.mesh.points[near], self.mesh.points[far]
        slope = (b.y - a.y) / (b.x - a.x)
        return [self.mesh.add(Point(x, a.y + slope * (x - a.x))) for x in map(self._x, dropped)]

    def _absorb(self) -> None:
        """Close each run of T-vertices on one side by an edge to the next T-vertex on the other side."""
        left = {_TOP: self.corner[_LEFT, _TOP], _BOTTOM: self.corner[_LEFT, _BOTTOM]}
        # By abscissa; of two at one abscissa the upper one comes first.
        order = sorted(((self._x(v), -t, v) for t in (_TOP, _BOTTOM) for v in self.side[t]))
        runs = [(-negative, [v for _, _, v in run]) for negative, run in groupby(order, key=lambda item: item[1])]
        for i, (t, run) in enumerate(runs):
            # The first of a run may be the end of the edge that closed the last one.
            t_side = [left[t], *(v for v in run if v != left[t])]
            if i + 1 < len(runs):
                closing = runs[i + 1][1][0]
            else:
                t_side.append(self.corner[_RIGHT, t])
                closing = self.corner[_RIGHT, -t]
            self.mesh.add_one_sided(t_side, left[-t], closing)
            left[t], left[-t] = t_side[-1], closing
