"""The command `view`."""

import argparse
import os
import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.options import Subparsers, add_quiet, positive
from exactmesh.errors import InputError
from exactmesh.io.text import printable
from exactmesh.progress import Progress

if TYPE_CHECKING:
    from exactmesh.viewer.subject import Subject


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser(
        "view", help="a page to look at a mesh, its claims and its steps; or an editor of polygons")
    command.add_argument("file", metavar="MESH", nargs="?", help="a mesh, of exactmesh or of others (.ele, .msh, "
                         ".vtu, .obj, ..); or a PSLG, which is meshed for the page (by the repaired construction), or "
                         "edited")
    command.add_argument("-o", "--output", metavar="PAGE", help="write the page, one HTML file that needs no network; "
                         "with --edit: where the page saves the polygon")
    command.add_argument("--pslg", metavar="P", help="the input of the mesh: the mesh is verified, the input drawn")
    command.add_argument("--report", metavar="R", help="the report of the mesh: its claims are listed")
    command.add_argument("--steps", action="store_true", help="each step of the construction; of a mesh with --pslg")
    command.add_argument("--construction", choices=("repaired", "paper"), help="what meshes a PSLG")
    command.add_argument("--edit", action="store_true", help="serve a page, on this machine only, that edits a polygon "
                         "and shows its exact mfs, meshes and failing claims; Ctrl-C stops it")
    command.add_argument("--port", metavar="N", type=_port, default=0, help="for --edit (default: a free one)")
    command.add_argument("--no-browser", action="store_true", help="for --edit: print the address only")
    command.add_argument("--time-limit", metavar="SECONDS", type=positive, default=20,
                         help="for --edit: give up on a polygon after this time (default: 20)")
    add_quiet(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    if args.edit:
        return _edit(args)
    if args.file is None:
        raise InputError("which mesh? give a file, or --edit")
    if not args.output:
        raise InputError("where is the page to go? give -o PAGE")
    return _write_page(args)


def _write_page(args: argparse.Namespace) -> int:
    # Here and below: what only one form of the command needs is imported when it is chosen.
    from exactmesh.io.atomic import write_text
    from exactmesh.viewer.document import document_of
    from exactmesh.viewer.page import viewer_page

    inputs = [path for path in (args.file, args.pslg, args.report) if path is not None]
    if "-" in inputs:
        raise InputError("a page is made of files, not of standard input")
    if os.path.realpath(args.output) in map(os.path.realpath, inputs):
        raise InputError(f"{printable(args.output)}: the page would take the place of what it shows")
    with Progress(args.quiet) as progress:
        progress("reading")
        subject = _subject(args, progress)
        progress("writing")
        write_text(args.output, viewer_page(document_of(subject)))
    return HOLDS


def _subject(args: argparse.Namespace, progress: Callable[[str], None]) -> "Subject":
    """Return what the arguments name, whichever kind of file the first one is."""
    from exactmesh.claims.run import Run
    from exactmesh.io.read import read_mesh, read_pslg
    from exactmesh.io.read_faces import holds_mesh, read_faces
    from exactmesh.viewer.report_file import read_report
    from exactmesh.viewer.subject import run_for, subject_of_foreign, subject_of_mesh, subject_of_run

    title = printable(os.path.basename(args.file))
    found = holds_mesh(args.file)
    if not found:
        if args.pslg or args.report:
            raise InputError("--pslg and --report are for a mesh; this file is none")
        return subject_of_run(Run(read_pslg(args.file).pslg, args.construction or "repaired", progress=progress), title,
                              args.steps)
    if args.construction:
        raise InputError("--construction is for a PSLG; this file is a mesh")
    given = read_pslg(args.pslg).pslg if args.pslg else None
    if found == "foreign":
        if args.report or args.steps:
            raise InputError("--report and --steps are for meshes by exactmesh")
        progress("measuring")
        return subject_of_foreign(*read_faces(args.file, given), given, title)
    source = read_mesh(args.file)
    report = read_report(args.report) if args.report else None
    if report is not None and report.mesh_sha256 != source.sha256:
        raise InputError(f"{printable(args.report)}: this is the report of another mesh than {printable(args.file)}")
    if not args.steps:
        progress("verification")
        return subject_of_mesh(source.mesh, given, report, title)
    if given is None:
        raise InputError("the steps to a mesh begin with its input: give --pslg P as well")
    return subject_of_run(run_for(given, source.mesh, report, progress), title, True)


def _edit(args: argparse.Namespace) -> int:
    import webbrowser

    from exactmesh.io.read import read_pslg
    from exactmesh.planar.pslg import polygon
    from exactmesh.viewer.server import Editor

    if args.pslg or args.report or args.steps or args.construction:
        raise InputError("--pslg, --report, --steps and --construction are for pages without --edit")
    if args.output == "-":
        raise InputError("the page saves to a file, not to standard output")
    start = [(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)]
    pslg = read_pslg(args.file).pslg if args.file else polygon(start)
    with Editor(pslg, args.output, args.port, args.time_limit) as editor:
        print(f"editing at {editor.url}\nCtrl-C stops", flush=True)
        if not args.no_browser:
            webbrowser.open(editor.url)
        try:
            editor.serve_forever()
        except KeyboardInterrupt:
            print("exactmesh: stopped", file=sys.stderr)
    return HOLDS


def _port(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and len(text) <= 5 and int(text) < 65536):
        raise argparse.ArgumentTypeError(f"{text!r} is not a port: 0 to 65535")
    return int(text)
