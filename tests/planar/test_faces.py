"""The faces of a PSLG and its domain: by hand, by Euler's formula, and against the oracle's cells."""

from fractions import Fraction
from itertools import combinations, product
from typing import Any

import families
import oracle
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.errors import GeometryError
from exactmesh.geometry.point import Point
from exactmesh.planar.faces import HoleOutside, NoDomain, Subdivision, domain_of, doubled_walk_area, subdivide
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.planar.validate import validate

Places = list[tuple[Any, Any]]
SQUARE: Places = [(0, 0), (9, 0), (9, 9), (0, 9)]


def cycle(n: int, first: int = 0) -> list[Edge]:
    return [(first + i, first + (i + 1) % n) for i in range(n)]


def box(low: int, high: int) -> Places:
    return [(low, low), (high, low), (high, high), (low, high)]


def pslg(vertices: Places, edges: list[Edge], holes: Places | None = None) -> Pslg:
    return Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in vertices), tuple(edges),
                tuple(Point(mpq(x), mpq(y)) for x, y in holes or []))


def ring_of(subdivision: Subdivision, walk: tuple[int, ...] | None) -> tuple[int, ...]:
    """Return the vertices of a walk from its least one."""
    vertices = [subdivision.half_edges.origin[h] for h in walk or ()]
    start = vertices.index(min(vertices)) if vertices else 0
    return tuple(vertices[start:] + vertices[:start])


def described(graph: Pslg) -> set[tuple[Any, ...]]:
    """Return each face as its outer ring, its inner rings, its isolated vertices and whether it is a hole."""
    found = subdivide(graph)
    assert len(found.faces) == len({face.outer for face in found.faces})
    return {(ring_of(found, face.outer), frozenset(ring_of(found, walk) for walk in face.inner),
             frozenset(face.isolated), face.is_hole) for face in found.faces}


def components(graph: Pslg) -> int:
    """Return the number of connected components, isolated vertices among them."""
    label = list(range(len(graph.vertices)))
    for u, v in graph.edges:
        old, new = label[u], label[v]
        label = [new if x == old else x for x in label]
    return len(set(label))


NONE: frozenset[Any] = frozenset()


# --- by hand ---


def test_a_square_has_an_inside_and_an_outside() -> None:
    assert described(pslg(SQUARE, cycle(4))) == {
        ((), frozenset({(0, 3, 2, 1)}), NONE, False), ((0, 1, 2, 3), NONE, NONE, False)}


def test_a_clockwise_square_has_the_same_faces() -> None:
    edges = [(v, u) for u, v in reversed(cycle(4))]
    assert described(pslg(SQUARE, edges)) == described(pslg(SQUARE, cycle(4)))


def test_nested_rings_lie_each_in_the_one_around_it() -> None:
    graph = pslg([*SQUARE, *box(1, 8), *box(2, 7), *box(3, 4), *box(5, 6)],
                 [e for i in range(5) for e in cycle(4, 4 * i)])
    assert described(graph) == {
        ((), frozenset({(0, 3, 2, 1)}), NONE, False),
        ((0, 1, 2, 3), frozenset({(4, 7, 6, 5)}), NONE, False),
        ((4, 5, 6, 7), frozenset({(8, 11, 10, 9)}), NONE, False),
        ((8, 9, 10, 11), frozenset({(12, 15, 14, 13), (16, 19, 18, 17)}), NONE, False),
        ((12, 13, 14, 15), NONE, NONE, False), ((16, 17, 18, 19), NONE, NONE, False)}


def test_countries_share_their_border() -> None:
    graph = pslg([*SQUARE, (4, 0), (5, 9)], [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (5, 4)])
    assert described(graph) == {
        ((), frozenset({(0, 3, 5, 2, 1, 4)}), NONE, False),
        ((0, 4, 5, 3), NONE, NONE, False), ((1, 2, 5, 4), NONE, NONE, False)}


def test_rings_that_touch_in_a_vertex_share_one_inner_walk() -> None:
    graph = pslg([(0, 0), (2, 1), (2, -1), (-2, 1), (-2, -1)], [(0, 2), (2, 1), (1, 0), (0, 3), (3, 4), (4, 0)])
    assert described(graph) == {
        ((), frozenset({(0, 4, 3, 0, 1, 2)}), NONE, False),
        ((0, 2, 1), NONE, NONE, False), ((0, 3, 4), NONE, NONE, False)}


def test_a_ring_that_touches_the_outer_one_from_inside_joins_its_walk() -> None:
    graph = pslg([*SQUARE, (2, 1), (1, 2)], [*cycle(4), (0, 4), (4, 5), (5, 0)])
    assert described(graph) == {
        ((), frozenset({(0, 3, 2, 1)}), NONE, False), ((0, 4, 5), NONE, NONE, False),
        ((0, 1, 2, 3, 0, 5, 4), NONE, NONE, False)}


