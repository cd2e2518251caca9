"""The command `hits`."""

import argparse
import json
from collections.abc import Callable
from typing import Any

from exactmesh.commands.exit_status import HOLDS
from exactmesh.commands.options import Subparsers
from exactmesh.io.atomic import write_text
from exactmesh.search import show
from exactmesh.search.store import Store


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("hits", help="list, filter and export what searches have found")
    command.add_argument("store", metavar="FILE")
    command.add_argument("--claim", metavar="ID", help="only finds of this claim or objective")
    command.add_argument("--construction", choices=("repaired", "paper", "classic", "coarse"))
    command.add_argument("--label", choices=("violation", "record", "crash"))
    command.add_argument("--max-points", type=int, metavar="N")
    command.add_argument("--confirmed", action="store_true", help="only what the independent check agrees with")
    command.add_argument("--json", action="store_true", help="print one JSON object a line")
    command.add_argument("--html", metavar="OUT", help="write a page with pictures")
    command.add_argument("--export", metavar="DIR", help="write files and pictures; print the commands that show them")
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    with Store(args.store, create=False) as store:
        finds = [find for find in store.finds() if _wanted(find, args)]
    if args.html:
        write_text(args.html, show.html_page(finds, "What searches have found"))
    if args.export:
        print("\n".join(show.export(finds, args.export)))
    elif args.json:
        for find in finds:
            print(json.dumps(show.find_record(find)))
    elif args.html != "-":
        print(show.finds_text(finds))
    return HOLDS


def _wanted(find: Any, args: argparse.Namespace) -> bool:
    filters: tuple[Callable[[], bool], ...] = (
        lambda: args.claim in (None, find["claim"]), lambda: args.construction in (None, find["construction"]),
        lambda: args.label in (None, find["label"]), lambda: bool(find["confirmed"]) or not args.confirmed,
        lambda: args.max_points is None or len(show.figure_of(find).points) <= args.max_points)
    return all(check() for check in filters)
