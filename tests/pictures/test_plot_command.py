"""The command `plot`: every kind of thing, every format, and what it refuses."""

import io
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from drawn import count, panels, root_of, texts

from exactmesh import cli
from exactmesh.api import mesh, polygon
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.planar.mesh import Mesh

ROOM = polygon([(0, 0), (7, 0), (7, 3), (4, 3), (4, 1), (3, 3), (0, 3)], "room")


class Files(NamedTuple):
    folder: Path
    room: str
    mesh: str


@pytest.fixture
def files(tmp_path: Path) -> Files:
    room, made = tmp_path / "room.json", tmp_path / "mesh.json"
    room.write_text(json_from_pslg(ROOM))
    made.write_text(json_from_mesh(mesh(ROOM).mesh))
    return Files(tmp_path, str(room), str(made))


def run(*words: str) -> int:
    return cli.main(["plot", *words])


def drawn(files: Files, *words: str) -> Any:
    out = files.folder / "out.svg"
    assert run(*words, "-o", str(out)) == 0
    return root_of(out.read_text())


def test_the_input_is_drawn_unless_more_is_asked_for(files: Files) -> None:
    root = drawn(files, files.room)
    assert count(root, "input") == 7 and count(root, "input-witness") == 1 and count(root, "feature-1") == 0
    assert [g.get("data-step") for g in panels(root)] == ["P"]


@pytest.mark.parametrize("words, step", [
    (("--step", "mesh"), "mesh"), (("--kind", "proper"), "mesh"), (("--construction", "paper"), "mesh"),
    (("--construction", "paper", "--step", "P5"), "P5"), (("--step", "trapezoids"), "trapezoids"),
    (("--kind", "classic"), "mesh"),
    (("--paper", "teeth=retiled", "--construction", "paper", "--step", "tube"), "tube"),
    (("--bounding-box", "1", "--step", "tube"), "tube"),
])
def test_steps_are_drawn(files: Files, words: tuple[str, ...], step: str) -> None:
    assert panels(drawn(files, files.room, *words))[0].get("data-step") == step


def test_all_steps_are_drawn(files: Files) -> None:
    assert len(panels(drawn(files, files.room, "--step", "all"))) == 6
    assert len(panels(drawn(files, files.room, "--step", "all", "--construction", "paper"))) == 11


def test_meshes_are_drawn_with_and_without_their_input(files: Files) -> None:
    faces = len(mesh(ROOM).mesh.faces)
    assert count(drawn(files, files.mesh), "faces") == faces
    root = drawn(files, files.room, files.mesh)
    assert sum(count(panels(root)[0], f"feature-{rank}") for rank in range(7)) == faces
    assert count(root, "witness") >= 1


def test_an_invalid_mesh_is_drawn_and_told(files: Files) -> None:
    bad = files.folder / "bad.json"
    bad.write_text(json_from_mesh(Mesh("nonproper", ROOM.vertices, ((0, 1, 2),))))
    out = files.folder / "bad.svg"
    assert run(files.room, str(bad), "-o", str(out)) == 1
    assert count(root_of(out.read_text()), "feature-0") == 1


NODES = "4 2 0 0\n1 0 0\n2 7 0\n3 7 3\n4 0 3\n"
# The second triangle is given clockwise.
TRIANGLES = "2 3 0\n1 1 2 3\n2 1 4 3\n"


def test_meshes_of_other_programs_are_drawn(files: Files) -> None:
    (files.folder / "box.node").write_text(NODES)
    ele = files.folder / "box.ele"
    ele.write_text(TRIANGLES)
    alone = drawn(files, str(ele))
    assert count(alone, "faces") == 2 and count(alone, "rim") == 4
    Path(files.room).write_text(json_from_pslg(polygon([(0, 0), (7, 0), (7, 3), (0, 3)])))
    root = drawn(files, files.room, str(ele))
    assert sum(count(root, f"feature-{rank}") for rank in range(7)) == 2 and count(root, "no-triangle") == 0


def test_a_mesh_that_is_not_quite_one_shows_its_nearest_pair(files: Files) -> None:
    # Its upper right corner is rounded: the edges are those of a plane graph, but not of a mesh of the input.
    (files.folder / "box.node").write_text(NODES)
    (files.folder / "box.ele").write_text(TRIANGLES)
    Path(files.room).write_text(json_from_pslg(polygon([(0, 0), (7, 0), ("7.0001", 3), (0, 3)])))
    out = files.folder / "box.svg"
    assert run(files.room, str(files.folder / "box.ele"), "-o", str(out)) == 1
    root = root_of(out.read_text())
    assert count(root, "witness") >= 1 and ", not valid" in texts(root, "heading")[0]


