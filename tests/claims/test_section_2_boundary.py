"""The claims of Section 2's boundary and of Appendix A: each witness refutes what it is for, all else holds."""

from importlib.resources import as_file, files

import families
import pytest
from gmpy2 import mpq

from exactmesh.api import read
from exactmesh.claims.claim import Claim
from exactmesh.claims.run import Run
from exactmesh.claims.section_2_boundary import BOUNDARY_CLAIMS
from exactmesh.numbers.algebraic import sqrt
from exactmesh.paper import PaperOptions
from exactmesh.steps.reading import sin_eighth

CLAIMS = {claim.id: claim for claim in BOUNDARY_CLAIMS}
REFUTED = {claim.id for claim in BOUNDARY_CLAIMS if claim.witness}
SMALL = {name: pslg for name, pslg in families.issue_list().items() if len(pslg.vertices) <= 60}
INPUTS = sorted(SMALL)[::3]


def judged(claim_id: str, run: Run):
    check = CLAIMS[claim_id].check
    assert check is not None
    return check(run)


def witness(name: str) -> Run:
    with as_file(files("exactmesh.claims.witnesses") / f"{name}.json") as path:
        return Run(read(str(path)), "paper")


# The exact worst value on the witness; squares of lengths in units of the mfs.
WORST = {
    # (sqrt(901) - 15)/52, a hair above sqrt(3)/6.
    "appendix-a.offset-edge-length": ((sqrt(901) - 15) / 52) ** 2,
    "appendix-a.no-part-meets-quarter-circle": mpq(44849809, 46785600),
    "appendix-a.next-edge-misses-quarter-circle": mpq(0),
    "appendix-a.both-angles-acute": mpq(59, 90) ** 2,
    "appendix-a.sine": mpq(1, 4),
    "section-2.p3-octagon-reason": sin_eighth() ** 2 / 4,
    "section-2.p3-through-interior": mpq(71, 240) ** 2,
    "section-2.p3-separation": mpq(14, 53) ** 2,
    "section-2.p5-feature-size": mpq(11480255728406054576057, 317778581128412621709241),
    "section-2.p5-above-grid": mpq(208474364630342110806016, 317778581128412621709241),
}


def test_ids_are_unique_and_every_claim_says_what_it_needs():
    assert len(CLAIMS) == len(BOUNDARY_CLAIMS)
    for claim in BOUNDARY_CLAIMS:
        assert isinstance(claim, Claim) and claim.runs == ("paper",) and claim.says and claim.paper
        assert bool(claim.witness) == bool(claim.corrected) == bool(claim.repair)
        assert claim.bound or claim.quantity == "truth"
    assert set(WORST) == REFUTED


@pytest.mark.parametrize("claim_id", sorted(REFUTED))
def test_the_witness_refutes_its_claim(claim_id):
    verdict = judged(claim_id, witness(CLAIMS[claim_id].witness))
    assert not verdict.holds and verdict.worst == WORST[claim_id]


@pytest.mark.parametrize("name", sorted({CLAIMS[claim_id].witness for claim_id in REFUTED}))
def test_a_witness_refutes_nothing_that_is_true(name):
    run = witness(name)
    for claim_id in CLAIMS.keys() - REFUTED:
        verdict = judged(claim_id, run)
        assert verdict.holds, (claim_id, verdict)


@pytest.mark.parametrize("name", INPUTS)
def test_all_other_claims_hold(name):
    run = Run(SMALL[name], "paper")
    for claim_id in CLAIMS.keys() - REFUTED:
        verdict = judged(claim_id, run)
        assert verdict.holds, (claim_id, verdict)


@pytest.mark.parametrize("name", sorted(SMALL)[1::12])
@pytest.mark.parametrize("options", [
    PaperOptions(reading="tube"), PaperOptions(right_angle="prolonged"), PaperOptions(ties="down")], ids=str)
def test_all_other_claims_hold_under_every_option(name, options):
    run = Run(SMALL[name], "paper", options=options)
    for claim_id in CLAIMS.keys() - REFUTED:
        verdict = judged(claim_id, run)
        assert verdict.holds, (claim_id, verdict)


# Of these the corrected statement is the same bound for polygons with at least four vertices.
FALSE_FOR_TRIANGLES = ["appendix-a.offset-edge-length", "appendix-a.next-edge-misses-quarter-circle",
                       "section-2.p3-separation"]


@pytest.mark.parametrize("name", [name for name in INPUTS if len(SMALL[name].vertices) > 3])
def test_what_is_false_of_triangles_holds_with_four_vertices(name):
    run = Run(SMALL[name], "paper")
    for claim_id in FALSE_FOR_TRIANGLES:
        assert judged(claim_id, run).holds, claim_id
    kept = judged("section-2.p3-through-interior", run)
    assert kept.worst is None or kept.worst >= (1 - sqrt(2) / 2) ** 2
    acute = judged("appendix-a.both-angles-acute", run)
    assert acute.worst is None or acute.worst >= mpq(1, 4)
    one_reflex = judged("appendix-a.one-end-reflex", run)
    assert one_reflex.worst is None or one_reflex.worst >= mpq(1, 2)


@pytest.mark.parametrize("name", ["triangle-13-14-15", "triangle-51-52-53", "triangle-near-equilateral"])
def test_triangles_keep_what_the_correction_says(name):
    run = witness(name)
    assert judged("appendix-a.offset-edge-length", run).worst > mpq(1, 12)
    assert judged("section-2.p3-separation", run).worst > mpq(1, 16)
    assert judged("section-2.p3-feature-size", run).holds


def test_appendix_a_needs_the_curve_only():
    run = witness("triangle-13-14-15")
    assert not judged("appendix-a.offset-edge-length", run).holds
    assert judged("appendix-a.offset-edge-length", run).worst == mpq(39, 112) ** 2
    assert "paper" not in vars(run)


def test_every_true_claim_meets_an_instance_somewhere():
    names = ["l-shape-4", "facing-wedges", "rhombus-5", "trapezoid-two-acute"]
    runs = [witness(name) for name in names] + [Run(families.reflex_notch(), "paper"),
                                                Run(families.rectangular_spiral(1), "paper")]
    for claim_id in CLAIMS.keys() - REFUTED:
        assert sum(judged(claim_id, run).instances for run in runs), claim_id
