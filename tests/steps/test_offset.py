"""The offset of every kind of corner by hand, by brute force from the definition, and its laws."""

from collections import Counter
from fractions import Fraction
from itertools import pairwise

import families
import oracle
import pytest
from constructions import HALL, graph, offset_of, unit_shape
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.constants import FLAT, LEVEL, WIDE
from exactmesh.steps.offset import offset
from exactmesh.steps.offset_check import check_nesting, check_separation, check_thickness
from exactmesh.steps.shape import shape_of

G = Fraction(29, 125)
A, B = Fraction(3, 40), Fraction(817, 2000)
HALF = Fraction(1, 2)
# The vertices of K1 counter-clockwise.
BODY = [(B, -G / 2), (B, G / 2), (A, 3 * G / 2), (-A, 3 * G / 2), (-B, G / 2), (-B, -G / 2),
        (-A, -3 * G / 2), (A, -3 * G / 2)]
BOX = [(0, 0), (10, 0), (10, 10), (0, 10)]


def unit(pslg):
    """Return a PSLG in units of its mfs."""
    return families.scaled(pslg, 1 / shape_of(domain_of(pslg), minimum_feature_size(pslg).squared).unit)


INPUTS = {name: unit(pslg) for name, pslg in (families.ALL_SMALL | families.SMALL_PSLGS | {"hall": HALL}).items()
          if len(pslg.vertices) <= 30 and name != "triangle"}


def placed(q):
    """Return the vertices of Q as (x, level)."""
    return list(zip(q.x, q.level, strict=True))


def rings(q):
    """Return the rings as lists of (x, level), each from its least vertex."""
    found = []
    for start, end in q.rings:
        ring = placed(q)[start:end]
        first = ring.index(min(ring))
        found.append(tuple(ring[first:] + ring[:first]))
    return sorted(found)


# --- hand cases ---


def test_a_square():
    q = offset_of(graph(BOX))
    # 10 = 43.1 g. The lines y = 3g/2 and y = 10 - 3g/2 are on the levels 1 and, after snapping, 41.
    assert placed(q) == [(WIDE, 1), (10 - WIDE, 1), (10 - WIDE, 41), (WIDE, 41)]
    assert q.source == (0, 2, 4, 6) and q.corner == (0, 2, 4, 6) and q.rings == ((0, 4),) and q.first == 4
    assert q.points[0] == (WIDE, mpq(3, 2) * LEVEL)


def test_the_cap_of_a_reflex_corner():
    # An L: its reflex corner (5, 5) has the interior below one edge and to the left of the other.
    q = offset_of(graph([(0, 0), (10, 0), (10, 5), (5, 5), (5, 10), (0, 10)]))
    cap = [p for p, corner in zip(placed(q), q.corner, strict=True) if corner == 6]
    # 5 = 21.55 g, so the centre goes to 22 g. Clockwise from the lower side of K1 to its left side.
    assert cap == [(5 - FLAT, 22 - 2), (5 - WIDE, 22 - 1)]
    assert [q.source[k] for k, corner in enumerate(q.corner) if corner == 6] == [-1, 6]


def test_a_slit_end_gets_half_of_the_body():
    # A wall from the middle of the floor upwards: seen from above its end turns by 360 degrees.
    q = offset_of(graph([(0, 0), (5, 0), (10, 0), (10, 10), (0, 10), (5, 4)],
                        [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 5)]))
    cap = [p for p, corner in zip(placed(q), q.corner, strict=True) if corner == 11]
    # 4 = 17.24 g: the centre goes to 17 g; half of K1, from its right side over the top to its left side.
    assert Counter(cap) == Counter([(5 + WIDE, 17), (5 + FLAT, 18), (5 - FLAT, 18), (5 - WIDE, 17)])


def test_a_slanted_slit_end_gets_five_vertices():
    q = offset_of(graph([*BOX, (3, 3), (6, 5)], [*graph(BOX).edges, (4, 5)]))
    assert sorted(Counter(q.corner).values()) == [1, 1, 1, 1, 5, 5]


def test_an_isolated_vertex_gets_the_whole_body_clockwise():
    q = offset_of(graph([*BOX, (3, 6)], graph(BOX).edges))
    # 6 = 25.86 g: the centre goes to 26 g.
    ring = [(p, k) for p, k, corner in zip(placed(q), range(12), q.corner, strict=True) if corner == -5]
    assert [p for p, _ in ring] == [
        (3 + FLAT, 24), (3 - FLAT, 24), (3 - WIDE, 25), (3 - WIDE, 26), (3 - FLAT, 27), (3 + FLAT, 27),
        (3 + WIDE, 26), (3 + WIDE, 25)]
    assert all(q.source[k] == -1 for _, k in ring) and q.rings[1] == (4, 12)


def test_a_straight_vertex_gets_one_vertex():
    q = offset_of(graph([(0, 0), (3, 0), (6, 3), (9, 6), (0, 6)]))
    at_floor = [p for p, corner in zip(placed(q), q.corner, strict=True) if corner == 4]
    # Up and to the left of a slope of 45 degrees K1 has the vertex (-b, g/2); 3 = 12.93 g.
    assert at_floor == [(6 - WIDE, 13)]


