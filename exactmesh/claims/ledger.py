"""The ledger: all claims, in the order of the paper and then of the repaired construction."""

from collections.abc import Iterator

from exactmesh.claims.ahead import verdicts_ahead
from exactmesh.claims.claim import Claim, Judgement
from exactmesh.claims.coarse import COARSE_CLAIMS
from exactmesh.claims.elsewhere import ELSEWHERE_CLAIMS
from exactmesh.claims.repaired import REPAIRED_CLAIMS
from exactmesh.claims.result import RESULT_CLAIMS
from exactmesh.claims.run import Run
from exactmesh.claims.section_2_boundary import BOUNDARY_CLAIMS
from exactmesh.claims.section_2_mesh import MESH_CLAIMS
from exactmesh.collector import collector_paused
from exactmesh.errors import InputError

# The places in the order of the paper; an id begins with its place.
_PLACES = (
    "abstract", "section-1", "table-1", "lemma-1", "lemma-2", "lemma-3", "section-2", "tube", "phase-1", "phase-2",
    "phase-3", "phase-4", "theorem-1", "theorem-2", "theorem-3", "section-5", "appendix-a", "repaired")

CLAIMS: tuple[Claim, ...] = tuple(sorted(
    (*ELSEWHERE_CLAIMS, *BOUNDARY_CLAIMS, *MESH_CLAIMS, *RESULT_CLAIMS, *REPAIRED_CLAIMS),
    key=lambda claim: _PLACES.index(claim.id.partition(".")[0])))
# All that is judged on runs: also what is not claimed of all inputs.
JUDGED: tuple[Claim, ...] = (*CLAIMS, *COARSE_CLAIMS)


def claim_by_id(wanted: str) -> Claim:
    """Return the claim with the given id; raises `InputError` for an unknown one."""
    for claim in JUDGED:
        if claim.id == wanted:
            return claim
    near = ", ".join(claim.id for claim in CLAIMS if wanted.split(".")[0] in claim.id) or "see `exactmesh claims`"
    raise InputError(f"there is no claim {wanted!r}; {near}")


def judge_one(claim: Claim, run: Run) -> Judgement:
    """Return the verdict on one claim; raises `InputError` when it cannot be judged in runs of that construction."""
    if claim.check is None:
        raise InputError(f"{claim.id} is about more than one input: there is nothing to judge on a file")
    if not claim.concerns(run):
        raise InputError(f"{claim.id} is judged in runs of the construction {' or '.join(claim.runs)}, "
                         f"of {' or '.join(claim.kinds)} meshes")
    return Judgement(claim, claim.check(run))


def judge(run: Run) -> Iterator[Judgement]:
    """Yield the verdict on each claim of the run's construction in turn; `run.progress` is told its id beforehand."""
    ahead = verdicts_ahead(run, run.jobs)
    for claim in JUDGED:
        if claim.check is not None and claim.concerns(run):
            run.progress(claim.id)
            with collector_paused():
                verdict = ahead[claim.id] if claim.id in ahead else claim.check(run)
            yield Judgement(claim, verdict)
