"""The page of all results: complete, whole in one file, and the same whenever it is made."""

import hashlib
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from exactmesh import cli
from exactmesh.claims.ledger import CLAIMS
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.reproduce import everything
from exactmesh.reproduce.everything import report_page, versions
from exactmesh.reproduce.figures import FIGURES
from exactmesh.reproduce.page import Picture, Section, page

_VOID = {"meta", "img", "br"}


class Reader(HTMLParser):
    """Collects what a page refers to, its texts and ids, and checks that elements are closed in order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []
        self.sources: list[str] = []
        self.pictures = 0
        self.texts: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in _VOID:
            self.open.append(tag)
        found = dict(attrs)
        if "id" in found:
            self.ids.append(str(found["id"]))
        self.links += [str(found["href"])] if "href" in found else []
        self.sources += [str(found["src"])] if "src" in found else []
        self.pictures += tag == "figure"

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert "href" not in dict(attrs)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = tmp_path_factory.mktemp("all")
    with pytest.MonkeyPatch.context() as patch:
        # Less of what has tests of its own: one family, the shortest rectangles, two inputs for the other meshers.
        patch.setattr(everything, "FAMILIES", everything.FAMILIES[:1])
        patch.setattr(everything, "_SHORT_LENGTHS", (2, 3))
        few = everything.inputs(True)[:1] + everything.inputs(True)[-1:]
        patch.setattr(everything, "inputs", lambda short: few)
        assert cli.main(["reproduce", "all", "--short", "-o", str(made), "--quiet"]) == 0
    return made


@pytest.fixture(scope="module")
def text(folder: Path) -> str:
    return (folder / "report.html").read_text()


@pytest.fixture(scope="module")
def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    return reader


def test_the_page_has_every_result(folder: Path, read: Reader) -> None:
    assert read.open == [] and len(set(read.ids)) == len(read.ids)
    results = ["bounds", "table1", "spread", "figures", *FIGURES, "claims", "proofs", "dissection", "peers"]
    assert [name for name in read.ids if name in results] == results
    assert {link.removeprefix("#") for link in read.links} <= set(read.ids)
    words = "".join(read.texts)
    assert all(claim.id in words for claim in CLAIMS)
    assert "a check FAILS" not in words and words.count("all that is checked here holds") == 3
    # The figures, Table 1, degradation against length, a dissection.
    assert read.pictures == len(FIGURES) + 3
    found = json.loads((folder / "report.json").read_text())
    assert [section["id"] for section in found["sections"]] == results
    assert found["versions"] == versions() and "exactmesh" in found["versions"]


def test_the_page_needs_nothing_else(text: str, read: Reader) -> None:
    assert all(source.startswith("data:image/svg+xml;base64,") for source in read.sources) and len(read.sources) == 3
    addresses = set(re.findall(r"\b(?:https?|file):[^\"' <]*", text))
    assert addresses == {"http://www.w3.org/2000/svg"}  # a name, not a place
    assert "<script" not in text and "@import" not in text and "url(" not in text


def test_each_result_has_its_command_and_the_hashes_of_its_inputs(folder: Path) -> None:
    sections = {section["id"]: section for section in json.loads((folder / "report.json").read_text())["sections"]}
    for name, section in sections.items():
        assert section["commands"][0].startswith("exactmesh "), name
        assert all(re.fullmatch(r"[0-9a-f]{64}", digest) for digest in section["inputs"].values())
    assert sections["claims"]["inputs"] == {
        name: hashlib.sha256(WITNESSES.path(name).read_bytes()).hexdigest() for name in WITNESSES.names()}
    assert len(sections["table1"]["inputs"]) == 7 and len(sections["spread"]["inputs"]) == 14
    assert all(path.endswith(".json") for path in sections["proofs"]["inputs"])


def test_a_command_of_the_page_prints_what_is_in_it(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sections = {section["id"]: section for section in json.loads((folder / "report.json").read_text())["sections"]}
    for name in ("bounds", "spread"):
        assert cli.main(sections[name]["commands"][0].split()[1:]) == 0
        assert capsys.readouterr().out == sections[name]["text"] + "\n"


def test_what_fails_is_told(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
                            ) -> None:
    bad = Section("bad", "A < B", ("exactmesh no",), "1 < 2 & 3", holds=False, inputs={"<x>": "0" * 64})
    monkeypatch.setattr("exactmesh.reproduce.everything.sections", lambda short, progress: iter([bad]))
    assert cli.main(["reproduce", "all", "-o", str(tmp_path)]) == 1
    assert "failing: bad" in capsys.readouterr().out
    html = (tmp_path / "report.html").read_text()
    assert "a check FAILS" in html and "A &lt; B" in html and "1 &lt; 2 &amp; 3" in html and "&lt;x&gt;" in html
    assert cli.main(["reproduce", "all", "-o", str(tmp_path), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["sections"][0]["holds"] is False


def test_the_page_depends_on_the_results_alone() -> None:
    one = Section("a", "A", ("x", "y"), pictures=(Picture("<svg/>", "p"), Picture("<svg/>", "q", is_plain=False)))
    assert report_page([one]) == report_page([one])
    assert "its parts alone (1)" in page("t", "l", {}, [one])


def test_a_folder_is_needed(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["reproduce", "all", "-o", "-"]) == 2
    assert "needs a folder" in capsys.readouterr().err
