"""The command `verify-run`."""

import argparse
import json
from collections.abc import Iterator
from itertools import islice

from exactmesh.commands.engine import add_engine, run_search
from exactmesh.commands.exit_status import FAILS, HOLDS, REFUSED
from exactmesh.commands.options import Subparsers, positive
from exactmesh.io.atomic import write_text
from exactmesh.planar.mesh import KINDS
from exactmesh.search.evidence import evidence_in, verification_html, verification_record, verification_text
from exactmesh.search.spec import Spec, Task, search_tasks
from exactmesh.search.store import Store
from exactmesh.search.verify_run import chosen_targets, family_spec, input_tasks


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("verify-run", help="judge many claims on many inputs, with a store and a report")
    command.add_argument("inputs", metavar="INPUT", nargs="+",
                         help="a file, a folder, a .jsonl file of one input a line, or family:NAME[:KEY=N,..]")
    command.add_argument("--claims", metavar="ID,..", default="all", help="claims and objectives (default: all)")
    command.add_argument("--construction", choices=("repaired", "paper", "both", "coarse"), default="repaired")
    command.add_argument("--kind", choices=KINDS)
    command.add_argument("--count", type=positive, default=1000,
                         help="figures of each random family, in whole tasks of up to a hundred (default: 1000)")
    command.add_argument("--seed", type=int, default=0)
    command.add_argument("--shrink", action="store_true",
                         help="shrink inputs that violate a claim, check them again and keep them as finds")
    command.add_argument("--report", metavar="OUT", help="write the report as JSON")
    command.add_argument("--html", metavar="OUT", help="write the report as a page")
    command.add_argument("--json", action="store_true", help="print the report as JSON")
    add_engine(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    targets = chosen_targets(args.claims, args.construction, args.kind)
    families = [name.removeprefix("family:") for name in args.inputs if name.startswith("family:")]
    files = [name for name in args.inputs if not name.startswith("family:")]
    refused: list[str] = []
    runs: list[tuple[Spec, Iterator[Task]]] = []
    if files:
        spec = Spec(targets, "inputs", json.dumps(sorted(files)), shrinks=args.shrink).checked()
        runs.append((spec, input_tasks(files, refused)))
    for family in families:
        spec = family_spec(family, targets, args.seed, args.count, args.shrink)
        tasks = search_tasks(spec)
        runs.append((spec, tasks if spec.strategy == "exhaustive" else islice(tasks, -(-args.count // spec.size))))
    with Store(args.store) as store:
        found = evidence_in(store, [run_search(args, store, spec, tasks, False) for spec, tasks in runs])
    record = verification_record(found, refused)
    if args.report:
        write_text(args.report, json.dumps(record, indent=1) + "\n")
    if args.html:
        write_text(args.html, verification_html(found, refused))
    if args.json:
        print(json.dumps(record, indent=1))
    elif not args.quiet:
        print(verification_text(found, refused))
    if any(total.violations or total.crashes for total in found.values()):
        return FAILS
    return REFUSED if refused else HOLDS
