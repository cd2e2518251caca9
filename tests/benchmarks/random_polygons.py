"""Mesh and verify many random simple polygons; a longer run than the test suite can afford.

Run `python tests/benchmarks/random_polygons.py [COUNT [LARGEST [SEED]]]`; 100 polygons of up to 5,000 vertices by
default. Prints a line for each tenth polygon and stops, with the input on standard output, at the first failing claim.
"""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
import families

import exactmesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.numbers.rational import sqrt_text

KINDS = ("grid", "growth", "monotone", "partition", "star")


def main() -> int:
    """Return 1 at the first failing claim, else 0."""
    count, largest, seed = [int(text) for text in sys.argv[1:]] + [100, 5000, 1][len(sys.argv) - 1 :]
    rng = random.Random(seed)
    worst = 0
    for number in range(1, count + 1):
        size = max(8, int(largest ** rng.uniform(0.4, 1)))
        polygon = families.random_simple_polygon(size, rng.randrange(10**6), rng.choice(KINDS))
        result = exactmesh.mesh(polygon)
        verification = exactmesh.verify(polygon, result.mesh)
        if not result.holds or verification.degradation_squared is None:
            print(json_from_pslg(polygon))
            return 1
        worst = max(worst, verification.degradation_squared)
        if number % 10 == 0:
            print(f"{number} polygons, worst degradation {sqrt_text(worst)}", file=sys.stderr, flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
