"""Check an exactmesh-certificate/1: one file, standard library only, integers only, nothing of the package imported.

    python check.py PSLG MESH CERTIFICATE [--max-bytes N] [--max-digits N] [--max-items N]

Prints one line: `VALID ...`, which states what is proved, or `INVALID clause: place`. Exit status: 0 valid, 1 invalid,
2 usage, or a file that cannot be read; 130 interrupted. PSLG is exactmesh-pslg/1, MESH is exactmesh-mesh/1 of kind
classic, nonproper or proper.

docs/certificate.md proves, clause by clause, that what is accepted is true. In short: the faces of the mesh and of the
certificate are counter-clockwise triangles whose directed edges cancel but for the sides of a box. So they tile the
box, and their edges form a plane graph. Edges of the input are among them, so the input is a PSLG; they alone part mesh
from rest, and the rest is what one reaches from the box and from hole points. In every face, each vertex of the mesh is
as far from all that does not contain it as the bound says, so no pair of the mesh is closer.

A point is three integers (X, Y, W), W > 0, for (X/W, Y/W). With numerators and denominators of b bits no number has
more than 16 b + 8 bits, and in comparisons those of a claim besides. Files are read once from front to back; memory is
linear in their size; time is that of sorting the edges and of a few products a face and vertex on it. No recursion.
"""

import argparse
import hashlib
import re
import sys
from array import array
from bisect import bisect_left
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import gcd
from typing import Any, BinaryIO, NamedTuple, NoReturn

Point = tuple[int, int, int]
Ratio = tuple[int, int]

VALID, INVALID, REFUSED, INTERRUPTED = 0, 1, 2, 130


class Refused(Exception):
    """A clause that fails, and where."""

    def __init__(self, clause: str, place: str) -> None:
        super().__init__(f"{clause}: {place}")


class Limits(NamedTuple):
    """What a file may ask for: bytes, decimal digits of one number (with its exponent), items of all its lists."""
    bytes: int = 1 << 28  # 268,435,456
    digits: int = 4000
    items: int = 20_000_000


DEFAULT = Limits()


# --- reading: a strict part of JSON, token by token ---

_BLOCK = 1 << 16
_SPACE = re.compile(rb"[ \t\n\r]*")
_ESCAPE = rb'\\(?:["\\/bfnrt]|u[0-9a-fA-F]{4})'
_STRING = re.compile(rb'"[ !#-\[\]-~]*+(?:' + _ESCAPE + rb"[ !#-\[\]-~]*+)*+")
_NUMBER = re.compile(rb"-?[0-9]*")
_CUT_ESCAPE = re.compile(rb"\\(?:u[0-9a-fA-F]{0,3})?")
_INDEX = re.compile(rb"0|[1-9][0-9]{0,17}")
_INTEGER = re.compile(rb"-?(?:0|[1-9][0-9]*)")
_SCALAR = re.compile(rb"([+-]?)(?:([0-9]+)/([0-9]+)|([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?)([0-9]+))?)")
# Whole rows as they are usually written: a short cut, which accepts nothing that the token reader does not.
_POINT_ROW = re.compile(rb'[ \n]*\["(-?[0-9]{1,999})(?:/([0-9]{1,999}))?", ?"(-?[0-9]{1,999})(?:/([0-9]{1,999}))?"\]')
_CYCLE_ROW = re.compile(rb"[ \n]*\[((?:0|[1-9][0-9]{0,17})(?:, ?(?:0|[1-9][0-9]{0,17}))*)\]")


