"""What `exactmesh trust` lists is what runs."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

import exactmesh
from exactmesh.cli import main
from exactmesh.trust import Base, trust_text, trusted_bases

ROOT = Path(exactmesh.__file__).parent
BASES = {base.name: base for base in trusted_bases()}
RUNS = {"check.py": "exactmesh.check", "mfs": "exactmesh.measure.mfs", "verify": "exactmesh.measure.validity",
        "reading": "exactmesh.io.mesh_json", "steps": "exactmesh.steps.offset_check",
        "dissection": "exactmesh.dissection.verify", "proofs": "exactmesh.proofs.certificate"}


def paths(base: Base) -> set[str]:
    return {path for path, _ in base.files}


@pytest.mark.parametrize("name", RUNS)
def test_what_is_imported_is_listed(name: str) -> None:
    script = (f"import sys, {RUNS[name]}\n"
              "print('\\n'.join(m.__file__ for n, m in sys.modules.items() if n.partition('.')[0] == 'exactmesh'))")
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=60, check=True)
    loaded = {Path(line).relative_to(ROOT).as_posix() for line in done.stdout.split()}
    assert "measure/candidates.py" in loaded or name not in ("mfs", "verify")
    # check.py runs without the package.
    assert loaded - {"__init__.py"} <= paths(BASES[name])
    assert ("__init__.py" in paths(BASES[name])) == (name != "check.py")


@pytest.mark.parametrize("name", BASES)
def test_lines_are_those_of_the_files(name: str) -> None:
    base = BASES[name]
    for path, lines in base.files:
        assert (ROOT / path).read_bytes().count(b"\n") == lines
    assert base.lines == sum(lines for _, lines in base.files) > 100


def test_the_bases_are_as_small_as_they_claim() -> None:
    assert BASES["check.py"].files == (("check.py", BASES["check.py"].lines),) and BASES["check.py"].lines <= 700
    assert paths(BASES["check.c"]) == {"check.c"}
    for name, base in BASES.items():
        rooms = {path.split("/")[0] for path in paths(base)}
        assert not rooms & {"repaired.py", "paper.py", "classic.py", "claims", "api.py", "cli.py", "commands"}, name
        assert set(base.libraries) <= {"gmpy2", "numpy"}, name
    assert not {path for name in ("mfs", "verify") for path in paths(BASES[name]) if path.startswith(("io/", "steps/"))}
    assert "steps/snap_check.py" in paths(BASES["steps"]) and "steps/snap.py" not in paths(BASES["steps"])
    assert paths(BASES["mfs"]) < paths(BASES["verify"])


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["trust"]) == 0
    shown = capsys.readouterr().out
    assert shown == trust_text(trusted_bases()) + "\n" and "exactmesh/measure/validity.py" in shown
    assert main(["trust", "--short"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == len(BASES)
    assert main(["trust", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)["trusted"]
    assert [(base["base"], base["lines"]) for base in told] == [(base.name, base.lines) for base in BASES.values()]
    assert told[0]["files"] == [{"path": "exactmesh/check.py", "lines": BASES["check.py"].lines}]
