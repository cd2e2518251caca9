"""How the faces of a mesh are to look: their corners, and a rank by feature size, found once for all panels.

Ranks are exact: floats with proven bounds decide most of them, `face_feature_squared` the rest.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import PADDING, Balls, Bools, Ints
from exactmesh.geometry.columns import Columns
from exactmesh.geometry.face_columns import Corners, FaceColumns, features_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.pictures.palette import FEATURE_FLOORS
from exactmesh.planar.cycles import Cycle

# More than the relative error of a float made of a rational.
_SLACK = 2.0**-50


@dataclass(frozen=True, slots=True)
class FaceLooks:
    """Faces as they are drawn: `corners` without the vertices on sides, `rank` by feature size (-1: no triangle).

    `on_sides` are the vertices that lie on sides of triangles.
    """

    corners: tuple[Cycle, ...]
    rank: tuple[int, ...]
    on_sides: tuple[int, ...]


def face_looks(points: Sequence[Point], faces: Sequence[Cycle], size_squared: mpq) -> FaceLooks:
    """Return the looks of faces by their features over the square root of `size_squared`, in the order of the faces.

    Rank k is below `FEATURE_FLOORS[k - 1]` and not below `FEATURE_FLOORS[k]`. A face that names a vertex that is not
    there is left out.
    """
    count = len(points)
    flat = np.fromiter(chain.from_iterable(faces), np.int64)
    if flat.size and not (flat.min() >= 0 and flat.max() < count):
        faces = [face for face in faces if all(0 <= v < count for v in face)]
    # An array of cycles none of which is empty is what the columns take.
    faces = [face for face in faces if face]
    columns, sorted_faces = Columns(points), FaceColumns(faces)
    corners = Corners(columns, sorted_faces)
    rank = np.zeros(len(faces), np.int64)
    shown: list[Cycle] = list(faces)
    on_sides: set[int] = set()
    bad = set(corners.bad.tolist())
    for number, places in zip(sorted_faces.long.tolist(), corners.places, strict=True):
        if number not in bad:
            shown[number] = tuple(sorted_faces.rows.flat[places].tolist())
            on_sides.update(set(faces[number]).difference(shown[number]))
    floors = [size_squared / floor**2 for floor in FEATURE_FLOORS]
    for numbers, values in features_squared(columns, sorted_faces, corners):
        found, decided = _ranks(values, floors)
        rank[numbers] = found
        for number in numbers[~decided].tolist():
            if number not in bad:
                rank[number] = _exact_rank(points, faces[number], floors)
    rank[corners.bad] = -1
    return FaceLooks(tuple(shown), tuple(rank.tolist()), tuple(sorted(on_sides)))


def _ranks(values: Balls, floors: Sequence[mpq]) -> tuple[Ints, Bools]:
    """Return the number of floors above each value, and which of these are certain."""
    low, high = values.mid - values.rad * PADDING, values.mid + values.rad * PADDING
    low, high = low - abs(low) * _SLACK, high + abs(high) * _SLACK
    surely, maybe = np.zeros(len(values), np.int64), np.zeros(len(values), np.int64)
    for floor in floors:
        try:
            value = float(floor)
        except OverflowError:
            return surely, np.zeros(len(values), bool)
        surely += high < value * (1 - _SLACK)
        maybe += low < value * (1 + _SLACK)
    # Not a number compares as false; subnormal floats have fewer digits than the slack allows for.
    return surely, (surely == maybe) & np.isfinite(high) & np.isfinite(low) & (values.mid > 2.0**-900)


def _exact_rank(points: Sequence[Point], face: Cycle, floors: Sequence[mpq]) -> int:
    corners = corners_of(points, face)
    if isinstance(corners, NotTriangle):
        raise AssertionError("faces that are no triangles have been set aside")
    squared = face_feature_squared(points, face, corners)
    return sum(squared < floor for floor in floors)
