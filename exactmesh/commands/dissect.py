"""The command `dissect`."""

import argparse
import sys

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_quiet, read_polygons
from exactmesh.dissection.assembly import animation_from_dissection, cut_sheet_from_dissection
from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.dissection_json import json_from_dissection
from exactmesh.dissection.picture import svg_from_dissection
from exactmesh.dissection.report import dissected_text
from exactmesh.dissection.triangles import KINDS
from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("dissect", help="cut polygons of equal area into pieces that make up each of them")
    command.add_argument("files", metavar="FILE", nargs="+", help="two polygons or more; they may have holes")
    command.add_argument("-o", "--output", metavar="PIECES", required=True,
                         help="write the pieces (exactmesh-dissection/1)")
    command.add_argument("--svg", metavar="S", help="write a picture of all polygons side by side")
    command.add_argument("--animation", metavar="A", help="write an SVG in which the pieces move from one to the next")
    command.add_argument("--cut-sheet", metavar="C", help="write an A4 page to print and cut, as SVG")
    command.add_argument("--scale", action="store_true",
                         help="scale all but the first to the area of the first, exactly")
    command.add_argument("--kind", choices=KINDS,
                         help="the triangulation; without it those with the fewest strips, which carry the bound")
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    drawings = ((args.svg, svg_from_dissection), (args.animation, animation_from_dissection),
                (args.cut_sheet, cut_sheet_from_dissection))
    outputs = [args.output, *(path for path, _ in drawings if path is not None)]
    if "" in outputs:
        raise InputError("the name of an output file is empty")
    if len(set(outputs)) < len(outputs):
        raise InputError("two results cannot go to one place: give each its own file")
    with Progress(args.quiet) as progress:
        progress("reading")
        result = dissect(read_polygons(args.files), args.scale, args.kind, progress)
        progress("writing")
        write_text(args.output, json_from_dissection(result.dissection))
        for path, drawing in drawings:
            if path is not None:
                write_text(path, drawing(result.dissection))
    if not args.quiet:
        print(dissected_text(result), file=sys.stderr if "-" in outputs else sys.stdout)
    return HOLDS
