"""The store: one SQLite file to which results are only added.

A task's report is written in one transaction, so a process that is killed loses the task at work and nothing else. A
task, and a find, is stored once whoever finds it: several runs, or several processes of one run, may share a file
(write-ahead log; a writer waits for another). Triggers refuse to change or delete a row.
"""

import json
import sqlite3
from collections.abc import Iterator, Mapping
from types import TracebackType
from typing import Any, Self

from exactmesh.errors import InputError
from exactmesh.io.text import printable

_APPLICATION = 0x65786D73  # "exms"
_LAYOUT = 2
_WAIT_SECONDS = 60.0
_TABLES = {
    "runs": "id INTEGER PRIMARY KEY, spec TEXT NOT NULL UNIQUE, version TEXT NOT NULL, command TEXT NOT NULL, "
            "started TEXT NOT NULL DEFAULT CURRENT_TIMESTAMP",
    "tasks": "run INTEGER NOT NULL, task TEXT NOT NULL, evaluated INTEGER NOT NULL, PRIMARY KEY (run, task)",
    "results": "run INTEGER NOT NULL, task TEXT NOT NULL, claim TEXT NOT NULL, construction TEXT NOT NULL, "
               "kind TEXT NOT NULL, judged INTEGER NOT NULL, skipped INTEGER NOT NULL, instances INTEGER NOT NULL, "
               "violations INTEGER NOT NULL, crashes INTEGER NOT NULL, outcome TEXT NOT NULL, exact TEXT NOT NULL, "
               "low TEXT NOT NULL, direction INTEGER NOT NULL, shown TEXT NOT NULL, input TEXT NOT NULL, "
               "figure TEXT NOT NULL, PRIMARY KEY (run, task, claim, construction, kind)",
    "finds": "id INTEGER PRIMARY KEY, claim TEXT NOT NULL, construction TEXT NOT NULL, kind TEXT NOT NULL, "
             "figure TEXT NOT NULL, label TEXT NOT NULL, outcome TEXT NOT NULL, exact TEXT NOT NULL, "
             "low TEXT NOT NULL, direction INTEGER NOT NULL, shown TEXT NOT NULL, confirmed INTEGER NOT NULL, "
             "confirmation TEXT NOT NULL, run INTEGER NOT NULL, task TEXT NOT NULL, "
             "UNIQUE (claim, construction, kind, figure)",
}
Row = Mapping[str, Any]


