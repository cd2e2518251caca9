"""Ranks of faces are those of exact arithmetic, whichever way they were found."""

import families
import pytest
from constructions import point
from gmpy2 import mpq
from hypothesis import example, given
from hypothesis import strategies as st

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.pictures import faces as module
from exactmesh.pictures.faces import face_looks
from exactmesh.pictures.palette import FEATURE_FLOORS
from exactmesh.planar.mesh import Mesh

NAMES = ("sliver with bends", "tiny", "huge", "30 digits", "comb 9 uneven nearly level", "growth 24")
MESHES = {name: Run(families.ALL_SMALL[name], "repaired") for name in NAMES}


def oracle(mesh: Mesh, size_squared: mpq) -> tuple[list[int], set[int]]:
    ranks, on_sides = [], set()
    for face in mesh.faces:
        corners = corners_of(mesh.vertices, face)
        assert not isinstance(corners, NotTriangle)
        squared = face_feature_squared(mesh.vertices, face, corners)
        ranks.append(sum(squared * floor**2 < size_squared for floor in FEATURE_FLOORS))
        on_sides |= {v for i, v in enumerate(face) if i not in corners}
    return ranks, on_sides


@pytest.mark.parametrize("name", NAMES)
def test_ranks_and_vertices_on_sides_are_exact(name: str) -> None:
    run = MESHES[name]
    looks = face_looks(run.mesh.vertices, run.mesh.faces, run.mfs.squared)
    ranks, on_sides = oracle(run.mesh, run.mfs.squared)
    assert list(looks.rank) == ranks and set(looks.on_sides) == on_sides and len(set(ranks)) > 1
    assert all(len(corners) == 3 and set(corners) <= set(face)
               for corners, face in zip(looks.corners, run.mesh.faces, strict=True))


@pytest.mark.parametrize("factor", [mpq(2) ** 1500, mpq(2) ** -1500, mpq(10) ** 160, mpq(10) ** -160])
def test_ranks_are_those_of_any_other_scale(factor: mpq) -> None:
    # Where floats overflow or have no digits left, exact arithmetic decides.
    run = MESHES["growth 24"]
    points = tuple(Point(p.x * factor, p.y * factor) for p in run.mesh.vertices)
    assert face_looks(points, run.mesh.faces, run.mfs.squared * factor**2) == face_looks(
        run.mesh.vertices, run.mesh.faces, run.mfs.squared)


def test_a_feature_on_a_floor_is_not_below_it(monkeypatch: pytest.MonkeyPatch) -> None:
    # Floats cannot tell: the exact rank is asked for, for these and no others.
    asked: list[object] = []
    exact = module._exact_rank
    monkeypatch.setattr(module, "_exact_rank", lambda *given: (asked.append(given[1]), exact(*given))[1])
    third = mpq(1, 3)
    heights = [third / floor for floor in FEATURE_FLOORS] + [mpq(1, 5), mpq(1, 1000)]
    points = [p for i, h in enumerate(heights) for p in (
        Point(mpq(10 * i), mpq(0)), Point(10 * i + mpq(8), mpq(0)), Point(10 * i + mpq(4), h))]
    cycles = [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(heights))]
    assert face_looks(points, cycles, third**2).rank == (0, 1, 2, 3, 4, 5, 1, 6)
    assert len(asked) == len(FEATURE_FLOORS)


@given(st.lists(st.lists(st.integers(-3, 6), max_size=5).map(tuple), max_size=8))
@example([(0, 1, 2), (0, 2, 1), (1, 1, 1), (0, 1, 3, 2), ()])
@example([(0, 1, 7)])
def test_anything_can_be_looked_at(faces: list[tuple[int, ...]]) -> None:
    points = [point(0, 0), point(4, 0), point(0, 4), point(2, 2), point(4, 4)]
    looks = face_looks(points, faces, mpq(1))
    kept = [face for face in faces if face and all(0 <= v < 5 for v in face)]
    assert len(looks.rank) == len(looks.corners) == len(kept)
    for face, rank in zip(kept, looks.rank, strict=True):
        assert (rank < 0) == isinstance(corners_of(points, face), NotTriangle)
