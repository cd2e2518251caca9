"""The command line: arguments in, exit status out. No geometry here.

Exit status: 0 all that was asked for holds; 1 a claim fails (results are still written, the witness is printed);
2 usage or input refused; 130 interrupted.
"""

import argparse
import contextlib
import hashlib
import json
import os
import sys
from collections.abc import Sequence
from dataclasses import replace

import exactmesh
from exactmesh import check, report
from exactmesh.api import ifs, meshing_of, mfs, verify
from exactmesh.certificate.files import certificate_text, pslg_bytes
from exactmesh.certificate.part import check_part
from exactmesh.claims.bounds import bounds
from exactmesh.claims.ledger import CLAIMS, claim_by_id, judge_one
from exactmesh.claims.run import ConstructionName, Run, construction_for
from exactmesh.claims.status import ledger
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.data import EXAMPLES
from exactmesh.dissection.assembly import animation_from_dissection, cut_sheet_from_dissection
from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.dissection_json import json_from_dissection, read_dissection
from exactmesh.dissection.lower_bound import rectangle_rows, rectangles_json, rectangles_text
from exactmesh.dissection.picture import svg_from_dissection
from exactmesh.dissection.report import dissected_text, verdict_json, verdict_text
from exactmesh.dissection.triangles import KINDS as DISSECTION_KINDS
from exactmesh.dissection.verify import verify_dissection
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.io.atomic import write_text
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.read import Source, read_mesh, read_pslg
from exactmesh.io.svg import svg_from_mesh
from exactmesh.io.text import printable
from exactmesh.numbers.rational import decimal_text, rational_from_text
from exactmesh.paper import PAPER_CHOICES, paper_options
from exactmesh.planar.bounding_box import with_bounding_box
from exactmesh.planar.mesh import KINDS
from exactmesh.planar.pslg import Pslg
from exactmesh.progress import Progress
from exactmesh.proofs.prove import prove, summaries
from exactmesh.proofs.report import contradiction, proofs_json, summary_text
from exactmesh.report_ledger import bounds_json, bounds_text, entry_text, ledger_json, ledger_text
from exactmesh.reproduce.growth import laws
from exactmesh.reproduce.spread import spread_json, spread_rows, spread_text
from exactmesh.reproduce.table1 import MADE, Made, table1_rows
from exactmesh.reproduce.text import table1_csv, table1_json, table1_svg, table1_text
from exactmesh.search.commands import add_search_commands

