"""The store, interruption, engines, and the command line."""

import json
import os
import signal
import sqlite3
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from itertools import islice
from pathlib import Path

import pytest

from exactmesh.claims.ledger import claim_by_id
from exactmesh.claims.status import Entry
from exactmesh.cli import main
from exactmesh.errors import InputError
from exactmesh.report_ledger import ledger_text
from exactmesh.search.driver import run_tasks, totals
from exactmesh.search.engine import Processes, Serial
from exactmesh.search.evidence import evidence_in, evidence_lines
from exactmesh.search.spec import Spec, Task, search_tasks
from exactmesh.search.store import Store

SPEC = Spec((("offset-edge-length", "paper", "nonproper"),), "random", "triangle", seed=3, size=4).checked()
ROOM = '{"format": "exactmesh-pslg/1", "vertices": [["0","0"],["17","0"],["17","1"],["1","1"],["0","1"]], ' \
       '"edges": [[0,1],[1,2],[2,3],[3,4],[4,0]]}'


def rows(path: Path) -> list[dict[str, object]]:
    with Store(str(path)) as store:
        return [dict(row) for run in store.runs() for row in store.results(run["id"])]


def finds(path: Path) -> set[tuple[object, ...]]:
    with Store(str(path)) as store:
        return {(find["claim"], find["figure"], find["exact"], find["confirmed"]) for find in store.finds()}


def search(path: Path, *more: str) -> int:
    return main(["search", "section-2.p5-feature-size", "--strategy", "random", "--family", "triangle:size=9", "--size",
                 "3", "--store", str(path), "--quiet", *more])


def test_rows_are_only_added(tmp_path: Path) -> None:
    path = tmp_path / "s.db"
    with Store(str(path)) as store:
        run = store.open_run("{}", "1", "c", False)
        assert store.add(run, {"task": "0", "evaluated": 2, "targets": []})
        assert not store.add(run, {"task": "0", "evaluated": 5, "targets": []})
        assert store.is_done(run, "0") and not store.is_done(run, "1") and store.evaluated(run) == 2
        with pytest.raises(InputError, match="--resume"):
            store.open_run("{}", "1", "c", False)
        assert store.open_run("{}", "1", "c", True) == run
    base = sqlite3.connect(path)
    for deed in ("UPDATE tasks SET evaluated = 0", "DELETE FROM tasks"):
        with pytest.raises(sqlite3.IntegrityError, match="never changed"):
            base.execute(deed)
    assert base.execute("PRAGMA journal_mode").fetchone() == ("wal",)


