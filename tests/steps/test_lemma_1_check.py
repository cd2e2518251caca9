"""The checker of Lemma 1: it agrees with brute force, and it can refuse every clause."""

from dataclasses import replace

import families
import oracle
import pytest
from constructions import clauses_of
from gmpy2 import mpq
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.steps import lemma_1_check
from exactmesh.steps.lemma_1_check import (
    check_case_1,
    check_case_2,
    check_centre,
    check_lemma,
    check_side_distance,
    check_slant,
)

NAMES = ["triangle with vertices on its sides", "pentagon", "spike room", "curved spiral", "growth 24", "star 24",
         "turned comb", "30 digits"]
MADE = {name: Run(families.ALL_SMALL[name], "paper").paper for name in NAMES}


def checks(chords, interior, points):
    """Return the verdicts of all checkers but that on the distance from the legs, which is false of rectangles."""
    return (check_centre(chords, points, True), check_centre(chords, points, False), check_slant(chords, points),
            check_case_1(chords, points), check_case_2(chords, points), check_lemma(chords, interior, points))


@pytest.mark.parametrize("name", NAMES)
def test_good_results_pass(name):
    made = MADE[name]
    verdicts = checks(made.trapezoidation, made.interior, made.points)
    assert all(verdict.holds for verdict in verdicts)
    whole = sum(z.bl != z.br and z.tl != z.tr for z in made.trapezoidation.trapezoids)
    assert verdicts[0].instances + verdicts[1].instances == whole
    assert verdicts[3].instances + verdicts[4].instances == whole
    clean = sum(z.bl != z.br and z.tl != z.tr and not z.top and not z.bottom for z in made.trapezoidation.trapezoids)
    assert verdicts[5].instances == clean


@pytest.mark.parametrize("name", NAMES)
def test_the_values_agree_with_brute_force(name):
    made = MADE[name]
    square = [(i, (i + 1) % 4) for i in range(4)]
    least = None
    for _, z, shape in lemma_1_check.quadrilaterals(made.trapezoidation, made.points):
        corners = [made.points[v] for v in (z.bl, z.br, z.tr, z.tl)]
        own = oracle.mfs_squared(corners, square)
        assert own == oracle.mfs_squared(shape.trapezoid(), square)
        if not z.top and not z.bottom:
            (s,) = {v for face in made.interior.faces if face[:2] == (z.bl, z.br) for v in face[2:]}
            left = oracle.mfs_squared([*corners, made.points[s]], square + [(i, 4) for i in range(4)]) / own
            least = left if least is None else min(least, left)
    assert check_lemma(made.trapezoidation, made.interior, made.points).worst == least


def test_a_leg_of_a_rectangle_is_exactly_half_a_width_away():
    made = Run(families.ALL_SMALL["unit square"], "paper").paper
    verdict = check_side_distance(made.trapezoidation, made.points)
    assert not verdict.holds and verdict.worst == mpq(1, 4) and verdict.instances == 1


def crossed(chords):
    """Exchange the upper corners of every trapezoid: its legs cross."""
    return replace(chords, trapezoids=tuple(replace(z, tl=z.tr, tr=z.tl) for z in chords.trapezoids))


@pytest.mark.parametrize("name", NAMES)
def test_crossed_legs_are_refused(name):
    made = MADE[name]
    verdict = check_case_1(crossed(made.trapezoidation), made.points)
    assert not verdict.holds and verdict.witness.clause == "mfs(H) = min(h, l)"


def moved(made, vertex, point):
    points = list(made.points)
    points[vertex] = point
    return points


def test_the_lemma_refuses_a_vertex_out_of_place():
    made = MADE["growth 24"]
    s = made.interior.first
    (z,) = {z for z in made.trapezoidation.trapezoids for face in made.interior.faces if face == (z.bl, z.br, s)}
    assert not z.top and not z.bottom
    a, b, c = (made.points[v] for v in (z.bl, z.br, z.tl))
    for share in (mpq(1, 1000), mpq(-1, 10)):
        near_a = Point(a.x + share * (b.x + c.x - 2 * a.x), a.y + share * (b.y + c.y - 2 * a.y))
        verdict = check_lemma(made.trapezoidation, made.interior, moved(made, s, near_a))
        assert not verdict.holds and verdict.witness.clause == "half of mfs(H) is left"


@pytest.mark.parametrize("harm", [
    lambda faces: faces[1:], lambda faces: (faces[0][::-1], *faces[1:]),
    lambda faces: ((*faces[0], 0), *faces[1:])])
def test_the_lemma_refuses_other_than_four_triangles(harm):
    made = Run(families.ALL_SMALL["unit square"], "paper").paper
    verdict = check_lemma(made.trapezoidation, replace(made.interior, faces=harm(made.interior.faces)), made.points)
    assert not verdict.holds and verdict.witness.clause == "four triangles stand around one vertex"


def test_all_clauses_are_known():
    # The first, second and fourth are theorems about any trapezoid that a record can describe: none makes them fail.
    assert clauses_of(lemma_1_check) == {
        "the centre halves the feature size", "mfs(P) = min(h, l h / sqrt(a^2 + h^2))", "mfs(H) = min(h, l)",
        "mfs(H) = mfs(P)", "the centre of R is farther than l/2 from the legs", "half of mfs(H) is left",
        "four triangles stand around one vertex"}


def test_verdicts_say_all_there_is_to_say():
    with recorded("lemma_1", lemma_1_check) as lines:
        verdicts = []
        for name in ("spike room", "growth 24", "turned comb"):
            made = MADE[name]
            near = made.points[made.interior.faces[0][0]]
            points = moved(made, made.interior.first, Point(near.x, near.y + mpq(1, 10**9)))
            args = {"good": (made.trapezoidation, made.interior, made.points),
                    "moved": (made.trapezoidation, made.interior, points),
                    "crossed": (crossed(made.trapezoidation), made.interior, made.points),
                    "without a face": (made.trapezoidation, replace(made.interior, faces=made.interior.faces[1:]),
                                       made.points)}
            for what, (chords, interior, places) in args.items():
                found = [*checks(chords, interior, places), check_side_distance(chords, places)]
                verdicts += [(f"{name}, {what}: {number}", verdict) for number, verdict in enumerate(found)]
        lines += verdicts
