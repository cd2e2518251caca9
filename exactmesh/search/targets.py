"""What a search wants to break or to push: a claim of the ledger, or an objective without a bound.

An `Evaluation` is exact. `low` encloses the value from below within 2^-200 of itself: it orders what different
processes found and is no score; whether a claim fails is decided by its checker alone.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from gmpy2 import mpq

from exactmesh.claims.claim import Claim
from exactmesh.claims.ledger import claim_by_id
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.measure.verdict import Verdict, Witness
from exactmesh.numbers.algebraic import Real
from exactmesh.planar.mesh import Kind
from exactmesh.planar.pslg import Pslg
from exactmesh.report import claim_json

Outcome = Literal["holds", "violated", "crash", "skipped"]
_BITS = 200


@dataclass(frozen=True, slots=True)
class Evaluation:
    """`value` is the worst exact value met; None without one. `direction` is 1 when greater is worse, -1 when less.
    `error` says what went wrong in a crash."""

    outcome: Outcome
    value: mpq | Real | None = None
    direction: int = 0
    instances: int = 0
    claim: Claim | None = None
    verdict: Verdict | None = None
    error: str = ""

    def is_worse_than(self, other: "Evaluation") -> bool:
        """Return whether this is the worse of two evaluations, exactly; a violation is worse than none."""
        if (self.outcome == "violated") != (other.outcome == "violated"):
            return self.outcome == "violated"
        if self.value is None or other.value is None or not self.direction:
            return self.value is not None and other.value is None
        return bool(self.value > other.value if self.direction > 0 else self.value < other.value)

    @property
    def low(self) -> mpq | None:
        """The rational that stands for the value in orders."""
        return self.value.enclosure(_BITS)[0] if isinstance(self.value, Real) else self.value

    @property
    def shown(self) -> str:
        """The claim with its verdict, or the error, as JSON text; costly, and wanted of few."""
        if self.claim is None or self.verdict is None:
            return json.dumps({"error": self.error} if self.error else {})
        return json.dumps(claim_json(self.claim, self.verdict), default=str)

    @property
    def rough(self) -> float:
        """A float, greater for worse: for guidance only."""
        low = self.low
        return 0.0 if low is None else float(low) * (self.direction or 1)


@dataclass(frozen=True, slots=True)
class Target:
    """A claim, or an objective dressed as one, judged on meshes of one kind by one construction."""

    claim: Claim
    construction: ConstructionName
    kind: Kind

    @property
    def key(self) -> tuple[str, str, str]:
        """What names it in stores."""
        return self.claim.id, self.construction, self.kind

    @property
    def direction(self) -> int:
        """1 when a greater value is worse, -1 when a lesser one is, 0 when neither is known."""
        first = next((sign for sign in self.claim.bound if sign in "<>"), "")
        return {"<": 1, ">": -1}.get(first, 0)

    def evaluate(self, pslg: Pslg) -> Evaluation:
        """Return the exact evaluation on one input; never raises."""
        return self.judge(Run(pslg, self.construction, self.kind))

    def judge(self, run: Run) -> Evaluation:
        """Return the exact evaluation of a run, which may be shared by several targets; never raises."""
        check = self.claim.check
        try:
            if check is None:
                raise InputError("no single input settles this claim")
            verdict = check(run)
        except InputError:
            return Evaluation("skipped")
        except ConstructionFailed as error:
            verdict = Verdict(1, False, None, Witness("the construction fails", {"step": error.step}))
            return Evaluation("violated", None, self.direction, 1, self.claim, verdict)
        except Exception as error:  # a fault of the program: kept, so that it can be mended, never a counterexample
            return Evaluation("crash", error=f"{type(error).__name__}: {error}"[:500])
        outcome: Outcome = "holds" if verdict.holds else "violated"
        return Evaluation(outcome, verdict.worst, self.direction, verdict.instances, self.claim, verdict)


def _degradation(run: Run) -> Verdict:
    squared = run.verification.degradation_squared
    if squared is None:
        raise InputError("the mesh is not valid: there are claims on that")
    return Verdict(1, True, squared)


def _steiner(run: Run) -> Verdict:
    return Verdict(1, True, mpq(run.verification.steiner, len(run.pslg.vertices)))


def _offset_edge(run: Run) -> Verdict:
    check = claim_by_id("appendix-a.offset-edge-length").check
    verdict = Verdict(0, True) if check is None else check(run)
    return Verdict(verdict.instances, True, verdict.worst, verdict.witness)


def _objective(name: str, says: str, bound: str, check: Callable[[Run], Verdict], kind: Kind = "nonproper",
               runs: tuple[ConstructionName, ...] = ("repaired", "paper", "coarse"), number: bool = False) -> Claim:
    return Claim(name, "objective", says, bound=bound, quantity="number" if number else "square", runs=runs,
                 check=check, kinds=(kind, "proper"))


OBJECTIVES: dict[str, Claim] = {claim.id: claim for claim in (
    _objective("degradation", "the greatest degradation", "< any number", _degradation),
    _objective("proper-degradation", "the greatest degradation of a proper mesh", "< any number", _degradation,
               "proper"),
    _objective("offset-edge-length", "the shortest edge of the offset curve, in units of the mfs", "> 0", _offset_edge,
               runs=("paper",)),
    _objective("steiner-per-vertex", "the most Steiner vertices a vertex", "< any number", _steiner, number=True))}


def target_of(name: str, construction: str | None = None, kind: str | None = None) -> Target:
    """Return a target by its claim or objective; the first construction and kind of the claim where none is given.

    Raises `InputError` when there is no such claim, it has no checker, or is not judged in such runs.
    """
    claim = OBJECTIVES.get(name) or claim_by_id(name)
    if claim.check is None:
        raise InputError(f"{claim.id} is about more than one input: no search can settle it")
    chosen = next((run for run in claim.runs if run == construction), None if construction else claim.runs[0])
    sort = next((one for one in claim.kinds if one == kind), None if kind else claim.kinds[0])
    if chosen is None or sort is None:
        raise InputError(f"{claim.id} is judged in runs of the construction {' or '.join(claim.runs)}, "
                         f"of {' or '.join(claim.kinds)} meshes")
    Run(Pslg((), ()), chosen, sort)  # refuses kinds that the construction does not make
    return Target(claim, chosen, sort)
