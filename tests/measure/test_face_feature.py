"""One face: which cycles are counter-clockwise triangles, and their feature size by all pairs."""

from fractions import Fraction
from itertools import combinations, pairwise, permutations, product

import oracle
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import orientation
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared, face_witness

few = settings(max_examples=120, deadline=None, derandomize=True)


def points(*places: tuple[int | str, int | str]) -> list[Point]:
    return [Point(mpq(x), mpq(y)) for x, y in places]


GRID = points(*product(range(3), repeat=2))


def is_triangle(at: list[Point], cycle: tuple[int, ...]) -> bool:
    """Return whether the cycle is a counter-clockwise triangle: some three of its vertices, in order, with all
    others on the three sides, in order."""
    for i, j, k in combinations(range(len(cycle)), 3):
        a, b, c = (at[cycle[place]] for place in (i, j, k))
        if orientation(a, b, c) > 0:
            runs = [(a, cycle[i + 1:j], b), (b, cycle[j + 1:k], c), (c, cycle[k + 1:] + cycle[:i], a)]
            if all(in_order([start, *(at[v] for v in run), end]) for start, run, end in runs):
                return True
    return False


def in_order(run: list[Point]) -> bool:
    """Return whether distinct points follow each other along a segment from the first to the last."""
    a, b = run[0], run[-1]
    parts = [(p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y) for p in run]
    return all(orientation(a, p, b) == 0 for p in run) and all(s < t for s, t in pairwise(parts))


@pytest.mark.parametrize("count", [3, 4, 5])
def test_every_cycle_on_a_grid_of_three_is_a_triangle_by_its_corners_when_it_is_one(count: int) -> None:
    found = 0
    for cycle in permutations(range(9), count):
        corners = corners_of(GRID, cycle)
        expected = is_triangle(GRID, cycle)
        assert isinstance(corners, NotTriangle) != expected, cycle
        if not isinstance(corners, NotTriangle):
            found += 1
            straight = [i for i in range(count) if orientation(
                GRID[cycle[i - 1]], GRID[cycle[i]], GRID[cycle[(i + 1) % count]]) == 0]
            assert sorted([*corners, *straight]) == list(range(count)) and corners == sorted(corners)
    assert found > 0


PLACES = points((0, 0), (4, 0), (4, 4), (0, 4), (2, 0), (1, 0), (2, 2), (0, 0), (3, 1))


@pytest.mark.parametrize(("cycle", "reason", "vertex"), [
    ((), "has fewer than three vertices", -1), ((2,), "has fewer than three vertices", 2),
    ((2, 3), "has fewer than three vertices", 2), ((0, 2, 1), "turns right", 0),
    ((0, 1, 2, 3), "has a fourth corner", 3), ((0, 4, 5, 1, 2), "turns back, or stands still,", 4),
    ((0, 7, 1, 2), "turns back, or stands still,", 0), ((0, 0, 1, 2), "turns back, or stands still,", 0),
    ((0, 4, 1), "turns back, or stands still,", 0), ((0, 1, 2, 8), "turns right", 8),
    ((0, 1, 1, 2), "turns back, or stands still,", 1),
])
def test_a_refusal_says_why_and_where(cycle: tuple[int, ...], reason: str, vertex: int) -> None:
    assert corners_of(PLACES, cycle) == NotTriangle(reason, vertex)


def test_a_cycle_that_winds_twice_is_no_triangle() -> None:
    # Six left turns of a hexagram walk, and a triangle run twice.
    assert isinstance(corners_of(PLACES, (0, 1, 2, 0, 1, 2)), NotTriangle)
    pentagram = points((0, 3), (-2, -2), (3, 1), (-3, 1), (2, -2))
    assert isinstance(corners_of(pentagram, (0, 1, 2, 3, 4)), NotTriangle)


@st.composite
def faces(draw: st.DrawFn) -> tuple[list[Point], tuple[int, ...]]:
    """Return a triangle with T-vertices, its cycle from anywhere, places of any index."""
    whole = st.integers(-20, 20)
    near = st.builds(lambda a, b: mpq(a) + mpq(b, 10**20), whole, st.integers(-1, 1))
    corner = st.builds(Point, near, near)
    a, b, c = draw(st.tuples(corner, corner, corner).filter(lambda t: orientation(*t) > 0))
    run: list[Point] = []
    # Ninths, a vertex next to the corner, and two next to each other in the middle.
    special = st.sampled_from([mpq(1, 10**12), mpq(1, 2), mpq(1, 2) + mpq(1, 10**12)])
    parts = st.lists(st.one_of(st.builds(mpq, st.integers(1, 8), st.just(9)), special),
                     max_size=3, unique=True).map(sorted)
    for p, q in ((a, b), (b, c), (c, a)):
        run.append(p)
        run += [Point(p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t) for t in draw(parts)]
    order = draw(st.permutations(range(len(run))))
    at = [run[order.index(v)] for v in range(len(run))]
    start = draw(st.integers(0, len(run) - 1))
    return at, tuple(order[start:]) + tuple(order[:start])


@few
@given(faces())
def test_the_feature_size_of_a_face_is_that_of_its_vertices_and_sides(face: tuple[list[Point], tuple[int, ...]]
                                                                       ) -> None:
    at, cycle = face
    corners = corners_of(at, cycle)
    assert not isinstance(corners, NotTriangle) and is_triangle(at, cycle)
    squared = face_feature_squared(at, cycle, corners)
    edges = [(cycle[i - 1], v) for i, v in enumerate(cycle)]
    assert squared == oracle.mfs_squared(at, edges)
    witness = face_witness(at, cycle)
    u, v = witness.feature
    assert (u, v) in edges and witness.vertex not in (u, v)
    assert witness.squared == squared == segment_distance_squared(at[witness.vertex], at[u], at[v])


@few
@given(faces())
def test_turning_the_cycle_changes_no_feature_size_and_reversing_it_makes_it_no_face(
        face: tuple[list[Point], tuple[int, ...]]) -> None:
    at, cycle = face
    sizes = set()
    for k in range(len(cycle)):
        turned = cycle[k:] + cycle[:k]
        corners = corners_of(at, turned)
        assert not isinstance(corners, NotTriangle)
        sizes.add(face_feature_squared(at, turned, corners))
        assert isinstance(corners_of(at, turned[::-1]), NotTriangle)
    assert len(sizes) == 1


def test_by_hand() -> None:
    right = points((0, 0), (4, 0), (0, 3), (1, 0), (2, 0), (0, "1/10"), ("2/5", "27/10"))
    assert face_feature_squared(right, (0, 1, 2), [0, 1, 2]) == Fraction(144, 25)
    # The vertex (1, 0) is 1 from the leg, (2, 0) is 6/5 from the hypotenuse.
    assert face_feature_squared(right, (0, 3, 4, 1, 2), [0, 3, 4]) == 1
    assert face_feature_squared(right, (0, 4, 1, 2), [0, 2, 3]) == Fraction(36, 25)
    assert face_feature_squared(right, (0, 1, 2, 5), [0, 1, 2]) == Fraction(1, 100)
    # The vertex on the hypotenuse is 2/5 from the leg.
    assert face_feature_squared(right, (0, 1, 6, 2), [0, 1, 3]) == Fraction(4, 25)
    # Neighbours on a side, far from the two other ones.
    wide = points((0, 0), (9, 0), (0, 9), (4, 0), (5, 0))
    assert face_feature_squared(wide, (0, 3, 4, 1, 2), [0, 3, 4]) == 1
