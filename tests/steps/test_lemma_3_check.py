"""The checker of Lemma 3 and of the layers: it accepts good rectangles and refuses harmed ones by the clause."""

from dataclasses import replace
from functools import partial

import families
import pytest
from constructions import clauses_of
from gmpy2 import mpq
from recorded import recorded
from unit_rectangles import tube_of

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.paper import PaperOptions
from exactmesh.steps import lemma_3_check as check
from exactmesh.steps.layered_rectangle import triangulate_in_layers
from exactmesh.steps.lemma_3 import triangulate_rectangle

FULL = tube_of(range(10), mpq(3, 2), partial(triangulate_rectangle, teeth="retiled"))
LITERAL = tube_of(range(10), mpq(3, 2), triangulate_rectangle)
LAYERS = tube_of(range(10), mpq(3, 2), triangulate_in_layers)
FAR = tube_of([0, 64, 65], mpq(3, 2), triangulate_rectangle)
GOOD = (check.check_hypothesis, check.check_positions, check.check_tiling, check.check_boundary, check.check_fan,
        check.check_teeth, check.check_feature, check.check_constant, partial(check.check_count, occupied=True))


@pytest.mark.parametrize("good", GOOD)
def test_a_good_rectangle_passes(good):
    verdict = good(*FULL)
    assert verdict.holds and verdict.instances > 0


@pytest.mark.parametrize("name", ["spike room", "growth 50", "two-opt 50", "tiny",
                                  "collinear vertices on a turned l-shape"])
def test_all_rectangles_of_a_tube_are_found_and_pass(name):
    made = Run(families.ALL_SMALL[name], "paper", options=PaperOptions(teeth="retiled")).paper
    boxes = list(check.boxes(made.tube, made.points))
    assert len(boxes) == len(made.tube.rectangles) > 0
    assert sum(len(box.faces) for box in boxes) == made.tube.phase.count("rectangle")
    for good in (check.check_positions, check.check_tiling, check.check_boundary, check.check_fan, check.check_feature,
                 check.check_constant):
        assert good(made.tube, made.points).holds


def with_record(made, **changes):
    tube, points = made
    return replace(tube, rectangles=(replace(tube.rectangles[0], **changes),)), points


def with_faces(made, change, phase=None):
    tube, points = made
    faces = change(tube.patch.faces)
    return replace(tube, patch=replace(tube.patch, faces=faces), phase=phase or ("rectangle",) * len(faces)), points


def with_point(made, vertex, point):
    tube, points = made
    return tube, [*points[:vertex], point, *points[vertex + 1 :]]


def moved(made, nth, by):
    """Move the nth new vertex."""
    vertex = made[0].patch.first + nth
    p = made[1][vertex]
    return with_point(made, vertex, Point(p.x + by[0], p.y + by[1]))


