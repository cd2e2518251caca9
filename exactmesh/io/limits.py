"""How much a file may ask for: beyond it every reader refuses, before memory is spent.

    with limited(Limits(digits=1_000_000)):
        pslg = exactmesh.read("outline.wkt")

Readers of text pass it to `check_text` before they parse it; readers of files take their bytes from `bytes_of`.
The limits that hold are those of the innermost `limited`, or else `Limits()`.
"""

import os
import re
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import BinaryIO, NamedTuple

from exactmesh.errors import FormatError
from exactmesh.numbers.rational import MAX_EXPONENT


class Limits(NamedTuple):
    """What one file may ask for; the defaults leave room for meshes of inputs of a million vertices.

    `bytes`: its length, and that of its numbers with their exponents written out. `digits`: of one number in a row,
    or by its exponent. `items`: of all its lists, counted by what separates them.
    """

    bytes: int = 3 << 29
    digits: int = 100_000
    items: int = 100_000_000


# What separates items. More is counted than there is in strings and between aligned columns, never less.
JSON_SEPARATORS = ",[{"
TEXT_SEPARATORS = ",(" + "".join(c for c in map(chr, range(0x3001)) if c.isspace())

_BLOCK = 1 << 20
_DIGITS = re.compile(r"\d*", re.ASCII)
# A number with an exponent, alone in its place: there is no other token that is parsed as one.
_EXPONENT = re.compile(r"(?<![\w.])[+-]?[\d.]+[eE][+-]?(\d+)(?![\w.])", re.ASCII)
# A digit, or another character of a number, that a JSON string spells by its code.
_ESCAPED = re.compile(r"\\u(00(?:3\d|[46]5|2[bdef]))", re.ASCII | re.IGNORECASE)

_active: ContextVar[Limits] = ContextVar("limits", default=Limits())  # noqa: B039  (it is immutable)


@contextmanager
def limited(limits: Limits) -> Iterator[None]:
    """Let other limits hold for what is read within."""
    token = _active.set(limits)
    try:
        yield
    finally:
        _active.reset(token)


def bytes_of(file: BinaryIO) -> bytes:
    """Return what is left in an open file; raises `FormatError` when that is too long, a regular file unread."""
    limit = _active.get().bytes
    try:
        status = os.fstat(file.fileno())
        known = status.st_size if stat.S_ISREG(status.st_mode) else 0
    except OSError:  # no file of the system: bytes in memory
        known = 0
    if known > limit:
        raise _beyond("bytes", limit)
    blocks: list[bytes] = []
    left = limit + 1
    size = known or _BLOCK  # what the system knows comes in one piece, which `join` does not copy
    # One read of the system at a time: between two of them an interruption is noticed.
    read = getattr(file, "read1", file.read)
    while left and (block := read(min(size, left))):
        blocks.append(block)
        left -= len(block)
        size = _BLOCK
    if not left:
        raise _beyond("bytes", limit)
    return b"".join(blocks)


def check_text(text: str, separators: str) -> None:
    """Raise `FormatError` when a text has too many items, or numbers too long to be parsed.

    In linear time, and with no memory to speak of.
    """
    limits = _active.get()
    if len(text) > limits.items and sum(map(text.count, separators)) > limits.items:
        raise _beyond("items", limits.items)
    if "\\u00" in text:
        text = _ESCAPED.sub(lambda match: chr(int(match[1], 16)), text)
    _check_runs(text, limits)
    # Few exponents are no danger, as none beyond MAX_EXPONENT is ever parsed.
    if limits.digits < MAX_EXPONENT or (text.count("e") + text.count("E")) * MAX_EXPONENT > limits.bytes:
        _check_exponents(text, limits)


def _check_runs(text: str, limits: Limits) -> None:
    # Each run of more digits than the limit meets one of these places.
    for place in range(limits.digits, len(text), limits.digits + 1):
        after = _DIGITS.match(text, place)
        before = _DIGITS.match(text[place - limits.digits : place][::-1])
        if after and before and after.end() - place + before.end() > limits.digits:
            raise _beyond("digits", limits.digits, f" in a number at character {place - before.end()}")


def _check_exponents(text: str, limits: Limits) -> None:
    total = 0
    for match in _EXPONENT.finditer(text):
        digits = match[1].lstrip("0") or "0"
        if len(digits) > 18 or int(digits) > limits.digits:
            raise _beyond("digits", limits.digits, f" by the exponent at character {match.start(1)}")
        total += int(digits)
        if total > limits.bytes:
            raise _beyond("bytes", limits.bytes, " when the exponents of its numbers are written out")


def _beyond(name: str, limit: int, where: str = "") -> FormatError:
    return FormatError("", f"more than {limit} {name}{where}: --max-{name} N allows more")
