"""The paper's figures: all there, drawn by the commands beside them, refuting what they say they refute."""

import hashlib
import json
import shlex
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest
from drawn import count, one, panels, paths, root_of, texts

from exactmesh import cli
from exactmesh.claims.status import ledger
from exactmesh.errors import InputError
from exactmesh.reproduce.figure_kit import judged, run_of, witness
from exactmesh.reproduce.figures import FIGURES, figures, write_figures
from exactmesh.reproduce.spread import l_shape

COMPANIONS = [name for name in FIGURES if name.endswith("-fails")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("figures")
    assert cli.main(["reproduce", "figures", "-o", str(made), "--quiet"]) == 0
    return made


def records(folder: Path) -> list[dict[str, object]]:
    found = json.loads((folder / "figures.json").read_text())["figures"]
    assert isinstance(found, list)
    return found


def picture(folder: Path, name: str) -> ET.Element:
    return root_of((folder / f"{name}.svg").read_text())


def test_the_folder_is_complete(folder: Path) -> None:
    found = records(folder)
    assert [figure["name"] for figure in found] == list(FIGURES)
    assert [f"fig-{number:02}" for number in range(1, 11)] == [name for name in FIGURES if len(name) == 6]
    assert {path.name for path in folder.iterdir()} == {f"{name}.svg" for name in FIGURES} | {
        "figures.json", "inputs"}
    for figure in found:
        root = root_of((folder / str(figure["file"])).read_text())
        assert panels(root) and texts(root, "heading")
        # What the caption says is written below the picture, whole.
        assert " ".join(texts(root, "caption")) == " ".join(figure["caption"])  # type: ignore[arg-type]
    inputs = {name: digest for figure in found for name, digest in figure["inputs"].items()}  # type: ignore[attr-defined]
    assert {f"inputs/{path.name}" for path in (folder / "inputs").iterdir()} == set(inputs)
    for name, digest in inputs.items():
        assert hashlib.sha256((folder / name).read_bytes()).hexdigest() == digest


def test_every_command_does_what_it_says(folder: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path,
                                         capsys: pytest.CaptureFixture[str]) -> None:
    commands = {command for figure in records(folder) for command in figure["commands"]}  # type: ignore[attr-defined]
    monkeypatch.chdir(folder)
    drawn = 0
    for command in sorted(commands):
        program, *words = shlex.split(command)
        assert program == "exactmesh"
        if words[0] == "plot":
            words[-1] = str(tmp_path / words[-1])
            assert cli.main(words) == 0, command
            assert panels(root_of(Path(words[-1]).read_text()))
            drawn += 1
        elif words[0] == "claims":
            assert cli.main(words) == 1, command  # refuted
        else:
            assert words[:3] == ["reproduce", "figures", "--only"] and words[3] in FIGURES
    assert drawn > 30 and "FAILS" in capsys.readouterr().out


def test_one_figure_is_made_alone_with_the_same_bytes(folder: Path, tmp_path: Path) -> None:
    assert cli.main(["reproduce", "figures", "--only", "fig-07,fig-07-fails", "-o", str(tmp_path), "--quiet"]) == 0
    assert {path.name for path in tmp_path.iterdir()} == {"fig-07.svg", "fig-07-fails.svg", "figures.json", "inputs"}
    for name in ("fig-07.svg", "fig-07-fails.svg"):
        assert (tmp_path / name).read_bytes() == (folder / name).read_bytes()


def test_companions_show_claims_that_the_ledger_refutes(folder: Path) -> None:
    refuted = {entry.claim.id for entry in ledger() if any(j.status == "refuted" for j in entry.judged)}
    shown = {figure["name"]: set(figure["refuted"]) for figure in records(folder)}  # type: ignore[call-overload]
    assert all(bool(claims) == (name in COMPANIONS) for name, claims in shown.items())
    assert set().union(*shown.values()) <= refuted and len(set().union(*shown.values())) >= 24


def test_what_holds_is_not_shown_as_refuted() -> None:
    assert judged("theorem-1.degradation", run_of(l_shape(44), "paper")).startswith("Refuted: the degradation is below")
    with pytest.raises(AssertionError, match="holds on"):
        judged("theorem-1.degradation", run_of(witness("unit-square"), "paper"))


def test_figure_2_has_66_positions_and_figure_1_three_kinds(folder: Path) -> None:
    root = picture(folder, "fig-02")
    for panel in panels(root)[:3]:
        assert count(panel, "given") == 68 and count(panel, "input") == 4
    fan, layers, nested = panels(root)[:3]
    assert [count(panel, "steiner") for panel in (fan, layers, nested)] == [0, 63, 76]
    assert count(layers, "t-vertex") == 0 < count(nested, "t-vertex")
    titles = texts(picture(folder, "fig-01"), "panel-title")
    assert [title.partition(":")[0] for title in titles] == ["classic", "proper", "nonproper"]
    assert [count(panel, "t-vertex") for panel in panels(picture(folder, "fig-01"))] == [0, 0, 2]


def test_figures_mark_what_they_are_about(folder: Path) -> None:
    assert one(panels(picture(folder, "fig-03"))[0], "claimed").chains
    assert count(picture(folder, "fig-05"), "p2-arc") and "143.1°" in texts(picture(folder, "fig-05"), "note")
    assert count(picture(folder, "fig-06"), "quasi-trapz") == 9
    # Three triangles of a fan, with two angles and a least distance each.
    seven = picture(folder, "fig-07")
    assert len(paths(seven, "angle")) == 6 and len(paths(seven, "witness")) == 3
    angles = [float(text[:-1]) for text in texts(seven, "note") if text.endswith("°")]
    assert len(angles) == 6 and min(angles) > 45
    assert min(float(text[:-1]) for text in texts(picture(folder, "fig-08"), "note")) >= 135
    assert {"a", "b", "a'", "b'", "R", "Q''", "B"} <= set(texts(picture(folder, "fig-09"), "note"))
    assert texts(picture(folder, "fig-10"), "height-label") == ["1/(8 d3): 0.0238095 mfs"]
    assert texts(picture(folder, "p6-fails"), "panel-title")[1] == "paper: degradation 52.2031"


def test_unknown_names_are_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["reproduce", "figures", "--only", "fig-11", "-o", str(tmp_path)]) == 2
    assert "there is no figure 'fig-11'" in capsys.readouterr().err
    with pytest.raises(InputError):
        list(figures(["fig-1"]))


def test_a_folder_in_the_way_is_told(tmp_path: Path) -> None:
    (tmp_path / "inputs").write_text("a file")
    with pytest.raises(InputError, match="no folder can be made"):
        write_figures(list(figures(["fig-04"])), str(tmp_path))


def test_figures_are_listed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["reproduce", "figures", "--only", "fig-04", "-o", str(tmp_path)]) == 0
    assert "Figure 4: a polygon P and the curve P2" in capsys.readouterr().out
    assert cli.main(["reproduce", "figures", "--only", "fig-04", "-o", str(tmp_path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == json.loads((tmp_path / "figures.json").read_text())
