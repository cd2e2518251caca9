"""The benchmark: its inputs are what they are called, its numbers add up, and the command runs on tiny inputs."""

import json
import xml.etree.ElementTree as ET
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import pytest

from exactmesh.bench import measure
from exactmesh.bench.inputs import FAMILIES, LEAST, WHAT, coast, roof
from exactmesh.bench.measure import Beside, Plan, Results, Row, exponent, measured, plan_of
from exactmesh.bench.peers import PEERS, Peer
from exactmesh.bench.report import bench_json, bench_svg, bench_text
from exactmesh.bench.worker import STAGES, WITHOUT_MESH, machine
from exactmesh.cli import main
from exactmesh.errors import InputError
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import domain_of

ROW = Row("circle", 10_000, dict.fromkeys(STAGES, 0.5), dict.fromkeys(STAGES, 0.6), 300 << 20, 50 << 20, 9, 9, True,
          {"orientation": (99_000, 1_000)})


# --- inputs ---


@pytest.mark.parametrize("name", FAMILIES)
def test_every_family_is_valid_and_has_about_the_size(name: str) -> None:
    for n in (LEAST, 500):
        graph = FAMILIES[name](n)
        assert domain_of(graph).domain
        if name != "coast":
            assert 0.8 * n <= len(graph.vertices) <= n + 2
        assert graph == FAMILIES[name](n)
    assert WHAT.keys() == FAMILIES.keys()


def test_a_bent_coast_has_the_size_and_its_own_vertices() -> None:
    own = coast(0)
    bent = coast(5000)
    assert len(bent.vertices) == 5000 and bent.vertices[: len(own.vertices)] == own.vertices
    assert len(domain_of(bent).domain) == len(domain_of(own).domain)
    assert sum(degree != 2 for degree in _degrees(bent.edges, 5000)) == 0


def _degrees(edges: tuple[tuple[int, int], ...], count: int) -> list[int]:
    degrees = [0] * count
    for edge in edges:
        for v in edge:
            degrees[v] += 1
    return degrees


def test_the_roof_is_long_and_nearly_horizontal_and_above_all() -> None:
    graph = roof(100)
    long = [(graph.vertices[u], graph.vertices[v]) for u, v in graph.edges
            if abs(graph.vertices[u].x - graph.vertices[v].x) > 50]
    assert len(long) == 1 and 0 < abs(long[0][0].y - long[0][1].y) < 1e-5
    assert min(p.y for p in long[0]) > max(p.y for p in graph.vertices[:-2])
    found = minimum_feature_size(graph)
    assert found is not None and found.squared > 0


# --- numbers ---


@pytest.mark.parametrize(("points", "power"), [
    ([(10, 5), (100, 50)], 1.0), ([(10, 3), (100, 300), (1000, 30_000)], 2.0), ([(10, 7), (1000, 7)], 0.0)])
def test_the_exponent_of_a_power_is_that_power(points: list[tuple[float, float]], power: float) -> None:
    found = exponent(points)
    assert found is not None and abs(found - power) < 1e-9


@pytest.mark.parametrize("points", [[], [(10, 5)], [(10, 5), (10, 6)], [(10, 0), (20, 5)]])
def test_there_is_no_exponent_without_two_sizes(points: list[tuple[float, float]]) -> None:
    assert exponent(points) is None


def test_growth_is_fitted_from_ten_thousand_on_where_there_are_two_such_sizes() -> None:
    rows = [replace(ROW, n=1000, cpu=dict.fromkeys(STAGES, 99.0)), ROW,
            replace(ROW, n=100_000, cpu=dict.fromkeys(STAGES, 5.0))]
    found = json.loads(bench_json(Results(rows, []), "m"))
    assert abs(found["growth"]["circle"]["all"] - 1) < 1e-9


