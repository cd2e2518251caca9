"""Triangulate all faces of the domain by one sweep, exactly, without Steiner points.

The sweep is Hertel and Mehlhorn's ("Fast triangulation of the plane with respect to simple polygons", 1985), for any
planar straight-line graph: vertices in lexicographic order, active edges from below. What lies between two
neighbouring active edges and left of the sweep line is triangulated as far as a chain of vertices that leads from the
left end of the lower edge to that of the upper one. Invariant: at each inner vertex of the chain, what is not yet
triangulated has an angle of at least 180 degrees. A chain may pass a vertex twice, around an edge or a diagonal with a
free end. O((n + m) log n) predicates; no recursion.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cmp_to_key

from exactmesh.geometry.fixed_point import FixedPoints, TurnFilter
from exactmesh.geometry.point import Point
from exactmesh.planar.cycles import Side
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.status import Status

Triangle = tuple[int, int, int]


@dataclass(frozen=True, slots=True)
class Triangulation:
    """Counter-clockwise triangles, each from its least vertex, in order; those of one face are joined at their sides.

    `apex[u, v]` is the third vertex of the triangle with (u, v) as a directed side: across (u, v) lies the triangle at
    `apex[v, u]`, where there is one. `constrained` holds both directions of the input edges along the domain; a side
    that is not in it has a triangle on either side.
    """

    triangles: tuple[Triangle, ...]
    constrained: frozenset[Side]
    apex: Mapping[Side, int]


def triangulation_of(triangles: Iterable[Triangle], constrained: frozenset[Side]) -> Triangulation:
    """Return the record of counter-clockwise triangles, given in any order and each from any of its vertices."""
    apex: dict[Side, int] = {}
    for u, v, w in triangles:
        apex[u, v], apex[v, w], apex[w, u] = w, u, v
    return Triangulation(triangles_from(apex), constrained, apex)


def triangles_from(apex: Mapping[Side, int]) -> tuple[Triangle, ...]:
    """Return the triangles of a dictionary of half-edges, in order."""
    return tuple(sorted((u, v, w) for (u, v), w in apex.items() if u < v and u < w))


def triangulate(subdivision: Subdivision, along: tuple[int, int] = (1, 0)) -> Triangulation:
    """Return a triangulation of the domain whose vertices are all vertices on it and in it, and no others.

    The sweep runs in the direction `along`, which is not (0, 0); each direction gives a triangulation of its own.
    """
    half_edges = subdivision.half_edges
    sides = {(half_edges.origin[h], half_edges.target(h))
             for face in subdivision.domain for walk in face.walks for h in walk}
    constrained = frozenset(sides | {(v, u) for u, v in sides})
    return triangulation_of(_Sweep(subdivision, sides, along).run(), constrained)


class _Sweep:
    """One sweep. `status` holds the active edges from below; edge e leads from `left[e]` to `right[e]`.

    Chains are linked nodes: `vertex`, and the nodes `up` and `down` the chain, -1 at its ends. Above edge e of the
    status, when `inside[e]`, the chain is `chain[e]`: its lowest, its highest and its rightmost node.
    """

    def __init__(self, subdivision: Subdivision, domain_on_left: set[Side], along: tuple[int, int]) -> None:
        pslg = subdivision.pslg
        x, y = along
        # Turned and scaled so that `along` points to the right; orientations stay.
        points = self.points = pslg.vertices if along == (1, 0) else tuple(
            Point(x * p.x + y * p.y, x * p.y - y * p.x) for p in pslg.vertices)
        columns = FixedPoints(points)
        self.turns = TurnFilter(columns)
        self.orientation = self.turns.orientation
        self.order: list[int] = columns.lexicographic().tolist()
        rank = [0] * len(points)
        for place, v in enumerate(self.order):
            rank[v] = place
        ends = [(u, v) if rank[u] < rank[v] else (v, u) for u, v in pslg.edges]
        self.left, self.right = [u for u, _ in ends], [v for _, v in ends]
        self.inside = [side in domain_on_left for side in ends]
        self.starting: list[list[int]] = [[] for _ in points]
        for edge, u in enumerate(self.left):
            self.starting[u].append(edge)
        self.status = Status(len(ends))
        self.vertex: list[int] = []
        self.up: list[int] = []
        self.down: list[int] = []
        self.chain: dict[int, tuple[int, int, int]] = {}
        self.triangles: list[Triangle] = []

    def run(self) -> list[Triangle]:
        for v in self.order:
            self._pass(v)
        self.turns.note()
        return self.triangles

    def _pass(self, v: int) -> None:
        """Move the sweep line over vertex v."""
        left, right, status = self.left, self.right, self.status
        at = status.first(lambda edges: self.turns.count_below(edges, left, right, v))
        below = status.before(at)
        ending, _ = status.run(at, lambda edge: right[edge] == v)
        starting = self._from_below(v)
        status.replace(at, len(ending), starting)
        # The chains directly below and above v, by the lowest and the highest node; -1 outside of the domain.
        lowest, last, first, highest = -1, -1, -1, -1
        if below >= 0 and self.inside[below]:
            lowest, last, rightmost = self.chain.pop(below)
            if not ending:
                first, highest = self._cut(rightmost, last)
                last = rightmost
        for edge in ending:
            if self.inside[edge]:
                first, highest, _ = self.chain.pop(edge)
                if edge != ending[-1]:
                    self._close(v, last=highest)
        if ending and not self.inside[ending[-1]]:
            first = -1
        if last >= 0:
            last = self._see_down(v, last)
        if first >= 0:
            first = self._see_up(v, first)
        self._go_on(v, below, starting, (lowest, last), (first, highest))

    def _go_on(self, v: int, below: int, starting: list[int], lower: tuple[int, int], upper: tuple[int, int]) -> None:
        """Join v to the chains below and above it, and begin those between the edges that start at v."""
        (lowest, last), (first, highest) = lower, upper
        here = -1
        if last >= 0:
            here = self._node(v, down=last)
            self.chain[below] = lowest, here, here
        for edge in starting:
            if self.inside[edge]:
                here = self._node(v)
                self.chain[edge] = here, here, here
        if first >= 0:
            # Without starting edges the two chains become one, joined by the node appended to the lower.
            self.up[here], self.down[first] = first, here
            edge = starting[-1] if starting else below
            self.chain[edge] = self.chain[edge][0], highest, here

    def _from_below(self, v: int) -> list[int]:
        """Return the edges that start at v, from below."""
        orientation, right = self.orientation, self.right

        def steeper(e: int, f: int) -> int:
            return orientation(v, right[f], right[e])

        starting = self.starting[v]
        return sorted(starting, key=cmp_to_key(steeper)) if len(starting) > 1 else starting

    def _node(self, v: int, down: int = -1) -> int:
        node = len(self.vertex)
        self.vertex.append(v)
        self.up.append(-1)
        self.down.append(down)
        if down >= 0:
            self.up[down] = node
        return node

    def _cut(self, node: int, highest: int) -> tuple[int, int]:
        """Cut a chain at a node, which becomes the end of the lower part; return both ends of the upper part."""
        copy = self._node(self.vertex[node])
        above = self.up[node]
        self.up[node] = -1
        if above < 0:
            return copy, copy
        self.up[copy], self.down[above] = above, copy
        return copy, highest

    def _close(self, v: int, last: int) -> None:
        """Triangulate between two edges that both end at v: all of the chain is seen from v."""
        vertex, down = self.vertex, self.down
        while (node := down[last]) >= 0:
            self.triangles.append((vertex[last], vertex[node], v))
            last = node

    def _see_down(self, v: int, last: int) -> int:
        """Triangulate what v sees of the chain below it; return the new highest node."""
        vertex, down = self.vertex, self.down
        while (node := down[last]) >= 0 and self.orientation(vertex[last], vertex[node], v) > 0:
            self.triangles.append((vertex[last], vertex[node], v))
            last = node
        return last

    def _see_up(self, v: int, first: int) -> int:
        """Triangulate what v sees of the chain above it; return the new lowest node."""
        vertex, up = self.vertex, self.up
        while (node := up[first]) >= 0 and self.orientation(vertex[node], vertex[first], v) > 0:
            self.triangles.append((vertex[node], vertex[first], v))
            first = node
        return first
