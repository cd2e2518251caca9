"""The options of `mesh --optimize`, and what they lead to."""

import argparse
import sys
from math import inf

from exactmesh.api import Meshing
from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.numbers.rational import rational_from_text, sqrt_text
from exactmesh.optimize.optimize import OPTIMIZED_KINDS, Optimized, optimize
from exactmesh.report import table, verification_text

_WHY = {
    "target": "the degradation asked for is reached", "no move helps": "no move helps any more",
    "effort": "much work gained little any more; --time-limit T allows more", "time": "the time is up",
    "interrupted": "interrupted"}


def add_optimization(command: argparse.ArgumentParser) -> None:
    """Add `--optimize`, `--target` and `--time-limit`."""
    command.add_argument("--optimize", action="store_true", help="improve the mesh locally, exactly: never worse than "
                         "the constrained Delaunay triangulation or the construction's mesh; interrupting it (Ctrl-C) "
                         "gives the best mesh so far")
    command.add_argument("--target", metavar="D", help="with --optimize: stop at degradation D (default: 1)")
    command.add_argument("--time-limit", metavar="T", help="with --optimize: work for up to T seconds where the "
                         "default, an effort linear in the size of the input, gives up earlier")


def check_optimization(args: argparse.Namespace) -> None:
    """Raise `InputError` for options that do not go together."""
    if not args.optimize:
        if args.target is not None or args.time_limit is not None:
            raise InputError("--target and --time-limit are for --optimize")
    elif args.kind not in OPTIMIZED_KINDS:
        raise InputError(f"--optimize is for --kind {' and '.join(OPTIMIZED_KINDS)}")
    elif args.construction not in (None, "repaired"):
        raise InputError("--optimize starts from the repaired construction: it does not go with --construction "
                         f"{args.construction}")


def optimized(args: argparse.Namespace, run: Run) -> tuple[Meshing, str]:
    """Return the optimised mesh of the run's input, without claims on steps, and a summary for reading."""
    target = rational_from_text("1" if args.target is None else args.target, "--target")
    limit = None
    if args.time_limit is not None:
        seconds = rational_from_text(args.time_limit, "--time-limit")
        if seconds < 0:
            raise InputError("--time-limit is negative")
        limit = float(seconds) if seconds < 10**9 else inf
    made = optimize(run.subdivision, run.kind, target, limit, run.progress)
    if made.reason == "interrupted":
        print("exactmesh: interrupted: this is the best mesh so far", file=sys.stderr)
    return Meshing(made.mesh, (), made.verification, run), _summary(made)


def _summary(made: Optimized) -> str:
    rows = [("candidate", "degradation", "Steiner vertices", "faces")]
    rows += [(candidate.name, sqrt_text(candidate.degradation_squared, 6), str(candidate.steiner),
              str(candidate.faces)) for candidate in made.candidates]
    return (f"{table(rows, right=(1, 2, 3))}\nthe mesh: {made.start}, {made.steps} steps; {_WHY[made.reason]}\n\n"
            f"{verification_text(made.verification)}")
