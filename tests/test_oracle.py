"""The oracle against values computed by hand, against other programs, and against harmed meshes."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from math import isclose, sqrt
from typing import Any, TypeAlias

import families
import oracle
import pytest
import shapely
from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg

Points: TypeAlias = tuple[tuple[Any, Any], ...]
Faces: TypeAlias = tuple[tuple[int, ...], ...]

SQUARE = ((0, 0), (4, 0), (4, 4), (0, 4))


def cycle(n: int, first: int = 0) -> list[tuple[int, int]]:
    return [(first + i, first + (i + 1) % n) for i in range(n)]


@dataclass(frozen=True)
class Case:
    """An input and a mesh of it, as `oracle.check_mesh` takes them."""

    points: Points
    edges: list[tuple[int, int]]
    mesh_points: Points
    faces: Faces
    kind: str
    holes: Points = ()

    def violations(self) -> list[str]:
        return oracle.check_mesh(self.points, self.edges, self.holes, self.mesh_points, self.faces, self.kind)

    def degradation_squared(self) -> Fraction | None:
        return oracle.degradation_squared(self.points, self.edges, self.mesh_points, self.faces)


def midway(r: int) -> Points:
    return tuple((p.x, p.y) for p in families.rectangle_with_two_midway_vertices(r).vertices)


RING = ((0, 0), (6, 0), (6, 6), (0, 6), (2, 2), (4, 2), (4, 4), (2, 4))
RING_FACES = ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 6, 5), (2, 3, 6), (3, 7, 6), (3, 0, 7), (0, 4, 7))
INNER_FACES = ((4, 5, 6), (4, 6, 7))
# A dangling edge from a corner, an isolated point, and a dangling edge and a point in the unbounded face.
MIXED = (*SQUARE, (1, 1), (2, 3), (9, 9), (5, 5))
MIXED_EDGES = [*cycle(4), (0, 4), (2, 7)]

MESHES: dict[str, tuple[Case, Fraction]] = {
    "square, classic": (
        Case(SQUARE, cycle(4), SQUARE, ((0, 1, 2), (0, 2, 3)), "classic"), Fraction(2)),
    "square with its centre": (
        Case(SQUARE, cycle(4), (*SQUARE, (2, 2)), ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)), "proper"),
        Fraction(4)),
    "square, centre on the side of a face": (
        Case(SQUARE, cycle(4), (*SQUARE, (2, 2)), ((0, 1, 2, 4), (0, 4, 3), (4, 2, 3)), "nonproper"),
        Fraction(4)),
    "square, Steiner point on its boundary": (
        Case(SQUARE, cycle(4), (*SQUARE, (2, 0)), ((0, 4, 3), (4, 1, 2), (4, 2, 3)), "internal"),
        # The corner (0, 0) is 8/sqrt(20) from the edge (2, 0), (0, 4).
        Fraction(5)),
    "triangle": (Case(SQUARE[:3], cycle(3), SQUARE[:3], ((0, 1, 2),), "classic"), Fraction(1)),
    "midway 3": (
        Case(midway(3), cycle(6), midway(3), ((0, 1, 5), (1, 2, 5), (2, 4, 5), (2, 3, 4)), "classic"),
        Fraction(5)),
    "midway 9": (
        Case(midway(9), cycle(6), midway(9), ((0, 1, 5), (1, 2, 5), (2, 4, 5), (2, 3, 4)), "classic"),
        # ((r + 1)/2)^2 + 1 at r = 9.
        Fraction(26)),
    "square with a hole": (
        Case(RING, [*cycle(4), *cycle(4, 4)], RING, RING_FACES, "classic", ((3, 3),)),
        # The inner corner (4, 2) is 4/sqrt(20) from the edge (6, 0), (2, 2).
        Fraction(5)),
    "square in a square": (
        Case(RING, [*cycle(4), *cycle(4, 4)], RING, RING_FACES + INNER_FACES, "classic"), Fraction(5)),
    "mixed": (
        Case(MIXED, MIXED_EDGES, MIXED, ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 3, 5), (3, 4, 5), (3, 0, 4)),
             "classic"),
        # Both have mfs 1, of (1, 1) and the lower side.
        Fraction(1)),
}


@pytest.mark.parametrize("name", MESHES)
def test_sound_meshes_and_their_degradation(name: str) -> None:
    case, value = MESHES[name]
    assert case.violations() == []
    assert case.degradation_squared() == value


CENTRE = MESHES["square with its centre"][0]
SIDE = MESHES["square, centre on the side of a face"][0]
CLASSIC = MESHES["square, classic"][0]
HOLE = MESHES["square with a hole"][0]
FILLED = MESHES["square in a square"][0]
MIXED_CASE = MESHES["mixed"][0]
SPLIT = MESHES["square, Steiner point on its boundary"][0]
# A triangle with a vertex on each of two sides, and an edge between these.
CUT = ((0, 0), (4, 0), (0, 4), (2, 0), (0, 2))
CUT_EDGES = [(0, 3), (3, 1), (1, 2), (2, 4), (4, 0), (3, 4)]

HARMED: dict[str, tuple[Case, str]] = {
    "unknown kind": (replace(CLASSIC, kind="best"), "unknown kind"),
    "vertex missing": (
        replace(CLASSIC, mesh_points=SQUARE[:3], faces=((0, 1, 2),)), "fewer than the input's"),
    "vertex moved": (replace(CENTRE, mesh_points=((0, "1e-30"), *CENTRE.mesh_points[1:])), "has moved"),
    "vertices exchanged": (replace(CLASSIC, mesh_points=(SQUARE[1], SQUARE[0], *SQUARE[2:])), "has moved"),
    "index out of range": (replace(CENTRE, faces=((0, 1, 5), *CENTRE.faces[1:])), "out of range"),
    "negative index": (replace(CENTRE, faces=((0, 1, -1), *CENTRE.faces[1:])), "out of range"),
    "face of two": (replace(CLASSIC, faces=(*CLASSIC.faces, (0, 1))), "not a cycle"),
    "vertex twice in a face": (replace(CLASSIC, faces=(*CLASSIC.faces, (0, 1, 1))), "not a cycle"),
    "coincident vertices": (replace(CENTRE, mesh_points=(*CENTRE.mesh_points, (2, 2))), "coincide"),
    "clockwise face": (
        replace(CENTRE, faces=((4, 1, 0), *CENTRE.faces[1:])), "not a counter-clockwise triangle"),
    "quadrilateral face": (
        replace(CLASSIC, kind="nonproper", faces=((0, 1, 2, 3),)), "not a counter-clockwise triangle"),
    "flat face": (replace(SIDE, faces=(*SIDE.faces, (0, 4, 2))), "not a counter-clockwise triangle"),
    "side run back and forth": (
        Case(SQUARE, cycle(4), (*SQUARE, (2, 2), (3, 3)), ((0, 1, 2, 4, 5),), "nonproper"),
        "not a counter-clockwise triangle"),
    "bow of five": (
        Case(SQUARE, cycle(4), (*SQUARE, (2, 5)), ((0, 2, 4, 1, 3),), "nonproper"),
        "not a counter-clockwise triangle"),
    "nonproper face in a proper mesh": (replace(SIDE, kind="proper"), "has 4 vertices, not 3"),
    "nonproper face in an internal mesh": (replace(SIDE, kind="internal"), "has 4 vertices, not 3"),
    "Steiner vertex in a classic mesh": (replace(CENTRE, kind="classic"), "no Steiner vertices"),
    "vertex inside a face": (
        replace(CLASSIC, kind="proper", mesh_points=(*SQUARE, (3, 1))), "lies inside face 0"),
    "T-vertex left out": (replace(SIDE, faces=((0, 1, 2), *SIDE.faces[1:])), "which leaves it out"),
    "isolated input point left out": (
        replace(MIXED_CASE, faces=((0, 1, 4), (1, 2, 3), (1, 3, 4), (3, 0, 4))), "vertex 5 lies inside face"),
    "face twice": (replace(CENTRE, faces=(*CENTRE.faces, CENTRE.faces[0])), "has 2 faces on one side"),
    "both diagonals": (replace(CLASSIC, faces=(*CLASSIC.faces, (1, 2, 3))), "more than an end in common"),
    "diagonals cross without a vertex": (
        replace(CLASSIC, faces=((0, 1, 2), (1, 2, 3))), "more than an end in common"),
    "overlapping faces": (replace(CLASSIC, faces=((0, 1, 2), (1, 2, 3))), "overlap"),
    "vertex on the boundary": (replace(SPLIT, kind="proper"), "interior of input edge 0"),
    "input edge across an edge": (
        replace(CLASSIC, edges=[*cycle(4), (1, 3)]), "more than an end in common"),
    "input edge inside a face": (
        Case(CUT, CUT_EDGES, CUT, ((0, 3, 1, 2, 4),), "nonproper"),
        "is no side of a face but runs through face 0"),
    "face missing": (replace(CENTRE, faces=CENTRE.faces[1:]), "the faces have area 12, the domain has 16"),
    "no faces": (replace(CLASSIC, faces=()), "the faces have area 0, the domain has 16"),
    "hole filled": (replace(FILLED, holes=((3, 3),)), "does not lie in the domain"),
    "hole not filled": (replace(HOLE, holes=()), "the faces have area 32, the domain has 36"),
    "face outside": (
        replace(MIXED_CASE, faces=(*MIXED_CASE.faces, (2, 6, 7)), points=(*MIXED[:6], (9, 3), MIXED[7]),
                mesh_points=(*MIXED[:6], (9, 3), MIXED[7])), "does not lie in the domain"),
    "the hole filled instead of a face": (
        replace(FILLED, holes=((3, 3),), faces=RING_FACES[2:] + INNER_FACES), "does not lie in the domain"),
    "unused Steiner vertex": (
        replace(CLASSIC, kind="proper", mesh_points=(*SQUARE, (7, 7))), "Steiner vertex 4 is in no face"),
}


@pytest.mark.parametrize("name", HARMED)
def test_harmed_meshes_are_refused(name: str) -> None:
    case, reason = HARMED[name]
    assert any(reason in violation for violation in case.violations()), case.violations()


def test_every_mesh_is_refused_without_any_one_of_its_faces() -> None:
    for case, _ in MESHES.values():
        for i in range(len(case.faces)):
            assert replace(case, faces=case.faces[:i] + case.faces[i + 1 :]).violations()


def test_faces_may_start_anywhere_and_come_in_any_order() -> None:
    for case, _ in MESHES.values():
        turned = tuple(face[1:] + face[:1] for face in reversed(case.faces))
        assert replace(case, faces=turned).violations() == []


# --- minimum feature size ---


@pytest.mark.parametrize(("points", "edges", "value"), [
    (((0, 0),), [], None),
    (((0, 0), (3, 4)), [], 25),
    (((0, 0), (3, 4)), [(0, 1)], 25),
    (((0, 0), (4, 0), (2, 1)), [(0, 1)], 1),
    (((0, 0), (4, 0), (5, 1)), [(0, 1)], 2),
    (((0, 0), (4, 0), (0, 3)), cycle(3), Fraction(144, 25)),
    ((("1/3", "0.5"), ("1/3", "1/2000"), ("7/3", "0.25")), [(0, 1)], Fraction(999, 2000) ** 2),
    (((0, 0), (4, 4), (1, 0)), [(0, 1)], Fraction(1, 2)),
    (SQUARE, cycle(4), 16),
])
def test_mfs_by_hand(points: Points, edges: list[tuple[int, int]], value: Fraction | None) -> None:
    assert oracle.mfs_squared(points, edges) == value


def test_mfs_is_what_other_programs_call_minimum_clearance() -> None:
    for name in ("square", "comb 5", "spike room", "l-shape 44", "star 5", "curved spiral", "two-opt 24",
                 "grid 50", "growth 50", "partition 24"):
        pslg = families.ALL_SMALL[name]
        shape = shapely.Polygon([(float(p.x), float(p.y)) for p in pslg.vertices])
        exact = oracle.mfs_squared(pslg.vertices, pslg.edges)
        assert exact is not None and isclose(sqrt(exact), shapely.minimum_clearance(shape), rel_tol=1e-9)


# --- the domain ---


def test_domain_area_by_hand() -> None:
    rings = [*cycle(4), *cycle(4, 4)]
    assert oracle.domain_area(SQUARE, cycle(4)) == 16
    assert oracle.domain_area(SQUARE, cycle(4)[:3]) == 0
    assert oracle.domain_area(RING, rings) == 36
    assert oracle.domain_area(RING, rings, [(3, 3)]) == 32
    assert oracle.domain_area(RING, rings, [(1, 2)]) == 4
    assert oracle.domain_area(RING, rings, [(1, 1), (3, 3)]) == 0
    assert oracle.domain_area(MIXED, MIXED_EDGES) == 16
    # A wall from side to side makes two faces, a wall with a gap makes one.
    walls = (*SQUARE, (0, 2), (4, 2), (3, 2))
    frame = [(0, 1), (1, 5), (5, 2), (2, 3), (3, 4), (4, 0)]
    assert oracle.domain_area(walls[:6], [*frame, (4, 5)], [(1, 1)]) == 8
    assert oracle.domain_area(walls, [*frame, (4, 6)], [(1, 1)]) == 0


@pytest.mark.parametrize("hole", [(0, 0), (2, 0), (5, 5), (5, 0), (2, 4), (-1, 2)])
def test_hole_points_outside_and_on_edges_are_refused(hole: tuple[int, int]) -> None:
    with pytest.raises(ValueError, match="does not lie in a bounded face"):
        oracle.domain_area(SQUARE, cycle(4), [hole])


@pytest.mark.parametrize("name", families.ALL_SMALL)
def test_domain_area_of_a_polygon_is_the_shoelace_formula(name: str) -> None:
    pslg = families.ALL_SMALL[name]
    area = oracle.domain_area(pslg.vertices, pslg.edges)
    assert area == abs(oracle.polygon_area(pslg.vertices)) > 0


@pytest.mark.parametrize("name", families.SMALL_PSLGS)
def test_domain_area_of_a_pslg_is_that_of_its_polygonized_faces(name: str) -> None:
    pslg = families.SMALL_PSLGS[name]
    at = [(float(p.x), float(p.y)) for p in pslg.vertices]
    lines = shapely.union_all([shapely.LineString([at[u], at[v]]) for u, v in pslg.edges])
    holes = [shapely.Point(float(p.x), float(p.y)) for p in pslg.holes]
    faces = [face for face in shapely.polygonize([lines]).geoms if not any(map(face.contains, holes))]
    area = oracle.domain_area(pslg.vertices, pslg.edges, pslg.holes)
    assert isclose(area, sum(face.area for face in faces), rel_tol=1e-9)


# --- meshes made by the simplest means ---


def ears(points: Points) -> Faces:
    """Return a classic triangulation: cut off any corner whose triangle contains no other vertex."""
    at = [oracle.triple(p) for p in points]
    left = list(range(len(at)))
    if oracle.polygon_area(points) < 0:
        left.reverse()
    faces = []
    while len(left) > 3:
        a, b, c = next(found for found in zip(left, left[1:] + left[:1], left[2:] + left[:2], strict=True)
                       if is_ear(at, left, found))
        faces.append((a, b, c))
        left.remove(b)
    return (*faces, tuple(left))


def is_ear(at: list[oracle.Triple], left: list[int], corner: tuple[int, int, int]) -> bool:
    a, b, c = (at[v] for v in corner)
    return oracle.turn(a, b, c) > 0 and not any(
        min(oracle.turn(a, b, at[v]), oracle.turn(b, c, at[v]), oracle.turn(c, a, at[v])) >= 0
        for v in left if v not in corner)


def with_centroids(case: Case) -> Case:
    """Return the mesh with every triangle cut into three."""
    points = list(case.mesh_points)
    faces = []
    for a, b, c in case.faces:
        corners = [oracle.place(case.mesh_points[v]) for v in (a, b, c)]
        faces += [(a, b, len(points)), (b, c, len(points)), (c, a, len(points))]
        points.append((sum(p[0] for p in corners) / 3, sum(p[1] for p in corners) / 3))
    return replace(case, mesh_points=tuple(points), faces=tuple(faces), kind="proper")


def classic(name: str) -> Case:
    pslg = families.ALL_SMALL[name]
    points = tuple((p.x, p.y) for p in pslg.vertices)
    return Case(points, list(pslg.edges), points, ears(points), "classic")


@pytest.mark.parametrize("name", families.ALL_SMALL)
def test_ear_clippings_are_accepted_and_their_centroids_too(name: str) -> None:
    case = classic(name)
    assert case.violations() == []
    degradation = case.degradation_squared()
    assert degradation is not None and degradation >= 1
    assert with_centroids(case).violations() == []


def test_classic_meshes_of_regular_polygons_degrade_as_proved() -> None:
    # mfs of the square is its side, sqrt(2); that of its mesh is a height, 1.
    assert classic("square").degradation_squared() == 2
    for name, n in (("13-gon", 13), ("40-gon", 40)):
        degradation = classic(name).degradation_squared()
        # At least 1/sin(pi/n) for the regular polygon; these points are near it.
        assert degradation is not None and sqrt(degradation) > 0.9 * n / 3.1416


def test_a_mesh_of_hundreds_of_faces() -> None:
    case = with_centroids(with_centroids(classic("growth 50")))
    assert len(case.faces) == 9 * 48 and case.violations() == []
    assert replace(case, faces=case.faces[:-1]).violations()


@pytest.mark.parametrize("move", [
    lambda p: families.rotated(p, Fraction(1, 3)), lambda p: families.scaled(p, Fraction(1, 10**30)),
    lambda p: families.translated(p, 10**30, Fraction(-1, 3))])
def test_moving_and_scaling_change_no_answer(move: Callable[[Pslg], Pslg]) -> None:
    def moved(points: Points) -> Points:
        vertices = tuple(Point(mpq(x), mpq(y)) for x, y in points)
        return tuple((p.x, p.y) for p in move(Pslg(vertices, ())).vertices)

    for case, value in MESHES.values():
        changed = replace(case, points=moved(case.points), mesh_points=moved(case.mesh_points),
                          holes=moved(case.holes))
        assert changed.violations() == [] and changed.degradation_squared() == value


# --- files ---


def test_reads_the_exchange_formats() -> None:
    pslg = ('{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["7/2", 0], ["0.5", "1e1"]],'
            ' "edges": [[0, 1], [1, 2], [2, 0]], "holes": [["1", "1"]]}')
    half = Fraction(1, 2)
    points: list[Any] = [(0, 0), (7 * half, 0), (half, 10)]
    holes: list[Any] = [(1, 1)]
    assert oracle.read_pslg(pslg) == (points, cycle(3), holes)
    mesh = ('{"format": "exactmesh-mesh/1", "kind": "classic", "vertices": [["0", "0"], ["7/2", "0"],'
            ' ["1/2", "10"]], "faces": [[0, 1, 2]]}')
    assert oracle.read_mesh(mesh) == (points, [(0, 1, 2)], "classic")
    with pytest.raises(ValueError, match="not a mesh"):
        oracle.read_mesh(pslg)
    with pytest.raises(ValueError, match="not a PSLG"):
        oracle.read_pslg(mesh)


def test_the_oracle_imports_the_standard_library_only() -> None:
    with open(oracle.__file__, encoding="utf-8") as source:
        lines = [line.split() for line in source if line.startswith(("import ", "from "))]
    assert {line[1].split(".")[0] for line in lines} == {
        "json", "bisect", "collections", "fractions", "itertools", "typing"}
