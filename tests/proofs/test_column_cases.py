"""What the proofs about polygons between columns are given is true of internal meshes as they are made."""

import importlib
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

import exactmesh
from exactmesh.claims.run import Run
from exactmesh.families.random_polygons import random_simple_polygon, spike_with_ledges
from exactmesh.families.shapes import comb
from exactmesh.geometry.point import cross, dot, minus
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.columns import _Columns
from exactmesh.steps.constants import LEVEL_EDGE, MERGE
from exactmesh.steps.rooms import BOTTOM, CHORD, TOP
from exactmesh.steps.tube import _chains


@pytest.fixture
def script(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(Path(exactmesh.__file__).parents[1] / "proofs_checks"))
    return importlib.import_module


INPUTS = [random_simple_polygon(12, 3), random_simple_polygon(20, 5), spike_with_ledges(20, 1), comb(4)]


@pytest.mark.parametrize("pslg", INPUTS)
def test_neighbours_on_edges_of_q_are_as_far_apart_along_edges_of_p(script: Any, pslg: Pslg) -> None:
    given = script("repaired_columns_tube")
    made = Run(pslg, "repaired", "internal").repaired
    first, points, seen = made.trapezoidation.first, made.points, 0
    on_edge = [(edge, first + i) for i, edge in enumerate(made.trapezoidation.edge)] + list(made.interior.on_edge)
    for k, chain in enumerate(_chains(made.offset, on_edge, points)):
        source = made.offset.source[k]
        if source < 0 or len(chain) == 2:
            continue
        e = minus(points[made.shape.origin[source ^ 1]], points[made.shape.origin[source]])
        length = dot(e, e)
        whole = minus(points[chain[-1]], points[chain[0]])
        assert cross(e, whole) ** 2 <= given.STEEPEST**2 * dot(e, whole) ** 2
        for u, v in pairwise(chain):
            side = minus(points[v], points[u])
            assert dot(side, e) > 0 and dot(side, side) >= MERGE**2
            assert dot(side, e) ** 2 >= given.WIDE_GAP**2 * length or (
                dot(side, e) ** 2 >= given.LEAST_GAP**2 * length and dot(whole, e) ** 2 <= given.REACH**2 * length
                and cross(whole, e) ** 2 <= given.RISE**2 * length)
            seen += 1
    assert seen


@pytest.mark.parametrize("pslg", INPUTS)
def test_legs_are_as_deep_below_chords(script: Any, pslg: Pslg) -> None:
    given = script("repaired_columns_legs")
    made = Run(pslg, "repaired", "internal").repaired
    columns = _Columns(made.offset, made.trapezoidation, made.points[: made.interior.first])
    columns.run()
    points, seen = columns.mesh.points, 0
    for room in columns.rooms:
        place = {t: {v: i for i, v in enumerate(room.chain[t])} for t in (TOP, BOTTOM)}
        inner = sorted((place[TOP][a], place[BOTTOM][b]) for a, b in columns.across[id(room)])
        for begin, end in pairwise([(0, 0), *inner, (len(room.chain[TOP]) - 1, len(room.chain[BOTTOM]) - 1)]):
            parts = {t: room.along[t][i:j] for t, i, j in zip((TOP, BOTTOM), begin, end, strict=True)}
            for t in (TOP, BOTTOM):
                if parts[t] != [CHORD] or len(parts[-t]) != 1 or parts[-t][0] < 0:
                    continue
                i, j = (begin[0], begin[1]) if t == TOP else (begin[1], begin[0])
                ps, fs = ([points[v] for v in chain[n : n + 2]] for chain, n in
                          ((room.chain[t], i), (room.chain[-t], j)))
                slope = (fs[1].y - fs[0].y) / (fs[1].x - fs[0].x)
                assert ps[1].x - ps[0].x >= LEVEL_EDGE and fs[1].x > fs[0].x
                for p, f in zip(ps, fs, strict=True):
                    if p == f:
                        continue
                    depth = t * (p.y - fs[0].y - slope * (p.x - fs[0].x))
                    assert abs(p.x - f.x) <= MERGE and t * (p.y - f.y) >= given.LOW
                    assert depth >= given.DEEP and depth**2 >= given.FAR**2 * (1 + slope**2)
                    seen += 1
    assert seen
