"""The checkers of the Tube, after and before snapping: each refuses harm by its clause, and every clause is seen."""

from dataclasses import replace

import families
import pytest
from constructions import clauses_of
from gmpy2 import mpq
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.measure.verdict import Tally
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.paper import PaperOptions
from exactmesh.steps import paper_tube_check as after
from exactmesh.steps import paper_tube_unsnapped_check as before
from exactmesh.steps.reading import READINGS
from exactmesh.steps.records import Offset, PaperTube, Patch, RealPoint, Rectangle, Shape

MADE = Run(families.ALL_SMALL["spike room"], "paper").paper
STAR = Run(families.ALL_SMALL["star 12"], "paper").paper
"""Rectangles and a fan; fans, cuts and no rectangle."""
MOST = mpq(9999, 10000)
OCTAGON, TUBE = READINGS["octagon"], READINGS["tube"]
G2 = MADE.p4.spacing**2 / MADE.mfs_squared


def moved(vertex, to, made=MADE, beyond=MOST, start=None):
    """Return the points with one vertex moved most of the way to another, or `beyond` times the way from `start`."""
    p, q = made.points[vertex if start is None else start], made.points[to]
    place = Point(p.x + (q.x - p.x) * beyond, p.y + (q.y - p.y) * beyond)
    return (*made.points[:vertex], place, *made.points[vertex + 1 :])


def phases(change):
    return replace(MADE.tube, phase=tuple(change(phase) for phase in MADE.tube.phase))


def faces(change):
    return replace(MADE.tube, patch=replace(MADE.tube.patch, faces=change(MADE.tube.patch.faces)))


def tiling(tube=MADE.tube, points=MADE.points):
    return after.check_tiling(MADE.shape, MADE.p4, MADE.trapezoidation, MADE.interior, tube, points)


def structure(points):
    return after.check_structure(MADE.shape, MADE.p4, points)


def angles(made, points):
    return after.check_snapped_angles(made.shape, made.p4, made.tube, points)


def record(**changes):
    return replace(MADE.tube, rectangles=(replace(MADE.tube.rectangles[0], **changes), *MADE.tube.rectangles[1:]))


def low_vertex(bound):
    return after.check_low_vertex(MADE.shape, MADE.p4, MADE.tube, MADE.points, MADE.mfs_squared, bound)


def at(*places):
    return [Point(mpq(x), mpq(y)) for x, y in places]


def by_hand(a_below, b_below, top=(-1, 11)):
    """Return the verdict on the projection in a Tube with B from (0, 0) to (10, 0), edge 1, and T' of height 4."""
    points = at((0, 0), (10, 0), (top[1], 4), (top[0], 4), a_below, b_below)
    shape = Shape(mpq(1), tuple(points[:2]), (1, 0, 0, 1), (), (), ())
    return after.check_projection(shape, PaperTube(Patch(2, (), ()), (), (Rectangle(2, (2, 3), (0, 1), 4, 5),)), points)


