"""The paper's Tube between P and P4, in its four phases (paper §2, "Triangulation of Tube", Fig. 6 to 10).

In      `Shape`, P4 as `Offset`, its trapezoidation, the points of all vertices so far, the squared mfs, and options.
Out     `PaperTube`.
Exact   rational. Lengths that the paper gives in units of the mfs, or along a direction, are irrational; they are
        replaced by rationals less than one part in 10^6 below.
Paper   phase 2 speaks of angles before snapping and reinstates the snapping later; here the snapped P4 is used from
        the start, and the rectangle is built on its top (a claim says what its motion would be).
        Phase 3 puts its vertex at 1/(8 d3) from the bottom: below the middle of the top in a quasi-trapz left by
        phase 2, whose height is 1/(2 d3). One without vertices on its top is about 1/4 high, and the text's reason
        does not apply: `tall` "lemma-1" takes Lemma 1's vertex, half way up, as for any trapezoid; "low" keeps
        1/(8 d3), over Lemma 1's abscissa, which can even lie outside.
        `rectangle` is Lemma 3 ("nested") or Theorem 2 ("layers").
Check   `paper_tube_check.py`
"""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.numbers.rational import sqrt_below
from exactmesh.steps.layered_rectangle import triangulate_in_layers
from exactmesh.steps.lemma_1 import lemma_1_abscissa
from exactmesh.steps.lemma_3 import Teeth, triangulate_rectangle
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import (
    Offset,
    PaperTube,
    Phase,
    Piece,
    Rectangle,
    Shape,
    Trapezoidation,
)

Tall = Literal["lemma-1", "low"]
Filling = Literal["nested", "layers"]
_RATIO_BITS = 24
_OFFSET = mpq(1, 4)
# The height of a rectangle is less than the paper's by this factor: what is below keeps half of the spacing although
# snapping rounds abscissae as well.
_DEPTH = 1 - mpq(1, 2**26)


@dataclass(frozen=True, slots=True)
class TubeOptions:
    """What the text leaves open; `granularity` is the spacing of the grid in units of the mfs, 1/(2 d3)."""

    granularity: mpq
    teeth: Teeth = "midpoint"
    tall: Tall = "lemma-1"
    rectangle: Filling = "nested"


def triangulate_tube_in_phases(shape: Shape, p4: Offset, chords: Trapezoidation, points: Sequence[Point],
                               mfs_squared: mpq, options: TubeOptions) -> PaperTube:
    """Return the triangulation of the Tube."""
    work = _Tube(shape, p4, points, mfs_squared, options)
    following = p4.successors()
    recorded: dict[int, list[int]] = defaultdict(list)
    for i, edge in enumerate(chords.edge):
        recorded[edge].append(chords.first + i)
    for k, source in enumerate(p4.source):
        ends = p4.first + k, p4.first + following[k]
        along = minus(points[ends[1]], points[ends[0]])
        between = sorted(recorded[k], key=lambda v: dot(minus(points[v], points[ends[0]]), along))
        top = [ends[0], *between, ends[1]]
        if source < 0:
            work.fan(shape.origin[p4.corner[k]], top)
        else:
            work.quasi_trapz(source, top)
    return PaperTube(work.mesh.finished(), tuple(work.phase), tuple(work.rectangles))


