"""The checks of P5 and of the Tube's boundary: exact values, and harmed results refused."""

from dataclasses import replace
from itertools import pairwise

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.steps import p5_check as check

few = settings(max_examples=15, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(3, 14), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
L = families.l_shape(4)


def paper(pslg):
    return Run(pslg, "paper").paper


def boundary(made, tube=None):
    return check.check_boundary(made.shape, made.p4, made.trapezoidation, tube or made.tube.patch, made.points)


@few
@given(polygons)
def test_good_results_pass(pslg):
    made = paper(pslg)
    grid = check.check_grid(made.p4, made.trapezoidation)
    assert grid.holds and grid.instances == len(made.p4.points) + len(made.trapezoidation.points)
    assert boundary(made).holds


@few
@given(polygons)
def test_p5_keeps_three_quarters_of_the_spacing(pslg):
    made = paper(pslg)
    verdict = check.check_above_grid(made.p4, made.trapezoidation, made.points)
    assert verdict.worst is not None and verdict.worst > mpq(7628, 10000) ** 2
    kept = check.check_kept(made.p4, made.trapezoidation, made.points)
    assert kept.worst is not None and 0 < kept.worst <= 1


def test_exact_values_on_an_l():
    # Vertices of P4 on neighbouring lines of the grid make trapezoids of one line's height.
    made = paper(L)
    spacing = made.p4.spacing
    rows = sorted(set(made.p4.level))
    verdict = check.check_above_grid(made.p4, made.trapezoidation, made.points)
    assert verdict.holds and verdict.instances == 1
    assert verdict.worst == min(b - a for a, b in pairwise(rows)) ** 2 == 1
    kept = check.check_kept(made.p4, made.trapezoidation, made.points)
    assert not kept.holds
    # mfs(P4) is that of a chord of the arc at the reflex corner.
    assert kept.worst == spacing**2 / min(
        (p.x - q.x) ** 2 + (p.y - q.y) ** 2 for p, q in pairwise(made.p4.points))


def with_end(chords, change):
    return replace(chords, points=(change(chords.points[0]), *chords.points[1:]))


def test_a_chord_end_off_the_grid():
    made = paper(L)
    harmed = with_end(made.trapezoidation, lambda p: Point(p.x, p.y + mpq(1, 2**90)))
    verdict = check.check_grid(made.p4, harmed)
    assert not verdict.holds and verdict.witness is not None
    assert verdict.witness.clause == "a vertex of P5 lies on the grid" and verdict.instances == len(made.p4.points) + 1


def test_a_vertex_of_p4_off_the_grid():
    made = paper(L)
    p4 = replace(made.p4, points=(Point(made.p4.points[0].x, mpq(1, 3)), *made.p4.points[1:]))
    verdict = check.check_grid(p4, made.trapezoidation)
    assert not verdict.holds and verdict.instances == 1


@pytest.mark.parametrize("one", [check.check_kept, check.check_above_grid])
def test_a_chord_end_off_its_edge_counts_as_zero(one):
    made = paper(L)
    points = list(made.points)
    first = made.trapezoidation.first
    points[first] = Point(points[first].x + mpq(1, 2**90), points[first].y)
    verdict = one(made.p4, made.trapezoidation, points)
    assert not verdict.holds and verdict.worst == 0


def inserted(tube, side, vertex):
    """Return the Tube with a vertex put on one of its boundary edges."""
    faces = []
    for face in tube.faces:
        at = next((i for i in range(len(face)) if (face[i - 1], face[i]) == side), None)
        faces.append(face if at is None else (*face[:at], vertex, *face[at:]))
    return replace(tube, faces=tuple(faces))


CLAUSE = "the Tube's boundary has no vertex more"


@pytest.mark.parametrize("harm, clause", [
    (lambda made: inserted(made.tube.patch, (0, 1), 999), CLAUSE),
    (lambda made: inserted(made.tube.patch, (made.p4.first + 1, made.p4.first), 999), CLAUSE),
    (lambda made: replace(made.tube.patch, faces=made.tube.patch.faces[1:]), CLAUSE),
    (lambda made: replace(made.tube.patch, on_edge=((0, 999),)), "the Tube records no vertex on P4"),
])
def test_the_checker_refuses_a_harmed_tube(harm, clause):
    made = paper(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]))
    assert boundary(made).holds
    verdict = boundary(made, harm(made))
    assert not verdict.holds and verdict.witness is not None and verdict.witness.clause == clause


def test_a_chord_end_off_its_edge_spoils_the_tubes_boundary():
    made = paper(L)
    points = list(made.points)
    points[made.trapezoidation.first] = Point(mpq(0), mpq(0))
    verdict = check.check_boundary(made.shape, made.p4, made.trapezoidation, made.tube.patch, points)
    assert not verdict.holds and verdict.witness is not None
    assert verdict.witness.clause == "a chord ends inside its edge"


def test_verdicts_say_all_there_is_to_say():
    with recorded("p5", check) as lines:
        made = paper(L)
        first, p = made.trapezoidation.first, made.trapezoidation.points[0]
        off_grid = with_end(made.trapezoidation, lambda p: Point(p.x, p.y + mpq(1, 2**90)))
        beside = [*made.points[:first], Point(p.x + mpq(1, 2**90), p.y), *made.points[first + 1:]]
        tube = made.tube.patch
        verdicts = [("grid", check.check_grid(made.p4, made.trapezoidation)),
                    ("grid, end moved", check.check_grid(made.p4, off_grid)), ("boundary", boundary(made))]
        for name, points in (("good", made.points), ("end beside its edge", beside)):
            verdicts += [
                (f"{name}: kept", check.check_kept(made.p4, made.trapezoidation, points)),
                (f"{name}: grid", check.check_above_grid(made.p4, made.trapezoidation, points)),
                (f"{name}: boundary", check.check_boundary(made.shape, made.p4, made.trapezoidation, tube, points))]
        verdicts += [
            ("a vertex more on P", boundary(made, inserted(tube, (0, 1), 999))),
            ("a face less", boundary(made, replace(tube, faces=tube.faces[1:]))),
            ("a record more", boundary(made, replace(tube, on_edge=((0, 999),))))]
        lines += verdicts


def test_every_chord_end_needs_its_edge():
    made = paper(L)
    with pytest.raises(ValueError):
        check.check_above_grid(made.p4, replace(made.trapezoidation, edge=made.trapezoidation.edge[1:]), made.points)
