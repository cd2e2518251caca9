"""The checks of P2 and P3: exact worst values by hand, good results pass, harmed ones are refused with the clause."""

from dataclasses import replace

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.paper import PaperOptions, simple_polygon
from exactmesh.steps import offset_curve_check as check
from exactmesh.steps.offset_curve import offset_curve
from exactmesh.steps.reading import sin_eighth
from exactmesh.steps.records import RealPoint

few = settings(max_examples=15, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(4, 14), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
CONVEX, FLAT, CHORDS, PROLONGED = 0, 1, 5, 7
EVERY = families.ring([(0, 0), (6, 0), (12, 0), (12, 8), (9, 8), (8, 3), (7, 8), (4, 7), (0, 8)])
SQUARE = families.ring([(0, 0), (1, 0), (1, 1), (0, 1)])
HAIR = mpq(1, 2**100)
# All that hold of every polygon with at least four vertices.
TRUE = [check.check_single_curve, check.check_arcs, check.check_refinement, check.check_tube_distance,
        check.check_feature_size, check.check_separation, check.check_extension_from_p,
        check.check_extension_from_vertex]


def made(pslg, **options):
    """Return P and its curve, the two arguments of every check."""
    run = Run(pslg, "paper", options=PaperOptions(**options))
    return simple_polygon(run.subdivision), run.curve


@few
@given(polygons, st.sampled_from(["chords", "prolonged"]))
def test_good_results_pass(pslg, right_angle):
    shape, curve = made(pslg, right_angle=right_angle)
    for one in TRUE:
        assert one(shape, curve).holds, one


@few
@given(polygons, st.sampled_from(["scaled", "moved", "mirrored", "reversed"]))
def test_worst_values_do_not_depend_on_place_size_and_order(pslg, change):
    other = {"scaled": lambda: families.scaled(pslg, mpq(7, 3)), "mirrored": lambda: families.mirrored(pslg),
             "moved": lambda: families.translated(pslg, mpq(1, 3), -5),
             "reversed": lambda: families.reversed_orientation(pslg)}[change]()
    for one in TRUE:
        old, new = one(*made(pslg)), one(*made(other))
        assert (old.worst, old.instances, old.holds) == (new.worst, new.instances, new.holds), one


L = families.l_shape(4)
FACING = families.ring([(0, 0), (4, -3), (4, 4), (0, 1), (-4, 4), (-4, -3)])


@pytest.mark.parametrize("one, pslg, worst, instances", [
    (check.check_single_curve, SQUARE, mpq(9, 16), 4),
    (check.check_single_curve, L, mpq(9, 16), 6),
    (check.check_arcs, SQUARE, None, 0),
    (check.check_arcs, L, 0, 1),
    (check.check_arcs, FACING, mpq(7, 25), 2),
    (check.check_refinement, L, None, 6),
    (check.check_tube_distance, SQUARE, mpq(1, 16), 4),
    (check.check_tube_distance, L, (2 + sqrt(2)) / 64, 8),
    (check.check_octagon, L, sin_eighth() ** 2 / 4, 2),
    (check.check_feature_size, SQUARE, mpq(1, 4), 4),
    (check.check_feature_size, L, sin_eighth() ** 2 / 4, 8),
    (check.check_separation, SQUARE, mpq(1, 4), 4),
    (check.check_through_interior, SQUARE, mpq(1, 4), 4),
    (check.check_through_interior, FACING, mpq(9, 64), 6),
    (check.check_separation, FACING, mpq(9, 64), 6),
    (check.check_extension_from_p, L, None, 0),
    (check.check_extension_from_p, FACING, mpq(25, 256), 2),
    (check.check_extension_from_vertex, FACING, mpq(25, 256), 2),
])
def test_exact_worst_values(one, pslg, worst, instances):
    verdict = one(*made(pslg))
    assert (verdict.worst, verdict.instances) == (worst, instances)


def test_a_right_angle_that_is_prolonged_attains_the_greatest_distance():
    verdict = check.check_extension_from_vertex(*made(L, right_angle="prolonged"))
    assert verdict.holds and verdict.worst == mpq(1, 8)


def at(vertex, change):
    """Return a harm: the record of the corner at a vertex of P goes through `change`."""
    def harm(shape, curve):
        return shape, replace(curve, rings=tuple(
            tuple(change(c) if shape.origin[c.corner] == vertex else c for c in ring) for ring in curve.rings))
    return harm


def nudged(dx, dy, which=0):
    def change(corner):
        moved = list(corner.vertices)
        moved[which] = RealPoint(moved[which].x + dx, moved[which].y + dy)
        return replace(corner, vertices=tuple(moved))
    return change


def with_arc(change):
    return lambda corner: replace(corner, arc=change(corner.arc))


def ring(change):
    return lambda shape, curve: (shape, replace(curve, rings=tuple(change(r) for r in curve.rings)))


def on_square(pslg, mfs_squared):
    """Return the curve of a polygon whose minimum feature size is said to be what it is not."""
    return lambda shape, curve: (found := simple_polygon(Run(pslg, "paper").subdivision),
                                 offset_curve(found, mpq(mfs_squared)))


def _along(corner, dx, dy):
    """Return the place at the radius of the arc about (8, 3), in a direction of length 5."""
    radius = 3 - corner.vertices[1].y
    return RealPoint(8 + dx * radius / 5, 3 + dy * radius / 5)


TIP = families.ring([(0, 0), (20, 0), (20, 10), (14, 10), (10, 1), (6, 10), (0, 10)])
WHOLE = check.check_single_curve
REFINED = check.check_refinement


HARMS = [
    (WHOLE, ring(lambda r: r[1:]), "P2 has the corners of P in their order"),
    (WHOLE, ring(lambda r: r[::-1]), "P2 has the corners of P in their order"),
    (WHOLE, at(CHORDS, with_arc(lambda arc: None)), "arcs are at the reflex corners"),
    (WHOLE, at(CONVEX, lambda c: replace(c, arc=c.vertices * 2)), "arcs are at the reflex corners"),
    (WHOLE, at(CONVEX, nudged(HAIR, 0)), "a segment is mfs/4 inside its edge"),
    (WHOLE, at(CONVEX, nudged(0, HAIR)), "a segment is mfs/4 inside its edge"),
    (WHOLE, at(CONVEX, lambda c: replace(c, vertices=(RealPoint(-c.vertices[0].x, -c.vertices[0].y),))),
     "a segment is mfs/4 inside its edge"),
    (WHOLE, at(FLAT, nudged(HAIR, 0)), "an arc goes from one perpendicular to the other"),
    (WHOLE, at(CHORDS, with_arc(lambda arc: (RealPoint(arc[0].x + HAIR, arc[0].y + 5 * HAIR), arc[1]))),
     "an arc goes from one perpendicular to the other"),
    (WHOLE, at(CONVEX, lambda c: replace(c, vertices=(c.vertices[0], nudged(HAIR, 0)(c).vertices[0]))),
     "segments meet at a corner without an arc"),
    (WHOLE, on_square(SQUARE, 9), "a segment runs along its edge"),
    (WHOLE, on_square(TIP, 9), "nothing else of P is nearer than mfs/4"),
    (REFINED, at(CONVEX, lambda c: replace(c, vertices=c.vertices * 2)), "a corner without an arc stays as it is"),
    (REFINED, at(PROLONGED, with_arc(lambda arc: None)), "a corner without an arc stays as it is"),
    (REFINED, at(PROLONGED, lambda c: replace(c, kind="chords")),
     "arcs over 90 degrees become chords, arcs under 90 degrees are prolonged"),
    (REFINED, at(CHORDS, lambda c: replace(c, kind="prolonged")),
     "arcs over 90 degrees become chords, arcs under 90 degrees are prolonged"),
    (REFINED, at(PROLONGED, nudged(HAIR, 0)), "prolonged segments meet in one vertex"),
    (REFINED, at(CHORDS, nudged(HAIR, 0)), "chords go from one end of the arc to the other"),
    (REFINED, at(CHORDS, lambda c: replace(c, vertices=c.vertices[::2])),
     "chords go from one end of the arc to the other"),
    (REFINED, at(CHORDS, nudged(0, HAIR, 1)), "two chords meet in the middle of the arc"),
    (REFINED, at(CHORDS, lambda c: replace(c, vertices=(c.vertices[0], _along(c, 3, -4), c.vertices[2]))),
     "two chords meet in the middle of the arc"),
    (REFINED, at(CHORDS, nudged(HAIR, 0, 1)), "two chords meet in the middle of the arc"),
    (REFINED, at(CHORDS, lambda c: replace(c, vertices=(c.vertices[0], RealPoint(16 - c.vertices[1].x,
                                                                              6 - c.vertices[1].y), c.vertices[2]))),
     "two chords meet in the middle of the arc"),
    (check.check_arcs, at(CHORDS, with_arc(lambda arc: arc[::-1])), "an arc spans less than 180 degrees"),
    (check.check_arcs, at(CHORDS, with_arc(lambda arc: (arc[0], RealPoint(16 - arc[0].x, 6 - arc[0].y)))),
     "an arc spans less than 180 degrees"),
    (check.check_tube_distance, at(CHORDS, nudged(0, mpq(1, 10), 1)), "P3 keeps 1/(4 sqrt 2) from P"),
    (check.check_feature_size, at(FLAT, nudged(6 - mpq(2, 5), 0)), "mfs(P3) >= sin(pi/8)/2"),
    (check.check_separation, at(CHORDS, nudged(0, -mpq(5, 2), 1)), "1 - sqrt(2)/2 apart"),
    (check.check_through_interior, at(CHORDS, nudged(0, -mpq(5, 2), 1)), "1/2 apart"),
    (check.check_extension_from_p, at(PROLONGED, lambda c: replace(c, vertices=(c.arc[0],))),
     "a prolonged segment stays beyond mfs/4"),
    (check.check_extension_from_p, at(PROLONGED, with_arc(lambda arc: (RealPoint(Real(mpq(1, 5)), arc[0].y), arc[1]))),
     "a prolonged segment stays beyond mfs/4"),
    (check.check_extension_from_p, at(PROLONGED, with_arc(lambda arc: (arc[0], RealPoint(Real(9), Real(2))))),
     "a prolonged segment stays beyond mfs/4"),
    (check.check_extension_from_vertex, at(PROLONGED, nudged(0, -1)),
     "a prolonged segment stays within sqrt(2)/4 of its corner"),
]


@pytest.mark.parametrize("one, harm, clause", HARMS)
def test_the_checker_refuses_a_harmed_result(one, harm, clause):
    good = made(EVERY)
    assert one(*good).holds
    verdict = one(*harm(*good))
    assert not verdict.holds and verdict.witness is not None and verdict.witness.clause == clause


def test_the_least_distance_may_be_that_of_a_vertex_of_p():
    # The tip (10, 1) above the floor, whose segment is at 3/4 when the mfs is said to be 3.
    verdict = check.check_single_curve(*on_square(TIP, 9)(None, None))
    assert verdict.worst == mpq(1, 4) ** 2 / 9


def test_half_a_circle_spans_180_degrees():
    shape, curve = made(EVERY)
    arc = next(c.arc for c in curve.rings[0] if c.kind == "chords")
    assert check.check_arcs(shape, curve).holds and arc is not None
    opposite = RealPoint(16 - arc[0].x, 6 - arc[0].y)
    verdict = check.check_arcs(*at(CHORDS, with_arc(lambda _: (arc[0], opposite)))(shape, curve))
    assert not verdict.holds


def test_a_prolonged_segment_that_goes_nowhere_is_at_the_bound_exactly():
    harmed = at(0, lambda c: replace(c, vertices=(c.arc[0],)))(*made(FACING))
    verdict = check.check_extension_from_p(*harmed)
    assert not verdict.holds and verdict.worst == mpq(1, 16)


@pytest.mark.parametrize("squared, holds", [(mpq(1, 32), True), (mpq(1, 32) - mpq(1, 2**400), False)])
def test_a_hair_below_the_bound_is_refused(squared, holds):
    # The middle of the arc, on the diagonal of its corner (2, 1), moves to the bound, and a hair beyond.
    x = (Real(squared) / 2).sqrt()
    harmed = at(1, lambda c: replace(c, vertices=(c.vertices[0], RealPoint(2 + x, 1 + x), c.vertices[2])))(*made(L))
    verdict = check.check_tube_distance(*harmed)
    assert verdict.holds is holds and verdict.worst == squared


def test_verdicts_say_all_there_is_to_say():
    with recorded("offset_curve", check) as lines:
        good = made(EVERY)
        every = [*TRUE, check.check_octagon, check.check_through_interior]
        curves = {"every": good, "square": made(SQUARE), "l": made(L), "facing": made(FACING)}
        verdicts = [(f"{name}: {one.__name__}", one(*curve)) for name, curve in curves.items() for one in every]
        lines += verdicts + [(f"{number}: {one.__name__}", one(*harm(*good)))
                                          for number, (one, harm, _) in enumerate(HARMS)]


@pytest.mark.parametrize("one, pslg", [(check.check_feature_size, L), (check.check_through_interior, SQUARE)])
def test_a_hair_more_of_the_input_is_too_much_for_what_attains_its_bound(one, pslg):
    shape, curve = made(pslg)
    assert curve.mfs_squared == 1 and one(shape, curve).holds
    assert not one(shape, replace(curve, mfs_squared=curve.mfs_squared + mpq(1, 10**40))).holds
    assert one(shape, replace(curve, mfs_squared=curve.mfs_squared - mpq(1, 10**40))).holds


@pytest.mark.parametrize("one", [check.check_octagon, check.check_through_interior])
def test_other_worst_values_do_not_depend_on_size_either(one):
    old, new = one(*made(L)), one(*made(families.scaled(L, mpq(7, 3))))
    assert (old.worst, old.instances, old.holds) == (new.worst, new.instances, new.holds)
