"""The validating sweep against a search of all pairs, defect by defect, and what lies below each vertex."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import combinations, permutations, product
from math import gcd, log2
from typing import Any, TypeAlias

import families
import pytest
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.errors import GeometryError, InputError
from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.validate import (
    Below,
    EdgesCross,
    EdgesOverlap,
    HolePointOnBoundary,
    VertexOnEdge,
    VerticesCoincide,
    swept,
    validate,
)

Place: TypeAlias = tuple[Fraction, Fraction]
Defect: TypeAlias = tuple[Any, ...]


def pslg(vertices: list[tuple[Any, Any]], edges: list[Edge], holes: list[tuple[Any, Any]] | None = None) -> Pslg:
    """Return the PSLG with these places, written as numbers or text."""
    return Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in vertices), tuple(edges),
                tuple(Point(mpq(x), mpq(y)) for x, y in holes or []))


# --- the definition, pair by pair ---


def places(points: tuple[Point, ...]) -> list[Place]:
    return [(Fraction(int(p.x.numerator), int(p.x.denominator)),
             Fraction(int(p.y.numerator), int(p.y.denominator))) for p in points]


def turn(a: Place, b: Place, c: Place) -> int:
    value = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    return (value > 0) - (value < 0)


def within(p: Place, a: Place, b: Place) -> bool:
    """Return whether p lies on the segment ab, but not at an end."""
    return turn(a, b, p) == 0 and min(a, b) < p < max(a, b)


def crossing(a: Place, b: Place, c: Place, d: Place) -> Place | None:
    """Return the only common point of two segments when it is interior to both."""
    if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], d[0] - c[0], d[1] - c[1]
        t = ((c[0] - a[0]) * vy - (c[1] - a[1]) * vx) / (ux * vy - uy * vx)
        return a[0] + t * ux, a[1] + t * uy
    return None


def defects(graph: Pslg) -> Iterator[Defect]:
    """Yield every defect as its class and fields."""
    at, holes = places(graph.vertices), places(graph.holes)
    ends = [(at[u], at[v]) for u, v in graph.edges]
    for (i, p), (j, q) in combinations(enumerate(at), 2):
        if p == q:
            yield VerticesCoincide, i, j, p
    for (v, p), (e, (a, b)) in product(enumerate(at), enumerate(ends)):
        if within(p, a, b):
            yield VertexOnEdge, v, e, graph.edges[e], p
    for e, f in combinations(range(len(ends)), 2):
        (a, b), (c, d) = ends[e], ends[f]
        both = graph.edges[e], graph.edges[f]
        if (place := crossing(a, b, c, d)) is not None:
            yield EdgesCross, e, f, both, place
        start, end = max(min(a, b), min(c, d)), min(max(a, b), max(c, d))
        if a != b and c != d and turn(a, b, c) == turn(a, b, d) == 0 and start < end:
            yield EdgesOverlap, e, f, both, start
    for h, p in enumerate(holes):
        if p in at or any(within(p, a, b) for a, b in ends):
            yield HolePointOnBoundary, h, p


def fields_of(error: GeometryError) -> Defect:
    at = places((error.at,))[0]  # type: ignore[attr-defined]
    match error:
        case VerticesCoincide():
            return VerticesCoincide, error.first, error.second, at
        case VertexOnEdge():
            return VertexOnEdge, error.vertex, error.edge, error.ends, at
        case EdgesOverlap() | EdgesCross():
            return type(error), error.first, error.second, error.ends, at
        case HolePointOnBoundary():
            return HolePointOnBoundary, error.hole, at
    raise AssertionError(f"an error of another class: {error!r}")


def lowest(graph: Pslg, points: tuple[Point, ...]) -> tuple[int, ...]:
    """Return the edge that a ray from each point, downwards and leaning to the right by nothing, meets first."""
    at = places(graph.vertices)
    found = []
    for x, y in places(points):
        best: tuple[Fraction, Fraction, int] | None = None
        for e, (u, v) in enumerate(graph.edges):
            (ax, ay), (bx, by) = sorted((at[u], at[v]))
            if ax <= x < bx:
                slope = (by - ay) / (bx - ax)
                height = ay + slope * (x - ax)
                # Edges that meet at x are told apart by their slopes, right of it.
                if height < y and (best is None or (height, slope) > best[:2]):
                    best = height, slope, e
        found.append(-1 if best is None else best[2])
    return tuple(found)


def judged(graph: Pslg) -> str:
    """Assert that `validate` and the search of all pairs agree; return the name of what was raised."""
    expected = list(defects(graph))
    try:
        below = validate(graph)
    except GeometryError as error:
        assert fields_of(error) in expected, (graph, error)
        return type(error).__name__
    assert expected == [], graph
    assert below == Below(lowest(graph, graph.vertices), lowest(graph, graph.holes)), graph
    return "valid"


# --- small grids, exhausted ---


def grid(size: int) -> list[tuple[int, int]]:
    return list(product(range(size), repeat=2))


def merged(segments: tuple[tuple[tuple[int, int], tuple[int, int]], ...]) -> Pslg:
    """Return the graph of segments whose equal ends are one vertex."""
    vertices = sorted({p for segment in segments for p in segment})
    return pslg(vertices, [(vertices.index(p), vertices.index(q)) for p, q in segments])


def test_all_pairs_of_segments_of_a_grid_of_four_in_both_orders() -> None:
    segments = list(combinations(grid(4), 2))
    outcomes = {judged(merged((s, t[::-1]))) for s, t in combinations(segments, 2)}
    outcomes |= {judged(merged((t, s))) for s, t in combinations(segments[::3], 2)}
    assert outcomes == {"valid", "VertexOnEdge", "EdgesOverlap", "EdgesCross"}


def test_all_triples_of_segments_of_a_grid_of_three() -> None:
    segments = list(combinations(grid(3), 2))
    for triple in combinations(segments, 3):
        judged(merged(triple))


def test_all_pairs_of_segments_of_a_grid_of_three_with_equal_ends_left_apart() -> None:
    segments = list(combinations(grid(3), 2))
    for s, t in product(segments, repeat=2):
        judged(pslg([*s, *t], [(0, 1), (3, 2)]))


def test_every_segment_of_a_grid_against_every_point_of_it_as_vertex_and_as_hole() -> None:
    for p, q in combinations(grid(4), 2):
        for r in grid(4):
            judged(pslg([r, p, q], [(2, 1)]))
            judged(pslg([p, q], [(0, 1)], [r]))


def test_all_vertices_of_a_grid_with_any_three_of_its_shortest_edges_and_diagonals() -> None:
    vertices = grid(3)
    short = [(i, j) for (i, p), (j, q) in combinations(enumerate(vertices), 2)
             if max(abs(p[0] - q[0]), abs(p[1] - q[1])) == 1]
    outcomes = {judged(pslg(vertices, list(edges))) for edges in combinations(short, 3)}
    assert outcomes == {"valid", "EdgesCross"}


# --- random graphs ---


@st.composite
def graphs(draw: st.DrawFn) -> Pslg:
    """Return a graph on a small grid, maybe with defects of any kind, ends of edges in any order."""
    size = draw(st.integers(2, 5))
    count = draw(st.integers(2, 9))
    cell = st.tuples(st.integers(0, size), st.integers(0, size))
    vertices = draw(st.lists(cell, min_size=count, max_size=count, unique=draw(st.integers(0, 9)) > 0))
    pair = st.tuples(st.integers(0, count - 1), st.integers(0, count - 1)).filter(lambda e: e[0] != e[1])
    edges = draw(st.lists(pair, max_size=9))
    halves = st.integers(-1, 2 * size + 1).map(lambda k: mpq(k, 2))
    return pslg(vertices, edges, draw(st.lists(st.tuples(halves, halves), max_size=2)))


@settings(max_examples=700, deadline=None, derandomize=True)
@given(graphs())
@example(pslg([(0, 0), (1, 0), (1, 0)], [(0, 2)]))  # the end of an edge coincides with an earlier vertex
@example(pslg([(0, 0), (0, 0), (1, 1), (1, 0)], [(0, 1), (0, 2), (0, 3)]))  # an edge between coinciding vertices
@example(pslg([(0, 0), (0, 0), (1, 1)], [(1, 0), (1, 2)]))
def test_random_graphs_are_judged_as_by_a_search_of_all_pairs(graph: Pslg) -> None:
    judged(graph)


@st.composite
def valid_graphs(draw: st.DrawFn) -> Pslg:
    """Return a graph without defects: edges that would make one are left out."""
    cell = st.tuples(st.integers(0, 5), st.integers(0, 5))
    vertices = draw(st.lists(cell, min_size=3, max_size=14, unique=True))
    at = [(Fraction(x), Fraction(y)) for x, y in vertices]
    kept: list[Edge] = []
    every = [(i, j) for i in range(len(at)) for j in range(len(at)) if i < j]
    for i, j in draw(st.permutations(every)):
        if len(kept) < 24 and not any(within(p, at[i], at[j]) for p in at) and not any(
                crossing(at[i], at[j], at[u], at[v]) for u, v in kept):
            kept.append((i, j) if draw(st.booleans()) else (j, i))
    holes = [(mpq(x, 6) + mpq(1, 7), mpq(y, 6)) for x, y in draw(st.lists(cell, max_size=2))]
    return pslg(vertices, kept, holes)


@settings(max_examples=120, deadline=None, derandomize=True)
@given(valid_graphs())
def test_full_valid_graphs_pass_with_what_is_below_each_vertex(graph: Pslg) -> None:
    assert judged(graph) in ("valid", "HolePointOnBoundary")


@settings(max_examples=100, deadline=None, derandomize=True)
@given(graphs())
def test_moving_scaling_and_shearing_change_no_verdict(graph: Pslg) -> None:
    def image(p: Point) -> Point:
        # A shear that keeps the order of the points, by 10^-30, on top of a move by 10^40.
        return Point((p.x + p.y / 10**9) / 10**30 + mpq(10**40), p.y / 10**30 - mpq(1, 3))

    moved = Pslg(tuple(map(image, graph.vertices)), graph.edges, tuple(map(image, graph.holes)))
    assert judged(moved) == judged(graph)


@settings(max_examples=150, deadline=None, derandomize=True)
@given(graphs(), st.randoms(use_true_random=False))
def test_numbering_and_direction_of_edges_change_no_verdict(graph: Pslg, source: Any) -> None:
    order = list(range(len(graph.vertices)))
    source.shuffle(order)
    edges = [(order[u], order[v])[::source.choice((1, -1))] for u, v in graph.edges]
    source.shuffle(edges)
    vertices = [graph.vertices[order.index(v)] for v in range(len(order))]
    renumbered = Pslg(tuple(vertices), tuple(edges), graph.holes)
    assert (judged(renumbered) == "valid") == (judged(graph) == "valid")


@pytest.mark.parametrize("name", families.SMALL_PSLGS)
def test_below_is_right_on_the_families(name: str) -> None:
    assert judged(families.SMALL_PSLGS[name]) == "valid"
    assert judged(families.mirrored(families.SMALL_PSLGS[name])) == "valid"


# --- each error by hand: its fields and its words ---

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
RING = [(0, 1), (1, 2), (2, 3), (3, 0)]


@pytest.mark.parametrize(("graph", "fields", "words"), [
    (pslg([(1, 1), (0, 0), (1, 1)], []), (VerticesCoincide, 0, 2, (1, 1)),
     "vertices 0 and 2 coincide at (1, 1)"),
    (pslg([(0, 0), ("1/3", "1/3"), (1, 0), ("1/3", "1/3")], [(0, 3), (1, 2)]),
     (VerticesCoincide, 1, 3, (Fraction(1, 3), Fraction(1, 3))), "vertices 1 and 3 coincide at (1/3, 1/3)"),
    (pslg([*SQUARE, (2, 0)], RING), (VertexOnEdge, 4, 0, (0, 1), (2, 0)), "vertex 4 lies on edge 0 (0, 1) at (2, 0)"),
    (pslg([*SQUARE, (0, "1/3")], RING), (VertexOnEdge, 4, 3, (3, 0), (0, Fraction(1, 3))),
     "vertex 4 lies on edge 3 (3, 0) at (0, 1/3)"),
    (pslg([*SQUARE, (-1, 2), (0, 2)], [*RING, (4, 5)]), (VertexOnEdge, 5, 3, (3, 0), (0, 2)),
     "vertex 5 lies on edge 3 (3, 0) at (0, 2)"),
    (pslg([(0, 0), (3, 0), (1, 0), (5, 0)], [(0, 1), (2, 3)]), (VertexOnEdge, 2, 0, (0, 1), (1, 0)),
     "vertex 2 lies on edge 0 (0, 1) at (1, 0)"),
    (pslg([(0, 0), (0, 3), (0, 1)], [(1, 0), (2, 1)]), (VertexOnEdge, 2, 0, (1, 0), (0, 1)),
     "vertex 2 lies on edge 0 (1, 0) at (0, 1)"),
    (pslg(SQUARE, [*RING, (2, 1)]), (EdgesOverlap, 1, 4, ((1, 2), (2, 1)), (4, 0)),
     "edges 1 (1, 2) and 4 (2, 1) overlap from (4, 0)"),
    (pslg(SQUARE, [(0, 1), (0, 1)]), (EdgesOverlap, 0, 1, ((0, 1), (0, 1)), (0, 0)),
     "edges 0 (0, 1) and 1 (0, 1) overlap from (0, 0)"),
    (pslg([(2, 2), (0, 0), (4, 4)], [(1, 2), (1, 0)]), (EdgesOverlap, 0, 1, ((1, 2), (1, 0)), (0, 0)),
     "edges 0 (1, 2) and 1 (1, 0) overlap from (0, 0)"),
    (pslg(SQUARE, [*RING, (0, 2), (3, 1)]), (EdgesCross, 4, 5, ((0, 2), (3, 1)), (2, 2)),
     "edges 4 (0, 2) and 5 (3, 1) cross at (2, 2)"),
    (pslg([(0, 0), (0, 3), (-1, 0), (2, 1)], [(2, 3), (0, 1)]),
     (EdgesCross, 0, 1, ((2, 3), (0, 1)), (0, Fraction(1, 3))), "edges 0 (2, 3) and 1 (0, 1) cross at (0, 1/3)"),
    (pslg(SQUARE, RING, [(1, 1), (0, 4)]), (HolePointOnBoundary, 1, (0, 4)),
     "hole point 1 at (0, 4) lies on vertex 3: it must lie inside a face"),
    (pslg(SQUARE, RING, [(4, 4)]), (HolePointOnBoundary, 0, (4, 4)),
     "hole point 0 at (4, 4) lies on vertex 2: it must lie inside a face"),
    (pslg(SQUARE, RING, [(2, 4)]), (HolePointOnBoundary, 0, (2, 4)),
     "hole point 0 at (2, 4) lies on edge 2 (2, 3): it must lie inside a face"),
    (pslg(SQUARE, RING, [(0, "1/2")]), (HolePointOnBoundary, 0, (0, Fraction(1, 2))),
     "hole point 0 at (0, 1/2) lies on edge 3 (3, 0): it must lie inside a face"),
])
def test_an_error_names_the_indices_and_the_exact_place(graph: Pslg, fields: Defect, words: str) -> None:
    with pytest.raises(GeometryError) as caught:
        validate(graph)
    assert fields_of(caught.value) == fields
    assert str(caught.value) == words
    assert isinstance(caught.value, InputError)


def test_two_hole_points_may_coincide_and_mark_what_is_below_them() -> None:
    below = validate(pslg(SQUARE, RING, [(1, 1), (1, 1), (5, 5), (1, -1)]))
    assert below.hole == (0, 0, -1, -1)


@pytest.mark.parametrize("numbers", list(permutations(range(3))))
def test_edges_that_become_neighbours_where_one_between_them_ends_are_compared(numbers: tuple[int, ...]) -> None:
    ends = [(0, 1), (2, 3), (4, 5)]
    graph = pslg([(0, 0), (4, 4), (0, 4), (4, 0), (0, 2), (1, 2)], [ends[i] for i in numbers])
    assert judged(graph) == "EdgesCross"


def test_a_sweep_tells_the_order_of_the_points_and_how_they_turn() -> None:
    found = swept(pslg(SQUARE, RING, [(1, 1)]))
    assert list(found.rank) == [0, 3, 4, 1, 2]
    assert [found.turns.orientation(*triple) for triple in ((0, 1, 2), (1, 0, 4), (0, 4, 2))] == [1, -1, 0]


def test_many_edges_at_one_vertex_pass_and_any_of_them_twice_does_not() -> None:
    directions = [(x, y) for x, y in product(range(-3, 4), repeat=2) if gcd(x, y) == 1]
    star = pslg([(0, 0), *directions], [(0, i + 1) for i in range(len(directions))])
    assert judged(star) == "valid"
    for i in range(0, len(directions), 3):
        assert judged(Pslg(star.vertices, (*star.edges, (i + 1, 0)))) == "EdgesOverlap"


@pytest.mark.parametrize("exponent", [20, 40, 300])
def test_a_crossing_by_less_than_any_double_is_found_and_a_gap_is_none(exponent: int) -> None:
    tiny = f"1/{10**exponent}"
    roof = [(0, 0), (2, 0), (1, tiny), (1, 5)]
    assert judged(pslg(roof, [(0, 1), (2, 3)])) == "valid"
    below = [(0, 0), (2, 0), (1, f"-{tiny}"), (1, 5)]
    assert judged(pslg(below, [(0, 1), (2, 3)])) == "EdgesCross"
    assert judged(pslg([(0, 0), (2, 0), (1, 0), (1, 5)], [(0, 1), (2, 3)])) == "VertexOnEdge"


def test_the_empty_graph_and_isolated_vertices_are_valid() -> None:
    assert validate(pslg([], [])) == Below((), ())
    assert validate(pslg([(0, 0), (0, 1), (1, 0)], [])) == Below((-1, -1, -1), ())


# --- size: no recursion, and a number of predicates that grows as n log n ---


def spokes(n: int) -> Pslg:
    """Return a hub with n spokes."""
    rim = families.regular_polygon(n).vertices
    return Pslg((*rim, Point(mpq(0), mpq(0))), tuple((n, i) for i in range(n)))


def ladder(n: int) -> Pslg:
    """Return n nested horizontal edges: all are cut by the sweep line at once."""
    return pslg([p for i in range(n) for p in ((i, i), (4 * n - i, i))], [(2 * i, 2 * i + 1) for i in range(n)])


LARGE = {
    "comb": lambda n: families.comb(n // 2),
    "star": lambda n: families.star(n // 2),
    "spokes": spokes,
    "ladder": lambda n: ladder(n // 2),
    "isolated points": lambda n: pslg([(i * i % 997, i) for i in range(n)], []),
    "growth": lambda n: families.random_simple_polygon(n, 1, "growth"),
    "vertical edges": lambda n: pslg([(i // 2, i % 2) for i in range(n)], [(i, i + 1) for i in range(0, n, 2)]),
}


@pytest.mark.parametrize("name", LARGE)
def test_predicates_grow_as_n_log_n(name: str) -> None:
    for n in (1000, 4000):
        graph = LARGE[name](n)
        forget()
        validate(graph)
        count = decisions()["sweep orientation"]
        asked = count.by_floats + count.exactly
        assert asked <= 1.5 * len(graph.vertices) * log2(len(graph.vertices))
        # An end that is reached is found without a search: what starts nowhere else takes a few predicates.
        starts = sum(1 for v, end in enumerate(_first_ends(graph)) if end)
        assert asked <= 12 * len(graph.vertices) + 2 * starts * log2(len(graph.vertices))


def _first_ends(graph: Pslg) -> list[bool]:
    """Return, for each vertex, whether no edge comes to it from before it."""
    first = [True] * len(graph.vertices)
    for u, v in graph.edges:
        first[max(u, v, key=graph.vertices.__getitem__)] = False
    return first


def test_a_defect_at_the_far_end_of_a_long_input_is_found() -> None:
    comb = families.comb(5000)
    right = max(p.x for p in comb.vertices)
    assert len(comb.vertices) > 10000
    tail = (Point(right - 1, mpq(1)), Point(right + 1, mpq(2)))
    count = len(comb.vertices)
    with pytest.raises(EdgesCross) as caught:
        validate(Pslg(comb.vertices + tail, (*comb.edges, (count, count + 1))))
    assert caught.value.second == count and caught.value.at == Point(right, mpq(3, 2))
