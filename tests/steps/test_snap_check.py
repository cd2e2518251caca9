"""The checks of P4: exact values, good results pass under both readings, harmed ones are refused with the clause."""

from dataclasses import replace

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.separation import Expr
from exactmesh.paper import PaperOptions
from exactmesh.steps import snap_check as check
from exactmesh.steps.reading import READINGS
from exactmesh.steps.snap import snap

few = settings(max_examples=15, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(3, 14), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
L = families.l_shape(4)
OCTAGON = READINGS["octagon"].inverse_d3


def paper(pslg, **options):
    return Run(pslg, "paper", options=PaperOptions(**options)).paper


def verdicts(made, p4, inverse_d3=OCTAGON):
    """Return the verdicts of all checks by name."""
    return {
        "motion": check.check_motion(made.curve, p4, inverse_d3),
        "feature": check.check_feature_size(made.curve, p4, inverse_d3),
        "regions": check.check_both_regions(made.shape, made.curve, p4, inverse_d3),
        "tube": check.check_tube_distance(made.shape, made.curve, p4, inverse_d3),
        "lemma": check.check_perturbation(made.curve, p4),
    }


@few
@given(polygons, st.sampled_from(["octagon", "tube"]), st.sampled_from(["up", "down"]),
       st.sampled_from(["chords", "prolonged"]))
def test_good_results_pass(pslg, reading, ties, right_angle):
    made = paper(pslg, reading=reading, ties=ties, right_angle=right_angle)
    for name, verdict in verdicts(made, made.p4, READINGS[reading].inverse_d3).items():
        assert verdict.holds, (name, verdict)
        assert verdict.instances == (1 if name == "lemma" else len(made.p4.points))


@few
@given(polygons, st.sampled_from([mpq(1, 3), mpq(5), mpq(10**9)]))
def test_scaling_changes_a_verdict_by_rounding_only(pslg, factor):
    made, other = paper(pslg), paper(families.scaled(pslg, factor))
    for name, verdict in verdicts(made, made.p4).items():
        new = verdicts(other, other.p4)[name]
        assert (new.holds, new.instances) == (verdict.holds, verdict.instances)
        if name != "motion":
            # x goes to a dyadic grid that does not scale along: 2^-17 of the mfs at most.
            assert abs(new.worst - verdict.worst) < mpq(1, 1000) * (1 + verdict.worst)


def test_exact_values_on_the_unit_square():
    # P3 has its vertices at 1/4 and 3/4. The spacing is 2/21: 1/4 is 2.625 lines up and 3/4 is 7.875.
    made = paper(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]))
    spacing = made.p4.spacing
    assert spacing == mpq(2, 21) and made.p4.level == (3, 3, 8, 8)
    found = verdicts(made, made.p4)
    assert found["motion"].worst == (3 * spacing - mpq(1, 4)) ** 2
    assert found["feature"].worst == (5 * spacing) ** 2
    assert found["regions"].worst == found["tube"].worst == (1 - 8 * spacing) ** 2
    assert found["lemma"].worst == 4 * (5 * spacing + 2 * (3 * spacing - mpq(1, 4))) ** 2


@few
@given(polygons)
def test_the_motion_by_a_second_sign_procedure(pslg):
    made = paper(pslg)
    worst = check.check_motion(made.curve, made.p4, OCTAGON).worst.fold(Expr, Expr.sqrt)
    vertices = [v for ring in made.curve.rings for corner in ring for v in corner.vertices]
    squares = []
    for v, p in zip(vertices, made.p4.points, strict=True):
        x, y = v.x.fold(Expr, Expr.sqrt) - p.x, v.y.fold(Expr, Expr.sqrt) - p.y
        squares.append((x * x + y * y) / made.curve.mfs_squared)
    hair = mpq(1, 2**200)
    assert all((square - worst - hair).sign() < 0 for square in squares)
    assert any((square - worst + hair).sign() > 0 for square in squares)
    # sin(pi/8)/8 squared, without the product's own numbers.
    bound = (2 - Expr(2).sqrt()) / 256
    assert (bound - worst).sign() > 0


def moved(p4, v, dx=0, level=0):
    """Return P4 with vertex v moved along x and by whole levels, everything that depends on it adapted."""
    x, levels, points = list(p4.x), list(p4.level), list(p4.points)
    x[v] += dx
    levels[v] += level
    points[v] = Point(x[v], levels[v] * p4.spacing)
    return replace(p4, x=tuple(x), level=tuple(levels), points=tuple(points))


def off_its_line(p4):
    points = (Point(p4.points[0].x, p4.points[0].y + mpq(1, 2**80)), *p4.points[1:])
    return replace(p4, points=points)


def off_its_abscissa(p4):
    return replace(p4, x=(p4.x[0] + mpq(1, 2**80), *p4.x[1:]))


def without_last(p4):
    count = len(p4.x) - 1
    return replace(p4, x=p4.x[:count], level=p4.level[:count], corner=p4.corner[:count], points=p4.points[:count],
                   source=p4.source[:count], rings=((0, count),))


