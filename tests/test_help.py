"""`--help` shows examples first, which are command lines that the parser takes; completion knows every command."""

import re
import shlex
import subprocess
from pathlib import Path

import pytest

from exactmesh import cli
from exactmesh.commands import MODULES
from exactmesh.commands.help_examples import EXAMPLES
from exactmesh.commands.parser import parser_of


def test_every_command_has_examples_and_a_module() -> None:
    assert set(MODULES) == set(EXAMPLES)
    folder = Path(cli.__file__).parent / "commands"
    assert all((folder / f"{module}.py").exists() for module in MODULES.values())


@pytest.mark.parametrize("name", MODULES)
def test_help_begins_with_examples_that_parse(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        cli.main([name, "--help"])
    out = capsys.readouterr().out
    for line, what in EXAMPLES[name]:
        program, *words = shlex.split(line.partition(" > ")[0])
        assert program == "exactmesh" and words[0] == name and what
        parser_of(name).parse_args(words)
        assert 0 < out.index(line) < out.index("options:")


def test_the_usage_of_no_command_names_all(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="0"):
        cli.main(["--help"])
    out = capsys.readouterr().out
    assert all(re.search(rf"^ +{name}\b", out, re.MULTILINE) for name in MODULES)


def test_completion_for_shells(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    for shell in ("bash", "zsh", "tcsh"):
        assert cli.main(["completion", shell]) == 0
        script = capsys.readouterr().out
        assert all(name in script for name in MODULES)
        if shell == "bash":
            (tmp_path / "script").write_text(script)
            subprocess.run(["bash", "-n", str(tmp_path / "script")], check=True)
