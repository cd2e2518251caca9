"""The command `completion`."""

import argparse

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.options import Subparsers
from exactmesh.io.library import library


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("completion", help="print a completion script for a shell")
    command.add_argument("shell", choices=("bash", "zsh", "tcsh"))
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    # Not before: the parser knows this module.
    from exactmesh.commands.parser import parser_of
    print(library("shtab", "completion").complete(parser_of(), shell=args.shell))
    return HOLDS
