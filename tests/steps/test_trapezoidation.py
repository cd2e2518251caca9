"""The trapezoidation by hand, by brute force from its definition, and its laws."""

import random
from collections import Counter
from fractions import Fraction
from itertools import pairwise

import families
import oracle
import pytest
from constructions import graph, offset_of, points_of, rings_on_levels, run
from gmpy2 import mpq

from exactmesh.planar import status
from exactmesh.steps.constants import LEVEL
from exactmesh.steps.trapezoidation import trapezoidate
from exactmesh.steps.trapezoidation_check import check_clearance, check_tiling, check_touch

G = Fraction(29, 125)
NAMES = [*sorted(families.ALL_SMALL | families.SMALL_PSLGS), "hall"]


def described(q, chords):
    """Return the trapezoids as (low, high, legs, corners and T-vertices by abscissa), in no order."""
    points = points_of(q, chords)

    def xs(vertices):
        return tuple(points[v].x for v in vertices)

    return Counter((z.low, z.high, z.left, z.right, xs((z.bl, *z.bottom, z.br)), xs((z.tl, *z.top, z.tr)))
                   for z in chords.trapezoids)


def by_definition(q):
    """Return what `described` returns, from the definition, slab by slab.

    In each slab between neighbouring levels with vertices the edges that cross it pair up from left to right. Cells of
    two slabs are one trapezoid when they have the same legs and no vertex lies between these on the common level.
    """
    following = q.successors()
    rows = {level: sorted(oracle.exact(x) for x, other in zip(q.x, q.level, strict=True) if other == level)
            for level in sorted(set(q.level))}

    def x_at(e, level):
        a, b = e, following[e]
        share = Fraction(level - q.level[a], q.level[b] - q.level[a])
        return oracle.exact(q.x[a]) + share * (oracle.exact(q.x[b]) - oracle.exact(q.x[a]))

    done, growing = [], {}
    for low, high in pairwise(rows):
        crossing = [e for e in range(len(q.x)) if min(q.level[e], q.level[following[e]]) <= low
                    and max(q.level[e], q.level[following[e]]) >= high]
        crossing.sort(key=lambda e: x_at(e, low) + x_at(e, high))
        here = {}
        for legs in zip(crossing[::2], crossing[1::2], strict=True):
            is_cut = legs not in growing or any(x_at(legs[0], low) <= x <= x_at(legs[1], low) for x in rows[low])
            here[legs] = low if is_cut else growing.pop(legs)
        done += [(start, low, legs) for legs, start in growing.items()]
        growing = here
    done += [(start, max(rows), legs) for legs, start in growing.items()]

    def side(level, legs):
        left, right = (x_at(e, level) for e in legs)
        return (left, *(x for x in rows[level] if left < x < right), right)

    return Counter((low, high, *legs, side(low, legs), side(high, legs)) for low, high, legs in done)


# --- hand cases ---


def test_a_rectangle_is_one_trapezoid():
    q = rings_on_levels([(0, 0), (5, 0), (5, 3), (0, 3)])
    chords = trapezoidate(q)
    (z,) = chords.trapezoids
    assert (z.low, z.high, z.left, z.right) == (0, 3, 3, 1)
    assert (z.bl, z.br, z.tr, z.tl) == (100, 101, 102, 103) and z.bottom == z.top == () and chords.points == ()


def test_a_triangle_on_its_tip_has_an_apex_below():
    chords = trapezoidate(rings_on_levels([(2, 0), (4, 2), (0, 2)]))
    (z,) = chords.trapezoids
    assert z.bl == z.br == 100 and (z.tl, z.tr) == (102, 101)


def test_an_l_shape_is_cut_at_its_reflex_corner():
    q = rings_on_levels([(0, 0), (6, 0), (6, 2), (3, 2), (3, 5), (0, 5)])
    chords = trapezoidate(q)
    assert chords.points == ((0, mpq(5, 2) * LEVEL),) and chords.edge == (5,)
    low, high = chords.trapezoids
    assert (low.tl, low.top, low.tr) == (106, (103,), 102) and (high.bl, high.bottom, high.br) == (106, (), 103)


def test_a_horizontal_edge_in_a_side_gives_two_t_vertices():
    # A block hangs from the ceiling.
    q = rings_on_levels([(0, 0), (9, 0), (9, 6), (5, 6), (5, 3), (4, 3), (4, 6), (0, 6)])
    z = trapezoidate(q).trapezoids[0]
    assert z.top == (105, 104) and z.high == 3