HARMS = {
    "too low": (check.check_hypothesis, tube_of([0, 1, 2], mpq(1), triangulate_rectangle), "h > w"),
    "grid starts late": (check.check_positions, with_record(FULL, grid=tuple(range(1, 11))),
                         "positions increase from 0"),
    "grid repeats": (check.check_positions, with_record(FULL, grid=(0, 1, 2, 3, 3, 5, 6, 7, 8, 9)),
                     "positions increase from 0"),
    "grid is short": (check.check_positions, with_record(FULL, grid=tuple(range(9))), "positions increase from 0"),
    "grid is wrong": (check.check_positions, with_record(FULL, grid=(*range(9), 11)),
                      "vertices stand at multiples of w"),
    "a' moved": (check.check_tiling, with_point(FULL, 11, Point(mpq(9), mpq(1))), "a b b' a' is a rectangle"),
    "slanted": (check.check_tiling, with_point(with_point(FULL, 11, Point(mpq(10), mpq(3, 2))), 10,
                                               Point(mpq(1), mpq(3, 2))), "a b b' a' is a rectangle"),
    "flipped": (check.check_tiling, with_faces(FULL, lambda faces: (faces[0][::-1], *faces[1:])),
                "the faces' boundaries add up to the rectangle's"),
    "bent": (check.check_tiling, moved(FULL, 2, (mpq(0), mpq(1, 9))), "faces are triangles"),
    "dropped": (check.check_tiling, with_faces(FULL, lambda faces: faces[1:]),
                "the faces' boundaries add up to the rectangle's"),
    "doubled": (check.check_tiling, with_faces(FULL, lambda faces: (*faces, faces[4])),
                "every face belongs to a rectangle"),
    "elsewhere": (check.check_tiling, with_faces(FULL, lambda faces: (*faces, (90, 91, 92))),
                  "every face belongs to a rectangle"),
    "on the side": (check.check_boundary, with_point(FULL, FULL[0].patch.first, Point(mpq(1, 2), mpq(0))),
                    "new vertices are inside"),
    "outside": (check.check_boundary, moved(FULL, 2, (mpq(9), mpq(0))), "new vertices are inside"),
    "thin fan": (check.check_fan, moved(FULL, 0, (mpq(-99, 100), mpq(-9, 20))), "f1 is kept"),
    "bent fan": (check.check_fan, moved(FULL, 2, (mpq(0), mpq(1, 9))), "f1 is kept"),
    "literal teeth": (check.check_teeth, LITERAL, "f2 is kept"),
    "literal features": (check.check_feature, LITERAL, "min(f1, f2) is kept"),
    "no triangle": (check.check_feature, moved(FULL, 2, (mpq(0), mpq(1, 9))), "min(f1, f2) is kept"),
    "crowded": (check.check_constant, moved(FULL, 0, (mpq(-9, 10), mpq(0))), "min(h, w) / sqrt(37) is kept"),
    "far": (partial(check.check_count, occupied=True), FAR, "three new vertices each at most"),
    "few positions": (partial(check.check_count, occupied=False), with_record(FULL, grid=(*range(9), 1)),
                      "three new vertices each at most"),
    "layers crowded": (check.check_layers_feature, moved(LAYERS, 0, (mpq(0), mpq(-1, 3))),
                       "min(h, w) / (sqrt(2) (1 + log2 n)) is kept"),
    "rows": (check.check_layer_count, LITERAL, "1 + floor(log2 n) rows"),
    "nonproper": (lambda tube, points: check.check_proper(tube), LITERAL, "faces have three vertices"),
}


@pytest.mark.parametrize("bad, made, clause", HARMS.values(), ids=HARMS)
def test_a_harmed_rectangle_is_refused(bad, made, clause):
    verdict = bad(*made)
    assert not verdict.holds and verdict.witness.clause == clause


def test_every_clause_is_seen():
    assert {clause for _, _, clause in HARMS.values()} == clauses_of(check)


def test_nothing_is_judged_without_rectangles():
    made = Run(families.ALL_SMALL["unit square"], "paper").paper
    for good in GOOD:
        assert (good(made.tube, made.points).instances, good(made.tube, made.points).holds) == (0, True)


def test_verdicts_say_all_there_is_to_say():
    with recorded("lemma_3", check) as lines:
        every = (*GOOD, partial(check.check_count, occupied=False), check.check_layers_feature, check.check_layer_count,
                 lambda tube, points: check.check_proper(tube))
        room = Run(families.ALL_SMALL["spike room"], "paper", options=PaperOptions(teeth="retiled")).paper
        good = [(f"{name}: {number}", one(*made)) for name, made in (
            ("room", (room.tube, room.points)),
            ("full", FULL), ("literal", LITERAL), ("layers", LAYERS), ("far", FAR)) for number, one in enumerate(every)]
        lines += good + [(name, bad(*made)) for name, (bad, made, _) in HARMS.items()]


@pytest.mark.parametrize("one", [check.check_tiling, lambda tube, points: check.check_proper(tube)])
def test_every_face_needs_its_phase(one):
    tube, points = FULL
    with pytest.raises(ValueError):
        one(replace(tube, phase=tube.phase[:-1]), points)