class Tokens:
    """The tokens of one file: punctuation, strings with their quotes, numbers. Only ASCII, no true, false and null."""

    def __init__(self, file: BinaryIO, name: str, limits: Limits) -> None:
        self.file, self.name, self.limits = file, name, limits
        self.data = b""
        self.at = 0
        self.offset = 0  # of data[0] in the file
        self.start = 0  # of the last token in the file
        self.last = b""  # the last string or number
        self.is_over = False
        self.items = 0
        self.digest = hashlib.sha256()

    def _more(self) -> bool:
        """Read on, keeping data[at:]; return False at the end of the file or of what may be read of it."""
        if self.is_over:
            return False
        block = self.file.read(_BLOCK)
        self.data = self.data[self.at :]
        self.offset += self.at
        self.at = 0
        room = self.limits.bytes - self.offset - len(self.data)
        self.is_over = len(block) > room
        self.digest.update(block)
        self.data += block[:room]
        return bool(block[:room])

    def peek(self) -> bytes:
        """Return the byte that the next token begins with, b"" at the end."""
        while True:
            space = _SPACE.match(self.data, self.at)
            self.at = space.end() if space else self.at
            self.start = self.offset + self.at
            if self.at < len(self.data) or not (self._more() or self.is_over):
                return self.data[self.at : self.at + 1]
            if self.at == len(self.data):
                self.too_many(self.limits.bytes, "bytes")

    def next(self) -> bytes:
        """Return the next token, b"" at the end."""
        first = self.peek()
        if first in b"[]{}:,":
            self.at += len(first)
            return first
        pattern = _STRING if first == b'"' else _NUMBER
        while True:
            match = pattern.match(self.data, self.at)
            length = match.end() - self.at if match else 0
            if length > 2 * self.limits.digits + 16:
                self.too_long()
            # An escape has six bytes: whatever stopped the match farther from the end stands.
            if self.at + length + 6 < len(self.data) or not self._more():
                break
        end = self.at + length
        if self.is_over and (end == len(self.data) or (first == b'"' and _CUT_ESCAPE.fullmatch(self.data, end))):
            self.too_many(self.limits.bytes, "bytes")
        if first == b'"' and self.data[end : end + 1] == first:
            end += 1
        elif first == b'"' or length == 0:
            self.wrong("a token")
        self.last, self.at = self.data[self.at : end], end
        return self.last

    def expect(self, token: bytes) -> None:
        """Pass the token given."""
        if self.next() != token:
            self.wrong(token.decode())

    def wrong(self, expected: str) -> NoReturn:
        """Refuse the last token."""
        raise Refused("format", f"{self.name}: byte {self.start}: {expected} expected")

    def too_long(self) -> NoReturn:
        raise Refused("size", f"{self.name}: byte {self.start}: too long")

    def too_many(self, limit: int, what: str) -> NoReturn:
        raise Refused("size", f"{self.name}: more than {limit} {what}")

    def count(self, more: int) -> None:
        """Count items of lists."""
        self.items += more
        if self.items > self.limits.items:
            self.too_many(self.limits.items, "items")


Shape = Callable[[Tokens], Any]
OPTIONAL: Mapping[str, Any] = {"holes": [], "name": ""}


def read_object(tokens: Tokens, shapes: Mapping[str, Shape]) -> dict[str, Any]:
    """Return the values of the object that the file is, each key once but for `OPTIONAL` ones, and its sha256."""
    found: dict[str, Any] = {}
    tokens.expect(b"{")
    while True:
        key = tokens.next()
        name = key[1:-1].decode()
        if key[:1] != b'"' or name not in shapes or name in found:
            tokens.wrong("another key")
        tokens.expect(b":")
        found[name] = shapes[name](tokens)
        token = tokens.next()
        if token == b"}":
            break
        if token != b",":
            tokens.wrong(", or }")
    if tokens.next():
        tokens.wrong("the end")
    for name in shapes:
        if name not in found:
            if name not in OPTIONAL:
                raise Refused("format", f"{tokens.name}: no {name}")
            found[name] = OPTIONAL[name]
    return found | {"sha256": tokens.digest.hexdigest()}


def items(tokens: Tokens) -> Iterator[None]:
    """Stop before each item of a list."""
    tokens.expect(b"[")
    if tokens.peek() == b"]":
        tokens.next()
        return
    while True:
        tokens.count(1)
        yield
        token = tokens.next()
        if token == b"]":
            return
        if token != b",":
            tokens.wrong(", or ]")


def text(tokens: Tokens) -> str:
    token = tokens.next()
    if token[:1] != b'"':
        tokens.wrong("a string")
    return token[1:-1].decode()