FIRST = MADE.tube.rectangles[0]
B, A = FIRST.side[0], FIRST.side[-1]
CORNER = MADE.shape.origin[MADE.p4.corner[0]]
LEFT = MADE.shape.origin[FIRST.edge]
HARMS = {
    "dropped": (lambda: tiling(faces(lambda old: old[1:])), "the faces' boundaries add up to the region's"),
    "doubled": (lambda: tiling(faces(lambda old: (*old, old[3]))), "faces do not overlap"),
    "flipped": (lambda: tiling(faces(lambda old: (*old[:5], old[5][::-1], *old[6:]))), "faces are triangles"),
    "folded": (lambda: structure(moved(MADE.p4.first, CORNER, beyond=2)), "triangles and quasi-trapz are simple"),
    "flat spoke": (lambda: angles(MADE, moved(MADE.p4.first, MADE.p4.first + 1, beyond=2, start=CORNER)),
                   "the angle with P4 is at least arcsin(1/4)"),
    "flat cut": (lambda: after.check_cut_angle(MADE.trapezoidation, MADE.tube, MADE.points),
                 "the angle with T is at least 45 degrees"),
    "a' below B": (lambda: by_hand((1, -1), (9, 2)), "R lies in Q'"),
    "a' beside": (lambda: by_hand((-2, 2), (9, 2)), "R lies in Q'"),
    "slanted": (lambda: by_hand((1, 2), (9, 2)), "T' projects onto B"),
    "crowded top": (lambda: after.check_upper(MADE.shape, MADE.tube, moved(FIRST.side[1], B), MADE.mfs_squared, G2),
                    "mfs(Q') is the spacing"),
    "shallow": (lambda: after.check_lower(MADE.shape, MADE.tube, moved(FIRST.a_below, LEFT), MADE.mfs_squared, G2 / 4),
                "mfs(Q'') is half the spacing"),
    "too high a bound": (lambda: low_vertex(G2), "the vertex at 1/(8 d3) keeps 1/(8 d3)"),
    "neighbours": (lambda: after.check_gaps(MADE.tube, moved(FIRST.side[1], B), MADE.mfs_squared, G2),
                   "neighbours are the spacing apart"),
    "short side": (lambda: after.check_longer_side(MADE.tube, moved(A, B)), "|a b| >= |a a'|"),
    "many": (lambda: after.check_steiner_count(112, 3), "at most 36 Steiner vertices a corner"),
    "T-vertex": (lambda: after.check_proper_elsewhere(MADE.interior, MADE.tube, ("rectangle",)),
                 "faces have three vertices"),
    "prolonged": (lambda: before.check_spokes(MADE.shape, bent(MADE.curve), False), "the angle is at least 45 degrees"),
    "inner corner": (lambda: before.check_inner_corners(*whole(), OCTAGON),
                     "a' and b' are farther than 1/(2 d3) from the sides"),
    "moved a'": (lambda: before.check_motion(MADE.shape, MADE.curve, MADE.p4, every_side_whole(),
                                             moved(FIRST.a_below, LEFT), OCTAGON),
                 "a' and b' move by at most 1/(4 d3)"),
    "second reading": (lambda: before.check_fan_number(TUBE), "1/(2 d3 sqrt 2) >= 0.067"),
    "first reading": (lambda: before.check_motion_number(OCTAGON), "1/(4 d3) = 1/(16 sqrt 2)"),
    "three decimals": (lambda: before.check_low_number(OCTAGON), "1/(8 d3) is 0.022 in three decimals"),
}


def bent(curve):
    """Move the first vertex of P3 along its ring: its spoke leans."""
    (ring,) = curve.rings
    v = ring[0].vertices[0]
    first = replace(ring[0], vertices=(RealPoint(v.x + 5, v.y), *ring[0].vertices[1:]))
    return replace(curve, rings=((first, *ring[1:]),))


def every_side_whole():
    """Return the Tube with its first rectangle on the whole edge of P4, as its record tells."""
    k = MADE.p4.source.index(FIRST.edge)
    following = MADE.p4.successors()
    return record(side=(MADE.p4.first + following[k], *FIRST.side[1:-1], MADE.p4.first + k))


SLANTED = Run(families.ring([(12, 1), (12, 4), (9, 7), (8, 4)]), "paper").paper


def whole():
    return SLANTED.shape, SLANTED.curve, SLANTED.p4, SLANTED.tube


@pytest.mark.parametrize("judged, clause", HARMS.values(), ids=HARMS)
def test_harm_is_refused(judged, clause):
    verdict = judged()
    assert not verdict.holds and verdict.witness.clause == clause


def test_every_clause_is_seen():
    assert {clause for _, clause in HARMS.values()} >= clauses_of(after) | clauses_of(before)


def test_good_results_pass():
    assert tiling().holds and structure(MADE.points).holds and angles(MADE, MADE.points).holds
    assert angles(STAR, STAR.points).instances == 2 * len(STAR.p4.x) + 2 * STAR.tube.phase.count("fan")
    assert after.check_projection(MADE.shape, MADE.tube, MADE.points).instances == len(MADE.tube.rectangles) > 0
    assert after.check_upper(MADE.shape, MADE.tube, MADE.points, MADE.mfs_squared, G2).holds
    assert after.check_lower(MADE.shape, MADE.tube, MADE.points, MADE.mfs_squared, G2 / 4).holds
    assert after.check_gaps(MADE.tube, MADE.points, MADE.mfs_squared, G2).holds
    assert after.check_longer_side(MADE.tube, MADE.points).holds
    assert by_hand((-1, 2), (11, 2)).witness.clause == "R lies in Q'"
    assert before.check_spokes(MADE.shape, MADE.curve, False).holds
    assert before.check_fan_number(OCTAGON).holds
    assert before.check_motion_number(TUBE).holds and before.check_low_number(TUBE).holds


@pytest.mark.parametrize("phase", sorted(set(MADE.tube.phase)))
def test_wrong_labels_are_judged_as_what_they_say(phase):
    # The low faces keep a quarter of the spacing, so nothing that has them keeps half of it.
    def verdict(tube):
        tally = Tally("half", ">=", G2 / 4)
        return after.check_feature(tube, MADE.points, MADE.mfs_squared, tally, (phase,))

    swapped = phases(lambda old: {phase: "low", "low": phase}.get(old, old))
    assert not verdict(swapped).holds
    assert verdict(MADE.tube).holds == (phase not in ("low", "rectangle"))
    assert verdict(phases(lambda old: "fan" if phase != "fan" else "cut")).instances == 0


