"""Pieces that no candidate was good enough for before the last ones: what they need, found by proving the bound."""

import pytest
from constructions import face_feature_squared, point, untiled
from gmpy2 import mpq

from exactmesh import api
from exactmesh.claims.ledger import CLAIMS
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg
from exactmesh.steps import nested, one_sided
from exactmesh.steps.constants import DESIGN_DEGRADATION, FEATURE_SQUARED, FLAT, LEVEL, WIDE
from exactmesh.steps.frame import Frame, frame_of
from exactmesh.steps.one_sided import triangulate_one_sided


def halving(first: mpq) -> list[mpq]:
    """Return the places of three flat caps, in levels from an anchor: the first apexes stand at c, 2 c, and a hair
    beyond 4 c, the second left of its cap by its inset, so that there are no others in a row."""
    inset = 1 + FLAT / LEVEL
    return [first, 2 * first + inset, 4 * first + mpq(1, 10**6)]


def six_points(first: mpq, low: mpq, phase: mpq) -> Pslg:
    """Return a room with six points, three towards either end, on one level below a strip one level high."""
    places = halving(first)
    width, height = 2 * WIDE + 5 * places[-1] * LEVEL, 3 + phase
    xs = [WIDE + place * LEVEL for place in places]
    ys = [height - 1, height - 1 - low, height - 1]
    corners = [point(0, 0), point(width, 0), point(width, height), point(0, height)]
    inside = [point(x, y) for x, y in zip([*xs, *(width - x for x in reversed(xs))], [*ys, *reversed(ys)], strict=True)]
    return Pslg((*corners, *inside), ((0, 1), (1, 2), (2, 3), (3, 0)))


@pytest.mark.parametrize("first, low, phase", [("747/250", "0", "0"), ("2939/1000", "3/20", "13/100")])
def test_members_exactly_half_as_far_out_keep_their_distance(first: str, low: str, phase: str) -> None:
    # Walls in a ratio of exactly 2: degradations were 21.59995 and, beyond the design value, 21.60157.
    result = api.mesh(six_points(mpq(first), mpq(low), mpq(phase)))
    assert {j.claim.id for j in result.judgements} >= {"repaired.interior-feature", "repaired.degradation"} <= {
        claim.id for claim in CLAIMS}
    assert result.holds
    assert result.verification.degradation_squared is not None
    assert mpq(2155, 100) ** 2 < result.verification.degradation_squared <= DESIGN_DEGRADATION**2


def strip() -> Frame:
    """Return the strip above the six points."""
    places = halving(mpq(747, 250))
    width = 5 * places[-1]
    caps = [place + sign * FLAT / LEVEL for place in places for sign in (-1, 1)]
    u = [mpq(0), *caps, *(width - x for x in reversed(caps)), width]
    return frame_of([point(x * LEVEL, 0) for x in u], point(0, LEVEL), point(width * LEVEL, LEVEL))


def test_the_last_nested_candidate_keeps_a_fifth_where_no_other_does() -> None:
    frame = strip()
    wanted = FEATURE_SQUARED * frame.scale_squared
    *others, last = [trial.candidate(frame) for trial in nested.nested_trials(frame)]
    assert max(c.value for c in others) < wanted == last.value


def neck(height: mpq, least: mpq) -> tuple[list[Point], Point, Point]:
    """Return a piece whose anchors are 0.06 apart, with T-vertices from `least` heights out to two on both sides."""
    far = [x for x in (least * height + i * 2 * FLAT for i in range(50)) if x <= 2 * height]
    us = [-3 * height, *(-x for x in reversed(far)), *far, 3 * height]
    return [point(x, 0) for x in us], point(0, height), point(mpq(6, 100), height)


@pytest.mark.parametrize("levels, least", [(3, "95/100"), (8, "9/10"), (8, "98/100")])
def test_a_narrow_neck_over_a_wide_room_gets_a_hub(levels: int, least: str) -> None:
    t_side, a, b = neck(levels * LEVEL, mpq(least))
    piece = triangulate_one_sided(t_side, a, b)
    m = len(t_side) - 1
    assert len(piece.steiner) == 1 and len(piece.faces) == m + 3 and m > 8
    points = [*t_side, a, b, *piece.steiner]
    faces = [tuple(v if v >= 0 else m + 3 for v in face) for face in piece.faces]
    assert untiled(points, [*range(m + 1), m + 2, m + 1], faces) == []
    assert min(face_feature_squared(points, face) for face in faces) >= FEATURE_SQUARED
    # Splits and nested triangles are not enough.
    frame = frame_of(t_side, a, b)
    wanted = FEATURE_SQUARED * frame.scale_squared
    assert all(c.value < wanted for c in (*one_sided._splits(frame), *nested.nested_candidates(frame)))


def test_many_t_vertices_below_a_side_of_four_heights_are_split_in_the_middle() -> None:
    # From below either anchor the other is too far for gaps of 0.15.
    height, gaps = 8 * LEVEL, 48
    t_side = [point(i * 2 * FLAT, 0) for i in range(gaps + 1)]
    piece = triangulate_one_sided(t_side, point(0, height), t_side[-1]._replace(y=height))
    assert piece.steiner == () and piece.faces[-1] == (gaps + 1, gaps // 2, gaps + 2)
