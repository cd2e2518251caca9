"""The comparison with other meshers: what is measured, on hand-made outputs, and the command."""

import csv
import io
import json
import os
import time
from collections.abc import Sequence
from pathlib import Path

import families
import pytest
from gmpy2 import mpq

from exactmesh import cli
from exactmesh.commands import reproduce
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.reproduce.peer_inputs import HARD_GROUPS, Input, inputs, maze, snowflake, square_island
from exactmesh.reproduce.peer_tools import PEERS, Made, Outline, Output, Tool, Unfit, Workshop
from exactmesh.reproduce.peers import GUARANTEED, OPTIMIZED, Measured, PeerRow, measure, outline_of, peer_rows, rounded
from exactmesh.reproduce.peers_text import peers_csv, peers_json, peers_text

SQUARE = families.ring([(0, 0), (4, 0), (4, 4), (0, 4)])


def measured(pslg: Pslg, vertices: Sequence[tuple[float, float]], triangles: Sequence[tuple[int, int, int]]
             ) -> Measured:
    subdivision: Subdivision = domain_of(pslg)
    size = minimum_feature_size(pslg)
    assert size is not None
    return measure(subdivision, size.squared, Output("made", "", 0.0, tuple(vertices), tuple(triangles)))


# --- measuring ---


def test_a_mesh_in_any_order_and_orientation_is_recognised() -> None:
    corners = [(4.0, 4.0), (0.0, 0.0), (9.0, 9.0), (0.0, 4.0), (4.0, 0.0)]  # (9, 9) is on no face
    assert measured(SQUARE, corners, [(1, 4, 0), (1, 3, 0)]) == Measured(True, mpq(2), 0, 0, 2)


def test_a_vertex_on_the_boundary_is_counted_and_lowers_the_feature_size() -> None:
    corners = [(0.0, 0.0), (1.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
    # The least height, 4/5 of the side from (1, 0) to (4, 4) is 12/5; the edge from (0, 0) to (1, 0) is 1 long.
    found = measured(SQUARE, corners, [(0, 1, 4), (1, 2, 3), (1, 3, 4)])
    assert (found.is_mesh, found.steiner, found.boundary) == (True, 1, 1)
    assert found.degradation_squared == mpq(16) / (mpq(4) ** 2 / 17)


def test_a_vertex_inside_is_not_on_the_boundary() -> None:
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (2.0, 2.0)]
    fan = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    assert measured(SQUARE, corners, fan) == Measured(True, mpq(4), 1, 0, 4)


def test_a_split_edge_between_two_faces_is_counted() -> None:
    halves = Pslg(SQUARE.vertices, (*SQUARE.edges, (0, 2)))
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0), (2.0, 2.0), (1.0, 1.0)]
    fan = [(0, 1, 5), (5, 1, 4), (1, 2, 4), (2, 3, 4), (4, 3, 5), (3, 0, 5)]
    found = measured(halves, corners, fan)
    assert (found.is_mesh, found.boundary, found.steiner) == (True, 2, 2)


def test_a_rounded_boundary_vertex_makes_it_no_mesh_but_its_edges_are_measured() -> None:
    slanted = families.ring([(0, 0), (3, 1), (0, 1)])
    corners = [(0.0, 0.0), (1.0, 1 / 3), (3.0, 1.0), (0.0, 1.0)]
    found = measured(slanted, corners, [(0, 1, 3), (1, 2, 3)])
    assert not found.is_mesh and found.boundary == 1
    assert found.degradation_squared is not None and mpq(1) < found.degradation_squared < mpq(10)


@pytest.mark.parametrize("triangles", [
    pytest.param([(0, 1, 2)], id="half"), pytest.param([], id="nothing"),
    pytest.param([(0, 1, 2), (0, 1, 3)], id="crossing"), pytest.param([(0, 1, 1), (0, 2, 3)], id="flat")])
def test_what_is_no_mesh_is_told(triangles: list[tuple[int, int, int]]) -> None:
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)]
    found = measured(SQUARE, corners, triangles)
    assert not found.is_mesh
    assert (found.degradation_squared is None) == (len(triangles) != 1)


def test_a_moved_vertex_of_the_input_is_told() -> None:
    corners = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (1e-9, 4.0)]
    assert not measured(SQUARE, corners, [(0, 1, 2), (0, 2, 3)]).is_mesh


# --- meshers in a process of their own ---


def _diagonal(outline: Outline) -> Made:
    return outline.vertices, [(0, 1, 2), (0, 2, 3)]


def _unfit(outline: Outline) -> Made:
    raise Unfit("too square")


def _broken(outline: Outline) -> Made:
    raise ValueError("some reason")


def _crash(outline: Outline) -> Made:
    os._exit(3)


def _sleep(outline: Outline) -> Made:
    time.sleep(60)
    return [], []


STRANGE = (Tool("a", "json", _diagonal), Tool("b", "no_such_package_at_all", _diagonal), Tool("c", "json", _unfit),
           Tool("d", "json", _broken), Tool("e", "json", _crash), Tool("f", "json", _sleep))


def test_a_mesher_may_be_missing_refuse_fail_crash_or_hang() -> None:
    outline = outline_of(domain_of(SQUARE))
    with Workshop(60.0, STRANGE) as workshop:
        found = [workshop.mesh(number, outline) for number in (0, 1, 2, 3, 4, 0)]
    assert [output.status for output in found] == [
        "made", "not installed", "not taken", "failed", "failed", "made"]
    with Workshop(0.5, STRANGE) as workshop:
        assert workshop.mesh(5, outline) == Output("too slow", "more than 0.5 s")
    assert found[0].triangles == ((0, 1, 2), (0, 2, 3)) and "pip install" in found[1].message
    assert found[2].message == "too square" and "some reason" in found[3].message and found[4].message == "crashed"


