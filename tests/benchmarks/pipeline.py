"""Measure reading, meshing with all checks, and verifying polygons, each in a process of its own.

Run `make bench` or `python tests/benchmarks/pipeline.py [N]`; N vertices, 10,000 by default. Prints the wall-clock
time of each command and the largest resident memory of the two.
"""

import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))
import families

from exactmesh.io.pslg_json import json_from_pslg

KINDS = ("grid", "growth", "monotone", "partition", "star")


def timed(*arguments: str) -> float:
    """Return the seconds that one command takes; the command must succeed."""
    start = time.perf_counter()
    subprocess.run([sys.executable, "-m", "exactmesh", *arguments], check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - start


def main() -> None:
    """Print a line for each kind of polygon."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    print(f"{'polygon':12}{'vertices':>10}{'mesh, s':>10}{'verify, s':>11}{'memory so far, MiB':>20}")
    with tempfile.TemporaryDirectory() as folder:
        for kind in KINDS:
            polygon = families.random_simple_polygon(count, 1, kind)
            source, mesh = Path(folder, "p.json"), Path(folder, "m.json")
            source.write_text(json_from_pslg(polygon), encoding="utf-8")
            meshing = timed("mesh", str(source), "-o", str(mesh))
            verifying = timed("verify", str(source), str(mesh), "--max-degradation", "45")
            memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
            print(f"{kind:12}{len(polygon.vertices):>10}{meshing:>10.1f}{verifying:>11.1f}{memory:>20.0f}", flush=True)


if __name__ == "__main__":
    main()
