"""The constrained Delaunay triangulation: valid, locally and globally Delaunay, the same from any start."""

import constructions
import families
import oracle
import pytest
from gmpy2 import mpq

from exactmesh.geometry.incircle import in_circle
from exactmesh.geometry.point import Point
from exactmesh.measure.validity import verify_mesh
from exactmesh.planar import delaunay
from exactmesh.planar.delaunay import constrained_delaunay, delaunay_from, flipped, main_axis
from exactmesh.planar.faces import domain_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.triangulation import Triangulation, triangulate

INPUTS = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": constructions.HALL}


def sides_off_circles(points: tuple[Point, ...], found: Triangulation) -> set[Edge]:
    """Return the sides that are constrained or strictly locally Delaunay; assert that no other is not Delaunay."""
    sides = set()
    for (u, v), w in found.apex.items():
        if (u, v) in found.constrained:
            sides.add((min(u, v), max(u, v)))
        else:
            sign = in_circle(points[u], points[v], points[w], points[found.apex[v, u]])
            assert sign <= 0
            if sign < 0:
                sides.add((min(u, v), max(u, v)))
    return sides


@pytest.mark.parametrize("name", INPUTS)
def test_valid_locally_delaunay_and_unique_but_for_four_on_a_circle(name: str) -> None:
    pslg = INPUTS[name]
    subdivision = domain_of(pslg)
    found = constrained_delaunay(subdivision)
    verification = verify_mesh(subdivision, Mesh("classic", pslg.vertices, found.triangles))
    assert verification.valid, verification.violations
    sides = sides_off_circles(pslg.vertices, found)
    for along in ((1, 0), (0, 1), (-2, 5)):
        other = delaunay_from(pslg.vertices, triangulate(subdivision, along))
        assert sides_off_circles(pslg.vertices, other) == sides
        assert other.constrained == found.constrained


@pytest.mark.parametrize("name", [*families.SMALL_PSLGS, "growth 24", "star 12", "unit square", "40-gon"])
def test_the_oracle_finds_nothing_wrong(name: str) -> None:
    pslg = INPUTS[name]
    faces = constrained_delaunay(domain_of(pslg)).triangles
    assert oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, pslg.vertices, faces, "classic") == []


@pytest.mark.parametrize("seed", range(200, 230))
def test_random_pslgs(seed: int) -> None:
    for pslg in (families.random_pslg(seed, 3), families.grid_map(6, 6, seed)):
        subdivision = domain_of(pslg)
        found = constrained_delaunay(subdivision)
        assert verify_mesh(subdivision, Mesh("classic", pslg.vertices, found.triangles)).valid
        sides_off_circles(pslg.vertices, found)


def test_circles_of_points_without_obstacles_are_empty() -> None:
    square = families.ring([(-9, -9), (40, -10), (41, 40), (-8, 37)])
    inside = [Point(mpq(i * i % 31), mpq(i * 7 % 29)) for i in range(25)]
    pslg = Pslg((*square.vertices, *dict.fromkeys(inside)), square.edges)
    found = constrained_delaunay(domain_of(pslg))
    points = pslg.vertices
    for u, v, w in found.triangles:
        assert all(in_circle(points[u], points[v], points[w], p) <= 0 for p in points)


def test_constrained_sides_stay() -> None:
    flat = families.ring([(0, 0), (10, -1), (20, 0), (10, 1)])
    assert constrained_delaunay(domain_of(flat)).triangles == ((0, 1, 3), (1, 2, 3))
    cut = Pslg(flat.vertices, (*flat.edges, (0, 2)))
    assert constrained_delaunay(domain_of(cut)).triangles == ((0, 1, 2), (0, 2, 3))


def test_four_points_on_a_circle_keep_their_diagonal() -> None:
    square = families.ALL_SMALL["unit square"]
    for triangles in (((0, 1, 2), (0, 2, 3)), ((0, 1, 3), (1, 2, 3))):
        start = triangulate(domain_of(square))
        apex = {(t[i], t[i - 2]): t[i - 1] for t in triangles for i in range(3)}
        assert delaunay_from(square.vertices, Triangulation(triangles, start.constrained, apex)).triangles == triangles


def test_a_limit_on_flips() -> None:
    polygon = families.rotated(families.random_simple_polygon(50, 3, "growth"), 1)
    start = triangulate(domain_of(polygon))
    assert flipped(polygon.vertices, start, 0) is None
    done = flipped(polygon.vertices, start)
    assert done is not None and flipped(polygon.vertices, done, 0) == done
    assert flipped(polygon.vertices, start, 10**6) == done


def test_other_directions_are_tried_and_the_last_is_finished(monkeypatch: pytest.MonkeyPatch) -> None:
    polygon = families.random_simple_polygon(60, 3, "growth")
    subdivision = domain_of(polygon)
    wanted = constrained_delaunay(subdivision)
    tried = []

    def noted(points: object, start: Triangulation, limit: int | None = None) -> Triangulation | None:
        tried.append(limit)
        return flipped(polygon.vertices, start, limit)

    monkeypatch.setattr(delaunay, "_MANY", 0)
    monkeypatch.setattr(delaunay, "flipped", noted)
    assert constrained_delaunay(subdivision) == wanted
    assert tried == [0, 0, 0, None]


def test_long_convex_polygons_take_few_flips() -> None:
    tall = families.ring([(x, x * x - 300**2) for x in range(-300, 300)]
                         + [(x, 300**2 - x * x) for x in range(300, -300, -1)])
    start = triangulate(domain_of(tall), main_axis(tall.vertices))
    assert flipped(tall.vertices, start, 2 * len(start.apex)) is not None
    assert flipped(tall.vertices, triangulate(domain_of(tall)), 2 * len(start.apex)) is None


@pytest.mark.parametrize(("corners", "along"), [
    ([(0, 0), (100, 0), (100, 1), (0, 1)], (64, 0)), ([(0, 0), (1, 0), (1, 100), (0, 100)], (0, 64)),
    ([(0, 0), (100, 99), (100, 101), (1, 3)], (45, 45))])
def test_the_main_axis(corners: list[tuple[int, int]], along: tuple[int, int]) -> None:
    assert main_axis(families.ring(corners).vertices) == along


def test_the_main_axis_of_next_to_nothing() -> None:
    assert main_axis(()) == (1, 0) and main_axis((Point(mpq(1), mpq(2)),)) == (1, 0)
    assert main_axis(families.ALL_SMALL["unit square"].vertices) != (0, 0)
