"""The command `examples`."""

import argparse

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.options import Subparsers
from exactmesh.data import EXAMPLES
from exactmesh.io.atomic import write_text


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("examples", help="list the real outlines that come along, or write one")
    command.add_argument("name", metavar="NAME", nargs="?")
    command.add_argument("-o", "--output", metavar="OUT", default="-", help="where to write it (default: -)")
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    if args.name is None:
        print("\n".join(EXAMPLES.names()))
    else:
        write_text(args.output, EXAMPLES.path(args.name).read_text(encoding="utf-8"))
    return HOLDS
