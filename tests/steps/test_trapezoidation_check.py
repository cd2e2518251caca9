"""The checker of the trapezoidation accepts good results and names the clause a harmed one breaks."""

from dataclasses import replace

import pytest
from constructions import clauses_of, points_of, rings_on_levels, run
from gmpy2 import mpq
from recorded import recorded

from exactmesh.geometry.columns import Columns
from exactmesh.geometry.decisions import Count, decisions, forget
from exactmesh.geometry.point import Point
from exactmesh.steps import trapezoidation_check
from exactmesh.steps.constants import GAP, LEVEL, LEVEL_EDGE, SEPARATION
from exactmesh.steps.records import Trapezoid, Trapezoidation
from exactmesh.steps.trapezoidation import trapezoidate
from exactmesh.steps.trapezoidation_check import check_clearance, check_gaps, check_tiling, check_touch

FAMILIES = ["hall", "triangle", "comb 5", "turned comb", "random pslg 1", "random pslg 5", "map 1", "star 12",
            "staircase", "grid 50", "monotone 50", "rectangular spiral"]
# A room with two teeth of different lengths and a block below: T-vertices above and below, chord ends, an apex.
ROOM = rings_on_levels([(0, 0), (4, 0), (4, 2), (6, 2), (6, 0), (12, 0), (12, 9), (10, 9), (8, 5), (6, 9), (5, 9),
                        (3, 5), (2, 9), (0, 9)])
CHORDS = trapezoidate(ROOM)


def everything(q, chords):
    """Return all verdicts."""
    points = points_of(q, chords)
    return [check_tiling(q, chords, points), *check_gaps(q, chords, points), check_touch(q, chords),
            check_clearance(q, chords, points)]


def with_trapezoids(chords, change):
    return replace(chords, trapezoids=tuple(change(list(chords.trapezoids))))


def with_one(number, **fields):
    """Return a harm that replaces fields of one trapezoid; a function gets the trapezoid."""
    def harm(chords):
        z = chords.trapezoids[number]
        values = {name: value(z) if callable(value) else value for name, value in fields.items()}
        return with_trapezoids(chords, lambda zs: [*zs[:number], replace(z, **values), *zs[number + 1:]])
    return harm


def moved_end(chords):
    """Move a chord end off its edge."""
    p = chords.points[0]
    return replace(chords, points=(Point(p.x + mpq(1, 10**15), p.y), *chords.points[1:]))


def other_edge(chords):
    """Record a chord end on another edge of Q."""
    return replace(chords, edge=((chords.edge[0] + 1) % 14, *chords.edge[1:]))


def end_at_a_vertex(chords):
    """Put a chord end where its edge ends."""
    return replace(chords, points=(ROOM.points[chords.edge[0]], *chords.points[1:]))


def end_near_the_end(chords):
    """Move a chord end along its upright edge to a hundredth of a level before the end."""
    e = chords.edge[0]
    a, p = ROOM.points[e], chords.points[0]
    return replace(chords, points=(Point(p.x, a.y + (p.y - a.y) / 100), *chords.points[1:]))


def merged():
    """Return a rectangle with a straight vertex on either side, and one trapezoid over both of its two."""
    q = rings_on_levels([(0, 0), (5, 0), (5, 2), (5, 4), (0, 4), (0, 2)])
    chords = trapezoidate(q)
    below, above = chords.trapezoids
    return q, replace(chords, trapezoids=(replace(below, high=above.high, tl=above.tl, tr=above.tr),))


def needless_chord(q):
    """Return the trapezoidation of a rectangle with one chord more, on a level without vertices."""
    ends = tuple(Point(q.points[k].x, mpq(3, 2) * LEVEL) for k in (3, 1))
    return Trapezoidation(104, ends, (3, 1), (Trapezoid(0, 1, 3, 1, 100, 101, 105, 104, (), ()),
                                              Trapezoid(1, 3, 3, 1, 104, 105, 102, 103, (), ())))


INSIDE, HEIGHT, ON_LEVEL = "a chord end lies inside its edge", "a trapezoid has a height", "a side lies on its level"
ORDER, HAS_INSIDE = "a side runs from left to right", "a trapezoid has an inside"
LEG, OVERLAP, SUM = ("a leg lies on its edge of Q", "trapezoids do not overlap",
                     "the trapezoids' boundaries add up to Q")