def test_a_shallow_reflex_corner_gets_one_vertex():
    q = offset_of(graph([(0, 0), (10, 0), (10, 5), (5, "49/10"), (0, 5)]))
    assert Counter(q.corner)[6] == 2
    bent = offset_of(graph([(0, 0), (10, 0), (10, 8), (5, 4), (2, 1)]))
    assert Counter(bent.corner)[6] == 1


@pytest.mark.parametrize("half_levels", [1, 3, 41, 101])
def test_caps_and_convex_corners_agree_on_ties(half_levels):
    # A horizontal edge half way between two multiples of g, from a reflex to a convex corner: it stays horizontal.
    y = Fraction(half_levels, 2) * G
    q = offset_of(graph([(0, y - 5), (10, y - 5), (10, y + 5), (5, y + 5), (5, y), (0, y)]))
    levels = {corner: level for (x, level), corner in zip(placed(q), q.corner, strict=True) if x < 5}
    at_reflex = [level for (x, level), corner in zip(placed(q), q.corner, strict=True) if corner == 8]
    # The edge's level is its height less 3g/2, rounded up: ties go up for both.
    assert levels[10] == min(at_reflex) == (half_levels + 1) // 2 - 2


@pytest.mark.parametrize("half_levels", [1, 3, 41, 101])
def test_isolated_vertices_on_ties_go_up(half_levels):
    y = Fraction(half_levels, 2) * G
    q = offset_of(graph([*((x, y + 2 * h - 10) for x, h in BOX), (3, y)], graph(BOX).edges))
    assert max(level for (_, level), corner in zip(placed(q), q.corner, strict=True) if corner == -5) == (
        (half_levels + 1) // 2 + 1)


def test_a_bare_triangle_has_no_offset():
    assert offset_of(graph([(0, 0), (9, 0), (0, 9)])).rings == ()


# --- brute force ---


def _floor(value):
    return value.numerator // value.denominator


def _cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1]


def _extreme(direction):
    """Return the vertices of K1 farthest in a direction, by number."""
    values = [_dot(k, direction) for k in BODY]
    return [k for k, value in enumerate(values) if value == max(values)]


def _between(n0, n1):
    """Return a direction in each open part into which the normals of K1 cut the clockwise turn from n0 to n1."""
    normals = [(BODY[k][1] - BODY[k - 1][1], BODY[k - 1][0] - BODY[k][0]) for k in range(8)]

    def is_inside(d):
        """Return whether d lies strictly within the clockwise turn from n0 to n1, 180 degrees at most."""
        return _cross(n0, d) < 0 and (_cross(d, n1) < 0 or (_cross(n0, n1) == 0))

    inside = [d for d in normals if is_inside(d)]
    # Clockwise by the angle from n0, all below 180 degrees: a comes first when b is to the right of it.
    inside.sort(key=lambda d: Fraction(-_dot(n0, d), -_cross(n0, d)))
    stops = [n0, *inside, n1]
    return [(a[0] * _size(b) + b[0] * _size(a), a[1] * _size(b) + b[1] * _size(a))
            for a, b in pairwise(stops)]


def _size(d):
    return abs(d[0]) + abs(d[1])


def corner_by_definition(before, p, after):
    """Return the vertices of Q of a corner, as (x, level), in no order."""
    e0, e1 = (p[0] - before[0], p[1] - before[1]), (after[0] - p[0], after[1] - p[1])
    n0, n1 = (-e0[1], e0[0]), (-e1[1], e1[0])
    common = [k for k in _extreme(n0) if k in _extreme(n1)]
    turn = _cross(e0, e1)
    centre = _floor(p[1] / G + HALF)
    if turn < 0 or (turn == 0 and _dot(e0, e1) < 0):
        numbers = {k for d in _between(n0, n1) for k in _extreme(d)}
    elif common:
        numbers = {common[0]}
    else:
        # The point at the distances of K1's supporting lines from both edges, as a linear system.
        r0 = _dot(n0, p) + _dot(n0, BODY[_extreme(n0)[0]])
        r1 = _dot(n1, p) + _dot(n1, BODY[_extreme(n1)[0]])
        det = _cross(n0, n1)
        x, y = (r0 * n1[1] - r1 * n0[1]) / det, (n0[0] * r1 - n1[0] * r0) / det
        return {(x, _floor(y / G))}
    return {(p[0] + BODY[k][0], centre + int(BODY[k][1] / G - HALF)) for k in numbers}


