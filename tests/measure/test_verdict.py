"""Verdicts, and the tally that makes them."""

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.measure.verdict import Relation, Tally, Verdict, Witness, failed, satisfies

RELATIONS: tuple[Relation, ...] = (">=", ">", "<=", "<", "==")
values = st.integers(-3, 3).map(lambda k: mpq(k, 2))


@pytest.mark.parametrize("verdict", [Verdict(3, True), Verdict(3, False), Verdict(0, True, mpq(1))])
def test_a_verdict_is_no_truth_value(verdict: Verdict) -> None:
    with pytest.raises(TypeError, match=r"^a Verdict is not a truth value: ask verdict\.holds$"):
        bool(verdict)


@pytest.mark.parametrize(("relation", "below", "at", "above"), [
    (">=", False, True, True), (">", False, False, True), ("<=", True, True, False), ("<", True, False, False),
    ("==", False, True, False)])
def test_a_relation_is_exact(relation: Relation, below: bool, at: bool, above: bool) -> None:
    tiny = mpq(1, 10**40)
    bound = mpq(1, 3)
    assert [satisfies(bound + step, relation, bound) for step in (-tiny, 0, tiny)] == [below, at, above]
    assert all(type(satisfies(bound, r, bound)) is bool for r in RELATIONS)


@pytest.mark.parametrize("relation", RELATIONS)
def test_a_claim_without_instances_holds(relation: Relation) -> None:
    assert Tally("clause", relation, mpq(1)).verdict() == Verdict(0, True, None, None)


@settings(max_examples=300, deadline=None, derandomize=True)
@given(st.lists(values, min_size=1, max_size=8), values, st.sampled_from(RELATIONS))
def test_a_tally_holds_when_every_value_does_and_keeps_the_first_worst_one(
        seen: list[mpq], bound: mpq, relation: Relation) -> None:
    tally = Tally("clause", relation, bound)
    for number, value in enumerate(seen):
        tally.see(value, number=number)
    verdict = tally.verdict()
    assert verdict.instances == len(seen)
    assert verdict.holds is all(satisfies(value, relation, bound) for value in seen)
    worst = {">": min(seen), "<": max(seen), "=": max(seen, key=lambda value: abs(value - bound))}[relation[0]]
    assert verdict.worst == worst
    assert verdict.witness == Witness("clause", {"number": seen.index(worst)})


def test_a_failure_names_its_clause_and_place_and_has_no_worst_value() -> None:
    verdict = failed(7, "the edge goes on", edge=[3, 4])
    assert (verdict.instances, verdict.holds, verdict.worst) == (7, False, None)
    assert verdict.witness == Witness("the edge goes on", {"edge": [3, 4]})