def test_dangling_trees_are_walked_around() -> None:
    # A tree from corner 0, one from corner 2 outwards, and one that touches nothing.
    graph = pslg([*SQUARE, (2, 1), (3, 3), (10, 10), (5, 5), (6, 5), (5, 6)],
                 [*cycle(4), (0, 4), (4, 5), (2, 6), (7, 8), (7, 9)])
    assert described(graph) == {
        ((), frozenset({(0, 3, 2, 6, 2, 1)}), NONE, False),
        ((0, 1, 2, 3, 0, 4, 5, 4), frozenset({(7, 8, 7, 9)}), NONE, False)}


def test_isolated_vertices_lie_in_the_face_around_them() -> None:
    graph = pslg([*SQUARE, *box(3, 6), (4, 4), (1, 1), (12, 3), (9, 12), (4, -1)], [*cycle(4), *cycle(4, 4)])
    assert described(graph) == {
        ((), frozenset({(0, 3, 2, 1)}), frozenset({10, 11, 12}), False),
        ((0, 1, 2, 3), frozenset({(4, 7, 6, 5)}), frozenset({9}), False),
        ((4, 5, 6, 7), NONE, frozenset({8}), False)}


def test_a_component_in_a_face_hangs_below_what_lies_under_its_first_vertex() -> None:
    # Under the triangle's first vertex lies another component; under that one, the border.
    graph = pslg([*SQUARE, (3, 6), (5, 5), (4, 7), (2, 2), (5, 3), (6, 2)],
                 [*cycle(4), *cycle(3, 4), (7, 8), (8, 9)])
    assert ((0, 1, 2, 3), frozenset({(4, 6, 5), (7, 8, 9, 8)}), NONE, False) in described(graph)


def test_no_edges_leave_one_face_with_all_vertices() -> None:
    assert described(pslg([(0, 0), (1, 1)], [])) == {((), NONE, frozenset({0, 1}), False)}
    assert described(pslg([], [])) == {((), NONE, NONE, False)}


def test_holes_mark_the_face_around_them() -> None:
    rings = [*cycle(4), *cycle(4, 4)]
    places = [*SQUARE, *box(3, 6)]
    assert [face.is_hole for face in subdivide(pslg(places, rings)).faces] == [False] * 3
    for hole, area in [((4, 4), 72), ((1, 1), 9), ((5, 8), 9), (("17/2", 5), 9)]:
        found = domain_of(pslg(places, rings, [hole, hole]))
        assert len(found.domain) == 1 and area_of(found) == area


def test_a_hole_point_outside_is_refused_with_its_number_and_place() -> None:
    for hole in [(10, 5), (-1, 3), (4, 10), (4, -1), (0, 10)]:
        with pytest.raises(HoleOutside) as caught:
            subdivide(pslg(SQUARE, cycle(4), [(1, 1), hole]))
        assert (caught.value.hole, caught.value.at) == (1, hole)
        assert str(caught.value) == (
            f"hole point 1 at ({hole[0]}, {hole[1]}) lies outside: no bounded face contains it")
        assert isinstance(caught.value, GeometryError)


NOTHING = "the edges enclose nothing: there is no bounded face to mesh"
NO_REST = "every bounded face holds a hole point: nothing is left to mesh"


@pytest.mark.parametrize(("graph", "words"), [
    (pslg([], []), NOTHING), (pslg([(0, 0)], []), NOTHING),
    (pslg(SQUARE, cycle(4)[:3]), NOTHING),
    (pslg(SQUARE, cycle(4), [(1, 1)]), NO_REST),
    (pslg([*SQUARE, *box(3, 6)], [*cycle(4), *cycle(4, 4)], [(1, 1), (4, 4)]), NO_REST)])
def test_an_input_without_a_domain_is_refused(graph: Pslg, words: str) -> None:
    subdivide(graph)
    with pytest.raises(NoDomain, match=f"^{words}$"):
        domain_of(graph)


def test_defects_are_refused_by_subdivide_too() -> None:
    crossed = pslg([(0, 0), (2, 2), (0, 2), (2, 0)], [(0, 1), (2, 3)])
    with pytest.raises(GeometryError, match="cross at"):
        subdivide(crossed)


def test_edges_in_all_directions_are_sorted_around_their_vertex() -> None:
    # Any closed fan of 16 triangles around the origin, spokes given in a scrambled order.
    rim = [(x, y) for x, y in product(range(-2, 3), repeat=2) if max(abs(x), abs(y)) == 2]
    order = [(7 * i) % 16 for i in range(16)]
    spokes = [(0, i + 1) if i % 3 else (i + 1, 0) for i in order]
    neighbours = [(i + 1, j + 1) for (i, p), (j, q) in combinations(enumerate(rim), 2)
                  if abs(p[0] - q[0]) + abs(p[1] - q[1]) == 1]
    found = subdivide(pslg([(0, 0), *rim], spokes + neighbours))
    assert len(found.faces) == 17 and all(len(face.outer or ()) == 3 for face in found.domain)
    assert area_of(found) == 16


# --- laws ---


def area_of(subdivision: Subdivision) -> mpq:
    """Return the area of the domain."""
    return sum((doubled_walk_area(subdivision.pslg, subdivision.half_edges, walk)
                for face in subdivision.domain for walk in face.walks), mpq(0)) / 2