def test_a_face_that_is_no_triangle_counts_as_zero():
    tally = Tally("any", ">=", mpq(1))
    harmed = faces(lambda old: (old[0][::-1], *old[1:]))
    assert after.check_feature(harmed, MADE.points, MADE.mfs_squared, tally).worst == 0


def test_a_right_angle_prolonged_is_45_degrees_exactly():
    pslg = families.ring([(0, 0), (9, 0), (9, 9), (5, 9), (5, 5), (0, 5)])
    for rule, worst in (("prolonged", Real(mpq(1, 2))), ("chords", (2 - sqrt(2)) / 4)):
        run = Run(pslg, "paper", options=PaperOptions(right_angle=rule))
        verdict = before.check_spokes(run.paper.shape, run.curve, False)
        assert verdict.holds and verdict.worst == worst


def test_tops_alone_are_a_part_of_all():
    for made in (MADE, STAR):
        whole_verdict = before.check_spokes(made.shape, made.curve, False)
        tops = before.check_spokes(made.shape, made.curve, True)
        assert tops.instances == 2 * len(made.shape.points) <= whole_verdict.instances
        assert tops.worst <= whole_verdict.worst


def test_verdicts_say_all_there_is_to_say():
    with recorded("paper_tube", after, before) as lines:
        phases_of = sorted(set(MADE.tube.phase))
        verdicts = [(name, judged()) for name, (judged, _) in HARMS.items()]
        for name, made in (("room", MADE), ("star", STAR)):
            shape, tube, points = made.shape, made.tube, made.points
            g2 = made.p4.spacing**2 / made.mfs_squared
            verdicts += [(f"{name}: {number}", verdict) for number, verdict in enumerate((
                after.check_tiling(shape, made.p4, made.trapezoidation, made.interior, tube, points),
                after.check_structure(shape, made.p4, points), angles(made, points),
                after.check_cut_angle(made.trapezoidation, tube, points), after.check_projection(shape, tube, points),
                after.check_upper(shape, tube, points, made.mfs_squared, g2),
                after.check_lower(shape, tube, points, made.mfs_squared, g2 / 4),
                after.check_low_vertex(shape, made.p4, tube, points, made.mfs_squared, g2 / 16),
                after.check_gaps(tube, points, made.mfs_squared, g2), after.check_longer_side(tube, points),
                after.check_steiner_count(7, 3), after.check_proper_elsewhere(made.interior, tube, ("rectangle",)),
                *(after.check_feature(tube, points, made.mfs_squared, Tally(phase, ">=", g2 / 4), (phase,))
                  for phase in phases_of),
                after.check_feature(tube, points, made.mfs_squared, Tally("all", ">=", g2 / 4)),
                before.check_spokes(shape, made.curve, False), before.check_spokes(shape, made.curve, True),
                before.check_inner_corners(shape, made.curve, made.p4, tube, TUBE),
                before.check_motion(shape, made.curve, made.p4, tube, points, TUBE)))]
        verdicts += [(f"{name}: {check.__name__}", check(reading))
                     for name, reading in (("octagon", OCTAGON), ("tube", TUBE))
                     for check in (before.check_fan_number, before.check_motion_number, before.check_low_number)]
        for name, made, tube in (("slanted", SLANTED, SLANTED.tube), ("whole", MADE, every_side_whole())):
            args = (made.shape, made.curve, made.p4, tube)
            verdicts += [(f"{name}: inner corners", before.check_inner_corners(*args, TUBE)),
                         (f"{name}: motion", before.check_motion(*args, made.points, TUBE))]
        lines += verdicts


@pytest.mark.parametrize("a_below, b_below, top, clause", [
    (("-1/2", 2), (9, 2), (-1, 11), "R lies in Q'"), ((1, 2), ("21/2", 2), (-1, 11), "R lies in Q'"),
    ((1, 2), (9, 2), (0, 10), None), ((1, 2), (9, 2), ("-1/100", 10), "T' projects onto B"),
    ((1, 2), (9, 2), (0, "1001/100"), "T' projects onto B"), ((1, 2), (9, 2), ("1/100", "999/100"), None)])
def test_a_top_as_wide_as_the_base_projects_onto_it(a_below, b_below, top, clause):
    verdict = by_hand(a_below, b_below, top)
    assert verdict.holds == (clause is None) and verdict.instances == 1
    if clause:
        assert (verdict.witness.clause, verdict.witness.place) == (clause, {"rectangle": 0, "edge": 1})


