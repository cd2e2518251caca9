"""Read and write the straight shapes of SVG: paths of lines, polygons, polylines, lines and rectangles.

A closed subpath is a ring of its element's polygon; which rings are holes follows from the even-odd rule, whatever
the element's own fill rule says. An open subpath is a line. The y axis of SVG points down and is turned up, so that a
shape is seen as in a browser. Coordinates are the exact decimals that are written; `transform`, curves and units other
than `px` are refused, and what draws nothing (text, styles, definitions) is skipped.
"""

import re
from collections.abc import Iterator, Sequence
from xml.etree import ElementTree

from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.decimals import decimal_of
from exactmesh.io.limits import TEXT_SEPARATORS, check_text
from exactmesh.io.parts import Ring, parts_of
from exactmesh.io.rings import Assembly, Run
from exactmesh.io.text import decimal_from_text, quoted
from exactmesh.planar.pslg import Pslg

_TOKEN = re.compile(r"[A-Za-z]|[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?|[^\s,]", re.ASCII)
_SHAPES = ("path", "polygon", "polyline", "line", "rect")
_SILENT = ("defs", "symbol", "clipPath", "mask", "marker", "pattern", "style", "script", "title", "desc", "metadata",
           "text", "linearGradient", "radialGradient", "filter", "namedview")


class Subpath:
    """Points of one subpath; `closed` when it ends where it begins."""

    def __init__(self, start: Point) -> None:
        self.points = [start]
        self.closed = False


def pslg_from_svg(text: str) -> Pslg:
    """Return the PSLG of a picture's straight shapes.

    Raises `FormatError` naming the element: for text that is not SVG, curves, transforms, rounded rectangles, and a
    ring of fewer than three points; and sizes beyond the limits.
    """
    check_text(text, TEXT_SEPARATORS)
    if "<!ENTITY" in text or ("<!DOCTYPE" in text and "[" in text[: text.find(">", text.find("<!DOCTYPE"))]):
        raise FormatError("", "entities are not read")
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise FormatError("", f"this is not XML: {error}") from None
    if _name(root) != "svg":
        raise FormatError("", f"the root element is {quoted(_name(root))}, not svg")
    assembly = Assembly()
    pending = [(root, "svg")]
    while pending:
        element, place = pending.pop()
        name = _name(element)
        if name in _SILENT:
            continue
        if element.get("transform"):
            raise FormatError(place, "a transform is not read: apply it first")
        if name in _SHAPES:
            _add(assembly, list(_subpaths(element, name, place)), place)
        elif name in ("circle", "ellipse", "image", "use"):
            raise FormatError(place, f"{name} is not made of straight lines")
        pending.extend((child, f"{place}/{_name(child)}[{index}]")
                       for index, child in reversed(list(enumerate(element))))
    return assembly.pslg()


def svg_from_pslg(pslg: Pslg) -> str:
    """Return a picture with one path for each polygon and line, which `pslg_from_svg` reads back.

    Raises `FormatError` when a coordinate is no finite decimal or a vertex is on no edge, for which SVG has nothing,
    and `GeometryError` when `pslg` is none.
    """
    parts = parts_of(pslg)
    if parts.points:
        raise FormatError(f"vertices[{parts.points[0]}]", "a vertex on no edge has no place in a path")
    xs = [p.x for p in pslg.vertices]
    ys = [-p.y for p in pslg.vertices]
    box = (min(xs), min(ys), max(xs) - min(xs), max(ys) - min(ys))
    shapes = [("domain", "".join(_ring(ring, pslg) for ring in polygon)) for polygon in parts.polygons]
    shapes += [("line", f"M{_pair(pslg, u)}L{_pair(pslg, v)}") for u, v in parts.lines]
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{" ".join(decimal_of(value) for value in box)}">',
        "<style>path { fill: none; stroke: #000; vector-effect: non-scaling-stroke } "
        ".domain { fill: #eef3fa; fill-rule: evenodd }</style>",
        *(f'<path class="{kind}" d="{d}"/>' for kind, d in shapes), "</svg>", ""])


