"""A campaign of harm against both checkers: python tests/certificate/campaign.py --seed N --count N.

Every kind of harm is done to every base in turn, each time with another seed, until COUNT triples are harmed. Both
checkers must agree to the letter, in time; what they accept must be true, and must not be of a kind that never is.
Exit status 0 when all of this holds. A triple that breaks it is kept in the folder given by --keep.
"""

import argparse
import contextlib
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

sys.path.append(str(Path(__file__).parent.parent))

from checkers import COMPILER, ByC, build, by_python, sanitized_or_plain
from harm import ALWAYS_WRONG, HARMS, harmed
from triples import BASES, truth

Verdict = Callable[[Sequence[bytes]], tuple[int, str]]


def harmed_triples(seed: int, count: int) -> Iterator[tuple[str, str, list[bytes]]]:
    """Yield `count` harmed triples with the names of base and kind, the same for the same seed."""
    made = turn = 0
    names = list(BASES)
    while made < count:
        for number, kind in enumerate(HARMS):
            # Bases and kinds shift against each other, so that all pairs come up.
            name = names[(turn + number) % len(names)]
            files = harmed(name, kind, seed * 10**6 + turn)
            if files is None:
                continue
            yield name, kind, files
            made += 1
            if made == count:
                return
        turn += 1


def fault(kind: str, files: Sequence[bytes], verdicts: Sequence[tuple[int, str]]) -> str:
    """Return what is wrong with the verdicts on a harmed triple, "" when nothing is."""
    status, line = verdicts[0]
    if any(verdict != verdicts[0] for verdict in verdicts):
        return f"the checkers differ: {verdicts}"
    if (status, line.split(" ")[0]) not in ((0, "VALID"), (1, "INVALID")) or "\n" in line:
        return f"no verdict: {status} {line!r}"
    if status == 0:
        wrong = truth(files)
        if wrong or kind in ALWAYS_WRONG:
            return f"accepted, but {wrong or 'of a kind that is always wrong'}"
    return ""


def run(seed: int, count: int, checkers: Sequence[Verdict], keep: Path | None = None) -> tuple[list[str], str]:
    """Return the faults found and a table of what happened."""
    faults: list[str] = []
    done: Counter[str] = Counter()
    accepted: Counter[str] = Counter()
    clauses: Counter[str] = Counter()
    slowest = 0.0
    for name, kind, files in harmed_triples(seed, count):
        begin = time.perf_counter()
        try:
            verdicts = [checker(files) for checker in checkers]
            found = fault(kind, files, verdicts)
        except Exception as error:  # a crash of a checker is what is looked for
            verdicts, found = [(3, "CRASH")], f"{type(error).__name__}: {error}"
        slowest = max(slowest, time.perf_counter() - begin)
        done[kind] += 1
        accepted[kind] += verdicts[0][0] == 0
        clauses[verdicts[0][1].split(":")[0] if verdicts[0][0] == 1 else "VALID"] += 1
        if found:
            faults.append(f"{kind}, {name}: {found}")
            if keep:
                for part, data in zip(("pslg", "mesh", "certificate"), files, strict=True):
                    (keep / f"{len(faults)}.{part}.json").write_bytes(data)
    lines = [f"{done[kind]:7} {accepted[kind]:7}  {kind}" for kind in HARMS if done[kind]]
    outcome = f"{len(faults)} FAULTS" if faults else f"{sum(accepted.values())} accepted, all true"
    total = f"{sum(done.values())} harmed of {len(done)} kinds, seed {seed}: {outcome}"
    table = ["  harmed accepted kind", *lines, "", "; ".join(
        f"{clause} {number}" for clause, number in clauses.most_common()), f"slowest {slowest:.2f} s", total]
    return faults, "\n".join(table)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--keep", type=Path, help="folder for triples that break the rules")
    parser.add_argument("--sanitize", action="store_true", help="compile check.c with sanitizers")
    args = parser.parse_args()
    if args.keep:
        args.keep.mkdir(parents=True, exist_ok=True)
    with contextlib.ExitStack() as stack:
        checkers: list[Verdict] = [by_python]
        if COMPILER:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
            program = stack.enter_context(sanitized_or_plain(folder)) if args.sanitize else build(folder)
            by_c = ByC(program)
            stack.callback(by_c.close)
            checkers.append(by_c)
        else:
            print("no C compiler: check.c is not tried")
        faults, table = run(args.seed, args.count, checkers, args.keep)
    print("\n".join([*faults[:20], table]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