@pytest.mark.parametrize("right, edge", [((10, 0), 1), ((5, 9), 0), ((-3, 1), 0)])
def test_a_quasi_trapz_is_judged_by_all_its_corners(right, edge):
    # The triangle of the first corner and the top is fine in all cases; the second region turns right.
    points = at((0, 0), right, (-1, 4), (11, 4))
    p4 = Offset(2, (mpq(-1), mpq(11)), (4, 4), (0, 0), (0, -1), ((0, 2),), tuple(points[2:]))
    verdict = after.check_structure(Shape(mpq(1), tuple(points[:2]), (0, 1), (), (), ()), p4, points)
    assert not verdict.holds and verdict.instances == edge + 1
    assert verdict.witness.place == {"edge_of_q": edge, "at": str(points[2 + edge])}


@pytest.mark.parametrize("apex, worst, vertex", [
    ((1, 3), mpq(9, 25), 2), ((4, 3), mpq(9, 25), 1), ((-1, 3), mpq(1, 5), 2), ((-1, -1), mpq(1, 37), 2)])
def test_angles_of_a_fan(apex, worst, vertex):
    points = at(apex, (0, 0), (5, 0))
    p4 = Offset(1, (), (), (), (), (), ())
    tube = PaperTube(Patch(3, (), ((0, 1, 2),)), ("fan",), ())
    verdict = after.check_snapped_angles(Shape(mpq(1), tuple(points[:1]), (), (), (), ()), p4, tube, points)
    assert (verdict.worst, verdict.instances) == (worst, 2)
    assert verdict.witness.place == {"vertex": vertex, "at": str(points[vertex])}


def test_an_obtuse_angle_counts_as_a_right_one():
    o, east, north, west = at((0, 0), (2, 0), (0, 1), (-1, "1/9"))
    assert after._sine_squared(o, east, north) == after._sine_squared(o, east, west) == 1
    assert after._sine_squared(east, o, north) == mpq(1, 5)


@pytest.mark.parametrize("high, x", [
    (("1/4", "3/4"), "1/2"), ((-1, 3), "1/2"), ((2, 5), "3/2"), ((-5, -2), -1), ((3, "7/2"), 2), ((-2, "-3/2"), "-3/4"),
    ((2, 3), "3/2"), (("1/2", "3/2"), "3/4"), ((0, 1), "1/2"), (("1/2", 4), "3/4")])
def test_the_centre_of_lemma_1(high, x):
    # Of the rectangle over the shorter side, or of the parallelogram from it to the nearest place on the other side.
    low = (mpq(0), mpq(1))
    assert after._lemma_1_abscissa(low, (mpq(high[0]), mpq(high[1]))) == mpq(x)
    assert after._lemma_1_abscissa((mpq(high[0]), mpq(high[1])), low) == mpq(x)


@pytest.mark.parametrize("corners, left", [
    (((0, 0), (4, 0), (4, 4), (0, 4)), True), (((0, 4), (4, 4), (4, 0), (0, 0)), False),
    (((0, 0), (4, 0), (1, 1), (0, 4)), True), (((4, 0), (1, 1), (0, 4), (0, 0)), True),
    (((1, 1), (0, 4), (0, 0), (4, 0)), True), (((0, 4), (0, 0), (4, 0), (1, 1)), True),
    (((0, 0), (4, 0), (0, 4), (4, 4)), False), (((0, 0), (4, 4), (4, 0), (0, 4)), False),
    (((0, 0), (2, 0), (4, 0), (0, 4)), True), (((2, 0), (4, 0), (0, 4), (0, 0)), True),
    (((0, 0), (1, 0), (2, 0), (3, 0)), False), (((0, 0), (4, 0), (0, 4)), True), (((0, 0), (0, 4), (4, 0)), False),
    (((0, 0), (1, 0), (4, 0)), False), (((0, 0), (4, 0), (2, 0), (0, 4)), False),
    (((0, 0), (4, 0), (0, 4), (0, 4)), False), (((3, 0), (0, 0), (1, -1), (2, 0)), False),
    (((0, 0), (2, 0), (2, 0), (0, 4)), False)])
def test_simple_and_counter_clockwise_regions(corners, left):
    assert after._turns_left(at(*corners)) is left


def test_all_faces_elsewhere_are_counted():
    plain = Patch(3, (), ((0, 1, 2), (2, 1, 0)))
    verdict = after.check_proper_elsewhere(plain, MADE.tube, after.PHASES)
    assert (verdict.instances, verdict.holds) == (2, True)


def test_every_face_has_a_phase():
    with pytest.raises(ValueError):
        after.check_proper_elsewhere(Patch(3, (), ()), replace(MADE.tube, phase=MADE.tube.phase[:-1]), ("low",))
