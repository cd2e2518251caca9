"""Classic meshes: valid, and the best one as good as the best of all triangulations."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, pairwise

import families
import oracle
import pytest
from constructions import HALL, face_feature_squared, graph, lattice_polygon
from gmpy2 import mpq

from exactmesh.classic import MAX_OPTIMAL_VERTICES, classic_mesh, optimal_classic_mesh, visible_pairs
from exactmesh.errors import InputError
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg

INPUTS = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": HALL}
SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
RIM = [(0, 1), (1, 2), (2, 3), (3, 0)]


def optimum(pslg: Pslg) -> Verification:
    """Return the verification of the optimal classic mesh; it is valid."""
    subdivision = domain_of(pslg)
    verification = verify_mesh(subdivision, optimal_classic_mesh(subdivision))
    assert verification.valid, verification.violations
    return verification


def admissible(pslg: Pslg) -> set[tuple[int, int]]:
    """Return edges and diagonals of a polygon by the oracle: pairs i < j whose open segment lies inside."""
    at = [oracle.triple(p) for p in pslg.vertices]
    domain = oracle.Domain(pslg.vertices, pslg.edges)
    found = {(min(e), max(e)) for e in pslg.edges}
    for i, j in combinations(range(len(at)), 2):
        if (i, j) in found or any(k not in (i, j) and oracle.on_segment(p, at[i], at[j]) for k, p in enumerate(at)):
            continue
        if any(not {i, j} & set(e) and oracle.meet(at[i], at[j], at[e[0]], at[e[1]]) for e in pslg.edges):
            continue
        (px, py), (qx, qy) = (oracle.place(pslg.vertices[v]) for v in (i, j))
        if domain.contains(((px + qx) / 2, (py + qy) / 2)):
            found.add((i, j))
    return found


def all_triangulations(sides: set[tuple[int, int]], i: int, j: int) -> Iterator[list[tuple[int, int, int]]]:
    """Yield every triangulation of the vertices i to j of a counter-clockwise polygon."""
    if j == i + 1:
        yield []
        return
    for k in range(i + 1, j):
        if (i, k) in sides and (k, j) in sides:
            for left in all_triangulations(sides, i, k):
                for right in all_triangulations(sides, k, j):
                    yield [(i, k, j), *left, *right]


def best_of_all(pslg: Pslg) -> Fraction:
    """Return the greatest squared mfs of a triangulation of a counter-clockwise polygon, all of them tried."""
    sides = admissible(pslg)
    least = max(min(face_feature_squared(pslg.vertices, t) for t in triangles)
                for triangles in all_triangulations(sides, 0, len(pslg.vertices) - 1))
    own = oracle.mfs_squared(pslg.vertices, pslg.edges)
    assert own is not None
    return min(own, least)


@pytest.mark.parametrize("name", INPUTS)
def test_the_fast_mesh_is_valid(name: str) -> None:
    subdivision = domain_of(INPUTS[name])
    mesh = classic_mesh(subdivision)
    assert mesh.kind == "classic" and mesh.faces == constrained_delaunay(subdivision).triangles
    verification = verify_mesh(subdivision, mesh)
    assert verification.valid and verification.degradation_squared is not None


@pytest.mark.parametrize("name", families.ALL_SMALL)
def test_the_best_mesh_is_valid_and_no_worse_than_the_fast_one(name: str) -> None:
    pslg = families.ALL_SMALL[name]
    best = optimum(pslg).degradation_squared
    fast = verify_mesh(domain_of(pslg), classic_mesh(domain_of(pslg))).degradation_squared
    assert best is not None and fast is not None and 1 <= best <= fast


@pytest.mark.parametrize("n", [4, 5, 6, 7, 8])
def test_the_best_mesh_is_the_best_of_all(n: int) -> None:
    for seed in range(12):
        for size in (4, 7):
            pslg = lattice_polygon(n, size, seed)
            mfs = optimum(pslg).mesh_mfs
            assert mfs is not None and oracle.exact(mfs.squared) == best_of_all(pslg), pslg


@pytest.mark.parametrize("name", ["hexagon", "comb 1", "midway 3", "star 5", "growth 9", "two-opt 9", "partition 9",
                                  "triangle with vertices on its sides", "grid 9", "spike room", "convex spike 1e-6"])
def test_the_best_mesh_of_named_polygons_is_the_best_of_all(name: str) -> None:
    mfs = optimum(families.ALL_SMALL[name]).mesh_mfs
    assert mfs is not None and oracle.exact(mfs.squared) == best_of_all(families.ALL_SMALL[name])


@pytest.mark.parametrize("name", ["comb 5", "collinear vertices", "curved spiral", "grid 24", "partition 24",
                                  "rectangular spiral", "star 12", "two-opt 24"])
def test_visible_pairs(name: str) -> None:
    pslg = families.ALL_SMALL[name]
    visible = visible_pairs(list(pslg.vertices))
    sides = admissible(pslg)
    for i, j in combinations(range(len(pslg.vertices)), 2):
        assert visible[i, j] == visible[j, i] == ((i, j) in sides)


@pytest.mark.parametrize("r", [4, 10, 1000, 10**6])
def test_the_rectangle_with_two_midway_vertices(r: int) -> None:
    # CLAIMS C05: every classic mesh degrades by sqrt(((r + 1) / 2)^2 + 1), exactly.
    degradation = optimum(families.rectangle_with_two_midway_vertices(r)).degradation_squared
    assert degradation == mpq(r + 1, 2) ** 2 + 1


def test_regular_polygons_degrade_linearly() -> None:
    values = [optimum(families.regular_polygon(n)).degradation_squared for n in (8, 16, 32, 64)]
    roots = [float(value) ** 0.5 for value in values if value is not None]
    assert all(1.8 < after / before < 2.2 for before, after in pairwise(roots))


@pytest.mark.parametrize("side", [-1, 1])
def test_heights_that_are_equal_when_rounded_are_told_apart(side: int) -> None:
    nudge = mpq(side, 10**40)
    pslg = families.ring([(0, 0), (1, nudge), (1, 1), (0, 1)])
    mfs = optimum(pslg).mesh_mfs
    assert mfs is not None and oracle.exact(mfs.squared) == best_of_all(pslg)
    faces = optimal_classic_mesh(domain_of(pslg)).faces
    assert ((0, 1, 2) in faces) == (side < 0)


def test_the_numbering_and_the_scale_do_not_matter() -> None:
    pslg = families.random_simple_polygon(30, 4, "partition")
    wanted = optimum(pslg).degradation_squared
    for other in (families.reversed_orientation(pslg), families.with_start(pslg, 11), families.mirrored(pslg),
                  families.scaled(pslg, Fraction(1, 10**200)), families.scaled(pslg, 10**200),
                  families.rotated(pslg, Fraction(2, 9))):
        assert optimum(other).degradation_squared == wanted


def test_a_triangle_and_what_lies_outside() -> None:
    triangle = families.ALL_SMALL["triangle"]
    assert optimal_classic_mesh(domain_of(triangle)).faces == ((0, 1, 2),)
    beside = graph([(9, 9), (0, 0), (4, 0), (4, 4), (0, 4), (7, 7)], [(1, 2), (2, 3), (3, 4), (4, 1), (3, 5)])
    assert optimum(beside).faces == 2


def test_progress_is_told() -> None:
    steps: list[str] = []
    optimal_classic_mesh(domain_of(families.ALL_SMALL["comb 5"]), steps.append)
    assert steps == ["visibility", "diagonals"]


@pytest.mark.parametrize("pslg", [
    HALL, families.SMALL_PSLGS["two squares"], families.SMALL_PSLGS["map 1"],
    graph([*SQUARE, (2, 2)], RIM), graph([*SQUARE, (2, 2)], [*RIM, (0, 4)])])
def test_what_is_no_simple_polygon_is_refused(pslg: Pslg) -> None:
    with pytest.raises(InputError, match="for one simple polygon; this domain has"):
        optimal_classic_mesh(domain_of(pslg))


def test_too_many_vertices_are_refused() -> None:
    polygon = families.random_simple_polygon(MAX_OPTIMAL_VERTICES + 1, 1, "growth")
    with pytest.raises(InputError, match="at most 200 vertices, not 201"):
        optimal_classic_mesh(domain_of(polygon))
