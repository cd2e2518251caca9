"""The command `reproduce`: a sub-command for each thing."""

import argparse
import os
import sys
from collections.abc import Callable

from exactmesh.claims.bounds import bounds
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.options import Subparsers, add_quiet, make_folder
from exactmesh.dissection.lower_bound import rectangle_rows, rectangles_json, rectangles_text
from exactmesh.io.atomic import write_text
from exactmesh.progress import Progress
from exactmesh.report_ledger import bounds_json, bounds_text
from exactmesh.reproduce.growth import laws
from exactmesh.reproduce.peers import peer_rows
from exactmesh.reproduce.peers_text import peers_csv, peers_json, peers_text
from exactmesh.reproduce.spread import spread_json, spread_rows, spread_text
from exactmesh.reproduce.table1 import MADE, Made, table1_rows
from exactmesh.reproduce.text import table1_csv, table1_json, table1_svg, table1_text


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("reproduce", help="tables and figures of the paper, recomputed")
    things = command.add_subparsers(required=True, metavar="WHAT")
    _add_thing(things, "bounds", "the paper's numbers beside their exact values", _bounds)
    _add_thing(things, "dissection", "the square to the r x 1 rectangle, pieces beside the fewest there can be",
               _dissection)
    _add_thing(things, "spread", "how the degradation of both constructions grows with the length of a room", _spread)
    table1 = _add_thing(things, "table1", "the paper's Table 1, exact degradations of all kinds of meshes on families "
                        "of inputs", _table1)
    table1.add_argument("-o", "--output", metavar="DIR", help="also write table1.txt, .csv and .svg there")
    table1.add_argument("--short", action="store_true", help="inputs of up to some 500 vertices")
    table1.add_argument("--kinds", metavar="KIND,..", type=_kinds, help=f"only these of {', '.join(MADE)}")
    peers = _add_thing(things, "peers", "other meshers beside this one on the same inputs, their meshes measured "
                       "exactly", _peers)
    peers.add_argument("-o", "--output", metavar="DIR", help="also write peers.txt, .csv and .json there")
    peers.add_argument("--short", action="store_true", help="fewer and smaller inputs")
    drawn = _add_thing(things, "figures", "the paper's figures from real runs, and companions where they fail",
                       _figures)
    drawn.add_argument("-o", "--output", metavar="DIR", required=True,
                       help="write NAME.svg, figures.json (captions, commands, hashes) and the inputs there")
    drawn.add_argument("--only", metavar="NAME,..", help="only these, such as fig-02,fig-02-fails")
    everything = _add_thing(things, "all", "every table and figure, in one page", _all)
    everything.add_argument("-o", "--output", metavar="DIR", required=True,
                            help="write report.html, which needs no other file, and report.json there")
    everything.add_argument("--short", action="store_true", help="without large inputs: some minutes at most")


def _add_thing(things: Subparsers, name: str, what: str, run: Callable[[argparse.Namespace], int]
               ) -> argparse.ArgumentParser:
    thing = things.add_parser(name, help=what)
    thing.add_argument("--json", action="store_true", help="print one JSON object")
    add_quiet(thing)
    thing.set_defaults(run=run)
    return thing


def _bounds(args: argparse.Namespace) -> int:
    rows = list(bounds())
    print(bounds_json(rows) if args.json else bounds_text(rows))
    return HOLDS


def _dissection(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        made = list(rectangle_rows(progress=progress))
    print(rectangles_json(made) if args.json else rectangles_text(made))
    return HOLDS if all(row.valid for row in made) else FAILS


def _spread(args: argparse.Namespace) -> int:
    with Progress(args.quiet) as progress:
        rooms = list(spread_rows(progress))
    print(spread_json(rooms) if args.json else spread_text(rooms))
    return HOLDS


def _table1(args: argparse.Namespace) -> int:
    if args.output:
        make_folder(args.output)  # before the work: it may be refused
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


def _figures(args: argparse.Namespace) -> int:
    from exactmesh.reproduce.figures import FIGURES, figures, figures_json, figures_text, write_figures

    make_folder(args.output)
    with Progress(args.quiet) as progress:
        found = list(figures(args.only.split(",") if args.only else FIGURES, progress))
        write_figures(found, args.output)
    if args.json or not args.quiet:
        print(figures_json(found) if args.json else figures_text(found))
    return HOLDS


def _all(args: argparse.Namespace) -> int:
    from exactmesh.reproduce.everything import report_json, report_page, sections

    make_folder(args.output)
    with Progress(args.quiet) as progress:
        found = list(sections(args.short, progress))
    path = os.path.join(args.output, "report.html")
    write_text(path, report_page(found))
    text = report_json(found)
    write_text(os.path.join(args.output, "report.json"), text)
    failing = [section.anchor for section in found if section.holds is False]
    if args.json:
        print(text, end="")
    elif not args.quiet:
        print(f"{path}: {len(found)} results, {f'failing: {chr(44).join(failing)}' if failing else 'no check fails'}")
    return FAILS if failing else HOLDS


def _peers(args: argparse.Namespace) -> int:
    if args.output:
        make_folder(args.output)
    with Progress(args.quiet) as progress:
        rows = list(peer_rows(args.short, progress))
    if args.output:
        for ending, text in {"txt": peers_text(rows) + "\n", "csv": peers_csv(rows), "json": peers_json(rows)}.items():
            write_text(os.path.join(args.output, f"peers.{ending}"), text)
    print(peers_json(rows) if args.json else peers_text(rows))
    return HOLDS


def _kinds(text: str) -> tuple[Made, ...]:
    names = text.split(",")
    if not set(names) <= set(MADE):
        raise argparse.ArgumentTypeError(f"{text!r}: choose from {', '.join(MADE)}, separated by commas")
    return tuple(kind for kind in MADE if kind in names)
