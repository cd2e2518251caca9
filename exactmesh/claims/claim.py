"""What a claim is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from exactmesh.claims.run import ConstructionName, Run
from exactmesh.measure.verdict import Verdict
from exactmesh.planar.mesh import Kind

# What the checker's values are: squares of lengths or of ratios, plain numbers, or nothing but yes and no.
Quantity = Literal["square", "number", "truth"]


@dataclass(frozen=True, slots=True)
class Claim:
    """A statement with a permanent id; a withdrawn id is never used again.

    `paper` is the place it is from, or the name of the repaired construction. `bound` is for readers; the checker
    decides. `runs` names the constructions, `kinds` the kinds of mesh in whose runs it is judged. A claim without a
    checker is one that no single input can settle. `corrected` is the true statement in place of a false one, `repair`
    how the repaired construction does without it, `witness` the file, among the package's witnesses, that is meant to
    refute it.
    """

    id: str
    paper: str
    says: str
    given: tuple[str, ...] = ()
    bound: str = ""
    quantity: Quantity = "truth"
    runs: tuple[ConstructionName, ...] = ("paper",)
    check: Callable[[Run], Verdict] | None = None
    corrected: str = ""
    repair: str = ""
    witness: str = ""
    kinds: tuple[Kind, ...] = ("nonproper", "proper")

    def concerns(self, run: Run) -> bool:
        """Return whether the claim can be judged in this run."""
        return self.check is not None and run.construction in self.runs and run.kind in self.kinds


@dataclass(frozen=True, slots=True)
class Judgement:
    """A claim and the verdict on it."""

    claim: Claim
    verdict: Verdict
