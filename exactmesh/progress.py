"""Tell a person at a terminal what long work is doing."""

import sys
import threading
import time
from types import TracebackType
from typing import Self

_DELAY = 1.5
_EVERY = 0.5


class Progress:
    """A line on standard error with the current step and the time so far.

    Shown only when standard error is a terminal, from a second and a half on, and removed at the end. Call it with
    the name of each step.
    """

    def __init__(self, quiet: bool) -> None:
        self._step = ""
        # Standard error is None when the caller has closed it.
        self._shown = not quiet and sys.stderr is not None and sys.stderr.isatty()
        self._done = threading.Event()
        self._thread = threading.Thread(target=self._refresh, daemon=True)

    def __call__(self, step: str) -> None:
        self._step = step

    def __enter__(self) -> Self:
        if self._shown:
            self._thread.start()
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
                 ) -> None:
        if self._shown:
            self._done.set()
            self._thread.join()

    def _refresh(self) -> None:
        start = time.monotonic()
        pause, drawn = _DELAY, False
        while not self._done.wait(pause):
            pause, drawn = _EVERY, True
            sys.stderr.write(f"\r\033[K{self._step} ({time.monotonic() - start:.0f} s)")
            sys.stderr.flush()
        if drawn:
            sys.stderr.write("\r\033[K")
            sys.stderr.flush()
