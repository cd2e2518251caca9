"""The command `verify-dissection`."""

import argparse

from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_quiet, read_polygons
from exactmesh.dissection.dissection_json import read_dissection
from exactmesh.dissection.report import verdict_json, verdict_text
from exactmesh.dissection.verify import verify_dissection
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("verify-dissection",
                                  help="decide whether pieces, from anywhere, make up each polygon")
    command.add_argument("files", metavar="FILE", nargs="+", help="the polygons, two or more, in the pieces' order")
    command.add_argument("pieces", metavar="PIECES", help="exactmesh-dissection/1")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        progress("reading")
        polygons = read_polygons(args.files, args.pieces)
        pieces = read_dissection(args.pieces)
        verdict = verify_dissection(polygons, pieces, progress)
    print(verdict_json(verdict) if args.json else verdict_text(verdict))
    return HOLDS if verdict.valid else FAILS
