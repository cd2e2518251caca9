"""All faces at once against one face after the other, at any scale; and how much is left to exact arithmetic."""

import random
from collections.abc import Callable

import families
import numpy as np
import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry import fixed_point
from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.fixed_point import FixedPoints
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.measure import mesh_faces as module
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.mesh_faces import MeshFaces
from exactmesh.numbers.rational import sqrt_below
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


def triples(seed: int, spread: mpq) -> list[Point]:
    """Return three points at a time: anywhere, nearly in line, or all near to each other, down to and below a unit."""
    source = random.Random(seed)

    def anywhere() -> Point:
        return Point(mpq(source.randint(-3000, 3000), 3) * spread, mpq(source.randint(-3000, 3000), 7) * spread)

    found = []
    for _ in range(150):
        a, b = anywhere(), anywhere()
        share, hair = mpq(source.randint(-100, 600), 500), spread / mpq(10) ** source.randint(0, 33)
        beside = Point(a.x + share * (b.x - a.x) + hair * source.randint(-9, 9) / 3,
                       a.y + share * (b.y - a.y) + hair * source.randint(1, 9) / 3)
        near = Point(a.x + hair, a.y - hair / 3)
        found += [a, b, anywhere(), a, b, beside, a, near, Point(a.x - hair / 7, a.y + hair)]
    return found


def assert_enclosed(low: float, high: float, squared: mpq, unit: mpq) -> None:
    assert low <= 0 or mpq(low) ** 2 * unit**2 <= squared
    assert high == np.inf or (high >= 0 and squared <= mpq(high) ** 2 * unit**2)


@pytest.mark.parametrize(("seed", "spread"), [(1, mpq(1)), (2, mpq(10) ** 40), (3, mpq(21, 10**30)), (4, mpq(21))])
def test_bounds_of_heights_and_distances_contain_them_and_are_narrow(seed: int, spread: mpq) -> None:
    points = triples(seed, spread)
    if spread == 21:  # whole numbers: nothing is rounded down
        points = [Point(mpq(int(p.x)), mpq(int(p.y))) for p in points]
    columns = FixedPoints(points)
    assert bool(columns.error) == (spread != 21)
    rows = np.arange(len(points)).reshape(-1, 3)
    faces = MeshFaces(columns, [tuple(row) for row in rows.tolist()])
    height_low, height_high = faces._heights(rows)
    near, far = faces._distances(rows[:, 2], rows[:, 0], rows[:, 1])
    wide, infinite = 0, 0
    for number, (i, j, k) in enumerate(rows.tolist()):
        a, b, c = points[i], points[j], points[k]
        if a in (b, c) or b == c:
            continue
        longest = max(distance_squared(a, b), distance_squared(b, c), distance_squared(c, a))
        assert_enclosed(height_low[number], height_high[number], doubled_area(a, b, c) ** 2 / longest, columns.unit)
        squared = segment_distance_squared(c, a, b)
        assert_enclosed(near[number], far[number], squared, columns.unit)
        length = float(sqrt_below(longest / columns.unit**2, 4))
        assert far[number] - near[number] <= 2.0**-44 * length + 40 * columns.error
        if length > 1000:
            assert height_high[number] - height_low[number] <= 2.0**-44 * length + 60 * columns.error
            wide += 1
        infinite += height_high[number] == np.inf
    assert wide >= 300 and (infinite > 0) == bool(columns.error)


# Points in a square of this side have units of 512, and what is left of one is rounded away.
SIDE, UNIT = 2**110, 512


def triples_in_units(seed: int) -> list[Point]:
    """Return three points at a time that are a few units from each other, one maybe far away along an axis."""
    source = random.Random(seed)
    found = []
    for number in range(800):
        few = source.choice((3, 8, 40))
        places = [[source.randint(0, few), source.randint(0, few)] for _ in range(3)]
        if number % 2:
            places[0][source.randint(0, 1)] += 2 ** source.choice((10, 60, 95))
        source.shuffle(places)
        found += [Point(*(mpq(UNIT * place + source.choice((0, 1, UNIT - 1))) for place in pair)) for pair in places]
    return found


