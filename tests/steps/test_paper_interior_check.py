"""The checker of P6: it refuses harmed triangulations by the clause, and its values agree with brute force."""

from dataclasses import replace

import families
import oracle
import pytest
from constructions import clauses_of, face_feature_squared
from gmpy2 import mpq
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.numbers.rational import sqrt_below
from exactmesh.planar.cycles import sides
from exactmesh.steps import paper_interior_check
from exactmesh.steps.paper_interior_check import boundary, check_degradation, check_feature, check_tiling
from exactmesh.steps.records import Trapezoid

MADE = Run(families.l_shape(5), "paper").paper
INSIDE, CHORDS = MADE.interior, MADE.trapezoidation


def faces(change):
    return replace(INSIDE, faces=change(INSIDE.faces))


def moved(vertex, point):
    return (*MADE.points[:vertex], point, *MADE.points[vertex + 1 :])


def test_a_good_result_passes():
    assert check_tiling(MADE.p4, CHORDS, INSIDE, MADE.points).holds
    assert check_degradation(MADE.p4, CHORDS, INSIDE, MADE.points).instances == len(INSIDE.faces)


NEW = INSIDE.first
HARMS = [
    (faces(lambda old: old[1:]), MADE.points, "the faces' boundaries add up to the region's"),
    (faces(lambda old: (*old, old[0])), MADE.points, "faces do not overlap"),
    (faces(lambda old: (old[0][::-1], *old[1:])), MADE.points, "faces are triangles"),
    (faces(lambda old: tuple(face for face in old if NEW not in face)), MADE.points,
     "one vertex in each trapezoid, none in a triangle"),
    (faces(lambda old: tuple(tuple(NEW + 1 if v == NEW else v for v in face) if n == 0 else face
                             for n, face in enumerate(old))), MADE.points,
     "one vertex in each trapezoid, none in a triangle"),
    (replace(INSIDE, points=(*INSIDE.points, Point(mpq(0), mpq(0)))), MADE.points,
     "every new vertex is in one trapezoid"),
    (INSIDE, moved(NEW, Point(mpq(-1), mpq(-1))), "faces are triangles"),
]


@pytest.mark.parametrize("interior, points, clause", HARMS)
def test_a_harmed_tiling_is_refused(interior, points, clause):
    verdict = check_tiling(MADE.p4, CHORDS, interior, points)
    assert not verdict.holds and verdict.witness.clause == clause


def near(vertex, other):
    """Return the points with one vertex put next to another."""
    p, q = MADE.points[vertex], MADE.points[other]
    return moved(vertex, Point(q.x + (p.x - q.x) / 10**6, q.y + (p.y - q.y) / 10**6))


def test_a_vertex_out_of_place_is_refused():
    points = near(NEW, INSIDE.faces[0][0])
    degradation = check_degradation(MADE.p4, CHORDS, INSIDE, points)
    assert not degradation.holds and degradation.witness.clause == "half of mfs(P5) is left"
    feature = check_feature(CHORDS, INSIDE, points, MADE.p4.spacing, MADE.mfs_squared)
    assert not feature.holds and feature.witness.clause == "feature size >= 1/(4 d3)"


def test_a_face_that_is_no_triangle_counts_as_zero():
    interior = faces(lambda old: (old[0][::-1], *old[1:]))
    assert check_feature(CHORDS, interior, MADE.points, MADE.p4.spacing, MADE.mfs_squared).worst == 0


def test_every_clause_is_seen():
    own = {clause for _, _, clause in HARMS} | {"half of mfs(P5) is left", "feature size >= 1/(4 d3)"}
    assert own >= clauses_of(paper_interior_check)


