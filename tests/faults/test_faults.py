"""A short campaign of faults, that it sees what it should, and interruptions of the whole program."""

import contextlib
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Iterable
from pathlib import Path
from unittest.mock import patch

import campaign_faults
import pytest
from campaign_faults import LEFT_OVER, OLD, run, wrong

pytestmark = pytest.mark.skipif(os.name != "posix", reason="signals and forks as on POSIX")


def test_nothing_is_half_written() -> None:
    problems, table = run(1, 24, ["SIGKILL", "SIGINT", "small files"])
    assert not problems, problems[0]
    assert sum(int(line.split()[0]) for line in table.splitlines()[1:-1]) == 24


def test_writing_in_place_is_seen() -> None:
    def careless(path: str, parts: Iterable[bytes]) -> None:
        data = b"".join(parts)
        with open(path, "wb") as file:
            for at in range(0, len(data), 100):
                file.write(data[at : at + 100])
                file.flush()

    with patch("exactmesh.io.atomic._replace", careless):
        problems, _ = run(1, 12, ["small files"])
    assert any("neither old nor new" in problem for problem in problems)


def test_what_is_wrong_is_seen(tmp_path: Path) -> None:
    (tmp_path / "m.json").write_bytes(b"new")
    expected = {"m.json": b"new"}
    assert wrong("SIGINT", 130, "exactmesh: interrupted\n", tmp_path, set(), expected) == []
    assert wrong("SIGINT", 0, "", tmp_path, set(), expected) == []
    assert wrong("SIGINT", 1, "", tmp_path, set(), {"m.json": b"new", "r": b""}) == ["status 1"]
    assert "not a line" in wrong("SIGINT", 130, "Traceback\n", tmp_path, set(), expected)[0]
    (tmp_path / "m.json").write_bytes(OLD)
    assert wrong("SIGKILL", -9, "", tmp_path, {"m.json"}, expected) == []
    assert "neither" in wrong("SIGKILL", -9, "", tmp_path, set(), expected)[0]
    left = tmp_path / ".exactmesh-0123456789abcdef.tmp"
    left.write_bytes(b"ne")
    assert wrong("SIGKILL", -9, "", tmp_path, {"m.json"}, expected) == []
    assert "also there" in wrong("SIGINT", 130, "", tmp_path, {"m.json"}, expected)[0]
    (tmp_path / "m.json.tmp").write_bytes(b"")
    assert "m.json.tmp" in wrong("SIGKILL", -9, "", tmp_path, {"m.json"}, expected)[0]


def test_temporary_files_have_the_documented_name(tmp_path: Path) -> None:
    seen = []
    with patch("os.replace", lambda old, new: seen.append(old)):
        campaign_faults.cli.main(["examples", "chile", "-o", str(tmp_path / "a")])
    assert seen and LEFT_OVER.fullmatch(os.path.basename(seen[0]))
    documented = (Path(__file__).parents[2] / "docs" / "faults.md").read_text(encoding="utf-8")
    assert re.search(r"\.exactmesh-[0-9a-f]{16}\.tmp", documented)


def test_the_program_is_interrupted_in_a_line(tmp_path: Path) -> None:
    process = subprocess.Popen([sys.executable, "-m", "exactmesh", "mesh", "-", "-o", "out.json"], cwd=tmp_path,
                               stdin=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdin
    process.stdin.write(" " * 10**6)  # more than a pipe holds: it is reading
    process.stdin.flush()
    time.sleep(0.2)
    process.send_signal(signal.SIGINT)
    assert process.stderr and process.stderr.read() == "exactmesh: interrupted\n"
    assert process.wait(timeout=60) == 130 and os.listdir(tmp_path) == []
    with contextlib.suppress(BrokenPipeError):
        process.stdin.close()
    process.stderr.close()
