"""The README's commands and their outputs. `python tests/readme.py` writes the outputs anew."""

import contextlib
import io
import os
import re
import shlex
import tempfile
from pathlib import Path

from exactmesh.cli import main

README = Path(__file__).parents[1] / "README.md"
_OUTPUT = re.compile(r"(<!-- output of: (.*?) -->\n```text\n)(.*?)(```\n)", re.DOTALL)
_CONSOLE = re.compile(r"```console\n(.*?)```\n", re.DOTALL)


def run(command: str) -> tuple[int, str]:
    """Run one `exactmesh ...` command in the current folder; return its exit status and standard output."""
    program, *arguments = shlex.split(command)
    assert program == "exactmesh", command
    stdout = io.StringIO()
    with contextlib.redirect_stdout(stdout):
        status = main(arguments)
    return status, stdout.getvalue()


def commands(text: str) -> list[str]:
    """Return the commands of the console blocks, in order."""
    return [line.removeprefix("$ ") for block in _CONSOLE.findall(text) for line in block.splitlines()]


def outputs(text: str) -> list[tuple[str, str]]:
    """Return the commands whose output is shown, with that output."""
    return [(command, shown) for _, command, shown, _ in _OUTPUT.findall(text)]


def updated(text: str) -> str:
    """Return the text with all outputs as they are now."""
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        for command in commands(text):
            run(command)
        return _OUTPUT.sub(lambda match: match[1] + run(match[2])[1] + match[4], text)


if __name__ == "__main__":
    os.environ["COLUMNS"] = "120"
    README.write_text(updated(README.read_text(encoding="utf-8")), encoding="utf-8")