def test_other_files_are_refused(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("no database, but long enough to be read as the header of one" * 20)
    sqlite3.connect(tmp_path / "b").execute("CREATE TABLE t (x)")
    for name, reason in (("a", "not a database"), ("b", "another program"), ("no/such", "cannot be used")):
        with pytest.raises(InputError, match=reason):
            Store(str(tmp_path / name))
    with pytest.raises(InputError, match="cannot be used"):
        Store(str(tmp_path / "absent"), create=False)


def test_two_writers_share_a_store(tmp_path: Path) -> None:
    path = str(tmp_path / "s.db")

    def write(seed: int) -> None:
        with Store(path) as store:
            spec = Spec(SPEC.targets, "random", "triangle", seed=seed % 2, size=2).checked()
            run = store.open_run(spec.to_json(), "1", "c", True)
            run_tasks(store, run, spec, islice(search_tasks(spec), 12), Serial(), None, lambda line: None)

    with ThreadPoolExecutor(4) as pool:
        list(pool.map(write, range(4)))
    assert len(rows(Path(path))) == 24


def test_a_resumed_run_and_many_processes_equal_one_that_goes_through(tmp_path: Path) -> None:
    whole, parts, many = tmp_path / "whole", tmp_path / "parts", tmp_path / "many"
    assert search(whole, "--tasks", "4") == 1
    search(parts, "--tasks", "1")
    assert search(parts, "--tasks", "4") == 2  # the run is there
    search(parts, "--tasks", "4", "--resume")
    search(many, "--tasks", "4", "--jobs", "2")
    assert rows(whole) == rows(parts) == rows(many)
    assert finds(whole) == finds(many) and all(find[3] for find in finds(whole))


def test_a_killed_worker_loses_nothing(tmp_path: Path) -> None:
    with Store(str(tmp_path / "s.db")) as store:
        run = store.open_run(SPEC.to_json(), "1", "c", False)
        engine = Processes(2)
        reports = engine.reports(SPEC.to_json(), islice(search_tasks(SPEC), 8), None)
        first = next(report for report in reports if report)
        import multiprocessing

        for child in multiprocessing.active_children():
            os.kill(child.pid or 0, signal.SIGKILL)
            break
        keys = {first["task"], *(report["task"] for report in reports if report)}
        assert keys == {str(i) for i in range(8)} and run == 1


@pytest.mark.parametrize("sent", [signal.SIGINT, signal.SIGKILL])
def test_what_is_done_survives_a_signal(tmp_path: Path, sent: signal.Signals) -> None:
    path = tmp_path / "s.db"
    command = [sys.executable, "-m", "exactmesh", "search", "offset-edge-length", "--strategy", "random", "--family",
               "triangle", "--size", "3", "--store", str(path)]
    with subprocess.Popen([*command, "--time-limit", "60"], stderr=subprocess.PIPE, text=True) as process:
        for _ in range(200):
            time.sleep(0.1)
            if path.exists() and len(rows(path)) > 3:
                break
        process.send_signal(sent)
        _, said = process.communicate()
    assert process.returncode == (130 if sent == signal.SIGINT else -9)
    assert ("--resume" in said) == (sent == signal.SIGINT)
    before = len(rows(path))
    assert before > 3
    assert subprocess.run([*command, "--resume", "--tasks", str(before + 2), "--quiet"], check=False).returncode == 0
    assert len(rows(path)) == before + 2


def test_hits_are_listed_filtered_and_exported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, folder = tmp_path / "s.db", tmp_path / "out"
    search(path, "--tasks", "1")
    assert main(["hits", str(path), "--confirmed", "--label", "violation", "--json"]) == 0
    records = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert records and all(r["confirmed"] and r["seed"] == 0 and r["strategy"] == "random" for r in records)
    assert main(["hits", str(path), "--max-points", "2"]) == 0
    assert len(capsys.readouterr().out.splitlines()) == 1
    assert main(["hits", str(path), "--html", str(tmp_path / "page.html"), "--export", str(folder)]) == 0
    commands = capsys.readouterr().out.splitlines()
    assert (tmp_path / "page.html").read_text().count("<h2") == len(commands) == len(list(folder.glob("*.svg")))
    assert main(commands[0].split()[1:]) == 1  # it shows the violation
    assert main(["hits", str(tmp_path / "none")]) == 2


@pytest.fixture
def inputs(tmp_path: Path) -> Path:
    """A folder with a long room, a file of lines, a square with a hole, and a file that is none."""
    folder = tmp_path / "in"
    (folder / "deeper").mkdir(parents=True)
    (folder / "room.json").write_text(ROOM)
    (folder / "hole.wkt").write_text("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))")
    (folder / "deeper" / "many.jsonl").write_text("[[0,0],[3,0],[1,2]]\n" * 3 + ROOM + "\n")
    (folder / "bad.json").write_text("{")
    return folder


def test_verify_run(tmp_path: Path, inputs: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["verify-run", str(inputs), "family:star:n=5", "--count", "50", "--claims",
                 "theorem-1.degradation,repaired.degradation,section-2.p5-grid", "--construction", "both", "--store",
                 str(tmp_path / "s.db"), "--report", str(tmp_path / "r.json"), "--html", str(tmp_path / "r.html")]
    assert main(arguments) == 1
    report = json.loads((tmp_path / "r.json").read_text())
    found = {(claim["id"], claim["construction"]): claim for claim in report["claims"]}
    assert found["repaired.degradation", "repaired"]["inputs"] == 56 and len(report["refused"]) == 1
    assert found["repaired.degradation", "repaired"]["status"] == "holds on 56 instances"
    refuted = found["theorem-1.degradation", "paper"]
    assert refuted["violations"] >= 2 and refuted["confirmed"] >= 1 and refuted["not_for"] == 1
    assert refuted["status"].startswith("refuted: fails on ") and refuted["status"].endswith(" confirmed")
    assert "refuted" in (tmp_path / "r.html").read_text() and "theorem-1.degradation" in capsys.readouterr().out
    assert main([*arguments, "--resume", "--jobs", "2"]) == 1
    assert json.loads((tmp_path / "r.json").read_text()) == report


def test_what_a_verify_run_saw_stands_in_the_ledger(tmp_path: Path, inputs: Path, capsys: pytest.CaptureFixture[str]
                                                    ) -> None:
    store = str(tmp_path / "s.db")
    main(["verify-run", str(inputs), "--claims", "repaired.degradation,theorem-1.degradation", "--construction", "both",
          "--store", store, "--quiet"])
    assert main(["claims", "repaired.degradation", "--store", store]) == 0
    assert "in store    holds on 6 instances (repaired, nonproper), worst " in capsys.readouterr().out
    assert main(["claims", "theorem-1.degradation", "--store", store, "--json"]) == 0
    [claim] = json.loads(capsys.readouterr().out)["claims"]
    by_paper, by_us = claim["evidence"]
    assert by_paper["status"].startswith("refuted: fails on 2 of 5 inputs") and by_paper["not_for"] == 1
    assert by_us["instances"] == 6 and by_us["worst"]["exact"] and by_us["witness"]["input"].endswith("wkt")
    # The whole table has one more column.
    with Store(store) as opened:
        lines = {name: evidence_lines(evidence_in(opened), name) for name in ("theorem-1.degradation", "lemma-2.x")}
    entries = [Entry(claim_by_id("theorem-1.degradation"), ())]
    head, row = ledger_text(entries, lines).splitlines()
    assert head.endswith("in the store") and "holds on 6 instances (repaired, nonproper), worst " in row
    assert not lines["lemma-2.x"] and "in the store" not in ledger_text(entries)
    assert main(["claims", "--store", str(tmp_path / "none")]) == 2


def test_files_that_violate_a_claim_are_shrunk_and_stored_once(tmp_path: Path, inputs: Path) -> None:
    store = tmp_path / "s.db"
    again = inputs / "turned.jsonl"
    again.write_text('[["1/2","0"],["1/2","17/2"],["0","17/2"],["0","1/2"],["0","0"]]\n')
    arguments = ["verify-run", str(inputs), "--claims", "theorem-1.degradation", "--construction", "paper", "--quiet",
                 "--store", str(store)]
    assert main([*arguments, "--shrink"]) == 1
    with Store(str(store)) as opened:
        shrunk = [json.loads(find["figure"]) for find in opened.finds()]
        assert all(find["confirmed"] and find["label"] == "violation" for find in opened.finds())
    assert len(shrunk) < 4 and all(len(figure) <= 5 for figure in shrunk)
    assert main([*arguments[:-1], str(tmp_path / "unshrunk.db")]) == 1
    with Store(str(tmp_path / "unshrunk.db")) as opened:
        assert {len(json.loads(find["figure"])) for find in opened.finds()} == {5}


@pytest.mark.parametrize("engine", [Serial(), Processes(2)])
def test_what_is_at_work_when_time_is_up_is_waited_for(tmp_path: Path, engine: Serial | Processes) -> None:
    with Store(str(tmp_path / "s.db")) as store:
        run = store.open_run(SPEC.to_json(), "1", "c", False)
        handed: list[str] = []

        def tasks() -> Iterator[Task]:
            for task in search_tasks(SPEC):
                handed.append(task.key)
                yield task

        assert run_tasks(store, run, SPEC, tasks(), engine, time.monotonic() + 0.2, lambda line: None) > 0
        assert {row["task"] for row in store.results(run)} == set(handed[: len(list(store.results(run)))])
        assert len(handed) - len(list(store.results(run))) <= 1  # one that was taken as time ran out


def test_totals_and_tasks_of_nothing(tmp_path: Path) -> None:
    with Store(str(tmp_path / "s.db")) as store:
        run = store.open_run(SPEC.to_json(), "1", "c", False)
        assert run_tasks(store, run, SPEC, iter([Task("0")]), Serial(), time.monotonic() - 1, lambda line: None) == 0
        assert totals(store, run) == {}


@pytest.mark.parametrize("arguments", [["--tasks", "0"], ["--size", "-1"], ["--jobs", "x"], ["--shard", "3/3"],
                                       ["--time-limit", "nan"], ["--family", "star:n=x"], ["--family", "no.py:f"],
                                       ["--strategy", "exhaustive"], ["--family", "cube"]])
def test_bad_arguments_are_refused(tmp_path: Path, arguments: list[str]) -> None:
    try:
        status = search(tmp_path / "s.db", *arguments)
    except SystemExit as left:
        status = int(str(left.code))
    assert status == 2


def test_two_processes_of_one_run_share_a_store_from_its_beginning(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "exactmesh", "search", "offset-edge-length", "--strategy", "random", "--family",
               "triangle", "--size", "4", "--tasks", "6", "--quiet", "--resume", "--store"]
    together = [subprocess.Popen([*command, str(tmp_path / "both.db")]) for _ in range(2)]
    assert [process.wait() for process in together] == [0, 0]
    assert main([*command[3:], str(tmp_path / "one.db")]) == 0
    assert rows(tmp_path / "both.db") == rows(tmp_path / "one.db")
    assert finds(tmp_path / "both.db") == finds(tmp_path / "one.db")
