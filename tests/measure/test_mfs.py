"""The minimum feature size: equal to a search of all pairs wherever that is affordable, and to GEOS beyond."""

from collections.abc import Callable
from fractions import Fraction
from math import isclose, log2, sqrt
from typing import Any

import families
import oracle
import pytest
import shapely
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.candidates import nearest_candidates
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.planar.pslg import Edge, Pslg

EVERY = families.ALL_SMALL | families.SMALL_PSLGS | {
    f"map {columns} x {rows}": families.grid_map(columns, rows, 9) for columns, rows in [(1, 1), (5, 5), (7, 6)]}


def pslg(vertices: list[tuple[Any, Any]], edges: list[Edge]) -> Pslg:
    return Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in vertices), tuple(edges))


def judged(graph: Pslg) -> Nearest | None:
    """Assert that the answer is the oracle's and that its witness has it; return it."""
    found = minimum_feature_size(graph)
    expected = oracle.mfs_squared(graph.vertices, graph.edges)
    if found is None:
        assert expected is None
        return None
    a, b = found.feature
    assert found.vertex not in (a, b)
    assert found.is_vertex_pair == (a == b)
    assert a == b or (a, b) in graph.edges
    points = graph.vertices
    assert segment_distance_squared(points[found.vertex], points[a], points[b]) == found.squared == expected
    return found


# --- by hand ---


@pytest.mark.parametrize(("vertices", "edges"), [([], []), ([(3, 4)], [])])
def test_where_there_is_no_pair_there_is_no_feature_size(vertices: list[tuple[int, int]], edges: list[Edge]) -> None:
    assert minimum_feature_size(pslg(vertices, edges)) is None


@pytest.mark.parametrize(("vertices", "edges", "expected"), [
    ([(0, 0), (3, 4)], [], Nearest(mpq(25), 1, (0, 0))),
    ([(0, 0), (3, 4)], [(0, 1)], Nearest(mpq(25), 1, (0, 0))),
    ([(0, 0), (3, 4)], [(1, 0)], Nearest(mpq(25), 0, (1, 1))),
    ([(0, 0), (4, 0), (2, 1)], [(0, 1)], Nearest(mpq(1), 2, (0, 1))),
    ([(0, 0), (4, 0), (5, 1)], [(0, 1)], Nearest(mpq(2), 2, (0, 1))),
    ([(0, 0), (4, 0), (4, 3), (0, 3)], [(0, 1), (2, 3)], Nearest(mpq(9), 2, (0, 1))),
    ([(0, 0), (1, 0), (9, 9), (9, 20)], [(0, 1), (2, 3)], Nearest(mpq(1), 1, (0, 0))),
    ([(0, 0), (4, 0), (0, 3)], [(0, 1), (1, 2), (2, 0)], Nearest(mpq(144, 25), 0, (1, 2))),
    # Two isolated points in a room: the least distance is between vertices.
    ([(0, 0), (4, 0), (4, 4), (0, 4), (2, 2), ("17/8", 2)], [(0, 1), (1, 2), (2, 3), (3, 0)],
     Nearest(mpq(1, 64), 5, (4, 4))),
    # A path of two edges: its ends are near each other's edges.
    ([(0, 0), (2, 0), (2, 1)], [(0, 1), (1, 2)], Nearest(mpq(1), 2, (0, 1))),
])
def test_by_hand(vertices: list[tuple[Any, Any]], edges: list[Edge], expected: Nearest) -> None:
    assert judged(pslg(vertices, edges)) == expected


