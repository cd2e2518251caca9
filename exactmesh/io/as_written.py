"""Quick reading of the exact formats in the layout that most files have: keys in order, scalars as strings.

Nothing is accepted here that the readers of `exactmesh.io.pslg_json` and `exactmesh.io.mesh_json` refuse, and nothing
is read in another way. Where a text is laid out otherwise, or something is wrong with it, the answer is None: those
readers then take it, or say what is wrong and where. White space may be anywhere.

Rows are taken in stretches, so that what they are split into is never in memory all at once.
"""

import json
import re
from collections.abc import Iterator
from functools import partial
from itertools import chain

from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.json_fields import each, point
from exactmesh.io.limits import JSON_SEPARATORS, check_text
from exactmesh.io.strict_json import parse_json
from exactmesh.planar.mesh import KINDS, Mesh
from exactmesh.planar.pslg import Pslg

Rows = list[tuple[int, ...]]

_STRETCH = 1 << 20
_LAST_ROW = re.compile(r"\][ \t\n\r]*\]")
_PSLG = re.compile(r'\s*\{\s*"format"\s*:\s*"exactmesh-pslg/1"\s*,\s*"vertices"\s*:\s*\[\s*(?=\[)', re.ASCII)
_EDGES = re.compile(r'\s*,\s*"edges"\s*:\s*\[\s*(?=\[)', re.ASCII)
_MESH = re.compile(r'\s*\{\s*"format"\s*:\s*"exactmesh-mesh/1"\s*,\s*"kind"\s*:\s*"([a-z]+)"\s*,\s*'
                   r'"vertices"\s*:\s*\[\s*(?=\[)', re.ASCII)
_FACES = re.compile(r'\s*,\s*"faces"\s*:\s*\[\s*(?=\[)', re.ASCII)
_NOTHING = str.maketrans("", "", " \t\n\r")
_NO_SCALAR = str.maketrans("", "", "0123456789-/")
_NO_INDICES = str.maketrans("", "", "0123456789, \t\n\r[]")
_point = partial(tuple.__new__, Point)


class _Otherwise(Exception):
    """The text is not laid out as expected here."""


def pslg_as_written(text: str) -> Pslg | None:
    """Return the PSLG of a text laid out as `json_from_pslg` does; None for any other. Sizes beyond the limits raise
    `FormatError`."""
    start = _PSLG.match(text)
    if start is None:
        return None
    check_text(text, JSON_SEPARATORS)
    try:
        vertices, at = _points(text, start.end())
        edges, at = _index_rows(text, _end(_EDGES, text, at), len(vertices))
        if {len(edge) for edge in edges} - {2} or any(u == v for u, v in edges):
            return None
        # What is left is short as a rule; its own reader looks for holes and the name.
        rest = parse_json('{"format": ""' + text[at:])
        if not isinstance(rest, dict) or set(rest) - {"format", "holes", "name"}:
            return None
        name = rest.get("name", "")
        if not isinstance(name, str):
            return None
        holes = each(rest.get("holes", []), "holes", point)
    except (_Otherwise, FormatError, ValueError, ZeroDivisionError, RecursionError):
        return None
    return Pslg(vertices, tuple((u, v) for u, v in edges), holes, name)


def mesh_as_written(text: str) -> Mesh | None:
    """Return the mesh of a text laid out as `json_from_mesh` does; None for any other. Sizes beyond the limits raise
    `FormatError`."""
    start = _MESH.match(text)
    if start is None:
        return None
    check_text(text, JSON_SEPARATORS)
    kind = next((kind for kind in KINDS if kind == start[1]), None)
    try:
        vertices, at = _points(text, start.end())
        faces, at = _index_rows(text, _end(_FACES, text, at), len(vertices))
    except (_Otherwise, ValueError, ZeroDivisionError, RecursionError):
        return None
    if kind is None or text[at:].translate(_NOTHING) != "}" or min(map(len, faces)) < 3:
        return None
    return Mesh(kind, vertices, tuple(faces))


def _end(pattern: re.Pattern[str], text: str, at: int) -> int:
    found = pattern.match(text, at)
    if found is None:
        raise _Otherwise
    return found.end()


def _stretches(text: str, start: int) -> tuple[Iterator[str], int]:
    """Return whole rows of the list whose first row begins at `start`, some at a time, and the place after the list.

    The commas between stretches are left out.
    """
    last = _LAST_ROW.search(text, start)
    if last is None:
        raise _Otherwise
    end = last.start() + 1

    def rows() -> Iterator[str]:
        at = start
        while True:
            cut = text.find("]", min(at + _STRETCH, end - 1), end) + 1
            yield text[at:cut]
            if cut == end:
                return
            comma = text.find("[", cut, end)
            if comma < 0 or text[cut:comma].translate(_NOTHING) != ",":
                raise _Otherwise
            at = comma

    return rows(), last.end()


def _points(text: str, start: int) -> tuple[tuple[Point, ...], int]:
    """Return the points of a list of pairs of strings, and the place after it."""
    found: list[Point] = []
    stretches, end = _stretches(text, start)
    for rows in stretches:
        parts = rows.split('"')
        if len(parts) % 4 != 1 or {part.translate(_NOTHING) for part in {parts[0], parts[-1]}} != {"[", "]"}:
            raise _Otherwise
        between = {part.translate(_NOTHING) for part in set(parts[4:-1:4])}
        if {part.translate(_NOTHING) for part in set(parts[2::4])} != {","} or not between <= {"],["}:
            raise _Otherwise
        scalars = parts[1::2]
        joined = "".join(scalars)
        # A minus may only come first; the rest `mpq` reads as `rational_from_text` does, or refuses.
        if joined.translate(_NO_SCALAR) or joined.count("-") != rows.count('"-'):
            raise _Otherwise
        values = list(map(mpq, scalars))
        found += map(_point, zip(values[::2], values[1::2], strict=True))
    return tuple(found), end


def _index_rows(text: str, start: int, count: int) -> tuple[Rows, int]:
    """Return the rows of a list of lists of indices below `count`, and the place after it; equal numbers are shared."""
    numbers = list(range(count))
    found: Rows = []
    stretches, end = _stretches(text, start)
    for rows in stretches:
        if rows.translate(_NO_INDICES):
            raise _Otherwise
        parsed = json.loads(f"[{rows}]")
        if set(map(type, parsed)) != {list} or set(map(type, chain.from_iterable(parsed))) != {int}:
            raise _Otherwise
        if max(map(max, filter(None, parsed))) >= count:
            raise _Otherwise
        found += [tuple(map(numbers.__getitem__, row)) for row in parsed]
    return found, end
