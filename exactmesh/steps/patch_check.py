"""Check the Interior and the Tube from the definition of a triangulation; the steps that made them are not imported.

Tiling    every face is a counter-clockwise triangle and the boundaries of the faces add up to that of the region: Q
          for the Interior, P less Q for the Tube, both cut at the recorded vertices. Then the faces tile the region.
Feature   every face has feature size at least g/5.
Caps      no vertex is recorded on an edge of a cap.
Gaps      neighbours on an edge of Q are at least 0.134 apart.
"""

from collections.abc import Sequence
from itertools import pairwise

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import Side, directed_edges
from exactmesh.steps.constants import EDGE_GAP, FEATURE_SQUARED
from exactmesh.steps.edge_chains import Misplaced, chain_sides, edge_chains
from exactmesh.steps.records import Offset, Patch, Shape, Trapezoidation


def recorded_on_edges(chords: Trapezoidation, interior: Patch) -> list[tuple[int, int]]:
    """Return all vertices recorded on edges of Q, chord ends and feet, with their edges."""
    return [(edge, chords.first + i) for i, edge in enumerate(chords.edge)] + list(interior.on_edge)


def check_interior_tiling(offset: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Verdict:
    """Return whether the faces of the Interior tile the inside of Q; one instance a face."""
    chains = edge_chains(offset, recorded_on_edges(chords, interior), points)
    if isinstance(chains, Misplaced):
        return failed(0, "a foot lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)
    return _check_tiling(interior, chain_sides(chains), points)


def check_tube_tiling(shape: Shape, offset: Offset, chords: Trapezoidation, interior: Patch, tube: Patch,
                      points: Sequence[Point]) -> Verdict:
    """Return whether the faces of the Tube tile what lies between P and Q; one instance a face."""
    chains = edge_chains(offset, recorded_on_edges(chords, interior), points)
    if isinstance(chains, Misplaced):
        return failed(0, "a foot lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)
    boundary = {side[::-1] for side in chain_sides(chains)}
    p_sides = {(shape.origin[h], shape.origin[h ^ 1]) for walks in shape.faces for walk in walks for h in walk}
    # An edge with the Tube on both sides is in no boundary.
    boundary |= {side for side in p_sides if side[::-1] not in p_sides}
    return _check_tiling(tube, boundary, points)


def check_feature(patch: Patch, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of the faces; one instance a face.

    A face that is no triangle counts as zero.
    """
    tally = Tally("feature size >= g/5", ">=", FEATURE_SQUARED)
    for cycle in patch.faces:
        corners = corners_of(points, cycle)
        value = 0 * FEATURE_SQUARED if isinstance(corners, NotTriangle) else face_feature_squared(
            points, cycle, corners)
        tally.see(value, face=list(cycle), at=str(points[cycle[0]]) if cycle else "")
    return tally.verdict()


def check_caps(offset: Offset, chords: Trapezoidation, interior: Patch) -> Verdict:
    """Return whether no vertex is recorded on an edge of a cap; one instance a recorded vertex."""
    recorded = recorded_on_edges(chords, interior)
    for number, (edge, v) in enumerate(recorded):
        if offset.source[edge] < 0:
            return failed(number + 1, "edges of caps stay whole", edge_of_q=edge, vertex=v)
    return Verdict(len(recorded), True)


def check_edge_gaps(offset: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared distance of neighbours on edges of Q with recorded vertices."""
    tally = Tally("neighbours >= 0.134 apart", ">=", EDGE_GAP**2)
    chains = edge_chains(offset, recorded_on_edges(chords, interior), points)
    if isinstance(chains, Misplaced):
        return failed(0, "a foot lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)
    for k, chain in enumerate(chains):
        for u, v in pairwise(chain if len(chain) > 2 else ()):
            tally.see(distance_squared(points[u], points[v]), edge_of_q=k, vertices=[u, v], at=str(points[u]))
    return tally.verdict()


def _check_tiling(patch: Patch, boundary: set[Side], points: Sequence[Point]) -> Verdict:
    count = len(patch.faces)
    for number, cycle in enumerate(patch.faces):
        corners = corners_of(points, cycle)
        if isinstance(corners, NotTriangle):
            return failed(number + 1, "faces are triangles", face=list(cycle), vertex=corners.vertex,
                          reason=corners.reason)
    owner, repeated = directed_edges(patch.faces)
    if repeated:
        return failed(count, "faces do not overlap", edge=list(repeated[0][0]))
    if odd := {side for side in owner if side[::-1] not in owner} ^ boundary:
        return failed(count, "the faces' boundaries add up to the region's", edge=list(min(odd)))
    return Verdict(count, True)
