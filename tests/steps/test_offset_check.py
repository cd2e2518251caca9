"""The checker of the offset accepts good results and names the clause a harmed one breaks."""

from dataclasses import replace
from itertools import product

import pytest
from constructions import HALL, clauses_of, graph, run, unit_shape
from gmpy2 import mpq
from recorded import recorded

from exactmesh.geometry.columns import Columns
from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.point import Point, cross, dot
from exactmesh.planar.pslg import Pslg
from exactmesh.steps import offset_check
from exactmesh.steps.constants import FLAT, LEVEL, SEPARATION
from exactmesh.steps.offset import offset
from exactmesh.steps.offset_check import check_nesting, check_separation, check_thickness
from exactmesh.steps.records import Offset

FAMILIES = ["hall", "triangle", "comb 5", "turned comb", "random pslg 1", "random pslg 5", "map 1", "star 12",
            "reflex notch 1e-6", "convex spike 1e-6", "sliver with bends", "square and two points", "two squares"]
L_SHAPE = graph([(0, 0), (10, 0), (10, 5), (5, 5), (5, 10), (0, 10)])
TWO_ROOMS = graph([(0, 0), (9, 0), (18, 0), (18, 9), (9, 9), (0, 9)],
                  [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0), (1, 4)])
HOLED = Pslg(graph([(0, 0), (20, 0), (20, 10), (0, 10), (4, 4), (6, 4), (6, 6), (4, 6), (12, 5), (15, 5)]).vertices,
             (*((i, (i + 1) % 4) for i in range(4)), (4, 5), (5, 6), (6, 7), (7, 4)),
             (graph([(5, 5), (5, 6), (6, 6)]).vertices[0],))


# --- tools: Q as rings of (x, level, corner, source) ---


def rings_of(q):
    rows = list(zip(q.x, q.level, q.corner, q.source, strict=True))
    return [rows[start:end] for start, end in q.rings]


def rebuilt(q, rings):
    """Return an offset made of these rings; points are those of abscissae and levels."""
    rows = [row for ring in rings for row in ring]
    ends = [sum(map(len, rings[: i + 1])) for i in range(len(rings))]
    x, level, corner, source = (tuple(column) for column in zip(*rows, strict=True)) if rows else ((), (), (), ())
    points = tuple(Point(a, (j + mpq(1, 2)) * LEVEL) for a, j in zip(x, level, strict=True))
    return replace(q, x=x, level=level, corner=corner, source=source, points=points,
                   rings=tuple(zip([0, *ends], ends, strict=False)))


def labelled(ring, other):
    """Return the places of one ring with the corners and sources of another: each corner once, the last one more
    often."""
    labels = list({corner: (corner, source) for _, _, corner, source in other}.values())
    return [(x, level, *labels[min(i, len(labels) - 1)]) for i, (x, level, _, _) in enumerate(ring)]


def moved(q, k, dx=0, levels=0):
    """Return Q with vertex k moved along or between levels, consistently."""
    rings = rings_of(q)
    flat = [row for ring in rings for row in ring]
    x, level, corner, source = flat[k]
    flat[k] = (x + mpq(dx), level + levels, corner, source)
    return rebuilt(q, [flat[start:end] for start, end in q.rings])


def place(q, k, point):
    """Return Q with the point of vertex k alone replaced."""
    return replace(q, points=(*q.points[:k], point, *q.points[k + 1:]))


def off_level(q):
    return place(q, 2, Point(q.points[2].x, q.points[2].y + mpq(1, 10**20)))


def off_abscissa(q):
    return place(q, 2, Point(q.points[2].x - mpq(1, 10**20), q.points[2].y))


def reversed_rings(q):
    return rebuilt(q, [ring[::-1] for ring in rings_of(q)])


def turned_labels(q):
    """Rotate the labels of the first ring against its places."""
    first, *others = rings_of(q)
    return rebuilt(q, [labelled(first, first[1:] + first[:1]), *others])


def one_level_lower(q):
    """Move everything down by one level: at the floor Q comes too near."""
    return rebuilt(q, [[(x, level - 1, c, s) for x, level, c, s in ring] for ring in rings_of(q)])


def pushed_out(q):
    """Move the lower right vertex of Q below the floor."""
    return moved(q, 1, levels=-4)


def all_outside(q):
    """Move Q away to the left, whole."""
    return rebuilt(q, [[(x - 100, level, c, s) for x, level, c, s in ring] for ring in rings_of(q)])


