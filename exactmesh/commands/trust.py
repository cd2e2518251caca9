"""The command `trust`."""

import argparse
import json

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.options import Subparsers
from exactmesh.trust import trust_text, trust_value, trusted_bases


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("trust", help="list the files that verdicts rest on, with their lines")
    command.add_argument("--short", action="store_true", help="sums only")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    bases = trusted_bases()
    print(json.dumps({"trusted": trust_value(bases)}, indent=1) if args.json else trust_text(bases, not args.short))
    return HOLDS
