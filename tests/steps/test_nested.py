"""The nested candidates: each tiles its quadrilateral, is measured exactly, and puts one vertex over a gap."""

import random

import pytest
from constructions import face_feature_squared, point, untiled
from gmpy2 import mpq

from exactmesh.steps.constants import FEATURE_SQUARED, LEVEL
from exactmesh.steps.frame import frame_of
from exactmesh.steps.nested import nested_below, nested_candidates


def strip(gaps, height=LEVEL, lean=0, reach=0):
    """Return the frame of a strip over these gaps; the clean side is `reach` longer at either end, and leans."""
    u = [mpq(0)]
    for gap in gaps:
        u.append(u[-1] + mpq(gap))
    return frame_of([point(x, 0) for x in u], point(-mpq(reach), mpq(height)),
                    point(u[-1] + mpq(reach), mpq(height) + mpq(lean)))


def random_strip(seed):
    source = random.Random(seed)
    gaps = [mpq(source.randint(15, 100), 100) * mpq(10) ** source.randint(0, source.choice((0, 2, 5)))
            for _ in range(source.randint(1, 40))]
    lean = mpq(source.randint(-10, 100), 100) if source.random() < 0.6 else mpq(0)
    reach = mpq(source.randint(-4, 30), 10) if source.random() < 0.5 else mpq(0)
    return strip(gaps, LEVEL if source.random() < 0.5 else 1, lean, max(reach, -gaps[0] / 3))


def outline(frame):
    """Return the boundary counter-clockwise, as faces name its vertices."""
    return [*range(len(frame.u)), frame.right, frame.left]


def placed(frame, candidate):
    """Return points and faces with new vertices numbered after the given ones."""
    count = len(frame.u) + 2
    return ([*frame.points(), *candidate.steiner],
            [tuple(v if v >= 0 else count - 1 - v for v in face) for face in candidate.faces])


@pytest.mark.parametrize("seed", range(40))
def test_every_candidate_tiles(seed):
    frame = random_strip(seed)
    for candidate in nested_candidates(frame):
        points, faces = placed(frame, candidate)
        assert untiled(points, outline(frame), faces) == []


@pytest.mark.parametrize("seed", range(40))
def test_the_value_is_the_least_feature_size_of_the_faces(seed):
    frame = random_strip(seed)
    for candidate in nested_candidates(frame):
        points, faces = placed(frame, candidate)
        # The step leaves the distances of T-vertices from each other to the rules that place them.
        assert candidate.value >= min(face_feature_squared(points, face) for face in faces)
        plain = [face for face in faces if len(face) == 3]
        assert all(candidate.value <= face_feature_squared(points, face) for face in plain)


@pytest.mark.parametrize("seed", range(40))
def test_there_is_one_new_vertex_over_each_gap_that_the_fans_leave(seed):
    frame = random_strip(seed)
    for candidate in nested_candidates(frame):
        apexes = {face[2]: face[:2] for face in candidate.faces if face[2] < 0 and face[1] == face[0] + 1 > 0}
        fans = [face for face in candidate.faces if len(face) == 3 and face[2] >= 0 and face[1] == face[0] + 1]
        assert len(candidate.steiner) + len(fans) == len(frame.u) - 1
        for apex, (u, v) in apexes.items():
            if v < len(frame.u):
                assert frame.u[u] < candidate.steiner[-1 - apex].x < frame.u[v]


def slanted(seed):
    """Return the frame of a strip with its clean side below it, from (0, 0) on; the T-side may slant by 1/4 there."""
    source = random.Random(seed)
    gaps = [mpq(source.randint(15, 60), 100) * mpq(10) ** source.randint(0, source.choice((0, 2)))
            for _ in range(source.randint(2, 30))]
    start, low, high = mpq(source.randint(-40, 300), 100), LEVEL, LEVEL * mpq(source.randint(4, 8), 4)
    slope = (high - low) / max(sum(gaps), 4 * (high - low)) * source.choice((-1, 0, 1))
    xs = [start]
    for gap in gaps:
        xs.append(xs[-1] + gap)
    return frame_of([point(x, high + slope * (x - start)) for x in xs], point(0, 0), point(xs[-1] + start + 1, 0))


@pytest.mark.parametrize("seed", range(40))
def test_along_the_clean_side_it_tiles_and_keeps_a_fifth_of_the_height(seed):
    frame = slanted(seed)
    candidate = nested_below(frame)
    points, faces = placed(frame, candidate)
    assert untiled(points, outline(frame), faces) == []
    assert candidate.value >= FEATURE_SQUARED * frame.scale_squared


def test_along_a_clean_side_that_the_t_side_is_not_over_there_is_nothing():
    t_side = [point(x, 1) for x in (0, 1, 2)]
    for a, b in ((point(2, 0), point(0, 0)), (point(1, 0), point(1, 0)), (point(1, 0), point(1, -1)),
                 (point(0, 0), point(2, 3))):
        assert nested_below(frame_of(t_side, a, b)) is None


def test_a_long_gap_is_one_vertex():
    frame = strip([1, 10**6, 1, 1, 10**5, 1])
    first = next(nested_candidates(frame))
    assert len(first.steiner) <= 6 and first.value >= FEATURE_SQUARED * frame.scale_squared


def test_apexes_lie_on_few_lines_through_the_anchors():
    frame = strip(["3/20"] * 60)
    first = next(nested_candidates(frame))
    long = [face for face in first.faces if len(face) > 3]
    assert long and first.value == (LEVEL / 5) ** 2 * frame.scale_squared
    # Walls at the anchors stand in a ratio of 2 or more, so their number is logarithmic.
    assert sum(frame.left in face for face in long) <= 8


@pytest.mark.parametrize("a, b", [((0, 0), (9, 0)), ((-1, -1), (11, 1)), ((-9, 1), (-1, 1)), ((11, 2), (12, 1))])
def test_without_height_over_the_t_side_there_is_no_candidate(a, b):
    frame = frame_of([point(0, 0), point(5, 0), point(10, 0)], point(*a), point(*b))
    assert frame.clean_height() <= 0 and list(nested_candidates(frame)) == []


def test_one_gap_is_allowed():
    frame = strip([20])
    candidates = list(nested_candidates(frame))
    assert candidates and all(len(candidate.steiner) == 1 for candidate in candidates)


def test_four_heights_are_tried_for_few_gaps_and_two_for_many():
    def heights(count):
        frame = strip([4] * count)
        return {apex.y / frame.a.y for candidate in nested_candidates(frame) for apex in candidate.steiner
                if apex.y == min(p.y for p in candidate.steiner)}

    assert heights(3) == {mpq(1, 5), mpq(1, 4), mpq(1, 3), mpq(2, 5)}
    assert heights(4) == {mpq(1, 5), mpq(23, 100)}


def test_an_anchor_on_the_wrong_side_leaves_the_mode_of_the_other():
    # A lies below the line of the T-side and to its left: only fans and groups of B can work.
    u = [point(0, 0), *(point(60 + mpq(k, 5), 0) for k in range(20))]
    frame = frame_of(u, point(-80, "-1/10"), point(64, 1))
    for candidate in nested_candidates(frame):
        points, faces = placed(frame, candidate)
        assert untiled(points, outline(frame), faces) == []
