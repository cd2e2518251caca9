"""Fuzz all readers: python tests/io/fuzz_readers.py --seed N --count N [--format F].

Every input is either refused by an `InputError` of one line (a certificate's by a verdict), or read; then what was
read, once written, is read again as the same. Nothing else may happen, in time: no other exception, no hang.

Inputs are valid samples with bytes, tokens, numbers and values changed, doubled, dropped, exchanged with other samples
and formats, or are made up from the words of the format. An input that is refused for a reason not seen before, or read
in a form not seen before, is kept and changed further. Same seed, same inputs. A third of them is read under limits so
small that they matter. Exit status 0 when nothing was found; a found input is kept in the folder given by --keep.
"""

import argparse
import io
import json
import random
import re
import resource
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import patch

sys.path.extend(str(Path(__file__).parent.parent / name) for name in ("", "certificate"))

import shapely
from triples import base

from exactmesh import check
from exactmesh.certificate.record import FORMAT, Certificate, json_from_certificate
from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.dissection_json import json_from_dissection, read_dissection
from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.limits import Limits, limited
from exactmesh.io.mesh_json import json_from_mesh, mesh_from_json
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.io.read import read_mesh, read_pslg
from exactmesh.io.text import text_from_bytes
from exactmesh.io.triangle_poly import poly_from_pslg
from exactmesh.numbers.rational import rational
from exactmesh.planar.pslg import Pslg, polygon

SECONDS = 20
MEMORY = 6 << 30
KEPT = 400
TINY = Limits(bytes=700, digits=12, items=120)

# --- what is read ---


def from_bytes(read: Callable[[str], Any], data: bytes) -> Any:
    """Return what a reader of files makes of these bytes on standard input."""
    with patch("sys.stdin", SimpleNamespace(buffer=io.BytesIO(data))):
        return read("-")


def pslg(data: bytes) -> str:
    """Read and write a PSLG of any format; return its form."""
    found: Pslg = from_bytes(read_pslg, data).pslg
    require_same_by_json(data, pslg_from_json, found)
    require(from_bytes(read_pslg, json_from_pslg(found).encode()).pslg == found, "the PSLG is written otherwise")
    try:
        text = poly_from_pslg(found)
    except FormatError:
        return "no decimals"
    if found.vertices:  # with none, the vertices would be in a .node
        again = from_bytes(read_pslg, text.encode()).pslg
        require(again == Pslg(found.vertices, found.edges, found.holes), "the .poly is another PSLG")
    return f"{len(found.holes)} holes, {min(len(found.vertices), 9)} vertices, {min(len(found.edges), 9)} edges"


def mesh(data: bytes) -> str:
    found = from_bytes(read_mesh, data).mesh
    require_same_by_json(data, mesh_from_json, found)
    require(from_bytes(read_mesh, json_from_mesh(found).encode()).mesh == found, "the mesh is written otherwise")
    return f"{found.kind} {min(len(found.vertices), 9)} {min(len(found.faces), 9)}"


def dissection(data: bytes) -> str:
    found = from_bytes(read_dissection, data)
    again = from_bytes(read_dissection, json_from_dissection(found).encode())
    require(again == found, "the dissection is written otherwise")
    return f"{len(found.scales)} {len(found.pieces)}"


