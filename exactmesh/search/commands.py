"""The sub-commands `search`, `hits` and `verify-run`: arguments in, exit status out."""

import argparse
import json
import sys
import time
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, version
from itertools import islice
from typing import Any

from exactmesh.io.atomic import write_text
from exactmesh.planar.mesh import KINDS
from exactmesh.progress import Progress
from exactmesh.search import show
from exactmesh.search.driver import add_row, keep_records, run_tasks, totals, worst_text
from exactmesh.search.engine import engine_of
from exactmesh.search.guided import require_hypothesis
from exactmesh.search.spec import STRATEGIES, Spec, Task, search_tasks
from exactmesh.search.store import Store
from exactmesh.search.targets import OBJECTIVES, target_of
from exactmesh.search.verify_run import chosen_targets, family_spec, input_tasks, parsed_family

_HOLDS, _FAILS, _REFUSED = 0, 1, 2


def add_search_commands(commands: Any) -> None:
    """Add the three sub-commands to a parser's."""
    command = commands.add_parser("search", help="search for a polygon on which a claim fails or comes closest")
    command.add_argument("claim", metavar="CLAIM", help=f"a claim, or an objective: {', '.join(OBJECTIVES)}")
    command.add_argument("--construction", choices=("repaired", "paper", "classic"))
    command.add_argument("--kind", choices=KINDS)
    command.add_argument("--strategy", choices=[name for name in STRATEGIES if name != "inputs"], default="climb",
                         help="exhaustive: all lattice polygons; random: a family; climb, anneal: local search from "
                         "random starts; guided: hypothesis' target (default: climb)")
    command.add_argument("--family", metavar="NAME[:KEY=N,..]", default="stretched",
                         help="lattice:n=4,m=3, triangle, tour, star, orthogonal, stretched, near-degenerate, flat, or "
                         "path.py:function (default: stretched)")
    command.add_argument("--seed", type=int, default=0)
    command.add_argument("--size", type=_positive, default=0, help="polygons, steps or examples of a task")
    command.add_argument("--shard", metavar="RES/MOD", type=_shard, default=(0, 1), help="only these tasks")
    command.add_argument("--stop-at-first", action="store_true", help="stop when the claim fails")
    command.add_argument("--export", metavar="DIR", help="write the finds of the store there as files and pictures")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    _add_engine(command)
    command.set_defaults(run=_search)

    command = commands.add_parser("hits", help="list, filter and export what searches have found")
    command.add_argument("store", metavar="FILE")
    command.add_argument("--claim", metavar="ID", help="only finds of this claim or objective")
    command.add_argument("--construction", choices=("repaired", "paper", "classic"))
    command.add_argument("--label", choices=("violation", "record", "crash"))
    command.add_argument("--max-corners", type=int, metavar="N")
    command.add_argument("--confirmed", action="store_true", help="only what the independent check agrees with")
    command.add_argument("--json", action="store_true", help="print one JSON object a line")
    command.add_argument("--html", metavar="OUT", help="write a page with pictures")
    command.add_argument("--export", metavar="DIR", help="write files and pictures; print the commands that show them")
    command.set_defaults(run=_hits)

    command = commands.add_parser("verify-run", help="judge many claims on many inputs, with a store and a report")
    command.add_argument("inputs", metavar="INPUT", nargs="+",
                         help="a file, a folder, a .jsonl file of one polygon a line, or family:NAME[:KEY=N,..]")
    command.add_argument("--claims", metavar="ID,..", default="all", help="claims and objectives (default: all)")
    command.add_argument("--construction", choices=("repaired", "paper", "both"), default="repaired")
    command.add_argument("--kind", choices=KINDS)
    command.add_argument("--count", type=_positive, default=1000, help="polygons of each random family (default: 1000)")
    command.add_argument("--seed", type=int, default=0)
    command.add_argument("--report", metavar="OUT", help="write the report as JSON")
    command.add_argument("--html", metavar="OUT", help="write the report as a page")
    command.add_argument("--json", action="store_true", help="print the report as JSON")
    _add_engine(command)
    command.set_defaults(run=_verify_run)


def _add_engine(command: argparse.ArgumentParser) -> None:
    command.add_argument("--store", metavar="FILE", required=True, help="where results are kept (SQLite)")
    command.add_argument("--resume", action="store_true", help="go on with a run that is in the store")
    command.add_argument("--time-limit", metavar="SECONDS", type=_positive, help="hand out no task after this time")
    command.add_argument("--tasks", metavar="N", type=_positive, help="no more than the first N tasks")
    where = command.add_mutually_exclusive_group()
    where.add_argument("--jobs", metavar="N", type=_positive, default=1, help="processes (default: 1)")
    where.add_argument("--scheduler", metavar="ADDRESS", help="a dask.distributed scheduler: tcp://host:port")
    command.add_argument("--quiet", action="store_true", help="no progress and no summary")