HOLDS, FAILS, REFUSED, INTERRUPTED = 0, 1, 2, 130


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; return its exit status."""
    args = _parser().parse_args(argv)
    try:
        status: int = args.run(args)
        if sys.stdout is not None:  # None when the caller has closed it
            sys.stdout.flush()
        return status
    except InputError as error:
        if isinstance(error.__cause__, BrokenPipeError):
            _abandon_output()
            return FAILS
        print(f"exactmesh: {error}", file=sys.stderr)
        return REFUSED
    except ConstructionFailed as error:
        print(f"exactmesh: {error}\nThis is a counterexample to the construction: please report the input.",
              file=sys.stderr)
        return FAILS
    except KeyboardInterrupt:
        print("exactmesh: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _abandon_output()
        return FAILS
    except OSError as error:
        # Files are left to `exactmesh.io`, which raises `InputError`: this is standard output.
        _abandon_output()
        print(f"exactmesh: standard output: cannot be written: {error.strerror or error}", file=sys.stderr)
        return REFUSED


def _abandon_output() -> None:
    """Leave nothing for the interpreter to flush into a pipe without a reader, or onto a full disk."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="exactmesh", description="Triangulate polygons and planar straight-line graphs with exact numbers so that "
        "the minimum feature size (mfs) is kept up to a constant factor, and check every step.",
        epilog="Exit status: 0 all that was asked for holds, 1 a claim fails, 2 usage or input refused, 130 "
        "interrupted. A FILE is exactmesh-pslg/1, GeoJSON, WKT or Triangle's .poly; - is standard input.")
    parser.add_argument("--version", action="version", version=f"exactmesh {exactmesh.__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")

    for name, what in (("mfs", "minimum"), ("ifs", "internal")):
        command = commands.add_parser(name, help=f"the exact {what} feature size of a PSLG, with its witness")
        command.add_argument("file", metavar="FILE")
        _add_box(command)
        command.add_argument("--json", action="store_true", help="print one JSON object")
        _add_quiet(command)
        command.set_defaults(run=_size, name=name)

    command = commands.add_parser("mesh", help="triangulate a PSLG, checking every step and the result")
    command.add_argument("file", metavar="FILE")
    command.add_argument("-o", "--output", metavar="OUT", help="write the mesh (exactmesh-mesh/1)")
    command.add_argument("--kind", choices=KINDS, default="nonproper",
                         help="nonproper (default): vertices may lie on sides of triangles; proper: they may not; "
                         "internal: proper, with vertices on the boundary, keeps the internal feature size; "
                         "classic: no new vertices, no promise")
    command.add_argument("--optimal", action="store_true", help="the best classic mesh of one simple polygon")
    _add_construction(command, default=None)
    _add_box(command)
    command.add_argument("--report", metavar="R", help="write what was checked (exactmesh-report/1)")
    command.add_argument("--svg", metavar="S", help="write a picture")
    command.add_argument("--certificate", metavar="C", help="write what a checker needs (exactmesh-certificate/1)")
    command.add_argument("--pslg", metavar="P", help="write the input, box included, as exactmesh-pslg/1: the checkers "
                         "read no other format")
    _add_quiet(command)
    command.set_defaults(run=_mesh)

    command = commands.add_parser("verify", help="decide whether a mesh, from anywhere, is valid, and its degradation")
    command.add_argument("pslg", metavar="PSLG")
    command.add_argument("mesh", metavar="MESH", help="exactmesh-mesh/1")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    _add_box(command)
    command.add_argument("--max-degradation", metavar="D", help="also demand that the degradation is at most D")
    _add_quiet(command)
    command.set_defaults(run=_verify)

    command = commands.add_parser("check", help="check a mesh by its certificate, as the stand-alone checkers do")
    for name in ("PSLG", "MESH", "CERTIFICATE"):
        command.add_argument(name.lower(), metavar=name, help=f"exactmesh-{name.lower()}/1")
    command.add_argument("--random-part", metavar="K", type=_count, help="look at K random faces, edges and vertices "
                         "only: may find a fault, proves nothing")
    command.add_argument("--seed", metavar="N", type=_count, default=0, help="for --random-part (default: 0)")
    for name in check.DEFAULT._fields:
        command.add_argument(f"--max-{name}", metavar="N", type=_count, default=getattr(check.DEFAULT, name),
                             help=f"refuse a file with more {name} (default: %(default)s)")
    command.set_defaults(run=_check)

    command = commands.add_parser("claims", help="the ledger of claims, or one claim, or one judged on one input")
    command.add_argument("id", metavar="ID", nargs="?")
    on = command.add_mutually_exclusive_group()
    on.add_argument("--on", metavar="FILE", help="judge the claim on this input")
    on.add_argument("--witness", metavar="NAME", help="judge the claim on a witness that comes along")
    _add_construction(command, default=None)
    command.add_argument("--json", action="store_true", help="print one JSON object")
    _add_quiet(command)
    command.set_defaults(run=_claims)

    command = commands.add_parser("reproduce", help="tables of the paper, recomputed")
    command.add_argument("what", choices=("bounds", "dissection", "spread", "table1"),
                         help="bounds: the paper's numbers beside their exact values; dissection: the square to the "
                         "r x 1 rectangle, pieces beside the fewest there can be; spread: how the degradation of "
                         "both constructions grows with the length of a room; table1: the paper's Table 1, exact "
                         "degradations of all kinds of meshes on families of inputs")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.add_argument("-o", "--output", metavar="DIR", help="table1: also write table1.txt, .csv and .svg there")
    command.add_argument("--short", action="store_true", help="table1: inputs of up to some 500 vertices")
    command.add_argument("--kinds", metavar="KIND,..", type=_kinds, help=f"table1: only these of {', '.join(MADE)}")
    _add_quiet(command)
    command.set_defaults(run=_reproduce)

    command = commands.add_parser("dissect", help="cut polygons of equal area into pieces that make up each of them")
    command.add_argument("files", metavar="FILE", nargs="+", help="two polygons or more; they may have holes")
    command.add_argument("-o", "--output", metavar="PIECES", required=True,
                         help="write the pieces (exactmesh-dissection/1)")
    command.add_argument("--svg", metavar="S", help="write a picture of all polygons side by side")
    command.add_argument("--animation", metavar="A", help="write an SVG in which the pieces move from one to the next")
    command.add_argument("--cut-sheet", metavar="C", help="write an A4 page to print and cut, as SVG")
    command.add_argument("--scale", action="store_true",
                         help="scale all but the first to the area of the first, exactly")
    command.add_argument("--kind", choices=DISSECTION_KINDS,
                         help="the triangulation; without it those with the fewest strips, which carry the bound")
    _add_quiet(command)
    command.set_defaults(run=_dissect)

    command = commands.add_parser("verify-dissection",
                                  help="decide whether pieces, from anywhere, make up each polygon")
    command.add_argument("files", metavar="FILE", nargs="+", help="the polygons, two or more, in the pieces' order")
    command.add_argument("pieces", metavar="PIECES", help="exactmesh-dissection/1")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    _add_quiet(command)
    command.set_defaults(run=_verify_dissection)

    command = commands.add_parser("prove", help="run the proofs for all inputs, or re-check their certificates")
    command.add_argument("id", metavar="ID", nargs="*", help="a claim, a problem, or a file of them; none: all")
    command.add_argument("--fast", action="store_true", help="certificates only, by rational arithmetic")
    command.add_argument("--seconds", type=float, default=30, help="what z3 and cvc5 get for a problem (default: 30)")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    _add_quiet(command)
    command.set_defaults(run=_prove)

    command = commands.add_parser("examples", help="list the real outlines that come along, or write one")
    command.add_argument("name", metavar="NAME", nargs="?")
    command.add_argument("-o", "--output", metavar="OUT", default="-", help="where to write it (default: -)")
    command.set_defaults(run=_examples)
    add_search_commands(commands)
    return parser


