"""The command `bench`."""

import argparse
import os
import sys
from collections.abc import Callable, Iterable

from exactmesh.bench.inputs import FAMILIES
from exactmesh.bench.measure import NOTHING, Results, measured, plan_of
from exactmesh.bench.peers import PEERS
from exactmesh.bench.report import bench_json, bench_svg, bench_text, results_of
from exactmesh.bench.worker import STAGES, WITHOUT_MESH, machine
from exactmesh.commands.exit_status import FAILS, HOLDS, INTERRUPTED
from exactmesh.commands.options import Subparsers, add_quiet, make_folder
from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.progress import Progress

_FULL, _SHORT = (10_000, 100_000, 1_000_000), (1_000, 10_000)


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("bench", help="time and memory of every stage, and beside other programs")
    command.add_argument("--sizes", metavar="N,..", type=_sizes, help="numbers of vertices (default: "
                         f"{', '.join(map(str, _FULL))}; hours)")
    command.add_argument("--short", action="store_true", help=f"sizes {', '.join(map(str, _SHORT))} and short "
                         "comparisons: minutes")
    command.add_argument("--families", metavar="FAMILY,..", type=_choice(FAMILIES, False), default=list(FAMILIES),
                         help=f"only these of {', '.join(FAMILIES)}")
    command.add_argument("--peers", metavar="PEER,..", type=_choice(PEERS, True), default=list(PEERS),
                         help=f"only these of {', '.join(PEERS)}; - for none")
    command.add_argument("--no-mesh", action="store_true", help="read, validate and measure only")
    command.add_argument("-o", "--output", metavar="DIR", help="also write bench.txt, .json and .svg there")
    command.add_argument("--resume", action="store_true", help="measure only what DIR does not have yet, and show all")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_quiet(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    sizes = args.sizes or (_SHORT if args.short else _FULL)
    plan = plan_of(args.families, sizes, args.short, WITHOUT_MESH if args.no_mesh else len(STAGES), args.peers)
    if args.output:
        make_folder(args.output)  # before the work: it may be refused
    known = _known(args, plan.stages)
    with Progress(args.quiet) as progress:
        results = measured(plan, progress, known, lambda found: _keep(args.output, found))
    _keep(args.output, results)
    print(bench_json(results, machine()) if args.json else bench_text(results, machine()))
    if results.interrupted:
        print("exactmesh: interrupted: the table has what was measured until then", file=sys.stderr)
        return INTERRUPTED
    return HOLDS if all(row.holds for row in results.rows) else FAILS


def _known(args: argparse.Namespace, stages: int) -> Results:
    """Return what an earlier run has measured; raises `InputError` if that were other stages."""
    if not args.resume:
        return NOTHING
    if not args.output:
        raise InputError("--resume needs -o DIR, where the measurements are")
    path = os.path.join(args.output, "bench.json")
    if not os.path.exists(path):
        return NOTHING
    with open(path, encoding="utf-8") as file:
        found = results_of(file.read(), machine(), path)
    if any(len(row.cpu) != stages for row in found.rows if not row.failure):
        raise InputError(f"{path}: measured with and without meshes: choose another folder")
    return found


def _keep(folder: str | None, results: Results) -> None:
    """Write all files of a folder, if there is one."""
    if folder:
        for ending, text_of in (("txt", bench_text), ("json", bench_json), ("svg", bench_svg)):
            write_text(os.path.join(folder, f"bench.{ending}"), text_of(results, machine()) + "\n")


def _sizes(text: str) -> list[int]:
    parts = text.split(",")
    if not all(part.isdecimal() and part.isascii() and len(part) <= 8 for part in parts):
        raise argparse.ArgumentTypeError(f"{text!r}: whole numbers of at most eight digits, separated by commas")
    return [int(part) for part in parts]


def _choice(known: Iterable[str], may_be_none: bool) -> Callable[[str], list[str]]:
    """Return a reader of a list of names; `-` stands for none."""
    names = list(known)

    def chosen(text: str) -> list[str]:
        given = [] if text == "-" and may_be_none else text.split(",")
        if not set(given) <= set(names):
            raise argparse.ArgumentTypeError(f"{text!r}: choose from {', '.join(names)}, separated by commas")
        return [name for name in names if name in given]

    return chosen
