"""The second implementation agrees with the claims' checkers, and would notice when it did not."""

import random
from dataclasses import replace
from fractions import Fraction

import pytest

from exactmesh.claims.run import ConstructionName, Run
from exactmesh.numbers.root import exact_text
from exactmesh.planar.mesh import Kind
from exactmesh.search import second
from exactmesh.search.families import family_of, planar_sample
from exactmesh.search.figure import Figure
from exactmesh.search.recheck import _ON_MESH, _made
from exactmesh.search.second import Between, Made, agree, evaluate, mfs_squared, second_value
from exactmesh.search.targets import target_of

HALF = Fraction(1, 2)


def sample(name: str, seed: int) -> Figure:
    figure = planar_sample(family_of(name, {}), random.Random(seed))
    assert figure is not None
    return figure


FIGURES = {f"{name} {seed}": sample(name, seed) for name, seed in (
    ("triangle", 1), ("tour", 2), ("stretched", 3), ("orthogonal", 4), ("near-degenerate", 5), ("segments", 0))}


@pytest.mark.parametrize(("construction", "kind"), [("paper", "nonproper"), ("repaired", "nonproper"),
                                                    ("repaired", "proper")])
def test_both_roads_lead_to_the_same_values(construction: ConstructionName, kind: Kind) -> None:
    claims = [claim for claim in second._ROADS
              if construction in target_of(claim).claim.runs and kind in target_of(claim).claim.kinds]
    met = set()
    for figure in FIGURES.values():
        run = Run(figure.pslg(), construction, kind)
        records: dict[bool, Made] = {}
        for claim in claims:
            target = target_of(claim, construction, kind)
            evaluation = target.judge(run)
            if evaluation.value is not None:
                on_mesh = claim in _ON_MESH
                if on_mesh not in records:
                    records[on_mesh] = _made(figure, run, target)
                value = second_value(claim, records[on_mesh])
                assert value is not None and agree(value, exact_text(evaluation.value)), claim
                met.add(claim)
    assert met == set(claims)


def test_a_harmed_record_of_p4_is_refused() -> None:
    target = target_of("section-2.p4-feature-size", "paper")
    figure = FIGURES["tour 2"]
    made = _made(figure, Run(figure.pslg(), "paper"), target)
    value = second_value("section-2.p4-feature-size", made)
    assert value is not None
    (x, y), *rest = made.p4
    for harmed, says in (([(x, y + made.spacing), *rest], "nearest"), ([(x, y + HALF * made.spacing), *rest], "grid"),
                         ([(x + made.spacing, y), *rest], "sideways"), (rest, "vertices")):
        with pytest.raises(ValueError, match=says):
            second_value("section-2.p4-feature-size", replace(made, p4=harmed))


def test_values_with_roots_agree_within_their_enclosures_only() -> None:
    stated = "3/8 - sqrt(5)/8"
    value = evaluate(stated)
    assert value.low < value.high and agree(value, stated)
    assert not agree(value, "3/8 - sqrt(5)/8 + 1/10**40".replace("10**40", str(10**40)))
    assert not agree(Between(value.low - HALF, value.high), stated)  # too wide to say anything
    assert agree(Fraction(3, 4), "3/4") and not agree(Fraction(3, 4), "1/4*2")
    for wrong in ("x", "2.5", "sqrt", "2**3", "f(2)"):
        with pytest.raises(ValueError, match="not an exact expression"):
            evaluate(wrong)


def test_the_plain_definition() -> None:
    corners = [(Fraction(x), Fraction(y)) for x, y in ((0, 0), (4, 0), (0, 3))]
    assert mfs_squared(corners, [(0, 1), (1, 2), (2, 0)]) == Fraction(144, 25)
    assert mfs_squared([*corners, (Fraction(1), HALF)], [(0, 1), (1, 2), (2, 0)]) == Fraction(1, 4)
    with pytest.raises(ValueError, match="one vertex only"):
        mfs_squared(corners[:1], [])
    # The middle of a segment, and beyond its ends.
    assert second.from_segment((HALF, HALF), corners[0], corners[1]) == Fraction(1, 4)
    assert second.from_segment((Fraction(7), Fraction(4)), corners[0], corners[1]) == 25