def certificate(data: bytes) -> str:
    """Read a certificate as the checker does; what the checker reads as PSLG or mesh, the package reads as well."""
    shapes = {"exactmesh-pslg/1": check.PSLG, "exactmesh-mesh/1": check.MESH}
    for name, read in (("exactmesh-pslg/1", pslg), ("exactmesh-mesh/1", mesh)):
        try:
            checked_by_checker(data, shapes[name])
        except check.Refused:
            continue
        try:
            read(data)
        except InputError as error:
            # The checker looks at indices and kinds later on.
            wanted = r"does not exist|an edge|both ends|at least three|is expected, not|more than \d+ "
            require(re.search(wanted, str(error)) is not None, f"the checker reads it, but {error}")
        return name
    try:
        found = checked_by_checker(data, check.CERTIFICATE)
    except check.Refused as refused:
        raise InputError(str(refused)) from None
    text = json_from_certificate(Certificate(
        *(found[key] for key in ("pslg_sha256", "mesh_sha256")),
        *(found[key].text for key in ("mfs_squared_at_least", "mfs_at_least", "input_mfs_squared_at_most")),
        tuple(found["witness"]), *(found[key].text for key in ("degradation_squared_at_most", "degradation_at_most")),
        tuple(Point(rational(x) / w, rational(y) / w) for x, y, w in found["vertices"]),
        tuple(tuple(cycle) for cycle in cycles(found["faces"])), tuple(found["hole_faces"])))
    again = checked_by_checker(text.encode(), check.CERTIFICATE)
    for key in found:
        same = cycles(again[key]) == cycles(found[key]) if key == "faces" else (
            key == "sha256" or again[key] == found[key] or key == "vertices")
        require(same, f"{key} is written otherwise")
    require(all(check.minus(p, q) == (0, 0) for p, q in zip(again["vertices"], found["vertices"], strict=True)),
            "vertices are written otherwise")
    return f"certificate {len(found['witness'])} {min(len(found['vertices']), 9)}"


def checked_by_checker(data: bytes, shapes: Any) -> dict[str, Any]:
    return check.read_object(check.Tokens(io.BytesIO(data), "FILE", check.Limits()), shapes)


def cycles(found: check.Cycles) -> list[list[int]]:
    return [list(found[i]) for i in range(len(found))]


def require_same_by_json(data: bytes, read: Callable[[str], Any], found: Any) -> None:
    """Require that the plain reader of an exact format finds the same as the one that takes short cuts."""
    if b"exactmesh-" in data:
        require(read(text_from_bytes(data)) == found, "short cuts lead elsewhere")


class Broken(Exception):
    """What was read is not what it should be."""


def require(holds: bool, what: str) -> None:
    if not holds:
        raise Broken(what)


READERS: dict[str, Callable[[bytes], str]] = {
    "pslg": pslg, "geojson": pslg, "wkt": pslg, "poly": pslg, "mesh": mesh, "dissection": dissection,
    "certificate": certificate, "svg": pslg, "cgshop": pslg, "wkb": pslg, "dxf": pslg}


# --- samples and words ---

_TRIANGLE = '"vertices": [["0", "0"], ["10", "0.5"], ["-1e1", "22/7"]]'
_RING = "[[0, 0], [9, 0], [9, 9.5], [0, 1e1], [0, 0]]"
_HOLE = "[[2, 2], [3, 2, 7], [3, 3], [2, 2]]"
_BOX, _HOLES = "0 0, 9 0, 9 9.5, 0 1e1, 0 0", "2 2, 3 2, 3 3, 2 2"
_GEOMETRY = {
    "Point": "[3, 4]", "MultiPoint": "[[1, 2], [3.5, -4e-2]]", "LineString": "[[0, 0], [1, 1]]",
    "MultiLineString": "[[[0, 0], [1, 1]], [[5, 5], [6, 5]]]", "Polygon": f"[{_RING}, {_HOLE}]",
    "MultiPolygon": f"[[{_RING}, {_HOLE}], [[[20, 0], [21, 0], [21, 1], [20, 0]]]]"}
