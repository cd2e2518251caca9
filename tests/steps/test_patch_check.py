"""The checkers of Interior and Tube accept good results and name the clause a harmed one breaks."""

from dataclasses import replace

import pytest
from constructions import clauses_of, run
from gmpy2 import mpq
from recorded import recorded

from exactmesh.geometry.decisions import decisions, forget
from exactmesh.geometry.point import Point
from exactmesh.measure.verdict import Verdict, Witness
from exactmesh.steps import patch_check
from exactmesh.steps.constants import EDGE_GAP, FEATURE
from exactmesh.steps.patch_check import (
    check_caps,
    check_edge_gaps,
    check_feature,
    check_interior_tiling,
    check_tube_tiling,
    recorded_on_edges,
    with_bound,
)
from exactmesh.steps.records import Patch

FAMILIES = ["hall", "triangle", "comb 5", "turned comb", "two-opt 9", "random pslg 1", "random pslg 5", "map 1",
            "star 24", "partition 24", "square and two points", "reflex notch 1e-6", "midway 100"]
# It has feet, chord ends, caps, and faces with T-vertices in the Interior and in the Tube.
BASE = run("turned comb").construction
EVERYWHERE = ("interior", "tube")


def everything(made):
    """Return all verdicts on a construction by name."""
    points = made.points
    return {
        "interior": check_interior_tiling(made.offset, made.trapezoidation, made.interior, points),
        "tube": check_tube_tiling(made.shape, made.offset, made.trapezoidation, made.interior, made.tube, points),
        "interior feature": check_feature(made.interior, points),
        "tube feature": check_feature(made.tube, points),
        "caps": check_caps(made.offset, made.trapezoidation, made.interior),
        "gaps": check_edge_gaps(made.offset, made.trapezoidation, made.interior, points),
    }


def broken(made):
    return {(name, verdict.witness.clause) for name, verdict in everything(made).items() if not verdict.holds}


def with_faces(part, change):
    """Return a harm that changes the list of faces of a patch."""
    def harm(made):
        patch = getattr(made, part)
        return replace(made, **{part: replace(patch, faces=tuple(change(list(patch.faces))))})
    return harm


def moved(part, number, to):
    """Return a harm that moves a new vertex of a patch; `to` gets its point and all points."""
    def harm(made):
        patch = getattr(made, part)
        points = list(patch.points)
        points[number] = to(points[number], made.points)
        return replace(made, **{part: replace(patch, points=tuple(points))})
    return harm


def with_long_face(change):
    """Return a change of the first face with T-vertices."""
    def changed(faces):
        at = next(i for i, face in enumerate(faces) if len(face) > 3)
        return [*faces[:at], change(faces[at]), *faces[at + 1:]]
    return changed


def corners(made, face):
    """Return the corners of a face with T-vertices, and its T-vertices."""
    at = made.points
    flat = [i for i in range(len(face)) if _turn(at[face[i - 1]], at[face[i]], at[face[(i + 1) % len(face)]]) == 0]
    return [v for i, v in enumerate(face) if i not in flat], [face[i] for i in flat]


def _turn(a, b, c):
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def without_t_vertex(made, part="interior"):
    """Leave a T-vertex out of the list of its face."""
    def change(face):
        return tuple(v for v in face if v != corners(made, face)[1][0])
    return with_faces(part, with_long_face(change))(made)


def with_far_t_vertex(made):
    """List a vertex on a face on which it does not lie."""
    stranger = max(made.interior.faces[0])
    return with_faces("tube", lambda faces: [(*faces[0], stranger), *faces[1:]])(made)


def merged(faces):
    """Merge two triangles with a common side into a quadrilateral with four corners."""
    for i, face in enumerate(faces):
        for j, other in enumerate(faces):
            if len(face) == len(other) == 3 and len(set(face) & set(other)) == 2:
                ((at, _),) = ((k, v) for k, v in enumerate(face) if v not in other)
                (apex,) = set(other) - set(face)
                both = (face[at], face[at - 2], apex, face[at - 1])
                if not corners(BASE, both)[1]:
                    return [both, *(f for k, f in enumerate(faces) if k not in (i, j))]
    raise AssertionError("no two faces make a quadrilateral")


def with_on_edge(change):
    """Return a harm that changes the records of feet."""
    def harm(made):
        return replace(made, interior=replace(made.interior, on_edge=tuple(change(list(made.interior.on_edge)))))
    return harm


def foot_number(made, i=0):
    """Return the place of a foot among the new vertices of the Interior."""
    return made.interior.on_edge[i][1] - made.interior.first


def foot_moved(to):
    """Return a harm that moves the first foot; `to` gets its point."""
    return lambda made: moved("interior", foot_number(made), lambda p, _: to(p))(made)


def foot_near_a_chord_end(made):
    """Move a foot along its edge to a hundredth beside its neighbour."""
    edge, foot = made.interior.on_edge[0]
    end = made.points[made.offset.first + edge]
    share = mpq(1, 100)

    def to(p, _):
        return Point(end.x + (p.x - end.x) * share, end.y + (p.y - end.y) * share)

    return moved("interior", foot - made.interior.first, to)(made)


