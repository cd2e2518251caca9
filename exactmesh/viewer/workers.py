"""Keeps a worker process ready, and stops one that takes too long or whose answer nobody waits for any more."""

import contextlib
import json
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Generator, Mapping

Part = Mapping[str, object]
_START_SECONDS = 60.0
_STANDING_BY = 2


class Workers:
    """Answers one request at a time, each by a deadline; a newer request stops the older one.

    After the first answer a second process stands by, because starting one takes longer than most answers. `close` ends
    both.
    """

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self._lock = threading.Lock()
        self._busy: _Worker | None = None
        self._idle = [_Worker()]
        self._closed = False

    def answer(self, request: str) -> Generator[Part, None, None]:
        """Yield the parts of the answer to a line for a worker.

        The last part is "end", "timeout", "superseded" or "stopped".
        """
        worker = self._take()
        name = ""
        try:
            worker.send(request)
            line = worker.line(_START_SECONDS)  # the first line says that it is ready: the time is for the request
            deadline = time.monotonic() + self.seconds
            while line and name != "end":
                line = worker.line(max(0.0, deadline - time.monotonic()))
                part = json.loads(line) if line else {"part": ""}
                name = part["part"]
                if name not in ("", "end"):
                    yield part
        finally:
            # Also when whoever reads the answer has gone away in the middle of it; and before "end" is told, because
            # the next request may come at once, and would stop a worker that is still busy.
            was_superseded = self._give_back(worker, finished=name == "end")
        if line is None:
            yield {"part": "timeout", "seconds": self.seconds}
        else:
            yield {"part": name or ("superseded" if was_superseded else "stopped")}

    def close(self) -> None:
        """End all processes."""
        with self._lock:
            self._closed = True
            for worker in (*self._idle, *([self._busy] if self._busy else [])):
                worker.stop()

    def _take(self) -> "_Worker":
        with self._lock:
            if self._busy is not None:
                self._busy.stop()
            self._busy = self._idle.pop(0) if self._idle else _Worker()
            return self._busy

    def _give_back(self, worker: "_Worker", finished: bool) -> bool:
        """Keep a worker that has finished, stop another one; return whether a newer request did so before."""
        with self._lock:
            if self._busy is not worker or self._closed:
                return True
            self._busy = None
            if finished:
                self._idle.append(worker)
            else:
                worker.stop()
            self._idle += [_Worker() for _ in range(_STANDING_BY - len(self._idle))]
            return False


class _Worker:
    """One process; a thread moves its lines into a queue, so that waiting for one can end."""

    def __init__(self) -> None:
        self.process = subprocess.Popen([sys.executable, "-m", "exactmesh.viewer.worker"], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, encoding="utf-8")
        self._lines: queue.Queue[str] = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def send(self, request: str) -> None:
        """Hand over a request; a process that is gone shows when its answer is waited for."""
        pipe = self.process.stdin
        assert pipe is not None
        with contextlib.suppress(OSError, ValueError):
            pipe.write(request + "\n")
            pipe.flush()

    def line(self, seconds: float) -> str | None:
        """Return the next line; None when none comes in time, "" when the process has ended."""
        try:
            return self._lines.get(timeout=seconds)
        except queue.Empty:
            return None

    def stop(self) -> None:
        """End the process."""
        self.process.kill()
        with contextlib.suppress(OSError):
            if self.process.stdin is not None:
                self.process.stdin.close()
        self.process.wait()

    def _read(self) -> None:
        assert self.process.stdout is not None
        with self.process.stdout as lines, contextlib.suppress(ValueError):
            for line in lines:
                self._lines.put(line)
        self._lines.put("")