TEXTS: dict[str, list[str]] = {
    "pslg": [
        f'{{"format": "exactmesh-pslg/1", {_TRIANGLE}, "edges": [[0, 1], [1, 2], [2, 0]], "holes": [["1", "1/2"]], '
        '"name": "a \\u00fc"}',
        '{"format": "exactmesh-pslg/1",\n "vertices": [[0, 0], [0.1, 3], [1e3, -7]],\n "edges": []}\n',
        f'{{"name": "", "holes": [], "edges": [[1, 0]], {_TRIANGLE}, "format": "exactmesh-pslg/1"}}'],
    "geojson": [
        *(f'{{"type": "{kind}", "coordinates": {text}}}' for kind, text in _GEOMETRY.items()),
        '{"type": "FeatureCollection", "crs": null, "features": [{"type": "Feature", "properties": {"a": [1, true]}, '
        f'"geometry": {{"type": "Polygon", "coordinates": [{_RING}]}}}}, '
        '{"type": "Feature", "properties": null, "geometry": null}]}',
        '{"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 2, 3]}, '
        '{"type": "GeometryCollection", "geometries": [{"type": "LineString", "coordinates": [[0, 0], [1, 2]]}]}]}'],
    "wkt": [
        f"POLYGON (({_BOX}), ({_HOLES}))", f"MULTIPOLYGON ((({_BOX}), ({_HOLES})), ((20 0, 21 0, 21 1, 20 0)))",
        "POINT (3 -.5e1)", "multipoint z ((1 2 3), (3.5 4 5))", "MULTIPOINT (1 2, 3 4)", "LINESTRING (0 0, 1 1, 2 0)",
        "MULTILINESTRING ((0 0, 1 1), (5 5, 6 5))",
        f"GEOMETRYCOLLECTION (POINT (1 2), GEOMETRYCOLLECTION (POLYGON (({_BOX}))), LINESTRING Z (0 0 1, 7 7 1))"],
    "poly": [
        "3 2 0 0\n0 0 0\n1 10 .5\n2 -1e1 3.\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 1 .25\n",
        "# a comment\n4 2 1 1\n1 0 0 7 1\n2 4 0 7 1\n3 4 4 7 0\n4 0 4 7 0\n\n2 1\n1 1 2 5\n2 2 3 6\n0\n1\n1 1 1 3 .1\n",
        "1\n1 0.5 2\n0\n0\n"],
    "svg": [
        '<svg xmlns="http://www.w3.org/2000/svg"><g><path d="M0 0 L9 0 9,9.5 h-9z m2,2 l1 0 V3 Z M1e1-.5.5 2" '
        'fill="none"/></g><polygon points="20,0 21,0 21,1"/></svg>',
        '<?xml version="1.0"?>\n<svg><title>a</title><rect x="0" y="0" width="4" height="3.5"/>'
        '<polyline points="1 1 2 2 3 1"/><line x1="1" y1="2" x2="2" y2="2.5"/></svg>'],
    "cgshop": [
        '{"content_type": "CG_SHOP_2025_Instance", "instance_uid": "a", "num_points": 5, "points_x": [0, 9, 9, 0, 4], '
        '"points_y": [0, 0, 9, 9, 5], "region_boundary": [0, 1, 2, 3], "num_constraints": 1, '
        '"additional_constraints": [[0, 4]]}'],
    "dxf": [
        "0\nSECTION\n2\nENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n9\n21\n0.5\n0\nLWPOLYLINE\n100\nAcDbEntity\n8\n0\n"
        "100\nAcDbPolyline\n90\n3\n70\n1\n"
        "10\n1\n20\n1\n10\n2\n20\n1\n10\n2\n20\n2\n0\nPOINT\n8\nhole\n10\n1.8\n20\n1.2\n0\nENDSEC\n0\nEOF\n"],
}


@cache
def samples(name: str) -> tuple[bytes, ...]:
    """Return valid inputs of a format."""
    if name in TEXTS:
        return tuple(text.encode() for text in TEXTS[name])
    if name == "wkb":
        return tuple(bytes(shapely.to_wkb(shapely.from_wkt(text))) for text in TEXTS["wkt"])
    if name == "certificate":
        return tuple(file for base_name in ("square", "ring with a hole, classic") for file in base(base_name).files())
    if name == "mesh":
        return tuple(base(key).files()[1] for key in ("square", "ring with a hole, classic", "two squares"))
    square, bar = polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), polygon([(0, 0), (4, 0), (4, 1), (0, 1)])
    triangle = polygon([(0, 0), (8, 0), (1, 1)])
    return tuple(json_from_dissection(dissect(pair, False).dissection).encode()
                 for pair in ([square, bar], [square, triangle]))


