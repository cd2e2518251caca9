"""The lists of cases for internal meshes are complete, and what they rest on is true of rooms as they are made."""

import importlib
from itertools import product
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.claims.run import Run
from exactmesh.families.domains import polygon_with_holes
from exactmesh.families.random_polygons import random_simple_polygon, spike_with_ledges
from exactmesh.families.shapes import comb
from exactmesh.geometry.distance import distance_squared
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.columns import _Columns
from exactmesh.steps.constants import LEVEL, MERGE, SEPARATION
from exactmesh.steps.rooms import BOTTOM, CHORD, STEP, TOP


@pytest.fixture
def rooms(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(Path(exactmesh.__file__).parents[1] / "proofs_checks"))
    return importlib.import_module("repaired_rooms")


def test_pieces_of_chords_have_one_label(rooms: Any) -> None:
    found = list(rooms.pieces())
    assert len(found) == 48 and len(dict.fromkeys(kind for _, kind in found)) == 48
    assert {label for label, _ in found} == set(rooms.LABELS)
    # Which ends may be chord ends decides, not which legs are there.
    assert all((label == "touch") == (not kind[0] and not kind[1]) for label, kind in found)


def test_no_angle_above_180_degrees_lies_around_an_extreme_vertex(rooms: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    assert rooms.check_sides() == 210
    made = rooms.vertices_at
    # Without the upright edges of the octagon there would be such vertices.
    monkeypatch.setattr(rooms, "vertices_at", lambda d0, d1: made(d0, d1)[:1])
    with pytest.raises(AssertionError):
        rooms.check_sides()


def test_polygons_between_chains_are_triangulated(rooms: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    assert rooms.check_polygons(3, 3) > 50
    monkeypatch.setattr(rooms, "triangulate_small", lambda outline: tuple(
        (0, i, i + 1) for i in range(1, len(outline) - 1)))
    with pytest.raises(AssertionError):
        rooms.check_polygons(4, 3)


def assert_as_argued(pslg: Pslg) -> int:
    """Assert what the argument says of the rooms of an internal mesh; return the number of columns."""
    run = Run(pslg, "repaired", "internal")
    made = run.repaired
    first = made.interior.first
    columns = _Columns(made.offset, made.trapezoidation, made.points[:first])
    columns.run()
    points, count = columns.mesh.points, 0
    for room in columns.rooms:
        places = {t: {v: i for i, v in enumerate(room.chain[t])} for t in (TOP, BOTTOM)}
        for t in (TOP, BOTTOM):
            for u, v, kind in zip(room.chain[t], room.chain[t][1:], room.along[t], strict=False):
                gap = points[v].x - points[u].x
                assert gap == 0 if kind == STEP else gap > 0
                if kind == CHORD:
                    new = {w for w in (u, v) if w >= first}
                    assert gap > MERGE if new else gap >= SEPARATION
                elif kind >= 0:
                    assert distance_squared(points[u], points[v]) >= MERGE**2
            for place in range(1, len(room.chain[t]) - 1):
                if columns._needs_edge(room, t, place):
                    assert points[room.chain[t][place]].y == (room.level(t) + mpq(1, 2)) * LEVEL
        across = [(places[TOP][a], places[BOTTOM][b]) for a, b in columns.across[id(room)]]
        assert all((a <= c and b <= d) or (a >= c and b >= d) for (a, b), (c, d) in product(across, repeat=2))
        count += len(across)
    return count


def test_rooms_are_as_the_argument_says() -> None:
    inputs = (comb(9), spike_with_ledges(20, 3), random_simple_polygon(40, 5, "star"), polygon_with_holes(2, 2, 1))
    assert sum(map(assert_as_argued, inputs)) > 100
