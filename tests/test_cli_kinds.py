"""Kinds, domains and boxes on the command line: what is written, and what is refused in one line."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import families
import pytest
from constructions import HALL, graph, point
from gmpy2 import mpq

from exactmesh import cli
from exactmesh.io.mesh_json import mesh_from_json
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.planar.pslg import Pslg

Run = Callable[..., tuple[int, str, str]]
HOLLOW = families.polygon_with_holes(1, 1, 2)
L_SHAPE = families.l_shape(5)
KINDS = ("nonproper", "proper", "internal", "classic")
SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])


@pytest.fixture
def run(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Run:
    """Return a function that runs a command; a `Pslg` among the arguments is written to a file first."""
    def run_(*args: str | Pslg) -> tuple[int, str, str]:
        texts = []
        for i, arg in enumerate(args):
            if isinstance(arg, Pslg):
                path = tmp_path / f"{i}.json"
                path.write_text(json_from_pslg(arg))
                arg = str(path)
            texts.append(arg)
        try:
            status = cli.main(texts)
        except SystemExit as stop:
            status = int(stop.code or 0)
        captured = capsys.readouterr()
        return status, captured.out, captured.err
    return run_


def verified(run: Run, pslg: Pslg, path: Path, *more: str) -> dict[str, Any]:
    """Return what `verify --json` says of a mesh file."""
    status, out, err = run("verify", pslg, str(path), "--json", "--quiet", *more)
    assert (status, err) == (0, "")
    found: dict[str, Any] = json.loads(out)
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_mesh_and_verify_every_kind(run: Run, tmp_path: Path, kind: str) -> None:
    out, report = tmp_path / "mesh.json", tmp_path / "report.json"
    status, _, err = run("mesh", HOLLOW, "--kind", kind, "-o", str(out), "--report", str(report), "--svg",
                         str(tmp_path / "picture.svg"))
    assert (status, err) == (0, "") and (tmp_path / "picture.svg").read_text().startswith("<svg")
    assert mesh_from_json(out.read_text()).kind == kind
    told = json.loads(report.read_text())
    assert told["mesh"]["kind"] == kind and all(claim["holds"] for claim in told["claims"])
    found = verified(run, HOLLOW, out)
    assert found["valid"] and found["kind"] == kind and found["violations"] == []
    assert found["degradation_squared"] == told["degradation_squared"]
    keys = {"ifs_squared", "ifs_degradation_squared"}
    for answer in (found, told):
        assert keys & set(answer) == (keys if kind == "internal" else set())
    if kind == "internal":
        before, after = (mpq(found["ifs_squared"][key]) for key in ("input", "mesh"))
        assert before / after == mpq(found["ifs_degradation_squared"]) == mpq(told["ifs_degradation_squared"]) < 45**2


def test_the_best_classic_mesh(run: Run, tmp_path: Path) -> None:
    room = families.rectangle_with_two_midway_vertices(10)
    assert run("mesh", room, "--kind", "classic", "--optimal", "-o", str(tmp_path / "m.json"))[0] == 0
    assert mpq(verified(run, room, tmp_path / "m.json")["degradation_squared"]) == mpq(11, 2) ** 2 + 1


@pytest.mark.parametrize("kind", ["nonproper", "proper", "classic"])
def test_a_box(run: Run, tmp_path: Path, kind: str) -> None:
    tree = Pslg(graph([(0, 0), (3, 1), (5, 4)]).vertices, ((0, 1), (1, 2)))
    out = tmp_path / "mesh.json"
    assert run("mesh", tree, "--kind", kind, "--bounding-box", "5/2", "-o", str(out))[0] == 0
    made = mesh_from_json(out.read_text())
    assert {(-mpq(5, 2), -mpq(5, 2)), (mpq(15, 2), mpq(13, 2))} <= {(p.x, p.y) for p in made.vertices[3:7]}
    assert verified(run, tree, out, "--bounding-box", "2.5")["valid"]
    # Without the box, or with another one, it is no mesh of the input.
    assert run("verify", tree, str(out))[0] == 2
    status, said, _ = run("verify", tree, str(out), "--bounding-box", "2", "--json")
    assert status == 1 and not json.loads(said)["valid"]


def test_feature_sizes_within_a_box(run: Run) -> None:
    dots = Pslg((point(0, 0), point(3, 0)), ())
    assert json.loads(run("mfs", dots, "--json")[1])["mfs_squared"] == "9"
    assert json.loads(run("mfs", dots, "--bounding-box", "1", "--json")[1])["mfs_squared"] == "1"
    assert json.loads(run("ifs", dots, "--json")[1])["ifs_squared"] is None
    assert json.loads(run("ifs", dots, "--bounding-box", "1/2", "--json")[1])["ifs_squared"] == "1/4"
    # The outside counts once it is part of the domain.
    slits = families.slits(1, 1)
    inner, outer = (mpq(json.loads(run("ifs", slits, "--json", *box)[1])["ifs_squared"])
                    for box in ((), ("--bounding-box", "1")))
    assert outer < inner / 10**6


@pytest.mark.parametrize("margin, reason", [
    ("0", "must be positive, not 0"), ("-1", "must be positive, not -1"), ("nan", "'nan' is not"),
    ("inf", "'inf' is not"), ("wide", "'wide' is not"), ("", "'' is not"), ("1/0", "denominator"),
    ("1 2", "'1 2' is not")])
@pytest.mark.parametrize("command", ["mfs", "ifs", "mesh", "verify"])
def test_margins_that_are_refused(run: Run, tmp_path: Path, command: str, margin: str, reason: str) -> None:
    out = tmp_path / "mesh.json"
    assert run("mesh", L_SHAPE, "-o", str(out))[0] == 0
    more = {"verify": (str(out),), "mesh": ("-o", str(tmp_path / "no.json"))}.get(command, ())
    status, said, err = run(command, L_SHAPE, *more, f"--bounding-box={margin}")
    assert (status, said) == (2, "") and err.startswith("exactmesh: ") and err.count("\n") == 1 and reason in err
    assert not (tmp_path / "no.json").exists()


def test_there_is_nothing_to_put_a_box_around(run: Run) -> None:
    status, _, err = run("mesh", Pslg((), ()), "--bounding-box", "1")
    assert status == 2 and err.count("\n") == 1


BARS = Pslg(graph([(0, 0), (1, 0), (3, 0), (4, 2)]).vertices, ((0, 1), (2, 3)))


@pytest.mark.parametrize("pslg, more, reason", [
    (Pslg(SQUARE.vertices, SQUARE.edges, (point(4, 1),)), (), "hole point 0"),
    (Pslg(SQUARE.vertices, SQUARE.edges, (point(5, 1),)), (), "hole point 0 at (5, 1) lies outside"),
    (Pslg(SQUARE.vertices, SQUARE.edges, (point(1, 1),)), (), "every bounded face holds a hole point"),
    (BARS, (), "there is no bounded face to mesh"),
    (HALL, ("--kind", "internal"), "has the domain on both sides"),
    (families.grid_map(2, 2, 1), ("--kind", "internal"), "has the domain on both sides"),
    (L_SHAPE, ("--kind", "internal", "--bounding-box", "1"), "has the domain on both sides"),
    (HOLLOW, ("--kind", "classic", "--optimal"), "one simple polygon"),
    (families.random_simple_polygon(201, 1), ("--kind", "classic", "--optimal"), "at most 200 vertices, not 201"),
    (L_SHAPE, ("--optimal",), "--optimal is for --kind classic"),
    (L_SHAPE, ("--kind", "proper", "--optimal"), "--optimal is for --kind classic"),
    (L_SHAPE, ("--kind", "internal", "--construction", "paper"), "nonproper and proper meshes, not internal ones"),
    (L_SHAPE, ("--kind", "classic", "--construction", "paper"), "not classic ones"),
    (L_SHAPE, ("--kind", "classic", "--construction", "repaired"), "nonproper, proper and internal meshes"),
    (HOLLOW, ("--construction", "paper"), "simple polygon"),
])
def test_what_is_refused_in_one_line(run: Run, tmp_path: Path, pslg: Pslg, more: tuple[str, ...], reason: str) -> None:
    out = tmp_path / "mesh.json"
    status, said, err = run("mesh", pslg, *more, "-o", str(out))
    assert (status, said) == (2, "") and err.startswith("exactmesh: ") and err.count("\n") == 1 and reason in err
    assert not out.exists()


@pytest.mark.parametrize("kind", ["proper", "classic"])
def test_classic_is_a_kind_and_no_construction_to_ask_for(run: Run, kind: str) -> None:
    status, said, err = run("mesh", L_SHAPE, "--kind", kind, "--construction", "classic")
    assert (status, said) == (2, "") and "--construction: invalid choice: 'classic'" in err


def test_an_unknown_kind(run: Run) -> None:
    status, _, err = run("mesh", L_SHAPE, "--kind", "cubic")
    assert status == 2 and "invalid choice: 'cubic'" in err


@pytest.mark.parametrize("kind", ["nonproper", "proper"])
def test_the_paper_makes_both_kinds(run: Run, tmp_path: Path, kind: str) -> None:
    out = tmp_path / "mesh.json"
    run("mesh", SQUARE, "--kind", kind, "--construction", "paper", "-o", str(out))
    assert verified(run, SQUARE, out)["kind"] == kind