S1 = "S1: P4 has the vertices of P3 in their order"


HARMS = [
    ("motion", without_last, S1),
    ("motion", lambda p4: replace(p4, corner=(p4.corner[1], p4.corner[0], *p4.corner[2:])), S1),
    ("motion", lambda p4: replace(p4, rings=((0, 3), (3, len(p4.x)))), S1),
    ("motion", lambda p4: replace(p4, level=p4.level[:-1]), S1),
    ("motion", off_its_line, "S2: a vertex lies on its line"),
    ("motion", off_its_abscissa, "S2: a vertex lies on its line"),
    ("motion", lambda p4: replace(p4, level=(p4.level[0] + 1, *p4.level[1:])), "S2: a vertex lies on its line"),
    ("motion", lambda p4: moved(p4, 0, level=1), "S3: a vertex goes to the nearest line"),
    ("motion", lambda p4: moved(p4, 0, level=-1), "S3: a vertex goes to the nearest line"),
    ("motion", lambda p4: moved(p4, 2, mpq(1, 2**16)), "S4: x stays"),
    ("motion", lambda p4: replace(p4, spacing=p4.spacing * mpq(201, 200)), "S5: the spacing is at most 1/(2 d3)"),
    ("motion", lambda p4: replace(p4, spacing=-p4.spacing), "S5: the spacing is at most 1/(2 d3)"),
    ("feature", lambda p4: moved(p4, 2, -mpq(1, 6), 1), "mfs(P4) >= 1/(2 d3)"),
    ("regions", lambda p4: moved(p4, 0, -mpq(1, 5)), "mfs(P and P4) >= 1/(2 d3)"),
    ("tube", lambda p4: moved(p4, 0, -mpq(1, 5)), "P4 keeps 1/(4 sqrt 2) - 1/(4 d3) from P"),
    ("lemma", without_last, S1),
]


def one(name, made, p4):
    """Return the verdict of one check by name."""
    return {
        "motion": lambda: check.check_motion(made.curve, p4, OCTAGON),
        "feature": lambda: check.check_feature_size(made.curve, p4, OCTAGON),
        "regions": lambda: check.check_both_regions(made.shape, made.curve, p4, OCTAGON),
        "tube": lambda: check.check_tube_distance(made.shape, made.curve, p4, OCTAGON),
        "lemma": lambda: check.check_perturbation(made.curve, p4),
    }[name]()


@pytest.mark.parametrize("name, harm, clause", HARMS)
def test_the_checker_refuses_a_harmed_result(name, harm, clause):
    made = paper(L)
    assert verdicts(made, made.p4)[name].holds
    verdict = one(name, made, harm(made.p4))
    assert not verdict.holds and verdict.witness is not None and verdict.witness.clause == clause


def test_the_paper_leaves_no_room_for_x():
    # With a grid of 1/(2 d3), up to 2^-60, and a vertex halfway between lines, any motion of x is too much.
    spacing = (OCTAGON / 2).enclosure(60)[0]
    square = families.translated(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]), 0, spacing / 2 - mpq(1, 4))
    made = paper(square)
    p4 = snap(made.shape, made.curve, spacing)
    assert check.check_motion(made.curve, p4, OCTAGON).holds
    verdict = check.check_motion(made.curve, moved(p4, 0, mpq(1, 2**17)), OCTAGON)
    assert not verdict.holds and verdict.witness is not None
    assert verdict.witness.clause == "a vertex moves by at most 1/(4 d3)"
    assert verdict.worst == spacing**2 / 4 + mpq(1, 2**34)


def test_bounds_are_sharp():
    # The lower left vertex of P4 goes as near to the left side, or the lower right one to it, as the bound allows.
    made = paper(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]))
    tube = 1 / (4 * sqrt(2)) - OCTAGON / 4
    hair = mpq(1, 2**200)
    for name, bound, place in (("tube", tube, lambda d: moved(made.p4, 0, d - made.p4.x[0])),
                               ("regions", OCTAGON / 2, lambda d: moved(made.p4, 0, d - made.p4.x[0])),
                               ("feature", OCTAGON / 2, lambda d: moved(made.p4, 1, made.p4.x[0] + d - made.p4.x[1]))):
        low, high = bound.enclosure(220)
        assert not verdicts(made, place(low - hair))[name].holds
        assert verdicts(made, place(high + hair))[name].holds


def test_lemma_2_says_nothing_when_vertices_move_by_half_the_mfs():
    made = paper(L)
    verdict = check.check_perturbation(made.curve, moved(made.p4, 0, mpq(1, 9)))
    assert verdict.holds and verdict.instances == 0


def test_lemma_2_is_tight():
    # A square of side 1/2, its two lower vertices raised by 1/8 each, and the upper ones lowered by as much.
    made = paper(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]))
    p4 = replace(made.p4, spacing=mpq(1, 8), level=(3, 3, 5, 5),
                 points=tuple(Point(x, mpq(j, 8)) for x, j in zip(made.p4.x, (3, 3, 5, 5), strict=True)))
    verdict = check.check_perturbation(made.curve, p4)
    assert verdict.holds and verdict.worst == 1


