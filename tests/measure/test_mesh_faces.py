"""All faces at once against one face after the other, at any scale; and how much is left to exact arithmetic."""

import random
from collections.abc import Callable

import families
import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry import fixed_point
from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.fixed_point import FixedPoints
from exactmesh.geometry.point import Point
from exactmesh.measure import mesh_faces as module
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.mesh_faces import MeshFaces
from exactmesh.planar.cycles import directed_edges
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

GRAPHS: dict[str, Pslg] = {
    "comb": families.comb(12), "star": families.star(9), "spiral": families.curved_spiral(2, 12),
    "random": families.random_simple_polygon(60, 4, "partition"), "map": families.grid_map(5, 5, 3),
    "flat": families.sliver(10**9, mpq(1, 10**9), 3)}
MESHES: dict[str, Mesh] = {name: exactmesh.mesh(graph).mesh for name, graph in GRAPHS.items()}
MOVES: dict[str, Callable[[Point], Point]] = {
    "as it is": lambda p: p,
    "tiny": lambda p: Point(p.x / 10**40 + 1, p.y / 10**40 - 7),
    "turned": lambda p: Point(3 * p.x - 4 * p.y, 4 * p.x + 3 * p.y),
    "flattened": lambda p: Point(p.x, (p.y + p.x) / 10**24),
}


def least_by_one(points: tuple[Point, ...], mesh: Mesh) -> tuple[mpq, int]:
    found = []
    for number, cycle in enumerate(mesh.faces):
        corners = corners_of(points, cycle)
        assert not isinstance(corners, NotTriangle)
        found.append((face_feature_squared(points, cycle, corners), number))
    return min(found)


@pytest.mark.parametrize("move", MOVES)
@pytest.mark.parametrize("name", MESHES)
def test_the_least_feature_is_that_of_all_faces_one_by_one(name: str, move: str) -> None:
    mesh = MESHES[name]
    points = tuple(map(MOVES[move], mesh.vertices))
    faces = MeshFaces(FixedPoints(points), mesh.faces)
    assert faces.not_triangles() == []
    assert faces.least_feature() == least_by_one(points, mesh)


@pytest.mark.parametrize("chunk", [1, 3, 50])
def test_stretches_make_no_difference(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(fixed_point, "_CHUNK", chunk)
    mesh = MESHES["comb"]
    faces = MeshFaces(FixedPoints(mesh.vertices), mesh.faces)
    assert faces.not_triangles() == [] and faces.least_feature() == least_by_one(mesh.vertices, mesh)


def test_faces_that_are_no_triangles_are_those_found_one_by_one() -> None:
    source = random.Random(5)
    refused = 0
    for mesh in MESHES.values():
        cycles = []
        for cycle in mesh.faces:
            changed = list(cycle)
            if source.random() < 0.3:
                source.shuffle(changed)
            if source.random() < 0.1:
                changed = changed[: source.randrange(3)]
            if source.random() < 0.1 and changed:
                changed.append(source.choice(changed))
            cycles.append(tuple(changed))
        expected = [(number, reason) for number, cycle in enumerate(cycles)
                    if isinstance(reason := corners_of(mesh.vertices, cycle), NotTriangle)]
        assert MeshFaces(FixedPoints(mesh.vertices), cycles).not_triangles() == expected
        refused += len(expected)
    assert refused > 50


@pytest.mark.parametrize("many", [0, 2**31 - 1])
def test_sides_are_those_of_the_dictionary(many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_MANY", many)
    source = random.Random(6)
    for mesh in MESHES.values():
        cycles = [*mesh.faces, *source.sample(mesh.faces, 5), *(face[::-1] for face in source.sample(mesh.faces, 3))]
        source.shuffle(cycles)
        owner, repeated = directed_edges(cycles)
        faces = MeshFaces(FixedPoints(mesh.vertices), cycles)
        sides = faces.sides()
        first, last = faces.vertex.tolist(), faces.vertex[faces.following].tolist()
        keys = list(zip(first, last, strict=True))
        assert [keys[entry] for entry in sides.first.tolist()] == list(owner)
        assert faces.face[sides.first].tolist() == list(owner.values())
        found = [(keys[entry], int(faces.face[entry])) for entry in sides.repeated]
        assert found == repeated
        assert faces.face[sides.owner].tolist() == [owner[side] for side, _ in repeated]


@pytest.mark.parametrize("family", ["comb", "star", "growth"])
def test_exact_decisions_of_a_verification_grow_no_faster_than_the_mesh(family: str) -> None:
    for n in (100, 400):
        graph = {"comb": lambda n=n: families.comb(n // 2), "star": lambda n=n: families.star(n // 2),
                 "growth": lambda n=n: families.random_simple_polygon(n, 1, "growth")}[family]()
        mesh = exactmesh.mesh(graph).mesh
        forget()
        assert exactmesh.verify(graph, mesh).valid
        counts = decisions()
        t_vertices = sum(len(face) - 3 for face in mesh.faces)
        # Three points on a line are what floats cannot tell; a few more may lie nearly so.
        assert counts["orientation"].exactly <= t_vertices + 10
        assert counts["orientation"].by_floats >= 3 * len(mesh.faces) - 10
        assert counts["least face feature"].exactly <= n
        assert counts["sweep orientation"].exactly <= n and counts["coincidence"].exactly == 0
