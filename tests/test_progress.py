"""Progress is for a person at a terminal: shown late, removed at the end, silent anywhere else."""

import io
import sys
import time

import pytest

from exactmesh import progress as module
from exactmesh.progress import Progress


class Terminal(io.StringIO):
    """A stream that says it is a terminal."""

    def isatty(self) -> bool:
        return True


def at_a_terminal(monkeypatch: pytest.MonkeyPatch) -> Terminal:
    """Put a terminal in place of standard error and cut waits to milliseconds.

    No fixture: pytest puts its own stream in place between the set-up and the test.
    """
    stream = Terminal()
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(module, "_DELAY", 0.02)
    monkeypatch.setattr(module, "_EVERY", 0.01)
    return stream


def wait_for(stream: Terminal, text: str) -> None:
    """Wait until the stream has the text, ten seconds at most."""
    for _ in range(1000):
        if text in stream.getvalue():
            return
        time.sleep(0.01)
    raise AssertionError(f"{text!r} was not shown")


def test_the_step_is_shown_with_the_time(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = at_a_terminal(monkeypatch)
    with Progress(quiet=False) as progress:
        progress("first")
        wait_for(terminal, "first (0 s)")
        progress("second")
        wait_for(terminal, "second (0 s)")


def test_the_line_is_removed_at_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = at_a_terminal(monkeypatch)
    with Progress(quiet=False) as progress:
        progress("step")
        wait_for(terminal, "step")
    assert terminal.getvalue().endswith("\r\033[K") and "\n" not in terminal.getvalue()


def test_the_line_is_removed_when_something_is_raised(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = at_a_terminal(monkeypatch)
    with pytest.raises(KeyboardInterrupt), Progress(quiet=False) as progress:
        progress("step")
        wait_for(terminal, "step")
        raise KeyboardInterrupt
    written = terminal.getvalue()
    assert written.endswith("\r\033[K")
    time.sleep(0.05)
    assert terminal.getvalue() == written


def test_short_work_shows_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = at_a_terminal(monkeypatch)
    monkeypatch.setattr(module, "_DELAY", 60)
    with Progress(quiet=False) as progress:
        progress("step")
    assert terminal.getvalue() == ""


@pytest.mark.parametrize("quiet, stream", [(True, Terminal()), (False, io.StringIO())])
def test_nothing_is_shown_when_quiet_or_elsewhere(quiet: bool, stream: io.StringIO,
                                                  monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", stream)
    monkeypatch.setattr(module, "_DELAY", 0.001)
    with Progress(quiet) as progress:
        progress("step")
        time.sleep(0.05)
    assert stream.getvalue() == ""


def test_a_closed_standard_error_does_no_harm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "stderr", None)
    with Progress(quiet=False) as progress:
        progress("step")