def scalar(tokens: Tokens) -> Ratio:
    """Return numerator and denominator > 0 of an integer, or of a string that is an integer, decimal or fraction."""
    token = tokens.next()
    body = token[1:-1] if token[:1] == b'"' else token
    match = _SCALAR.fullmatch(body)
    if not match or (body is token and not _INTEGER.fullmatch(token)):
        tokens.wrong("a scalar")
    sign, numerator, denominator, whole, part, exponent_sign, exponent = match.groups(b"")
    mantissa = numerator or whole + part
    if not mantissa:
        tokens.wrong("a scalar")
    # Nine digits of an exponent are beyond any limit, and are not read further.
    shift = int(exponent[:9]) if exponent else 0
    if len(exponent) > 9 or max(len(mantissa) + shift, len(denominator)) > tokens.limits.digits:
        tokens.too_long()
    shift = (-shift if exponent_sign == b"-" else shift) - len(part)
    value, over = integer(mantissa), integer(denominator) if denominator else 10 ** max(-shift, 0)
    if over == 0:
        tokens.wrong("a denominator that is not zero")
    return (-value if sign == b"-" else value) * 10 ** max(shift, 0), over


def integer(digits: bytes) -> int:
    """Return the integer with these digits, however small the interpreter's limit for one conversion is."""
    value = 0
    for i in range(0, len(digits), 600):
        part = digits[i : i + 600]
        value = value * 10 ** len(part) + int(part)
    return value


class Claim(NamedTuple):
    """A number that the certificate states, and how it is written there."""
    value: Ratio
    text: str


def claim(tokens: Tokens) -> Claim:
    """Return a scalar that is a string."""
    value = scalar(tokens)
    if tokens.last[:1] != b'"':
        tokens.wrong("a string")
    return Claim(value, tokens.last[1:-1].decode())


def points(tokens: Tokens) -> list[Point]:
    """Return the points of a list of pairs of scalars."""
    found: list[Point] = []
    for _ in items(tokens):
        match = _POINT_ROW.match(tokens.data, tokens.at)
        if match and max(map(len, match.groups(b""))) <= tokens.limits.digits:
            p, q, r, s = map(int, match.groups(b"1"))
            if q and s:
                tokens.at = match.end()
                found.append(point_of((p, q), (r, s)))
                continue
        tokens.expect(b"[")
        x = scalar(tokens)
        tokens.expect(b",")
        y = scalar(tokens)
        tokens.expect(b"]")
        found.append(point_of(x, y))
    return found


def point_of(x: Ratio, y: Ratio) -> Point:
    """Return a point over one denominator."""
    (p, q), (r, s) = x, y
    common = gcd(q, s)
    q, s = q // common, s // common
    return p * s, r * q, q * s * common


@dataclass(frozen=True, slots=True)
class Cycles:
    """Lists of indices, one after the other: cycle i is flat[start[i] : start[i + 1]]."""

    flat: "array[int]"
    start: "array[int]"

    def __len__(self) -> int:
        return len(self.start) - 1

    def __getitem__(self, i: int) -> "array[int]":
        return self.flat[self.start[i] : self.start[i + 1]]


def cycles(tokens: Tokens) -> Cycles:
    """Return a list of lists of indices."""
    flat, start = array("q"), array("q", [0])
    for _ in items(tokens):
        match = _CYCLE_ROW.match(tokens.data, tokens.at)
        if match:
            tokens.at = match.end()
            row = list(map(int, match[1].split(b",")))
            tokens.count(len(row))
            flat.extend(row)
        else:
            flat.extend(indices(tokens))
        start.append(len(flat))
    return Cycles(flat, start)


def indices(tokens: Tokens) -> "array[int]":
    """Return a list of indices."""
    found = array("q")
    for _ in items(tokens):
        token = tokens.next()
        if not _INDEX.fullmatch(token):
            tokens.wrong("an index")
        found.append(int(token))
    return found


class Pslg(NamedTuple):
    """The input; edge e joins edges[e][0] and edges[e][1]."""
    format: None
    vertices: list[Point]
    edges: Cycles
    holes: list[Point]
    name: str
    sha256: str


class Mesh(NamedTuple):
    """The mesh: the input's vertices come first."""
    format: None
    kind: str
    vertices: list[Point]
    faces: Cycles
    sha256: str


class Certificate(NamedTuple):
    """The certificate: `vertices` go on after the mesh's."""
    format: None
    pslg_sha256: str
    mesh_sha256: str
    mfs_squared_at_least: Claim
    mfs_at_least: Claim
    input_mfs_squared_at_most: Claim
    degradation_squared_at_most: Claim
    degradation_at_most: Claim
    witness: "array[int]"
    hole_faces: "array[int]"
    vertices: list[Point]
    faces: Cycles
    sha256: str


