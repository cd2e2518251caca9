"""Half-edges: topology over indices; the coordinates below only serve to sort the edges around a vertex."""

from math import atan2

import families
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.planar.half_edges import HalfEdges, link, outgoing, walks
from exactmesh.planar.pslg import Edge, Pslg

TRIANGLE: list[Edge] = [(0, 1), (1, 2), (2, 0)]


def linked(pslg: Pslg) -> HalfEdges:
    """Return the half-edges of a PSLG, sorted around each vertex by floating-point angles."""
    rotation = outgoing(pslg.edges, len(pslg.vertices))
    at = [(float(p.x), float(p.y)) for p in pslg.vertices]

    def angle(h: int) -> float:
        (ax, ay), (bx, by) = (at[v] for v in pslg.edges[h >> 1][:: -1 if h & 1 else 1])
        return atan2(by - ay, bx - ax)

    return link(pslg.edges, [sorted(leaving, key=angle) for leaving in rotation])


def test_a_triangle_has_two_walks_one_on_either_side() -> None:
    half_edges = link(TRIANGLE, outgoing(TRIANGLE, 3))
    assert half_edges.origin == (0, 1, 1, 2, 2, 0)
    assert [half_edges.target(h) for h in range(6)] == [1, 0, 2, 1, 0, 2]
    assert walks(half_edges) == [(0, 2, 4), (1, 5, 3)]


def test_one_edge_has_one_walk_around_it_and_no_edge_none() -> None:
    assert walks(link([(3, 1)], outgoing([(3, 1)], 4))) == [(0, 1)]
    assert walks(link([], outgoing([], 5))) == []


def test_a_path_is_walked_forth_and_back() -> None:
    path = [(0, 1), (1, 2), (2, 3)]
    assert walks(link(path, outgoing(path, 4))) == [(0, 2, 4, 5, 3, 1)]


def test_outgoing_half_edges_are_listed_by_index() -> None:
    assert outgoing([(0, 1), (2, 1), (1, 0)], 4) == [[0, 5], [1, 3, 4], [2], []]


def test_the_rotation_decides_the_walks() -> None:
    # Three edges from 0 to 1, 2, 3 and the ring around them; a face lies between two neighbouring spokes.
    edges = [(0, 1), (0, 2), (0, 3), (1, 2), (2, 3), (3, 1)]
    rotation = [[0, 2, 4], [1, 11, 6], [3, 7, 8], [5, 9, 10]]
    found = {frozenset(walk) for walk in walks(link(edges, rotation))}
    assert found == {frozenset({0, 6, 3}), frozenset({2, 8, 5}), frozenset({4, 10, 1}), frozenset({7, 11, 9})}


@pytest.mark.parametrize("name", [*families.SMALL_PSLGS, "comb 5", "star 12", "growth 50"])
def test_walks_are_the_cycles_of_next_and_turn_at_shared_vertices(name: str) -> None:
    pslg = (families.SMALL_PSLGS | families.ALL_SMALL)[name]
    half_edges = linked(pslg)
    count = 2 * len(pslg.edges)
    assert sorted(half_edges.next) == list(range(count))
    for h in range(count):
        assert half_edges.target(h) == half_edges.origin[half_edges.next[h]]
        assert half_edges.target(h ^ 1) == half_edges.origin[h]
    found = walks(half_edges)
    assert sorted(h for walk in found for h in walk) == list(range(count))
    for walk in found:
        assert walk[0] == min(walk)
        assert all(half_edges.next[walk[i - 1]] == h for i, h in enumerate(walk))


@settings(max_examples=100, deadline=None, derandomize=True)
@given(st.integers(2, 8), st.randoms(use_true_random=False))
def test_any_rotation_gives_a_surface_of_even_euler_characteristic(n: int, source) -> None:  # type: ignore[no-untyped-def]
    edges = [(u, v) for u in range(n) for v in range(u + 1, n)]
    rotation = outgoing(edges, n)
    for leaving in rotation:
        source.shuffle(leaving)
    faces = len(walks(link(edges, rotation)))
    assert (n - len(edges) + faces) % 2 == 0 and n - len(edges) + faces <= 2


def test_a_walk_of_a_hundred_thousand_half_edges_needs_no_recursion() -> None:
    path = [(i, i + 1) for i in range(50_000)]
    (walk,) = walks(link(path, outgoing(path, 50_001)))
    assert len(walk) == 100_000
