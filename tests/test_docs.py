"""The documentation site builds with strict links, and what its pages show to do is done here."""

import contextlib
import re
import shlex
import subprocess
import sys
from pathlib import Path

import pytest
import readme
from families import comb

from exactmesh.commands.parser import parser_of
from exactmesh.io.pslg_json import json_from_pslg

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "docs" / name for name in (
    "tutorial.md", "how-to/own-file.md", "how-to/verify.md", "how-to/cluster.md", "how-to/cite.md",
    "pictures.md")]
FAILS = "--stop-at-first"  # the search that is meant to end with a violation
_FILE = re.compile(r"```text (\S+)\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_the_commands_do_what_is_said(page: Path, tmp_path: Path) -> None:
    text = page.read_text(encoding="utf-8")
    with contextlib.chdir(tmp_path):
        for name, content in _FILE.findall(text):
            Path(name).write_text(content, encoding="utf-8")
        commands = readme.commands(text)
        assert commands
        for command in commands:
            assert readme.run(command)[0] == (1 if FAILS in command else 0), command


@pytest.mark.parametrize("page", ["certificate", "optimize"])
def test_commands_on_files_that_a_page_takes_as_given(page: str, tmp_path: Path) -> None:
    commands = readme.commands((ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8"))
    with contextlib.chdir(tmp_path):
        readme.run("exactmesh examples luxembourg -o outline.geojson")
        Path("comb.json").write_text(json_from_pslg(comb(20)), encoding="utf-8")
        # The comparison with other meshers has its own tests, and takes its time.
        done = [command for command in commands if command.startswith("exactmesh ") and "peers" not in command]
        assert done and all(readme.run(command)[0] == 0 for command in done)


def test_every_command_of_every_page_is_one_that_there_is() -> None:
    found = [line.strip().removeprefix("$ ") for page in (ROOT / "docs").rglob("*.md")
             for line in page.read_text(encoding="utf-8").splitlines()
             if re.match(r"(    |\$ )exactmesh \w", line) and " [" not in line]  # a bracket: a synopsis
    assert len(found) > 30
    for line in found:
        words = shlex.split(line, comments=True)[1:]
        parser_of(words[0]).parse_args(words)


@pytest.mark.parametrize("page", sorted((ROOT / "docs").rglob("*.md")), ids=lambda page: page.stem)
def test_the_python_runs(page: Path) -> None:
    for block in re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL):
        subprocess.run([sys.executable, "-c", block], check=True)


def test_the_site_is_built_with_strict_links(tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, "-m", "mkdocs", "build", "--strict", "--quiet", "--site-dir", tmp_path],
                          cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    errata = (tmp_path / "errata" / "index.html").read_text(encoding="utf-8")
    assert "theorem-1.degradation" in errata and "lemma-1.degradation" not in errata
    assert "Re-checked" in (tmp_path / "theorems" / "lemma-1" / "index.html").read_text(encoding="utf-8").replace(
        "re-checked", "Re-checked")
    chain = (tmp_path / "theorems" / "the-repaired-construction" / "index.html").read_text(encoding="utf-8")
    assert "Worst found, 21.55" in chain
    assert (tmp_path / "reference" / "index.html").read_text(encoding="utf-8").count("exactmesh.api") > 5
