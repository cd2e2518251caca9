"""The edges of Q cut at the vertices recorded on them, in order; a record out of place is named."""

import random

import pytest
from constructions import points_of, rings_on_levels, run
from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.edge_chains import Misplaced, chain_sides, edge_chains
from exactmesh.steps.patch_check import recorded_on_edges
from exactmesh.steps.records import Trapezoidation

SQUARE = rings_on_levels([(0, 0), (8, 0), (8, 8), (0, 8)])


def chains_with(recorded):
    """Return the chains of the square with points recorded on its edges, as (edge, share of the way)."""
    chords = Trapezoidation(104, tuple(along(e, share) for e, share in recorded), (), ())
    on_edge = [(e, 104 + i) for i, (e, _) in enumerate(recorded)]
    return edge_chains(SQUARE, on_edge, points_of(SQUARE, chords))


def along(e, share):
    a, b = SQUARE.points[e], SQUARE.points[(e + 1) % 4]
    return Point(a.x + (b.x - a.x) * mpq(share), a.y + (b.y - a.y) * mpq(share))


def test_whole_edges_are_chains_of_two():
    assert chains_with([]) == [[100, 101], [101, 102], [102, 103], [103, 100]]


@pytest.mark.parametrize("e", range(4))
def test_vertices_are_put_in_order_whatever_the_direction(e):
    shares = ["3/4", "1/9", "1/2", "2/3"]
    chain = chains_with([(e, share) for share in shares])[e]
    assert chain == [100 + e, 105, 106, 107, 104, 100 + (e + 1) % 4]


def test_each_ring_is_closed_by_itself():
    two = rings_on_levels([(0, 0), (8, 0), (8, 8)], [(3, 1), (5, 3), (5, 1)])
    assert edge_chains(two, [], points_of(two, Trapezoidation(106, (), (), ()))) == [
        [100, 101], [101, 102], [102, 100], [103, 104], [104, 105], [105, 103]]


@pytest.mark.parametrize("share", ["-1/9", "0", "1", "10/9"])
def test_a_vertex_at_an_end_or_beyond_is_misplaced(share):
    assert chains_with([(1, "1/2"), (2, share)]) == Misplaced(2, 105)


def test_a_vertex_beside_its_edge_is_misplaced():
    chords = Trapezoidation(104, (Point(mpq(8) + mpq(1, 10**30), mpq(1)),), (), ())
    assert edge_chains(SQUARE, [(1, 104)], points_of(SQUARE, chords)) == Misplaced(1, 104)


def test_a_vertex_recorded_on_the_wrong_edge_is_misplaced():
    chords = Trapezoidation(104, (along(1, "1/2"),), (), ())
    assert edge_chains(SQUARE, [(0, 104)], points_of(SQUARE, chords)) == Misplaced(0, 104)


def test_the_sides_of_chains():
    assert chain_sides([[1, 5, 2], [2, 1]]).tolist() == [[1, 5], [5, 2], [2, 1]]


@pytest.mark.parametrize("name", ["hall", "turned comb", "random pslg 3"])
def test_every_record_of_a_run_is_in_one_chain_whatever_the_order(name):
    made = run(name).construction
    recorded = recorded_on_edges(made.trapezoidation, made.interior)
    chains = edge_chains(made.offset, recorded, made.points)
    assert sorted(v for chain in chains for v in chain[1:-1]) == sorted(v for _, v in recorded)
    random.Random(1).shuffle(recorded)
    assert edge_chains(made.offset, recorded, made.points) == chains
