"""Bytes to text, the decimals in it, and the places and extracts that error messages show."""

import re

from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.numbers.rational import rational_from_text

_DECIMAL = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?", re.ASCII)


def text_from_bytes(data: bytes) -> str:
    """Return the text of UTF-8 `data`, without a byte order mark, every line ended by a line feed.

    Raises `FormatError` for bytes that are not UTF-8, for a NUL (a sign of a binary file) and when there is
    nothing but white space.
    """
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise FormatError(f"byte {error.start}", "this is not UTF-8 text") from None
    if "\0" in text:
        raise FormatError(f"byte {data.index(0)}", "a NUL byte: this is not a text file")
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    if not text or text.isspace():
        raise FormatError("", "the file is empty")
    return text


def decimal_from_text(text: str) -> mpq:
    """Return exactly the decimal that `text` spells; `FormatError` for anything else, a fraction included."""
    if not _DECIMAL.fullmatch(text):
        raise FormatError("", f"{quoted(text)} is not a finite decimal")
    return rational_from_text(text)


def place_at(text: str, offset: int) -> str:
    """Return the line and column, both from 1, of the character at `offset`."""
    line_start = text.rfind("\n", 0, offset) + 1
    return f"line {text.count(chr(10), 0, offset) + 1}, column {offset - line_start + 1}"


def shortened(text: str, limit: int = 40) -> str:
    """Return `text`, cut where an error message would become unreadable."""
    return text if len(text) <= limit else text[: limit - 3] + "..."


def quoted(text: str) -> str:
    """Return `text` shortened, in quotes and on one line."""
    return repr(shortened(text))


def printable(path: str) -> str:
    """Return a path as one line of a message can show it."""
    return path if path.isprintable() else repr(path)[1:-1]