class _Tube:
    """Faces with the phases they come from."""

    def __init__(self, shape: Shape, p4: Offset, points: Sequence[Point], mfs_squared: mpq, options: TubeOptions
                 ) -> None:
        self.shape = shape
        self.p4 = p4
        self.mfs_squared = mfs_squared
        self.options = options
        self.mesh = PatchBuilder(points)
        self.phase: list[Phase] = []
        self.rectangles: list[Rectangle] = []

    def fan(self, corner: int, top: Sequence[int]) -> None:
        """Phase 1: join a reflex corner to all vertices of a chord of its arc."""
        for u, v in pairwise(top):
            self._face("fan", corner, v, u)

    def quasi_trapz(self, half_edge: int, top: list[int]) -> None:
        """Phases 2 to 4 over the edge of P that `half_edge` runs along."""
        left, right = self.shape.origin[half_edge], self.shape.origin[half_edge ^ 1]
        was_clean = len(top) == 2
        while len(top) > 2 and not self._is_wide(left, top[0], top[1]):
            self._face("cut", left, top[1], top[0])
            top = top[1:]
        while len(top) > 2 and not self._is_wide(right, top[-1], top[-2]):
            self._face("cut", right, top[-1], top[-2])
            top = top[:-1]
        if was_clean or len(top) == 2:
            self._centre("tall", left, right, top[-1], top[0])
        else:
            self._rectangle(half_edge, left, right, top)

    def _face(self, phase: Phase, *cycle: int) -> None:
        self.mesh.add_face(cycle)
        self.phase.append(phase)

    def _is_wide(self, v: int, t: int, onward: int) -> bool:
        """Return whether the angle at t between v and the rest of the top is at least 135 degrees."""
        place = self.mesh.points
        a, b = minus(place[v], place[t]), minus(place[onward], place[t])
        product = dot(a, b)
        return bool(product < 0 and 2 * product * product >= dot(a, a) * dot(b, b))

    def _below(self, length: mpq, per_squared: mpq) -> mpq:
        """Return a rational just below length * mfs / sqrt(per_squared)."""
        return sqrt_below(length * length * self.mfs_squared / per_squared, _RATIO_BITS)

    def _rectangle(self, half_edge: int, left: int, right: int, top: list[int]) -> None:
        place = self.mesh.points
        a, b = place[top[0]], place[top[-1]]
        along = minus(b, a)
        depth = self._below(_DEPTH * (_OFFSET - self.options.granularity), dot(along, along))
        down = Point(depth * along.y, -depth * along.x)
        a_below = self.mesh.add(Point(a.x + down.x, a.y + down.y))
        b_below = self.mesh.add(Point(b.x + down.x, b.y + down.y))
        self._face("rest", left, a_below, top[0])
        self._face("rest", right, top[-1], b_below)
        self._centre("low", left, right, b_below, a_below)
        # Seen from b, with P below turned upwards, the figure of Lemma 3 keeps its orientation.
        side = top[::-1]
        spacing, start = self.p4.spacing, place[side[0]].y
        grid = tuple(int(abs(place[v].y - start) / spacing) for v in side)
        self.rectangles.append(Rectangle(half_edge, tuple(side), grid, a_below, b_below))
        options = self.options
        unit = triangulate_in_layers(grid) if options.rectangle == "layers" else triangulate_rectangle(
            grid, options.teeth)
        across = Point(-along.x / grid[-1], -along.y / grid[-1])
        steiner = tuple(Point(b.x + p.x * across.x + p.y * down.x, b.y + p.x * across.y + p.y * down.y)
                        for p in unit.steiner)
        self.mesh.add_piece(Piece(unit.faces, steiner), (*side, b_below, a_below))
        self.phase += ["rectangle"] * len(unit.faces)

    def _centre(self, phase: Phase, left: int, right: int, top_right: int, top_left: int) -> None:
        """Phase 3: one vertex in a quasi-trapz without vertices on its sides."""
        place = self.mesh.points
        p, q = place[left], place[right]
        bottom = minus(q, p)
        length_squared = distance_squared(p, q)
        at_left, at_right = (dot(minus(place[t], p), bottom) / length_squared for t in (top_left, top_right))
        if phase == "low":
            x, height = (at_left + at_right) / 2, self.options.granularity / 4
        else:
            x = lemma_1_abscissa(mpq(0), mpq(1), at_left, at_right)
            height = self.options.granularity / 4 if self.options.tall == "low" else _OFFSET / 2
        up = self._below(height, length_squared)
        s = self.mesh.add(Point(p.x + x * bottom.x - up * bottom.y, p.y + x * bottom.y + up * bottom.x))
        for u, v in pairwise((left, right, top_right, top_left, left)):
            self._face(phase, u, v, s)