NUMBERS = [
    "0", "-0", "1", "-1", "7", "2", "3", "1.5", "-2.25", ".5", "5.", "1e2", "1E-3", "1e400", "-1e-400", "1e100000",
    "1e100001", "22/7", "1/0", "-3/9", "+4", "0x10", "1_0", "01", "1e", "--1", "NaN", "Infinity", "-Infinity", "nan",
    "inf", "9" * 25, "1" + "0" * 60, "4294967296", "2147483648", "9223372036854775808", "1000000000", "-5",
    "9" * 5000, "1/" + "7" * 5000, "٣", "²", "1 2", "sqrt(2)", "sqrt(-1)", "(1+sqrt(5))/2", "2**9", "1/3+1/7",
    "0.1e-5", "1e+2", "5e-324", "1.7976931348623157e308", "1e309"]
KEYS = ["format", "type", "vertices", "edges", "faces", "holes", "name", "kind", "coordinates", "geometry",
        "geometries", "features", "pieces", "scales", "polygons", "motions", "matrix", "translation", "witness",
        "hole_faces", "mfs_at_least", "points_x", "region_boundary", "additional_constraints"]
NAMES = ["exactmesh-pslg/1", "exactmesh-mesh/1", "exactmesh-dissection/1", FORMAT, "classic", "internal", *_GEOMETRY,
         "Feature", "FeatureCollection", "GeometryCollection"]
WORDS = {
    "json": ['"', "{", "}", "[", "]", ",", ":", "null", "true", "false", '""', "[]", "{}", '"\\ud800"', '"\\u0000"',
             "\\", '"a', "[[", "]]", "[[[[[[", *(f'"{word}"' for word in (*KEYS, *NAMES))],
    "wkt": ["(", ")", ",", "((", "))", "POINT", "polygon", "MULTIPOLYGON", "LINESTRING", "MULTIPOINT", "EMPTY", "Z",
            "M", "ZM", "SRID=4326;", "GEOMETRYCOLLECTION", "GEOMETRYCOLLECTION (", "CURVEPOLYGON", "()", "POINT (1 2)"],
    "svg": ["<svg>", "</svg>", "<g>", "</g>", "<path d=", "/>", ">", "<", '"', "M", "m0 0", "L", "z", "H", "C", "A",
            "<polygon points=", " transform=", "<rect ", "width=", "<!ENTITY a", "<!DOCTYPE", "&amp;", "&a;", "<!--"],
    "dxf": ["\n", "0\n", "10\n", "20\n", "LINE\n", "ARC\n", "INSERT\n", "SECTION\n2\nBLOCKS\n", "LWPOLYLINE\n",
            "POLYLINE\n", "VERTEX\n", "SEQEND\n", "42\n1\n", "90\n1000000000\n", "999\n", "EOF\n", "70\n-1\n"],
    "poly": ["\n", "#", "# x\n", "0\n", "1\n", "\n\n", "3 2 0 0\n", "0 0 0\n", "1 1 2\n", "1000000000\n", "-1"],
    "all": ["\r\n", "\r", "\t", " ", "\ufeff", "\0", "\x1a", "é", "\N{EM SPACE}", "\x85", "\udcff", "\U0001f600"],
}
FAMILY = {"wkt": "wkt", "poly": "poly", "svg": "svg", "dxf": "dxf", "wkb": "wkt"}