def foot_on_a_cap(made):
    """Record a foot on the edge of a cap as well."""
    cap = made.offset.source.index(-1)
    return with_on_edge(lambda feet: [*feet, (cap, feet[0][1])])(made)


def near_an_edge(part):
    """Return a harm that moves a Steiner vertex to a thousandth of its distance from a neighbour's side."""
    def harm(made):
        patch = getattr(made, part)
        feet = {v for _, v in patch.on_edge}
        number = next(i for i in range(len(patch.points)) if patch.first + i not in feet)
        face = next(f for f in patch.faces if patch.first + number in f and len(f) == 3)
        u, v = (made.points[w] for w in face if w != patch.first + number)
        middle = Point((u.x + v.x) / 2, (u.y + v.y) / 2)
        return moved(part, number, lambda p, _: Point(middle.x + (p.x - middle.x) / 1000,
                                                      middle.y + (p.y - middle.y) / 1000))(made)
    return harm


FOOT, CAPS, TRIANGLES = "a foot lies inside its edge", "edges of caps stay whole", "faces are triangles"
OVERLAP, SUM = "faces do not overlap", "the faces' boundaries add up to the region's"
FEATURE_SIZE, GAPS = "feature size >= g/5", "neighbours >= 0.134 apart"
HARMS = [
    *((with_faces(part, change), (part, clause)) for part in EVERYWHERE for change, clause in (
        (lambda faces: faces[1:], SUM), (lambda faces: faces[:-1], SUM), (lambda faces: [], SUM),
        (lambda faces: [*faces, faces[0]], OVERLAP), (lambda faces: [*faces, faces[3]], OVERLAP),
        (lambda faces: [faces[0][::-1], *faces[1:]], TRIANGLES), (merged, TRIANGLES),
        (lambda faces: [(*faces[0], faces[0][0]), *faces[1:]], TRIANGLES),
        (lambda faces: [faces[0][:2], *faces[1:]], TRIANGLES), (lambda faces: [(), *faces[1:]], TRIANGLES))),
    (without_t_vertex, ("interior", SUM)), (lambda made: without_t_vertex(made, "tube"), ("tube", SUM)),
    (with_far_t_vertex, ("tube", TRIANGLES)), (with_far_t_vertex, ("tube feature", FEATURE_SIZE)),
    *((harm, (check, FOOT)) for check in ("interior", "tube", "gaps") for harm in (
        foot_moved(lambda p: Point(p.x, p.y + mpq(1, 10**15))), foot_moved(lambda p: Point(p.x - 100, p.y)),
        with_on_edge(lambda feet: [((feet[0][0] + 1) % 20, feet[0][1]), *feet[1:]]), foot_on_a_cap)),
    (with_on_edge(lambda feet: feet[1:]), ("interior", SUM)), (with_on_edge(lambda feet: feet[1:]), ("tube", SUM)),
    (with_on_edge(lambda feet: [*feet, feet[0]]), ("interior", SUM)),
    (with_on_edge(lambda feet: [*feet, feet[0]]), ("gaps", GAPS)),
    (foot_on_a_cap, ("caps", CAPS)), (foot_near_a_chord_end, ("gaps", GAPS)),
    (near_an_edge("interior"), ("interior feature", FEATURE_SIZE)),
    (near_an_edge("tube"), ("tube feature", FEATURE_SIZE)),
    (with_faces("interior", lambda faces: [faces[0][::-1], *faces[1:]]), ("interior feature", FEATURE_SIZE)),
]


@pytest.mark.parametrize("name", FAMILIES)
def test_good_results_are_accepted(name):
    made = run(name).construction
    verdicts = everything(made)
    assert all(verdict.holds for verdict in verdicts.values())
    assert verdicts["interior"].instances == verdicts["interior feature"].instances == len(made.interior.faces)
    assert verdicts["tube"].instances == verdicts["tube feature"].instances == len(made.tube.faces)
    assert verdicts["caps"].instances == len(made.interior.on_edge) + len(made.trapezoidation.points)


def test_the_base_has_everything():
    assert broken(BASE) == set() and len(BASE.interior.on_edge) >= 2 and BASE.trapezoidation.points
    assert all(any(len(face) > 3 for face in getattr(BASE, part).faces) for part in EVERYWHERE)
    assert BASE.tube.points and len(BASE.interior.points) > len(BASE.interior.on_edge)


@pytest.mark.parametrize("harm, place", HARMS)
def test_harmed_results_are_refused(harm, place):
    assert place in broken(harm(BASE))


@pytest.mark.parametrize("part", EVERYWHERE)
def test_no_face_may_be_missing_twice_or_turned_round(part):
    faces = getattr(BASE, part).faces
    for i, face in enumerate(faces):
        for clause, changed in ((SUM, faces[:i] + faces[i + 1:]), (OVERLAP, (*faces, face)),
                                (TRIANGLES, (*faces[:i], face[::-1], *faces[i + 1:]))):
            harmed = with_faces(part, lambda _, changed=changed: changed)(BASE)
            assert everything(harmed)[part].witness.clause == clause