def test_the_table_says_what_was_measured_what_failed_and_what_is_missed() -> None:
    beside = [Beside("geos", "circle", 100_000, 10.0, 1.0, 0.2), Beside("geos", "comb", 100_000, 10.0, 3.0, 0.2),
              Beside("sect", "random", 1000, 0.02, failure="not installed (sect)")]
    text = bench_text(Results([ROW, Row("comb", 10_000, failure="ended by signal 9"),
                               replace(ROW, family="star", holds=False)], beside), "a machine")
    lines = {line.split()[0]: line for line in text.splitlines() if line.strip()}
    assert "a machine" in text and "NOT VALID" in text and "ended by signal 9" in text and "not installed" in text
    circle = next(line for line in text.splitlines() if line.startswith("circle"))
    assert circle.split()[2] == "50.0" and " 300 " in circle and " 1.00" in circle
    assert "10.0, 0.10" in lines["orientation"]
    rows = [line for line in text.splitlines() if line.startswith("GEOS")]
    assert rows[0].endswith("met") and rows[1].endswith("MISSED")


def test_the_picture_has_a_panel_for_each_family_and_the_peers() -> None:
    beside = [Beside("geos", "circle", 100_000, 10.0, 1.0, 0.2)]
    svg = bench_svg(Results([ROW, replace(ROW, n=100_000), replace(ROW, family="star")], beside), "m & n")
    titles = [element.text or "" for element in ET.fromstring(svg).iter("{http://www.w3.org/2000/svg}title")]
    for panel, series in (("circle", "geos, s"), ("circle", "memory, GiB"), ("star", "verify, s")):
        assert any(title.startswith(panel) and title.endswith(series) for title in titles)


def test_what_is_left_is_told_from_the_rates_so_far(monkeypatch: pytest.MonkeyPatch) -> None:
    now = iter([0.0, 10.0, 10.0, 10.0 + 100.0, 110.0, 110.0, 110.0])
    monkeypatch.setattr(measure.time, "perf_counter", lambda: next(now))
    monkeypatch.setattr(measure, "_run", lambda task: {"n": 1000})
    said: list[str] = []
    measured(Plan(["circle"], [1000, 10_000], peers=()), said.append)
    # 10 seconds for 1000 vertices: 100 for the ten times as many that are left.
    assert said[1] == "circle, 10000 vertices (2 of 2, about 2 min left)"


