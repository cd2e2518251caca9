"""`exactmesh mesh --optimize`: what it writes and says, what it refuses, and what an interrupt leaves."""

import hashlib
import json
import signal
from collections.abc import Callable
from pathlib import Path

import families
import pytest

from exactmesh import cli
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.planar.pslg import Pslg
from exactmesh.progress import Progress


@pytest.fixture
def given(tmp_path: Path) -> Callable[[Pslg], Path]:
    """Return a function that writes an input."""
    def write(pslg: Pslg) -> Path:
        path = tmp_path / "in.json"
        path.write_text(json_from_pslg(pslg), encoding="utf-8")
        return path
    return write


def test_it_writes_a_better_mesh_that_verifies_with_a_certificate(
        given: Callable[[Pslg], Path], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = str(given(families.comb(10)))
    files = {name: str(tmp_path / f"{name}.out") for name in ("mesh", "certificate", "report", "svg")}
    options = [f"--{name}={file}" for name, file in files.items() if name != "mesh"]
    assert cli.main(["mesh", path, "--optimize", "-o", files["mesh"], *options]) == 0
    said = capsys.readouterr().out
    assert "constrained Delaunay, optimised" in said and "no move helps" in said and "valid proper mesh" in said
    assert cli.main(["verify", path, files["mesh"], "--max-degradation", "2.6"]) == 0
    assert cli.main(["check", path, files["mesh"], files["certificate"]]) == 0
    report = json.loads(Path(files["report"]).read_text(encoding="utf-8"))
    assert report["construction"] == "optimized" and report["claims"] == []
    assert report["mesh"]["sha256"] == hashlib.sha256(Path(files["mesh"]).read_bytes()).hexdigest()
    assert "<svg" in Path(files["svg"]).read_text(encoding="utf-8")


def test_target_and_time_limit_are_obeyed(given: Callable[[Pslg], Path], capsys: pytest.CaptureFixture[str]) -> None:
    path = str(given(families.comb(10)))
    assert cli.main(["mesh", path, "--optimize", "--target", "7/2"]) == 0
    assert "is reached" in capsys.readouterr().out
    assert cli.main(["mesh", path, "--optimize", "--time-limit", "0"]) == 0
    said = capsys.readouterr().out
    assert "the time is up" in said and "repaired construction" in said and "degradation 6.02" in said
    assert cli.main(["mesh", path, "--optimize", "--time-limit", "1e300", "--target=5", "--quiet"]) == 0
    assert capsys.readouterr() == ("", "")


@pytest.mark.parametrize("options, reason", [
    (["--target", "3"], "--target and --time-limit are for --optimize"),
    (["--time-limit", "3"], "--target and --time-limit are for --optimize"),
    (["--optimize", "--kind", "classic"], "--optimize is for --kind nonproper and proper"),
    (["--optimize", "--kind", "internal"], "--optimize is for --kind nonproper and proper"),
    (["--optimize", "--construction", "paper"], "does not go with --construction paper"),
    (["--optimize", "--target", "1/2"], "below 1"),
    (["--optimize", "--target", "small"], "--target: 'small' is not"),
    (["--optimize", "--time-limit", "-1"], "--time-limit is negative"),
    (["--optimize", "--time-limit", "soon"], "--time-limit: 'soon' is not"),
])
def test_what_makes_no_sense_is_refused_in_a_line(
        options: list[str], reason: str, given: Callable[[Pslg], Path], capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["mesh", str(given(families.comb(2))), *options]) == 2
    captured = capsys.readouterr()
    assert reason in captured.err and captured.err.count("\n") == 1 and not captured.out


def test_an_interrupt_writes_the_best_mesh_so_far(
        given: Callable[[Pslg], Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str]) -> None:
    told = []

    def call(self: Progress, step: str) -> None:
        told.append(step)
        if step.startswith("optimisation: ") and sum(t.startswith("optimisation: ") for t in told) == 1:
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(Progress, "__call__", call)
    path, mesh = str(given(families.comb(40))), str(tmp_path / "mesh.json")
    assert cli.main(["mesh", path, "--optimize", "-o", mesh]) == 0
    captured = capsys.readouterr()
    assert "interrupted: this is the best mesh so far" in captured.err and "interrupted" in captured.out
    assert "verification" in told
    # The constrained Delaunay triangulation has degradation 21.02.
    assert cli.main(["verify", path, mesh, "--max-degradation", "10"]) == 0


def test_an_interrupt_before_there_is_a_mesh_is_one(
        given: Callable[[Pslg], Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
        capsys: pytest.CaptureFixture[str]) -> None:
    def call(self: Progress, step: str) -> None:
        if step.startswith("constrained Delaunay"):
            signal.raise_signal(signal.SIGINT)

    monkeypatch.setattr(Progress, "__call__", call)
    mesh = tmp_path / "mesh.json"
    assert cli.main(["mesh", str(given(families.comb(4))), "--optimize", "-o", str(mesh)]) == 130
    assert capsys.readouterr().err == "exactmesh: interrupted\n" and not mesh.exists()
