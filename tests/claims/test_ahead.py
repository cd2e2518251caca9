"""Checks in several processes say the same, in the same order, as in one."""

import json
from pathlib import Path

import families
import pytest
from constructions import HALL

from exactmesh.claims.ahead import _TASKS, verdicts_ahead
from exactmesh.claims.ledger import judge
from exactmesh.claims.repaired import STEP_CLAIMS
from exactmesh.claims.run import Run
from exactmesh.cli import main
from exactmesh.io.pslg_json import json_from_pslg

PSLG = families.random_simple_polygon(150, 3, "partition")


@pytest.mark.parametrize("kind", ["nonproper", "proper"])
def test_verdicts_are_the_same_whatever_the_number_of_processes(kind):
    expected = list(judge(Run(PSLG, kind=kind)))
    for jobs in (2, 3):
        run = Run(PSLG, kind=kind, jobs=jobs)
        assert list(judge(run)) == expected and run.mesh == Run(PSLG, kind=kind).mesh


def test_every_step_claim_is_checked_ahead_once():
    found = verdicts_ahead(Run(HALL), 2)
    assert set(found) == {claim.id for claim in STEP_CLAIMS if claim.concerns(Run(HALL))}
    for claim in STEP_CLAIMS:
        assert sum(claim.id.startswith(names) for names in _TASKS[1:]) == 1


def test_a_failing_claim_fails_in_another_process_too():
    run = Run(HALL, jobs=2)
    made = run.repaired
    object.__setattr__(made.interior, "faces", made.interior.faces[1:])
    found = verdicts_ahead(run, 2)
    assert not found["repaired.interior-tiling"].holds and found["repaired.tube-tiling"].holds


def test_one_job_or_another_construction_is_done_here():
    assert verdicts_ahead(Run(HALL), 1) == {} and verdicts_ahead(Run(PSLG, "classic", "classic"), 2) == {}


def test_the_command_writes_the_same_bytes(tmp_path: Path):
    source = tmp_path / "p.json"
    source.write_text(json_from_pslg(PSLG), encoding="utf-8")
    written = []
    for jobs in ("1", "2"):
        mesh, said = tmp_path / f"m{jobs}.json", tmp_path / f"r{jobs}.json"
        assert main(["mesh", str(source), "-o", str(mesh), "--report", str(said), "--jobs", jobs, "--quiet"]) == 0
        written.append((mesh.read_bytes(), json.loads(said.read_text())))
    assert written[0] == written[1]
