"""Rooms: chords end before slivers under shallow legs, at either end, and slivers join the room beyond the chord."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import families
import pytest
from constructions import cycle_area, points_of, rings_on_levels, run
from gmpy2 import mpq

from exactmesh.steps.constants import LEVEL, MERGE, TRIM
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset
from exactmesh.steps.rooms import BOTTOM, CHORD, STEP, TOP, Room, rooms_of
from exactmesh.steps.trapezoidation import trapezoidate

NAMES = [*sorted(families.ALL_SMALL | families.SMALL_PSLGS), "hall"]
Ring = Sequence[tuple[Any, int]]
HALF = mpq(1, 2)
# A left leg of slope LEVEL/3 over a chord that begins at (6, 2) and meets the tip (20, 2) of a steep tooth.
TOOTH = [(0, 0), (30, 0), (30, 4), (20 + HALF, 4), (20, 2), (20 - HALF, 4), (12, 4)]
# Two nearly parallel long edges; the chord on level 1 begins below the upper one and ends above the lower one.
WIDE_STRIP = [(0, 0), (100, 1), (200, 2), (140, 2), (40, 1), (-60, 0)]
STRIP = [(0, 0), (100, 1), (200, 2), (168, 2), (68, 1), (-32, 0)]
UNEVEN_STRIP = [(0, 0), (100, 1), (200, 2), (148, 2), (68, 1), (-32, 0)]
# Two teeth touch level 2 between two legs.
TEETH = [(0, 0), (40, 0), (28, 4), (26 + HALF, 4), (26, 2), (26 - HALF, 4), (14 + HALF, 4), (14, 2), (14 - HALF, 4),
         (12, 4)]
VIEWS = [(1, 1), (-1, 1), (1, -1), (-1, -1)]


def seen(ring: Ring, view: tuple[int, int]) -> Ring:
    """Return the ring seen from another side, counter-clockwise still."""
    sx, sy = view
    turned = [(sx * x, sy * y) for x, y in ring]
    return turned if sx * sy > 0 else turned[::-1]


def made(*rings: Ring) -> tuple[Offset, PatchBuilder, list[Room]]:
    """Return the offset, the builder with all vertices, and the rooms of rings on levels."""
    q = rings_on_levels(*rings)
    chords = trapezoidate(q)
    mesh = PatchBuilder(points_of(q, chords), proper=True)
    return q, mesh, rooms_of(mesh, q, chords)


def new_places(mesh: PatchBuilder) -> list[tuple[mpq, mpq]]:
    """Return the new vertices as (x, level)."""
    return [(p.x, p.y / LEVEL - mpq(1, 2)) for p in mesh.points[mesh.first:]]


def outline(room: Room) -> list[int]:
    """Return the vertices of a room, counter-clockwise."""
    return list(dict.fromkeys((*room.chain[BOTTOM], *room.chain[TOP][::-1])))


def check(q: Offset, mesh: PatchBuilder, rooms: list[Room]) -> None:
    """Assert what holds of all rooms: chains run to the right, ends meet, rooms cover Q, steps are `TRIM` high."""
    points = mesh.points
    for room in rooms:
        for t in (TOP, BOTTOM):
            chain, along = room.chain[t], room.along[t]
            assert len(along) == len(chain) - 1
            for (u, v), kind in zip(pairwise(chain), along, strict=True):
                assert points[u].x == points[v].x if kind == STEP else points[u].x < points[v].x
                assert kind != CHORD or points[u].y == points[v].y
                assert kind != STEP or abs(points[u].y - points[v].y) >= TRIM
        for end in (0, -1):
            assert points[room.chain[TOP][end]].x == points[room.chain[BOTTOM][end]].x
    area = sum(cycle_area(points, range(q.first + a, q.first + b)) for a, b in q.rings)
    assert sum(cycle_area(points, outline(room)) for room in rooms) == area
    following = q.successors()
    for edge, v in mesh.on_edge:
        low, high = sorted((q.points[edge].x, q.points[following[edge]].x))
        assert low < points[v].x < high


def chords(rooms: list[Room]) -> int:
    """Return how many pieces of chords two rooms share."""
    pieces = [{pair for room in rooms for pair, kind in zip(pairwise(room.chain[t]), room.along[t], strict=True)
               if kind == CHORD} for t in (TOP, BOTTOM)]
    return len(pieces[0] & pieces[1])


# --- hand cases ---


@pytest.mark.parametrize("view", VIEWS)
def test_a_chord_is_trimmed_at_a_shallow_leg(view: tuple[int, int]) -> None:
    sx, sy = view
    q, mesh, rooms = made(seen(TOOTH, view))
    check(q, mesh, rooms)
    slope = LEVEL / 3
    (k, level), (foot, foot_level) = new_places(mesh)
    assert k == foot == sx * (6 + TRIM / slope) and level == sy * 2
    # The foot is TRIM away from the end of the chord, on the leg.
    assert (foot_level - level) * LEVEL == sy * TRIM
    leg = next(e for e, following in enumerate(q.successors())
               if {q.points[e].x, q.points[following].x} == {0, sx * 12})
    assert mesh.on_edge == [(leg, mesh.first + 1)]


def test_the_sliver_joins_the_room_beyond_the_chord() -> None:
    _, mesh, rooms = made(TOOTH)
    k, foot = mesh.first, mesh.first + 1
    below, left = (next(room for room in rooms if room.z.low == low) for low in (0, 2))
    corner = below.z.tl
    at = below.chain[TOP].index(corner)
    assert below.chain[TOP][at : at + 3] == [corner, foot, k]
    assert below.along[TOP][at : at + 3] == [6, STEP, CHORD]
    # The room above begins with the step.
    assert left.chain[BOTTOM][0] == k and left.chain[TOP][0] == foot and corner not in outline(left)


@pytest.mark.parametrize("view", VIEWS)
def test_both_ends_are_trimmed_where_slivers_fit(view: tuple[int, int]) -> None:
    q, mesh, rooms = made(seen(WIDE_STRIP, view))
    check(q, mesh, rooms)
    reach = TRIM * 100 / LEVEL
    assert {view[0] * x for x, _ in new_places(mesh)} == {40 + reach, 100 - reach} and len(mesh.on_edge) == 2
    assert chords(rooms) == 1


@pytest.mark.parametrize("view", VIEWS)
def test_a_sliver_takes_a_short_chord_whole(view: tuple[int, int]) -> None:
    # A new vertex between the two legs would be 0.017 from one of them: a strip like this had degradation 65.
    q, mesh, rooms = made(seen(STRIP, view))
    check(q, mesh, rooms)
    ((x, level),) = new_places(mesh)
    assert view[0] * x in (68, 100) and abs(level - view[1]) * LEVEL == mpq(32, 100) * LEVEL > TRIM
    assert chords(rooms) == 0 and len(mesh.on_edge) == 1


@pytest.mark.parametrize("view", VIEWS)
def test_of_two_slivers_that_do_not_fit_the_longer_one_is_taken(view: tuple[int, int]) -> None:
    q, mesh, rooms = made(seen(UNEVEN_STRIP, view))
    check(q, mesh, rooms)
    # The lower edge is the shallower one: its sliver reaches to the other end of the chord.
    ((x, level),) = new_places(mesh)
    assert view[0] * x == 68 and view[1] * level == mpq(68, 100)


def test_a_chord_ends_at_a_tip_before_which_there_is_no_room() -> None:
    # A spike of the outside reaches in from the right, under the left leg.
    reach = TRIM * 3 / LEVEL
    for gap, end in ((reach + 2 * MERGE, reach), (reach + MERGE / 2, reach + MERGE / 2)):
        q, mesh, rooms = made([(0, 0), (30, 0), (30, 1), (6 + gap, 2), (30, 3), (30, 4), (12, 4)])
        check(q, mesh, rooms)
        places = new_places(mesh)
        assert (6 + end, 2 + end / 3) in places and {x for x, level in places if level == 2} == {6 + end} - {6 + gap}


def test_both_ends_of_a_row_of_teeth() -> None:
    q, mesh, rooms = made(TEETH)
    check(q, mesh, rooms)
    reach = TRIM * 3 / LEVEL
    assert {x for x, _ in new_places(mesh)} == {6 + reach, 34 - reach} and chords(rooms) == 3


def test_steep_and_upright_legs_are_left_alone() -> None:
    for lean in (0, mpq(1, 10), mpq(-1, 10)):
        q, mesh, rooms = made([(0, 0), (30, 0), (30, 4), (20 + HALF, 4), (20, 2), (20 - HALF, 4), (lean, 4)])
        check(q, mesh, rooms)
        assert new_places(mesh) == [] and mesh.on_edge == []


# --- laws ---


@pytest.mark.parametrize("name", NAMES)
def test_rooms_of_every_family(name: str) -> None:
    made_ = run(name).construction
    q, chords_ = made_.offset, made_.trapezoidation
    mesh = PatchBuilder([*made_.shape.points, *q.points, *chords_.points], proper=True)
    check(q, mesh, rooms_of(mesh, q, chords_))
