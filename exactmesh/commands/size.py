"""The commands `mfs` and `ifs`."""

import argparse

from exactmesh import report
from exactmesh.api import ifs, mfs
from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_box, add_quiet, read_source
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    for name, what in (("mfs", "minimum"), ("ifs", "internal")):
        command = commands.add_parser(name, help=f"the exact {what} feature size of a PSLG, with its witness")
        command.add_argument("file", metavar="FILE")
        add_box(command)
        command.add_argument("--json", action="store_true", help="print one JSON object")
        add_quiet(command)
        add_limits(command)
        command.set_defaults(run=_run, name=name)


def _run(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        progress("reading")
        pslg = read_source(args, args.file).pslg
        progress(args.name)
        nearest = mfs(pslg) if args.name == "mfs" else ifs(pslg)
    print(report.size_json(args.name, nearest) if args.json else report.size_text(args.name, nearest))
    return HOLDS