def test_bounds_of_few_units_contain_what_they_bound_and_are_those_stated() -> None:
    points = [*triples_in_units(7), Point(mpq(0), mpq(0)), Point(mpq(SIDE), mpq(SIDE)), Point(mpq(0), mpq(SIDE))]
    columns = FixedPoints(points)
    assert (columns.unit, columns.error) == (UNIT, 1)
    rows = np.arange(len(points)).reshape(-1, 3)
    faces = MeshFaces(columns, [tuple(row) for row in rows.tolist()])
    with np.errstate(all="raise"):
        height_low, height_high = faces._heights(rows)
        near, far = faces._distances(rows[:, 2], rows[:, 0], rows[:, 1])
    slack = 1 + mpq(1, 2**44)
    finite = positive = edges = 0
    for number, (i, j, k) in enumerate(rows.tolist()):
        a, b, c = points[i], points[j], points[k]
        ab, ac, bc = (tuple(mpq(part[0]) for part in columns.differences(np.array([u]), np.array([v])))
                      for u, v in ((i, j), (i, k), (j, k)))
        if a != b and b != c and c != a:
            longest = max(distance_squared(a, b), distance_squared(b, c), distance_squared(c, a))
            assert_enclosed(height_low[number], height_high[number], doubled_area(a, b, c) ** 2 / longest, UNIT)
            assert_enclosed(near[number], far[number], segment_distance_squared(c, a, b), UNIT)
        products = abs(ab[0] * ac[1]) + abs(ab[1] * ac[0])
        absolute = sum(map(abs, (*ab, *ac)))
        area, off = abs(ab[0] * ac[1] - ab[1] * ac[0]), products / 2**49 + 4 * absolute + 8
        longest = sqrt_below(max(x * x + y * y for x, y in (ab, ac, bc)), 60)
        if longest > 2:
            assert height_high[number] <= (area + off) / (longest - 2) * slack
            finite += 1
        else:
            assert height_high[number] == np.inf
            edges += longest == 2
        assert height_low[number] >= max(area - off, 0) / (longest + 2) * (2 - slack)
        positive += height_low[number] > 0
        assert far[number] - near[number] <= 2 * (sum(map(abs, (*ab, *ac))) / 2**48 + 8) * slack
    assert finite > 700 and positive > 100 and edges > 3


def test_bounds_of_small_whole_numbers_are_as_good_as_exact() -> None:
    points = [Point(mpq(x), mpq(y)) for x in range(4) for y in range(4)]
    columns = FixedPoints(points)
    rows = np.array([(i, j, k) for i in range(16) for j in range(16) for k in range(16) if len({i, j, k}) == 3])
    faces = MeshFaces(columns, [tuple(row) for row in rows.tolist()])
    with np.errstate(all="raise"):
        heights = faces._heights(np.arange(rows.size).reshape(-1, 3))
        distances = faces._distances(rows[:, 2], rows[:, 0], rows[:, 1])
    for number, (i, j, k) in enumerate(rows.tolist()):
        a, b, c = points[i], points[j], points[k]
        longest = max(distance_squared(a, b), distance_squared(b, c), distance_squared(c, a))
        for (low, high), squared in ((heights, doubled_area(a, b, c) ** 2 / longest),
                                     (distances, segment_distance_squared(c, a, b))):
            assert_enclosed(low[number], high[number], squared, mpq(1))
            assert high[number] - low[number] <= 2.0**-43


def test_t_vertices_a_few_units_apart_bound_the_feature_by_their_distance() -> None:
    corners = [(0, 0), (SIDE, 0), (0, SIDE)]
    pairs = [(far, distance, first, second, upright) for far in (2**60, 2**100) for distance in (1, 2, 3, 7)
             for first in (0, 1, UNIT - 1) for second in (0, 1, UNIT - 1) for upright in (False, True)]
    points = [Point(mpq(x), mpq(y)) for x, y in corners]
    cycles = []
    for far, distance, first, second, upright in pairs:
        ends = [UNIT * far + first, UNIT * (far + distance) + second]
        points += [Point(*map(mpq, (0, end) if upright else (end, 0))) for end in ends]
        u, v = len(points) - 2, len(points) - 1
        cycles.append((0, 1, 2, v, u) if upright else (0, u, v, 1, 2))
    columns = FixedPoints(points)
    assert (columns.unit, columns.error) == (UNIT, 1)
    faces = MeshFaces(columns, cycles)
    assert faces.not_triangles() == []
    low, high = np.full(len(cycles), np.inf), np.full(len(cycles), np.inf)
    faces._lower_by_t_vertices(low, high)
    for number, (_, distance, first, second, _) in enumerate(pairs):
        assert mpq(low[number]) <= distance + mpq(second - first, UNIT) <= mpq(high[number])
        assert high[number] - low[number] <= 4 + 2.0**-40
    feature = faces.least_feature()
    assert feature is not None and feature[0] == min(
        (UNIT * distance + second - first) ** 2 for _, distance, first, second, _ in pairs)


