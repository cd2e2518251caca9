"""Where tasks are done: in this process, in some processes of this machine, or on a dask.distributed cluster.

An engine takes tasks one by one and yields reports as they come, in any order. After the deadline it hands out nothing
more and waits for what is at work. What is at work when it is stopped (interrupt, death) is lost and will be done again
by a run that resumes. A worker that dies takes
its task with it, which is handed out again; a task that kills its workers `_ATTEMPTS` times raises `TaskLost`.
"""

import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Iterator
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from importlib import import_module
from typing import Any, Protocol
from uuid import uuid4

from exactmesh.errors import InputError
from exactmesh.search.collect import Json
from exactmesh.search.spec import Task
from exactmesh.search.work import run_task

_ATTEMPTS = 4
_POLL = 0.5


class TaskLost(InputError):
    """A task took all its workers with it; `task` names it. What was done is stored."""

    def __init__(self, task: str) -> None:
        super().__init__(f"the worker of task {task} died {_ATTEMPTS} times")
        self.task = task


class Engine(Protocol):
    """Does the tasks of one run until they are done or the deadline, a time of `time.monotonic`, has passed.

    Yields None now and then while there is nothing to report, so that the caller keeps control.
    """

    def reports(self, spec: str, tasks: Iterator[Task], deadline: float | None) -> Iterator[Json | None]: ...


class Serial:
    """One task after the other, in this process."""

    def reports(self, spec: str, tasks: Iterator[Task], deadline: float | None) -> Iterator[Json | None]:
        for task in tasks:
            if _is_over(deadline):
                return
            yield run_task(spec, task.key, task.payload)


class Processes:
    """Some processes of this machine."""

    def __init__(self, count: int) -> None:
        self.count = count

    def reports(self, spec: str, tasks: Iterator[Task], deadline: float | None) -> Iterator[Json | None]:
        pool = self._pool()
        work: dict[Future[Json], tuple[Task, int]] = {}
        again: list[tuple[Task, int]] = []
        try:
            while True:
                while not _is_over(deadline) and len(work) < 2 * self.count and (
                        entry := again.pop() if again else _next(tasks)):
                    try:
                        work[pool.submit(run_task, spec, *entry[0])] = entry
                    except BrokenProcessPool:
                        again.append(entry)
                        break
                if not work and (not again or _is_over(deadline)):
                    return
                done = wait(work, _POLL, FIRST_COMPLETED).done
                for future in done:
                    if isinstance(future.exception(), BrokenProcessPool):
                        again.append(_another(*work.pop(future)))
                    else:
                        work.pop(future)
                        yield future.result()
                if again:
                    again += [_another(*entry) for entry in work.values()]
                    work.clear()
                    pool.shutdown(wait=False, cancel_futures=True)
                    pool = self._pool()
                if not done:
                    yield None
        finally:
            mine = list((getattr(pool, "_processes", None) or {}).values())
            pool.shutdown(wait=False, cancel_futures=True)
            for process in mine:
                process.terminate()

    def _pool(self) -> ProcessPoolExecutor:
        return ProcessPoolExecutor(self.count, multiprocessing.get_context("spawn"), _follow_parent)


class Cluster:
    """A dask.distributed cluster that is running; its workers have exactmesh installed, and may come, leave and die."""

    def __init__(self, address: str) -> None:
        try:
            self.library: Any = import_module("distributed")
        except ImportError as error:
            raise InputError("--scheduler needs dask.distributed: pip install 'exactmesh[cluster]'") from error
        try:
            self.client: Any = self.library.Client(address, timeout=20, set_as_default=False)
        except (OSError, ValueError) as error:
            raise InputError(f"no scheduler answers at {address}: {error}") from error

    def reports(self, spec: str, tasks: Iterator[Task], deadline: float | None) -> Iterator[Json | None]:
        died = (self.library.scheduler.KilledWorker, CancelledError)
        run = uuid4().hex
        work: dict[Any, tuple[Task, int]] = {}
        again: list[tuple[Task, int]] = []
        try:
            while True:
                window = max(8, 3 * sum(self.client.nthreads().values()))
                while not _is_over(deadline) and len(work) < window and (
                        entry := again.pop() if again else _next(tasks)):
                    name = f"exactmesh-{run}-{entry[0].key}-{entry[1]}"
                    work[self.client.submit(run_task, spec, *entry[0], key=name, pure=False)] = entry
                if not work:
                    return
                try:
                    with self.client.as_current():
                        self.library.wait(list(work), timeout=_POLL, return_when="FIRST_COMPLETED")
                except TimeoutError:
                    yield None
                for future in [future for future in work if future.done()]:
                    entry = work.pop(future)
                    try:
                        report: Json = future.result()
                    except OSError as error:
                        raise InputError(f"the cluster is gone ({error}); --resume goes on") from error
                    except died:
                        again.append(_another(*entry))
                        continue
                    future.release()
                    yield report
        finally:
            self.client.cancel(list(work))
            self.client.close()


def engine_of(jobs: int, scheduler: str | None) -> Engine:
    """Return the engine asked for; raises `InputError` when it cannot be had."""
    if scheduler:
        return Cluster(scheduler)
    if jobs < 1:
        raise InputError(f"--jobs needs a positive number, not {jobs}")
    return Serial() if jobs == 1 else Processes(jobs)


def _is_over(deadline: float | None) -> bool:
    return deadline is not None and time.monotonic() >= deadline


def _next(tasks: Iterator[Task]) -> tuple[Task, int] | None:
    task = next(tasks, None)
    return None if task is None else (task, 0)


def _another(task: Task, attempt: int) -> tuple[Task, int]:
    if attempt + 1 >= _ATTEMPTS:
        raise TaskLost(task.key)
    return task, attempt + 1


def _follow_parent() -> None:
    """Leave Ctrl-C to the parent, which stops the workers; end when the parent is gone, however it went."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_end_with_parent, daemon=True).start()


def _end_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
        os._exit(1)