def test_a_drawing_that_crosses_itself_is_no_drawing_of_a_polygon():
    # Two corners change places in P3 and in P4: vertices stay where they were, edges cross.
    made = paper(families.ring([(0, 0), (3, 0), (3, 2), (0, 2)]))
    order = (0, 2, 1, 3)
    curve = replace(made.curve, rings=(tuple(made.curve.rings[0][i] for i in order),))
    p4 = replace(made.p4, **{name: tuple(getattr(made.p4, name)[i] for i in order)
                             for name in ("x", "level", "corner", "points", "source")})
    verdict = check.check_perturbation(curve, p4)
    assert not verdict.holds and verdict.witness is not None and verdict.witness.clause == "the drawings are equivalent"
    assert verdict.instances == 1
    assert str(verdict.witness.place["what"]).startswith("edges 0 (0, 1) and 2 (2, 3) cross at")


def test_the_bounds_are_those_of_the_reading():
    tube = READINGS["tube"].inverse_d3
    assert tube == 1 / (4 * sqrt(2)) and (2 - sqrt(2)).sqrt() / 4 == OCTAGON
    # With the octagon's grid the tube's reading is broken: its 1/(2 d3) is smaller.
    made = paper(L)
    verdict = check.check_motion(made.curve, made.p4, tube)
    assert not verdict.holds and verdict.witness is not None
    assert verdict.witness.clause == "S5: the spacing is at most 1/(2 d3)"


def test_verdicts_say_all_there_is_to_say():
    with recorded("snap", check) as lines:
        made = paper(L)
        far = moved(made.p4, 0, mpq(1, 9))
        lines += [*verdicts(made, made.p4).items(),
                       *((f"vertex 0 far off: {name}", one(name, made, far)) for name in ("motion", "lemma")),
                       *((f"{number}: {name}", one(name, made, harm(made.p4)))
                         for number, (name, harm, _) in enumerate(HARMS))]


SQUARE = families.ring([(0, 0), (1, 0), (1, 1), (0, 1)])


@pytest.mark.parametrize("motion, instances, holds", [
    # The mfs of P3 is 1/2. A vertex that moves by a mfs, a being 0.24, leaves 1 - 2 a of it at least.
    (mpq(24, 100), 1, True), (mpq(1, 4), 0, True), (mpq(1, 4) - mpq(1, 10**30), 1, True), (mpq(26, 100), 0, True)])
def test_lemma_2_speaks_of_motions_below_half_the_mfs(motion, instances, holds):
    made = paper(SQUARE)
    at = [Point(mpq(x, 4), mpq(y, 4)) for x, y in ((1, 1), (3, 1), (3, 3), (1, 3))]
    p4 = replace(made.p4, points=(Point(at[0].x + motion, at[0].y), *at[1:]))
    verdict = check.check_perturbation(made.curve, p4)
    assert (verdict.instances, verdict.holds) == (instances, holds)
    if instances:
        assert verdict.worst == 4 * (mpq(1, 2) - motion + 2 * motion) ** 2
        assert verdict.witness.place == {"vertex_of_p4": 0, "edge_of_p4": [1, 2],
                                         "motion": sqrt(Real(motion**2)).decimal()}


def test_a_spacing_of_nothing_is_no_spacing():
    made = paper(L)
    verdict = check.check_motion(made.curve, replace(made.p4, spacing=mpq(0)), OCTAGON)
    assert verdict.witness.clause == "S5: the spacing is at most 1/(2 d3)"
    assert verdict.witness.place == {"spacing": "0"} and verdict.instances == 0


def test_a_spacing_of_just_the_bound_is_allowed():
    made = paper(SQUARE)
    p4 = replace(made.p4, spacing=mpq(1, 8), level=(2, 2, 6, 6),
                 points=tuple(Point(x, mpq(y, 4)) for x, y in zip(made.p4.x, (1, 1, 3, 3), strict=True)))
    assert check.check_motion(made.curve, p4, Real(mpq(1, 4))).holds
    assert not check.check_motion(made.curve, p4, Real(mpq(1, 4) - mpq(1, 10**40))).holds


def test_rings_have_their_edges_one_after_the_other():
    made = paper(SQUARE)
    (ring,) = made.curve.rings
    assert check._rings(replace(made.curve, rings=(ring, ring[:3]))) == [
        [(0, 1), (1, 2), (2, 3), (3, 0)], [(4, 5), (5, 6), (6, 4)]]


def test_nothing_is_judged_without_vertices():
    made = paper(SQUARE)
    empty = replace(made.p4, x=(), level=(), corner=(), points=(), source=(), rings=())
    verdict = check.check_tube_distance(made.shape, replace(made.curve, rings=()), empty, OCTAGON)
    assert (verdict.instances, verdict.holds, verdict.worst) == (0, True, None)
