"""The claims judged on runs of the coarse construction: those of the repaired one, with the bounds of its balance.

They are no part of the ledger: none is proved, and nothing is claimed of inputs that were not run.
"""

from collections.abc import Callable
from dataclasses import replace

from gmpy2 import mpq

from exactmesh.claims.claim import Claim
from exactmesh.claims.repaired import REPAIRED_CLAIMS
from exactmesh.claims.run import Run
from exactmesh.measure.verdict import Verdict
from exactmesh.steps.balance import (
    COARSE,
    COARSE_DEGRADATION,
    COARSE_EDGE_GAP,
    COARSE_GAP,
    COARSE_LEVEL_EDGE,
    COARSE_SEPARATION,
    COARSE_THICKNESS_MAX,
)
from exactmesh.steps.offset_check import check_nesting

# The relation and the bound in place of the repaired construction's; what is not here has no bound of its own.
_BOUNDS: dict[str, tuple[str, mpq]] = {
    "offset-thickness": (">=", COARSE.crown * COARSE.level),
    "offset-reach": ("<=", COARSE_THICKNESS_MAX),
    "offset-separation": (">=", COARSE_SEPARATION),
    "chord-gap": (">=", COARSE_GAP),
    "level-edge": (">=", COARSE_LEVEL_EDGE),
    "chord-leg": (">=", COARSE_SEPARATION),
    "chord-clearance": (">=", COARSE.level),
    "edge-gap": (">=", COARSE_EDGE_GAP),
    "interior-feature": (">=", COARSE.feature),
    "tube-feature": (">=", COARSE.feature),
    "degradation": ("<=", COARSE_DEGRADATION),
}
_SAME = ("unit", "trapezoidation", "chord-touch", "interior-tiling", "tube-tiling", "steiner-count")


def _nesting(run: Run) -> Verdict:
    return check_nesting(run.repaired.shape, run.repaired.offset, run.columns, COARSE.level)


def _with_bound(claim: Claim, relation: str, bound: mpq) -> Callable[[Run], Verdict]:
    """Return the claim's check with another bound: the worst value is that of its checker."""
    least = bound if claim.quantity == "number" else bound**2
    unit = "" if claim.id == "repaired.degradation" else " mfs"

    def check(run: Run) -> Verdict:
        verdict = Verdict(0, True) if claim.check is None else claim.check(run)
        if verdict.worst is None or verdict.witness is None:
            return verdict
        holds = verdict.worst >= least if relation == ">=" else verdict.worst <= least
        return replace(verdict, holds=bool(holds),
                       witness=replace(verdict.witness, clause=f"{claim.says}: {relation} {bound}{unit}"))

    return check


def _coarse(claim: Claim) -> Claim | None:
    """Return the claim as it is judged on runs of the coarse construction; None where it is not."""
    name = claim.id.removeprefix("repaired.")
    check, bound = claim.check, claim.bound
    if name in _BOUNDS:
        relation, value = _BOUNDS[name]
        check, bound = _with_bound(claim, relation, value), f"{relation} {value}{' mfs' if 'mfs' in bound else ''}"
    elif name == "offset-nesting":
        check = _nesting
    elif name not in _SAME:
        return None
    return replace(claim, id=f"coarse.{name}", paper="coarse construction", bound=bound, check=check,
                   runs=("coarse",), kinds=("nonproper",))


COARSE_CLAIMS: tuple[Claim, ...] = tuple(found for claim in REPAIRED_CLAIMS if (found := _coarse(claim)) is not None)
