"""Compare `verify` with brute force on small meshes: python tests/differential/campaign_verify.py --seed N --count N.

Random polygons, polygons with holes and PSLGs are meshed in all four kinds; the meshes, as they are and after one to
three changes of 15 kinds, are judged by `verify_mesh` and by `oracle`, which shares no code with the package. They must
agree on validity, and on valid meshes on both feature sizes and the degradation, exactly. Exit status 0 when they do.
"""

import argparse
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

sys.path.extend(str(Path(__file__).parent.parent / name) for name in ("", "measure"))

import families
from test_validity import CHANGES, STARTS, Case

from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.planar.mesh import KINDS

FACES = 36
PER_START = 40


def _start(source: random.Random) -> Case:
    """Return a random small input with a mesh that is valid, of a random kind."""
    while True:
        count, seed = source.randrange(4, 8), source.randrange(10**6)
        match source.randrange(6):
            case 0 | 1 | 2:
                name = source.choice(("grid", "growth", "monotone", "partition", "star", "two-opt"))
                pslg = families.random_simple_polygon(count, seed, name)
            case 3:
                pslg = families.polygon_with_holes(1, 1, seed)
            case 4:
                pslg = families.random_pslg(seed, source.randrange(1, 3))
            case _:
                return source.choice(STARTS)
        kind = source.choice(KINDS)
        try:
            mesh = Run(pslg, "classic" if kind == "classic" else "repaired", kind).mesh
        except InputError:  # an internal mesh is not made where edges have the domain on both sides
            continue
        if len(mesh.faces) <= FACES:
            return Case(pslg, mesh)


def cases(seed: int, count: int) -> Iterator[tuple[str, Case]]:
    """Yield `count` cases, each with the names of the changes made, the same for the same seed."""
    source = random.Random(seed)
    for number in range(count):
        if number % PER_START == 0:
            start = _start(source)
            yield "no change", start
            continue
        chosen = source.choices(CHANGES, k=source.choice((1, 1, 1, 2, 3)))
        case = start
        try:
            for change in chosen:
                case = change(case, source)
        except (ValueError, IndexError, RuntimeError):  # a change that cannot follow the one before
            case = start
        yield ", ".join(change.__name__ for change in chosen), case


def run(seed: int, count: int) -> tuple[list[str], str]:
    """Return the disagreements, and a table."""
    done: Counter[str] = Counter()
    valid: Counter[str] = Counter()
    clauses: Counter[str] = Counter()
    found: list[str] = []
    for number, (changes, case) in enumerate(cases(seed, count)):
        name = changes if "," not in changes else "two or three changes"
        done[name] += 1
        try:
            violated = case.judged()
        except AssertionError as error:
            found.append(f"{number}, {changes}: {str(error).splitlines()[:1]}: {case}")
            continue
        valid[name] += not violated
        clauses.update(violated)
    lines = [" meshes   valid  change", *(f"{done[name]:7} {valid[name]:7}  {name}" for name in sorted(done)), "",
             "clauses broken: " + ", ".join(f"{clause} {number}" for clause, number in clauses.most_common()),
             f"{count} meshes, seed {seed}: {sum(valid.values())} valid, {len(found)} disagreements"]
    return found, "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=500)
    args = parser.parse_args()
    begin = time.perf_counter()
    found, table = run(args.seed, args.count)
    print("\n".join([*found[:20], table, f"{time.perf_counter() - begin:.0f} s"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
