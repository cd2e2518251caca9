"""Read and write DXF through ezdxf: lines and straight polylines of the model space, seen from above.

LINE, LWPOLYLINE and POLYLINE are edges; POINT is a vertex, or, on the layer `hole`, marks a face to be left empty.
Coordinates are binary doubles, taken at their exact value. The domain is what the lines enclose. Arcs, bulges, splines
and blocks are refused; text, dimensions and hatches draw no edge and are skipped.
"""

import io
from typing import Any

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.decimals import nearest_double
from exactmesh.io.library import library
from exactmesh.io.limits import TEXT_SEPARATORS, check_text
from exactmesh.io.rings import Assembly, Run
from exactmesh.io.text import quoted
from exactmesh.numbers.rational import rational_from_float
from exactmesh.planar.pslg import Pslg

HOLE_LAYER = "hole"
_CURVED = ("ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX", "INSERT", "MLINE")


def pslg_from_dxf(text: str) -> Pslg:
    """Return the PSLG of a file's text; needs ezdxf.

    Raises `FormatError` naming the entity by its handle; for text that is not DXF, and sizes beyond the limits.
    """
    check_text(text, TEXT_SEPARATORS)
    ezdxf = library("ezdxf", "formats")
    try:
        return _pslg(ezdxf.read(io.StringIO(text)))
    except InputError:
        raise
    except Exception as error:  # the library's own, and what it runs into where the file is broken
        raise FormatError("", f"this is not DXF: {quoted(str(error).strip())}") from None


def _pslg(document: Any) -> Pslg:
    assembly = Assembly()
    holes: list[Point] = []
    for entity in document.modelspace():
        kind, place = entity.dxftype(), f"{entity.dxftype()} {entity.dxf.handle}"
        if kind == "LINE":
            _add_line(assembly, [entity.dxf.start, entity.dxf.end], place)
        elif kind in ("LWPOLYLINE", "POLYLINE"):
            _add_line(assembly, _corners(entity, kind, place), place)
        elif kind == "POINT":
            point = _point(entity.dxf.location, place)
            if str(entity.dxf.layer).lower() == HOLE_LAYER:
                holes.append(point)
            else:
                assembly.add_point(point)
        elif kind in _CURVED:
            raise FormatError(place, "is not made of straight lines")
    pslg = assembly.pslg()
    return Pslg(pslg.vertices, pslg.edges, tuple(holes))


def dxf_from_pslg(pslg: Pslg) -> str:
    """Return the text of a file: a LINE for each edge, a POINT for each vertex on none and for each hole.

    Raises `FormatError` when a coordinate is no double. Needs ezdxf.
    """
    ezdxf = library("ezdxf", "formats")
    document = ezdxf.new("R2010")
    space = document.modelspace()
    document.layers.add(HOLE_LAYER)
    for u, v in pslg.edges:
        space.add_line(_pair(pslg.vertices[u], f"vertices[{u}]"), _pair(pslg.vertices[v], f"vertices[{v}]"))
    on_edges = {v for edge in pslg.edges for v in edge}
    for v, point in enumerate(pslg.vertices):
        if v not in on_edges:
            space.add_point(_pair(point, f"vertices[{v}]"))
    for index, point in enumerate(pslg.holes):
        space.add_point(_pair(point, f"holes[{index}]"), dxfattribs={"layer": HOLE_LAYER})
    stream = io.StringIO()
    document.write(stream)
    return stream.getvalue()


def _corners(entity: Any, kind: str, place: str) -> list[Any]:
    if kind == "LWPOLYLINE":
        corners = [(x, y) for x, y, bulge in entity.get_points("xyb") if _straight(bulge, place)]
        closed = entity.closed
    else:
        corners = [vertex.dxf.location for vertex in entity.vertices if _straight(vertex.dxf.get("bulge", 0), place)]
        closed = entity.is_closed
    same = len(corners) > 1 and tuple(corners[0])[:2] == tuple(corners[-1])[:2]
    return [*corners, corners[0]] if closed and corners and not same else corners


def _straight(bulge: float, place: str) -> bool:
    if bulge:
        raise FormatError(place, "has a bulge: it is not made of straight lines")
    return True


def _add_line(assembly: Assembly, corners: list[Any], place: str) -> None:
    assembly.add_line(Run([_point(corner, place) for corner in corners], lambda index: place))


def _point(location: Any, place: str) -> Point:
    x, y = tuple(location)[:2]
    return Point(rational_from_float(float(x), place), rational_from_float(float(y), place))


def _pair(point: Point, place: str) -> tuple[float, float]:
    if any(nearest_double(value) != value for value in point):
        raise FormatError(place, f"{point} has no double for a coordinate, and this format has nothing else")
    return float(point.x), float(point.y)