MAPS = {f"map {columns} x {rows}, {seed}": families.grid_map(columns, rows, seed, keep)
        for columns, rows, seed, keep in [(6, 5, 3, Fraction(1, 2)), (6, 5, 4, Fraction(1, 4)), (8, 8, 5, Fraction(1)),
                                          (7, 3, 6, Fraction(0)), (5, 9, 7, Fraction(9, 10))]}
ALL = families.SMALL_PSLGS | MAPS | {f"another {seed}": families.random_pslg(seed, 3) for seed in range(30, 36)}


@pytest.mark.parametrize("name", ALL)
def test_eulers_formula(name: str) -> None:
    graph = ALL[name]
    faces = len(subdivide(graph).faces)
    assert len(graph.vertices) - len(graph.edges) + faces == 1 + components(graph)


@pytest.mark.parametrize("name", [*ALL, *list(families.ALL_SMALL)[::4]])
def test_every_half_edge_is_in_one_walk_and_walks_wind_as_they_should(name: str) -> None:
    found = subdivide((ALL | families.ALL_SMALL)[name])
    used = [h for face in found.faces for walk in face.walks for h in walk]
    assert sorted(used) == list(range(2 * len(found.pslg.edges)))
    on_edges = {v for edge in found.pslg.edges for v in edge}
    isolated = [v for face in found.faces for v in face.isolated]
    assert sorted([*isolated, *on_edges]) == list(range(len(found.pslg.vertices)))
    assert [face.outer is None for face in found.faces] == [True] + [False] * (len(found.faces) - 1)
    for face in found.faces:
        assert all(doubled_walk_area(found.pslg, found.half_edges, walk) <= 0 for walk in face.inner)
        if face.outer:
            assert doubled_walk_area(found.pslg, found.half_edges, face.outer) > 0


@pytest.mark.parametrize("name", ALL)
def test_the_area_of_the_domain_is_that_of_the_oracle(name: str) -> None:
    graph = ALL[name]
    expected = oracle.domain_area(graph.vertices, graph.edges, graph.holes)
    assert area_of(subdivide(graph)) == expected
    for move in (families.mirrored, families.reversed_orientation):
        assert area_of(subdivide(move(graph))) == expected
    turned = families.rotated(graph, Fraction(3, 4))
    assert area_of(subdivide(turned)) == expected


@pytest.mark.parametrize("name", ALL)
def test_two_places_are_in_one_face_when_the_oracle_says_so(name: str) -> None:
    graph = ALL[name]
    plane = oracle.Domain(graph.vertices, graph.edges)
    xs, ys = ([p[axis] for p in graph.vertices] for axis in (0, 1))
    places = [Point(min(xs) + (max(xs) - min(xs)) * mpq(i, 7) + mpq(1, 977),
                    min(ys) + (max(ys) - min(ys)) * mpq(j, 7) + mpq(1, 991))
              for i, j in product(range(7), repeat=2)]
    face_of: dict[object, set[int]] = {}
    for p in places:
        cell = plane.locate(p)
        if cell is None:
            continue
        if cell == plane.root(plane.OUTSIDE):
            with pytest.raises(HoleOutside):
                subdivide(Pslg(graph.vertices, graph.edges, (p,)))
            continue
        faces = subdivide(Pslg(graph.vertices, graph.edges, (p,))).faces
        marked = [i for i, face in enumerate(faces) if face.is_hole]
        assert len(marked) == 1
        face_of.setdefault(cell, set()).add(marked[0])
    assert all(len(marked) == 1 for marked in face_of.values())
    assert len({next(iter(marked)) for marked in face_of.values()}) == len(face_of)


@settings(max_examples=150, deadline=None, derandomize=True)
@given(st.sets(st.tuples(st.integers(0, 4), st.integers(0, 4), st.integers(0, 3)), max_size=60))
def test_parts_of_a_lattice_obey_euler_and_the_oracle(chosen: set[tuple[int, int, int]]) -> None:
    places = list(product(range(5), repeat=2))
    edges = []
    for x, y, kind in sorted(chosen):
        # Diagonals that meet in the even points only, so that a cell has one of them at most.
        dx, dy = [(1, 0), (0, 1), (1, 1), (1, -1)][kind]
        if (x + dx, y + dy) in places and (kind < 2 or (x + y) % 2 == 0):
            edges.append((places.index((x, y)), places.index((x + dx, y + dy))))
    graph = pslg(list(places), edges)
    validate(graph)
    found = subdivide(graph)
    assert len(graph.vertices) - len(edges) + len(found.faces) == 1 + components(graph)
    assert area_of(found) == oracle.domain_area(graph.vertices, edges)


def test_a_long_spiral_and_a_deep_nest_need_no_recursion() -> None:
    spiral = subdivide(families.rectangular_spiral(600))
    assert len(spiral.faces) == 2 and len(spiral.faces[1].outer or ()) == 4802
    rings = 1500
    nest = subdivide(pslg([p for i in range(rings) for p in box(i, 2 * rings - i)],
                          [e for i in range(rings) for e in cycle(4, 4 * i)]))
    assert len(nest.faces) == rings + 1
    assert all(len(face.inner) == 1 for face in nest.faces[:-1])
