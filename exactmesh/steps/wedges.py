"""Cut wedges off a trapezoid: T-vertices far out over a slanted leg are dropped onto that leg.

A left leg that leans right on its way down lies under part of the top side, and T-vertices there, more than X = 2H
before the leg's lower end, get a vertical segment down to the leg. Its foot becomes a vertex of the edge of Q, which
the Tube absorbs. The corner at the end of the side is dropped as well when it is a vertex of Q and as far before:
without that the leftover can be arbitrarily flat (a long spike with a ledge of length 1 near its tip).
"""

from itertools import takewhile

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.constants import WEDGE_HEIGHTS
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Trapezoid

# A trapezoid is seen from four sides: (1, 1) as it is, (-1, 1) with left and right exchanged, (1, -1) upside down.
# In each view the wedge over the left leg and under the top side is cut off.
Flip = tuple[int, int]
FLIPS: tuple[Flip, ...] = ((1, 1), (1, -1), (-1, 1), (-1, -1))
TOP, BOTTOM = 1, -1
LEFT, RIGHT = 1, -1


class Leftover:
    """What is left of a trapezoid: cutting wedges moves its corners and shortens its sides.

    `corner[s, t]` is the left (s = 1) or right (s = -1) corner of the top (t = 1) or bottom (t = -1) side;
    `side[t]` lists the T-vertices of a side from left to right.
    """

    def __init__(self, mesh: PatchBuilder, of_q: range, z: Trapezoid) -> None:
        self.mesh = mesh
        self.of_q = of_q
        self.reach = WEDGE_HEIGHTS * (z.high - z.low) * mesh.balance.level
        self.edge = {LEFT: z.left, RIGHT: z.right}
        self.corner = {(LEFT, TOP): z.tl, (LEFT, BOTTOM): z.bl, (RIGHT, TOP): z.tr, (RIGHT, BOTTOM): z.br}
        self.original = dict(self.corner)
        self.side = {TOP: z.top, BOTTOM: z.bottom}

    def x(self, v: int) -> mpq:
        """Return the abscissa of a vertex."""
        return self.mesh.points[v].x

    def cut_wedge(self, flip: Flip) -> None:
        """Cut off the wedge that is at the left of the top in the given view, if there is one."""
        s, t = flip
        near, far, end = self.original[s, t], self.original[s, -t], self.original[-s, t]
        candidates = list(self.side[t][::s])
        if end in self.of_q and end != near:
            candidates.append(end)
        limit = s * self.x(far) - self.reach
        dropped = list(takewhile(lambda v: s * self.x(v) < limit, candidates))
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
        gone = set(dropped)
        self.side[t] = tuple(v for v in self.side[t] if v not in gone)
        self.corner[flip] = dropped[-1]

    def _feet(self, dropped: list[int], near: int, far: int) -> list[int]:
        a, b = self.mesh.points[near], self.mesh.points[far]
        slope = (b.y - a.y) / (b.x - a.x)
        return [self.mesh.add(Point(x, a.y + slope * (x - a.x))) for x in map(self.x, dropped)]