def random_value(source: random.Random, depth: int = 0) -> Any:
    """Return a JSON value made up from the words and numbers of the formats."""
    kind = source.randrange(8 if depth < 5 else 5)
    if kind < 3:
        return source.choice(NUMBERS)
    if kind == 3:
        return source.choice([None, True, False, 0, 1, 2, -1, 10**9, 10**30, 0.5, 1e300, 5e-324, "", "é", "\ud800"])
    if kind == 4:
        return source.choice(NAMES)
    if kind < 7:
        return [random_value(source, depth + 1) for _ in range(source.choice((0, 1, 2, 2, 2, 3, 4)))]
    return {source.choice(KEYS): random_value(source, depth + 1) for _ in range(source.randrange(4))}


def with_other_value(source: random.Random, data: bytes) -> bytes:
    """Return a JSON text in which one value, somewhere, is another, or dropped, doubled or moved."""
    try:
        root = [json.loads(data)]
    except (ValueError, RecursionError):
        return data
    spots: list[tuple[Any, Any]] = []
    waiting: list[Any] = [root]
    while waiting:
        holder = waiting.pop()
        for key in list(holder) if isinstance(holder, dict) else range(len(holder)):
            spots.append((holder, key))
            if isinstance(holder[key], (list, dict)):
                waiting.append(holder[key])
    holder, key = source.choice(spots)
    other_holder, other_key = source.choice(spots)
    match source.randrange(6):
        case 0:
            holder[key] = random_value(source)
        case 1:
            holder[key] = source.choice(NUMBERS)
        case 2 if holder is not root:
            del holder[key]
        case 3 if isinstance(holder, list) and holder is not root:
            holder.insert(key, holder[key])
        case 4:
            holder[key], other_holder[other_key] = other_holder[other_key], holder[key]
        case _:
            holder[key] = [holder[key]]
    try:
        return json.dumps(root[0], ensure_ascii=source.random() < 0.5).encode("utf-8", "surrogatepass")
    except (ValueError, RecursionError):  # it now holds itself
        return data


def made_up(source: random.Random, name: str) -> bytes:
    """Return an input made from the words of a format only."""
    family = FAMILY.get(name, "json")
    if family == "json" and source.random() < 0.5:
        return json.dumps(random_value(source)).encode()
    words = [source.choice(source.choice((WORDS[family], NUMBERS, WORDS[family], WORDS["all"]))
                           if source.random() < 0.9 else WORDS["all"]) for _ in range(source.randrange(1, 25))]
    return source.choice(("", " ", "\n")).join(words).encode("utf-8", "surrogatepass")


_NUMBER = re.compile(rb"-?[0-9]+")


def changed(source: random.Random, name: str, data: bytes, others: Sequence[bytes]) -> bytes:
    """Return the input with one thing changed."""
    a, b = sorted((source.randrange(len(data) + 1), source.randrange(len(data) + 1)))
    b = min(b, a + source.choice((1, 2, 4, 16, 1000)))
    family = FAMILY.get(name, "json")
    match source.randrange(12 if family == "json" else 9):
        case 0:
            return data[:a] + data[b:]
        case 1:
            return data[:b] + data[a:b] * source.choice((1, 1, 1, 2, 50)) + data[b:]
        case 2:
            return data[:a] + bytes([source.randrange(256)]) + data[a + 1 :]
        case 3 | 4:
            word = source.choice(source.choice((WORDS[family], NUMBERS, WORDS["all"])))
            return data[:a] + word.encode("utf-8", "surrogatepass") + data[source.choice((a, b)) :]
        case 5 | 6:
            spots = list(_NUMBER.finditer(data))
            if not spots:
                return data + b"1"
            spot = source.choice(spots)
            number = source.choice((source.choice(NUMBERS), str(source.randrange(-2, 12))))
            return data[: spot.start()] + number.encode() + data[spot.end() :]
        case 7:
            other = source.choice(others)
            c = source.randrange(len(other) + 1)
            return data[:a] + other[c : c + source.choice((3, 20, 1000))] + data[source.choice((a, b, len(data))) :]
        case 8:
            return data[:a]
        case _:
            return with_other_value(source, data)