PSLG: dict[str, Shape] = {
    "format": lambda tokens: tokens.expect(b'"exactmesh-pslg/1"'),
    "vertices": points, "edges": cycles, "holes": points, "name": text}
MESH: dict[str, Shape] = {
    "format": lambda tokens: tokens.expect(b'"exactmesh-mesh/1"'), "kind": text, "vertices": points, "faces": cycles}
CERTIFICATE: dict[str, Shape] = {
    "format": lambda tokens: tokens.expect(b'"exactmesh-certificate/1"'), "pslg_sha256": text, "mesh_sha256": text,
    "mfs_squared_at_least": claim, "mfs_at_least": claim, "input_mfs_squared_at_most": claim,
    "degradation_squared_at_most": claim, "degradation_at_most": claim,
    "witness": indices, "hole_faces": indices, "vertices": points, "faces": cycles}


# --- geometry: signs of polynomials ---


def turn(a: Point, b: Point, c: Point) -> int:
    """Return a number that is positive, 0 or negative as a, b, c turn left, are collinear, or turn right."""
    return (a[0] * (b[1] * c[2] - c[1] * b[2]) - a[1] * (b[0] * c[2] - c[0] * b[2])
            + a[2] * (b[0] * c[1] - c[0] * b[1]))


def minus(a: Point, b: Point) -> tuple[int, int]:
    """Return a - b, times the positive a[2] b[2]."""
    return a[0] * b[2] - b[0] * a[2], a[1] * b[2] - b[1] * a[2]


def dot(u: tuple[int, int], v: tuple[int, int]) -> int:
    return u[0] * v[0] + u[1] * v[1]


def distance_squared(t: Point, a: Point, b: Point) -> Ratio:
    """Return the squared distance of t from the closed segment a b; a = b is allowed."""
    edge, from_a = minus(b, a), minus(t, a)
    if dot(edge, from_a) <= 0:
        return dot(from_a, from_a), (a[2] * t[2]) ** 2
    from_b = minus(t, b)
    if dot(edge, from_b) >= 0:
        return dot(from_b, from_b), (b[2] * t[2]) ** 2
    # `edge` is too long by a[2] b[2], `from_a` by a[2] t[2]: what is left is (a[2] t[2])^2.
    area = edge[0] * from_a[1] - edge[1] * from_a[0]
    return area * area, dot(edge, edge) * (a[2] * t[2]) ** 2


def is_less(x: Ratio, y: Ratio) -> bool:
    return x[0] * y[1] < y[0] * x[1]


def corners_of(at: Sequence[Point]) -> list[int]:
    """Return the places of the three left turns of a cycle of points that goes straight on elsewhere, else []."""
    count = len(at)
    if count == 3:
        return [0, 1, 2] if turn(*at) > 0 else []
    corners = []
    for i in range(count):
        before, here, after = at[i - 1], at[i], at[(i + 1) % count]
        sign = turn(before, here, after)
        if sign > 0:
            corners.append(i)
        elif sign < 0 or dot(minus(here, before), minus(after, here)) <= 0:
            return []
    return corners if len(corners) == 3 else []


def has_room(cycle: Sequence[int], at: Sequence[Point], corners: Sequence[int], watched: int, bound: Ratio) -> bool:
    """Return whether each vertex below `watched` of a face has neighbours on the cycle, and sides of the triangle that
    do not contain it, at a squared distance of at least `bound` only."""
    i, j, k = corners
    count = len(cycle)
    for first, last, other in ((i, j, k), (j, k, i), (k, i, j)):
        for place in range(first, last if last > first else last + count):
            t = at[place % count]
            if cycle[place % count] < watched and (
                    is_less(distance_squared(t, at[last], at[other]), bound) or
                    (place > first and is_less(distance_squared(t, at[other], at[first]), bound))):
                return False
    return count == 3 or not any(min(cycle[i - 1], cycle[i]) < watched and
                                 is_less(distance_squared(at[i - 1], at[i], at[i]), bound) for i in range(count))


