"""Windows: what falls into them is where it belongs, what is far outside is cut off exactly."""

from fractions import Fraction

import pytest
import shapely
from constructions import point
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.pictures.view import around, view_of, window

small = st.fractions(min_value=-60, max_value=60, max_denominator=8)
places = st.tuples(small, small)
UNIT = window(point(0, 0), point(10, 10), 100.0)


def on(p: tuple[Fraction, Fraction]) -> Point:
    return Point(mpq(p[0]), mpq(p[1]))


@settings(max_examples=50)
@given(places, places, places)
@example((Fraction(-50), Fraction(-50)), (Fraction(60), Fraction(-50)), (Fraction(5), Fraction(60)))
@example((Fraction(0), Fraction(0)), (Fraction(0), Fraction(0)), (Fraction(1), Fraction(60)))
def test_polygons_are_cut_where_they_leave(a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction],
                                           c: tuple[Fraction, Fraction]) -> None:
    drawn = UNIT.polygon([on(a), on(b), on(c)])
    whole = shapely.Polygon([(float(10 * x), float(100 - 10 * y)) for x, y in (a, b, c)])
    seen = whole.intersection(shapely.box(0, 0, 100, 100))
    if not drawn:
        assert seen.area == 0
        return
    assert all(-100.001 <= z <= 200.001 for place in drawn for z in place) or all(
        whole.covers(shapely.Point(p)) for p in drawn)
    cut = shapely.Polygon(drawn) if len(drawn) > 2 else shapely.Polygon()
    assert abs(cut.intersection(shapely.box(0, 0, 100, 100)).area - seen.area) < 1e-6


@settings(max_examples=50)
@given(places, places)
@example((Fraction(-60), Fraction(5)), (Fraction(60), Fraction(5)))
def test_segments_are_cut_where_they_leave(a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction]) -> None:
    drawn = UNIT.segment(on(a), on(b))
    whole = shapely.LineString([(float(10 * x), float(100 - 10 * y)) for x, y in (a, b)])
    seen = whole.intersection(shapely.box(0, 0, 100, 100)).length
    found = shapely.LineString(drawn).intersection(shapely.box(0, 0, 100, 100)).length if drawn else 0.0
    assert abs(found - seen) < 1e-6


def test_a_far_end_does_not_spoil_what_is_near() -> None:
    # A line of slope 1 through (1, 1) that runs 10^40 on either side: floats alone would lose its place.
    view = around(point(1, 1), mpq(1, 10**6), 100.0)
    far = mpq(10) ** 40
    (x0, y0), (x1, y1) = view.segment(Point(1 - far, 1 - far), Point(1 + far, 1 + far))
    assert (x0, y0) == (-100.0, 200.0) and (x1, y1) == (200.0, -100.0)
    triangle = view.polygon([Point(1 - far, mpq(1)), Point(1 + far, mpq(1)), Point(mpq(1), 1 + far)])
    # Below half of the window is empty, above it is full.
    assert {y for _, y in triangle} == {50.0, -100.0} and {x for x, _ in triangle} == {-100.0, 200.0}


@settings(max_examples=50)
@given(st.lists(places, min_size=1, max_size=9))
def test_a_view_of_all_points_holds_them(points: list[tuple[Fraction, Fraction]]) -> None:
    view = view_of(list(map(on, points)), 300.0)
    assert all(view.holds(place) for place in view.places(map(on, points)))
    assert view.places(map(on, points)) == [view.place(on(p)) for p in points]
    assert 40 <= view.width <= 330 and 40 <= view.height <= 330


@settings(max_examples=50)
@given(st.lists(places, min_size=3, max_size=6))
def test_what_is_shown_by_numbers_is_what_is_not_missed(points: list[tuple[Fraction, Fraction]]) -> None:
    shown = UNIT.shown(list(map(on, points)))
    assert shown is not None
    assert shown(range(len(points))) == (not UNIT.misses(UNIT.places(map(on, points))))
    assert view_of(list(map(on, points))).shown(list(map(on, points))) is None


def test_panels_far_from_the_origin_have_places_of_their_own() -> None:
    near = view_of([point(5, 5), point(7, 9)]).panel("P", "", ())
    assert near.offset is None and near.left < 5 < near.top
    for points in ([Point(mpq(10) ** 20, mpq(0)), Point(mpq(10) ** 20 + 1, mpq(1))],
                   [Point(mpq(10) ** 400, mpq(0)), Point(mpq(2 * 10**400), mpq(1))],
                   [Point(mpq(1, 10**400), mpq(0)), Point(mpq(2, 10**400), mpq(1, 10**400))]):
        far = view_of(points).panel("P", "", ())
        assert far.offset is not None and (far.left, far.unit) == (0.0, 1.0)


@pytest.mark.parametrize("low, high", [((0, 0), (0, 1)), ((0, 0), (1, 0)), ((2, 0), (1, 1))])
def test_an_empty_window_is_refused(low: tuple[int, int], high: tuple[int, int]) -> None:
    with pytest.raises(InputError, match="is empty"):
        window(point(*low), point(*high))
