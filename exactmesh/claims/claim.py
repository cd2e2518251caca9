"""What a claim is, and what it is judged on."""

from collections.abc import Callable
from dataclasses import dataclass

from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import Verification
from exactmesh.measure.verdict import Verdict
from exactmesh.planar.faces import Subdivision
from exactmesh.repaired import Construction


@dataclass(frozen=True, slots=True)
class Run:
    """One input with the result of every step and the verification of the mesh."""

    subdivision: Subdivision
    mfs: Nearest
    construction: Construction
    verification: Verification


@dataclass(frozen=True, slots=True)
class Claim:
    """A statement with a permanent id; a withdrawn id is never used again.

    `paper` is the place it is from, or the name of the repaired construction. `bound` is for readers; the checker
    decides. `squared` tells that the checker's values are squares of what `bound` speaks of.
    """

    id: str
    paper: str
    says: str
    given: tuple[str, ...]
    bound: str
    squared: bool
    check: Callable[[Run], Verdict]


@dataclass(frozen=True, slots=True)
class Judgement:
    """A claim and the verdict on it."""

    claim: Claim
    verdict: Verdict
