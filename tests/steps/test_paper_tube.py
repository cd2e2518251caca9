"""The paper's Tube: a triangulation in four phases on every family, and the rectangle it is built around."""

from collections import Counter

import families
import oracle
import pytest
from constructions import cycle_area, face_feature_squared
from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.measure.verdict import Tally
from exactmesh.paper import PaperOptions
from exactmesh.steps import lemma_3_check
from exactmesh.steps.paper_tube_check import PHASES, check_feature, check_low_vertex, check_structure, check_tiling
from exactmesh.steps.reading import READINGS

NAMES = sorted(families.ALL_SMALL)
OPTIONS = [PaperOptions(), PaperOptions(reading="tube"), PaperOptions(teeth="retiled"),
           PaperOptions(rectangle="layers"), PaperOptions(right_angle="prolonged", ties="down")]


def made(name, options=OPTIONS[0]):
    return Run(families.ALL_SMALL[name], "paper", options=options).paper


def tally():
    return Tally("least", ">=", mpq(0))


@pytest.mark.parametrize("options", OPTIONS, ids=["default", "tube", "retiled", "layers", "prolonged down"])
@pytest.mark.parametrize("name", NAMES)
def test_every_result_passes_its_checker(name, options):
    done = made(name, options)
    verdict = check_tiling(done.shape, done.p4, done.trapezoidation, done.interior, done.tube, done.points)
    assert verdict.holds and verdict.instances == len(done.tube.patch.faces) == len(done.tube.phase)
    assert check_structure(done.shape, done.p4, done.points).holds
    assert lemma_3_check.check_tiling(done.tube, done.points).holds


@pytest.mark.parametrize("name", NAMES)
def test_areas_add_up(name):
    done = made(name)
    areas = [cycle_area(done.points, face) for face in done.tube.patch.faces]
    assert min(areas) > 0
    whole = abs(oracle.polygon_area(done.shape.points))
    assert sum(areas) == whole - oracle.polygon_area(done.p4.points)


@pytest.mark.parametrize("name", NAMES)
def test_phases_have_their_numbers_of_faces(name):
    done = made(name)
    count = Counter(done.tube.phase)
    rectangles = len(done.tube.rectangles)
    edges = sum(source >= 0 for source in done.p4.source)
    assert count["rest"] == 2 * rectangles and count["low"] == 4 * rectangles
    assert count["tall"] == 4 * (edges - rectangles)
    recorded = Counter(done.trapezoidation.edge)
    chords = [k for k, source in enumerate(done.p4.source) if source < 0]
    assert count["fan"] == sum(1 + recorded[k] for k in chords)
    on_tops = sum(n for k, n in recorded.items() if k not in chords)
    assert count["cut"] == on_tops - sum(len(record.side) - 2 for record in done.tube.rectangles)


@pytest.mark.parametrize("name", ["spike room", "growth 50", "two-opt 50", "turned comb", "tiny", "huge"])
@pytest.mark.parametrize("options", OPTIONS[:2], ids=["octagon", "tube"])
def test_rectangles_have_the_stated_height_less_a_millionth(name, options):
    done = made(name, options)
    wanted = (mpq(1, 4) - READINGS[options.reading].granularity) ** 2
    for box in lemma_3_check.boxes(done.tube, done.points):
        assert (1 - mpq(1, 10**6)) ** 2 * wanted <= box.h_squared / done.mfs_squared <= wanted


@pytest.mark.parametrize("name", ["spike room", "star 12", "growth 24", "curved spiral"])
def test_features_agree_with_brute_force(name):
    done = made(name)
    verdict = check_feature(done.tube, done.points, done.mfs_squared, tally())
    assert verdict.worst * done.mfs_squared == min(face_feature_squared(done.points, f) for f in done.tube.patch.faces)
    for phase in PHASES:
        mine = [face for face, other in zip(done.tube.patch.faces, done.tube.phase, strict=True) if other == phase]
        verdict = check_feature(done.tube, done.points, done.mfs_squared, tally(), (phase,))
        assert verdict.instances == len(mine)
        if mine:
            assert verdict.worst * done.mfs_squared == min(face_feature_squared(done.points, face) for face in mine)


@pytest.mark.parametrize("name", ["unit square", "growth 24", "star 12", "curved spiral", "sliver with bends"])
def test_the_low_vertex_is_the_one_that_the_option_puts_there(name):
    # Both stand a hair below 1/(8 d3), each by its own rational, so the two values agree to a millionth or so.
    usual, low = made(name), made(name, PaperOptions(tall="low"))
    told = check_low_vertex(usual.shape, usual.p4, usual.tube, usual.points, usual.mfs_squared, mpq(0)).worst
    built = check_feature(low.tube, low.points, low.mfs_squared, tally(), ("tall",)).worst
    assert abs(told / built - 1) < mpq(1, 10**5)


def test_with_the_option_low_a_vertex_can_lie_outside():
    pslg = families.ring([(0, 0), (2, 1), (0, 4), (0, 3), (1, 1)])
    low = Run(pslg, "paper", options=PaperOptions(tall="low"))
    assert not low.verification.valid
    verdict = check_tiling(low.paper.shape, low.paper.p4, low.paper.trapezoidation, low.paper.interior, low.paper.tube,
                           low.paper.points)
    assert not verdict.holds and verdict.witness.clause == "faces are triangles"
    assert check_feature(low.paper.tube, low.paper.points, low.paper.mfs_squared, tally(), ("tall",)).worst == 0
    assert Run(pslg, "paper").verification.valid


@pytest.mark.parametrize("name", ["growth 24", "spike room"])
def test_moving_the_input_by_whole_lines_moves_the_tube(name):
    done = made(name)
    step = done.p4.spacing
    moved = Run(families.translated(families.ALL_SMALL[name], 0, 5 * step), "paper").paper
    assert moved.tube.phase == done.tube.phase
    assert [(p.x, p.y - 5 * step) for p in moved.tube.patch.points] == list(done.tube.patch.points)


@pytest.mark.parametrize("factor", [2, mpq(1, 8)])
def test_scaling_by_a_power_of_two_scales_the_tube(factor):
    done = made("growth 24")
    scaled = Run(families.scaled(families.ALL_SMALL["growth 24"], factor), "paper").paper
    assert scaled.tube.phase == done.tube.phase and scaled.tube.patch.faces == done.tube.patch.faces
    assert [(p.x / factor, p.y / factor) for p in scaled.tube.patch.points] == list(done.tube.patch.points)
