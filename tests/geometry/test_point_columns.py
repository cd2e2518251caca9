"""Columns of points and of faces: every array says, or contains, what exact arithmetic says one by one."""

import random
from itertools import pairwise, permutations

import numpy as np
import pytest
from gmpy2 import mpq
from test_balls import assert_contained

from exactmesh.geometry import face_columns
from exactmesh.geometry.columns import Columns, Rows, column_of, columns_of, indices
from exactmesh.geometry.decisions import Count, decisions, forget
from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.face_columns import Corners, FaceColumns, features_squared, unpaired_sides
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area, orientation
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.planar.cycles import directed_edges

PLACES = {"as it is": (mpq(1), mpq(0)), "tiny": (mpq(1, 10**30), mpq(0)), "far": (mpq(1, 7), mpq(10**25)),
          "huge": (mpq(10) ** 40, mpq(0)), "a little far": (mpq(1), mpq(-17 * 2000))}


def points(place: str, seed: int = 1, count: int = 120) -> list[Point]:
    """Return random points, some of them in line, scaled and moved."""
    source = random.Random(seed)
    factor, shift = PLACES[place]
    found = [Point(mpq(source.randint(-3000, 3000), 3), mpq(source.randint(-3000, 3000), 7)) for _ in range(count)]
    found += [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in pairwise(found[:41])]
    return [Point(p.x * factor + shift, p.y * factor - shift) for p in found]


def triples(count: int) -> np.ndarray:
    source = random.Random(2)
    some = [source.sample(range(count), 3) for _ in range(300)]
    return np.array(some + [[i, i + 1, 120 + i] for i in range(40)]).T


@pytest.mark.parametrize("place", PLACES)
def test_measures_are_contained_and_narrow(place: str) -> None:
    at = points(place)
    columns = Columns(at)
    assert list(columns) == at and len(columns) == len(at) and columns[3] == at[3] and columns[2:4] == at[2:4]
    a, b, c = triples(len(at))
    rows = [(at[i], at[j], at[k]) for i, j, k in zip(a.tolist(), b.tolist(), c.tolist(), strict=True)]
    unit = float(PLACES[place][0]) ** 2 * 10**6
    heights = [doubled_area(p, q, r) ** 2 / max(distance_squared(p, q), distance_squared(q, r), distance_squared(r, p))
               for p, q, r in rows]
    for balls, values, size in (
            (columns.doubled_areas(a, b, c), [doubled_area(*row) for row in rows], unit),
            (columns.distances_squared(a, b), [distance_squared(p, q) for p, q, _ in rows], unit),
            (columns.vectors(a, b).dot(columns.vectors(a, c)),
             [(q.x - p.x) * (r.x - p.x) + (q.y - p.y) * (r.y - p.y) for p, q, r in rows], unit),
            (columns.heights_squared(a, b, c), heights, unit),
            (columns.segment_distances_squared(c, a, b),
             [segment_distance_squared(r, p, q) for p, q, r in rows], unit)):
        assert_contained(balls, values)
        assert np.isfinite(balls.rad).all() and np.median(balls.rad) <= 1e-9 * size


@pytest.mark.parametrize("place", PLACES)
def test_turns_are_exact_and_few_need_exact_arithmetic(place: str) -> None:
    at = points(place)
    a, b, c = triples(len(at))
    forget()
    turns = Columns(at).turns(a, b, c)
    expected = [orientation(at[i], at[j], at[k]) for i, j, k in zip(a.tolist(), b.tolist(), c.tolist(), strict=True)]
    assert turns.tolist() == expected and turns.dtype == np.int64
    zeros = expected.count(0)
    assert zeros >= 40 and decisions() == {"turn": Count(340 - zeros, zeros)}


def test_columns_are_made_once() -> None:
    at = points("as it is")
    columns = columns_of(at)
    assert columns_of(columns) is columns and columns.points is at
    assert indices(iter([3, 1]), 2).tolist() == indices([3, 1]).tolist() == [3, 1]


@pytest.mark.parametrize("values", [
    [mpq(10**30), mpq(10**30) + mpq(1, 3)], [mpq(-10**30), mpq(-10**30) + 7], [mpq(10) ** 400, mpq(10) ** 400 + 1],
    [mpq(5)], [mpq(17), mpq(18)], [mpq(10**6, 3), mpq(10**6 + 1, 3)]])
def test_what_is_far_away_is_moved_by_a_whole_number(values: list[mpq]) -> None:
    column = column_of(values)
    whole = {round(v - mpq(mid)) for v, mid in zip(values, column.mid.tolist(), strict=True)}
    assert len(whole) == 1
    assert_contained(column, [v - whole.copy().pop() for v in values])
    assert (np.abs(column.mid) <= max(1, 2 * float(max(values) - min(values)))).all()


@pytest.mark.parametrize("values", [[mpq(-1), mpq(1)], [mpq(1), mpq(9, 8)], [mpq(10) ** 400, mpq(-10) ** 401]])
def test_what_is_near_or_beyond_floats_stays(values: list[mpq]) -> None:
    column = column_of(values)
    if max(values) < 10:
        assert column.mid.tolist() == [float(v) for v in values]
    else:
        assert column.signs().tolist() == [0, 0]
    assert len(column_of([])) == 0


def test_rows_of_any_length() -> None:
    rows = Rows([(4, 5), (), (6,), (7, 8, 9)])
    assert (rows.size.tolist(), rows.start.tolist()) == ([2, 0, 1, 3], [0, 2, 2, 3, 6])
    assert rows.flat.tolist() == [4, 5, 6, 7, 8, 9]
    place, start = rows.places(np.array([3, 0, 2]))
    assert (rows.flat[place].tolist(), start.tolist()) == ([7, 8, 9, 4, 5, 6], [0, 3, 5, 6])
    assert len(rows) == 4