def test_an_interrupt_keeps_what_was_measured(
        monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    made = 0

    def run(task: dict[str, object]) -> dict[str, object]:
        nonlocal made
        made += 1
        if made == 4:
            raise KeyboardInterrupt
        return {"n": 77, "cpu": {"read": 1.0}}

    monkeypatch.setattr(measure, "_run", run)
    assert main(["bench", "--sizes", "60", "--quiet", "--json"]) == 130
    shown = capsys.readouterr()
    assert [row["family"] for row in json.loads(shown.out)["rows"]] == ["random"]
    assert "interrupted" in shown.err


def test_a_run_goes_on_where_another_ended(
        tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    asked: list[object] = []

    def run(task: dict[str, object]) -> dict[str, object]:
        if task["task"] == "peer":
            return {"n": 59, "ours": 1.0, "theirs": 2.0}
        asked.append((task["task"], task.get("family")))
        if len(asked) == 3:
            raise KeyboardInterrupt
        if len(asked) == 6:
            return {"failure": "ended by signal 9"}
        return {"n": 59, "cpu": dict.fromkeys(STAGES, 1.0), "decisions": {"orientation": [3, 1]}}

    monkeypatch.setattr(measure, "_run", run)
    monkeypatch.setitem(PEERS, "sect", replace(PEERS["sect"], module="json"))  # a module that is there
    command = ["bench", "--sizes", "60", "--families", "circle,comb,star", "--peers", "sect", "-o", str(tmp_path),
               "--quiet", "--json"]
    assert main(command) == 130
    assert main([*command, "--resume"]) == 0
    assert main([*command, "--resume"]) == 0
    assert [family for task, family in asked if task == "make"] == ["circle", "comb", "comb", "star", "star"]
    capsys.readouterr()
    assert main([*command, "--resume"]) == 0
    assert len(asked) == 8
    found = json.loads(capsys.readouterr().out)
    assert found == json.loads((tmp_path / "bench.json").read_text())
    assert [(row["family"], row["n"], row["decisions"]) for row in found["rows"]] == [
        (family, 59, {"orientation": [3, 1]}) for family in ("circle", "comb", "star")]
    assert [row["ratio"] for row in found["peers"]] == [0.5]
    # Another choice adds to what there is.
    assert main(["bench", "--sizes", "80", "--families", "comb", "--peers", "-", "-o", str(tmp_path), "--quiet",
                 "--resume"]) == 0
    rows = json.loads((tmp_path / "bench.json").read_text())["rows"]
    assert [(row["family"], row["size"]) for row in rows] == [("circle", 60), ("comb", 60), ("star", 60), ("comb", 80)]
    assert main([*command, "--resume", "--no-mesh"]) == 2
    assert "measured with and without meshes" in capsys.readouterr().err


@pytest.mark.parametrize(("text", "message"), [
    ("{}", "no measurements of exactmesh bench"), ("[", "no measurements of exactmesh bench"),
    ('{"machine": "m", "rows": [{"decisions": {}, "speed": 1}], "peers": []}', "no measurements of exactmesh bench"),
    ('{"machine": "m", "rows": [], "peers": [{"peer": "p", "family": "star", "n": 9, "target": null}]}',
     "no measurements of exactmesh bench"),
    ('{"machine": "m", "rows": [], "peers": []}', "measured on another machine: m")])
def test_only_own_measurements_are_gone_on_with(
        text: str, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "bench.json"
    path.write_text(text)
    assert main(["bench", "--sizes", "60", "-o", str(tmp_path), "--resume", "--quiet"]) == 2
    assert capsys.readouterr().err == f"exactmesh: {path}: {message}\n" and path.read_text() == text


def test_going_on_needs_a_folder(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["bench", "--resume", "--quiet"]) == 2
    assert "--resume needs -o DIR" in capsys.readouterr().err


def test_a_process_that_fails_leaves_a_row_and_the_rest_goes_on() -> None:
    found = measure._run({"task": "make", "family": "no such family", "n": 100, "path": "x"})
    assert "KeyError" in found["failure"]


def test_a_size_too_small_is_refused() -> None:
    with pytest.raises(InputError, match="60 is the least"):
        plan_of(["circle"], [59, 100], True, len(STAGES), [])


def test_comparisons_are_cut_to_the_largest_size_and_made_once_each() -> None:
    full = Plan([], [100]).cases()
    assert len(full) == 8 and all(n == case.n for _, case, n in full)
    assert {case.short for _, case, _ in full} == {n for _, _, n in Plan([], [100], short=True).cases()}
    cut = Plan([], [100], peers=["sect"], largest=1000).cases()
    # The case whose bound is for this size stands for both.
    assert [(case.n, n) for _, case, n in cut] == [(1000, 1000)]


# --- the command ---


def test_the_command_measures_every_stage_and_peer_there_is(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "out"
    assert main(["bench", "--sizes", "60", "--short", "--families", "comb,map", "-o", str(folder), "--json",
                 "--quiet"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found == json.loads((folder / "bench.json").read_text())
    assert [(row["family"], row["failure"], row["holds"]) for row in found["rows"]] == [
        ("comb", "", True), ("map", "", True)]
    for row in found["rows"]:
        assert set(row["cpu"]) == set(row["wall"]) == set(STAGES) and row["faces"] > row["n"] > 0
        assert row["memory"] > row["memory_before"] > 0
        assert {"orientation", "sweep orientation", "least distance"} <= set(row["decisions"])
    assert {row["peer"] for row in found["peers"]} == set(PEERS)
    for row in found["peers"]:
        if find_spec(PEERS[row["peer"]].module) is None:
            assert row["failure"] == f"not installed ({PEERS[row['peer']].module})"
        else:
            assert row["failure"] == "" and row["n"] <= 60 and row["ratio"] > 0 and row["target"] is None
    assert "microseconds a vertex" in (folder / "bench.txt").read_text()
    ET.parse(folder / "bench.svg")


def test_a_peer_that_is_not_there_is_a_row_that_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    gone: Peer = replace(PEERS["geos"], module="no_such_module")
    monkeypatch.setitem(PEERS, "geos", gone)
    found = measured(Plan([], [60], WITHOUT_MESH, ["geos"], True, 60), lambda step: None)
    assert [row.failure for row in found.beside] == ["not installed (no_such_module)"] * 3
    assert "not installed" in bench_text(found, machine())


@pytest.mark.parametrize("wrong", [["--sizes", "x"], ["--families", "none"], ["--peers", "nobody"]])
def test_a_wrong_choice_is_refused(wrong: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(["bench", *wrong])
    assert caught.value.code == 2
    assert capsys.readouterr().err


