"""Run a search: hand out what is not done, store what comes back, keep the worst figure of each target."""

import json
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

from gmpy2 import mpq

from exactmesh.search.collect import Json, find_json
from exactmesh.search.engine import Engine
from exactmesh.search.figure import Figure
from exactmesh.search.recheck import Answer, Checker
from exactmesh.search.shrink import shrink
from exactmesh.search.spec import Spec, Task
from exactmesh.search.store import Row, Store
from exactmesh.search.targets import Evaluation, Target, target_of

Key = tuple[str, str, str]
_RECORD_BUDGET = 150


@dataclass(slots=True)
class Sum:
    """What a run has to say of one target; `worst` is the stored row with the worst value, `confirmed` the number of
    violations with which the independent check agrees."""

    judged: int = 0
    skipped: int = 0
    instances: int = 0
    violations: int = 0
    crashes: int = 0
    confirmed: int = 0
    worst: Row | None = None


def run_tasks(store: Store, run: int, spec: Spec, tasks: Iterator[Task], engine: Engine, deadline: float | None,
              progress: Callable[[str], None], stop_at_first: bool = False) -> int:
    """Do the tasks that the store does not have; return how many inputs were judged now.

    Raises `KeyboardInterrupt` when interrupted; what is stored then is whole, and a later run goes on from there.
    """
    best = totals(store, run)
    count = 0
    start = time.monotonic()
    waiting = (task for task in tasks if not store.is_done(run, task.key))
    reports = engine.reports(spec.to_json(), waiting, deadline)
    try:
        with Checker() as checker:
            for report in reports:
                if report is not None:
                    count += _take(store, run, report, best, checker)
                progress(_line(count, time.monotonic() - start, best))
                if stop_at_first and any(total.violations for total in best.values()):
                    return count
    finally:
        close = getattr(reports, "close", None)
        if close is not None:
            close()
    return count


def totals(store: Store, run: int) -> dict[Key, Sum]:
    """Return the sums over all stored tasks of a run: the same in whatever order they were done."""
    found: dict[Key, Sum] = {}
    for row in store.results(run):
        add_row(found, row)
    return found


def add_row(found: dict[Key, Sum], row: Row) -> None:
    """Count one stored row."""
    total = found.setdefault((row["claim"], row["construction"], row["kind"]), Sum())
    for name in ("judged", "skipped", "instances", "violations", "crashes"):
        setattr(total, name, getattr(total, name) + row[name])
    if row["outcome"] and (total.worst is None or _is_worse(row, total.worst)):
        total.worst = row


def keep_records(store: Store, run: int) -> None:
    """Store the worst figure of each target, shrunk while it is no better, if it is one a search can move."""
    with Checker() as checker:
        for key, total in totals(store, run).items():
            if total.worst is None or not total.worst["direction"] or total.worst["figure"] == "null":
                continue
            target = target_of(*key)
            figure = Figure.from_json(json.loads(total.worst["figure"]))
            worst = target.evaluate(figure.pslg())
            if worst.value is None:
                continue

            def no_better(smaller: Figure, target: Target = target, worst: Evaluation = worst) -> bool:
                found = target.evaluate(smaller.pslg())
                return found.value is not None and not worst.is_worse_than(found)

            label = "violation" if worst.outcome == "violated" else "record"
            find = find_json(target, shrink(figure, no_better, _RECORD_BUDGET), label)
            confirm(store, run, total.worst["task"], find, checker)


def confirm(store: Store, run: int, task: str, find: Json, checker: Checker) -> None:
    """Store a find that is new, with the word of the independent check."""
    if not store.has_find(find):
        answer = (Answer(False, "a fault of the program, not a counterexample") if find["label"] == "crash" else
                  checker.check(find))
        store.add_find(run, task, find, answer.agrees, answer.says)


def _take(store: Store, run: int, report: Any, best: dict[Key, Sum], checker: Checker) -> int:
    # Finds first: a process that dies in between does the task again, and stores no find twice.
    for find in report["finds"]:
        confirm(store, run, report["task"], find, checker)
    if not store.add(run, report):
        return 0
    for row in report["targets"]:
        claim, construction, kind = row["target"]
        add_row(best, {**row, "claim": claim, "construction": construction, "kind": kind})
    return int(report["evaluated"])


def _is_worse(row: Row, than: Row) -> bool:
    if (row["outcome"] == "violated") != (than["outcome"] == "violated"):
        return bool(row["outcome"] == "violated")
    if not row["low"] or not than["low"]:
        return bool(row["low"]) and not than["low"]
    mine, its = mpq(row["low"]), mpq(than["low"])
    return bool(mine > its if row["direction"] > 0 else row["direction"] < 0 and mine < its)


def worst_text(row: Row | None) -> str:
    """Return the worst value of a row as a decimal with its exact square or number, shortened."""
    if row is None:
        return "nothing judged"
    worst = json.loads(row["shown"]).get("worst")
    if not isinstance(worst, dict):
        return str(row["outcome"])
    exact = str(worst["exact"])
    return f"{worst['decimal']} = {exact}" if len(exact) <= 60 else f"{worst['decimal']} (exactly: see hits --json)"


def _line(count: int, seconds: float, best: dict[Key, Sum]) -> str:
    parts = [f"{count} inputs, {count / max(seconds, 1e-9):.0f}/s"]
    for key, total in list(best.items())[:2]:
        parts.append(f"{key[0]}: {total.violations} violations, worst {worst_text(total.worst)}")
    return "; ".join(parts)
