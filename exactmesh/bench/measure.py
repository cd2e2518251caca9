"""Run all measurements, each in a process of its own, and say how long the rest will take."""

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from math import log
from statistics import linear_regression, median
from typing import Any

from exactmesh.bench.inputs import FAMILIES, LEAST
from exactmesh.bench.peers import PEERS, Case
from exactmesh.bench.worker import STAGES, WITHOUT_MESH
from exactmesh.errors import InputError

# Seconds a vertex before anything has been measured.
_GUESS, _GUESS_WITHOUT_MESH = 400e-6, 60e-6


@dataclass(frozen=True, slots=True)
class Row:
    """One input of about `size` vertices: seconds by stage, of the process (`cpu`) and of the clock (`wall`); memory in
    bytes, the greatest of the process, and what it had before it read the input. `failure` says why there is no
    more."""

    family: str
    n: int
    cpu: Mapping[str, float] = field(default_factory=dict)
    wall: Mapping[str, float] = field(default_factory=dict)
    memory: int = 0
    memory_before: int = 0
    mesh_vertices: int = 0
    faces: int = 0
    holds: bool = True
    decisions: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    failure: str = ""
    size: int = 0

    @property
    def added_memory(self) -> int:
        """The memory that the input took, in bytes."""
        return max(1, self.memory - self.memory_before)


@dataclass(frozen=True, slots=True)
class Beside:
    """One comparison at about `size` vertices: seconds of ours and of another program in one process; `target` bounds
    their quotient."""

    peer: str
    family: str
    n: int
    target: float | None
    ours: float = 0.0
    theirs: float = 0.0
    failure: str = ""
    size: int = 0

    @property
    def ratio(self) -> float | None:
        """Our time over theirs."""
        return None if self.failure else self.ours / max(self.theirs, 1e-9)


@dataclass(frozen=True, slots=True)
class Plan:
    """What to measure; comparisons are made at their full sizes or, `short`, at smaller ones, cut to `largest`."""

    families: Sequence[str]
    sizes: Sequence[int]
    stages: int = len(STAGES)
    peers: Sequence[str] = tuple(PEERS)
    short: bool = False
    largest: int = 10**6

    def cases(self) -> list[tuple[str, Case, int]]:
        """Return the comparisons: peer, case and size, each size once."""
        found: dict[tuple[str, str, int], Case] = {}
        for peer in self.peers:
            for case in PEERS[peer].cases:
                found.setdefault((peer, case.family, min(case.short if self.short else case.n, self.largest)), case)
        return [(peer, case, n) for (peer, _, n), case in found.items()]


@dataclass(frozen=True, slots=True)
class Results:
    """All that was measured, all that was planned unless it is `interrupted`."""

    rows: Sequence[Row]
    beside: Sequence[Beside]
    interrupted: bool = False


NOTHING = Results((), ())


def measured(plan: Plan, progress: Callable[[str], None], known: Results = NOTHING,
             keep: Callable[[Results], None] = lambda results: None) -> Results:
    """Measure all that is planned and not `known`, small inputs first, and return it with what is known; `progress` is
    told what is measured and how long the rest takes, and `keep` all that there is after each measurement.

    A process that fails, for lack of memory or otherwise, leaves a row that says so; it is not known. An interrupt ends
    it all; what there is by then is returned.
    """
    rows = {(row.family, row.size): row for row in known.rows if not row.failure}
    beside = {(row.peer, row.family, row.size): row for row in known.beside if not row.failure}
    planned = [(family, n) for n in plan.sizes for family in plan.families]
    compared = {(name, case.family, n): case for name, case, n in plan.cases()}
    inputs, cases = [key for key in planned if key not in rows], [key for key in compared if key not in beside]
    left = _Left(progress, [*inputs, *((f"{name}, {family}", n) for name, family, n in cases)],
                 _GUESS if plan.stages > WITHOUT_MESH else _GUESS_WITHOUT_MESH)

    def found(interrupted: bool = False) -> Results:
        order, peers = list(FAMILIES), list(PEERS)
        return Results(sorted(rows.values(), key=lambda row: (row.size, order.index(row.family))),
                       sorted(beside.values(), key=lambda row: (peers.index(row.peer), row.size,
                                                                order.index(row.family))), interrupted)

    try:
        for family, n in inputs:
            with left.timed():
                rows[family, n] = _measured_input(family, n, plan.stages)
            keep(found())
        for name, family, n in cases:
            with left.timed():
                beside[name, family, n] = _measured_peer(name, compared[name, family, n], n)
            keep(found())
    except KeyboardInterrupt:
        return found(interrupted=True)
    return found()