class Store:
    """An open store; use it in a `with` statement. Raises `InputError` when the file is something else."""

    def __init__(self, path: str, create: bool = True) -> None:
        self.path = path
        try:
            uri = "file:" + path.replace("%", "%25").replace("?", "%3f").replace("#", "%23")
            self._base = sqlite3.connect(uri + ("" if create else "?mode=rw"), timeout=_WAIT_SECONDS, uri=True,
                                         isolation_level=None)
            self._base.row_factory = sqlite3.Row
            self._prepare()
        except sqlite3.Error as error:
            raise InputError(f"{printable(path)}: cannot be used as a store: {error}") from error

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
                 ) -> None:
        self._base.close()

    def open_run(self, spec: str, version: str, command: str, resume: bool) -> int:
        """Return the id of the run with this spec, a new one or, if `resume`, the one that is there.

        Raises `InputError` when it is there and is not to be resumed.
        """
        with self._transaction():
            row = self._base.execute("SELECT id FROM runs WHERE spec = ?", (spec,)).fetchone()
            if row is None:
                return int(self._base.execute("INSERT INTO runs (spec, version, command) VALUES (?, ?, ?)",
                                              (spec, version, command)).lastrowid or 0)
        if not resume:
            raise InputError(f"{printable(self.path)} holds this run already: --resume goes on with it, another "
                             "--seed starts a new one")
        return int(row["id"])

    def is_done(self, run: int, task: str) -> bool:
        """Return whether the report of a task is stored."""
        return self._base.execute("SELECT 1 FROM tasks WHERE run = ? AND task = ?", (run, task)).fetchone() is not None

    def add(self, run: int, report: Mapping[str, Any]) -> bool:
        """Store the report of a task without its finds; return False when it was there."""
        with self._transaction():
            if not self._insert("tasks", {"run": run, "task": report["task"], "evaluated": report["evaluated"]}):
                return False
            for row in report["targets"]:
                self._insert("results", _row(row, run, report["task"]))
        return True

    def has_find(self, find: Mapping[str, Any]) -> bool:
        """Return whether a figure is stored for its target."""
        return self._base.execute(
            "SELECT 1 FROM finds WHERE claim = ? AND construction = ? AND kind = ? AND figure = ?",
            (*find["target"], json.dumps(find["figure"]))).fetchone() is not None

    def add_find(self, run: int, task: str, find: Mapping[str, Any], confirmed: bool, confirmation: str) -> bool:
        """Store a find with the word of the independent check; return False when it was there."""
        with self._transaction():
            return self._insert("finds", {**_row(find, run, task), "confirmed": int(confirmed),
                                          "confirmation": confirmation})

    def evaluated(self, run: int) -> int:
        """Return how many inputs the run has judged."""
        return int(self._base.execute("SELECT total(evaluated) FROM tasks WHERE run = ?", (run,)).fetchone()[0])

    def runs(self) -> list[Row]:
        """Return all runs, oldest first."""
        return [dict(row) for row in self._base.execute("SELECT * FROM runs ORDER BY id")]

    def results(self, run: int) -> Iterator[Row]:
        """Yield the reports of a run by task and target, in the order of their keys, whoever wrote them when."""
        for row in self._base.execute("SELECT * FROM results WHERE run = ? ORDER BY length(task), task, claim, "
                                      "construction, kind", (run,)):
            yield dict(row)

    def finds(self) -> Iterator[Row]:
        """Yield all finds with the spec and version of their runs, in the order in which they were stored."""
        for row in self._base.execute("SELECT finds.*, runs.spec, runs.version, runs.command FROM finds "
                                      "JOIN runs ON runs.id = finds.run ORDER BY finds.id"):
            yield dict(row)

    def _insert(self, table: str, row: Mapping[str, object]) -> bool:
        names = ", ".join(row)
        marks = ", ".join("?" * len(row))
        return self._base.execute(f"INSERT OR IGNORE INTO {table} ({names}) VALUES ({marks})",
                                  tuple(row.values())).rowcount > 0

    def _transaction(self) -> "_Transaction":
        return _Transaction(self._base)

    def _prepare(self) -> None:
        # One transaction: another process may be making the file right now.
        self._base.execute("BEGIN")
        found = self._base.execute("PRAGMA application_id").fetchone()[0]
        tables = self._base.execute("SELECT count(*) FROM sqlite_master").fetchone()[0]
        self._base.execute("COMMIT")
        if found == _APPLICATION:
            if (layout := self._base.execute("PRAGMA user_version").fetchone()[0]) != _LAYOUT:
                raise InputError(f"{printable(self.path)}: was written by another version (layout {layout}, not "
                                 f"{_LAYOUT})")
            return
        if found or tables:
            raise InputError(f"{printable(self.path)}: is a database of another program")
        self._base.execute("PRAGMA journal_mode = WAL")
        with self._transaction():
            for name, columns in _TABLES.items():
                self._base.execute(f"CREATE TABLE IF NOT EXISTS {name} ({columns})")
                for deed in ("UPDATE", "DELETE"):
                    self._base.execute(f"CREATE TRIGGER IF NOT EXISTS {name}_{deed} BEFORE {deed} ON {name} "
                                       "BEGIN SELECT RAISE(ABORT, 'rows of a store are never changed'); END")
            self._base.execute(f"PRAGMA user_version = {_LAYOUT}")
            self._base.execute(f"PRAGMA application_id = {_APPLICATION}")


class _Transaction:
    """Writes all or nothing; waits for other writers at its beginning."""

    def __init__(self, base: sqlite3.Connection) -> None:
        self._base = base

    def __enter__(self) -> None:
        self._base.execute("BEGIN IMMEDIATE")

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
                 ) -> None:
        self._base.execute("COMMIT" if kind is None else "ROLLBACK")


def _row(report: Mapping[str, Any], run: int, task: str) -> dict[str, object]:
    claim, construction, kind = report["target"]
    rest = {name: value for name, value in report.items() if name not in ("target", "figure")}
    return {"run": run, "task": task, "claim": claim, "construction": construction, "kind": kind, **rest,
            "figure": json.dumps(report["figure"])}
