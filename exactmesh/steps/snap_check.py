"""Check the paper's P4 from the definition of snapping, and what snapping does to distances; `snap.py` is not imported.

S1  P4 has the vertices of P3, in their order.          S2  a vertex lies on its line of the grid.
S3  y moves by at most half the spacing of the grid.    S4  x, which the paper keeps, moves by at most mfs/2^17.

Values are in units of the mfs, squared. `inverse_d3` is the paper's 1/d3; the grid's spacing is a rational just below
1/(2 d3) mfs, which S5 asserts, so the bounds that follow are the paper's own.
"""

from itertools import chain

from gmpy2 import mpq

from exactmesh.errors import GeometryError
from exactmesh.measure.algebraic_mfs import Labelled, algebraic_mfs, least_between, real_place
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.verdict import Tally, Verdict, Witness, failed
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.validate import validate
from exactmesh.steps.curve_view import decimal_place
from exactmesh.steps.records import Offset, OffsetCurve, RealPoint, Shape

_X_MOTION = mpq(1, 2**17)
_NONE = -1


def check_motion(curve: OffsetCurve, p4: Offset, inverse_d3: Real) -> Verdict:
    """Return the verdict on the squared motion of each vertex, at most 1/(4 d3), once S1 to S5 hold."""
    tally = Tally("a vertex moves by at most 1/(4 d3)", "<=", (inverse_d3 / 4) ** 2)
    p3 = _vertices(curve)
    if not _corresponds(curve, p4):
        return failed(0, "S1: P4 has the vertices of P3 in their order")
    if not 0 < 2 * p4.spacing <= inverse_d3 * sqrt(curve.mfs_squared):
        return failed(0, "S5: the spacing is at most 1/(2 d3)", spacing=str(p4.spacing))
    for v, (old, new) in enumerate(zip(p3, p4.points, strict=True)):
        x, y = new.x - old.x, new.y - old.y
        broken = ("S2: a vertex lies on its line" if (new.x, new.y) != (p4.x[v], p4.level[v] * p4.spacing) else
                  "S3: a vertex goes to the nearest line" if 2 * abs(y) > p4.spacing else
                  "S4: x stays" if x * x > _X_MOTION**2 * curve.mfs_squared else None)
        if broken:
            return failed(v + 1, broken, vertex_of_p4=v, at=str(new), before=decimal_place(old))
        tally.see((x * x + y * y) / curve.mfs_squared, vertex_of_p4=v, at=str(new))
    return tally.verdict()


def check_feature_size(curve: OffsetCurve, p4: Offset, inverse_d3: Real) -> Verdict:
    """Return the verdict on mfs(P4) >= 1/(2 d3); one instance a vertex."""
    return _rational_mfs(Pslg(p4.points, _edges(p4)), "mfs(P4) >= 1/(2 d3)", inverse_d3 / 2, curve, len(p4.points))


def check_both_regions(shape: Shape, curve: OffsetCurve, p4: Offset, inverse_d3: Real) -> Verdict:
    """Return the verdict on the mfs of P and P4 together, at least 1/(2 d3); one instance a vertex of P4."""
    count = len(shape.points)
    p_edges = tuple((shape.origin[h], shape.origin[h ^ 1]) for h in range(0, len(shape.origin), 2))
    both = Pslg(shape.points + p4.points, p_edges + tuple((u + count, v + count) for u, v in _edges(p4)))
    return _rational_mfs(both, "mfs(P and P4) >= 1/(2 d3)", inverse_d3 / 2, curve, len(p4.points))


def check_tube_distance(shape: Shape, curve: OffsetCurve, p4: Offset, inverse_d3: Real) -> Verdict:
    """Return the verdict on the distance between P and P4, at least 1/(4 sqrt 2) - 1/(4 d3); one instance a vertex."""
    bound = (1 / (4 * sqrt(2)) - inverse_d3 / 4) ** 2
    places = [real_place(p) for p in shape.points + p4.points]
    count = len(shape.points)
    p_edges = [(shape.origin[h], shape.origin[h ^ 1]) for h in range(0, len(shape.origin), 2)]
    q_edges = [(u + count, v + count) for u, v in _edges(p4)]
    least = least_between(places, [
        Labelled(range(count), [_NONE] * count, q_edges, q_edges),
        Labelled(range(count, len(places)), [_NONE] * len(p4.points), p_edges, p_edges)],
        ">=", bound * curve.mfs_squared)
    if least is None:
        return Verdict(0, True)
    place = {"from": decimal_place(places[least.vertex]), "to": [decimal_place(places[v]) for v in least.edge]}
    return Verdict(len(p4.points), least.holds, least.squared / curve.mfs_squared,
                   Witness("P4 keeps 1/(4 sqrt 2) - 1/(4 d3) from P", place))


