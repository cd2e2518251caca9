"""Where a claim's witness is: from the names and numbers in a report to vertices, edges, faces and points to mark.

Checkers name places in their own terms (see `exactmesh.measure.verdict.Witness`). Vertices, pairs and cycles are
numbers of the mesh. The rest needs more: numbers of the input's edges need the input, those of trapezoids, of edges of
Q and of rectangles need the run, and points of the repaired construction are in units of its `unit`. Algebraic points
are given as decimals near them, good enough for a mark. What cannot be told is left out: then there is nothing to fly
to, and the page says so.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.claims.run import REPAIRED_STEPS, Run
from exactmesh.geometry.point import Point
from exactmesh.numbers.rational import rational_from_text
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge
from exactmesh.steps.paper_interior_check import boundary
from exactmesh.steps.records import Offset, PaperTube, Trapezoidation
from exactmesh.viewer.stages import ring_edges

_NUMBER = r"-?\d{1,2000}(?:/[1-9]\d{0,2000}|\.\d{1,2000})?"
_POINT = re.compile(rf"\(({_NUMBER}), ({_NUMBER})\)", re.ASCII)


@dataclass(frozen=True, slots=True)
class Marks:
    """Vertices, edges and cycles of vertices by number, and exact points in the input's units."""

    vertices: tuple[int, ...] = ()
    edges: tuple[Edge, ...] = ()
    cycles: tuple[Cycle, ...] = ()
    points: tuple[Point, ...] = ()


class Places:
    """What is known for telling places; `unit` is what points in witnesses are multiples of, None if unknown."""

    def __init__(self, mesh: Mesh, edges: Sequence[Edge] = (), unit: mpq | None = None, run: Run | None = None
                 ) -> None:
        self.mesh = mesh
        self.edges = edges
        self.unit = unit
        self.q: Offset | None = None
        self.trapezoidation: Trapezoidation | None = None
        self.tube: PaperTube | None = None
        if run is not None and run.construction in REPAIRED_STEPS:
            self.q, self.trapezoidation = run.repaired.offset, run.repaired.trapezoidation
        elif run is not None and run.construction == "paper":
            self.q, self.trapezoidation, self.tube = run.paper.p4, run.paper.trapezoidation, run.paper.tube
        self.ring = ring_edges(self.q) if self.q is not None else ()

    def marks(self, witness: Mapping[str, object]) -> Marks:
        """Return the marks of a witness as it stands in a report, which may hold anything."""
        vertices: list[int] = []
        edges: list[Edge] = []
        cycles: list[Cycle] = []
        points: list[Point] = []
        for name, value in witness.items():
            numbers = _numbers(value)
            if name in ("vertex", "other", "vertices"):
                vertices += self._within(numbers)
            elif name in ("vertex_of_q", "vertex_of_p4") and self.q is not None:
                vertices += self._within([self.q.first + k for k in numbers])
            elif name in ("edge", "e", "f"):
                edges += self._edge(value, numbers)
            elif name in ("edge_of_q", "edge_of_p4"):
                edges += self._edge_of_q(value, numbers)
            elif name in ("face", "trapezoid", "rectangle", "ring"):
                cycles += self._cycle(name, value, numbers)
            points += self._points(value)
        return Marks(tuple(vertices), tuple(edges), tuple(cycles), tuple(points))

    def _within(self, numbers: Sequence[int]) -> list[int]:
        return [v for v in numbers if 0 <= v < len(self.mesh.vertices)]

    def _edge(self, value: object, numbers: Sequence[int]) -> Iterator[Edge]:
        """Yield a pair of vertices, or the input's edge of that number."""
        if numbers and isinstance(value, int):
            numbers = self.edges[numbers[0]] if 0 <= numbers[0] < len(self.edges) else ()
        if len(inside := self._within(numbers)) == 2:
            yield inside[0], inside[1]

    def _edge_of_q(self, value: object, numbers: Sequence[int]) -> Iterator[Edge]:
        """Yield an edge of Q by its number, or a pair of vertices of Q by theirs."""
        if self.q is None or not all(0 <= k < len(self.ring) for k in numbers):
            return
        if numbers and isinstance(value, int):
            yield self.ring[numbers[0]]
        elif len(numbers) == 2:
            yield self.q.first + numbers[0], self.q.first + numbers[1]

    def _cycle(self, name: str, value: object, numbers: Sequence[int]) -> Iterator[Cycle]:
        if not numbers:
            return
        if not isinstance(value, int):
            if name == "face" and len(inside := self._within(numbers)) == len(numbers):
                yield tuple(inside)
            return
        number = numbers[0]
        if name == "face" and 0 <= number < len(self.mesh.faces):
            yield self.mesh.faces[number]
        elif name == "trapezoid" and self.trapezoidation and 0 <= number < len(self.trapezoidation.trapezoids):
            yield boundary(self.trapezoidation.trapezoids[number])
        elif name == "rectangle" and self.tube and 0 <= number < len(self.tube.rectangles):
            record = self.tube.rectangles[number]
            yield (*record.side, record.a_below, record.b_below)
        elif name == "ring" and self.q is not None and 0 <= number < len(self.q.rings):
            yield tuple(self.q.first + k for k in range(*self.q.rings[number]))

    def _points(self, value: object) -> Iterator[Point]:
        """Yield the points spelled in a text or in a list of texts, in the input's units."""
        texts = value if isinstance(value, list | tuple) else [value]
        for text in texts:
            found = _POINT.fullmatch(text) if isinstance(text, str) else None
            if found and self.unit is not None:
                yield Point(rational_from_text(found[1]) * self.unit, rational_from_text(found[2]) * self.unit)


def _numbers(value: object) -> list[int]:
    """Return the whole numbers in a value: itself, or the items of a list of them; no others."""
    items = value if isinstance(value, list | tuple) else [value]
    whole = [item for item in items if isinstance(item, int) and not isinstance(item, bool)]
    return whole if len(whole) == len(items) else []
