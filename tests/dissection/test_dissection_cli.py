"""The commands `dissect`, `verify-dissection` and `reproduce dissection`: statuses, files, refusals."""

import json
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from exactmesh import cli

SQUARE = "POLYGON((0 0,2 0,2 2,0 2,0 0))"
RECTANGLE = "POLYGON((0 0,4 0,4 1,0 1,0 0))"
LONGER = "POLYGON((0 0,5 0,5 1,0 1,0 0))"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in (("a", SQUARE), ("b", RECTANGLE), ("c", LONGER)):
        (tmp_path / f"{name}.wkt").write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_a_dissection_is_written_drawn_and_verified(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["dissect", "a.wkt", "b.wkt", "-o", "p.json", "--svg", "p.svg"]) == 0
    assert "6875 x 2 x (4 + 4)" in capsys.readouterr().out
    assert cli.main(["verify-dissection", "a.wkt", "b.wkt", "p.json"]) == 0
    assert "40 pieces of area 4" in capsys.readouterr().out
    assert cli.main(["verify-dissection", "a.wkt", "b.wkt", "p.json", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["valid"] is True
    root = ElementTree.parse(folder / "p.svg").getroot()
    assert len(list(root.iter("{http://www.w3.org/2000/svg}path"))) == 80


def test_drawings_are_written(folder: Path) -> None:
    assert cli.main(["dissect", "a.wkt", "b.wkt", "-o", "p.json", "--animation", "m.svg", "--cut-sheet", "c.svg"]) == 0
    assert len(list(ElementTree.parse(folder / "m.svg").getroot().iter("{http://www.w3.org/2000/svg}path"))) == 40
    assert ElementTree.parse(folder / "c.svg").getroot().get("width") == "210mm"


def test_a_factor_is_told(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["dissect", "a.wkt", "c.wkt", "-o", "p.json", "--scale"]) == 0
    assert "polygon 2 is scaled by 2*sqrt(5)/5 = 0.894427191" in capsys.readouterr().out
    assert cli.main(["verify-dissection", "a.wkt", "c.wkt", "p.json"]) == 0
    assert "2*sqrt(5)/5" in capsys.readouterr().out


def test_what_is_no_dissection_has_status_1(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    cli.main(["dissect", "a.wkt", "b.wkt", "-o", "p.json", "--quiet"])
    assert cli.main(["verify-dissection", "b.wkt", "a.wkt", "p.json"]) == 1
    assert "the clause 'tiling' fails" in capsys.readouterr().out
    assert cli.main(["verify-dissection", "b.wkt", "a.wkt", "p.json", "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["refusal"] == {"clause": "tiling", "place": {"figure": 0}}


@pytest.mark.parametrize("arguments, reason", [
    (["dissect", "a.wkt", "c.wkt", "-o", "p.json"], "areas differ: 4 (polygon 1) and 5 (polygon 2)"),
    (["dissect", "a.wkt", "-o", "p.json"], "two polygons or more"),
    (["dissect", "a.wkt", "b.wkt", "-o", ""], "is empty"),
    (["dissect", "a.wkt", "b.wkt", "-o", "p", "--svg", "p"], "one place"),
    (["dissect", "a.wkt", "b.wkt", "-o", "p", "--svg", "s", "--animation", "s"], "one place"),
    (["dissect", "a.wkt", "b.wkt", "-o", "p", "--cut-sheet", ""], "is empty"),
    (["dissect", "-", "-", "-o", "p.json"], "once only"),
    (["verify-dissection", "a.wkt", "b.wkt", "none.json"], "none.json: no such file"),
    (["verify-dissection", "a.wkt", "b.wkt", "a.wkt"], "a.wkt: line 1"),
    (["verify-dissection", "a.wkt", "a.wkt"], "two polygons or more")])
def test_refusals_are_one_line(folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], reason: str
                               ) -> None:
    assert cli.main(arguments) == 2
    error = capsys.readouterr().err
    assert reason in error and error.count("\n") == 1
    assert not (folder / "p.json").exists()


def test_pieces_on_standard_output_are_not_mixed_with_the_summary(folder: Path, capsys: pytest.CaptureFixture[str]
                                                                  ) -> None:
    assert cli.main(["dissect", "a.wkt", "b.wkt", "-o", "-"]) == 0
    captured = capsys.readouterr()
    assert json.loads(captured.out)["format"] == "exactmesh-dissection/1" and "pieces" in captured.err


def test_the_table_is_printed(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("exactmesh.dissection.lower_bound.rectangle_rows.__defaults__", ((2, 4), lambda step: None))
    assert cli.main(["reproduce", "dissection"]) == 0
    assert "r = 4" in capsys.readouterr().out
    assert cli.main(["reproduce", "dissection", "--json"]) == 0
    assert [row["r"] for row in json.loads(capsys.readouterr().out)["rows"]] == [2, 4]
