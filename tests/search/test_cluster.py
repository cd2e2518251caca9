"""A search on a dask.distributed cluster of real processes, one of which is killed while it works."""

import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

import pytest

from exactmesh.cli import main
from exactmesh.search.store import Store

distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed (extra `cluster`)")

TASKS = 40
# Patience for machines that do much else; nothing waits that long on an idle one.
PATIENCE = 180


def contents(path: Path) -> tuple[list[dict[str, object]], set[tuple[object, ...]]]:
    with Store(str(path)) as store:
        [run] = store.runs()
        finds = {(find["claim"], find["figure"], find["exact"], find["confirmed"]) for find in store.finds()}
        return list(store.results(run["id"])), finds


def arguments(store: Path, *more: str) -> list[str]:
    return ["search", "offset-edge-length", "--strategy", "random", "--family", "triangle", "--size", "60", "--tasks",
            str(TASKS), "--quiet", "--store", str(store), *more]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def test_a_cluster_that_loses_a_worker_finds_what_one_process_finds(tmp_path: Path) -> None:
    port = free_port()
    address = f"tcp://127.0.0.1:{port}"
    started: list[subprocess.Popen[bytes]] = []

    def start(*command: str) -> "subprocess.Popen[bytes]":
        process = subprocess.Popen([sys.executable, "-m", *command], cwd=tmp_path, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        started.append(process)
        return process

    try:
        start("distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", str(port), "--no-dashboard")
        workers = [start("distributed.cli.dask_worker", address, "--no-nanny", "--nthreads", "1", "--no-dashboard",
                         "--host", "127.0.0.1", "--death-timeout", str(PATIENCE)) for _ in range(3)]
        with distributed.Client(address, set_as_default=False, timeout=PATIENCE) as client:
            client.wait_for_workers(3, timeout=PATIENCE)
            cluster = tmp_path / "cluster.db"
            run = start("exactmesh", *arguments(cluster, "--scheduler", address))
            deadline = time.monotonic() + PATIENCE
            while time.monotonic() < deadline and done(cluster) <= 3 and run.poll() is None:
                time.sleep(0.02)
            done_before = done(cluster)
            workers[0].send_signal(signal.SIGKILL)
            assert 3 < done_before < TASKS  # it was killed while there was work
            assert run.wait(PATIENCE) == 0
            assert len(client.scheduler_info()["workers"]) == 2
    finally:
        for process in started:
            process.kill()
            process.wait()
    assert main(arguments(tmp_path / "alone.db")) == 0
    assert contents(cluster) == contents(tmp_path / "alone.db")
    assert done(cluster) == TASKS and contents(cluster)[1]


def test_no_scheduler_is_an_input_error(tmp_path: Path) -> None:
    assert main(arguments(tmp_path / "s.db", "--scheduler", "no-scheme://nowhere")) == 2


def done(path: Path) -> int:
    if not path.exists():
        return 0
    with Store(str(path)) as store:
        return sum(1 for run in store.runs() for _ in store.results(run["id"]))
