"""What the two exact JSON formats share: their keys, scalars, points and vertex indices.

A reader of a part raises `FormatError` with a place relative to that part; `each` puts the list's own place
before it, so that no place is spelled out until something is wrong.
"""

import re
from collections.abc import Callable, Iterable, Iterator
from itertools import islice
from math import isinf
from typing import TypeVar

from gmpy2 import mpq, mpz

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.strict_json import Json, Number, described
from exactmesh.io.text import quoted, shortened
from exactmesh.numbers.rational import rational_from_float, rational_from_text

T = TypeVar("T")

_INTEGER = re.compile(r"-?\d+", re.ASCII)
_NONZERO_MANTISSA = re.compile(r"-?[0.]*[1-9]", re.ASCII)
_ROWS = 1 << 12
# An index that is longer is out of range in any file; it is not worth converting.
_INDEX_DIGITS = 18


def fields(
    value: Json, format_name: str, required: Iterable[str], optional: Iterable[str] = ()
) -> dict[str, Json]:
    """Return the object `value`, of format `format_name` and with no keys but the given ones."""
    if not isinstance(value, dict):
        raise FormatError("", f"an object of format {format_name!r} is expected, not {described(value)}")
    if "format" not in value:
        raise FormatError("", f"the key 'format' is missing; it should be {format_name!r}")
    if value["format"] != format_name:
        raise FormatError("format", f"{format_name!r} is expected here, not {described(value['format'])}")
    known = ("format", *required, *optional)
    for key in required:
        if key not in value:
            raise FormatError("", f"the key {key!r} is missing")
    for key in value:
        if key not in known:
            raise FormatError("", f"unknown key {quoted(key)}; {format_name} has {', '.join(known)}")
    return value


def each(value: Json, place: str, read: Callable[[Json], T]) -> tuple[T, ...]:
    """Return what `read` makes of each item of the list `value`, which stands at `place`."""
    if not isinstance(value, list):
        raise FormatError(place, f"a list is expected, not {described(value)}")
    found: list[T] = []
    for item in value:
        try:
            found.append(read(item))
        except FormatError as error:
            raise FormatError(f"{place}[{len(found)}]{error.place}", error.reason) from None
    return tuple(found)


def scalar(value: Json) -> mpq:
    """Return the rational that a string spells, or a number: an integer, or else the nearest double, exactly.

    A number that overflows a double, or is not zero and underflows to it, is refused: its double is no
    reading of it.
    """
    if isinstance(value, str):
        return rational_from_text(value)
    if not isinstance(value, Number):
        raise FormatError("", f"a number is expected, or a string that spells one, not {described(value)}")
    if _INTEGER.fullmatch(value.text):
        return mpq(mpz(value.text))
    double = float(value.text)
    if isinf(double) or (double == 0 and _NONZERO_MANTISSA.match(value.text)):
        shown = shortened(value.text)
        raise FormatError("", f"{shown} is beyond the range of a double: write it as a string")
    return rational_from_float(double)


def point(value: Json) -> Point:
    """Return the point of a list of two scalars."""
    if not isinstance(value, list) or len(value) != 2:
        raise FormatError("", f"a point is a list of two scalars, not {described(value)}")
    return Point._make(each(value, "", scalar))


def vertex_index(value: Json, count: int) -> int:
    """Return an index below `count`."""
    if isinstance(value, Number) and value.text.isdigit() and len(value.text) <= _INDEX_DIGITS:
        index = int(value.text)
        if index < count:
            return index
    if isinstance(value, Number) and _INTEGER.fullmatch(value.text):
        raise FormatError("", f"vertex {shortened(value.text)} does not exist (there are {count})")
    raise FormatError("", f"a vertex index is expected, not {described(value)}")


def edge(value: Json, count: int) -> tuple[int, int]:
    """Return the two ends, different and below `count`, of an edge."""
    if not isinstance(value, list) or len(value) != 2:
        raise FormatError("", f"an edge is a list of two vertex indices, not {described(value)}")
    u, v = each(value, "", lambda index: vertex_index(index, count))
    if u == v:
        raise FormatError("", f"both ends are vertex {u}: an edge needs two")
    return u, v


def rows(items: Iterable[str]) -> str:
    """Return a JSON list of texts that are JSON already, one a line so that files can be compared."""
    return "".join(row_parts(items))


def row_parts(items: Iterable[str]) -> Iterator[str]:
    """Yield `rows` in parts of some thousand rows; no item is empty."""
    rest = iter(items)
    before = "[\n  "
    while body := ",\n  ".join(islice(rest, _ROWS)):
        yield before + body
        before = ",\n  "
    yield "[]" if before[0] == "[" else "]"


def point_rows(points: Iterable[Point]) -> str:
    """Return a JSON list of points; scalars are strings in lowest terms."""
    return rows(map(point_row, points))


def point_row(p: Point) -> str:
    """Return a point as a JSON list of strings in lowest terms."""
    return f'["{p.x}", "{p.y}"]'