GAPS, TO_LEG = "gap to a T-vertex >= 0.15", "T-vertex to leg >= 0.0599"
LEVEL_AT = "level edge at a T-vertex >= 0.0688"
TOUCH, GOES_ON = "vertices of Q on a side >= 1", "the edge goes on for g or more"
# The room's trapezoids: those with T-vertices above and below come after the two beside the block.
WITH_TOP = next(i for i, z in enumerate(CHORDS.trapezoids) if z.top)
WITH_BOTTOM = next(i for i, z in enumerate(CHORDS.trapezoids) if z.bottom)
HARMS = [
    (moved_end, INSIDE), (other_edge, INSIDE), (end_at_a_vertex, INSIDE),
    (with_one(0, high=lambda z: z.low), HEIGHT), (with_one(1, high=lambda z: z.low - 1), HEIGHT),
    (with_one(0, high=lambda z: z.high + 1), ON_LEVEL), (with_one(0, low=lambda z: z.low - 1), ON_LEVEL),
    (with_one(0, tl=lambda z: z.bl), ON_LEVEL),
    (with_one(0, tl=lambda z: z.tr, tr=lambda z: z.tl), ORDER),
    (with_one(WITH_TOP, top=lambda z: z.top[::-1] if len(z.top) > 1 else (z.tl,)), ORDER),
    (with_one(WITH_TOP, top=lambda z: (*z.top, z.tr)), ORDER),
    (with_one(0, bl=lambda z: z.br, tl=lambda z: z.tr), HAS_INSIDE),
    (with_one(0, left=lambda z: z.right), LEG), (with_one(0, right=lambda z: (z.right + 1) % 14), LEG),
    (with_one(WITH_TOP, br=lambda z: z.bottom[-1], bottom=lambda z: z.bottom[:-1]), LEG),
    (lambda c: with_trapezoids(c, lambda zs: [*zs, zs[0]]), OVERLAP),
    (lambda c: with_trapezoids(c, lambda zs: [*zs, replace(zs[WITH_TOP], top=())]), OVERLAP),
    (lambda c: with_trapezoids(c, lambda zs: zs[1:]), SUM), (lambda c: with_trapezoids(c, lambda zs: zs[:-1]), SUM),
    (lambda c: with_trapezoids(c, lambda zs: []), SUM),
    (with_one(WITH_TOP, top=()), SUM), (with_one(WITH_TOP, top=lambda z: z.top[1:]), SUM),
    (with_one(WITH_BOTTOM, bottom=lambda z: z.bottom[1:]), SUM),
    (end_near_the_end, GOES_ON),
]
# Not harmed but badly made: rings that break an invariant, and what refuses their trapezoidation.
BAD_RINGS = [
    ([(0, 0), (9, 0), (9, 5), ("32/10", 5), ("306/100", 2), ("3", 2), ("29/10", 5), (0, 5)], LEVEL_AT),
    ([(0, 0), (9, 0), (9, 5), (5, 5), ("314/100", 2), ("310/100", 5), ("305/100", 5), (3, 2), (2, 5), (0, 5)], GAPS),
    ([(0, 0), (9, 0), (9, 5), ("1/10", 5), ("1/20", 2), ("1/50", 5), (0, 5)], TO_LEG),
]


def broken(q, chords):
    return {verdict.witness.clause for verdict in everything(q, chords) if not verdict.holds}


@pytest.mark.parametrize("name", FAMILIES)
def test_good_results_are_accepted(name):
    made = run(name).construction
    q, chords, points = made.offset, made.trapezoidation, made.points
    tiling = check_tiling(q, chords, points)
    assert tiling.holds and tiling.instances == len(chords.trapezoids)
    for verdict in (*check_gaps(q, chords, points), check_touch(q, chords), check_clearance(q, chords, points)):
        assert verdict.holds
    assert check_touch(q, chords).instances == 2 * len(chords.trapezoids)
    assert check_clearance(q, chords, points).instances == 2 * len(chords.points)


def test_the_room_is_accepted():
    assert broken(ROOM, CHORDS) == set() and len(CHORDS.points) == 4


@pytest.mark.parametrize("harm, clause", HARMS)
def test_harmed_results_are_refused(harm, clause):
    assert clause in broken(ROOM, harm(CHORDS))