# --- the clauses ---


class Checker:
    """All three files; vertices and faces of the mesh come before those of the rest, which the certificate holds."""

    def __init__(self, pslg: Pslg, mesh: Mesh, certificate: Certificate) -> None:
        self.pslg, self.mesh, self.certificate = pslg, mesh, certificate
        self.given, self.watched = len(pslg.vertices), len(mesh.vertices)
        self.points = mesh.vertices + certificate.vertices
        self.meshed = len(mesh.faces)
        self.count = self.meshed + len(certificate.faces)
        # Half-edge h leads from the vertex origin[h] to the next one of its face.
        self.origin = mesh.faces.flat + certificate.faces.flat
        shift = len(mesh.faces.flat)
        self.start = mesh.faces.start + array("q", (shift + s for s in certificate.faces.start[1:]))

    def run(self) -> str:
        """Return what is proved; raise `Refused` for the first clause that fails."""
        for clause in (self.check_files, self.check_input_vertices, self.check_faces, self.check_box,
                       self.check_tiling, self.check_use, self.check_input_edges, self.check_border,
                       self.check_holes, self.check_claims):
            clause()
        found = self.certificate
        return (f"{self.mesh.kind} mesh: mfs_squared >= {found.mfs_squared_at_least.text}"
                f" (mfs >= {found.mfs_at_least.text}),"
                f" degradation_squared <= {found.degradation_squared_at_most.text}"
                f" (degradation <= {found.degradation_at_most.text})")

    def named(self, face: int) -> str:
        return f"mesh face {face}" if face < self.meshed else f"rest face {face - self.meshed}"

    def edge(self, h: int) -> str:
        return f"edge [{self.origin[h]}, {self.target(h)}]"

    def target(self, h: int) -> int:
        face = self.face_of[h]
        return self.origin[h + 1] if h + 1 < self.start[face + 1] else self.origin[self.start[face]]

    def check_files(self) -> None:
        """The files belong together; indices are in range."""
        pslg, mesh, found = self.pslg, self.mesh, self.certificate
        if found.pslg_sha256 != pslg.sha256:
            raise Refused("hash", "PSLG")
        if found.mesh_sha256 != mesh.sha256:
            raise Refused("hash", "MESH")
        if mesh.kind not in ("classic", "nonproper", "proper"):
            raise Refused("kind", "MESH")
        lists = ((pslg.edges, "PSLG: edge", self.given, 2, 2), (mesh.faces, "MESH: face", self.watched, 3, 0),
                 (found.faces, "CERTIFICATE: face", len(self.points), 3, 0))
        for rows, name, bound, least, most in lists:
            for i in range(len(rows)):
                row = rows[i]
                if len(row) < least or len(row) > (most or len(row)) or max(row) >= bound:
                    raise Refused("index", f"{name} {i}")
        if len(found.witness) != 3 or max(found.witness) >= self.given:
            raise Refused("index", "CERTIFICATE: witness")
        if len(found.hole_faces) != len(pslg.holes) or max(found.hole_faces, default=-1) >= len(found.faces):
            raise Refused("index", "CERTIFICATE: hole_faces")

    def check_input_vertices(self) -> None:
        """The input's vertices come first in the mesh, unchanged; a classic mesh has no others."""
        for v, p in enumerate(self.pslg.vertices):
            if v >= self.watched or minus(p, self.points[v]) != (0, 0):
                raise Refused("input-vertices", f"vertex {v}")
        if self.mesh.kind == "classic" and self.watched > self.given:
            raise Refused("steiner", f"vertex {self.given}")

    def check_faces(self) -> None:
        """Each face is a counter-clockwise triangle, and leaves room around each vertex of the mesh on it."""
        if not self.meshed:
            raise Refused("domain", "MESH: no face")
        bound = self.certificate.mfs_squared_at_least.value
        if bound[0] <= 0:
            raise Refused("bound", "mfs_squared_at_least is not positive")
        for face in range(self.count):
            cycle = self.origin[self.start[face] : self.start[face + 1]]
            at = [self.points[v] for v in cycle]
            corners = corners_of(at)
            if not corners:
                raise Refused("face-shape", self.named(face))
            if len(cycle) > 3 and face < self.meshed and self.mesh.kind != "nonproper":
                raise Refused("face-size", self.named(face))
            if not has_room(cycle, at, corners, self.watched, bound):
                raise Refused("feature", self.named(face))

    def check_box(self) -> None:
        """The first four vertices of the rest are an upright rectangle, counter-clockwise from the lower left."""
        steps = [minus(q, p) for p, q in pairwise(self.certificate.vertices[:4])]
        if [(x > 0) - (x < 0) for step in steps for x in step] != [1, 0, 0, 1, -1, 0] or minus(
                self.certificate.vertices[3], self.certificate.vertices[0])[0] != 0:
            raise Refused("box", "CERTIFICATE: vertices")

    def check_tiling(self) -> None:
        """Each directed edge occurs once, and so does its reverse, but for the four sides of the box."""
        origin, start, size = self.origin, self.start, len(self.points)
        self.face_of = array("q", (face for face in range(self.count) for _ in range(start[face], start[face + 1])))
        keys = array("q")
        for h in range(len(origin)):
            u, v = origin[h], self.target(h)
            keys.append(2 * (u * size + v) if u < v else 2 * (v * size + u) + 1)
        self.order = array("q", sorted(range(len(keys)), key=keys.__getitem__))
        self.keys = array("q", (keys[h] for h in self.order))
        self.twin = array("q", [-1]) * len(keys)
        self.sides: list[int] = []
        i = 0
        while i < len(keys):
            h, key = self.order[i], self.keys[i]
            after, second = (self.keys[i + k] if i + k < len(keys) else -1 for k in (1, 2))
            if after == key or after == second == key ^ 1:
                raise Refused("overlap", self.edge(h))
            if after == key ^ 1:
                g = self.order[i + 1]
                self.twin[h], self.twin[g] = g, h
                i += 1
            else:
                u, v = origin[h] - self.watched, self.target(h) - self.watched
                if not 0 <= u < 4 or v != (u + 1) % 4:
                    raise Refused("boundary", self.edge(h))
                self.sides.append(h)
            i += 1

    def check_use(self) -> None:
        """Each vertex is on a face, each new one of the mesh on a face of the mesh."""
        used = bytearray(len(self.points))
        for v in self.origin:
            used[v] = 1
        used[self.given : self.watched] = bytes(self.watched - self.given)
        for v in self.mesh.faces.flat:
            used[v] = 1
        if (unused := used.find(0)) >= 0:
            raise Refused("unused-vertex", f"vertex {unused}")

    def check_input_edges(self) -> None:
        """Each edge of the input is an edge of the tiling, and no two are the same."""
        size = len(self.points)
        self.is_input = bytearray(len(self.origin))
        for e in range(len(self.pslg.edges)):
            u, v = sorted(self.pslg.edges[e])
            key = 2 * (u * size + v)
            place = bisect_left(self.keys, key)
            if place == len(self.keys) or self.keys[place] != key:
                raise Refused("input-edge", f"edge {e}")
            h = self.order[place]
            if self.is_input[h]:
                raise Refused("repeated-edge", f"edge {e}")
            self.is_input[h] = self.is_input[self.twin[h]] = 1

    def check_border(self) -> None:
        """Only edges of the input part mesh and rest."""
        first_of_rest = self.start[self.meshed]
        for h in range(first_of_rest):
            if self.twin[h] >= first_of_rest and not self.is_input[h]:
                raise Refused("border", self.edge(h))

    def check_holes(self) -> None:
        """The rest is what is reached from the box and from hole points without crossing the input."""
        reached = bytearray(self.count)
        self.flood([self.face_of[h] for h in self.sides], reached, 1)
        for i, p in enumerate(self.pslg.holes):
            face = self.meshed + self.certificate.hole_faces[i]
            if not self.is_inside(p, face):
                raise Refused("hole", f"hole {i}: not inside rest face {face - self.meshed}")
            if reached[face] == 1:
                raise Refused("hole", f"hole {i}: outside")
            self.flood([face], reached, 2)
        if (missed := reached.find(0, self.meshed)) >= 0:
            raise Refused("domain", f"{self.named(missed)}: neither outside nor in a hole")

    def is_inside(self, p: Point, face: int) -> bool:
        """Return whether p is in the closed face, and neither on an edge of the input nor one of its vertices."""
        for h in range(self.start[face], self.start[face + 1]):
            u, v = self.origin[h], self.target(h)
            a, b = self.points[u], self.points[v]
            sign = turn(a, b, p)
            from_a, from_b = minus(p, a), minus(p, b)
            if sign < 0 or (u < self.given and from_a == (0, 0)):
                return False
            if sign == 0 and self.is_input[h] and dot(from_a, from_b) <= 0:
                return False
        return True

    def flood(self, waiting: list[int], reached: bytearray, mark: int) -> None:
        """Mark the faces of the rest that are reached from those waiting without crossing the input."""
        for face in waiting:
            reached[face] = mark
        while waiting:
            face = waiting.pop()
            for h in range(self.start[face], self.start[face + 1]):
                if self.twin[h] >= 0 and not self.is_input[h]:
                    other = self.face_of[self.twin[h]]
                    if not reached[other]:
                        reached[other] = mark
                        waiting.append(other)

    def check_claims(self) -> None:
        """The witness is a pair of the input as near as stated; the degradation and the decimals follow."""
        found, edges = self.certificate, self.pslg.edges
        v, a, b = found.witness
        if v in (a, b) or not (a == b or any(set(edges[e]) == {a, b} for e in range(len(edges)))):
            raise Refused("witness", "no pair of the input")
        p, q = found.input_mfs_squared_at_most.value
        if is_less((p, q), distance_squared(self.points[v], self.points[a], self.points[b])):
            raise Refused("witness", "input_mfs_squared_at_most")
        r, s = found.mfs_squared_at_least.value
        if is_less(found.degradation_squared_at_most.value, (p * s, q * r)):
            raise Refused("claim", "degradation_squared_at_most")
        n, d = found.mfs_at_least.value
        if n < 0 or is_less((r, s), (n * n, d * d)):
            raise Refused("claim", "mfs_at_least")
        n, d = found.degradation_at_most.value
        if n < 0 or is_less((n * n, d * d), found.degradation_squared_at_most.value):
            raise Refused("claim", "degradation_at_most")