GRID = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (4, 0), (0, 4), (2, 0), (2, 2), (0, 2), (1, 0))]
SOME = [(0, 1, 2), (0, 2, 1), (0, 3, 1, 2), (0, 1), (), (0, 3, 1, 4, 2, 5), (0, 6, 3, 1, 2), (0, 3, 6, 1, 2), (5,),
        (3, 1, 4, 5), (0, 3, 1), (1, 4, 2, 0, 3), (0, 1, 4, 3), (1, 2, 0)]


@pytest.mark.parametrize("cycles", [SOME, [*SOME, ()], SOME[:2], SOME[2:4], [], [*permutations(range(5), 4)],
                                    [*permutations(range(6), 3)], [(), (3,), (0, 3, 1, 2)],
                                    [(0, 1, 2), (4, 5, 3), (4, 5, 1)]])
def test_faces_are_those_found_one_by_one(cycles: list[tuple[int, ...]]) -> None:
    columns, faces = Columns(GRID), FaceColumns(cycles)
    corners = Corners(columns, faces)
    one_by_one = [corners_of(GRID, cycle) for cycle in cycles]
    assert corners.bad.tolist() == [i for i, found in enumerate(one_by_one) if isinstance(found, NotTriangle)]
    seen: list[int] = []
    for numbers, values in features_squared(columns, faces, corners):
        for number, low, high in zip(numbers.tolist(), values.low().tolist(), values.high().tolist(), strict=True):
            found = one_by_one[number]
            if not isinstance(found, NotTriangle):
                seen.append(number)
                exact = face_feature_squared(GRID, cycles[number], found)
                assert mpq(low) <= exact <= mpq(high) and high - low <= 1e-9
    assert sorted(seen) == [i for i, found in enumerate(one_by_one) if not isinstance(found, NotTriangle)]
    first, last = faces.sides()
    sides = [(cycle[i - 1], cycle[i]) for cycle in cycles for i in range(len(cycle))]
    assert sorted(zip(first.tolist(), last.tolist(), strict=True)) == sorted(sides)
    owner, repeated = directed_edges(cycles)
    found_sides = unpaired_sides(faces, len(GRID))
    if len(set(sides)) < len(sides):
        assert found_sides is None and len(owner) + len(repeated) <= len(sides)
    else:
        assert found_sides is not None
        assert [divmod(key, len(GRID)) for key in found_sides.tolist()] == sorted(
            side for side in sides if side[::-1] not in set(sides))


@pytest.mark.parametrize("chunk", [1, 3, 1 << 13])
def test_features_of_faces_with_t_vertices(chunk: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(face_columns, "CHUNK", chunk)
    source = random.Random(4)
    at: list[Point] = []
    cycles: list[tuple[int, ...]] = []
    while len(cycles) < 60:
        corners = [Point(mpq(source.randint(-50, 50), 3), mpq(source.randint(-50, 50))) for _ in range(3)]
        if orientation(*corners) <= 0:
            continue
        run = []
        for p, q in zip(corners, corners[1:] + corners[:1], strict=True):
            parts = source.choice([[], [1], [999], [50, 950], [500, 501], [499, 500, 501], [300]])
            run += [Point(p.x + (q.x - p.x) * t / 1000, p.y + (q.y - p.y) * t / 1000) for t in (0, *parts)]
        start = source.randrange(len(run))
        cycles.append(tuple(len(at) + (start + i) % len(run) for i in range(len(run))))
        at += run
    columns, faces = Columns(at), FaceColumns(cycles)
    corners_found = Corners(columns, faces)
    assert corners_found.bad.tolist() == [] and faces.count == 60
    seen = []
    for numbers, values in features_squared(columns, faces, corners_found):
        for number, low, high in zip(numbers.tolist(), values.low().tolist(), values.high().tolist(), strict=True):
            places = corners_of(at, cycles[number])
            assert not isinstance(places, NotTriangle)
            exact = face_feature_squared(at, cycles[number], places)
            assert mpq(low) <= exact <= mpq(high) and high - low <= 1e-7 * high + 1e-9
            seen.append(number)
    assert sorted(seen) == list(range(60))


def test_a_walk_that_hardly_goes_on_or_back_is_decided_exactly() -> None:
    hair = mpq(1, 10**40)
    at = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (1, 0), (0, 1), ("1/3", 0), (mpq(1, 3) + hair, 0),
                                                 ("1/4", "1/4"))]
    cycles = [(0, 3, 1, 2), (0, 3, 4, 1, 2), (0, 4, 3, 1, 2), (0, 1, 2), (0, 1, 5, 2), (0, 1), (0, 4, 1, 2),
              (0, 3, 1, 2)]
    forget()
    assert Corners(Columns(at), FaceColumns(cycles)).bad.tolist() == [2, 4, 5]
    counts = decisions()["ahead"]
    assert (counts.by_floats, counts.exactly) == (5, 4)


@pytest.mark.parametrize("far", [mpq(0), mpq(10**30), mpq(10) ** 400])
def test_further_points_are_moved_like_the_first(far: mpq) -> None:
    first = [Point(far + i * i, mpq(i, 3)) for i in range(9)]
    more = [Point(far - mpq(i, 7), mpq(5, i)) for i in range(1, 6)]
    columns = Columns(first)
    both = columns.extended(more)
    assert list(both) == first + more and list(columns) == first
    assert (both.x.mid[:9] == columns.x.mid).all() and (both.y.mid[:9] == columns.y.mid).all()
    moved = round(first[0].x - mpq(float(both.x.mid[0])))
    assert_contained(both.x, [p.x - moved for p in both])
    assert_contained(both.y, [p.y for p in both])