@pytest.mark.parametrize("ring, clause", BAD_RINGS)
def test_rings_that_break_an_invariant_are_refused(ring, clause):
    q = rings_on_levels([(mpq(x), y) for x, y in ring])
    assert clause in broken(q, trapezoidate(q))


def test_a_needless_chord_is_refused_although_the_trapezoids_tile():
    q = rings_on_levels([(0, 0), (5, 0), (5, 3), (0, 3)])
    chords = needless_chord(q)
    assert check_tiling(q, chords, points_of(q, chords)).holds
    assert broken(q, chords) == {TOUCH}


def test_the_bounds_themselves_are_allowed():
    exact = rings_on_levels([(0, 0), (9, 0), (9, 5), (4, 5), (3 + LEVEL_EDGE, 2), (3, 2), (2, 5), (0, 5)])
    chords = trapezoidate(exact)
    gaps, edges, _ = check_gaps(exact, chords, points_of(exact, chords))
    assert gaps.instances == 0 and edges.holds and edges.worst == LEVEL_EDGE**2
    apart = rings_on_levels([(0, 0), (9, 0), (9, 5), (6, 5), (3 + GAP, 2), (mpq(31, 10), 5), (mpq(305, 100), 5), (3, 2),
                             (2, 5), (0, 5)])
    chords = trapezoidate(apart)
    gaps, _, _ = check_gaps(apart, chords, points_of(apart, chords))
    assert gaps.holds and gaps.worst == GAP**2
    leg = rings_on_levels([(0, 0), (9, 0), (9, 5), (1, 5), (SEPARATION, 2), (mpq(1, 100), 5), (0, 5)])
    chords = trapezoidate(leg)
    _, _, legs = check_gaps(leg, chords, points_of(leg, chords))
    assert legs.holds and legs.worst == SEPARATION**2


def test_two_trapezoids_may_not_be_merged():
    q, chords = merged()
    assert broken(q, trapezoidate(q)) == set() and broken(q, chords) == {SUM}


def test_only_gaps_at_t_vertices_count():
    # The top is short and clean: that is no gap of I4.
    q = rings_on_levels([(0, 0), (5, 0), ("1/10", 3), (0, 3)])
    chords = trapezoidate(q)
    assert [v.instances for v in check_gaps(q, chords, points_of(q, chords))] == [0, 0, 0]


@pytest.mark.parametrize("number", range(len(CHORDS.trapezoids)))
def test_no_trapezoid_may_be_missing_or_there_twice(number):
    z = CHORDS.trapezoids[number]
    assert SUM in broken(ROOM, with_trapezoids(CHORDS, lambda zs: zs[:number] + zs[number + 1:]))
    assert OVERLAP in broken(ROOM, with_trapezoids(CHORDS, lambda zs: [*zs, z]))


@pytest.mark.parametrize("number", range(len(CHORDS.trapezoids)))
@pytest.mark.parametrize("side", ["top", "bottom"])
def test_no_t_vertex_may_be_missing(number, side):
    row = getattr(CHORDS.trapezoids[number], side)
    for i in range(len(row)):
        assert broken(ROOM, with_one(number, **{side: row[:i] + row[i + 1:]})(CHORDS)) == {SUM}


def test_every_clause_fires():
    fired = {clause for _, clause in HARMS} | {clause for _, clause in BAD_RINGS} | {TOUCH}
    assert fired == clauses_of(trapezoidation_check)


CHECKS = ("tiling", "gaps", "level edges", "legs", "touch", "clearance")


def test_verdicts_say_all_there_is_to_say():
    with recorded("trapezoidation", trapezoidation_check) as lines:
        made = [("good", ROOM, CHORDS), *((f"harm {i}", ROOM, harm(CHORDS)) for i, (harm, _) in enumerate(HARMS))]
        made += [(f"ring {i}", q, trapezoidate(q)) for i, (ring, _) in enumerate(BAD_RINGS)
                 for q in [rings_on_levels([(mpq(x), y) for x, y in ring])]]
        lines += [(f"{name}: {check}", verdict) for name, q, chords in made
                                 for check, verdict in zip(CHECKS, everything(q, chords), strict=True)]


