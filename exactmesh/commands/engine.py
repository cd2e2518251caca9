"""What `search` and `verify-run` share: where they run, and where results are kept."""

import argparse
import sys
import time
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, version
from itertools import islice

from exactmesh.commands.options import positive
from exactmesh.progress import Progress
from exactmesh.search import show
from exactmesh.search.driver import keep_records, run_tasks
from exactmesh.search.engine import engine_of
from exactmesh.search.spec import Spec, Task
from exactmesh.search.store import Store


def add_engine(command: argparse.ArgumentParser) -> None:
    """Add where tasks run, where results are kept, and what ends a run before its end."""
    command.add_argument("--store", metavar="FILE", required=True, help="where results are kept (SQLite)")
    command.add_argument("--resume", action="store_true", help="go on with a run that is in the store")
    command.add_argument("--time-limit", metavar="SECONDS", type=positive, help="hand out no task after this time")
    command.add_argument("--tasks", metavar="N", type=positive, help="no more than the first N tasks")
    where = command.add_mutually_exclusive_group()
    where.add_argument("--jobs", metavar="N", type=positive, default=1, help="processes (default: 1)")
    where.add_argument("--scheduler", metavar="ADDRESS", help="a dask.distributed scheduler: tcp://host:port")
    command.add_argument("--quiet", action="store_true", help="no progress and no summary")


def run_search(args: argparse.Namespace, store: Store, spec: Spec, tasks: Iterator[Task], stop: bool) -> int:
    """Do a run as far as time and tasks allow; return its id."""
    run = store.open_run(spec.to_json(), _version(), show.command_of(spec), args.resume)
    engine = engine_of(args.jobs, args.scheduler)
    deadline = None if args.time_limit is None else time.monotonic() + args.time_limit
    try:
        with Progress(args.quiet) as progress:
            limited: Iterator[Task] = tasks if args.tasks is None else islice(tasks, args.tasks)
            run_tasks(store, run, spec, limited, engine, deadline, progress, stop)
            if spec.shrinks:
                progress("shrinking and checking the worst")
                keep_records(store, run)
    except KeyboardInterrupt:
        print("exactmesh: what is done is stored; --resume goes on from there", file=sys.stderr)
        raise
    return run


def _version() -> str:
    try:
        return version("exactmesh")
    except PackageNotFoundError:
        return "unknown"
