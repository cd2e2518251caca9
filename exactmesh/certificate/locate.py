"""Find, for each of a few points, a face that contains it."""

from collections.abc import Sequence

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.planar.cycles import Cycle, sides

Spans = tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.int64]]


def faces_around(wanted: Sequence[Point], points: Sequence[Point], faces: Sequence[Cycle]) -> list[int]:
    """Return the number of the first face with each of the `wanted` points inside or on its boundary, -1 for none.

    Faces are convex and counter-clockwise. O(faces) comparisons of small integers a point, and predicates for the few
    faces whose boxes hold it.
    """
    if not wanted or not faces:
        return [-1] * len(wanted)
    spans = [_spans([p[axis] for p in wanted], [p[axis] for p in points], faces) for axis in (0, 1)]
    return [_face_around(p, number, points, faces, spans) for number, p in enumerate(wanted)]


def _face_around(p: Point, number: int, points: Sequence[Point], faces: Sequence[Cycle], spans: Sequence[Spans]) -> int:
    near = np.ones(len(faces), dtype=np.bool_)
    for low, high, rank in spans:
        near &= (low <= rank[number]) & (rank[number] <= high)
    for face in np.flatnonzero(near).tolist():
        if all(orientation(points[u], points[v], p) >= 0 for u, v in sides(faces[face])):
            return face
    return -1


def _spans(wanted: Sequence[mpq], values: Sequence[mpq], faces: Sequence[Cycle]) -> Spans:
    """Return the least and the greatest value of each face, and the wanted ones, as ranks: exactly."""
    place = {value: r for r, value in enumerate(sorted({*wanted, *values}))}
    ranks = [place[value] for value in values]
    return (np.array([min(ranks[v] for v in face) for face in faces]),
            np.array([max(ranks[v] for v in face) for face in faces]), np.array([place[value] for value in wanted]))
