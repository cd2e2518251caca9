"""Time and memory of every step and every checker of the repaired construction, per vertex, and what floats decided.

Run `python tests/benchmarks/steps_profile.py [N [FAMILY [JOBS]]]`: 10,000 vertices of the family "star" and one process
by default; a family is one of the random polygons, "comb" or "circle". Times are of the processor, in microseconds a
vertex; memory is what the process holds at the end of the step, in bytes a vertex, and the most it ever held.
"""

import resource
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
import families

from exactmesh.claims.ledger import judge
from exactmesh.claims.run import Run
from exactmesh.geometry.decisions import decisions
from exactmesh.planar.pslg import Pslg


def polygon(family: str, count: int) -> Pslg:
    """Return a polygon of a family with about so many vertices."""
    if family == "comb":
        return families.comb(count // 4)
    if family == "circle":
        return families.regular_polygon(count)
    return families.random_simple_polygon(count, 1, family)


class Laps:
    """Prints a line for each step when the next one begins."""

    def __init__(self, count: int) -> None:
        self.count = count
        self.step = "start"
        self.begun = self.start = time.process_time()
        self.held = _held()

    def __call__(self, step: str) -> None:
        now = time.process_time()
        if now - self.begun > 2e-7 * self.count:
            held, most = _held() - self.held, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
            print(f"{self.step:32}{(now - self.begun) / self.count * 1e6:9.1f}{held / self.count:9.0f}"
                  f"{most / self.count:9.0f}", flush=True)
        self.step, self.begun = step, time.process_time()


def _held() -> int:
    """Return the resident memory in bytes; 0 where the system does not tell."""
    try:
        return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1]) * resource.getpagesize()
    except OSError:
        return 0


def main() -> int:
    """Return 1 when a claim fails, else 0."""
    given = sys.argv[1:]
    count, family, jobs = int(given[0]) if given else 10_000, *[*given[1:2], "star"][:1], int([*given[2:], "1"][0])
    pslg = polygon(family, count)
    count = len(pslg.vertices)
    print(f"{family}, {count} vertices, {jobs} jobs\n{'step':32}{'us':>9}{'bytes':>9}{'peak':>9}")
    laps = Laps(count)
    run = Run(pslg, progress=laps, jobs=jobs)
    _ = run.subdivision
    laps("mfs")
    _ = run.size, run.repaired
    laps("verification")
    held = all(judgement.verdict.holds for judgement in judge(run))
    laps("end")
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    total = time.process_time() - laps.start + children.ru_utime + children.ru_stime
    print(f"{'all':32}{total / count * 1e6:9.1f}\n\n{'decisions':32}{'floats':>12}{'exact':>12}")
    for what, number in decisions().items():
        print(f"{what:32}{number.by_floats:>12}{number.exactly:>12}")
    return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