def inside_the_hole(q):
    """Move the ring around the hole to a small place inside it: it still crosses nothing."""
    outer, ring, *others = rings_of(q)
    return rebuilt(q, [outer, [(5 + (x - 5) / 4, 21 + (level - 21) // 4, c, s) for x, level, c, s in ring], *others])


def crossed(q):
    """Exchange the places of two neighbours, so that the ring crosses itself."""
    first, *others = rings_of(q)
    a, b = first[1], first[2]
    return rebuilt(q, [[first[0], (*b[:2], *a[2:]), (*a[:2], *b[2:]), *first[3:]], *others])


def flat_cap(q):
    """Move one vertex of the cap of the reflex corner next to the other."""
    k = q.corner.index(6)
    return moved(q, k + 1, q.x[k] - q.x[k + 1] - mpq(1, 100), q.level[k] - q.level[k + 1])


def swapped(i, j):
    """Return a harm that exchanges the labels of two rings."""
    def harm(q):
        rings = rings_of(q)
        rings[i], rings[j] = labelled(rings[i], rings[j]), labelled(rings[j], rings[i])
        return rebuilt(q, rings)
    return harm


def repeated(i, j):
    """Return a harm that gives ring i the labels of ring j as well."""
    def harm(q):
        rings = rings_of(q)
        rings[i] = labelled(rings[i], rings[j])
        return rebuilt(q, rings)
    return harm


def without(i):
    """Return a harm that drops a ring."""
    def harm(q):
        rings = rings_of(q)
        return rebuilt(q, rings[:i] + rings[i + 1:])
    return harm


def mixed_labels(q):
    """Give one corner of the second ring to the first."""
    first, second, *others = rings_of(q)
    return rebuilt(q, [[(*first[0][:2], *second[0][2:]), *first[1:]], second, *others])


LEAST, GREATEST = "distance to the edge >= g", "distance to the edge <= 0.4701"
APART, ON_LEVELS = "distance >= 0.0599", "vertices are on levels"
ONE_WALK, TURNS = "a ring belongs to one walk, once", "a ring turns like its walk"
IN_FACE, ALL_WALKS, SIMPLE = "a ring is inside its face", "every walk has a ring", "Q is simple and meets nothing"
HARMS = [
    (L_SHAPE, one_level_lower, LEAST), (L_SHAPE, pushed_out, LEAST), (L_SHAPE, all_outside, LEAST),
    (L_SHAPE, turned_labels, GREATEST), (L_SHAPE, lambda q: moved(q, 0, "1/2"), GREATEST),
    (L_SHAPE, flat_cap, APART),
    (L_SHAPE, off_level, ON_LEVELS), (L_SHAPE, off_abscissa, ON_LEVELS),
    (L_SHAPE, lambda q: replace(q, level=(q.level[0] + 1, *q.level[1:])), ON_LEVELS),
    (L_SHAPE, reversed_rings, TURNS), (HOLED, reversed_rings, TURNS), (HOLED, swapped(0, 1), TURNS),
    (L_SHAPE, pushed_out, SIMPLE), (L_SHAPE, crossed, SIMPLE), (HOLED, swapped(2, 3), SIMPLE),
    (HALL, swapped(1, 2), SIMPLE), (L_SHAPE, all_outside, IN_FACE), (HOLED, inside_the_hole, IN_FACE),
    (TWO_ROOMS, swapped(0, 1), IN_FACE),
    (TWO_ROOMS, repeated(1, 0), ONE_WALK), (HALL, repeated(4, 3), ONE_WALK), (HOLED, mixed_labels, ONE_WALK),
    (TWO_ROOMS, without(0), ALL_WALKS), (HOLED, without(1), ALL_WALKS), (HOLED, without(3), ALL_WALKS),
]


def verdicts(pslg, harm):
    """Return the verdicts of all checks on a harmed offset."""
    shape = unit_shape(pslg)
    q = harm(offset(shape))
    return [*check_thickness(shape, q), check_separation(q), check_nesting(shape, q)]


@pytest.mark.parametrize("name", FAMILIES)
def test_good_results_are_accepted(name):
    made = run(name).construction
    shape, q = made.shape, made.offset
    least, greatest = check_thickness(shape, q)
    walks = sum(len(walk) for face in shape.faces for walk in face)
    assert least.holds and greatest.holds and least.instances == greatest.instances == 2 * walks
    for verdict in (check_separation(q), check_nesting(shape, q)):
        assert verdict.holds and verdict.instances == len(q.x)


@pytest.mark.parametrize("pslg, harm, clause", HARMS)
def test_harmed_results_are_refused(pslg, harm, clause):
    broken = [verdict.witness.clause for verdict in verdicts(pslg, harm) if not verdict.holds]
    assert clause in broken


@pytest.mark.parametrize("pslg", [L_SHAPE, TWO_ROOMS, HOLED])
def test_the_unharmed_are_accepted(pslg):
    assert all(verdict.holds for verdict in verdicts(pslg, lambda q: q))
    assert all(verdict.holds for verdict in verdicts(pslg, lambda q: rebuilt(q, rings_of(q))))


@pytest.mark.parametrize("pslg", [L_SHAPE, TWO_ROOMS, HOLED])
def test_where_a_ring_starts_and_which_comes_first_does_not_matter(pslg):
    def harmless(q):
        return rebuilt(q, [ring[1:] + ring[:1] for ring in rings_of(q)[::-1]])

    assert all(verdict.holds for verdict in verdicts(pslg, harmless))


def test_every_vertex_that_leaves_its_level_is_named():
    shape = unit_shape(L_SHAPE)
    q = offset(shape)
    for k, p in enumerate(q.points):
        verdict = check_nesting(shape, place(q, k, Point(p.x, p.y + LEVEL)))
        assert (verdict.witness.clause, verdict.witness.place["vertex_of_q"]) == (ON_LEVELS, k)


def test_an_end_on_the_wrong_side_has_a_negative_thickness():
    shape = unit_shape(L_SHAPE)
    least, _ = check_thickness(shape, pushed_out(offset(shape)))
    assert least.worst < 0 and least.witness.place["edge"] in range(6)


def test_the_bounds_themselves_are_allowed():
    # A strip of Q as high as g above its edge, and two vertices exactly 0.0599 apart.
    shape = unit_shape(graph([(0, 0), (10, 0), (10, 10), (0, 10)]))
    exact = Offset(4, (mpq(1), mpq(9), mpq(9), mpq(1)), (1, 1, 8, 8), (0, 2, 4, 6), (0, -1, -1, -1), ((0, 4),),
                   tuple(Point(mpq(x), mpq(y)) for x, y in ((1, LEVEL), (9, LEVEL), (9, 9), (1, 9))))
    assert check_thickness(shape, exact)[0].holds and check_thickness(shape, exact)[0].worst == LEVEL**2
    near = tuple(Point(mpq(x), mpq(y)) for x, y in ((1, 1), (1 + SEPARATION, 1), (9, 9), (1, 9)))
    assert check_separation(replace(exact, points=near)).worst == SEPARATION**2
    assert check_separation(replace(exact, points=near)).holds


def test_the_width_of_a_cap_is_the_separation_of_an_isolated_vertex():
    made = offset(unit_shape(graph([(0, 0), (10, 0), (10, 10), (0, 10), (5, 5)],
                                   [(0, 1), (1, 2), (2, 3), (3, 0)])))
    assert check_separation(made).worst <= (2 * FLAT) ** 2


def test_every_clause_fires():
    assert {clause for _, _, clause in HARMS} == clauses_of(offset_check)


CHECKS = ("least", "greatest", "separation", "nesting")


def test_verdicts_say_all_there_is_to_say():
    with recorded("offset", offset_check) as lines:
        none = [(f"{name}: {check}", verdict) for name, pslg in (("l", L_SHAPE), ("rooms", TWO_ROOMS), ("holed", HOLED))
                for check, verdict in zip(CHECKS, verdicts(pslg, lambda q: q), strict=True)]
        harmed = [(f"{number}: {check}", verdict) for number, (pslg, harm, _) in enumerate(HARMS)
                  for check, verdict in zip(CHECKS, verdicts(pslg, harm), strict=True)]
        lines += none + harmed


def turned(start, direction):
    """Return how far a direction is turned counter-clockwise from `start`: exact, growing with the angle, below 4."""
    x, y = dot(start, direction), cross(start, direction)
    share = mpq(y) / (abs(x) + abs(y))
    return share % 4 if x >= 0 else 2 - share


@pytest.mark.parametrize("size", [mpq(1, 7), mpq(3)])
def test_a_direction_lies_within_an_angle_or_not(size):
    directions = [Point(size * x, size * y) for x in range(-2, 3) for y in range(-2, 3) if x or y]
    for start, end, direction in product(directions, repeat=3):
        whole = turned(start, end) or 4  # equal directions make a full turn
        within = 0 < turned(start, direction) < whole
        assert offset_check._is_within(start, end, direction) == within, (start, end, direction)


def test_walks_turn_left_or_not_however_thin():
    # A triangle, the same the other way round, one too thin for floats, both ways, and what encloses nothing.
    thin = mpq(1, 10**40)
    points = Columns([Point(mpq(x), mpq(y)) for x, y in ((0, 0), (3, 0), (0, 3), (1, 1 + thin), (2, 2), (1, 1))])
    cycles = [(0, 1, 2), (2, 1, 0), (0, 4, 3), (3, 4, 0), (0, 4, 5), (0, 4), (1, 2, 0, 1, 2, 0)]
    expected = [True, False, True, False, False, False, True]
    forget()
    assert offset_check._turn_left(points, cycles) == expected
    counts = decisions()["ring"]
    assert counts.by_floats + counts.exactly == 7 and counts.exactly >= 4
    assert offset_check._turn_left(points, []) == []
    assert offset_check._turn_left(points, [(), (0, 1, 2), (2, 1, 0)]) == [False, True, False]
    quad = Columns([Point(mpq(x), mpq(y)) for x, y in ((0, 0), (thin, 0), (5, 5), (5 - thin, 5 + thin))])
    assert offset_check._turn_left(quad, [(0, 1, 2, 3), (3, 2, 1, 0), (1, 2, 3, 0)]) == [True, False, True]


def test_each_face_of_p_says_which_vertices_are_isolated():
    shape = unit_shape(HOLED)
    with pytest.raises(ValueError):
        check_nesting(replace(shape, isolated=()), offset(shape))
