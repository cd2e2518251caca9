"""The checks of Appendix A: its sentences on exact polygons, the places where they fail, and harmed curves."""

from dataclasses import replace
from fractions import Fraction

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point, dot
from exactmesh.numbers.separation import Expr
from exactmesh.paper import simple_polygon
from exactmesh.steps import appendix_a_check as check
from exactmesh.steps.records import RealPoint

few = settings(max_examples=20, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(4, 14), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
coordinates = st.integers(-30, 30)
TRUE = [check.check_edge_length, check.check_both_reflex, check.check_one_reflex, check.check_unit_edges,
        check.check_reach, check.check_formula,
        lambda shape, curve: check.check_quarter_circle(shape, curve, only_next=True)]
SQUARE = families.ring([(0, 0), (1, 0), (1, 1), (0, 1)])
RHOMBUS = families.ring([(0, 0), (5, 0), (8, 4), (3, 4)])
L = families.l_shape(4)
TRAPEZOID = families.ring([(0, 0), (mpq(19, 180), -1), (mpq(199, 180), -1), (mpq(109, 90), 0)])
T_13_14_15 = families.ring([(0, 0), (mpq(5, 4), 0), (mpq(25, 56), mpq(15, 14))])
# Both ends of the lowest edge of the notch's tip are reflex.
FLAT_TIP = families.ring([(0, 0), (9, 0), (9, 6), (7, 6), (5, 2), (4, 2), (2, 6), (0, 6)])


def made(pslg):
    run = Run(pslg, "paper")
    return simple_polygon(run.subdivision), run.curve


@few
@given(polygons)
def test_what_is_true_of_four_vertices_or_more_holds(pslg):
    for one in TRUE:
        verdict = one(*made(pslg))
        assert verdict.holds, (one, verdict)


@pytest.mark.parametrize("one, pslg, worst, instances, holds", [
    (check.check_edge_length, SQUARE, mpq(1, 4), 4, True),
    (check.check_edge_length, T_13_14_15, mpq(39, 112) ** 2, 3, False),
    (check.check_edge_length, RHOMBUS, mpq(5, 8) ** 2, 4, True),
    (check.check_both_reflex, SQUARE, None, 0, True),
    (check.check_both_reflex, FLAT_TIP, mpq(1), 1, True),
    (check.check_one_reflex, L, mpq(3, 4) ** 2, 2, True),
    (check.check_unit_edges, SQUARE, mpq(0), 8, True),
    (check.check_unit_edges, RHOMBUS, None, 0, True),
    (check.check_both_acute, TRAPEZOID, mpq(59, 90) ** 2, 1, False),
    (check.check_both_acute, RHOMBUS, None, 0, True),
    # (2 T^2 - 1)/(4 T) for T = tan(w/2) = 1/2.
    (check.check_reach, RHOMBUS, mpq(-1, 4), 4, True),
    (check.check_sine, RHOMBUS, mpq(1, 4), 4, False),
    (check.check_sine, SQUARE, None, 0, True),
    (check.check_formula, RHOMBUS, mpq(1), 4, True),
    (check.check_formula, TRAPEZOID, mpq(1), 2, True),
    (check.check_formula, families.ring([(0, 0), (3, 0), (0, 4)]), None, 0, True),
    (check.check_quarter_circle, TRAPEZOID, mpq(44849809, 46785600), 4, False),
    (check.check_quarter_circle, T_13_14_15, mpq(0), 6, False),
])
def test_exact_worst_values(one, pslg, worst, instances, holds):
    verdict = one(*made(pslg))
    assert (verdict.worst, verdict.instances, verdict.holds) == (worst, instances, holds)


def test_the_segments_of_the_13_14_15_triangle():
    lengths = sorted(one.length_squared() for one in check._straights(*made(T_13_14_15)))
    assert lengths == [mpq(39, 112) ** 2, mpq(3, 8) ** 2, mpq(45, 112) ** 2]


def test_an_edge_of_a_quadrilateral_enters_j_y():
    # e runs from p1 = (0, 0) to p2 = (19/180, -1), u is the top side, mfs is 1: y is at depth 1, on the top side.
    y, e = (Fraction(181, 180), Fraction(0)), (Fraction(19, 181), Fraction(-180, 181))
    area = e[0] * 0 - e[1] * y[0]
    assert area == 1
    # A point of the right side, which is neither e nor u.
    t = Fraction(1, 50)
    at = (Fraction(199, 180) + t * Fraction(19, 180), -1 + t)
    d = (at[0] - y[0], at[1] - y[1])
    onwards, upwards = d[0] * e[0] + d[1] * e[1], d[0] * e[1] - d[1] * e[0]
    assert onwards > 0 and upwards > 0 and onwards**2 + upwards**2 < 1
    assert made(TRAPEZOID)[1].mfs_squared == 1
    assert not check.check_quarter_circle(*made(TRAPEZOID)).holds
    assert check.check_quarter_circle(*made(TRAPEZOID), only_next=True).holds


@few
@given(st.tuples(*[coordinates] * 6))
def test_no_triangle_is_below_the_square_root_of_one_twelfth(c):
    a, b, p = (c[0], c[1]), (c[2], c[3]), (c[4], c[5])
    if (b[0] - a[0]) * (p[1] - a[1]) == (b[1] - a[1]) * (p[0] - a[0]):
        return
    verdict = check.check_edge_length(*made(families.ring([a, b, p])))
    assert verdict.worst is not None and verdict.worst > mpq(1, 12)


@few
@given(st.tuples(*[coordinates] * 6))
def test_the_least_segment_of_a_triangle_by_its_formula_and_a_second_sign_procedure(c):
    points = [(c[0], c[1]), (c[2], c[3]), (c[4], c[5])]
    area = abs((points[1][0] - points[0][0]) * (points[2][1] - points[0][1])
               - (points[1][1] - points[0][1]) * (points[2][0] - points[0][0]))
    if not area:
        return
    worst = check.check_edge_length(*made(families.ring(points))).worst
    squares = sorted((points[i][0] - points[i - 1][0]) ** 2 + (points[i][1] - points[i - 1][1]) ** 2 for i in range(3))
    a, b, h = (Expr(n).sqrt() for n in squares)
    # The least height is area/h, the inner radius area/(a + b + h); |e'| = |e| (1 - mfs/4 over the radius).
    least = a * (1 - (a + b + h) / (4 * h)) * h / area
    difference = least * least - worst.fold(Expr, Expr.sqrt)
    hair = mpq(1, 2**150)
    assert (difference - hair).sign() < 0 < (difference + hair).sign()


@few
@given(polygons, st.sampled_from([Fraction(1, 3), Fraction(2, 9)]))
def test_turning_scaling_and_mirroring_change_no_value(pslg, turn):
    for one in [*TRUE, check.check_quarter_circle, check.check_both_acute, check.check_sine]:
        old = one(*made(pslg))
        for other in (families.rotated(pslg, turn), families.scaled(pslg, mpq(3, 7)), families.mirrored(pslg)):
            new = one(*made(other))
            assert (old.worst, old.instances, old.holds) == (new.worst, new.instances, new.holds)


def nudged(vertex, dx, dy):
    """Return a harm: all that the record has at a vertex of P moves."""
    def move(p):
        return RealPoint(p.x + dx, p.y + dy)

    def change(shape, corner):
        if shape.origin[corner.corner] != vertex:
            return corner
        arc = corner.arc and tuple(map(move, corner.arc))
        return replace(corner, vertices=tuple(map(move, corner.vertices)), arc=arc)

    return lambda shape, curve: (shape, replace(curve, rings=tuple(tuple(change(shape, c) for c in ring)
                                                                   for ring in curve.rings)))


HARMS = [
    (check.check_edge_length, SQUARE, nudged(0, mpq(1, 100), 0), "|e'| >= 1/2"),
    (check.check_edge_length, SQUARE, nudged(0, mpq(2), 0), "|e'| >= 1/2"),
    (check.check_both_reflex, FLAT_TIP, nudged(4, mpq(1, 2**99), 0), "|e'| = |e|"),
    (check.check_one_reflex, L, nudged(1, -mpq(5, 4), 0), "|e'| > 1/2"),
    (check.check_both_acute, families.ring([(0, 0), (9, 0), (8, 2), (1, 2)]), nudged(0, 6, 0), "|e'| > 1"),
    (check.check_reach, RHOMBUS, nudged(0, mpq(5), 0), "t1 is at most 1/4 beyond z"),
    (check.check_formula, RHOMBUS, nudged(0, mpq(1, 2**99), 0), "|e'| >= 1/(2 sin w)"),
]


@pytest.mark.parametrize("one, pslg, harm, clause", HARMS)
def test_the_checker_refuses_a_harmed_curve(one, pslg, harm, clause):
    good = made(pslg)
    assert one(*good).holds
    verdict = one(*harm(*good))
    assert not verdict.holds and verdict.witness is not None and verdict.witness.clause == clause


def test_an_acute_angle_at_an_edge_that_is_said_to_be_as_short_as_mfs():
    # Of a right triangle with legs 3 and 4 the mfs is 12/5; said to be 3, its edge of length 3 has an acute angle.
    shape, curve = made(families.ring([(0, 0), (4, 0), (0, 3)]))
    verdict = check.check_unit_edges(shape, replace(curve, mfs_squared=mpq(9)))
    assert not verdict.holds and verdict.worst == mpq(3, 5)


def test_j_y_is_open():
    # In a rhombus y is a corner, and the side opposite to u passes it at distance mfs exactly.
    verdict = check.check_quarter_circle(*made(families.ring([(0, 0), (5, 0), (9, 3), (4, 3)])))
    assert verdict.holds and verdict.instances > 0 and verdict.worst == 1


def test_an_edge_may_start_at_y():
    # u ends at depth mfs exactly, and the edge beyond turns away from e.
    shape, curve = made(families.ring([(0, 0), (6, 0), (11, 4), (7, 9), (3, 4)]))
    assert curve.mfs_squared == 16
    assert check.check_quarter_circle(shape, curve).holds


def test_verdicts_say_all_there_is_to_say():
    with recorded("appendix_a", check) as lines:
        every = [check.check_edge_length, check.check_both_reflex, check.check_one_reflex, check.check_unit_edges,
                 check.check_both_acute, check.check_reach, check.check_sine, check.check_formula,
                 check.check_quarter_circle]
        inputs = {"square": SQUARE, "rhombus": RHOMBUS, "l": L, "trapezoid": TRAPEZOID, "13 14 15": T_13_14_15,
                  "flat tip": FLAT_TIP}
        verdicts = []
        for name, pslg in inputs.items():
            verdicts += [(f"{name}: {one.__name__}", one(*made(pslg))) for one in every]
            verdicts.append((f"{name}: next", check.check_quarter_circle(*made(pslg), only_next=True)))
        lines += verdicts + [(f"{number}: {one.__name__}", one(*harm(*made(pslg))))
                                        for number, (one, pslg, harm, _) in enumerate(HARMS)]


@pytest.mark.parametrize("factor", [mpq(1), mpq(3, 7), mpq(5)])
def test_the_bounds_that_leave_edges_out_say_what_exact_values_say(factor, monkeypatch):
    said = []
    for seed in range(8):
        shape, curve = made(families.scaled(families.random_simple_polygon(9, seed, "growth"), factor))
        for end in check._acute_ends(shape, curve):
            for u, v in zip(shape.origin[::2], shape.origin[1::2], strict=True):
                a, b = (Point(shape.points[w].x - end.corner.p.x, shape.points[w].y - end.corner.p.y) for w in (u, v))
                xs, depths = (dot(a, end.along), dot(b, end.along)), (end.depth(a), end.depth(b))
                left, size = end.z * end.scale, end.scale
                beside = bool(max(xs) <= left or min(xs) >= left + size or min(depths) >= size or max(depths) <= 0)
                assert end.is_beside(a, b) == beside
                said.append((end, a, b, beside))
    monkeypatch.setattr(check._AcuteEnd, "is_beside", lambda *_: False)
    assert all(check._nearest_in_square(end, a, b) is None for end, a, b, beside in said if beside)
    assert 0 < sum(beside for *_, beside in said) < len(said)
