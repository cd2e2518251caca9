"""The command `plot`."""

import argparse
import os
from dataclasses import replace
from typing import TYPE_CHECKING

from exactmesh.commands.construction import add_construction
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_box, add_quiet, read_source
from exactmesh.errors import InputError
from exactmesh.planar.mesh import KINDS, Kind
from exactmesh.progress import Progress

if TYPE_CHECKING:
    from exactmesh.pictures.scene import Scene
    from exactmesh.pictures.view import View

def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser(
        "plot", help="a picture of an input, of a mesh, or of any step of a construction")
    command.add_argument("files", metavar="FILE", nargs="+", help="a PSLG, a mesh, or a PSLG and a mesh of it; of "
                         "exactmesh or of others (.ele, .msh, .vtu, .obj, ..)")
    command.add_argument("-o", "--output", metavar="OUT", required=True,
                         help="the picture: .svg, or .png and .pdf, which need matplotlib; - is standard output, SVG")
    command.add_argument("--step", metavar="STEP", help="of a PSLG: P (the input, the default); mesh; of the paper's "
                         "construction also P2, P3, P4, P5, P6, phase1 to phase4, tube; of the repaired one Q, "
                         "trapezoids, interior, tube; all of them")
    add_construction(command, default=None)
    command.add_argument("--kind", choices=KINDS, help="the kind of mesh (default: nonproper)")
    add_box(command)
    command.add_argument("--window", metavar="X,Y,X,Y", help="only what is in this rectangle, given by two corners")
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    form = _form(args.output)
    if len(args.files) > 2:
        raise InputError("plot takes a PSLG, a mesh, or a PSLG and a mesh of it")
    if args.files == ["-", "-"]:
        raise InputError("PSLG and MESH cannot both be standard input")
    with Progress(args.quiet) as progress:
        progress("reading")
        scene, holds = _scene(args, progress)
        progress("drawing")
        if form == "svg":
            from exactmesh.io.atomic import write_text
            from exactmesh.pictures.svg import svg_text

            write_text(args.output, svg_text(scene))
        else:
            from exactmesh.io.atomic import write_bytes
            from exactmesh.pictures.mpl import image_bytes

            write_bytes(args.output, image_bytes(scene, form))
    return HOLDS if holds else FAILS


def _form(path: str) -> str:
    """Return the format that a file's name asks for."""
    ending = os.path.splitext(path)[1].lower().removeprefix(".")
    if path == "-":
        return "svg"
    if ending not in ("svg", "png", "pdf"):
        raise InputError(f"{path or 'an empty name'}: a picture is .svg, .png or .pdf")
    return ending


def _scene(args: argparse.Namespace, progress: Progress) -> "tuple[Scene, bool]":
    """Return the picture, and whether what it shows is valid."""
    from exactmesh.claims.run import ConstructionName, Run, construction_for
    from exactmesh.io.read_faces import holds_mesh
    from exactmesh.paper import paper_options
    from exactmesh.pictures.draw import picture_of_input, picture_of_run
    from exactmesh.planar.faces import subdivide

    first, *others = args.files
    made = args.construction or args.kind or args.paper
    view = None if args.window is None else _window(args.window)
    is_mesh = bool(others) or (first != "-" and holds_mesh(first) != "")
    if is_mesh and (args.step or made):
        raise InputError("--step, --construction, --paper and --kind are of what is made from a PSLG; a mesh was given")
    if is_mesh:
        return _scene_of_mesh(args, view, progress)
    pslg = read_source(args, first).pslg
    if not args.step and not made:
        subdivide(pslg)
        return picture_of_input(pslg, view), True
    kind: Kind = args.kind or "nonproper"
    construction: ConstructionName = args.construction or construction_for(kind)
    run = Run(pslg, construction, kind, paper_options(dict(args.paper)), progress)
    return picture_of_run(run, args.step or "mesh", view), True


def _scene_of_mesh(args: argparse.Namespace, view: "View | None", progress: Progress) -> "tuple[Scene, bool]":
    """Return the picture of a mesh, with its input or without, and whether it is exactly a mesh of that."""
    from exactmesh.io.read import read_mesh
    from exactmesh.io.read_faces import holds_mesh, read_faces
    from exactmesh.measure.foreign import in_order, measure_foreign
    from exactmesh.measure.validity import verify_mesh
    from exactmesh.pictures.draw import picture_of_faces, picture_of_mesh
    from exactmesh.planar.faces import domain_of
    from exactmesh.planar.mesh import Mesh
    from exactmesh.planar.pslg import Pslg

    *given, path = args.files
    is_foreign = path != "-" and holds_mesh(path) != "ours"
    if not given:
        if not is_foreign:
            return picture_of_faces(read_mesh(path).mesh, view), True
        points, cycles, _ = in_order(Pslg((), ()), *read_faces(path))
        return picture_of_faces(Mesh("nonproper", points, cycles), view), True
    pslg = read_source(args, given[0]).pslg
    subdivision = domain_of(pslg)
    if not is_foreign:
        mesh = read_mesh(path).mesh
        progress("verification")
        verification = verify_mesh(subdivision, mesh)
        return picture_of_mesh(pslg, mesh, verification, view=view), verification.valid
    vertices, faces = read_faces(path, pslg)
    progress("measuring")
    measured = measure_foreign(subdivision, vertices, faces)
    # Of a mesh that rounding has spoilt, what is drawn is the nearest pair of its edges.
    found = replace(measured.verification, mesh_mfs=measured.graph.nearest)
    return picture_of_mesh(pslg, measured.mesh, found, view=view), found.valid


def _window(text: str) -> "View":
    from exactmesh.geometry.point import Point
    from exactmesh.numbers.rational import rational_from_text
    from exactmesh.pictures.view import window

    numbers = [rational_from_text(part, "--window") for part in text.split(",")]
    if len(numbers) != 4:
        raise InputError(f"--window: four numbers are expected, not {len(numbers)}")
    (left, right), (low, high) = sorted(numbers[::2]), sorted(numbers[1::2])
    return window(Point(left, low), Point(right, high))
