"""What the README says is so: its commands run, their outputs are those shown, its Python runs, its links lead."""

import contextlib
import re
import subprocess
import sys

import pytest
import readme

TEXT = readme.README.read_text(encoding="utf-8")
ROOT = readme.README.parent


@pytest.fixture(scope="module")
def statuses(tmp_path_factory):
    """Run all console commands in one folder, in order."""
    with contextlib.chdir(tmp_path_factory.mktemp("readme")):
        yield {command: readme.run(command)[0] for command in readme.commands(TEXT)}


def test_the_commands_do_what_is_said(statuses):
    refuted = "exactmesh claims theorem-1.degradation --witness l-shape-192 --construction paper"
    assert statuses.pop(refuted) == 1
    assert len(statuses) >= 5 and set(statuses.values()) == {0}


@pytest.mark.parametrize("command, shown", readme.outputs(TEXT), ids=lambda value: value.splitlines()[0][:40])
def test_the_outputs_are_those_shown(statuses, command, shown):
    assert readme.run(command)[1] == shown


def test_the_python_runs():
    for block in re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL):
        subprocess.run([sys.executable, "-c", block], check=True)


def test_links_lead_to_files():
    links = re.findall(r"\]\(([^)#:]+)\)", TEXT)
    assert links and all((ROOT / link).exists() for link in links)


def test_make_targets_exist():
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"`make (\w+)`|^make (\w+)", TEXT, re.MULTILINE))
    targets = {name for pair in targets for name in pair if name}
    assert {"demo", "test", "bench"} <= targets
    assert all(re.search(rf"^{target}:", makefile, re.MULTILINE) for target in targets)
