"""Assemble points, lines and polygons with holes, as GeoJSON and WKT have them, into one PSLG.

Equal points are one vertex and equal segments one edge, so that what two parts share is shared in the PSLG.
When there is a polygon, the domain is the union of the polygons, and lines and points are features of it or
of its outside; when there is none, the domain is what the lines enclose, as in any PSLG.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.hole_points import Ring, hole_points
from exactmesh.io.text import shortened
from exactmesh.planar.pslg import Edge, Pslg


@dataclass(frozen=True, slots=True)
class Run:
    """A list of positions; `place_of` says where each stands, and for None where the list does.

    Places are asked for only when something is wrong: to find a line number, a text is read from its
    beginning.
    """

    points: Sequence[Point]
    place_of: Callable[[int | None], str]


@dataclass(slots=True)
class Assembly:
    """A PSLG that grows part by part; what does not fit raises `FormatError` at the place of the part."""

    _vertices: dict[Point, int] = field(default_factory=dict)
    _edges: dict[Edge, int] = field(default_factory=dict)
    _rings: list[Ring] = field(default_factory=list)
    _polygons: int = 0

    def add_point(self, point: Point) -> None:
        """Add a vertex, which need not lie on an edge."""
        self._vertex(point)

    def add_line(self, line: Run) -> None:
        """Add the segments of a line of two positions or more."""
        if len(line.points) < 2:
            count = len(line.points)
            raise FormatError(line.place_of(None), f"a line needs at least two positions, not {count}")
        self._segments(line)

    def add_polygon(self, rings: Sequence[Run]) -> None:
        """Add a polygon: its exterior ring, then the interior rings that bound its holes."""
        for index, ring in enumerate(rings):
            _check_ring(ring)
            self._rings.append(Ring(self._polygons, index == 0, self._segments(ring)))
        self._polygons += 1

    def add_even_odd(self, rings: Sequence[Run]) -> None:
        """Add a polygon of rings of equal standing: what an odd number of them goes around is inside."""
        for ring in rings:
            _check_ring(ring)
            self._rings.append(Ring(self._polygons, True, self._segments(ring)))
        self._polygons += 1

    def pslg(self) -> Pslg:
        """Return the PSLG of the parts so far; raises `FormatError` when there is none."""
        if not self._vertices:
            raise FormatError("", "there is no geometry in it")
        pslg = Pslg(tuple(self._vertices), tuple(self._edges))
        return Pslg(pslg.vertices, pslg.edges, hole_points(pslg, self._rings)) if self._rings else pslg

    def _vertex(self, point: Point) -> int:
        return self._vertices.setdefault(point, len(self._vertices))

    def _segments(self, run: Run) -> tuple[int, ...]:
        """Add the segments between consecutive positions; return their edges."""
        found = []
        points = run.points
        u = self._vertex(points[0])
        for index in range(1, len(points)):
            v = self._vertex(points[index])
            if u == v:
                at = shortened(str(points[index]), 80)
                raise FormatError(run.place_of(index), f"a zero-length edge: {at} is repeated")
            edge = (u, v) if (v, u) not in self._edges else (v, u)
            found.append(self._edges.setdefault(edge, len(self._edges)))
            u = v
        return tuple(found)


def _check_ring(ring: Run) -> None:
    points = ring.points
    if points and points[0] != points[-1]:
        first, last = (shortened(str(points[i]), 80) for i in (0, -1))
        raise FormatError(ring.place_of(None), f"the ring is not closed: from {first} to {last}")
    if (distinct := len(set(points))) < 3:
        raise FormatError(ring.place_of(None), f"a ring needs at least three distinct points, not {distinct}")