def _search(args: argparse.Namespace) -> int:
    target = target_of(args.claim, args.construction, args.kind)
    if args.strategy == "guided":
        require_hypothesis()
    family, parameters, plugin = parsed_family(args.family)
    spec = Spec((target.key,), args.strategy, family, parameters, plugin, args.seed, args.size, args.shard).checked()
    with Store(args.store) as store:
        run = _run(args, store, spec, search_tasks(spec), args.stop_at_first)
        found = totals(store, run)[target.key] if totals(store, run) else None
        finds = [find for find in store.finds() if (find["claim"], find["construction"], find["kind"]) == target.key]
        commands = show.export(finds, args.export) if args.export else []
        evaluated = store.evaluated(run)
    fails = any(find["label"] == "violation" and find["confirmed"] for find in finds)
    if args.json:
        print(json.dumps({"claim": target.claim.id, "construction": target.construction, "kind": target.kind,
                          "polygons": evaluated, "violations": found.violations if found else 0,
                          "instances": found.instances if found else 0,
                          "worst": json.loads(found.worst["shown"]).get("worst") if found and found.worst else None,
                          "finds": [show.find_record(find) for find in finds]}, indent=1))
    elif not args.quiet:
        print(f"{target.claim.id} ({target.construction}, {target.kind}): {evaluated} polygons in this run, "
              f"{found.violations if found else 0} violations, worst {worst_text(found.worst if found else None)}")
        if finds:
            print(show.finds_text(finds))
        print("\n".join(commands), end="\n" if commands else "")
    return _FAILS if fails else _HOLDS


def _hits(args: argparse.Namespace) -> int:
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
    return _HOLDS


def _verify_run(args: argparse.Namespace) -> int:
    targets = chosen_targets(args.claims, args.construction, args.kind)
    families = [name.removeprefix("family:") for name in args.inputs if name.startswith("family:")]
    files = [name for name in args.inputs if not name.startswith("family:")]
    refused: list[str] = []
    runs: list[tuple[Spec, Iterator[Task]]] = []
    if files:
        spec = Spec(targets, "inputs", json.dumps(sorted(files)), shrinks=False).checked()
        runs.append((spec, input_tasks(files, refused)))
    for family in families:
        spec = family_spec(family, targets, args.seed, 50)
        tasks = search_tasks(spec)
        runs.append((spec, tasks if spec.strategy == "exhaustive" else islice(tasks, -(-args.count // spec.size))))
    rows: dict[tuple[str, str, str], Any] = {}
    with Store(args.store) as store:
        for spec, tasks in runs:
            run = _run(args, store, spec, tasks, False)
            for row in store.results(run):
                add_row(rows, row)
    record = show.verification_record(rows, refused)
    if args.report:
        write_text(args.report, json.dumps(record, indent=1) + "\n")
    if args.html:
        write_text(args.html, show.verification_html(rows, refused))
    if args.json:
        print(json.dumps(record, indent=1))
    elif not args.quiet:
        print(show.verification_text(rows, refused))
    if any(total.violations or total.crashes for total in rows.values()):
        return _FAILS
    return _REFUSED if refused else _HOLDS


def _run(args: argparse.Namespace, store: Store, spec: Spec, tasks: Iterator[Task], stop: bool) -> int:
    """Do a run as far as time and tasks allow; return its id."""
    run = store.open_run(spec.to_json(), _version(), show.command_of(spec), args.resume)
    engine = engine_of(args.jobs, args.scheduler)
    deadline = None if args.time_limit is None else time.monotonic() + args.time_limit
    try:
        with Progress(args.quiet) as progress:
            limited: Iterator[Task] = tasks if args.tasks is None else islice(tasks, args.tasks)
            run_tasks(store, run, spec, limited, engine, deadline, progress, stop)
            if spec.strategy != "inputs" and spec.shrinks:
                progress("shrinking and checking the worst")
                keep_records(store, run)
    except KeyboardInterrupt:
        print("exactmesh: what is done is stored; --resume goes on from there", file=sys.stderr)
        raise
    return run


def _wanted(find: Any, args: argparse.Namespace) -> bool:
    filters: tuple[Callable[[], bool], ...] = (
        lambda: args.claim in (None, find["claim"]), lambda: args.construction in (None, find["construction"]),
        lambda: args.label in (None, find["label"]), lambda: bool(find["confirmed"]) or not args.confirmed,
        lambda: args.max_corners is None or len(json.loads(find["corners"])) <= args.max_corners)
    return all(check() for check in filters)


def _positive(text: str) -> int:
    if not text.isdecimal() or len(text) > 9 or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive whole number")
    return int(text)


def _shard(text: str) -> tuple[int, int]:
    residue, _, modulus = text.partition("/")
    if not (residue.isdecimal() and modulus.isdecimal() and int(residue) < int(modulus)):
        raise argparse.ArgumentTypeError(f"{text!r} is not RES/MOD with RES < MOD")
    return int(residue), int(modulus)


def _version() -> str:
    try:
        return version("exactmesh")
    except PackageNotFoundError:
        return "unknown"
