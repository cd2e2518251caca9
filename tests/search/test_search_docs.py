"""docs/search.md: its commands run and print what is shown, its plug-in works, the catalogue's commands are taken."""

import contextlib
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
import readme

from exactmesh.cli import main

TEXT = (Path(__file__).parents[2] / "docs" / "search.md").read_text(encoding="utf-8")
# A claim of which confirmed violations are found.
FAIL = "appendix-a.offset-edge-length"
CATALOGUE = [line for block in re.findall(r"```text\n(exactmesh .*?)```", TEXT, re.DOTALL)
             for line in block.splitlines()]


@pytest.fixture(scope="module")
def statuses(tmp_path_factory: pytest.TempPathFactory) -> Iterator[dict[str, int]]:
    """Run all commands of the page in one folder, in order."""
    with contextlib.chdir(tmp_path_factory.mktemp("docs")):
        [plugin] = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
        Path("thin.py").write_text(plugin, encoding="utf-8")
        yield {command: readme.run(command)[0] for command in readme.commands(TEXT)}


def test_the_commands_do_what_is_said(statuses: dict[str, int]) -> None:
    assert len(statuses) >= 8
    for command, status in statuses.items():
        assert status == (1 if "hits" not in command and FAIL in command else 0), command


@pytest.mark.parametrize(("command", "shown"), readme.outputs(TEXT))
def test_the_output_is_what_is_shown(statuses: dict[str, int], command: str, shown: str) -> None:
    assert statuses and readme.run(command)[1] == shown


@pytest.mark.parametrize("command", [command for command in CATALOGUE if "exhaustive" not in command])
def test_the_commands_of_the_catalogue_are_taken(command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # One short walk each, and no shrinking of the worst: all of it takes minutes.
    monkeypatch.setattr("exactmesh.commands.engine.keep_records", lambda store, run: None)
    short = re.sub(r"--(tasks|size|count) \d+", r"--\1 1", command).replace("finds.db", "s.db")
    with contextlib.chdir(tmp_path):
        assert main([*shlex.split(short)[1:], "--quiet"]) in (0, 1)


@pytest.mark.parametrize("command", [command for command in CATALOGUE if "exhaustive" in command])
def test_what_is_known_is_found_again(command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with contextlib.chdir(tmp_path):
        assert main([*shlex.split(command)[1:], "--jobs", "2", "--quiet"]) == 1
        assert main(["hits", "finds.db", "--confirmed", "--max-points", "3"]) == 0
    assert "second implementation" in capsys.readouterr().out
