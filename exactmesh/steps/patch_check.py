"""Check the Interior and the Tube from the definition of a triangulation; the steps that made them are not imported.

Tiling    every face is a counter-clockwise triangle and the boundaries of the faces add up to that of the region: Q
          for the Interior, P less Q for the Tube, both cut at the recorded vertices. Then the faces tile the region.
Feature   every face has feature size at least g/5.
Caps      no vertex is recorded on an edge of a cap.
Gaps      neighbours on an edge of Q are at least 0.134 apart.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import Ints, exact_balls
from exactmesh.geometry.columns import columns_of, indices
from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.face_columns import Corners, FaceColumns, features_squared, unpaired_sides
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges
from exactmesh.steps.constants import EDGE_GAP, FEATURE_SQUARED
from exactmesh.steps.edge_chains import Chains, Misplaced, chain_sides, edge_chains
from exactmesh.steps.filtered_tally import FilteredTally, see_worst
from exactmesh.steps.records import Offset, Patch, Shape, Trapezoidation


def recorded_on_edges(chords: Trapezoidation, interior: Patch) -> list[tuple[int, int]]:
    """Return all vertices recorded on edges of Q, chord ends and feet, with their edges."""
    return [(edge, chords.first + i) for i, edge in enumerate(chords.edge)] + list(interior.on_edge)


class PatchColumns:
    """The faces of a patch in arrays, and which of them are triangles."""

    def __init__(self, patch: Patch, points: Sequence[Point]) -> None:
        self.points = columns_of(points)
        self.faces = FaceColumns(patch.faces)
        self.corners = Corners(self.points, self.faces)


def chains_of(offset: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Chains | Misplaced:
    """Return the edges of Q cut at all vertices recorded on them."""
    return edge_chains(offset, recorded_on_edges(chords, interior), points)


def check_interior_tiling(offset: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point],
                          chains: Chains | Misplaced | None = None, columns: PatchColumns | None = None) -> Verdict:
    """Return whether the faces of the Interior tile the inside of Q; one instance a face.

    To give `chains_of` and the `PatchColumns` of the Interior saves time, here and below.
    """
    chains = chains or chains_of(offset, chords, interior, points)
    if isinstance(chains, Misplaced):
        return _misplaced(chains)
    return _check_tiling(interior, chain_sides(chains), columns or PatchColumns(interior, points))


def check_tube_tiling(shape: Shape, offset: Offset, chords: Trapezoidation, interior: Patch, tube: Patch,
                      points: Sequence[Point], chains: Chains | Misplaced | None = None,
                      columns: PatchColumns | None = None) -> Verdict:
    """Return whether the faces of the Tube tile what lies between P and Q; one instance a face."""
    chains = chains or chains_of(offset, chords, interior, points)
    if isinstance(chains, Misplaced):
        return _misplaced(chains)
    origin = np.array(shape.origin, np.int64)
    along = indices(h for walks in shape.faces for walk in walks for h in walk)
    p_sides = np.column_stack((origin[along], origin[along ^ 1]))
    # An edge with the Tube on both sides is in no boundary.
    outside = p_sides[~np.isin(along, along ^ 1)]
    boundary = np.concatenate((chain_sides(chains)[:, ::-1], outside))
    return _check_tiling(tube, boundary, columns or PatchColumns(tube, points))


def check_feature(patch: Patch, points: Sequence[Point], columns: PatchColumns | None = None) -> Verdict:
    """Return the verdict on the least squared feature size of the faces; one instance a face.

    A face that is no triangle counts as zero.
    """
    tally = Tally("feature size >= g/5", ">=", FEATURE_SQUARED)
    columns = columns or PatchColumns(patch, points)
    faces, corners = columns.faces, columns.corners

    def exactly(face: int) -> mpq:
        cycle = patch.faces[face]
        places = corners_of(points, cycle)
        return mpq(0) if isinstance(places, NotTriangle) else face_feature_squared(points, cycle, places)

    def place(face: int) -> dict[str, object]:
        cycle = patch.faces[face]
        return {"face": list(cycle), "at": str(points[cycle[0]]) if cycle else ""}

    least = FilteredTally(tally, "face feature")
    least.offer(corners.bad, exact_balls(np.zeros(len(corners.bad))))
    for numbers, values in features_squared(columns.points, faces, corners):
        good = ~np.isin(numbers, corners.bad)
        least.offer(numbers[good], values[good])
    least.see(exactly, place, faces.count)
    return tally.verdict()


def with_bound(verdict: Verdict, feature: mpq) -> Verdict:
    """Return the verdict of `check_feature` on the same faces with another bound."""
    if verdict.worst is None or verdict.witness is None:
        return verdict
    return replace(verdict, holds=bool(verdict.worst >= feature**2),
                   witness=replace(verdict.witness, clause=f"feature size >= {feature}"))


def check_caps(offset: Offset, chords: Trapezoidation, interior: Patch) -> Verdict:
    """Return whether no vertex is recorded on an edge of a cap; one instance a recorded vertex."""
    recorded = recorded_on_edges(chords, interior)
    for number, (edge, v) in enumerate(recorded):
        if offset.source[edge] < 0:
            return failed(number + 1, "edges of caps stay whole", edge_of_q=edge, vertex=v)
    return Verdict(len(recorded), True)


def check_edge_gaps(offset: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point],
                    chains: Chains | Misplaced | None = None) -> Verdict:
    """Return the verdict on the least squared distance of neighbours on edges of Q with recorded vertices."""
    chains = chains or chains_of(offset, chords, interior, points)
    if isinstance(chains, Misplaced):
        return _misplaced(chains)
    tally = Tally("neighbours >= 0.134 apart", ">=", EDGE_GAP**2)
    columns = columns_of(points)
    edge = indices(k for k, chain in enumerate(chains) if len(chain) > 2 for _ in chain[1:])
    first = indices(v for chain in chains if len(chain) > 2 for v in chain[:-1])
    last = indices(v for chain in chains if len(chain) > 2 for v in chain[1:])

    def exactly(i: int) -> mpq:
        return distance_squared(points[first[i]], points[last[i]])

    def place(i: int) -> dict[str, object]:
        u, v = int(first[i]), int(last[i])
        return {"edge_of_q": int(edge[i]), "vertices": [u, v], "at": str(points[u])}

    see_worst(tally, "edge gap", columns.distances_squared(first, last), exactly, place)
    return tally.verdict()


def _misplaced(chains: Misplaced) -> Verdict:
    return failed(0, "a foot lies inside its edge", edge_of_q=chains.edge_of_q, vertex=chains.vertex)


def _check_tiling(patch: Patch, boundary: Ints, columns: PatchColumns) -> Verdict:
    """Return whether the faces are triangles and the directed edges without a twin are those of `boundary`.

    Arrays decide that all is well; when it is not, the offender is looked for one by one.
    """
    count = len(patch.faces)
    points = columns.points
    for face in columns.corners.bad[:1].tolist():
        cycle = patch.faces[face]
        reason = corners_of(points, cycle)
        if isinstance(reason, NotTriangle):
            return failed(face + 1, "faces are triangles", face=list(cycle), vertex=reason.vertex,
                          reason=reason.reason)
    unpaired = unpaired_sides(columns.faces, len(points))
    if unpaired is None:
        _, repeated = directed_edges(patch.faces)
        return failed(count, "faces do not overlap", edge=list(repeated[0][0]))
    odd = np.setxor1d(unpaired, boundary[:, 0] * len(points) + boundary[:, 1])
    if odd.size:
        edge = divmod(int(odd[0]), len(points))
        return failed(count, "the faces' boundaries add up to the region's", edge=list(edge))
    return Verdict(count, True)