def test_edges_come_before_vertices_and_lower_indices_first() -> None:
    square = pslg([(0, 0), (1, 0), (1, 1), (0, 1)], [(2, 3), (0, 1), (1, 2), (3, 0)])
    assert judged(square) == Nearest(mpq(1), 0, (2, 3))
    # Point 4 is as near to edge (0, 1) as to point 5.
    graph = pslg([(0, 0), (9, 0), (9, 9), (0, 9), (4, 1), (5, 1)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    assert judged(graph) == Nearest(mpq(1), 4, (0, 1))


# --- against all pairs ---


@pytest.mark.parametrize("name", EVERY)
def test_every_small_input_has_the_oracles_feature_size(name: str) -> None:
    assert judged(EVERY[name]) is not None


def numbers() -> st.SearchStrategy[mpq]:
    """Whole numbers, thirds, and offsets from 10^-3 to 10^-30, so that clusters arise."""
    whole = st.integers(0, 4).map(mpq)
    near = st.builds(lambda a, b, e: mpq(a) + mpq(b) / mpq(10) ** e, st.integers(0, 4), st.integers(-3, 3),
                     st.sampled_from([3, 14, 16, 17, 30]))
    thirds = st.builds(mpq, st.integers(-9, 9), st.just(3))
    wide = st.builds(lambda a, e: mpq(a) * mpq(10) ** e, st.integers(-3, 3), st.integers(-30, 30))
    return st.one_of(whole, near, thirds, wide)


@st.composite
def graphs(draw: st.DrawFn) -> Pslg:
    """Return distinct points and a few edges, which may cross; no vertex lies on an edge that does not list it."""
    points = draw(st.lists(st.tuples(numbers(), numbers()), min_size=1, max_size=9, unique=True))
    pairs = [(u, v) for u in range(len(points)) for v in range(u)]
    edges = draw(st.lists(st.sampled_from(pairs), max_size=6, unique=True)) if pairs else []
    graph = pslg(points, edges)
    at = graph.vertices
    kept = [(u, v) for u, v in edges
            if all(w in (u, v) or segment_distance_squared(p, at[u], at[v]) for w, p in enumerate(at))]
    return Pslg(at, tuple((u, v) if draw(st.booleans()) else (v, u) for u, v in kept))


@settings(max_examples=250, deadline=None, derandomize=True)
@given(graphs())
@example(pslg([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (2, 3)]))  # crossing edges
def test_points_with_few_edges_crossing_ones_among_them(graph: Pslg) -> None:
    judged(graph)


def test_a_graph_of_edges_that_cross_may_have_its_feature_size_between_two_pairs() -> None:
    cross = pslg([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (2, 3)])
    found = judged(cross)
    assert found is not None and found.squared == 2


@pytest.mark.parametrize("spread", [10**6, 10**15, 10**17, 10**30])
@pytest.mark.parametrize("offset", [0, 10**30])
def test_a_spread_beyond_doubles(spread: int, offset: int) -> None:
    for tip in (mpq(1), mpq(1, spread), mpq(-7, spread)):
        corners = [(0, 0), (spread, 0), (spread, 3), (mpq(spread, 3), 1), (mpq(spread, 3) + tip, 2), (0, 3)]
        graph = families.translated(families.ring(corners), offset, mpq(-offset, 7))
        found = judged(graph)
        assert found is not None and found.squared <= 1


@pytest.mark.parametrize("size", [10**12, 10**16, 10**20, 10**300])
def test_clusters_far_smaller_than_the_resolution_of_floats(size: int) -> None:
    tiny = families.scaled(families.comb(6, 30, "uneven"), mpq(1, size))
    small = families.scaled(families.star(5), mpq(1, 2 * size))
    both = Pslg(
        (*tiny.vertices, *families.translated(small, 1, mpq(1, 3)).vertices, Point(mpq(1), mpq(-1))),
        (*tiny.edges, *((u + len(tiny.vertices), v + len(tiny.vertices)) for u, v in small.edges)))
    found = judged(both)
    alone = judged(families.star(5))
    assert found is not None and alone is not None
    assert found.squared <= alone.squared / (2 * size) ** 2


def test_coordinates_of_thirty_digits_that_differ_in_the_last() -> None:
    base = 123456789012345678901234567890
    graph = pslg([(base + x, base * 2 + y) for x, y in [(0, 0), (10**15, 1), (10**15, 3), (5 * 10**14, 2), (0, 4)]],
                 [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0)])
    found = judged(graph)
    assert found is not None and found.squared < 4


# --- filters that stay sharp: the number of exact evaluations grows with n, whatever the scale of the features ---


def flat_comb(teeth: int, gap: mpq) -> Pslg:
    """Return a comb of teeth of length 1 and nearly parallel sides; tips are about `gap` from the next tooth."""
    corners: list[tuple[mpq, mpq]] = []
    for i in range(teeth):
        corners += [(mpq(0), 3 * i * gap), (1 - mpq(i * i % 17, 1000), (3 * i + 1 + mpq(i % 7, 10)) * gap)]
    return families.ring([*corners, (mpq(0), 3 * teeth * gap), (mpq(-1), 3 * teeth * gap), (mpq(-1), mpq(0))])


def strips(lines: int, gap: mpq) -> Pslg:
    """Return parallel segments across each other's ends: each vertex is within 2^-44 of every segment."""
    vertices: list[tuple[Any, Any]] = []
    for i in range(lines):
        vertices += [(mpq(i, 3 * lines), i * gap), (1 + mpq(i * i % 101, 301), (i + mpq(i % 5, 50)) * gap)]
    return pslg(vertices, [(2 * i, 2 * i + 1) for i in range(lines)])


def cluster(size: int, scale: mpq) -> Pslg:
    """Return a tiny star in the middle of a room, crossed by nothing."""
    star = families.translated(families.scaled(families.star(size), scale), mpq(1, 3), mpq(1, 7))
    room = pslg([(-1, -1), (2, -1), (2, 2), (-1, 2)], [(0, 1), (1, 2), (2, 3), (3, 0)])
    return Pslg((*room.vertices, *star.vertices), (*room.edges, *((u + 4, v + 4) for u, v in star.edges)))


def fan(spokes: int, scale: mpq) -> Pslg:
    """Return long segments that all end near one place, `scale` apart, and small ones among them."""
    vertices: list[tuple[Any, Any]] = []
    for i in range(spokes):
        vertices += [(scale * i, scale * (i * i % 11)), (mpq(2) + mpq(i, spokes), mpq(-1) + mpq(2 * i, spokes))]
        vertices += [(-scale * (i + 1), scale * (i % 3)), (-scale * (i + mpq(4, 3)), scale * (i % 3 + mpq(1, 3)))]
    return pslg(vertices, [(i, i + 1) for i in range(0, 4 * spokes, 2)])


ADVERSE: dict[str, Callable[[int], Pslg]] = {
    "flat comb, 2^-60": lambda n: flat_comb(n, mpq(1, 2**60)),
    "flat comb, 10^-24": lambda n: flat_comb(n, mpq(1, 10**24)),
    "strips, 2^-60": lambda n: strips(n, mpq(1, 2**60)),
    "strips, 10^-23": lambda n: strips(n, mpq(1, 10**23)),
    "cluster, 10^-16": lambda n: cluster(n, mpq(1, 10**16)),
    "cluster, 10^-40": lambda n: cluster(n, mpq(1, 10**40)),
    "cluster, 10^-200": lambda n: cluster(n, mpq(1, 10**200)),
    "fan, 10^-18": lambda n: fan(n, mpq(1, 10**18)),
    "fan, 10^-50": lambda n: fan(n, mpq(1, 10**50)),
}


@pytest.mark.parametrize("name", ADVERSE)
def test_tiny_features_cost_no_more_exact_evaluations_than_there_are_vertices(name: str) -> None:
    judged(ADVERSE[name](12))
    for n in (100, 400):
        graph = ADVERSE[name](n)
        forget()
        assert minimum_feature_size(graph) is not None
        count = decisions()["least distance"]
        assert count.exactly <= len(graph.vertices)
        # And no more than so many pairs are looked at by floats.
        assert count.by_floats <= 25 * len(graph.vertices) * log2(len(graph.vertices))


# --- laws ---


@pytest.mark.parametrize("name", [*families.SMALL_PSLGS, *list(families.ALL_SMALL)[::6]])
def test_moving_turning_mirroring_and_renumbering_keep_it_and_scaling_scales_it(name: str) -> None:
    graph = EVERY[name]
    found = minimum_feature_size(graph)
    assert found is not None
    changes: list[tuple[Callable[[Pslg], Pslg], mpq]] = [
        (lambda p: families.translated(p, 10**40, Fraction(-1, 7)), mpq(1)),
        (lambda p: families.rotated(p, Fraction(2, 7)), mpq(1)),
        (families.mirrored, mpq(1)), (families.reversed_orientation, mpq(1)),
        (lambda p: families.with_start(p, 3), mpq(1)),
        (lambda p: families.scaled(p, Fraction(1, 10**30)), mpq(1, 10**60)),
        (lambda p: families.scaled(p, 10**30), mpq(10**60))]
    for change, factor in changes:
        changed = minimum_feature_size(change(graph))
        assert changed is not None and changed.squared == factor * found.squared


@settings(max_examples=120, deadline=None, derandomize=True)
@given(graphs(), st.tuples(numbers(), numbers()))
def test_another_vertex_never_raises_it(graph: Pslg, place: tuple[mpq, mpq]) -> None:
    before = minimum_feature_size(graph)
    more = minimum_feature_size(Pslg((*graph.vertices, Point(*place)), graph.edges))
    assert before is None or (more is not None and more.squared <= before.squared)


@pytest.mark.parametrize("name", list(EVERY)[::3])
def test_the_candidates_hold_every_pair_at_the_least_distance(name: str) -> None:
    graph = EVERY[name]
    features = [*graph.edges, *((v, v) for v in range(len(graph.vertices)))]
    found = nearest_candidates(graph.vertices, features)
    at = graph.vertices
    distances = {(v, i): segment_distance_squared(p, at[a], at[b]) for v, p in enumerate(at)
                 for i, (a, b) in enumerate(features) if v not in (a, b)}
    least = min(distances.values())
    assert {pair for pair, value in distances.items() if value == least} <= set(found)
    assert len(found) == len(set(found)) and all(pair in distances for pair in found)


# --- larger inputs ---


LARGE: dict[str, Callable[[], Pslg]] = {
    "growth": lambda: families.random_simple_polygon(5000, 1, "growth"),
    "grid": lambda: families.random_simple_polygon(5000, 2, "grid"),
    "monotone": lambda: families.random_simple_polygon(5000, 3, "monotone"),
    "star-shaped": lambda: families.random_simple_polygon(5000, 4, "star"),
    "comb": lambda: families.comb(2499),
    "uneven comb": lambda: families.comb(2499, 10**6, "uneven"),
    "spiral": lambda: families.rectangular_spiral(624),
    "curved spiral": lambda: families.curved_spiral(104, 24),
    "star": lambda: families.star(2500),
    "regular": lambda: families.regular_polygon(5000),
    "staircase": lambda: families.staircase(2499),
    "map": lambda: families.grid_map(70, 69, 3),
    "map, few edges": lambda: families.grid_map(70, 69, 4, Fraction(1, 3)),
}


@pytest.mark.parametrize("name", LARGE)
def test_five_thousand_vertices_against_geos(name: str) -> None:
    graph = LARGE[name]()
    assert 4900 <= len(graph.vertices) <= 5100
    found = minimum_feature_size(graph)
    assert found is not None
    at = [(float(p.x), float(p.y)) for p in graph.vertices]
    on_edges = {v for edge in graph.edges for v in edge}
    lines = [shapely.LineString([at[u], at[v]]) for u, v in graph.edges]
    lonely = [shapely.Point(at[v]) for v in range(len(at)) if v not in on_edges]
    clearance = shapely.minimum_clearance(shapely.GeometryCollection([*lines, *lonely]))
    assert isclose(sqrt(found.squared), clearance, rel_tol=1e-6)
    a, b = found.feature
    assert segment_distance_squared(graph.vertices[found.vertex], graph.vertices[a], graph.vertices[b]) == found.squared
