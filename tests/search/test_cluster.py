"""A search on a dask.distributed cluster of real processes, one of which is killed while it works."""

import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from exactmesh.cli import main
from exactmesh.search.store import Store

distributed = pytest.importorskip("distributed", reason="dask.distributed is not installed (extra `cluster`)")


def contents(path: Path) -> tuple[list[dict[str, object]], set[tuple[object, ...]]]:
    with Store(str(path)) as store:
        [run] = store.runs()
        finds = {(find["claim"], find["figure"], find["exact"], find["confirmed"]) for find in store.finds()}
        return list(store.results(run["id"])), finds


def search(store: Path, *more: str) -> int:
    return main(["search", "section-2.p5-feature-size", "--strategy", "random", "--family", "tour:n=5", "--size", "6",
                 "--tasks", "60", "--quiet", "--store", str(store), *more])


def test_a_cluster_that_loses_a_worker_finds_what_one_process_finds(tmp_path: Path) -> None:
    address_file = tmp_path / "scheduler.json"
    base = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--host", "127.0.0.1", "--port", "0",
            "--no-dashboard", "--scheduler-file", str(address_file)]
    started: list[subprocess.Popen[bytes]] = []

    def start(command: list[str]) -> "subprocess.Popen[bytes]":
        process = subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        started.append(process)
        return process

    try:
        start(base)
        deadline = time.monotonic() + 30
        while not address_file.exists() and time.monotonic() < deadline:
            time.sleep(0.1)
        workers = [start([sys.executable, "-m", "distributed.cli.dask_worker", "--scheduler-file", str(address_file),
                          "--no-nanny", "--nthreads", "1", "--no-dashboard", "--host", "127.0.0.1"]) for _ in range(3)]
        client = distributed.Client(scheduler_file=str(address_file), set_as_default=False)
        client.wait_for_workers(3, timeout=30)
        address = client.scheduler.address
        cluster = tmp_path / "cluster.db"
        run = start([sys.executable, "-m", "exactmesh", "search", "section-2.p5-feature-size", "--strategy", "random",
                     "--family", "tour:n=5", "--size", "6", "--tasks", "60", "--quiet", "--store", str(cluster),
                     "--scheduler", address])
        while time.monotonic() < deadline + 30 and not (cluster.exists() and _tasks(cluster) > 3):
            time.sleep(0.05)
        done_before = _tasks(cluster)
        workers[0].send_signal(signal.SIGKILL)
        assert 3 < done_before < 60  # it was killed while there was work
        assert run.wait(60) == 1
        assert len(client.scheduler_info()["workers"]) == 2
        client.close()
    finally:
        for process in started:
            process.kill()
            process.wait()
    assert search(tmp_path / "alone.db") == 1
    assert contents(cluster) == contents(tmp_path / "alone.db")


def test_no_scheduler_is_an_input_error(tmp_path: Path) -> None:
    assert search(tmp_path / "s.db", "--scheduler", "no-scheme://nowhere") == 2


def _tasks(path: Path) -> int:
    with Store(str(path)) as store:
        return sum(1 for run in store.runs() for _ in store.results(run["id"]))