@pytest.mark.parametrize("part", EVERYWHERE)
def test_every_t_vertex_is_needed(part):
    faces = getattr(BASE, part).faces
    for i, face in enumerate(faces):
        for t in corners(BASE, face)[1]:
            changed = (*faces[:i], tuple(v for v in face if v != t), *faces[i + 1:])
            harmed = with_faces(part, lambda _, changed=changed: changed)(BASE)
            assert everything(harmed)[part].witness.clause == SUM


def test_where_a_cycle_starts_does_not_matter():
    turned = with_faces("tube", lambda faces: [face[1:] + face[:1] for face in faces[::-1]])(BASE)
    assert broken(turned) == set()


def test_the_bound_itself_is_allowed():
    points = [Point(mpq(0), mpq(0)), Point(mpq(9), mpq(0)), Point(mpq(4), FEATURE)]
    exact = check_feature(Patch(3, (), ((0, 1, 2),)), points)
    assert exact.holds and exact.worst == FEATURE**2
    points[2] = Point(mpq(4), FEATURE - mpq(1, 10**30))
    assert not check_feature(Patch(3, (), ((0, 1, 2),)), points).holds


def test_gaps_of_exactly_the_bound_are_allowed():
    made = BASE
    edge, _ = recorded_on_edges(made.trapezoidation, made.interior)[0]
    a = made.points[made.offset.first + edge]
    b = made.points[made.offset.first + made.offset.successors()[edge]]
    level = replace(made.offset, points=tuple(
        Point(mpq(0), mpq(0)) if k == edge else Point(mpq(9), mpq(0)) if k == made.offset.successors()[edge] else p
        for k, p in enumerate(made.offset.points)))
    assert a != b
    chords = replace(made.trapezoidation, edge=(edge,), points=(Point(EDGE_GAP, mpq(0)),))
    points = [*made.shape.points, *level.points, *chords.points]
    verdict = check_edge_gaps(level, chords, replace(made.interior, on_edge=()), points)
    assert verdict.holds and verdict.worst == EDGE_GAP**2 and verdict.instances == 2


def test_every_clause_fires():
    assert {clause for _, (_, clause) in HARMS} == clauses_of(patch_check)


def test_verdicts_say_all_there_is_to_say():
    with recorded("patch", patch_check) as lines:
        made = [("good", BASE), *((f"harm {number}", harm(BASE)) for number, (harm, _) in enumerate(HARMS))]
        lines += [(f"{name}: {check}", verdict) for name, construction in made
                        for check, verdict in everything(construction).items() if name == "good" or not verdict.holds]


def test_gaps_below_the_bound_are_refused():
    # The three pieces of an edge, the one in the middle a hair too short.
    made = BASE
    edge = made.trapezoidation.edge[0]
    k, following = made.offset.first + edge, made.offset.first + made.offset.successors()[edge]
    points = list(made.points)
    points[k], points[following] = Point(mpq(0), mpq(0)), Point(mpq(9), mpq(0))
    ends = tuple(Point(x, mpq(0)) for x in (mpq(4), 4 + EDGE_GAP - mpq(1, 10**30)))
    first = made.trapezoidation.first
    points[first : first + 2] = ends
    chords = replace(made.trapezoidation, edge=(edge, edge), points=ends)
    level = replace(made.offset, points=tuple(points[made.offset.first : made.offset.first + len(made.offset.points)]))
    forget()
    verdict = check_edge_gaps(level, chords, replace(made.interior, on_edge=()), points)
    assert not verdict.holds and verdict.instances == 3
    assert verdict.witness.place == {"edge_of_q": edge, "vertices": [first, first + 1], "at": str(ends[0])}
    assert decisions()["edge gap"].by_floats + decisions()["edge gap"].exactly == 3


@pytest.mark.parametrize("feature, holds", [
    (FEATURE, True), (FEATURE + mpq(1, 10**30), False), (FEATURE / 2, True), (mpq(1), False)])
def test_another_bound_judges_the_same_worst_value(feature, holds):
    points = [Point(mpq(0), mpq(0)), Point(mpq(9), mpq(0)), Point(mpq(4), FEATURE)]
    exact = check_feature(Patch(3, (), ((0, 1, 2),)), points)
    verdict = with_bound(exact, feature)
    assert (verdict.holds, verdict.worst, verdict.instances) == (holds, FEATURE**2, 1)
    assert (verdict.witness.clause, verdict.witness.place) == (f"feature size >= {feature}", exact.witness.place)


def test_another_bound_leaves_a_verdict_without_a_value_alone():
    place = Witness("faces are triangles", {})
    for verdict in (Verdict(0, True), Verdict(3, False, None, place), Verdict(3, True, mpq(1), None)):
        assert with_bound(verdict, mpq(5)) is verdict