def check_perturbation(curve: OffsetCurve, p4: Offset) -> Verdict:
    """Return the verdict of Lemma 2 on the step from P3 to P4: mfs(P4) + 2 motion over mfs(P3), squared, is at least 1,
    and P4 is a simple polygon. With a motion of a mfs(P3), this is mfs(P4)/mfs(P3) >= 1 - 2 a; when a is 1/2 or more
    nothing is said, and there is no instance.

    Simple is all that has to be asked of the drawing: on the way from P3 to P4 the order of vertices stays."""
    clause = "mfs(P4) >= (1 - 2 a) mfs(P3)"
    before = algebraic_mfs(_vertices(curve), [edge for ring in _rings(curve) for edge in ring])
    after = minimum_feature_size(Pslg(p4.points, _edges(p4)))
    if before is None or after is None or not _corresponds(curve, p4):
        return failed(0, "S1: P4 has the vertices of P3 in their order")
    motion = max(_squared(old, RealPoint(Real(new.x), Real(new.y)))
                 for old, new in zip(_vertices(curve), p4.points, strict=True))
    if 4 * motion >= before.squared:
        return Verdict(0, True)
    if (reason := _crossing(p4)) is not None:
        return failed(1, "the drawings are equivalent", what=reason)
    reach = after.squared + 4 * motion + 4 * sqrt(after.squared * motion)
    tally = Tally(clause, ">=", mpq(1))
    tally.see(reach / before.squared, vertex_of_p4=after.vertex, edge_of_p4=list(after.feature),
              motion=sqrt(motion).decimal())
    return tally.verdict()


def _rational_mfs(graph: Pslg, clause: str, bound: Real, curve: OffsetCurve, instances: int) -> Verdict:
    tally = Tally(clause, ">=", bound * bound)
    nearest = minimum_feature_size(graph)
    if nearest is None:
        return tally.verdict()
    tally.see(nearest.squared / curve.mfs_squared, at=str(graph.vertices[nearest.vertex]),
              edge=[str(graph.vertices[v]) for v in nearest.feature])
    verdict = tally.verdict()
    return Verdict(instances, verdict.holds, verdict.worst, verdict.witness)


def _crossing(p4: Offset) -> str | None:
    """Return in words how P4 is no simple polygon; None when it is one."""
    try:
        validate(Pslg(p4.points, _edges(p4)))
    except GeometryError as error:
        return str(error)
    return None


def _corresponds(curve: OffsetCurve, p4: Offset) -> bool:
    corners = [corner.corner for ring in curve.rings for corner in ring for _ in corner.vertices]
    ranges = tuple((ring[0][0], ring[-1][0] + 1) for ring in _rings(curve))
    return (list(p4.corner) == corners and p4.rings == ranges
            and len(corners) == len(p4.points) == len(p4.x) == len(p4.level))


def _vertices(curve: OffsetCurve) -> list[RealPoint]:
    return [vertex for corner in chain.from_iterable(curve.rings) for vertex in corner.vertices]


def _rings(curve: OffsetCurve) -> list[list[Edge]]:
    """Return the edges of P3, ring by ring."""
    rings = []
    start = 0
    for ring in curve.rings:
        end = start + sum(len(corner.vertices) for corner in ring)
        rings.append([(v, v + 1 if v + 1 < end else start) for v in range(start, end)])
        start = end
    return rings


def _edges(p4: Offset) -> tuple[Edge, ...]:
    return tuple(enumerate(p4.successors()))


def _squared(a: RealPoint, b: RealPoint) -> Real:
    x, y = a.x - b.x, a.y - b.y
    return x * x + y * y
