"""The command `mesh`."""

import argparse
import hashlib
import sys
from collections.abc import Iterable

from exactmesh import report
from exactmesh.api import meshing_of
from exactmesh.certificate.files import certificate_text, pslg_bytes
from exactmesh.claims.run import ConstructionName, Run, construction_for
from exactmesh.commands.construction import add_construction
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.optimization import add_optimization, check_optimization, optimized
from exactmesh.commands.options import Subparsers, add_box, add_quiet, positive, read_source
from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.io.mesh_json import json_parts_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.paper import paper_options
from exactmesh.pictures.draw import svg_from_mesh
from exactmesh.pictures.steps import makers_of
from exactmesh.planar.mesh import KINDS
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("mesh", help="triangulate a PSLG, checking every step and the result")
    command.add_argument("file", metavar="FILE")
    command.add_argument("-o", "--output", metavar="OUT", help="write the mesh (exactmesh-mesh/1)")
    command.add_argument("--kind", choices=KINDS, default="nonproper",
                         help="nonproper (default): vertices may lie on sides of triangles; proper: they may not; "
                         "internal: proper, with vertices on the boundary, keeps the internal feature size; "
                         "classic: no new vertices, no promise")
    command.add_argument("--optimal", action="store_true", help="the best classic mesh of one simple polygon")
    add_optimization(command)
    add_construction(command, default=None)
    add_box(command)
    command.add_argument("--report", metavar="R", help="write what was checked (exactmesh-report/1)")
    command.add_argument("--svg", metavar="S", help="write a picture")
    command.add_argument("--certificate", metavar="C", help="write what a checker needs (exactmesh-certificate/1)")
    command.add_argument("--pslg", metavar="P", help="write the input, box included, as exactmesh-pslg/1: the checkers "
                         "read no other format")
    command.add_argument("--jobs", metavar="N", type=positive, default=1, help="processes that check (default: 1)")
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    results = (args.output, args.report, args.svg, args.certificate, args.pslg)
    outputs = [path for path in results if path]
    if "" in results:
        raise InputError("the name of an output file is empty")
    if len(set(outputs)) < len(outputs):
        raise InputError("two results cannot go to one place: give each its own file")
    if args.optimal and args.kind != "classic":
        raise InputError("--optimal is for --kind classic")
    check_optimization(args)
    if args.certificate and not args.output:
        raise InputError("a certificate belongs to the file of a mesh: give -o as well")
    if args.certificate and args.kind == "internal":
        raise InputError("internal meshes split edges of the input: certificates are for the other kinds")
    if args.certificate and args.bounding_box is not None and not args.pslg:
        raise InputError("with --bounding-box a certificate needs --pslg P: the input in its box is written there")
    construction: ConstructionName = args.construction or construction_for(args.kind)
    with Progress(args.quiet) as progress:
        progress("reading")
        source = read_source(args, args.file)
        pslg_data = b""
        if args.pslg:
            pslg_data = json_from_pslg(source.pslg).encode()
        elif args.certificate:
            pslg_data = pslg_bytes(args.file, source.sha256)
        options = paper_options(dict(args.paper))
        run = Run(source.pslg, construction, args.kind, options, progress, args.optimal, args.jobs)
        if args.optimize:
            result, summary = optimized(args, run)
        else:
            result = meshing_of(run)
            summary = f"{report.claims_text(result.judgements)}\n\n{report.verification_text(result.verification)}"
        progress("writing")
        # All parts are in memory at once only where they are needed again.
        parts: Iterable[str] = json_parts_from_mesh(result.mesh)
        if args.report or args.certificate:
            parts = list(parts)
        if args.output:
            write_text(args.output, parts)
        if args.report:
            digest = hashlib.sha256("".join(parts).encode()).hexdigest()
            name = "optimized" if args.optimize else construction
            write_text(args.report, report.report_json(source.pslg, source.sha256, result, digest, name))
        if args.svg:
            # Vertices of an optimised mesh are not those of the construction's steps.
            makers = None if args.optimize else makers_of(run)
            write_text(args.svg, svg_from_mesh(source.pslg, result.mesh, result.verification, makers))
        if args.pslg:
            write_text(args.pslg, pslg_data.decode())
        if args.certificate and result.verification.valid:
            data = "".join(parts).encode()
            write_text(args.certificate, certificate_text(pslg_data, data, run.subdivision, result.mesh,
                                                          result.verification, progress))
    if args.certificate and not result.verification.valid:
        print("exactmesh: no certificate is written: the mesh is not valid", file=sys.stderr)
    if not args.quiet:
        # A summary never mixes with a result that goes to standard output.
        print(summary, file=sys.stderr if "-" in results else sys.stdout)
    if not result.holds:
        print(report.failures_text(result.judgements), file=sys.stderr)
    return HOLDS if result.holds and result.verification.valid else FAILS