def test_teeth_on_one_level_share_a_chord():
    q = rings_on_levels([(0, 0), (9, 0), (9, 6), (7, 6), (6, 3), (5, 6), (4, 6), (3, 3), (2, 6), (0, 6)])
    chords = trapezoidate(q)
    assert len(chords.points) == 2 and len(chords.trapezoids) == 4
    assert chords.trapezoids[0].top == (107, 104)


def test_a_hole_splits_and_joins():
    q = rings_on_levels([(0, 0), (9, 0), (9, 9), (0, 9)], [(3, 3), (3, 6), (6, 6), (6, 3)])
    chords = trapezoidate(q)
    assert len(chords.trapezoids) == 4 and len(chords.points) == 4 and sorted(chords.edge) == [1, 1, 3, 3]


def test_a_chord_passes_where_no_vertex_touches_it():
    # The vertex at (20, 3) is outside the left room, which goes on through level 3.
    q = rings_on_levels([(0, 0), (2, 0), (2, 6), (0, 6)], [(10, 0), (20, 3), (10, 6)])
    chords = trapezoidate(q)
    assert len(chords.trapezoids) == 3 and len(chords.points) == 1


def test_nothing_has_no_trapezoids():
    assert trapezoidate(rings_on_levels()).trapezoids == ()


# --- brute force ---


def lattice_polygon(n, seed, kind):
    """Return a random simple polygon as a ring on levels, squeezed so that many vertices share one."""
    pslg = families.random_simple_polygon(n, seed, kind)
    return rings_on_levels([(p.x, int(p.y)) for p in pslg.vertices])


@pytest.mark.parametrize("kind", families.KINDS)
@pytest.mark.parametrize("n", [4, 7, 12, 25, 40])
def test_random_polygons_agree_with_the_definition(kind, n):
    for seed in range(6):
        q = lattice_polygon(n, seed, kind)
        chords = trapezoidate(q)
        assert described(q, chords) == by_definition(q)
        assert check_tiling(q, chords, points_of(q, chords)).holds and check_touch(q, chords).holds


def steps_and_teeth(seed):
    """Return a mountain range over a lake, both on few levels: many ties, horizontal edges, straight vertices."""
    source = random.Random(seed)
    count = source.randint(2, 14)
    upper = [(x, source.randint(6, 9)) for x in range(count, -1, -1)]
    lower = [(x, source.randint(0, 4)) for x in range(count + 1)]
    rings = [lower + upper]
    if source.random() < 0.7:
        # A hole between the levels 4 and 6, clockwise, that touches neither side.
        left, right = Fraction(1, 3), count - Fraction(1, 3)
        rings = [[(x, y if y < 5 else y + 4) for x, y in rings[0]],
                 [(left, 6), (left + Fraction(1, 7), 8), (right, 8), (right, 6), ((left + right) / 2, 7)]]
    return rings_on_levels(*rings)


@pytest.mark.parametrize("seed", range(60))
def test_ties_and_holes_agree_with_the_definition(seed):
    q = steps_and_teeth(seed)
    chords = trapezoidate(q)
    assert described(q, chords) == by_definition(q)
    assert check_tiling(q, chords, points_of(q, chords)).holds


@pytest.mark.parametrize("name", NAMES)
def test_offsets_agree_with_the_definition(name):
    q = run(name).construction.offset
    chords = run(name).construction.trapezoidation
    if q.rings:
        assert described(q, chords) == by_definition(q)
    assert check_tiling(q, chords, run(name).construction.points).holds
    assert check_touch(q, chords).holds and check_clearance(q, chords, run(name).construction.points).holds


# --- laws ---


@pytest.mark.parametrize("seed", range(20))
def test_moving_by_whole_levels_moves_the_trapezoids(seed):
    q = steps_and_teeth(seed)
    moved = rings_on_levels(*([(x + 17, level - 1000) for x, level in zip(q.x, q.level, strict=True)][start:end]
                              for start, end in q.rings))
    first, second = trapezoidate(q), trapezoidate(moved)
    assert second.edge == first.edge
    assert second.points == tuple((p.x + 17, p.y - 1000 * LEVEL) for p in first.points)
    assert [(z.low + 1000, z.high + 1000, z.bl, z.br, z.tr, z.tl, z.bottom, z.top) for z in second.trapezoids] == [
        (z.low, z.high, z.bl, z.br, z.tr, z.tl, z.bottom, z.top) for z in first.trapezoids]


