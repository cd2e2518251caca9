"""The command `convert`."""

import argparse
import os
import sys

from exactmesh import report_foreign
from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_quiet
from exactmesh.errors import InputError
from exactmesh.io.atomic import write_bytes
from exactmesh.io.export import export_mesh, export_pslg, extension_of
from exactmesh.io.read import read_mesh, read_pslg
from exactmesh.measure.foreign import graph_mfs, pslg_mfs
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser(
        "convert", help="write a PSLG or a mesh in another format",
        description="Write a PSLG, or with --mesh a mesh (exactmesh-mesh/1), in another format. What a format cannot "
        "hold exactly\nis rounded; then the exact feature size of what was written is printed beside the old one.")
    command.add_argument("file", metavar="FILE")
    command.add_argument("-o", "--output", metavar="OUT", required=True, help="where to write it")
    command.add_argument("--mesh", action="store_true", help="FILE is a mesh")
    command.add_argument("--to", metavar="EXT", help="the format; without it the extension of OUT says: for a PSLG "
                         "json (exactmesh-pslg/1), geojson, wkt, wkb, poly, svg, dxf, cgshop (an instance); for a mesh "
                         "json, geojson, ele, cgshop (a solution), or one of meshio's: vtu, vtk, obj, off, msh, ...")
    command.add_argument("--pslg", metavar="P", help="the instance of a CG:SHOP solution")
    add_limits(command)
    add_quiet(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    extension = extension_of(args.output, args.to)
    with Progress(args.quiet) as progress:
        progress("reading")
        if args.mesh:
            mesh = read_mesh(args.file).mesh
            instance = read_pslg(args.pslg).pslg if args.pslg else None
            progress("writing")
            written, held_mesh = export_mesh(mesh, instance, extension)
            progress("feature size")
            sizes = ([graph_mfs(each.vertices, each.faces) for each in (mesh, held_mesh)] if written.rounded else [])
        else:
            if args.pslg:
                raise InputError("--pslg is for --mesh")
            pslg = read_pslg(args.file).pslg
            progress("writing")
            written, held = export_pslg(pslg, extension)
            progress("feature size")
            sizes = [pslg_mfs(each) for each in (pslg, held)] if written.rounded else []
        for kind, data in written.files.items():
            # Triangle's mesh is two files, which differ in their extensions only.
            path = args.output if len(written.files) == 1 else os.path.splitext(args.output)[0] + kind
            write_bytes(path, data)
    if sizes and not args.quiet:
        print(report_foreign.rounded_text(written.rounded, *sizes),
              file=sys.stderr if args.output == "-" else sys.stdout)
    return HOLDS
