"""The command `view`: files in, a page out, and what is refused."""

import json
from pathlib import Path

import pytest
import readme
from pages import L_SHAPE

from exactmesh.cli import main
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.planar.pslg import polygon

ROOT = Path(__file__).parents[2]


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with an input, its mesh, and its report."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "l.json").write_text(json_from_pslg(L_SHAPE), encoding="utf-8")
    assert main(["mesh", "l.json", "-o", "mesh.json", "--report", "report.json", "--quiet"]) == 0
    return tmp_path


def data(page: Path) -> dict[str, object]:
    """Return the data of a page."""
    text = page.read_text(encoding="utf-8")
    found: dict[str, object] = json.loads(text.partition('id="data">')[2].partition("</script>")[0])
    return found


def names(page: Path) -> list[str]:
    stages: list[dict[str, str]] = data(page)["stages"]  # type: ignore[assignment]
    return [stage["name"] for stage in stages]


def test_a_mesh_with_whatever_is_known_of_it(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = folder / "page.html"
    assert main(["view", "mesh.json", "-o", "page.html"]) == 0
    assert names(page) == ["Mesh"] and data(page)["claims"] == [] and data(page)["given"] is None
    assert main(["view", "mesh.json", "--report", "report.json", "-o", "page.html"]) == 0
    claims: list[dict[str, object]] = data(page)["claims"]  # type: ignore[assignment]
    assert len(claims) > 15 and data(page)["given"] == 6 and data(page)["degradation"] is not None
    assert main(["view", "mesh.json", "--pslg", "l.json", "--report", "report.json", "-o", "page.html"]) == 0
    more: list[dict[str, object]] = data(page)["claims"]  # type: ignore[assignment]
    assert [claim["id"] for claim in more] == ["verification", *(claim["id"] for claim in claims)]
    assert names(page) == ["Input", "Mesh"]
    assert main(["view", "mesh.json", "--pslg", "l.json", "--report", "report.json", "--steps", "-o", "page.html"]) == 0
    steps = ["Input", "Q", "Trapezoids", "Interior", "Tube", "Mesh"]
    assert names(page) == steps and data(page)["title"] == "mesh.json"
    assert main(["view", "l.json", "--steps", "-o", "page.html"]) == 0
    assert names(page) == steps and len(data(page)["claims"]) == len(claims)  # type: ignore[arg-type]
    assert main(["view", "l.json", "--construction", "paper", "-o", "page.html"]) == 0
    assert names(page) == ["Input", "Mesh"] and len(data(page)["claims"]) > 50  # type: ignore[arg-type]
    assert capsys.readouterr() == ("", "")


def test_the_commands_of_the_page_in_docs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    commands = readme.commands((ROOT / "docs" / "viewer.md").read_text(encoding="utf-8"))
    assert len(commands) == 3
    assert [readme.run(command)[0] for command in commands] == [0, 0, 0]
    assert names(tmp_path / "page.html")[1:5] == ["Q", "Trapezoids", "Interior", "Tube"]


def test_meshes_of_others(folder: Path) -> None:
    square = polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
    (folder / "s.json").write_text(json_from_pslg(square), encoding="utf-8")
    (folder / "s.node").write_text("4 2 0 0\n1 0 2\n2 2 2\n3 2 0\n4 0 0\n", encoding="utf-8")
    (folder / "s.ele").write_text("2 3 0\n1 1 2 3\n2 1 3 4\n", encoding="utf-8")  # clockwise, in another order
    page = folder / "page.html"
    assert main(["view", "s.ele", "-o", "page.html"]) == 0
    assert data(page)["features"] == ["2", "2"] and names(page) == ["Mesh"]
    assert main(["view", "s.ele", "--pslg", "s.json", "-o", "page.html"]) == 0
    assert data(page)["x"] == ["0", "2", "2", "0"] and names(page) == ["Input", "Mesh"]
    assert data(page)["degradation"] == {"squared": "2", "exact": "sqrt(2)", "decimal": "1.4142136"}
    claims: list[dict[str, object]] = data(page)["claims"]  # type: ignore[assignment]
    assert [(claim["id"], claim["holds"]) for claim in claims] == [("verification", True)]


@pytest.mark.parametrize("arguments, message", [
    ([], "which mesh? give a file, or --edit"),
    (["mesh.json"], "where is the page to go? give -o PAGE"),
    (["mesh.json", "--pslg", "l.json", "-o", "./l.json"], "./l.json: the page would take the place of what it shows"),
    (["no.json", "-o", "p"], "no.json: no such file"),
    (["-", "-o", "p"], "a page is made of files, not of standard input"),
    (["l.json", "--report", "report.json", "-o", "p"], "--pslg and --report are for a mesh; this file is none"),
    (["mesh.json", "--steps", "-o", "p"], "the steps to a mesh begin with its input: give --pslg P as well"),
    (["mesh.json", "--construction", "paper", "-o", "p"], "--construction is for a PSLG; this file is a mesh"),
    (["s.ele", "--report", "report.json", "-o", "p"], "--report and --steps are for meshes by exactmesh"),
    (["mesh.json", "--report", "mesh.json", "-o", "p"],
     "mesh.json: an object of format 'exactmesh-report/1' is expected, not an object"),
    (["other.json", "--report", "report.json", "-o", "p"],
     "report.json: this is the report of another mesh than other.json"),
    (["mesh.json", "-o", "no/such/folder/p"], "no/such/folder/p: cannot be written: No such file or directory"),
    (["--edit", "--steps"], "--pslg, --report, --steps and --construction are for pages without --edit"),
    (["--edit", "-o", "-"], "the page saves to a file, not to standard output"),
    (["--edit", "no.json"], "no.json: no such file")])
def test_what_is_refused_is_told_in_a_line(folder: Path, capsys: pytest.CaptureFixture[str], arguments: list[str],
                                           message: str) -> None:
    mesh = (folder / "mesh.json").read_text(encoding="utf-8")
    (folder / "other.json").write_text(mesh + "\n", encoding="utf-8")
    (folder / "s.ele").write_text("", encoding="utf-8")
    assert main(["view", *arguments]) == 2
    assert capsys.readouterr() == ("", f"exactmesh: {message}\n")
    assert not (folder / "p").exists()


@pytest.mark.parametrize("port", ["x", "-1", "65536", "१"])
def test_a_port_is_a_number(port: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as caught:
        main(["view", "--edit", "--port", port])
    assert caught.value.code == 2 and "is not a port: 0 to 65535" in capsys.readouterr().err