@pytest.mark.parametrize("seed", range(20))
def test_reflections_reflect_the_trapezoids(seed):
    q = steps_and_teeth(seed)
    found = described(q, trapezoidate(q))

    def reflected(sx, sy):
        rings = [[(sx * x, sy * y) for x, y in zip(q.x[a:b], q.level[a:b], strict=True)] for a, b in q.rings]
        r = rings_on_levels(*([*ring[:1], *ring[:0:-1]] for ring in rings))
        return described(r, trapezoidate(r))

    def shape(counter):
        return Counter((low, high, bottom, top) for low, high, _, _, bottom, top in counter.elements())

    def turned(row):
        return tuple(-x for x in reversed(row))

    assert shape(reflected(-1, 1)) == Counter(
        (low, high, turned(bottom), turned(top)) for low, high, bottom, top in shape(found).elements())
    assert shape(reflected(1, -1)) == Counter(
        (-high, -low, top, bottom) for low, high, bottom, top in shape(found).elements())


@pytest.mark.parametrize("seed", range(20))
def test_where_a_ring_starts_does_not_matter(seed):
    q = steps_and_teeth(seed)
    rings = [list(zip(q.x[a:b], q.level[a:b], strict=True)) for a, b in q.rings]
    turned = rings_on_levels(*(ring[1:] + ring[:1] for ring in rings[::-1]))

    def shape(q):
        return Counter((low, high, bottom, top) for low, high, _, _, bottom, top in
                       described(q, trapezoidate(q)).elements())

    assert shape(turned) == shape(q)


@pytest.mark.parametrize("name", ["comb 12 long floor", "hall", "random pslg 2", "star 24"])
def test_each_chord_end_is_recorded_once(name):
    chords = run(name).construction.trapezoidation
    assert len(set(zip(chords.edge, chords.points, strict=True))) == len(chords.points)
    used = {v for z in chords.trapezoids for v in (z.bl, z.br, z.tr, z.tl)}
    assert used >= set(range(chords.first, chords.first + len(chords.points)))


def test_areas_add_up():
    q = offset_of(graph([(0, 0), (20, 0), (20, 9), (9, 9), (9, 3), (0, 9)]))
    chords = trapezoidate(q)
    points = points_of(q, chords)
    areas = [oracle.polygon_area([points[v] for v in (z.bl, z.br, z.tr, z.tl)]) for z in chords.trapezoids]
    assert min(areas) > 0 and sum(areas) == oracle.polygon_area(q.points)


@pytest.mark.parametrize("longest", [2, 3, 5])
@pytest.mark.parametrize("kind", ["growth", "star", "partition", "comb"])
def test_the_blocks_of_the_status_do_not_matter(kind, longest, monkeypatch):
    pslg = families.comb(40) if kind == "comb" else families.random_simple_polygon(120, 5, kind)
    q = offset_of(pslg)
    whole = trapezoidate(q)
    monkeypatch.setattr(status, "_LONGEST", longest)
    assert trapezoidate(q) == whole


@pytest.mark.parametrize("size", [10**20, 10**400])
def test_levels_and_abscissae_beyond_floats_are_exact(size):
    q = rings_on_levels([(0, 0), (9, 0), (9, size + 4), (6, size + 4), (5, size), (4, size + 4), (0, size + 4)])
    small = rings_on_levels([(0, 0), (9, 0), (9, 8), (6, 8), (5, 4), (4, 8), (0, 8)])
    fields = [(z.left, z.right, z.bl, z.br, z.tr, z.tl, z.bottom, z.top) for z in trapezoidate(small).trapezoids]
    assert [(z.left, z.right, z.bl, z.br, z.tr, z.tl, z.bottom, z.top) for z in trapezoidate(q).trapezoids] == fields
    assert check_tiling(q, trapezoidate(q), points_of(q, trapezoidate(q))).holds
    far = rings_on_levels([(size * x, y) for x, y in ((0, 0), (9, 0), (9, 8), (6, 8), (5, 4), (4, 8), (0, 8))])
    assert [z.top for z in trapezoidate(far).trapezoids] == [z.top for z in trapezoidate(small).trapezoids]