@pytest.mark.parametrize("name", INPUTS)
def test_every_corner_agrees_with_the_definition(name):
    shape = unit_shape(INPUTS[name])
    q = offset(shape)
    points = [oracle.place(p) for p in shape.points]
    found = {}
    for p, corner in zip(placed(q), q.corner, strict=True):
        found.setdefault(corner, []).append(p)
    for walk in (walk for face in shape.faces for walk in face):
        for incoming, outgoing in zip((walk[-1], *walk[:-1]), walk, strict=True):
            before, p, after = (points[shape.origin[h]] for h in (incoming, outgoing, outgoing ^ 1))
            here = found.pop(outgoing)
            assert len(here) == len(set(here)) and set(here) == corner_by_definition(before, p, after)
    assert all(corner < 0 and len(here) == 8 for corner, here in found.items())


# --- laws ---


@pytest.mark.parametrize("name", INPUTS)
def test_edges_run_from_the_last_vertex_of_a_corner_to_the_first_of_the_next(name):
    shape = unit_shape(INPUTS[name])
    q = offset(shape)
    following = q.successors()
    assert len(q.rings) == sum(map(len, shape.faces)) + sum(map(len, shape.isolated))
    assert sorted(h for h in q.source if h >= 0) == sorted(h for face in shape.faces for walk in face for h in walk)
    for k, h in enumerate(q.source):
        if h < 0:
            assert q.corner[following[k]] == q.corner[k]
        else:
            assert q.corner[k] == h and shape.origin[q.corner[following[k]]] == shape.origin[h ^ 1]
    assert max(Counter(c for c in q.corner if c >= 0).values()) <= 5
    assert all(p == (x, (level + HALF) * G) for p, (x, level) in zip(q.points, placed(q), strict=True))


@pytest.mark.parametrize("name", INPUTS)
def test_every_offset_passes_its_checkers(name):
    shape = unit_shape(INPUTS[name])
    q = offset(shape)
    assert all(verdict.holds for verdict in (*check_thickness(shape, q), check_separation(q), check_nesting(shape, q)))


@settings(max_examples=60, derandomize=True, deadline=None)
@given(st.sampled_from(sorted(INPUTS)), st.fractions(max_denominator=1000), st.integers(-10**6, 10**6))
def test_moving_by_whole_levels_moves_q_rigidly(name, dx, levels):
    q = offset_of(INPUTS[name])
    moved = offset_of(families.translated(INPUTS[name], dx, levels * G))
    assert placed(moved) == [(x + mpq(dx), level + levels) for x, level in placed(q)]
    assert (moved.corner, moved.source, moved.rings) == (q.corner, q.source, q.rings)


@pytest.mark.parametrize("name", INPUTS)
def test_order_and_orientation_of_the_input_do_not_matter(name):
    pslg = INPUTS[name]
    assert rings(offset_of(families.reversed_orientation(pslg))) == rings(offset_of(pslg))
    assert rings(offset_of(families.with_start(pslg, 3))) == rings(offset_of(pslg))


def _has_straight_corner_along_the_body(shape):
    """Return whether a vertex of 180 degrees has edges normal to an edge of K1, so that either end would do."""
    slopes = {(abs(BODY[k][0] - BODY[k - 1][0]), abs(BODY[k][1] - BODY[k - 1][1])) for k in range(8)}
    for walk in (walk for face in shape.faces for walk in face):
        for incoming, outgoing in zip((walk[-1], *walk[:-1]), walk, strict=True):
            a, p, b = (shape.points[shape.origin[h]] for h in (incoming, outgoing, outgoing ^ 1))
            d = (abs(p.x - a.x), abs(p.y - a.y))
            if (p.x - a.x) * (b.y - p.y) == (p.y - a.y) * (b.x - p.x) and any(_cross(d, s) == 0 for s in slopes):
                return True
    return False


@pytest.mark.parametrize("name", INPUTS)
def test_a_reflection_in_the_y_axis_reflects_q(name):
    shape = unit_shape(INPUTS[name])
    if _has_straight_corner_along_the_body(shape):
        # Either of two vertices of K1 will do there, and the fixed order prefers the same one in both.
        return
    reflected = offset_of(families.mirrored(INPUTS[name]))
    assert sorted((-x, level) for x, level in placed(reflected)) == sorted(placed(offset(shape)))


def test_every_face_has_its_own_rings():
    two = graph([(0, 0), (9, 0), (18, 0), (18, 9), (9, 9), (0, 9)],
                [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)])
    q = offset_of(two)
    assert len(q.rings) == 2 and len(q.x) == 8
    assert rings(q) == sorted(rings(offset_of(graph([(0, 0), (9, 0), (9, 9), (0, 9)])))
                              + rings(offset_of(graph([(9, 0), (18, 0), (18, 9), (9, 9)]))))


def test_a_hole_is_offset_into_the_face():
    hole = Pslg(graph([*BOX, (4, 4), (6, 4), (6, 6), (4, 6)]).vertices,
                (*graph(BOX).edges, (4, 5), (5, 6), (6, 7), (7, 4)), graph([(5, 5), (0, 0), (1, 0)]).vertices[:1])
    q = offset_of(hole)
    (outer, inner) = q.rings
    xs = q.x[slice(*inner)]
    assert outer == (0, 4) and (min(xs), max(xs)) == (4 - WIDE, 6 + WIDE) and len(xs) == 8
