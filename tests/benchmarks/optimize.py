"""Optimise the inputs of `exactmesh reproduce peers`, and larger ones: degradations, Steiner vertices, time.

Run `python tests/benchmarks/optimize.py [--short | --large]`. Prints a line an input and, at the end, figures over the
ordinary ones. The time of the construction is that of `exactmesh mesh`, all checks on; both are of the processor.
"""

import sys
from collections.abc import Iterator
from math import sqrt
from pathlib import Path
from statistics import median
from time import process_time

sys.path.insert(0, str(Path(__file__).parents[1]))
import families

from exactmesh.api import mesh
from exactmesh.optimize.optimize import optimize
from exactmesh.planar.faces import domain_of
from exactmesh.reproduce.peer_inputs import HARD_GROUPS, Input, inputs


def large() -> Iterator[Input]:
    """Yield random polygons of 1,000 to 100,000 vertices, and combs."""
    for n in (1000, 10_000, 100_000):
        for kind in ("grid", "growth", "star"):
            yield Input("large", f"{kind} {n}", lambda n=n, kind=kind: families.random_simple_polygon(n, 1, kind))
    for k in (500, 5000):
        yield Input("large", f"comb {k}", lambda k=k: families.comb(k))


def main() -> int:
    """Return 1 when a mesh is worse than it may be, else 0."""
    options = sys.argv[1:]
    found: list[tuple[str, float, float, int, int, float]] = []
    failures = 0
    for given in large() if "--large" in options else inputs("--short" in options):
        pslg = given.make()
        start = process_time()
        plain = mesh(pslg)
        middle = process_time()
        made = optimize(domain_of(pslg))
        end = process_time()
        before, after = plain.verification, made.verification
        first, best, classic = before.degradation_squared, after.degradation_squared, made.candidates[0]
        if not after.valid or first is None or best is None or best > min(first, classic.degradation_squared):
            failures += 1
            print(f"FAILS: {given.group} {given.name}")
            continue
        ratio = (end - middle) / (middle - start)
        found.append((given.group, sqrt(classic.degradation_squared), sqrt(best), before.steiner, after.steiner, ratio))
        print(f"{given.group:9} {given.name:26} n {len(pslg.vertices):6}  Delaunay "
              f"{sqrt(classic.degradation_squared):9.6g}  construction {sqrt(first):7.4f} +{before.steiner:<6} "
              f"optimised {sqrt(best):.6f} +{after.steiner:<5} {end - middle:7.2f} s, {ratio:5.2f} of the "
              f"construction's; {made.reason}", flush=True)
    ordinary = [row for row in found if row[0] not in HARD_GROUPS]
    best_first = sorted(row[2] for row in ordinary)
    print(f"{len(ordinary)} ordinary inputs: median {median(best_first):.6f}, "
          f"95% {best_first[len(best_first) * 19 // 20]:.6f}, worst {best_first[-1]:.6f}; "
          f"constrained Delaunay: median {median(row[1] for row in ordinary):.6f}")
    share = max((row[4] / row[3] for row in found if row[3]), default=0)
    print(f"Steiner vertices: {sum(row[4] for row in ordinary)}, of the construction "
          f"{sum(row[3] for row in ordinary)}; greatest share {share:.3f}")
    print(f"time over the construction's: median {median(row[5] for row in found):.2f}, "
          f"greatest {max(row[5] for row in found):.2f}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
