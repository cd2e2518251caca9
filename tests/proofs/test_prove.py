"""The command `exactmesh prove`: what it prints, its exit status, and that it can fail."""

import json
from dataclasses import replace

import pytest

from exactmesh import cli
from exactmesh.claims.ledger import CLAIMS
from exactmesh.claims.status import ledger
from exactmesh.proofs import prove as prove_module
from exactmesh.proofs import registry
from exactmesh.proofs.certificate import Refused
from exactmesh.proofs.engines import ENGINES, Engine, installed
from exactmesh.proofs.problem import group_from_json, json_from_group
from exactmesh.proofs.registry import groups, is_proved, theorems


def test_fast_mode_re_checks_all_certificates(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["prove", "--fast", "--quiet"]) == 0
    shown = capsys.readouterr().out
    assert "certificate: " in shown and "NOT PROVED" not in shown
    claims = sorted(theorem.claim for theorem in theorems())
    assert sorted(line.split()[0] for line in shown.splitlines()[1 : len(claims) + 1]) == claims


def test_json_has_the_keys_of_the_formats_document(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["prove", "lemma-1.case-1-feature-size", "--fast", "--json", "--quiet"]) == 0
    proofs = json.loads(capsys.readouterr().out)["proofs"]
    assert proofs and all({"claim", "method", "result", "seconds", "certificate"} <= set(proof) for proof in proofs)
    assert {proof["result"] for proof in proofs} == {"proved"}


def test_an_unknown_name_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["prove", "no-such-claim", "--fast"]) == 2
    assert "no-such-claim" in capsys.readouterr().err


@pytest.mark.parametrize("seconds", ["0", "-1", "nan", "inf"])
def test_seconds_have_a_range(seconds: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["prove", "--fast", "--seconds", seconds]) == 2
    assert "seconds" in capsys.readouterr().err


def test_a_proof_that_fails_is_an_exit_status(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
                                              ) -> None:
    group = groups()[0]
    broken = replace(group, problems=tuple(replace(p, certificate={"kind": "boxes", "variables": [], "tree": []})
                                           for p in group.problems))
    for module in (prove_module, registry):
        monkeypatch.setattr(module, "groups", lambda: (broken,))
    assert cli.main(["prove", "--fast", "--quiet"]) == 1
    assert "NOT PROVED" in capsys.readouterr().out


def test_what_rests_on_an_open_claim_is_an_exit_status(
        monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    group = next(group for group in groups() if any(theorem.claims for theorem in group.theorems))
    resting = tuple(replace(theorem, claims=("section-1.linear-time",)) for theorem in group.theorems)
    for module in (prove_module, registry):
        monkeypatch.setattr(module, "groups", lambda: (replace(group, theorems=resting),))
    assert cli.main(["prove", "--fast", "--quiet"]) == 1
    assert "NOT PROVED" in capsys.readouterr().out


def test_a_theorem_names_a_problem_once() -> None:
    group = groups()[0]
    theorem = replace(group.theorems[0], problems=group.theorems[0].problems * 2)
    with pytest.raises(Refused, match=f"a problem is named twice for {theorem.claim}"):
        group_from_json(json_from_group(replace(group, theorems=(theorem,))))


def test_nothing_is_both_proved_and_refuted() -> None:
    proved = [claim for claim in CLAIMS if is_proved(claim.id)]
    assert proved
    for claim in proved:
        assert not claim.witness, f"{claim.id} is proved, and a witness is meant to refute it"


def test_the_ledger_says_proved() -> None:
    claim = next(claim for claim in CLAIMS if claim.id == "lemma-1.degradation")
    entry, = ledger([claim])
    assert entry.status == "proved"
    assert replace(entry, proved=False).status == "holds"


@pytest.mark.parametrize("engine", ENGINES)
def test_engines_answer(engine: str) -> None:
    if not installed(engine):
        pytest.skip(f"{engine} is not installed")
    script = "(set-logic QF_NRA)\n(declare-const x Real)\n(assert (< (* x x) {}))\n(check-sat)\n"
    with Engine(engine, 5) as running:
        assert running.answer(script.format("0.0")) == "unsat"
        assert running.answer(script.format("1.0")) == "sat"
        assert running.answer("(assert nonsense)").startswith("error")
