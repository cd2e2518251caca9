"""Find, for each of a few points, a face that contains it."""

from collections.abc import Sequence

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.planar.cycles import Cycle, sides


def faces_around(wanted: Sequence[Point], points: Sequence[Point], faces: Sequence[Cycle]) -> list[int]:
    """Return the number of the first face with each of the `wanted` points inside or on its boundary, -1 for none.

    Faces are convex and counter-clockwise. O(faces) comparisons of small integers a point, and predicates for the few
    faces whose boxes hold it.
    """
    if not wanted or not faces:
        return [-1] * len(wanted)
    near = np.ones((len(wanted), len(faces)), dtype=np.bool_)
    for axis in (0, 1):
        near &= _near([p[axis] for p in wanted], [p[axis] for p in points], faces)
    return [next((face for face in np.flatnonzero(row).tolist() if all(
        orientation(points[u], points[v], p) >= 0 for u, v in sides(faces[face]))), -1)
            for p, row in zip(wanted, near, strict=True)]


def _near(wanted: Sequence[mpq], values: Sequence[mpq], faces: Sequence[Cycle]) -> NDArray[np.bool_]:
    """Return, by wanted value and face, whether the value lies in the face's span; by ranks, so exactly."""
    place = {value: r for r, value in enumerate(sorted({*wanted, *values}))}
    ranks = [place[value] for value in values]
    low = np.array([min(ranks[v] for v in face) for face in faces])
    high = np.array([max(ranks[v] for v in face) for face in faces])
    rank = np.array([place[value] for value in wanted])[:, None]
    inside: NDArray[np.bool_] = (low <= rank) & (rank <= high)
    return inside
