"""What one task saw: counts, the worst value of each target with its polygon, and polygons worth keeping."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from exactmesh.claims.run import Run
from exactmesh.numbers.root import exact_text
from exactmesh.planar.pslg import Pslg
from exactmesh.search.corners import Corners, pslg_of
from exactmesh.search.shrink import shrink
from exactmesh.search.targets import Evaluation, Target

Json = dict[str, object]
# Of each target and task, this many violations are shrunk and kept: the first ones and the worst.
_KEPT = 2
_SKIPPED = Evaluation("skipped")


@dataclass(slots=True)
class Tallied:
    """One target's counts; `worst` is None until there is something to judge."""

    target: Target
    judged: int = 0
    skipped: int = 0
    instances: int = 0
    violations: int = 0
    crashes: int = 0
    worst: Evaluation | None = None
    worst_input: Pslg | None = None
    worst_corners: Corners | None = None
    found: list[Corners] = field(default_factory=list)
    crashed: list[tuple[Corners, str]] = field(default_factory=list)

    def see(self, evaluation: Evaluation, pslg: Pslg, corners: Corners | None) -> None:
        """Count one evaluation."""
        if evaluation.outcome == "skipped":
            self.skipped += 1
            return
        self.judged += 1
        self.instances += evaluation.instances
        if evaluation.outcome == "crash":
            self.crashes += 1
            if corners is not None and not self.crashed:
                self.crashed.append((corners, evaluation.shown))
            return
        if self.worst is None or evaluation.is_worse_than(self.worst):
            self.worst, self.worst_input, self.worst_corners = evaluation, pslg, corners
        if evaluation.outcome == "violated":
            self.violations += 1
            if corners is not None and len(self.found) < _KEPT - 1:
                self.found.append(corners)


class Collector:
    """Judges polygons and keeps what a task has to report."""

    def __init__(self, targets: Sequence[Target]) -> None:
        self.evaluated = 0
        self.tallies = [Tallied(target) for target in targets]

    def see(self, corners: Corners) -> Evaluation:
        """Judge a polygon; return the evaluation of the first target."""
        return self.see_input(pslg_of(corners), corners)

    def see_input(self, pslg: Pslg, corners: Corners | None = None) -> Evaluation:
        """Judge any input; targets of one construction and kind share its run."""
        self.evaluated += 1
        runs: dict[tuple[str, str], Run] = {}
        first = None
        for tally in self.tallies:
            target = tally.target
            run = runs.setdefault((target.construction, target.kind), Run(pslg, target.construction, target.kind))
            evaluation = target.judge(run)
            tally.see(evaluation, pslg, corners)
            first = first or evaluation
        return first or _SKIPPED

    def result(self, key: str, shrinks: bool) -> Json:
        """Return the report of the task: the same for the same task, wherever it ran."""
        return {"task": key, "evaluated": self.evaluated,
                "targets": [_tally_json(tally) for tally in self.tallies],
                "finds": [find for tally in self.tallies for find in _finds(tally, shrinks)]}


def find_json(target: Target, corners: Corners, label: str) -> Json:
    """Return a polygon with its evaluation as it is stored."""
    evaluation = target.evaluate(pslg_of(corners))
    return {"target": list(target.key), "label": label, "corners": [list(corner) for corner in corners],
            **evaluation_json(evaluation)}


def evaluation_json(evaluation: Evaluation | None) -> Json:
    """Return an evaluation with exact numbers as text."""
    if evaluation is None:
        return {"outcome": "", "exact": "", "low": "", "direction": 0, "shown": "{}"}
    return {"outcome": evaluation.outcome, "exact": "" if evaluation.value is None else exact_text(evaluation.value),
            "low": "" if evaluation.low is None else str(evaluation.low), "direction": evaluation.direction,
            "shown": evaluation.shown or "{}"}


def _tally_json(tally: Tallied) -> Json:
    pslg = tally.worst_input
    return {"target": list(tally.target.key), "judged": tally.judged, "skipped": tally.skipped,
            "instances": tally.instances, "violations": tally.violations, "crashes": tally.crashes,
            **evaluation_json(tally.worst), "input": "" if pslg is None else pslg.name,
            "corners": None if tally.worst_corners is None else [list(corner) for corner in tally.worst_corners]}


def _finds(tally: Tallied, shrinks: bool) -> list[Json]:
    """Return violations, shrunk, and crashes, each once."""
    target = tally.target
    polygons = list(tally.found)
    if tally.worst is not None and tally.worst.outcome == "violated" and tally.worst_corners is not None:
        polygons.append(tally.worst_corners)
    if shrinks:
        polygons = [shrink(polygon, lambda p: target.evaluate(pslg_of(p)).outcome == "violated")
                    for polygon in dict.fromkeys(polygons)]
    finds = [find_json(target, polygon, "violation") for polygon in dict.fromkeys(polygons)]
    return finds + [find_json(target, polygon, "crash") for polygon, _ in tally.crashed]
