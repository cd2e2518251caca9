"""Read a file of any known format, recognized by its content; a misleading file name does no harm.

Every error is one line that begins with the path.
"""

import hashlib
import os
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

from exactmesh.collector import collector_paused
from exactmesh.errors import FormatError, InputError
from exactmesh.io.as_written import pslg_as_written
from exactmesh.io.cgshop import is_instance, pslg_from_instance
from exactmesh.io.dxf import pslg_from_dxf
from exactmesh.io.geo_interface import pslg_from_wkb
from exactmesh.io.geojson import pslg_from_geojson_value
from exactmesh.io.limits import bytes_of
from exactmesh.io.mesh_json import mesh_from_json
from exactmesh.io.pslg_json import pslg_from_value
from exactmesh.io.strict_json import Json, described, parse_json
from exactmesh.io.svg_path import pslg_from_svg
from exactmesh.io.text import printable, quoted, text_from_bytes
from exactmesh.io.triangle_poly import pslg_from_poly
from exactmesh.io.wkt import KINDS, pslg_from_wkt
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

Syntax = Literal["json", "wkt", "poly", "svg", "dxf"]

_KNOWN = "exactmesh-pslg/1, GeoJSON, WKT, WKB, Triangle's .poly, SVG, DXF and CG:SHOP instances"
# Asked only when the content says nothing: then the reader of that format has the better message.
_BY_EXTENSION: dict[str, Syntax] = {".json": "json", ".geojson": "json", ".wkt": "wkt", ".poly": "poly",
                                    ".svg": "svg", ".dxf": "dxf"}
# A DXF file begins with a comment, code 999, or a section, code 0.
_DXF = re.compile(r"999\n|0\s*\n\s*SECTION\b")
# WKB begins with the byte order, which is no character of a text.
_BYTE_ORDERS = (b"\0", b"\1")
_WORD = re.compile(r"[A-Za-z]+")
_WHOLE = re.compile(r"\d+", re.ASCII)
_FIRST_LINE_BUT_COMMENTS = re.compile(r"(?:\s|#.*)*([^\n#]*)")


@dataclass(frozen=True, slots=True)
class Source:
    """A PSLG and the file it comes from.

    `sha256` is of the file's bytes, followed by those of the `.node` file if the vertices are in one.
    """

    pslg: Pslg
    sha256: str
    path: str


@dataclass(frozen=True, slots=True)
class MeshSource:
    """A mesh and the file it comes from; `sha256` is of the bytes."""

    mesh: Mesh
    sha256: str
    path: str


def read_pslg(path: str) -> Source:
    """Return the PSLG in the file `path`, or on standard input when `path` is `-`.

    Raises `InputError` when the file cannot be read, and `FormatError` when it is not of a known format.
    """
    with blaming(path), collector_paused():
        data = bytes_at(path)
        digest = hashlib.sha256(data)

        def node_text() -> str:
            node = os.path.splitext(path)[0] + ".node"
            try:
                node_data = bytes_at(node)
            except InputError as error:
                raise InputError(f"the vertices are in {printable(node)}: {error}") from error
            digest.update(node_data)
            return text_from_bytes(node_data)

        if data[:1] in _BYTE_ORDERS or path.lower().endswith(".wkb"):
            pslg = pslg_from_wkb(data)
        else:
            pslg = _pslg(text_from_bytes(data), path, None if path == "-" else node_text)
        return Source(pslg, digest.hexdigest(), path)


def read_mesh(path: str) -> MeshSource:
    """Return the exactmesh-mesh/1 in the file `path`, or on standard input when `path` is `-`.

    Raises `InputError` when the file cannot be read, and `FormatError` when it is not a mesh.
    """
    with blaming(path), collector_paused():
        data = bytes_at(path)
        text = text_from_bytes(data)
        if _syntax(text, path) != "json":
            raise FormatError("", f"not a mesh: exactmesh-mesh/1 is expected, not {quoted(text.lstrip())}")
        return MeshSource(mesh_from_json(text), hashlib.sha256(data).hexdigest(), path)


@contextmanager
def blaming(path: str) -> Iterator[None]:
    """Put the path before the message of every `InputError`."""
    name = "standard input" if path == "-" else printable(path)
    try:
        yield
    except FormatError as error:
        raise FormatError(f"{name}: {error.place}" if error.place else name, error.reason) from error
    except InputError as error:
        raise InputError(f"{name}: {error}") from error


def read_bytes(path: str) -> bytes:
    """Return the bytes of a file, `-` for standard input; raises `InputError`, which begins with the path."""
    with blaming(path):
        return bytes_at(path)


def bytes_at(path: str) -> bytes:
    """Return the bytes of a file, `-` for standard input; raises `InputError` without the path."""
    try:
        if path == "-":
            # Python has no stream there when the shell closed it.
            if sys.stdin is None:
                raise InputError("standard input is closed")
            return bytes_of(sys.stdin.buffer)
        with open(path, "rb") as file:
            return bytes_of(file)
    except InputError:
        raise
    except FileNotFoundError:
        raise InputError("no such file") from None
    except IsADirectoryError:
        raise InputError("this is a directory") from None
    except PermissionError:
        raise InputError("permission denied") from None
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror or error}") from error
    except ValueError as error:
        # A NUL or a lone surrogate in the path: there is no such file.
        raise InputError(f"cannot be read: {error}") from error


def _syntax(text: str, path: str) -> Syntax:
    """Return the syntax of a text that is not blank; `FormatError` when neither it nor its name says."""
    start = text.lstrip()
    if start[0] in '{["':
        return "json"
    if start[0] == "<":
        return "svg"
    if _DXF.match(start):
        return "dxf"
    word = _WORD.match(start)
    if word and word[0].upper() in (*KINDS, "SRID"):
        return "wkt"
    line = _FIRST_LINE_BUT_COMMENTS.match(start)
    tokens = line[1].split() if line else []
    if tokens and all(map(_WHOLE.fullmatch, tokens)):
        return "poly"
    hint = _BY_EXTENSION.get(os.path.splitext(path)[1].lower())
    if hint is None:
        raise FormatError("", f"not a format we know: it begins with {quoted(start)}; known are {_KNOWN}")
    return hint


def _pslg(text: str, path: str, node_text: Callable[[], str] | None) -> Pslg:
    match _syntax(text, path):
        case "json":
            quick = pslg_as_written(text)
            return _pslg_from_json(parse_json(text)) if quick is None else quick
        case "wkt":
            return pslg_from_wkt(text)
        case "poly":
            return pslg_from_poly(text, node_text)
        case "svg":
            return pslg_from_svg(text)
        case "dxf":
            return pslg_from_dxf(text)


def _pslg_from_json(value: Json) -> Pslg:
    if isinstance(value, dict) and "format" in value:
        return pslg_from_value(value)
    if isinstance(value, dict) and "type" in value and not is_instance(value):
        return pslg_from_geojson_value(value)
    if is_instance(value):
        return pslg_from_instance(value)
    what = 'an object without "format" or "type"' if isinstance(value, dict) else described(value)
    raise FormatError("", f"not a format we know: the JSON is {what}; known are {_KNOWN}")