def exponent(points: Sequence[tuple[float, float]]) -> float | None:
    """Return the power of x that y grows with: the slope of logarithms by least squares; None for fewer than two x."""
    if len({x for x, _ in points}) < 2 or min(y for _, y in points) <= 0:
        return None
    return linear_regression([log(x) for x, _ in points], [log(y) for _, y in points]).slope


class _Left:
    """Tells how long what is left will take, from the rates of what has been done: of the same family where known."""

    def __init__(self, progress: Callable[[str], None], todo: Sequence[tuple[str, int]], guess: float) -> None:
        self.progress = progress
        self.guess = guess
        self.todo = list(todo)
        self.count = len(self.todo)
        self.rates: dict[str, float] = {}

    @contextmanager
    def timed(self) -> Iterator[None]:
        """Say what is measured next, and take the time that it takes into account."""
        name, n = self.todo[0]
        known = median(self.rates.values()) if self.rates else self.guess
        seconds = sum(size * self.rates.get(what, known) for what, size in self.todo)
        number = self.count - len(self.todo) + 1
        self.progress(f"{name}, {n} vertices ({number} of {self.count}, about {_duration(seconds)} left)")
        start = time.perf_counter()
        yield
        self.todo.pop(0)
        self.rates[name] = (time.perf_counter() - start) / n


def _duration(seconds: float) -> str:
    return f"{seconds:.0f} s" if seconds < 100 else f"{seconds / 60:.0f} min" if seconds < 6000 else (
        f"{seconds / 3600:.1f} h")


def _measured_input(family: str, n: int, stages: int) -> Row:
    with tempfile.TemporaryDirectory(prefix="exactmesh-bench-") as folder:
        path, out = os.path.join(folder, "p.json"), os.path.join(folder, "m.json")
        made = _run({"task": "make", "family": family, "n": n, "path": path})
        found = made if "failure" in made else _run({"task": "pipeline", "path": path, "out": out, "stages": stages})
    given: dict[str, Any] = {"family": family, "n": n, "size": n}
    return Row(**given | found)


def _measured_peer(name: str, case: Case, n: int) -> Beside:
    peer = PEERS[name]
    if peer.is_there:
        found = _run({"task": "peer", "peer": name, "family": case.family, "n": n})
    else:
        found = {"failure": f"not installed ({peer.module})"}
    # The bound is for the full size.
    target = case.target if n == case.n else None
    given: dict[str, Any] = {"peer": name, "family": case.family, "n": n, "size": n, "target": target}
    return Beside(**given | found)


def _run(task: Mapping[str, object]) -> dict[str, Any]:
    """Return what a process of its own found out, or its failure."""
    done = subprocess.run([sys.executable, "-m", "exactmesh.bench.worker", json.dumps(task)], capture_output=True,
                          text=True, check=False)
    if done.returncode == 0:
        found: dict[str, Any] = json.loads(done.stdout)
        return found
    if done.returncode == -2:
        raise KeyboardInterrupt
    if done.returncode < 0:
        return {"failure": f"ended by signal {-done.returncode}"}
    lines = done.stderr.strip().splitlines()
    return {"failure": lines[-1] if lines else f"exit status {done.returncode}"}


def plan_of(families: Sequence[str], sizes: Sequence[int], short: bool, stages: int, peers: Sequence[str]) -> Plan:
    """Return the plan of a command line; raises `InputError` for sizes below the least that all families have.

    Comparisons are made at sizes no greater than the greatest of `sizes`.
    """
    if small := [n for n in sizes if n < LEAST]:
        raise InputError(f"a size of {min(small)} is too small: {LEAST} is the least")
    return Plan(families, sorted(set(sizes)), stages, peers, short, max(sizes))
