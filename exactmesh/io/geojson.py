"""Read GeoJSON (RFC 7946) as a PSLG.

Every geometry is read: polygons, lines and points, in collections and features of any depth. Coordinates are
the exact decimals that are written. A third coordinate, the altitude, is ignored: everything is seen from
above. So are `crs`, `bbox`, `id`, `properties` and foreign members, and features whose geometry is `null`.
"""

from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.json_fields import each
from exactmesh.io.rings import Assembly, Run
from exactmesh.io.strict_json import Json, Number, described, parse_json
from exactmesh.numbers.rational import rational_from_text
from exactmesh.planar.pslg import Pslg

_GEOMETRIES = ("Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon")
_TYPES = (*_GEOMETRIES, "GeometryCollection", "Feature", "FeatureCollection")


def pslg_from_geojson(text: str) -> Pslg:
    """Return the PSLG of a file's text.

    Raises `FormatError` naming the place, such as `features[2].geometry.coordinates[0][3]`: for text that is
    not GeoJSON, a ring that is not closed or has fewer than three distinct points, and a position repeated at
    once.
    """
    return pslg_from_geojson_value(parse_json(text))


def pslg_from_geojson_value(value: Json) -> Pslg:
    """Return the PSLG of a parsed file; raises as `pslg_from_geojson`."""
    assembly = Assembly()
    # A list of what is left, last first, instead of recursion: collections nest as deep as the file likes.
    pending = [(value, "")]
    while pending:
        item, place = pending.pop()
        if not isinstance(item, dict):
            raise FormatError(place, f"a GeoJSON object is expected, not {described(item)}")
        pending.extend(reversed(_inner(item, place)))
        if item["type"] in _GEOMETRIES:
            at = _join(place, "coordinates")
            _add(assembly, str(item["type"]), _member(item, "coordinates", place), at)
    return assembly.pslg()


def _inner(item: dict[str, Json], place: str) -> list[tuple[Json, str]]:
    """Return the objects inside a feature or a collection, each with its place."""
    kind = _member(item, "type", place)
    if kind not in _TYPES:
        known = ", ".join(_TYPES)
        raise FormatError(_join(place, "type"), f"one of {known} is expected, not {described(kind)}")
    if kind == "Feature":
        geometry = _member(item, "geometry", place)
        return [] if geometry is None else [(geometry, _join(place, "geometry"))]
    if kind in ("FeatureCollection", "GeometryCollection"):
        key = "features" if kind == "FeatureCollection" else "geometries"
        inner = _member(item, key, place)
        if not isinstance(inner, list):
            raise FormatError(_join(place, key), f"a list is expected, not {described(inner)}")
        return [(part, f"{_join(place, key)}[{index}]") for index, part in enumerate(inner)]
    return []


def _add(assembly: Assembly, kind: str, coordinates: Json, place: str) -> None:
    parts = _list(coordinates, place) if kind.startswith("Multi") else [(coordinates, place)]
    for part, at in parts:
        if kind.endswith("Point"):
            try:
                assembly.add_point(_position(part))
            except FormatError as error:
                raise FormatError(at + error.place, error.reason) from None
        elif kind.endswith("LineString"):
            assembly.add_line(_run(part, at))
        else:
            assembly.add_polygon([_run(ring, ring_at) for ring, ring_at in _list(part, at)])


def _list(value: Json, place: str) -> list[tuple[Json, str]]:
    """Return the items of a list that is not empty, each with its place."""
    if not isinstance(value, list) or not value:
        raise FormatError(place, f"a list that is not empty is expected, not {described(value)}")
    return [(item, f"{place}[{index}]") for index, item in enumerate(value)]


def _run(value: Json, place: str) -> Run:
    return Run(each(value, place, _position), lambda index: place if index is None else f"{place}[{index}]")


def _position(value: Json) -> Point:
    if not isinstance(value, list) or len(value) not in (2, 3):
        raise FormatError("", f"a position is a list of two or three numbers, not {described(value)}")
    return Point._make(each(value, "", _decimal)[:2])


def _decimal(value: Json) -> mpq:
    if not isinstance(value, Number):
        raise FormatError("", f"a number is expected, not {described(value)}")
    return rational_from_text(value.text)


def _member(item: dict[str, Json], key: str, place: str) -> Json:
    if key not in item:
        raise FormatError(place, f"the key {key!r} is missing")
    return item[key]


def _join(place: str, key: str) -> str:
    return f"{place}.{key}" if place else key