def _make_folder(path: str) -> None:
    """Make a folder where there is none; raises `InputError`."""
    if path == "-":
        raise InputError("several files are written: -o needs a folder, not standard output")
    try:
        os.makedirs(path, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{printable(path)}: no folder can be made: {reason}") from error


def _add_quiet(command: argparse.ArgumentParser) -> None:
    command.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _add_construction(command: argparse.ArgumentParser, default: str | None) -> None:
    command.add_argument("--construction", choices=("repaired", "paper"), default=default,
                         help="the repaired construction, or the published one to the letter")
    command.add_argument("--paper", metavar="NAME=VALUE", action="append", default=[], type=_paper_option,
                         help="what the paper leaves open, for --construction paper: " + "; ".join(
                             f"{name}={'|'.join(values)}" for name, values in PAPER_CHOICES.items()))


def _add_box(command: argparse.ArgumentParser) -> None:
    command.add_argument("--bounding-box", metavar="MARGIN",
                         help="put the input into an upright rectangle this far away on every side: the outside "
                         "becomes part of the domain")


def _read(args: argparse.Namespace, path: str) -> Source:
    """Return the PSLG in a file, within a box where one is asked for."""
    source = read_pslg(path)
    if args.bounding_box is None:
        return source
    return replace(source, pslg=with_bounding_box(source.pslg, rational_from_text(args.bounding_box, "--bounding-box")))


def _paper_option(text: str) -> tuple[str, str]:
    name, _, value = text.partition("=")
    if value not in PAPER_CHOICES.get(name, ()):
        raise argparse.ArgumentTypeError(f"{text!r} is none of the choices")
    return name, value


def _count(text: str) -> int:
    if not (text.isdecimal() and text.isascii() and len(text) <= 9):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of at most nine digits")
    return int(text)


def _kinds(text: str) -> tuple[Made, ...]:
    names = text.split(",")
    if not set(names) <= set(MADE):
        raise argparse.ArgumentTypeError(f"{text!r}: choose from {', '.join(MADE)}, separated by commas")
    return tuple(kind for kind in MADE if kind in names)


def _size(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        progress("reading")
        pslg = _read(args, args.file).pslg
        progress(args.name)
        nearest = mfs(pslg) if args.name == "mfs" else ifs(pslg)
    print(report.size_json(args.name, nearest) if args.json else report.size_text(args.name, nearest))
    return HOLDS


def _mesh(args: argparse.Namespace) -> int:
    results = (args.output, args.report, args.svg, args.certificate, args.pslg)
    outputs = [path for path in results if path]
    if "" in results:
        raise InputError("the name of an output file is empty")
    if len(set(outputs)) < len(outputs):
        raise InputError("two results cannot go to one place: give each its own file")
    if args.optimal and args.kind != "classic":
        raise InputError("--optimal is for --kind classic")
    if args.certificate and not args.output:
        raise InputError("a certificate belongs to the file of a mesh: give -o as well")
    if args.certificate and args.kind == "internal":
        raise InputError("internal meshes split edges of the input: certificates are for the other kinds")
    if args.certificate and args.bounding_box is not None and not args.pslg:
        raise InputError("with --bounding-box a certificate needs --pslg P: the input in its box is written there")
    construction: ConstructionName = args.construction or construction_for(args.kind)
    with Progress(args.quiet) as progress:
        progress("reading")
        source = _read(args, args.file)
        pslg_data = b""
        if args.pslg:
            pslg_data = json_from_pslg(source.pslg).encode()
        elif args.certificate:
            pslg_data = pslg_bytes(args.file, source.sha256)
        options = paper_options(dict(args.paper))
        run = Run(source.pslg, construction, args.kind, options, progress, args.optimal)
        result = meshing_of(run)
        progress("writing")
        text = json_from_mesh(result.mesh)
        if args.output:
            write_text(args.output, text)
        if args.report:
            digest = hashlib.sha256(text.encode()).hexdigest()
            write_text(args.report, report.report_json(source.pslg, source.sha256, result, digest, construction))
        if args.svg:
            write_text(args.svg, svg_from_mesh(source.pslg, result.mesh, result.verification))
        if args.pslg:
            write_text(args.pslg, pslg_data.decode())
        if args.certificate and result.verification.valid:
            write_text(args.certificate, certificate_text(pslg_data, text.encode(), run.subdivision, result.mesh,
                                                          result.verification, progress))
    if args.certificate and not result.verification.valid:
        print("exactmesh: no certificate is written: the mesh is not valid", file=sys.stderr)
    if not args.quiet:
        # A summary never mixes with a result that goes to standard output.
        stream = sys.stderr if "-" in results else sys.stdout
        print(report.claims_text(result.judgements), report.verification_text(result.verification), sep="\n\n",
              file=stream)
    if not result.holds:
        print(report.failures_text(result.judgements), file=sys.stderr)
    return HOLDS if result.holds else FAILS


def _verify(args: argparse.Namespace) -> int:
    bound = None
    if args.max_degradation is not None:
        bound = rational_from_text(args.max_degradation, "--max-degradation")
    if args.pslg == args.mesh == "-":
        raise InputError("PSLG and MESH cannot both be standard input")
    with Progress(args.quiet) as progress:
        progress("reading")
        pslg, candidate = _read(args, args.pslg).pslg, read_mesh(args.mesh).mesh
        progress("verification")
        verification = verify(pslg, candidate)
    print(report.verification_json(verification) if args.json else report.verification_text(verification))
    if not verification.valid:
        return FAILS
    degradation = verification.degradation_squared
    if bound is not None and degradation is not None and (bound < 0 or degradation > bound * bound):
        print(f"exactmesh: the degradation is above {decimal_text(bound)}", file=sys.stderr)
        return FAILS
    return HOLDS


def _check(args: argparse.Namespace) -> int:
    if args.random_part is not None:
        valid, line = check_part(args.pslg, args.mesh, args.certificate, args.random_part, args.seed)
        print(line)
        return HOLDS if valid else FAILS
    limits = [text for name in check.DEFAULT._fields for text in (f"--max-{name}", str(getattr(args, f"max_{name}")))]
    return check.main([*limits, "--", args.pslg, args.mesh, args.certificate])


def _claims(args: argparse.Namespace) -> int:
    if args.id is None and (args.on or args.witness):
        raise InputError("which claim is to be judged? give its ID")
    chosen = CLAIMS if args.id is None else (claim_by_id(args.id),)
    with Progress(args.quiet) as progress:
        if not args.on and not args.witness:
            entries = ledger(chosen, progress)
            if args.json:
                print(ledger_json(entries))
            else:
                print(ledger_text(entries) if args.id is None else entry_text(entries[0]))
            return HOLDS
        claim = chosen[0]
        pslg = read_pslg(args.on or str(WITNESSES.path(args.witness))).pslg
        construction: ConstructionName = args.construction or (claim.runs or ("repaired",))[0]
        judgement = judge_one(claim, Run(pslg, construction, claim.kinds[0], paper_options(dict(args.paper)), progress))
    print(json.dumps(report.claim_json(claim, judgement.verdict)) if args.json else report.claims_text([judgement]))
    if not judgement.verdict.holds:
        print(report.failures_text([judgement]), file=sys.stderr)
    return HOLDS if judgement.verdict.holds else FAILS


def _reproduce(args: argparse.Namespace) -> int:
    if args.what == "table1":
        return _reproduce_table1(args)
    if args.output or args.short or args.kinds:
        raise InputError("-o, --short and --kinds are for table1")
    if args.what == "spread":
        with Progress(args.quiet) as progress:
            rooms = list(spread_rows(progress))
        print(spread_json(rooms) if args.json else spread_text(rooms))
        return HOLDS
    if args.what == "dissection":
        with Progress(args.quiet) as progress:
            made = list(rectangle_rows(progress=progress))
        print(rectangles_json(made) if args.json else rectangles_text(made))
        return HOLDS if all(row.valid for row in made) else FAILS
    rows = list(bounds())
    print(bounds_json(rows) if args.json else bounds_text(rows))
    return HOLDS


def _reproduce_table1(args: argparse.Namespace) -> int:
    if args.output:
        _make_folder(args.output)  # before the work: it may be refused
    with Progress(args.quiet) as progress:
        rows = list(table1_rows(args.kinds or MADE, args.short, progress))
    found = laws(rows)
    if args.output:
        texts = {"txt": table1_text(rows, found) + "\n", "csv": table1_csv(rows), "svg": table1_svg(rows)}
        for ending, text in texts.items():
            write_text(os.path.join(args.output, f"table1.{ending}"), text)
    print(table1_json(rows, found) if args.json else table1_text(rows, found))
    failures = [failure for law in found for failure in law.failures]
    if failures:
        print("\n".join(failures), file=sys.stderr)
    return FAILS if failures else HOLDS


def _prove(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        results = list(prove(args.id, args.fast, args.seconds, progress))
    print(proofs_json(results) if args.json else summary_text(summaries(results), results))
    return FAILS if contradiction(results) else HOLDS


def _dissect(args: argparse.Namespace) -> int:
    drawings = ((args.svg, svg_from_dissection), (args.animation, animation_from_dissection),
                (args.cut_sheet, cut_sheet_from_dissection))
    outputs = [args.output, *(path for path, _ in drawings if path is not None)]
    if "" in outputs:
        raise InputError("the name of an output file is empty")
    if len(set(outputs)) < len(outputs):
        raise InputError("two results cannot go to one place: give each its own file")
    with Progress(args.quiet) as progress:
        progress("reading")
        result = dissect(_polygons(args.files), args.scale, args.kind, progress)
        progress("writing")
        write_text(args.output, json_from_dissection(result.dissection))
        for path, drawing in drawings:
            if path is not None:
                write_text(path, drawing(result.dissection))
    if not args.quiet:
        print(dissected_text(result), file=sys.stderr if "-" in outputs else sys.stdout)
    return HOLDS


def _verify_dissection(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        progress("reading")
        polygons = _polygons(args.files, args.pieces)
        pieces = read_dissection(args.pieces)
        verdict = verify_dissection(polygons, pieces, progress)
    print(verdict_json(verdict) if args.json else verdict_text(verdict))
    return HOLDS if verdict.valid else FAILS


def _polygons(paths: Sequence[str], *others: str) -> list[Pslg]:
    """Return the PSLGs in files; raises `InputError` when there is one only, or standard input is named twice."""
    if len(paths) < 2:
        raise InputError("a dissection is of two polygons or more")
    if [*paths, *others].count("-") > 1:
        raise InputError("standard input can be read once only")
    return [read_pslg(path).pslg for path in paths]


def _examples(args: argparse.Namespace) -> int:
    if args.name is None:
        print("\n".join(EXAMPLES.names()))
    else:
        write_text(args.output, EXAMPLES.path(args.name).read_text(encoding="utf-8"))
    return HOLDS