def test_rows_and_texts_of_strange_meshers() -> None:
    given = [Input("random", "square", lambda: SQUARE), Input("midway", "r = 4", lambda: (
        families.rectangle_with_two_midway_vertices(4)))]
    told: list[str] = []
    rows = list(peer_rows(progress=told.append, chosen=given, tools=STRANGE[:4]))
    assert len(rows) == 2 * 6 and len(told) == 2 * 5
    assert [row.status for row in rows[:6]] == ["made", "not installed", "not taken", "failed", "made", "made"]
    ours = {(row.name, row.tool): row.measured for row in rows if row.tool in (GUARANTEED, OPTIMIZED)}
    assert all(found is not None and found.is_mesh and not found.boundary for found in ours.values())
    best = ours["r = 4", OPTIMIZED]
    assert best is not None and best.degradation_squared == 4
    text = peers_text(rows)
    lines = {line.split()[0]: line for line in text.split("\n\n")[0].splitlines()[1:]}
    assert "not installed" in lines["b"] and "0 of 1" in lines["c"] and "infinite" in lines["d"]
    assert lines["a"].split()[:6] == ["a", "1", "of", "1", "1", "1.414"]
    # Two triangles are no mesh of a hexagon; they are a graph with a feature size of its own.
    assert "!" in text.split("\n\n")[1].splitlines()[1]
    table = list(csv.DictReader(io.StringIO(peers_csv(rows))))
    records = json.loads(peers_json(rows))["peers"]
    assert len(table) == len(records) == len(rows)
    assert table[0]["degradation_squared"] == records[0]["degradation_squared"] == "2"
    assert records[1]["degradation_squared"] is None and records[1]["status"] == "not installed"


def test_the_meshers_that_are_installed_make_meshes_of_a_square_with_a_hole() -> None:
    ring = Pslg(SQUARE.vertices + families.ring([(1, 1), (1, 3), (3, 3), (3, 1)]).vertices,
                (*SQUARE.edges, (4, 5), (5, 6), (6, 7), (7, 4)), (families.Point(mpq(2), mpq(2)),))
    rows = list(peer_rows(chosen=[Input("holes", "ring", lambda: ring)]))
    assert [row.tool for row in rows] == [*(tool.name for tool in PEERS), GUARANTEED, OPTIMIZED]
    for row in rows:
        assert row.status in ("made", "not installed"), row
        if row.measured is not None:
            assert row.measured.is_mesh and row.measured.degradation_squared is not None
            assert row.measured.boundary == 0 or row.tool in ("gmsh", "Triangle pq")


def test_a_domain_with_loose_edges_is_for_some_meshers_only() -> None:
    loose = Pslg((*SQUARE.vertices, families.Point(mpq(2), mpq(2))), (*SQUARE.edges, (0, 4)))
    outline = outline_of(domain_of(loose))
    assert outline.rings is None
    with pytest.raises(Unfit, match="polygons with holes"):
        outline.faces()
    assert outline_of(domain_of(SQUARE)).faces() == [[[0, 1, 2, 3]]]


# --- inputs ---


def test_every_short_input_is_one_and_survives_rounding() -> None:
    found = inputs(short=True)
    assert {given.group for given in found} > set(HARD_GROUPS) and len(found) > 40
    assert len({(given.group, given.name) for given in inputs(short=False)}) == len(inputs(short=False)) > 150
    for given in found:
        pslg = rounded(given.make())
        assert domain_of(pslg).domain
        assert all(mpq(float(p.x)) == p.x and mpq(float(p.y)) == p.y for p in pslg.vertices)


def test_fractals_and_mazes_have_the_sizes_and_shapes_they_should() -> None:
    for order in range(3):
        assert len(snowflake(order).vertices) == 3 * 4**order
    size = minimum_feature_size(snowflake(2))
    # The altitude of the small triangles, 97/112, or what it leaves of their sides.
    assert size is not None and mpq(7, 10) < size.squared <= 1
    assert len(square_island(1).vertices) == 28 and domain_of(square_island(2)).domain
    made = maze(5, 4, 1)
    assert len(domain_of(made).domain) == 1 and len(made.vertices) == 30
    # Walls of cells less those of a tree.
    assert len(made.edges) == 5 * 5 + 6 * 4 - (5 * 4 - 1)


def test_the_command_prints_and_writes(monkeypatch: pytest.MonkeyPatch, tmp_path: Path,
                                       capsys: pytest.CaptureFixture[str]) -> None:
    row = PeerRow("combs", "2 teeth", 7, "a", "made", "", 0.25, Measured(True, mpq(10) ** 20, 3, 2, 9))
    monkeypatch.setattr(reproduce, "peer_rows", lambda short, progress: [row] if short else [])
    folder = tmp_path / "new"
    assert cli.main(["reproduce", "peers", "--short", "-o", str(folder)]) == 0
    text = capsys.readouterr().out
    assert "1.0e+10 +2" in text
    assert (folder / "peers.txt").read_text(encoding="utf-8") == text
    assert cli.main(["reproduce", "peers", "--short", "--json"]) == 0
    assert capsys.readouterr().out == (folder / "peers.json").read_text(encoding="utf-8") + "\n"
    assert sorted(os.listdir(folder)) == ["peers.csv", "peers.json", "peers.txt"]
