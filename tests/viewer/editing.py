"""Starts the editor as a person does, and stops it."""

import http.client
import json
import os
import signal
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import parse_qs, urlsplit


class Served(NamedTuple):
    """A running editor."""

    url: str
    process: subprocess.Popen[str]

    @property
    def port(self) -> int:
        """Its port."""
        return urlsplit(self.url).port or 0

    @property
    def token(self) -> str:
        """Its token."""
        return parse_qs(urlsplit(self.url).query)["token"][0]

    def ask(self, method: str, path: str, body: bytes | None = None, **headers: str) -> tuple[int, bytes]:
        """Send a request with the token, unless headers say otherwise; return status and body."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        sent = {"X-Exactmesh-Token": self.token, **{name.replace("_", "-"): value for name, value in headers.items()}}
        connection.request(method, path, body, sent)
        answer = connection.getresponse()
        found = answer.status, answer.read()
        connection.close()
        return found

    def parts(self, pslg: Any, claims: bool = False) -> list[dict[str, Any]]:
        """Return the parts of the answer to a polygon."""
        status, body = self.ask("POST", "/evaluate", json.dumps({"pslg": pslg, "claims": claims}).encode())
        assert status == 200, body
        return [json.loads(line) for line in body.splitlines()]


@contextmanager
def editor(*arguments: str) -> Iterator[Served]:
    """Run `exactmesh view --edit`; it must end by Ctrl-C, cleanly, with all of its processes."""
    with started(*arguments) as served:
        yield served
        workers = children(served.process.pid)
        served.process.send_signal(signal.SIGINT)
        assert served.process.wait(10) == 0
        assert served.process.stderr is not None and served.process.stderr.read() == "exactmesh: stopped\n"
        assert [pid for pid in workers if is_alive(pid)] == []


@contextmanager
def started(*arguments: str) -> Iterator[Served]:
    """Run `exactmesh view --edit`; kill it at the end if it still runs."""
    process = subprocess.Popen([sys.executable, "-m", "exactmesh", "view", "--edit", "--no-browser", *arguments],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    with process:
        try:
            assert process.stdout is not None and process.stderr is not None
            line = process.stdout.readline()
            assert line.startswith("editing at http://127.0.0.1:"), process.stderr.read()
            yield Served(line.split()[-1], process)
        finally:
            process.kill()


def children(pid: int) -> list[int]:
    """Return the processes that a process has started, in any of its threads."""
    lists = Path(f"/proc/{pid}/task").glob("*/children")
    return [int(word) for path in lists for word in path.read_text(encoding="ascii").split()]


def is_alive(pid: int) -> bool:
    """Return whether a process runs."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return True


def polygon_json(*corners: tuple[str, str]) -> dict[str, Any]:
    """Return the PSLG of a polygon as the page sends it."""
    count = len(corners)
    return {"format": "exactmesh-pslg/1", "vertices": [list(corner) for corner in corners],
            "edges": [[i, (i + 1) % count] for i in range(count)]}