@pytest.mark.parametrize("name", ["pentagon", "spike room", "l-shape 44", "growth 9", "star 9", "reflex notch 1e-2"])
def test_values_agree_with_brute_force(name):
    made = Run(families.ALL_SMALL[name], "paper").paper
    features = {face: face_feature_squared(made.points, face) for face in made.interior.faces}
    edges = {side for z in made.trapezoidation.trapezoids for side in sides(boundary(z))}
    used = sorted({v for side in edges for v in side})
    place = {v: i for i, v in enumerate(used)}
    p5 = oracle.mfs_squared([made.points[v] for v in used], [(place[u], place[v]) for u, v in edges])
    verdict = check_degradation(made.p4, made.trapezoidation, made.interior, made.points)
    assert verdict.worst == min(features.values()) / p5
    whole = check_feature(made.trapezoidation, made.interior, made.points, made.p4.spacing, made.mfs_squared)
    assert whole.worst == min(features.values()) / oracle.exact(made.mfs_squared)


def test_trapezoids_with_t_vertices_are_left_out_on_demand():
    made = Run(families.spike_room(100), "paper").paper
    args = (made.trapezoidation, made.interior, made.points, made.p4.spacing, made.mfs_squared)
    whole, clean = check_feature(*args), check_feature(*args, clean_only=True)
    assert not whole.holds and clean.holds and 0 < clean.instances < whole.instances


def test_verdicts_say_all_there_is_to_say():
    with recorded("paper_interior", paper_interior_check) as lines:
        cases = [("good", INSIDE, MADE.points), ("near", INSIDE, near(NEW, INSIDE.faces[0][0])),
                 *((str(number), interior, points) for number, (interior, points, _) in enumerate(HARMS))]
        verdicts = []
        for name, interior, points in cases:
            verdicts += [
                (f"{name}: tiling", check_tiling(MADE.p4, CHORDS, interior, points)),
                (f"{name}: degradation", check_degradation(MADE.p4, CHORDS, interior, points)),
                (f"{name}: feature", check_feature(CHORDS, interior, points, MADE.p4.spacing, MADE.mfs_squared)),
                (f"{name}: clean", check_feature(CHORDS, interior, points, MADE.p4.spacing, MADE.mfs_squared,
                                                 clean_only=True))]
        lines += verdicts


@pytest.mark.parametrize("name", ["pentagon", "spike room", "growth 24", "turned comb", "star 24"])
def test_good_tilings_pass_with_triangles_and_rows_of_t_vertices(name):
    made = Run(families.ALL_SMALL[name], "paper").paper
    verdict = check_tiling(made.p4, made.trapezoidation, made.interior, made.points)
    assert verdict.holds and verdict.instances == len(made.interior.faces)


def test_boundaries_run_counter_clockwise_and_an_apex_counts_once():
    z = Trapezoid(0, 1, 0, 1, 1, 2, 3, 4, (5, 6), (7, 8, 9))
    assert boundary(z) == (1, 5, 6, 2, 3, 9, 8, 7, 4)
    assert boundary(replace(z, tr=4, top=())) == (1, 5, 6, 2, 4)
    assert boundary(replace(z, br=1, bottom=())) == (1, 3, 9, 8, 7, 4)


def test_size_changes_no_verdict():
    made = Run(families.scaled(families.l_shape(5), 3), "paper").paper
    assert made.mfs_squared == 9 * MADE.mfs_squared
    old = check_feature(CHORDS, INSIDE, near(NEW, INSIDE.faces[0][0]), MADE.p4.spacing, MADE.mfs_squared)
    points = tuple(Point(3 * p.x, 3 * p.y) for p in near(NEW, INSIDE.faces[0][0]))
    new = check_feature(CHORDS, INSIDE, points, 3 * MADE.p4.spacing, 9 * MADE.mfs_squared)
    assert (old.worst, old.holds, old.instances) == (new.worst, new.holds, new.instances) and not old.holds
    at_bound = check_feature(CHORDS, INSIDE, points, 6 * sqrt_below(old.worst * MADE.mfs_squared, 90),
                             9 * MADE.mfs_squared)
    assert at_bound.holds