def _ring(ring: Ring, pslg: Pslg) -> str:
    return "M" + "L".join(_pair(pslg, v) for v in ring) + "Z"


def _pair(pslg: Pslg, v: int) -> str:
    point = pslg.vertices[v]
    return f"{decimal_of(point.x, f'vertices[{v}]')} {decimal_of(-point.y, f'vertices[{v}]')}"


def _name(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else "#comment"


def _add(assembly: Assembly, subpaths: Sequence[Subpath], place: str) -> None:
    rings = [path for path in subpaths if path.closed]
    for path in subpaths:
        if not path.closed and len(path.points) > 1:
            assembly.add_line(Run(path.points, lambda index: place))
    if rings:
        assembly.add_even_odd([Run([*path.points, path.points[0]], lambda index: place) for path in rings])


def _subpaths(element: ElementTree.Element, name: str, place: str) -> Iterator[Subpath]:
    if name == "path":
        yield from _path(element.get("d", ""), place)
    elif name in ("polygon", "polyline"):
        numbers = [_number(token, place) for token in _TOKEN.findall(element.get("points", ""))]
        if len(numbers) % 2 or not numbers:
            raise FormatError(place, f"an even number of coordinates is expected, not {len(numbers)}")
        points = [_up(x, y) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
        path = Subpath(points[0])
        path.points = points
        path.closed = name == "polygon"
        yield path
    elif name == "line":
        x1, y1, x2, y2 = (_length(element, key, place) for key in ("x1", "y1", "x2", "y2"))
        path = Subpath(_up(x1, y1))
        path.points.append(_up(x2, y2))
        yield path
    else:
        x, y, width, height = (_length(element, key, place) for key in ("x", "y", "width", "height"))
        if any(_length(element, key, place) for key in ("rx", "ry")):
            raise FormatError(place, "a rectangle with round corners is not made of straight lines")
        path = Subpath(_up(x, y))
        path.points += [_up(x, y + height), _up(x + width, y + height), _up(x + width, y)]
        path.closed = True
        yield path


def _path(d: str, place: str) -> Iterator[Subpath]:
    tokens = _TOKEN.findall(d)
    here = start = (mpq(0), mpq(0))
    path: Subpath | None = None
    command = ""
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if token.isalpha():
            command = token
            index += 1
        elif command in ("", "Z", "z"):
            raise FormatError(place, f"a command is expected in the path, not {quoted(token)}")
        kind, relative = command.upper(), command.islower()
        if kind == "Z":
            if path is None:
                raise FormatError(place, "Z without a subpath")
            path.closed = True
            if len(path.points) > 1 and path.points[-1] == path.points[0]:
                path.points.pop()
            yield path
            path, here = None, start
            continue
        if kind not in "MLHV":
            raise FormatError(place, f"{command} is not a straight line: only M, L, H, V and Z are read")
        wanted = 2 if kind in "ML" else 1
        numbers = [_number(token, place) for token in tokens[index : index + wanted]]
        if len(numbers) < wanted:
            raise FormatError(place, f"{command} is followed by {wanted} numbers")
        index += wanted
        x, y = here if relative else (mpq(0), mpq(0))
        if kind == "H":
            here = (x + numbers[0], here[1])
        elif kind == "V":
            here = (here[0], y + numbers[0])
        else:
            here = (x + numbers[0], y + numbers[1])
        if kind == "M":
            if path is not None:
                yield path
            path, start = Subpath(_up(*here)), here
            command = "l" if relative else "L"  # more pairs are lines
        else:
            if path is None:
                path = Subpath(_up(*start))
            path.points.append(_up(*here))
    if path is not None:
        yield path


def _up(x: mpq, y: mpq) -> Point:
    return Point(x, -y)


def _number(token: str, place: str) -> mpq:
    try:
        return decimal_from_text(token)
    except FormatError as error:
        raise FormatError(place, error.reason) from None


def _length(element: ElementTree.Element, key: str, place: str) -> mpq:
    return _number(element.get(key, "0").removesuffix("px"), f"{place}/@{key}")
