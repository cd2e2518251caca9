"""Look at a random part of a large certificate: hashes and claims, and a few faces with what surrounds them.

The files are parsed by `json`, and only the numbers that are needed are read as such. A fault that is found is one: the
certificate is not valid. That none is found proves nothing about what was not looked at, and the line says so.

P1  the hashes are those of the files.       P2  a chosen vertex of the input is the mesh's.
P3  a chosen face is a counter-clockwise triangle and leaves room around the vertices of the mesh.
P4  each directed edge of a chosen face occurs once, and its reverse once, or never for the box's sides.
P5  a chosen edge of the input occurs in a face.
Not checked: all else, such as what the claims say of the input's mfs.
"""

import hashlib
import io
import json
import random
from collections import Counter
from collections.abc import Iterable, Sequence
from typing import Any

from exactmesh.check import Limits, Point, Refused, Tokens, corners_of, has_room, minus, point_of, scalar
from exactmesh.errors import FormatError
from exactmesh.io.limits import JSON_SEPARATORS, check_text
from exactmesh.io.read import read_bytes

_CLAIM = "mfs_squared_at_least"


def check_part(pslg_path: str, mesh_path: str, certificate_path: str, chosen: int, seed: int) -> tuple[bool, str]:
    """Return whether no fault is found in `chosen` faces, edges and vertices, and the line that says what was done.

    Raises `InputError` when a file cannot be read.
    """
    pslg_data, mesh_data, certificate_data = map(read_bytes, (pslg_path, mesh_path, certificate_path))
    try:
        pslg, mesh, certificate = map(_parsed, ((pslg_data, "PSLG"), (mesh_data, "MESH"),
                                                (certificate_data, "CERTIFICATE")))
        for data, key, name in ((pslg_data, "pslg_sha256", "PSLG"), (mesh_data, "mesh_sha256", "MESH")):
            if hashlib.sha256(data).hexdigest() != certificate[key]:
                raise Refused("hash", name)
        counts = _Part(pslg, mesh, certificate, random.Random(seed)).run(chosen)
    except Refused as refused:
        return False, f"INVALID {refused}"
    except (KeyError, TypeError, IndexError, ValueError, AttributeError):
        return False, "INVALID format: the files are not of their formats; the full check says where"
    return True, (f"PARTIAL no fault in {counts}, seed {seed}: nothing is proved about the rest; "
                  "without --random-part all is checked")


def _parsed(file: tuple[bytes, str]) -> Any:
    data, name = file
    try:
        text = data.decode("ascii")
        check_text(text, JSON_SEPARATORS)
        return json.loads(text)
    except FormatError as error:
        raise Refused("size", f"{name}: {error.reason}") from None
    except (ValueError, RecursionError):
        raise Refused("format", name) from None


class _Part:
    """The three parsed files, and which parts of them are looked at."""

    def __init__(self, pslg: Any, mesh: Any, certificate: Any, source: random.Random) -> None:
        self.pslg, self.certificate, self.source = pslg, certificate, source
        self.given, self.watched = len(pslg["vertices"]), len(mesh["vertices"])
        self.vertices: list[Any] = mesh["vertices"] + certificate["vertices"]
        self.faces: list[Any] = mesh["faces"] + certificate["faces"]
        self.meshed = len(mesh["faces"])

    def run(self, chosen: int) -> str:
        """Return what was looked at; raise `Refused` for a fault."""
        vertices = self._sample(self.given, chosen)
        for v in vertices:
            if minus(_point(self.pslg["vertices"][v]), self._at(v)) != (0, 0):
                raise Refused("input-vertices", f"vertex {v}")
        faces = self._sample(len(self.faces), chosen)
        for number in faces:
            self._check_face(number)
        edges = self._sample(len(self.pslg["edges"]), chosen)
        self._check_edges(faces, edges)
        return (f"{len(faces)} of {len(self.faces)} faces, {len(edges)} of {len(self.pslg['edges'])} edges and "
                f"{len(vertices)} of {self.given} vertices of the input")

    def _sample(self, count: int, chosen: int) -> list[int]:
        return sorted(self.source.sample(range(count), min(chosen, count)))

    def _at(self, v: int) -> Point:
        if v < 0:
            raise IndexError(v)
        return _point(self.vertices[v])

    def _named(self, number: int) -> str:
        return f"mesh face {number}" if number < self.meshed else f"rest face {number - self.meshed}"

    def _check_face(self, number: int) -> None:
        cycle = self.faces[number]
        at = [self._at(v) for v in cycle]
        corners = corners_of(at) if len(at) >= 3 else []
        if not corners:
            raise Refused("face-shape", self._named(number))
        if not has_room(cycle, at, corners, self.watched, _scalar(self.certificate[_CLAIM])):
            raise Refused("feature", self._named(number))

    def _check_edges(self, faces: Iterable[int], edges: Iterable[int]) -> None:
        """Count the directed edges that matter in one pass over all faces."""
        box = {(self.watched + i, self.watched + (i + 1) % 4) for i in range(4)}
        wanted: Counter[tuple[int, int]] = Counter()
        for number in faces:
            for u, v in _sides(self.faces[number]):
                wanted[u, v] = wanted[v, u] = 0
        for e in edges:
            u, v = self.pslg["edges"][e]
            wanted[u, v] = wanted[v, u] = 0
        for cycle in self.faces:
            for side in _sides(cycle):
                if side in wanted:
                    wanted[side] += 1
        for (u, v), count in wanted.items():
            if count != 1 and not (count == 0 and (v, u) in box):
                clause = "overlap" if count > 1 else "boundary"
                raise Refused(clause, f"edge [{u}, {v}]")


def _sides(cycle: Sequence[int]) -> Iterable[tuple[int, int]]:
    return zip(cycle, [*cycle[1:], cycle[0]], strict=True)


def _scalar(value: Any) -> tuple[int, int]:
    return scalar(Tokens(io.BytesIO(json.dumps(value).encode()), "a number", Limits()))


def _point(value: Any) -> Point:
    x, y = value
    return point_of(_scalar(x), _scalar(y))
