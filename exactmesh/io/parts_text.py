"""Write PSLGs, and the faces of meshes, as GeoJSON and well-known text: polygons with holes, lines and points.

Coordinates are decimals, written exactly: each writer raises `FormatError` for one that no decimal spells (see
`exactmesh.io.decimals.rounded`), and `GeometryError` for a PSLG that is none.
"""

from collections.abc import Callable, Iterable

from exactmesh.geometry.point import Point
from exactmesh.io.decimals import decimal_of
from exactmesh.io.json_fields import rows
from exactmesh.io.parts import parts_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg


def geojson_from_pslg(pslg: Pslg) -> str:
    """Return a feature collection: a polygon for each face of the domain, and lines and points for what is left."""
    parts, position = parts_of(pslg), _written(pslg.vertices, "[", ", ", "]")

    def listed(vertices: Iterable[int]) -> str:
        return f"[{', '.join(map(position, vertices))}]"

    geometries = [("Polygon", f"[{', '.join(listed((*ring, ring[0])) for ring in polygon)}]")
                  for polygon in parts.polygons]
    geometries += [("LineString", listed(line)) for line in parts.lines]
    geometries += [("Point", position(v)) for v in parts.points]
    return _collection(geometries)


def geojson_from_mesh(mesh: Mesh) -> str:
    """Return a feature collection with a polygon for each face."""
    position = _written(mesh.vertices, "[", ", ", "]")
    return _collection(("Polygon", f"[[{', '.join(map(position, (*face, face[0])))}]]") for face in mesh.faces)


def wkt_from_pslg(pslg: Pslg) -> str:
    """Return one geometry: a polygon for each face of the domain, lines and points for what is left."""
    parts, position = parts_of(pslg), _written(pslg.vertices, "", " ", "")

    def listed(vertices: Iterable[int]) -> str:
        return f"({', '.join(map(position, vertices))})"

    texts = [f"POLYGON ({', '.join(listed((*ring, ring[0])) for ring in polygon)})" for polygon in parts.polygons]
    texts += [f"LINESTRING {listed(line)}" for line in parts.lines]
    texts += [f"POINT ({position(v)})" for v in parts.points]
    return (texts[0] if len(texts) == 1 else f"GEOMETRYCOLLECTION ({', '.join(texts)})") + "\n"


def _written(points: tuple[Point, ...], before: str, between: str, after: str) -> Callable[[int], str]:
    texts = [before + between.join(decimal_of(value, f"vertices[{v}]") for value in point) + after
             for v, point in enumerate(points)]
    return texts.__getitem__


def _collection(geometries: Iterable[tuple[str, str]]) -> str:
    features = rows('{"type": "Feature", "properties": {}, "geometry": '
                    f'{{"type": "{kind}", "coordinates": {text}}}}}' for kind, text in geometries)
    return f'{{"type": "FeatureCollection", "features": {features}}}\n'
