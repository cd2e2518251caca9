"""Short runs of the differential campaigns, and that they see what they should."""

import math
import random
from fractions import Fraction
from itertools import pairwise

import campaign_mfs
import campaign_verify
import pytest
from campaign_mfs import KINDS, TOLERANCE, Drawing, by_geos, compared, root_above
from hypothesis import given
from hypothesis import strategies as st
from test_validity import Case


def test_geos_agrees_within_the_proven_tolerance() -> None:
    outliers, table = campaign_mfs.run(1, 330)
    assert not outliers, outliers[0]
    assert table.count("\n") == len(KINDS) + 2


def test_clearances_that_are_off_are_seen() -> None:
    square = Drawing((((0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)),), True)
    step = 4 * 2**0.5 * float(TOLERANCE)
    assert compared(square, 4.0, True).is_within and compared(square, 4 + 0.9 * step).is_within
    for wrong in (4 + 1.1 * step, 4 - 1.1 * step, 0.0, math.inf, 3.999):
        assert not compared(square, wrong).is_within
    lonely = Drawing((((1.0, 2.0),),))
    assert compared(lonely, math.inf, True).is_within and not compared(lonely, 1.0).is_within
    outliers, table = campaign_mfs.run(1, 22, lambda drawing: by_geos(drawing) * (1 + 1e-9) + 1e-300)
    assert len(outliers) > 8 and f"{len(outliers)} outliers" in table


@pytest.mark.parametrize("kind", KINDS)
def test_inputs_are_what_the_proof_is_about(kind: str) -> None:
    # Products of differences neither overflow nor underflow.
    for seed in range(30):
        places = {place for chain in KINDS[kind](random.Random(seed)).chains for place in chain}
        for axis in (0, 1):
            values = sorted({Fraction(place[axis]) for place in places})
            steps = [b - a for a, b in pairwise(values)]
            assert not steps or (min(steps) > Fraction(1, 2**240) and values[-1] - values[0] < 2**240)


@given(st.fractions(min_value=0))
def test_root_above(value: Fraction) -> None:
    root = root_above(value)
    assert root * root > value
    assert (root * (1 - Fraction(1, 2**58))) ** 2 <= value or value < Fraction(1, 2**100)


def test_verify_agrees_with_brute_force() -> None:
    found, table = campaign_verify.run(1, 120)
    assert not found, found[0]
    assert " valid, 0 disagreements" in table


def test_disagreements_are_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    honest = Case.verify
    # A verifier that accepts whatever it is given.
    monkeypatch.setattr(Case, "verify", lambda case: campaign_verify.STARTS[0].verify() if honest(
        case).violations else honest(case))
    found, _ = campaign_verify.run(1, 40)
    assert len(found) > 5