@pytest.mark.parametrize("move", MOVES)
@pytest.mark.parametrize("name", MESHES)
def test_bounds_of_faces_with_t_vertices_contain_their_features(name: str, move: str) -> None:
    mesh = MESHES[name]
    points = tuple(map(MOVES[move], mesh.vertices))
    columns = FixedPoints(points)
    faces = MeshFaces(columns, mesh.faces)
    low, high = np.full(len(mesh.faces), np.inf), np.full(len(mesh.faces), np.inf)
    faces._lower_by_t_vertices(low, high)
    for number, cycle in enumerate(mesh.faces):
        if len(cycle) == 3:
            assert low[number] == high[number] == np.inf
            continue
        corners = corners_of(points, cycle)
        assert not isinstance(corners, NotTriangle)
        assert_enclosed(low[number], high[number], face_feature_squared(points, cycle, corners), columns.unit)
        longest = max(distance_squared(points[u], points[v]) for u in cycle for v in cycle)
        length = float(sqrt_below(longest / columns.unit**2, 4))
        assert high[number] - low[number] <= 2.0**-44 * length + 40 * columns.error


def test_edges_are_found_where_they_are_met_first() -> None:
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
    sides = MeshFaces(FixedPoints(points), [(0, 1, 2), (), (2, 3, 0), (0, 1, 3)]).sides()
    keys = np.array([0 * 4 + 1, 2 * 4 + 3, 1 * 4 + 0, 3 * 4 + 0, 15, 0])
    assert sides.find(keys).tolist() == [0, 3, -1, 4, -1, -1]
    assert (sides.repeated.tolist(), sides.owner.tolist()) == ([6, 8], [0, 4])
    none = MeshFaces(FixedPoints(points), []).sides()
    assert none.find(keys).tolist() == [-1] * 6


def test_one_face_with_t_vertices_among_many_without_may_have_the_least_feature() -> None:
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (9, 0), (0, 9), (4, 0), (5, 0), (9, 9), (20, 0), (20, 9),
                                                 (9, 20))]
    cycles = [(1, 5, 2), (1, 6, 5), (6, 7, 5), (5, 7, 8), (0, 3, 4, 1, 2)]
    faces = MeshFaces(FixedPoints(points), cycles)
    assert faces.not_triangles() == [] and faces.least_feature() == (1, 4)


def test_a_triangle_is_not_refused_by_floats_alone() -> None:
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (9, 0), (0, 9))]
    faces = MeshFaces(FixedPoints(points), [(0, 1, 2)])
    faces.turn = -faces.turn
    with pytest.raises(AssertionError, match=r"^floats refuse face 0, which is a triangle$"):
        faces.not_triangles()


def test_a_walk_back_on_a_side_and_a_last_face_without_vertices_are_refused() -> None:
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (9, 0), (0, 9), (3, 0), (6, 0))]
    faces = MeshFaces(FixedPoints(points), [(0, 4, 3, 1, 2), (0, 3, 4, 1, 2), ()])
    assert faces.not_triangles() == [(0, NotTriangle("turns back, or stands still,", 4)),
                                     (2, NotTriangle("has fewer than three vertices", -1))]


def test_indices_take_half_the_memory_where_they_are_small(monkeypatch: pytest.MonkeyPatch) -> None:
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (1, 0), (1, 1))]
    for many, wanted in ((4, np.int32), (3, np.int64), (2, np.int64)):
        monkeypatch.setattr(module, "_MANY", many)
        faces = MeshFaces(FixedPoints(points), [(0, 1, 2)])
        sides = faces.sides()
        for indices in (faces.vertex, faces.face, faces.following, faces.before, sides.first, sides._sorted_first):
            assert indices.dtype == wanted
        assert faces.turn.dtype == np.int8
        assert faces.face[sides.repeated].tolist() == faces.face[sides.owner].tolist() == []


def test_keys_are_whole_numbers_of_any_size() -> None:
    faces = MeshFaces(FixedPoints([]), [])
    faces.columns.points = range(2**31 - 3)  # type: ignore[assignment]
    ends = np.array([2**31 - 4, 2**31 - 5], np.int32)
    assert faces.key(ends, ends[::-1]).tolist() == [(2**31 - 4) * (2**31 - 3) + 2**31 - 5,
                                                    (2**31 - 5) * (2**31 - 3) + 2**31 - 4]