TENT = rings_on_levels([(0, 0), (7, 0), (7, 2), (3, 5), (0, 2)])
TENTED = trapezoidate(TENT)
"""A rectangle below a triangle, which has an apex."""
ODD = [
    with_one(1, tl=lambda z: z.tr, tr=lambda z: z.tl), with_one(1, tl=lambda z: z.bl), with_one(1, bl=lambda z: z.br),
    with_one(1, top=lambda z: (z.tl,)), with_one(1, top=lambda z: (z.bl,)), with_one(1, left=lambda z: z.right),
    with_one(1, high=lambda z: z.low), with_one(1, tl=lambda z: z.bl, tr=lambda z: z.bl),
    with_one(0, bl=lambda z: z.br, tl=lambda z: z.tr), with_one(0, bottom=lambda z: (z.bl,)),
    with_one(0, bl=lambda z: z.br, br=lambda z: z.bl), with_one(0, right=lambda z: z.left),
    with_one(0, high=lambda z: z.low, tl=lambda z: z.bl, tr=lambda z: z.br),
]
KITE = rings_on_levels([(3, 0), (7, 2), (3, 5), (0, 2)])


@pytest.mark.parametrize("q, chords", [(ROOM, CHORDS), (TENT, TENTED), (KITE, trapezoidate(KITE)), merged(),
                                       *((ROOM, harm(CHORDS)) for harm, _ in HARMS[3:]),
                                       *((TENT, harm(TENTED)) for harm in ODD)])
def test_arrays_say_what_the_definition_says(q, chords):
    points, following = points_of(q, chords), q.successors()
    broken_ones = [trapezoidation_check._broken(
        z, [(q.points[e], q.points[following[e]]) for e in (z.left, z.right)], points, q.height)
        for z in chords.trapezoids]
    sound = trapezoidation_check._are_sound(q, chords, Columns(points))
    assert sound.tolist() == [clause is None for clause in broken_ones]


@pytest.mark.parametrize("q, chords", [(ROOM, CHORDS), (TENT, TENTED)])
def test_what_is_recorded_needs_no_exact_decision(q, chords, monkeypatch):
    def refuse(*points):
        raise AssertionError(f"exact orientation of {points}")

    monkeypatch.setattr(trapezoidation_check, "orientation", refuse)
    forget()
    points = points_of(q, chords)
    everything(q, chords)
    counts = decisions()
    apexes = sum((z.bl == z.br) + (z.tl == z.tr) for z in chords.trapezoids)
    neighbours = sum(len(z.bottom) + len(z.top) + 2 for z in chords.trapezoids) - apexes
    assert (counts["order on a side"].by_floats, counts["order on a side"].exactly) == (neighbours, 0)
    gaps, edges, legs = check_gaps(q, chords, points)
    for name, instances in (("clearance", 2 * len(chords.points)), ("chord gap", gaps.instances + edges.instances),
                            ("chord leg", legs.instances)):
        found = counts.get(name, Count())
        assert found.by_floats + found.exactly == instances


def test_where_a_ring_begins_changes_no_gap():
    for ring, _ in BAD_RINGS:
        found = set()
        for k in range(len(ring)):
            q = rings_on_levels([(mpq(x), y) for x, y in ring[k:] + ring[:k]])
            chords = trapezoidate(q)
            found.add(tuple((v.instances, v.holds, v.worst) for v in check_gaps(q, chords, points_of(q, chords))))
        assert len(found) == 1


@pytest.mark.parametrize("end", range(len(CHORDS.points)))
def test_each_chord_end_is_named_that_its_edge_hardly_goes_beyond(end):
    edge = CHORDS.edge[end]
    a, p = ROOM.points[edge], CHORDS.points[end]
    near = Point(p.x, a.y + (p.y - a.y) / 10**6)
    chords = replace(CHORDS, points=(*CHORDS.points[:end], near, *CHORDS.points[end + 1:]))
    verdict = check_clearance(ROOM, chords, points_of(ROOM, chords))
    assert not verdict.holds and verdict.worst == abs(p.y - a.y) / 10**6
    assert verdict.witness.place == {"vertex": CHORDS.first + end, "edge_of_q": edge, "at": str(near)}


def test_every_chord_end_needs_its_edge():
    with pytest.raises(ValueError):
        check_tiling(ROOM, replace(CHORDS, edge=CHORDS.edge[:-1]), points_of(ROOM, CHORDS))