def check(pslg: BinaryIO, mesh: BinaryIO, certificate: BinaryIO, limits: Limits = DEFAULT) -> tuple[bool, str]:
    """Return whether the certificate is accepted, and the line that says so; files are open for reading bytes."""
    try:
        proved = Checker(Pslg(**read_object(Tokens(pslg, "PSLG", limits), PSLG)),
                         Mesh(**read_object(Tokens(mesh, "MESH", limits), MESH)),
                         Certificate(**read_object(Tokens(certificate, "CERTIFICATE", limits), CERTIFICATE))).run()
    except Refused as refused:
        return False, f"INVALID {refused}"
    return True, f"VALID {proved}"


def main(argv: Sequence[str] | None = None) -> int:
    """Check the files named on the command line; return the exit status."""
    parser = argparse.ArgumentParser(
        description="Check a mesh and its certificate. Exit status: 0 valid, 1 invalid, 2 usage or unreadable file.")
    for name in ("PSLG", "MESH", "CERTIFICATE"):
        parser.add_argument(name.lower(), metavar=name, help=f"exactmesh-{name.lower()}/1")
    for name in ("bytes", "digits", "items"):
        parser.add_argument(f"--max-{name}", metavar="N", type=_limit, default=getattr(DEFAULT, name),
                            help=f"refuse a file with more {name} (default: %(default)s)")
    args = parser.parse_args(argv)
    try:
        with open(args.pslg, "rb") as pslg, open(args.mesh, "rb") as mesh, open(args.certificate, "rb") as certificate:
            valid, line = check(pslg, mesh, certificate, Limits(args.max_bytes, args.max_digits, args.max_items))
        print(line, flush=True)
    except (OSError, ValueError, MemoryError) as error:
        print(f"check: {str(error) or 'out of memory'}", file=sys.stderr)
        return REFUSED
    except KeyboardInterrupt:
        print("check: interrupted", file=sys.stderr)
        return INTERRUPTED
    return VALID if valid else INVALID


def _limit(text: str) -> int:
    if not re.fullmatch("[0-9]{1,9}", text):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of at most nine digits")
    return int(text)


if __name__ == "__main__":
    sys.exit(main())
