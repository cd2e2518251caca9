"""What is known of each claim, computed from the witnesses: nothing here is typed by hand.

Every claim is judged on every witness that comes with the package, in every construction it concerns, on meshes of the
first kind it names. It is "refuted" when it fails on one, or certificates that are re-checked now disprove it, else
"proved" when such certificates prove it for all inputs, of that construction or of all, "holds" when there were
instances and none failed, "open" when there were none.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Literal

from exactmesh.claims.claim import Claim
from exactmesh.claims.ledger import CLAIMS
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.errors import InputError
from exactmesh.io.read import read_pslg
from exactmesh.measure.verdict import Verdict
from exactmesh.planar.mesh import Kind
from exactmesh.proofs.registry import is_proved, is_proved_of_repaired, is_refuted

Known = Literal["proved", "holds", "refuted", "open"]


@dataclass(frozen=True, slots=True)
class Judged:
    """What is known of a claim in the runs of one construction; `witness` is the smallest input that refutes it."""

    construction: ConstructionName
    status: Known
    instances: int
    witness: str = ""
    verdict: Verdict | None = None


@dataclass(frozen=True, slots=True)
class Entry:
    """A claim with what is known of it, construction by construction."""

    claim: Claim
    judged: tuple[Judged, ...]
    proved: bool = False
    disproved: bool = False

    @property
    def status(self) -> Known:
        """The status of the sentence as the paper means it: of the published construction, where that is judged."""
        known = "refuted" if self.disproved else self.judged[0].status if self.judged else "open"
        return "proved" if self.proved and known != "refuted" else known

    @property
    def instances(self) -> int:
        """The number of instances met in all runs."""
        return sum(judged.instances for judged in self.judged)


def ledger(claims: Iterable[Claim] = CLAIMS, progress: Callable[[str], None] = lambda step: None) -> list[Entry]:
    """Return what is known of the given claims; `progress` is told the name of each witness."""
    runs: dict[tuple[str, ConstructionName, Kind], Run] = {}
    by_size = sorted(((len(pslg.vertices), name, pslg) for name in WITNESSES.names()
                      for pslg in [read_pslg(str(WITNESSES.path(name))).pslg]), key=lambda item: item[:2])

    def run_of(name: str, construction: ConstructionName, kind: Kind) -> Run:
        key = name, construction, kind
        if key not in runs:
            progress(f"{name} ({construction}, {kind})")
            pslg = next(pslg for _, other, pslg in by_size if other == name)
            runs[key] = Run(pslg, construction, kind)
        return runs[key]

    names = [name for _, name, _ in by_size]
    return [Entry(claim, tuple(_judged(claim, construction, names, run_of) for construction in claim.runs),
                  is_proved(claim.id), is_refuted(claim.id)) for claim in claims]


def _judged(claim: Claim, construction: ConstructionName, names: list[str],
            run_of: Callable[[str, ConstructionName, Kind], Run]) -> Judged:
    if claim.check is None:
        return Judged(construction, "open", 0)
    instances = 0
    refuted: tuple[str, Verdict] | None = None
    for name in names:
        try:
            verdict = claim.check(run_of(name, construction, claim.kinds[0]))
        except InputError:
            # The construction is not for this input (the paper's takes simple polygons only).
            continue
        instances += verdict.instances
        if not verdict.holds and refuted is None:
            refuted = name, verdict
    if refuted is not None:
        return Judged(construction, "refuted", instances, *refuted)
    if construction == "repaired" and is_proved_of_repaired(claim.id):
        return Judged(construction, "proved", instances)
    return Judged(construction, "holds" if instances else "open", instances)