@pytest.mark.parametrize("words, made", [((), {"offset", "chord", "interior"}), (("--optimize",), {"steiner"}),
                                         (("--kind", "classic"), set())])
def test_the_command_mesh_draws_too(files: Files, words: tuple[str, ...], made: set[str]) -> None:
    out = files.folder / "mesh.svg"
    assert cli.main(["mesh", files.room, "--svg", str(out), "--quiet", *words]) == 0
    whole = panels(root_of(out.read_text()))[0]
    assert count(whole, "given") == 7
    assert {name for name in ("offset", "chord", "interior", "tube", "steiner") if count(whole, name)} <= made
    assert made <= {"steiner"} or count(whole, "offset")


def test_a_window_holds_what_is_in_it(files: Files) -> None:
    root = drawn(files, files.room, "--step", "mesh", "--window=-1/2,-1/2,1,1")
    assert count(root, "given") == 1 and 0 < count(root, "offset") < 10
    again = drawn(files, files.room, "--step", "mesh", "--window=1,1,-0.5,-0.5")
    assert [e.attrib for e in again.iter()] == [e.attrib for e in root.iter()]


def test_standard_input_and_output(files: Files, monkeypatch: pytest.MonkeyPatch,
                                   capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(json_from_pslg(ROOM).encode())))
    assert run("-", "-o", "-") == 0
    assert count(root_of(capsys.readouterr().out), "input") == 7


@pytest.mark.parametrize("ending, start", [("png", b"\x89PNG"), ("pdf", b"%PDF"), ("SVG", b"<svg")])
def test_formats_by_name(files: Files, ending: str, start: bytes) -> None:
    out = files.folder / f"out.{ending}"
    assert run(files.room, "-o", str(out)) == 0
    assert out.read_bytes().startswith(start)


def nothing(files: Files) -> None:
    """Leave the files as they are."""


def clip(files: Files) -> None:
    Path(files.room).write_text(json_from_pslg(polygon([(0, 0), (2, 2), (2, 0), (0, 2)])))


@pytest.mark.parametrize("change, words, says", [
    (nothing, ("{room}", "-o", "out.jpg"), "is .svg, .png or .pdf"),
    (nothing, ("{room}", "-o", ""), "an empty name"),
    (nothing, ("{room}", "--step", "P9", "-o", "out.svg"), "has no step 'P9'"),
    (nothing, ("{mesh}", "--step", "mesh", "-o", "out.svg"), "a mesh was given"),
    (nothing, ("{room}", "{mesh}", "--kind", "proper", "-o", "out.svg"), "a mesh was given"),
    (nothing, ("{room}", "{mesh}", "{mesh}", "-o", "out.svg"), "takes a PSLG, a mesh"),
    (nothing, ("-", "-", "-o", "out.svg"), "cannot both be standard input"),
    (nothing, ("{room}", "--window", "1,2,3", "-o", "out.svg"), "four numbers"),
    (nothing, ("{room}", "--window", "1,2,1,3", "-o", "out.svg"), "is empty"),
    (nothing, ("{room}", "--window", "a,2,1,3", "-o", "out.svg"), "--window"),
    (nothing, ("{room}", "--kind", "classic", "--construction", "paper", "-o", "out.svg"), "not classic ones"),
    (nothing, ("missing.json", "-o", "out.svg"), "missing.json: no such file"),
    (nothing, ("{mesh}", "{room}", "-o", "out.svg"), "mesh.json"),
    (clip, ("{room}", "-o", "out.svg"), "cross"),
])
def test_refusals_are_one_line(files: Files, change: Callable[[Files], None], words: tuple[str, ...], says: str,
                               monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.chdir(files.folder)
    change(files)
    assert run(*(word.format(room=files.room, mesh=files.mesh) for word in words)) == 2
    err = capsys.readouterr().err
    assert err.startswith("exactmesh: ") and err.count("\n") == 1 and says in err
    assert not [name for name in os.listdir() if name.startswith("out")]


def test_png_without_matplotlib_names_the_extra(files: Files, monkeypatch: pytest.MonkeyPatch,
                                                capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    assert run(files.room, "-o", str(files.folder / "out.png")) == 2
    assert "exactmesh[plot]" in capsys.readouterr().err
    assert run(files.room, "-o", str(files.folder / "out.svg")) == 0
