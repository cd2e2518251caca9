"""The command line: exit statuses, what goes where, and every refusal one line without a traceback."""

import hashlib
import io
import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import families
import pytest
from constructions import HALL, graph
from gmpy2 import mpq

import exactmesh
from exactmesh import api, cli
from exactmesh.commands import mesh as mesh_command
from exactmesh.commands import options, size
from exactmesh.data import EXAMPLES
from exactmesh.errors import ConstructionFailed
from exactmesh.io.mesh_json import json_from_mesh, mesh_from_json
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.measure.verdict import Verdict, Witness
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])
HALVES = Mesh("classic", SQUARE.vertices, ((0, 1, 2), (0, 2, 3)))
ROOM = "POLYGON((0 0, 9 0, 9 5, 5 5, 4 2, 3 5, 0 5, 0 0))"


class Result(NamedTuple):
    """What a command did."""

    status: int
    out: str
    err: str


Run = Callable[..., Result]


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Return a function that runs one command in this process."""
    def run_(*args: str, stdin: str | bytes = "") -> Result:
        data = stdin.encode() if isinstance(stdin, str) else stdin
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
        try:
            status = cli.main(args)
        except SystemExit as stop:
            status = int(stop.code or 0)
        captured = capsys.readouterr()
        return Result(status, captured.out, captured.err)
    return run_


@pytest.fixture
def write(tmp_path: Path) -> Callable[[str, str | bytes], str]:
    """Return a function that writes a file and returns its path."""
    def write_(name: str, content: str | bytes) -> str:
        path = tmp_path / name
        path.write_bytes(content.encode() if isinstance(content, str) else content)
        return str(path)
    return write_


def shell(*args: str, stdin: bytes = b"", module: bool = False, **options: Any) -> subprocess.CompletedProcess[bytes]:
    """Run the command in a process of its own."""
    start = [sys.executable, "-m", "exactmesh"] if module else [
        sys.executable, "-c", "import sys; from exactmesh.cli import main; sys.exit(main())"]
    return subprocess.run([*start, *args], input=stdin, capture_output=True, timeout=60, check=False, **options)


# --- mfs ---


def test_mfs(run: Run, write: Any) -> None:
    result = run("mfs", write("a.json", json_from_pslg(SQUARE)))
    assert result == (0, "mfs 4, squared exactly 16: vertex 2 and edge (0, 1)\n", "")


def test_mfs_as_json(run: Run, write: Any) -> None:
    found = json.loads(run("mfs", write("a.json", json_from_pslg(HALL)), "--json").out)
    assert found == {"mfs_squared": "121/37", "decimal": "1.80838886036", "witness": {"vertex": 8, "edge": [9, 7]}}


@pytest.mark.parametrize("corners, found", [
    ([(0, 0), (3, 4)], {"mfs_squared": "25", "decimal": "5", "witness": {"vertex": 1, "other": 0}}),
    ([(0, 0)], {"mfs_squared": None, "decimal": None, "witness": None}),
])
def test_mfs_of_points_as_json(run: Run, write: Any, corners: Any, found: Any) -> None:
    pslg = Pslg(graph(corners).vertices if len(corners) > 1 else SQUARE.vertices[:1], ())
    assert json.loads(run("mfs", write("a.json", json_from_pslg(pslg)), "--json").out) == found


def test_mfs_of_a_single_point_in_words(run: Run) -> None:
    result = run("mfs", "-", stdin="POINT(1 2)")
    assert result.status == 0 and result.out.startswith("mfs: none")


def test_a_long_exact_value_is_cut_short_in_words_only(run: Run, write: Any) -> None:
    path = write("a.json", json_from_pslg(families.ALL_SMALL["30 digits"]))
    exact = json.loads(run("mfs", path, "--json").out)["mfs_squared"]
    words = run("mfs", path).out
    assert len(exact) > 60 and exact not in words and f"({len(exact)} characters, in full with --json)" in words


# --- mesh ---


def test_mesh_writes_a_mesh_a_report_and_a_picture(run: Run, write: Any, tmp_path: Path) -> None:
    source = write("a.json", json_from_pslg(HALL))
    out, report, svg = (tmp_path / name for name in ("m.json", "r.json", "s.svg"))
    result = run("mesh", source, "-o", str(out), "--report", str(report), "--svg", str(svg))
    assert result.status == 0 and result.err == ""
    made = mesh_from_json(out.read_text())
    assert exactmesh.verify(HALL, made).valid
    assert svg.read_text().startswith("<svg")
    found = json.loads(report.read_text())
    assert found["input"]["sha256"] == hashlib.sha256(Path(source).read_bytes()).hexdigest()
    assert found["mesh"]["sha256"] == hashlib.sha256(out.read_bytes()).hexdigest()


def test_the_report_has_the_keys_of_the_format(run: Run, write: Any, tmp_path: Path) -> None:
    report = tmp_path / "r.json"
    run("mesh", write("a.json", json_from_pslg(HALL)), "--report", str(report))
    found = json.loads(report.read_text())
    verification = api.mesh(HALL).verification
    assert found["format"] == "exactmesh-report/1" and found["construction"] == "repaired"
    assert {k: found["input"][k] for k in ("vertices", "edges")} == {"vertices": 15, "edges": 12}
    assert {k: found["mesh"][k] for k in ("kind", "steiner", "faces")} == {
        "kind": "nonproper", "steiner": verification.steiner, "faces": verification.faces}
    assert found["mesh"]["vertices"] == 15 + verification.steiner
    assert found["mfs_squared"]["input"] == "121/37"
    assert found["mfs_squared"]["witness_input"] == {"vertex": 8, "edge": [9, 7]}
    assert set(found["mfs_squared"]["witness_mesh"]) == {"vertex", "edge"}
    assert mpq(found["mfs_squared"]["input"]) / mpq(found["mfs_squared"]["mesh"]) == mpq(found["degradation_squared"])
    for claim in found["claims"]:
        assert {"id", "paper", "bound", "instances", "holds", "worst", "witness"} <= set(claim)
        assert claim["holds"] is True and (claim["worst"] is None or set(claim["worst"]) == {"exact", "decimal"})
    degradation = next(claim for claim in found["claims"] if claim["id"] == "theorem-1.degradation")
    exact = degradation["worst"]["exact"]
    assert eval(exact, {"sqrt": lambda x: x**0.5}) == pytest.approx(float(degradation["worst"]["decimal"]))


def test_mesh_to_standard_output(run: Run) -> None:
    result = run("mesh", "-", "-o", "-", stdin=ROOM)
    assert result.status == 0 and mesh_from_json(result.out).kind == "nonproper"
    # The summary does not mix with the mesh.
    assert "degradation" in result.err


def test_the_summary_lists_every_claim(run: Run) -> None:
    result = run("mesh", "-", stdin=ROOM)
    assert result.status == 0 and result.err == ""
    assert all(j.claim.id in result.out for j in api.mesh(SQUARE).judgements)
    assert "valid nonproper mesh" in result.out and "FAILS" not in result.out


def test_quiet_says_nothing(run: Run, tmp_path: Path) -> None:
    assert run("mesh", "-", "--quiet", "-o", str(tmp_path / "m.json"), stdin=ROOM) == (0, "", "")


def test_every_format_gives_the_same_mesh(run: Run) -> None:
    texts = {
        json_from_pslg(SQUARE),
        '{"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}',
        "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0))",
        "4 2 0 0\n0 0 0\n1 4 0\n2 4 4\n3 0 4\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n",
    }
    assert len({run("mesh", "-", "-o", "-", "--quiet", stdin=text).out for text in texts}) == 1


def test_two_results_do_not_go_to_one_place(run: Run, tmp_path: Path) -> None:
    path = str(tmp_path / "m.json")
    for second in ("--report", "--svg"):
        result = run("mesh", "-", "-o", path, second, path, stdin=ROOM)
        assert result.status == 2 and result.out == "" and os.listdir(tmp_path) == []


def test_a_failing_claim_is_status_1_and_the_results_are_written(
        run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def meshing_of(done: Any) -> api.Meshing:
        good = whole(done)
        bad = Verdict(7, False, mpq(1, 9), Witness("feature size >= g/5", {"face": [3, 1, 4], "at": "(0, 1/2)"}))
        return replace(good, judgements=(replace(good.judgements[0], verdict=bad), *good.judgements[1:]))

    whole = api.meshing_of
    monkeypatch.setattr(mesh_command, "meshing_of", meshing_of)
    out, report, svg = (tmp_path / name for name in ("m.json", "r.json", "s.svg"))
    result = run("mesh", "-", "-o", str(out), "--report", str(report), "--svg", str(svg), stdin=ROOM)
    failing = api.mesh(SQUARE).judgements[0].claim.id
    assert result.status == 1 and "FAILS" in result.out
    assert result.err == f"{failing} fails: feature size >= g/5: face [3, 1, 4], at (0, 1/2)\n"
    assert mesh_from_json(out.read_text()).faces and svg.exists()
    first = json.loads(report.read_text())["claims"][0]
    assert first["holds"] is False and first["witness"]["face"] == [3, 1, 4] and first["instances"] == 7


def test_a_failing_claim_is_told_when_quiet(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = api.meshing_of

    def meshing_of(done: Any) -> api.Meshing:
        good = whole(done)
        return replace(good, judgements=(replace(good.judgements[0], verdict=Verdict(0, False)),))

    monkeypatch.setattr(mesh_command, "meshing_of", meshing_of)
    result = run("mesh", "-", "--quiet", stdin=ROOM)
    assert result.status == 1 and result.out == "" and result.err.endswith(" fails\n")


def test_a_failed_construction_is_told_as_a_counterexample(run: Run, tmp_path: Path,
                                                           monkeypatch: pytest.MonkeyPatch) -> None:
    def meshing_of(done: Any) -> api.Meshing:
        raise ConstructionFailed("one-sided quadrilateral", {"a": "(1, 2)"})

    monkeypatch.setattr(mesh_command, "meshing_of", meshing_of)
    result = run("mesh", "-", "-o", str(tmp_path / "m.json"), stdin=ROOM)
    assert result.status == 1 and result.out == "" and os.listdir(tmp_path) == []
    assert "one-sided quadrilateral" in result.err and "(1, 2)" in result.err and "counterexample" in result.err


# --- verify ---


def test_verify_a_mesh_of_another_tool(run: Run, write: Any) -> None:
    pslg, mesh = write("p.json", json_from_pslg(SQUARE)), write("m.json", json_from_mesh(HALVES))
    result = run("verify", pslg, mesh)
    assert result.status == 0 and result.out.startswith("valid classic mesh: 2 faces, 0 Steiner vertices\n")
    found = json.loads(run("verify", pslg, mesh, "--json").out)
    assert {k: found[k] for k in ("valid", "kind", "violations", "mfs_squared", "degradation_squared", "steiner",
                                  "faces")} == {
        "valid": True, "kind": "classic", "violations": [], "mfs_squared": {"input": "16", "mesh": "8"},
        "degradation_squared": "2", "steiner": 0, "faces": 2}


def test_verify_a_bad_mesh(run: Run, write: Any) -> None:
    pslg = write("p.json", json_from_pslg(SQUARE))
    mesh = write("m.json", json_from_mesh(Mesh("classic", SQUARE.vertices, ((0, 1, 2),))))
    result = run("verify", pslg, mesh)
    assert result.status == 1 and result.out.startswith("not a valid classic mesh") and result.err == ""
    result = run("verify", pslg, mesh, "--json")
    found = json.loads(result.out)
    assert result.status == 1 and found["valid"] is False and found["degradation_squared"] is None
    assert {violation["clause"] for violation in found["violations"]} == {"input-edge", "boundary", "unused-vertex"}
    assert all(set(violation) == {"clause", "place"} for violation in found["violations"])


def test_many_violations_are_counted(run: Run, write: Any) -> None:
    pslg = families.regular_polygon(64)
    result = run("verify", write("p.json", json_from_pslg(pslg)),
                 write("m.json", json_from_mesh(Mesh("classic", pslg.vertices, ()))))
    assert result.status == 1 and re.search(r"and \d+ more\n$", result.out)


@pytest.mark.parametrize("bound, status", [
    ("2", 0), ("1.5", 0), ("1.4142135623730951", 0), ("1.4142135623730950", 1), ("99/70", 0), ("140/99", 1),
    ("1", 1), ("0", 1), ("-2", 1), ("1e9", 0),
])
def test_the_bound_on_the_degradation_is_exact(run: Run, write: Any, bound: str, status: int) -> None:
    pslg, mesh = write("p.json", json_from_pslg(SQUARE)), write("m.json", json_from_mesh(HALVES))
    result = run("verify", pslg, mesh, "--max-degradation", bound)
    assert result.status == status
    assert (result.err == "") == (status == 0)
    if status:
        assert result.err.startswith("exactmesh: the degradation is above ") and result.err.count("\n") == 1


def test_a_degradation_equal_to_the_bound_passes(run: Run, write: Any) -> None:
    quarters = Mesh("proper", (*SQUARE.vertices, *graph([(2, 2), (0, 0), (1, 0)]).vertices[:1]),
                    ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)))
    assert exactmesh.verify(SQUARE, quarters).degradation_squared == 4
    paths = write("p.json", json_from_pslg(SQUARE)), write("m.json", json_from_mesh(quarters))
    for bound, status in (("2", 0), ("1.99999999999999999999", 1), ("2.00000000000000000001", 0)):
        assert run("verify", *paths, "--max-degradation", bound).status == status


def test_verify_what_mesh_makes(run: Run, write: Any, tmp_path: Path) -> None:
    out = str(tmp_path / "m.json")
    pslg = write("p.json", json_from_pslg(HALL))
    assert run("mesh", pslg, "-o", out, "--quiet").status == 0
    assert run("verify", pslg, out, "--max-degradation", "108/5").status == 0


def test_verify_reads_one_of_the_two_from_standard_input(run: Run, write: Any) -> None:
    pslg, mesh = json_from_pslg(SQUARE), json_from_mesh(HALVES)
    assert run("verify", "-", write("m.json", mesh), stdin=pslg).status == 0
    assert run("verify", write("p.json", pslg), "-", stdin=mesh).status == 0
    result = run("verify", "-", "-", stdin=pslg)
    assert result == (2, "", "exactmesh: PSLG and MESH cannot both be standard input\n")


# --- examples ---


def test_examples_are_listed_and_written(run: Run, tmp_path: Path) -> None:
    assert run("examples").out.split() == list(EXAMPLES.names())
    text = EXAMPLES.path("luxembourg").read_text(encoding="utf-8")
    assert run("examples", "luxembourg").out == text
    path = tmp_path / "l.geojson"
    assert run("examples", "luxembourg", "-o", str(path)) == (0, "", "") and path.read_text() == text
    assert run("mfs", str(path)).status == 0


def test_an_unknown_example_is_refused(run: Run) -> None:
    result = run("examples", "atlantis")
    assert result.status == 2 and "atlantis" in result.err and "luxembourg" in result.err


# --- refusals ---


def pslg_text(**changes: Any) -> str:
    fields = {"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]],
              "edges": [[0, 1], [1, 2], [2, 3], [3, 0]]}
    return json.dumps({k: v for k, v in (fields | changes).items() if v is not None})


def corners(*places: Sequence[Any]) -> str:
    """Return the file of a polygon."""
    return pslg_text(vertices=[[str(x), str(y)] for x, y in places],
                     edges=[[i, (i + 1) % len(places)] for i in range(len(places))])


REFUSED: dict[str, tuple[str | bytes, str]] = {
    "crossing edges": (corners((0, 0), (4, 4), (4, 0), (0, 4)), r"edges 0 \(0, 1\) and 2 \(2, 3\) cross at \(2, 2\)"),
    "crossing far away": (corners((10**40, 0), (10**40 + 4, 4), (10**40 + 4, 0), (10**40, 4)), "cross at"),
    "overlapping edges": (corners((0, 0), (4, 0), (2, 0), (2, 3)), "vertex 2 lies on edge 0"),
    "overlap from a vertex": (pslg_text(edges=[[0, 1], [1, 2], [2, 0], [0, 1]]), "overlap from"),
    "the same edge backwards": (pslg_text(edges=[[0, 1], [1, 2], [2, 0], [1, 0]]), "overlap from"),
    "a vertex on an edge": (corners((0, 0), (4, 0), (4, 4), (2, 0), (0, 4)), r"vertex 3 lies on edge 0 \(0, 1\)"),
    "repeated vertices": (corners((0, 0), (4, 0), (4, 0), (0, 4)), "vertices 1 and 2 coincide"),
    "repeated as a decimal": (corners((0, 0), (4, 0), ("4.0", "0e5"), (0, 4)), "vertices 1 and 2 coincide"),
    "an edge of no length": (pslg_text(edges=[[0, 1], [1, 1]]), r"edges\[1\]: both ends are vertex 1"),
    "two vertices": (corners((0, 0), (4, 0)), "overlap"),
    "one vertex": (pslg_text(vertices=[["0", "0"]], edges=[]), "nothing"),
    "no vertices": (pslg_text(vertices=[], edges=[]), "nothing"),
    "an open path": (pslg_text(edges=[[0, 1], [1, 2]]), "the edges enclose nothing"),
    "flat": (corners((0, 0), (2, 0), (4, 0)), "overlap from"),
    "nan": (corners((0, 0), (4, "nan"), (4, 4)), r"vertices\[1\]\[1\]"),
    "infinity": (corners((0, 0), (4, "inf"), (4, 4)), r"vertices\[1\]\[1\]"),
    "a NaN of JSON": (pslg_text().replace('"4"', "NaN", 1), "NaN"),
    "a zero denominator": (corners((0, 0), ("4/0", 0), (4, 4)), "zero"),
    "a huge exponent": (corners((0, 0), ("1e999999999", 0), (4, 4)), "exponent"),
    "words": (corners((0, 0), ("four", 0), (4, 4)), "four"),
    "three coordinates": (pslg_text(vertices=[["0", "0", "0"]] * 4), "vertices"),
    "an index too large": (pslg_text(edges=[[0, 4]]), r"edges\[0\]"),
    "a negative index": (pslg_text(edges=[[0, -1]]), r"edges\[0\]"),
    "an index that is no number": (pslg_text(edges=[[0, "1"]]), r"edges\[0\]"),
    "an edge of three": (pslg_text(edges=[[0, 1, 2]]), r"edges\[0\]"),
    "no edges key": (pslg_text(edges=None), "edges"),
    "an unknown key": (pslg_text(colour="red"), "colour"),
    "another format": (pslg_text(format="exactmesh-pslg/2"), "exactmesh-pslg"),
    "a mesh": (json_from_mesh(HALVES), "exactmesh-mesh/1"),
    "a hole outside": (pslg_text(holes=[["9", "9"]]), "hole point 0"),
    "a hole on an edge": (pslg_text(holes=[["2", "0"]]), "hole point 0"),
    "a hole that takes all": (pslg_text(holes=[["1", "1"]]), "nothing is left to mesh"),
    "not JSON": ("{this is not JSON", "line 1"),
    "truncated": (pslg_text()[:60], ""),
    "truncated text": (ROOM[:30], ""),
    "empty": ("", "empty"),
    "blank": (" \n\t\n", ""),
    "binary": (bytes(range(256)), ""),
    "a PNG": (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR", ""),
    "UTF-16": (pslg_text().encode("utf-16"), ""),
    "prose": ("To whom it may concern:\n", "not a format we know"),
    "a list": ("[1, 2, 3]", ""),
    "a number": ("42", ""),
    "nested deeply": ("[" * 100_000, ""),
    "an open WKT ring": ("POLYGON((0 0, 4 0, 4 4))", ""),
    "a WKT curve": ("CIRCULARSTRING(0 0, 1 1, 2 0)", ""),
    "a GeoJSON without coordinates": ('{"type": "Polygon"}', "coordinates"),
    "a poly without its nodes": ("0 2 0 0\n3 0\n", ""),
}


@pytest.mark.parametrize("name", REFUSED)
def test_bad_inputs_are_refused_in_one_line_and_nothing_is_written(
        run: Run, write: Any, tmp_path: Path, name: str) -> None:
    content, reason = REFUSED[name]
    path = write("bad", content)
    out = tmp_path / "out"
    out.mkdir()
    outputs = ["-o", str(out / "m.json"), "--report", str(out / "r.json"), "--svg", str(out / "s.svg")]
    result = run("mesh", path, *outputs)
    assert result.status == 2 and result.out == "" and os.listdir(out) == []
    assert result.err.startswith("exactmesh: ") and result.err.count("\n") == 1 and result.err.endswith("\n")
    assert re.search(reason, result.err) and "Traceback" not in result.err and len(result.err) < 600
    if name not in ("one vertex", "no vertices", "an open path", "a hole that takes all"):
        assert run("mfs", path).status == 2
    assert run("verify", path, write("m.json", json_from_mesh(HALVES))).status == 2


@pytest.mark.parametrize("text, reason", [
    (json_from_pslg(SQUARE), "exactmesh-mesh/1"), (ROOM, "not a mesh"), ("", "empty"),
    (json_from_mesh(HALVES).replace("classic", "cubic"), "kind"),
    (json_from_mesh(HALVES).replace("[0, 2, 3]", "[0, 2, 4]"), r"faces\[1\]\[2\]"),
    (json_from_mesh(HALVES).replace("[0, 2, 3]", "[0, 2]"), r"faces\[1\]"),
    (json_from_mesh(HALVES)[:50], ""),
])
def test_bad_meshes_are_refused(run: Run, write: Any, text: str, reason: str) -> None:
    result = run("verify", write("p.json", json_from_pslg(SQUARE)), write("m.json", text))
    assert result.status == 2 and result.out == "" and result.err.count("\n") == 1
    assert re.search(reason, result.err)


@pytest.mark.parametrize("command", [("mfs",), ("mesh",), ("verify", "-")])
def test_files_that_cannot_be_read_are_named(run: Run, tmp_path: Path, command: tuple[str, ...]) -> None:
    for path, reason in ((str(tmp_path / "none"), "no such file"), (str(tmp_path), "directory"),
                         ("a\0b", "cannot be read")):
        result = run(*command, path, stdin=json_from_pslg(SQUARE))
        assert result.status == 2 and result.out == "" and reason in result.err and result.err.count("\n") == 1


@pytest.mark.parametrize("bound", ["", "two", "nan", "1/0", "1e999999", "inf"])
def test_bad_bounds_are_refused(run: Run, write: Any, bound: str) -> None:
    pslg, mesh = write("p.json", json_from_pslg(SQUARE)), write("m.json", json_from_mesh(HALVES))
    result = run("verify", pslg, mesh, "--max-degradation", bound)
    assert result.status == 2 and result.out == "" and "--max-degradation" in result.err


@pytest.mark.parametrize("option", ["-o", "--report", "--svg"])
def test_results_that_cannot_be_written_are_named(run: Run, tmp_path: Path, option: str) -> None:
    path = str(tmp_path / "none" / "m.json")
    result = run("mesh", "-", "--quiet", option, path, stdin=ROOM)
    assert result.status == 2 and path in result.err and result.err.count("\n") == 1
    assert os.listdir(tmp_path) == []


def test_a_result_never_takes_the_place_of_a_directory(run: Run, tmp_path: Path) -> None:
    result = run("mesh", "-", "--quiet", "-o", str(tmp_path), stdin=ROOM)
    assert result.status == 2 and os.listdir(tmp_path) == []


def test_an_old_result_stays_when_the_new_one_is_refused(run: Run, write: Any, tmp_path: Path) -> None:
    old = write("m.json", "old")
    assert run("mesh", "-", "-o", old, stdin="POLYGON((0 0, 4 4, 4 0, 0 4, 0 0))").status == 2
    assert Path(old).read_text() == "old" and os.listdir(tmp_path) == ["m.json"]


# --- usage ---


@pytest.mark.parametrize("args", [
    (), ("mfs",), ("triangulate", "a"), ("mfs", "a", "--svg", "b"), ("verify", "a"), ("mesh", "a", "b"),
    ("mesh", "a", "--construction", "best"), ("--quiet",),
])
def test_wrong_usage_is_status_2(run: Run, args: tuple[str, ...]) -> None:
    result = run(*args)
    assert result.status == 2 and result.out == "" and result.err.startswith("usage: exactmesh")


def test_the_version(run: Run) -> None:
    assert run("--version") == (0, f"exactmesh {exactmesh.__version__}\n", "")


@pytest.mark.parametrize("args", [("--help",), ("mfs", "--help"), ("mesh", "--help"), ("verify", "--help")])
def test_help(run: Run, args: tuple[str, ...]) -> None:
    result = run(*args)
    assert result.status == 0 and result.out.startswith("usage: exactmesh") and result.err == ""


# --- interruption ---


@pytest.mark.parametrize("command", [("mfs", "-"), ("mesh", "-")])
def test_an_interruption_is_status_130(run: Run, monkeypatch: pytest.MonkeyPatch, command: tuple[str, ...]) -> None:
    def interrupted(path: str) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(options, "read_pslg", interrupted)
    assert run(*command) == (130, "", "exactmesh: interrupted\n")


def test_an_interruption_while_writing_leaves_nothing(run: Run, tmp_path: Path,
                                                      monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(descriptor: int) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", interrupted)
    result = run("mesh", "-", "--quiet", "-o", str(tmp_path / "m.json"), stdin=ROOM)
    assert result.status == 130 and os.listdir(tmp_path) == []


def test_a_reader_that_has_gone_ends_the_command_quietly(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def gone(args: Any) -> int:
        raise BrokenPipeError

    monkeypatch.setattr(size, "_run", gone)
    assert run("mfs", "-") == (1, "", "")


# --- processes ---


def test_the_module_is_the_command() -> None:
    done = shell("--version", module=True)
    assert (done.returncode, done.stdout.decode()) == (0, f"exactmesh {exactmesh.__version__}{os.linesep}")


def test_no_progress_where_standard_error_is_no_terminal() -> None:
    done = shell("mesh", "-", "--quiet", "-o", "-", stdin=ROOM.encode(), module=True)
    assert done.returncode == 0 and done.stderr == b"" and mesh_from_json(done.stdout.decode()).faces


@pytest.mark.skipif(os.name != "posix", reason="pipes and devices as on POSIX")
@pytest.mark.parametrize("args", [("examples", "norway"), ("mfs", "-"), ("mesh", "-", "--quiet", "-o", "-")])
def test_a_closed_pipe_is_no_traceback(args: tuple[str, ...]) -> None:
    reading, writing = os.pipe()
    os.close(reading)
    try:
        done = subprocess.run([sys.executable, "-m", "exactmesh", *args], input=ROOM.encode(), stdout=writing,
                              stderr=subprocess.PIPE, timeout=60, check=False)
    finally:
        os.close(writing)
    assert done.returncode == 1 and done.stderr == b""


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="a device that is always full")
@pytest.mark.parametrize("args", [("mfs", "-"), ("mesh", "-"), ("mesh", "-", "--quiet", "-o", "-")])
def test_a_full_disk_is_one_line(args: tuple[str, ...]) -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run([sys.executable, "-m", "exactmesh", *args], input=ROOM.encode(), stdout=full,
                              stderr=subprocess.PIPE, timeout=60, check=False)
    assert done.returncode == 2
    assert done.stderr.decode().splitlines() == [
        "exactmesh: standard output: cannot be written: No space left on device"]


@pytest.mark.skipif(os.name != "posix", reason="descriptors are closed as on POSIX")
@pytest.mark.parametrize("closed", [1, 2])
def test_a_closed_descriptor_does_no_harm(tmp_path: Path, closed: int) -> None:
    path = tmp_path / "a.wkt"
    path.write_text(ROOM)
    done = subprocess.run(["sh", "-c", f'exec "$0" -m exactmesh mfs "$1" {closed}>&-', sys.executable, str(path)],
                          capture_output=True, timeout=60, check=False)
    assert done.returncode == 0 and done.stderr == b""
