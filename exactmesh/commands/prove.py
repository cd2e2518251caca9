"""The command `prove`."""

import argparse

from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.options import Subparsers, add_quiet
from exactmesh.progress import Progress
from exactmesh.proofs.prove import prove, summaries
from exactmesh.proofs.report import contradiction, proofs_json, summary_text


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("prove", help="run the proofs for all inputs, or re-check their certificates")
    command.add_argument("id", metavar="ID", nargs="*", help="a claim, a problem, or a file of them; none: all")
    command.add_argument("--fast", action="store_true", help="certificates only, by rational arithmetic")
    command.add_argument("--seconds", type=float, default=30, help="what z3 and cvc5 get for a problem (default: 30)")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_quiet(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        results = list(prove(args.id, args.fast, args.seconds, progress))
    found = summaries(results)
    print(proofs_json(results) if args.json else summary_text(found, results))
    return FAILS if contradiction(results) or not all(summary.stands for summary in found) else HOLDS