def inputs(source: random.Random, name: str, pool: list[bytes], others: Sequence[bytes]) -> Iterator[bytes]:
    """Yield inputs for ever; those that the caller adds to `pool` are changed further."""
    first = list(samples(name))
    yield from first
    while True:
        if source.random() < 0.1:
            yield made_up(source, name)
            continue
        data = source.choice(pool if pool and source.random() < 0.5 else first)
        for _ in range(source.choice((1, 1, 1, 1, 1, 2, 3, 6))):
            data = changed(source, name, data, others)
        yield data[:20_000]


# --- the campaign ---


class TooSlow(Exception):
    """An input took longer than it may."""


@contextmanager
def alarm() -> Iterator[None]:
    """Raise `TooSlow` in what takes longer than it may."""
    def ring(number: int, frame: object) -> None:
        raise TooSlow(f"more than {SECONDS} s")

    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def outcome(name: str, data: bytes) -> tuple[str, str]:
    """Return "read", "refused" or "FAULT", and the form of what was read, the reason, or what is wrong."""
    try:
        with alarm():
            return "read", READERS[name](data)
    except InputError as error:
        message = str(error)
        if "\n" in message or not message.isprintable() or len(message) > 1000:
            return "FAULT", f"the refusal is no line for people: {message[:200]!r}"
        return "refused", message
    except Exception as error:  # whatever it is, it should not have come up
        return "FAULT", f"{type(error).__name__}: {str(error)[:200]}"


def run(seed: int, count: int, names: Sequence[str], keep: Path | None = None) -> tuple[list[str], str]:
    """Return the faults found, and a table of what happened."""
    faults: list[str] = []
    lines = [" inputs    read refused reasons forms faults  slowest  format"]
    for name in names:
        source = random.Random(f"{seed} {name}")
        others = [sample for other in READERS for sample in samples(other)]
        pool: list[bytes] = []
        seen: set[str] = set()
        outcomes: Counter[str] = Counter()
        forms: Counter[str] = Counter()
        slowest = 0.0
        share = count // len(names) + (names.index(name) < count % len(names))
        for number, data in zip(range(share), inputs(source, name, pool, others), strict=False):
            begin = time.perf_counter()
            with limited(TINY if number % 3 == 2 else Limits()):
                kind, what = outcome(name, data)
            slowest = max(slowest, time.perf_counter() - begin)
            outcomes[kind] += 1
            form = what if kind == "read" else re.sub(r"'.*'|\".*\"|\d+", "#", what)
            if form not in seen:
                seen.add(form)
                forms[kind] += 1
                if len(data) < 3000:
                    pool.append(data)
                    del pool[:-KEPT]
            if kind == "FAULT":
                faults.append(f"{name} {number}: {what}: {data[:300]!r}")
                if keep:
                    (keep / f"{name}-{number}").write_bytes(data)
        lines.append(f"{share:7} {outcomes['read']:7} {outcomes['refused']:7} {forms['refused']:7} {forms['read']:5} "
                     f"{outcomes['FAULT']:6} {slowest:6.2f} s  {name}")
    lines.append(f"{count} inputs, seed {seed}: {f'{len(faults)} FAULTS' if faults else 'nothing found'}")
    return faults, "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=20_000)
    parser.add_argument("--format", choices=READERS, action="append", help="again for more; default: all")
    parser.add_argument("--keep", type=Path, help="folder for inputs that break the rules")
    args = parser.parse_args()
    if args.keep:
        args.keep.mkdir(parents=True, exist_ok=True)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))  # a reader that wants more is at fault
    begin = time.perf_counter()
    faults, table = run(args.seed, args.count, args.format or list(READERS), args.keep)
    print("\n".join([*faults[:30], table, f"{time.perf_counter() - begin:.0f} s"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
