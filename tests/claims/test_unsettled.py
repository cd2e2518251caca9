"""Each claim that is neither proved nor refuted has one sentence that says why, and no other claim has."""

from exactmesh.claims.status import ledger
from exactmesh.claims.unsettled import UNSETTLED


def test_the_sentences_are_those_of_the_unsettled_claims() -> None:
    entries = ledger()
    assert {entry.claim.id for entry in entries if entry.status in ("open", "holds")} == set(UNSETTLED)
    assert all(20 < len(text) < 400 and not text.endswith(".") for text in UNSETTLED.values())


def test_what_is_disproved_without_an_input_is_refuted() -> None:
    (entry,) = (entry for entry in ledger() if entry.claim.id == "section-1.vertex-error")
    assert entry.status == "refuted" and entry.disproved and not entry.proved
