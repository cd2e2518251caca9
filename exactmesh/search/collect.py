"""What one task saw: counts, the worst value of each target with its figure, and figures worth keeping."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from exactmesh.claims.run import Run
from exactmesh.numbers.root import exact_text
from exactmesh.planar.pslg import Pslg
from exactmesh.search.figure import Figure
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
    worst_figure: Figure | None = None
    found: list[Figure] = field(default_factory=list)
    crashed: list[Figure] = field(default_factory=list)

    def see(self, evaluation: Evaluation, pslg: Pslg, figure: Figure | None) -> None:
        """Count one evaluation."""
        if evaluation.outcome == "skipped":
            self.skipped += 1
            return
        self.judged += 1
        self.instances += evaluation.instances
        if evaluation.outcome == "crash":
            self.crashes += 1
            if figure is not None and not self.crashed:
                self.crashed.append(figure)
            return
        if self.worst is None or evaluation.is_worse_than(self.worst):
            self.worst, self.worst_input, self.worst_figure = evaluation, pslg, figure
        if evaluation.outcome == "violated":
            self.violations += 1
            if figure is not None and len(self.found) < _KEPT - 1:
                self.found.append(figure)


class Collector:
    """Judges polygons and keeps what a task has to report."""

    def __init__(self, targets: Sequence[Target]) -> None:
        self.evaluated = 0
        self.tallies = [Tallied(target) for target in targets]

    def see(self, figure: Figure) -> Evaluation:
        """Judge a figure; return the evaluation of the first target."""
        return self.see_input(figure.pslg(), figure)

    def see_input(self, pslg: Pslg, figure: Figure | None) -> Evaluation:
        """Judge any input, which is kept when it is worth it as `figure`, if given; targets of one construction and
        kind share its run."""
        self.evaluated += 1
        runs: dict[tuple[str, str], Run] = {}
        first = None
        for tally in self.tallies:
            target = tally.target
            run = runs.setdefault((target.construction, target.kind), Run(pslg, target.construction, target.kind))
            evaluation = target.judge(run)
            tally.see(evaluation, pslg, figure)
            first = first or evaluation
        return first or _SKIPPED

    def result(self, key: str, shrinks: bool, shows_figures: bool = True) -> Json:
        """Return the report of the task: the same for the same task, wherever it ran. Inputs that have a name of their
        own need not be shown as figures."""
        return {"task": key, "evaluated": self.evaluated,
                "targets": [_tally_json(tally, shows_figures) for tally in self.tallies],
                "finds": [find for tally in self.tallies for find in _finds(tally, shrinks)]}


def find_json(target: Target, figure: Figure, label: str) -> Json:
    """Return a figure with its evaluation as it is stored."""
    evaluation = target.evaluate(figure.pslg())
    return {"target": list(target.key), "label": label, "figure": figure.to_json(), **evaluation_json(evaluation)}


def evaluation_json(evaluation: Evaluation | None) -> Json:
    """Return an evaluation with exact numbers as text."""
    if evaluation is None:
        return {"outcome": "", "exact": "", "low": "", "direction": 0, "shown": "{}"}
    return {"outcome": evaluation.outcome, "exact": "" if evaluation.value is None else exact_text(evaluation.value),
            "low": "" if evaluation.low is None else str(evaluation.low), "direction": evaluation.direction,
            "shown": evaluation.shown}


def _tally_json(tally: Tallied, shows_figure: bool) -> Json:
    pslg, figure = tally.worst_input, tally.worst_figure if shows_figure else None
    return {"target": list(tally.target.key), "judged": tally.judged, "skipped": tally.skipped,
            "instances": tally.instances, "violations": tally.violations, "crashes": tally.crashes,
            **evaluation_json(tally.worst), "input": "" if pslg is None else pslg.name,
            "figure": None if figure is None else figure.to_json()}


def _finds(tally: Tallied, shrinks: bool) -> list[Json]:
    """Return violations, shrunk, and crashes, each once; without shrinking, the worst violation only."""
    target = tally.target
    figures = list(tally.found) if shrinks else []
    if tally.worst is not None and tally.worst.outcome == "violated" and tally.worst_figure is not None:
        figures.append(tally.worst_figure)
    figures = list(dict.fromkeys(figures))
    if shrinks:
        figures = [shrink(figure, lambda f: target.evaluate(f.pslg()).outcome == "violated", _budget(figure))
                   for figure in figures]
    finds = [find_json(target, figure, "violation") for figure in dict.fromkeys(figures)]
    return finds + [find_json(target, figure, "crash") for figure in tally.crashed]


def _budget(figure: Figure) -> int:
    """Return how often to try: large figures take long."""
    return max(40, min(300, 30000 // len(figure.points)))
