"""Check P5, the paper's trapezoidation of P4, and that the Tube leaves its boundary alone.

Neither the trapezoidation nor the Tube is imported. P5 is a graph: the edges of P4, cut where chords end on them, and
the horizontal sides of all trapezoids, cut at their T-vertices.
"""

from collections.abc import Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.steps.edge_chains import Chains, Misplaced, chain_sides, edge_chains
from exactmesh.steps.records import Offset, Patch, Shape, Trapezoidation

_ONE = mpq(1)


def check_grid(p4: Offset, chords: Trapezoidation) -> Verdict:
    """Return whether all vertices of P5 lie on lines of the grid; one instance a vertex."""
    vertices = p4.points + chords.points
    for number, p in enumerate(vertices):
        if (p.y / p4.spacing).denominator != 1:
            return failed(number + 1, "a vertex of P5 lies on the grid", at=str(p))
    return Verdict(len(vertices), True)


def check_kept(p4: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on mfs(P5) >= mfs(P4); the value is the square of their quotient."""
    before = minimum_feature_size(Pslg(p4.points, tuple(enumerate(p4.successors()))))
    tally = Tally("mfs(P5) >= mfs(P4)", ">=", _ONE)
    if before is not None:
        _see(tally, p4, chords, points, before.squared)
    return tally.verdict()


def check_above_grid(p4: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Verdict:
    """Return the verdict on mfs(P5) at least the spacing of the grid; the value is the square of their quotient."""
    tally = Tally("mfs(P5) >= the spacing of the grid", ">=", _ONE)
    _see(tally, p4, chords, points, p4.spacing * p4.spacing)
    return tally.verdict()


def check_boundary(shape: Shape, p4: Offset, chords: Trapezoidation, tube: Patch, points: Sequence[Point]) -> Verdict:
    """Return whether the boundary of the Tube's faces is that of P and of P4 as P5 left it, with no vertex more; one
    instance an edge of that boundary. Not checked: that the faces are triangles and tile the Tube."""
    chains = _chains(p4, chords, points)
    if isinstance(chains, Misplaced):
        return failed(0, "a chord ends inside its edge", edge_of_p4=chains.edge_of_q, vertex=chains.vertex)
    if tube.on_edge:
        return failed(0, "the Tube records no vertex on P4", vertex=tube.on_edge[0][1])
    wanted = {(v, u) for u, v in chain_sides(chains).tolist()}
    wanted |= {(shape.origin[h], shape.origin[h ^ 1]) for walks in shape.faces for walk in walks for h in walk}
    owner, _ = directed_edges(tube.faces)
    odd = {side for side in owner if side[::-1] not in owner} ^ wanted
    if odd:
        return failed(len(wanted), "the Tube's boundary has no vertex more", edge=list(min(odd)))
    return Verdict(len(wanted), True)


def _see(tally: Tally, p4: Offset, chords: Trapezoidation, points: Sequence[Point], unit_squared: mpq) -> None:
    p5 = _graph(p4, chords, points)
    nearest = None if p5 is None else minimum_feature_size(p5)
    if p5 is None or nearest is None:
        tally.see(mpq(0), what="chords do not end on edges of P4")
        return
    tally.see(nearest.squared / unit_squared, at=str(p5.vertices[nearest.vertex]),
              edge=[str(p5.vertices[v]) for v in nearest.feature])


def _graph(p4: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Pslg | None:
    """Return P5; None when a chord does not end on its edge."""
    chains = _chains(p4, chords, points)
    if isinstance(chains, Misplaced):
        return None
    edges: set[Edge] = {(min(side), max(side)) for side in chain_sides(chains).tolist()}
    for z in chords.trapezoids:
        for row in ((z.bl, *z.bottom, z.br), (z.tl, *z.top, z.tr)):
            edges |= {(min(side), max(side)) for side in pairwise(row) if side[0] != side[1]}
    return Pslg(p4.points + chords.points, tuple((u - p4.first, v - p4.first) for u, v in sorted(edges)))


def _chains(p4: Offset, chords: Trapezoidation, points: Sequence[Point]) -> Chains | Misplaced:
    ends = range(chords.first, chords.first + len(chords.points))
    return edge_chains(p4, zip(chords.edge, ends, strict=True), points)
