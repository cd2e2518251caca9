"""Triangulation by a sweep: valid for every domain, in every direction, by two independent judges."""

from fractions import Fraction

import constructions
import families
import oracle
import pytest
from constructions import graph

from exactmesh.geometry.predicates import orientation
from exactmesh.measure.validity import verify_mesh
from exactmesh.planar.faces import domain_of, subdivide
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.planar.triangulation import Triangulation, triangulate, triangulation_of

INPUTS = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": constructions.HALL}
SQUARE = [(0, 0), (6, 0), (6, 6), (0, 6)]
RIM = [(0, 1), (1, 2), (2, 3), (3, 0)]
DIRECTIONS = ((1, 0), (0, 1), (-1, 0), (5, 2), (-3, -7))


def judged(pslg: Pslg, found: Triangulation) -> None:
    """Assert that the triangles are a classic mesh, and that the record agrees with itself."""
    subdivision = domain_of(pslg)
    verification = verify_mesh(subdivision, Mesh("classic", pslg.vertices, found.triangles))
    assert verification.valid, verification.violations
    assert triangulation_of(found.triangles, found.constrained) == found
    half_edges = subdivision.half_edges
    along = {(half_edges.origin[h], half_edges.target(h))
             for face in subdivision.domain for walk in face.walks for h in walk}
    assert found.constrained == along | {(v, u) for u, v in along}
    assert {side for side in found.apex if side[::-1] not in found.apex} <= along
    assert all(u < v and u < w for u, v, w in found.triangles) and list(found.triangles) == sorted(found.triangles)


@pytest.mark.parametrize("name", INPUTS)
def test_every_small_input_in_every_direction(name: str) -> None:
    subdivision = domain_of(INPUTS[name])
    for along in DIRECTIONS:
        judged(INPUTS[name], triangulate(subdivision, along))


@pytest.mark.parametrize("name", [*families.SMALL_PSLGS, "hall", "comb 8 doubling", "curved spiral",
                                  "collinear vertices", "reflex notch 1e-6", "partition 24"])
def test_the_oracle_finds_nothing_wrong(name: str) -> None:
    pslg = INPUTS[name]
    faces = triangulate(domain_of(pslg)).triangles
    assert oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, pslg.vertices, faces, "classic") == []


@pytest.mark.parametrize("seed", range(100, 160))
def test_random_pslgs(seed: int) -> None:
    for pslg in (families.random_pslg(seed, 3), families.grid_map(5, 5, seed, Fraction(seed % 4, 4))):
        judged(pslg, triangulate(domain_of(pslg)))


HARD = {
    "isolated vertices, some in a column": graph([*SQUARE, (3, 3), (3, 4), (3, 1), (2, 3), (5, 5)], RIM),
    "a vertical dangling edge, from below": graph([*SQUARE, (3, 4)], [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4)]),
    "a floating vertical edge": graph([*SQUARE, (3, 2), (3, 4)], [*RIM, (4, 5)]),
    "a star of edges to all sides": graph(
        [*SQUARE, (3, 3), (4, 3), (4, 4), (3, 4), (2, 4), (2, 3), (2, 2), (3, 2), (4, 2)],
        [*RIM, *((4, i) for i in range(5, 13))]),
    "a chain of collinear vertices": graph([*SQUARE, (1, 1), (2, 2), (3, 3), (4, 4)], [*RIM, (4, 5), (6, 7)]),
    "collinear with corners": graph([*SQUARE, (2, 2), (4, 4), (4, 2)], [*RIM, (0, 4), (4, 5), (5, 2)]),
    "faces that share a vertex": graph([(0, 0), (2, -1), (2, 1), (-2, 1), (-2, -1)],
                                       [(0, 1), (1, 2), (2, 0), (0, 3), (3, 4), (4, 0)]),
    "a face inside that touches the rim": graph([*SQUARE, (3, 1), (3, 3)], [*RIM, (0, 4), (4, 5), (5, 0)]),
    "a comb of dangling edges from above and below": graph(
        [*SQUARE, (1, 4), (5, 4), (1, 2), (2, 1), (3, 5)], [*RIM, (3, 4), (2, 5), (0, 6), (1, 7), (2, 8)]),
}


@pytest.mark.parametrize("name", HARD)
def test_hard_cases(name: str) -> None:
    pslg = HARD[name]
    for along in DIRECTIONS:
        found = triangulate(domain_of(pslg), along)
        judged(pslg, found)
        assert oracle.check_mesh(pslg.vertices, pslg.edges, [], pslg.vertices, found.triangles, "classic") == []


def test_points_of_a_lattice_in_a_triangle_in_all_directions() -> None:
    inside = [(x, y) for x in range(1, 6) for y in range(1, 6) if x + y < 8]
    pslg = graph([(0, 0), (8, 0), (0, 8), *inside], [(0, 1), (1, 2), (2, 0)])
    for x in range(-3, 4):
        for y in range(-3, 4):
            if (x, y) != (0, 0):
                judged(pslg, triangulate(domain_of(pslg), (x, y)))


def test_what_lies_in_a_hole_or_outside_is_left_alone() -> None:
    pslg = graph([(0, 0), (9, 0), (0, 9), (2, 2), (4, 2), (2, 4), (20, 1), (30, 2), (15, 15)],
                 [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (6, 7)])
    pslg = Pslg((*pslg.vertices, constructions.point(3, "5/2")), pslg.edges, (constructions.point("5/2", "5/2"),))
    found = triangulate(domain_of(pslg))
    judged(pslg, found)
    assert {v for triangle in found.triangles for v in triangle} == set(range(6))
    assert (6, 7) not in found.constrained


def test_without_a_domain_there_are_no_triangles() -> None:
    found = triangulate(subdivide(graph([(0, 0), (1, 0), (2, 5), (7, 7)], [(0, 1), (1, 2)])))
    assert found == Triangulation((), frozenset(), {})


def test_apex_leads_across_a_shared_edge() -> None:
    pslg = graph([(0, 0), (4, 0), (4, 4), (0, 4)], [*RIM, (0, 2)])
    found = triangulate(domain_of(pslg))
    assert found.triangles == ((0, 1, 2), (0, 2, 3))
    assert (found.apex[0, 2], found.apex[2, 0]) == (3, 1) and (0, 2) in found.constrained


def test_a_polygon_of_three_thousand_vertices_has_all_its_triangles() -> None:
    for kind in families.KINDS.keys() - {"two-opt"}:
        polygon = families.random_simple_polygon(3000, 5, kind)
        triangles = triangulate(domain_of(polygon)).triangles
        assert len(triangles) == 2998
        assert all(orientation(*(polygon.vertices[v] for v in triangle)) == 1 for triangle in triangles)
