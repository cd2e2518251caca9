"""Read GeoJSON (RFC 7946) as a PSLG.

Every geometry is read: polygons, lines and points, in collections and features of any depth. Coordinates are
the exact decimals that are written. A third coordinate, the altitude, is ignored: everything is seen from
above. So are `crs`, `bbox`, `id`, `properties` and foreign members, and features whose geometry is `null`.
"""

from typing import NamedTuple

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
    # A list of what is left, last first, instead of recursion. Places are links to the one around, spelled out when
    # something is wrong: their lengths grow with the depth.
    pending: list[tuple[Json, _Place | None]] = [(value, None)]
    while pending:
        item, place = pending.pop()
        try:
            inner = _taken(assembly, item)
        except FormatError as error:
            raise FormatError(_spelled(place, error.place), error.reason) from None
        pending.extend((part, _Place(place, step)) for part, step in reversed(inner))
    return assembly.pslg()


class _Place(NamedTuple):
    """Where an object stands: its step from the one around it."""

    around: "_Place | None"
    step: str


def _spelled(place: _Place | None, within: str) -> str:
    steps = [within] if within else []
    while place is not None:
        steps.append(place.step)
        place = place.around
    return ".".join(reversed(steps))


def _taken(assembly: Assembly, item: Json) -> list[tuple[Json, str]]:
    """Add a geometry; return the objects inside a feature or a collection, each with its step from here.

    Raises `FormatError` with a place relative to the object.
    """
    if not isinstance(item, dict):
        raise FormatError("", f"a GeoJSON object is expected, not {described(item)}")
    kind = _member(item, "type")
    if kind in _GEOMETRIES:
        _add(assembly, str(kind), _member(item, "coordinates"), "coordinates")
        return []
    if kind == "Feature":
        geometry = _member(item, "geometry")
        return [] if geometry is None else [(geometry, "geometry")]
    if kind not in _TYPES:
        raise FormatError("type", f"one of {', '.join(_TYPES)} is expected, not {described(kind)}")
    key = "features" if kind == "FeatureCollection" else "geometries"
    inner = _member(item, key)
    if not isinstance(inner, list):
        raise FormatError(key, f"a list is expected, not {described(inner)}")
    return [(part, f"{key}[{index}]") for index, part in enumerate(inner)]


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


def _member(item: dict[str, Json], key: str) -> Json:
    if key not in item:
        raise FormatError("", f"the key {key!r} is missing")
    return item[key]
