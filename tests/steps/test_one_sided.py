"""One-sided quadrilaterals: every one is tiled, and strips of height g keep a fifth of it."""

import random
from fractions import Fraction

import pytest
from constructions import face_feature_squared, point, untiled
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.errors import ConstructionFailed
from exactmesh.geometry.point import Point
from exactmesh.steps.constants import FEATURE_SQUARED, GAP, LEVEL
from exactmesh.steps.one_sided import triangulate_one_sided


def side(gaps, y=0):
    """Return a level T-side from the origin with these gaps."""
    xs = [mpq(0)]
    for gap in gaps:
        xs.append(xs[-1] + mpq(gap))
    return [Point(x, mpq(y)) for x in xs]


def solved(t_side, a, b):
    """Return the points with new vertices numbered after the given ones, the outline and the faces."""
    piece = triangulate_one_sided(t_side, a, b)
    count = len(t_side) + 2
    points = [*t_side, a, b, *piece.steiner]
    faces = [tuple(v if v >= 0 else count - 1 - v for v in face) for face in piece.faces]
    outline = [*range(len(t_side)), count - 1, count - 2]
    signed = sum(p.x * q.y - p.y * q.x for p, q in
                 ((points[outline[i - 1]], points[v]) for i, v in enumerate(outline)))
    return points, outline if signed > 0 else outline[::-1], faces


def assert_tiled(t_side, a, b):
    assert untiled(*solved(t_side, a, b)) == []


def value(t_side, a, b):
    """Return the squared feature size of the faces, neighbours on one side included."""
    points, _, faces = solved(t_side, a, b)
    return min(face_feature_squared(points, face) for face in faces)


def turned(points, t, mirror):
    """Return points turned by the rational angle of t, and reflected before."""
    t = mpq(t)
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return [Point(c * x - s * y, s * x + c * y) for x, y in ((-p.x if mirror else p.x, p.y) for p in points)]


def random_gaps(source, most=80):
    """Return up to 80 gaps of 0.15 or more, in ratios of up to 1e5."""
    spread = source.choice((0, 1, 3, 5))
    return [GAP * mpq(source.randint(100, 999), 100) * mpq(10) ** source.randint(0, spread)
            if source.random() < 0.7 else GAP for _ in range(source.randint(1, most))]


# --- hand cases ---


def test_equal_anchors_make_a_fan():
    piece = triangulate_one_sided(side([1, 2, 1]), point(1, 1), point(1, 1))
    assert piece.faces == ((0, 1, 4), (1, 2, 4), (2, 3, 4)) and piece.steiner == ()


def test_equal_anchors_below_make_a_counter_clockwise_fan():
    piece = triangulate_one_sided(side([1, 2, 1]), point(1, -1), point(1, -1))
    assert piece.faces == ((1, 0, 4), (2, 1, 4), (3, 2, 4))


def test_a_square_is_split():
    piece = triangulate_one_sided(side([1]), point(0, 1), point(1, 1))
    assert len(piece.faces) == 2 and piece.steiner == ()


def test_a_small_square_with_a_t_vertex_in_the_middle_is_split_there():
    # Large enough for the split in the middle, too small for one at the end.
    piece = triangulate_one_sided(side(["3/50", "3/50"]), point(0, "3/25"), point("3/25", "3/25"))
    assert (3, 1, 4) in piece.faces and piece.steiner == ()


def test_the_first_split_that_is_large_enough_is_taken():
    piece = triangulate_one_sided(side([2, 2]), point(0, 4), point(4, 4))
    assert piece.faces == ((0, 1, 4), (1, 2, 4), (3, 0, 4))


def test_a_low_strip_with_many_t_vertices_is_nested():
    piece = triangulate_one_sided(side([GAP] * 30), point(0, LEVEL), point(30 * GAP, LEVEL))
    assert len(piece.steiner) > 10 and max(map(len, piece.faces)) > 3


def test_a_short_clean_side_above_a_few_gaps():
    t_side, a, b = side([1, 1, 1, 1]), point(2, 1), point(mpq(2) + GAP / 3, 1)
    assert_tiled(t_side, a, b)


def test_a_quadrilateral_turned_inside_out_is_refused():
    with pytest.raises(ConstructionFailed) as caught:
        # The sides A u_0 and B u_1 cross.
        triangulate_one_sided(side([1]), point(2, 1), point(-1, 1))
    assert caught.value.step == "one-sided quadrilateral"
    assert caught.value.place == {"t_side": tuple(side([1])), "a": point(2, 1), "b": point(-1, 1)}


def test_a_quadrilateral_without_inside_is_refused():
    with pytest.raises(ConstructionFailed):
        triangulate_one_sided(side([1, 1]), point(-1, 0), point(3, 0))


# --- every quadrilateral is tiled ---


