"""Theorems that rest on claims: these are claims of the ledger, there is no circle, and one that is open counts."""

from dataclasses import replace

import pytest

from exactmesh.claims.ledger import CLAIMS, claim_by_id
from exactmesh.claims.status import ledger
from exactmesh.proofs import registry
from exactmesh.proofs.problem import Group, group_from_json, json_from_group
from exactmesh.proofs.prove import prove, summaries
from exactmesh.proofs.registry import groups, is_proved, stands, theorems

RESTING = [theorem for theorem in theorems() if theorem.claims]
RESTS_ON = {theorem.claim: {claim for t in theorems() if t.claim == theorem.claim for claim in t.claims}
            for theorem in theorems()}


def test_theorems_rest_on_proved_claims_of_the_ledger() -> None:
    assert RESTING
    for theorem in RESTING:
        assert set(theorem.claims) <= {claim.id for claim in CLAIMS}
        assert all(is_proved(claim) for claim in theorem.claims) and stands(theorem)


def test_no_theorem_rests_on_itself() -> None:
    for start in RESTS_ON:
        seen: set[str] = set()
        ahead = set(RESTS_ON[start])
        while ahead:
            claim = ahead.pop()
            assert claim != start
            seen.add(claim)
            ahead |= RESTS_ON.get(claim, set()) - seen


def test_what_rests_on_an_open_claim_does_not_stand(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = next(theorem for theorem in RESTING if theorem.claim == "abstract.nonproper")
    theorem = replace(whole, claims=("section-1.linear-time",))
    assert not stands(theorem)
    assert group_from_json(json_from_group(Group("g", (theorem,)))) == Group("g", (theorem,))
    group = next(group for group in groups() if whole in group.theorems)
    changed = replace(group, theorems=(theorem,))
    monkeypatch.setattr(registry, "groups", lambda: (changed,))
    monkeypatch.setattr("exactmesh.proofs.prove.groups", lambda: (changed,))
    found, = summaries(list(prove(theorem.problems, fast=True)))
    assert not found.stands


def test_the_bounds_of_theorem_1_are_proved_of_the_repaired_construction_only() -> None:
    for name in ("theorem-1.degradation", "theorem-1.feature-size"):
        entry, = ledger([claim_by_id(name)])
        assert entry.status == "refuted" and not entry.proved
        assert [(judged.construction, judged.status) for judged in entry.judged] == [
            ("paper", "refuted"), ("repaired", "proved")]
