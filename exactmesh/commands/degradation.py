"""The command `degradation`."""

import argparse

from exactmesh import report_foreign
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_quiet
from exactmesh.io.decimals import nearest_double, rounded
from exactmesh.io.read import read_pslg
from exactmesh.io.read_faces import read_faces
from exactmesh.measure.foreign import measure_foreign
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser(
        "degradation", help="the exact degradation of any mesher's output",
        description="Compare a mesh by any mesher with its input, exactly: whether it is a mesh of the input, its mfs "
        "and degradation,\nand how many vertices it has beyond the input's, on the boundary and elsewhere. Exit status "
        "1 when it is no mesh\nof the input, not even after the input is rounded to doubles as meshers do.")
    command.add_argument("pslg", metavar="PSLG")
    command.add_argument("mesh", metavar="MESH", help="exactmesh-mesh/1, Triangle's .ele with its .node, a CG:SHOP "
                         "solution, or what meshio reads: .msh, .vtu, .obj, .off, ...")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_limits(command)
    add_quiet(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        progress("reading")
        pslg = read_pslg(args.pslg).pslg
        subdivision = domain_of(pslg)
        vertices, faces = read_faces(args.mesh, pslg)
        progress("measuring")
        measured = measure_foreign(subdivision, vertices, faces)
        in_doubles = None
        if not measured.verification.valid:
            progress("measuring in doubles")
            held = Pslg(rounded(pslg.vertices, nearest_double), pslg.edges, rounded(pslg.holes, nearest_double))
            in_doubles = measure_foreign(domain_of(held), rounded(vertices, nearest_double), faces)
    print(report_foreign.foreign_json(measured, in_doubles) if args.json else
          report_foreign.foreign_text(measured, in_doubles))
    return HOLDS if measured.verification.valid or (in_doubles is not None and in_doubles.verification.valid) else FAILS