@pytest.mark.parametrize("seed", range(40))
def test_slanted_strips_are_tiled(seed):
    source = random.Random(seed)
    t_side = side(random_gaps(source))
    length = t_side[-1].x
    a = point(-length * source.randint(-20, 20) / 100, mpq(source.randint(20, 3000), 100))
    b = point(length + length * source.randint(-20, 20) / 100, mpq(source.randint(20, 3000), 100))
    turn, mirror = Fraction(source.randint(-50, 50), 17), source.random() < 0.5
    *t_side, a, b = turned([*t_side, a, b], turn, mirror)
    assert_tiled(t_side, a, b)


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("wrong", ["a", "b"])
def test_an_anchor_on_the_wrong_side_does_no_harm(seed, wrong):
    source = random.Random(1000 + seed)
    t_side = side(random_gaps(source, 30))
    length = t_side[-1].x
    # Beyond the end of the T-side and below its line, but above the line from the other anchor through that end.
    other = Point(length * source.randint(20, 80) / 100, mpq(source.randint(25, 300), 100))
    beyond = -mpq(source.randint(1, 200), 10)
    wrong_one = Point(beyond, other.y / other.x * beyond * source.randint(1, 95) / 100)
    a, b = wrong_one, other
    if wrong == "b":
        t_side = [Point(length - p.x, p.y) for p in reversed(t_side)]
        a, b = Point(length - other.x, other.y), Point(length - wrong_one.x, wrong_one.y)
    assert min(a.y, b.y) < 0
    assert_tiled(t_side, a, b)
    *t_side, a, b = turned([*t_side, a, b], Fraction(3, 7), True)
    assert_tiled(t_side, a, b)


@settings(max_examples=100, derandomize=True, deadline=None)
@given(st.lists(st.integers(1, 50), min_size=1, max_size=6), st.integers(-40, 40), st.integers(1, 40),
       st.integers(-40, 40), st.integers(1, 40))
def test_small_quadrilaterals_are_tiled(gaps, xa, ya, xb, yb):
    t_side = side(gaps)
    a, b = point(xa, ya), Point(t_side[-1].x + xb, mpq(yb))
    end = t_side[-1]

    def turn(p, q, r):
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)

    # Simple: A u_0 and B u_m do not meet. All points are on or above the T-side.
    crossing = (turn(t_side[0], a, end) * turn(t_side[0], a, b) <= 0
                and turn(end, b, t_side[0]) * turn(end, b, a) <= 0)
    if not crossing:
        assert_tiled(t_side, a, b)


@pytest.mark.parametrize("seed", range(20))
def test_one_gap_is_tiled(seed):
    source = random.Random(seed)
    length = mpq(source.randint(1, 10**4), 10)
    a = Point(-mpq(source.randint(0, 100), 10), mpq(source.randint(1, 100), 10))
    b = Point(length + mpq(source.randint(0, 100), 10), mpq(source.randint(1, 100), 10))
    assert_tiled(side([length]), a, b)


# --- the feature size of strips ---


@pytest.mark.parametrize("seed", range(60))
def test_a_strip_of_height_g_keeps_a_fifth_of_it(seed):
    source = random.Random(seed)
    t_side = side(random_gaps(source))
    a, b = Point(mpq(0), LEVEL), Point(t_side[-1].x, LEVEL)
    assert_tiled(t_side, a, b)
    assert value(t_side, a, b) >= FEATURE_SQUARED


@pytest.mark.parametrize("gaps", [
    [GAP] * 80, [GAP] * 9, [GAP], [GAP, 10**5], [10**5, GAP], [GAP, 10**5, GAP] * 20, [GAP * 2**k for k in range(20)],
    [GAP * 2**k for k in range(20)][::-1], [GAP, mpq(82, 100)] * 40, [10**5] * 80,
])
def test_hand_made_strips_keep_a_fifth(gaps):
    t_side = side(gaps)
    a, b = Point(mpq(0), LEVEL), Point(t_side[-1].x, LEVEL)
    assert_tiled(t_side, a, b)
    assert value(t_side, a, b) >= FEATURE_SQUARED


@pytest.mark.parametrize("seed", range(30))
def test_strips_with_leaning_ends_and_more_height_keep_a_fifth(seed):
    source = random.Random(seed)
    t_side = side(random_gaps(source, 30))
    high = LEVEL * (1 + mpq(source.randint(0, 300), 100))
    out = [mpq(source.randint(0, 100), 100) for _ in range(2)]
    a, b = Point(-out[0], LEVEL), Point(t_side[-1].x + out[1], high)
    assert_tiled(t_side, a, b)
    assert value(t_side, a, b) >= FEATURE_SQUARED


# --- laws ---


@pytest.mark.parametrize("seed", range(20))
def test_turning_the_quadrilateral_turns_the_piece(seed):
    source = random.Random(seed)
    t_side = side(random_gaps(source, 20))
    given_points = [*t_side, Point(mpq(0), LEVEL), Point(t_side[-1].x + 1, LEVEL * 2)]
    piece = triangulate_one_sided(given_points[:-2], *given_points[-2:])
    moved = turned(given_points, Fraction(source.randint(-9, 9), 5), False)
    other = triangulate_one_sided(moved[:-2], *moved[-2:])
    assert other.faces == piece.faces


@pytest.mark.parametrize("seed", range(20))
def test_a_mirror_image_has_the_same_faces_turned_round(seed):
    source = random.Random(seed)
    t_side = side(random_gaps(source, 20))
    a, b = Point(mpq(0), LEVEL), Point(t_side[-1].x + 1, LEVEL * 2)
    piece = triangulate_one_sided(t_side, a, b)
    below = triangulate_one_sided([Point(p.x, -p.y) for p in t_side], Point(a.x, -a.y), Point(b.x, -b.y))
    assert below.faces == tuple(face[::-1] for face in piece.faces)
    assert below.steiner == tuple(Point(p.x, -p.y) for p in piece.steiner)


@pytest.mark.parametrize("seed", range(20))
def test_there_is_at_most_one_new_vertex_a_gap(seed):
    t_side = side(random_gaps(random.Random(seed)))
    piece = triangulate_one_sided(t_side, Point(mpq(0), LEVEL), Point(t_side[-1].x, LEVEL))
    assert len(piece.steiner) <= len(t_side) - 1
