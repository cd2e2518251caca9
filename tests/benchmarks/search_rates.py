"""Measure what searches and verification runs get done, in CPU time of one core.

Run `python tests/benchmarks/search_rates.py [--large]`. The first lines are the targets of the design: 2,000 exact
feature sizes a second of polygons with up to 12 corners, and 50 complete evaluations (mesh, all claims on the result,
verification). Then tasks of a verification run as workers do them, with the time to store them; with `--large` on
polygons of 1,000 to 10,000 vertices too.
"""

import random
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from itertools import islice
from pathlib import Path

from exactmesh.search.collect import Collector
from exactmesh.search.driver import run_tasks
from exactmesh.search.engine import Serial
from exactmesh.search.families import family_of, planar_sample
from exactmesh.search.figure import Figure
from exactmesh.search.small_mfs import small_mfs_squared
from exactmesh.search.spec import Spec, search_tasks
from exactmesh.search.store import Store
from exactmesh.search.targets import target_of
from exactmesh.search.verify_run import chosen_targets, family_spec

LIGHT = "repaired.degradation,repaired.steiner-count,theorem-1.triangulation"


def samples(family: str, count: int, **parameters: int) -> list[Figure]:
    """Return figures of a family."""
    found = (planar_sample(family_of(family, parameters), random.Random(seed)) for seed in range(count))
    return [figure for figure in found if figure is not None]


def rate(work: Callable[[Figure], object], figures: Sequence[Figure]) -> float:
    """Return how many figures are worked on in a second of CPU time."""
    start = time.process_time()
    for figure in figures:
        work(figure)
    return len(figures) / (time.process_time() - start)


def run_rate(spec: Spec, tasks: int | None) -> tuple[int, float]:
    """Return how many inputs a run judged, and how many in a second of CPU time, with the store."""
    with tempfile.TemporaryDirectory() as folder, Store(str(Path(folder, "s.db"))) as store:
        run = store.open_run(spec.to_json(), "0", "benchmark", False)
        start = time.process_time()
        count = run_tasks(store, run, spec, islice(search_tasks(spec), tasks), Serial(), None, lambda line: None)
        return count, count / (time.process_time() - start)


def main() -> None:
    """Print a line for each measurement."""
    for n in (6, 12):
        print(f"exact feature sizes, {n} corners: "
              f"{rate(lambda f: small_mfs_squared(f.points), samples('tour', 1000, n=n)):.0f} a second")
    for name, construction in (("repaired.degradation", "repaired"), ("theorem-1.degradation", "paper")):
        for n in (3, 4, 6, 8, 12):
            collector = Collector([target_of(name, construction)])
            print(f"mesh and check, {construction}, {n} corners: "
                  f"{rate(collector.see, samples('tour', 200, n=n)):.0f} a second")
    for family, claims, tasks in (("lattice:n=4,m=4", LIGHT, None), ("tour:n=5", LIGHT, 10), ("tour:n=6", "all", 3)):
        count, speed = run_rate(family_spec(family, chosen_targets(claims, "repaired", None), 0, 1000, False), tasks)
        print(f"verification run, {family}, {'all claims' if claims == 'all' else 'three claims'}: "
              f"{speed:.0f} a second ({count} inputs)")
    if "--large" in sys.argv[1:]:
        for n in (1000, 3000, 10000):
            for kind in ("growth", "partition"):
                spec = family_spec(f"{kind}:n={n}", chosen_targets("all", "repaired", None), 0, 1000, False)
                count, speed = run_rate(spec, 1)
                print(f"verification run, {kind}:n={n}, all claims: {speed:.2f} a second ({count} inputs)")


if __name__ == "__main__":
    main()
