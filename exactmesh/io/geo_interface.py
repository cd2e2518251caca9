"""Objects with `__geo_interface__` (shapely, geopandas and others) and WKB: coordinates are doubles, taken exactly."""

from collections.abc import Mapping
from decimal import Decimal
from typing import Any, Protocol

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.decimals import nearest_double
from exactmesh.io.geojson import pslg_from_geojson_value
from exactmesh.io.library import library
from exactmesh.io.parts import closed, parts_of
from exactmesh.io.strict_json import Json, Number
from exactmesh.io.text import quoted
from exactmesh.planar.pslg import Pslg


class HasGeoInterface(Protocol):
    """An object that describes itself as a GeoJSON-like mapping."""

    @property
    def __geo_interface__(self) -> Mapping[str, Any]: ...


def pslg_from_geo(geometry: HasGeoInterface | Mapping[str, Any]) -> Pslg:
    """Return the PSLG of a geometry, a feature or a collection, as from GeoJSON; a double is taken at its exact value.

    Raises `FormatError` as `pslg_from_geojson` does, and for coordinates that are not finite.
    """
    mapping = geometry if isinstance(geometry, Mapping) else geometry.__geo_interface__
    return pslg_from_geojson_value(_json(mapping))


def geo_from_pslg(pslg: Pslg) -> dict[str, Any]:
    """Return a geometry collection, to be read by `shapely.geometry.shape` and others.

    Raises `FormatError` when a coordinate is no double (round it first: `exactmesh.io.decimals`), `GeometryError` when
    `pslg` is none.
    """
    parts = parts_of(pslg)
    places = pslg.vertices
    geometries: list[dict[str, Any]] = [
        {"type": "Polygon", "coordinates": tuple(tuple(map(_pair, closed(ring, places))) for ring in polygon)}
        for polygon in parts.polygons]
    geometries += [{"type": "LineString", "coordinates": (_pair(places[u]), _pair(places[v]))} for u, v in parts.lines]
    geometries += [{"type": "Point", "coordinates": _pair(places[v])} for v in parts.points]
    return geometries[0] if len(geometries) == 1 else {"type": "GeometryCollection", "geometries": geometries}


def pslg_from_wkb(data: bytes) -> Pslg:
    """Return the PSLG of well-known binary, or of its hexadecimal text; needs shapely.

    Raises `FormatError` for anything else, and as `pslg_from_geo`.
    """
    shapely = library("shapely", "formats")
    try:
        geometry = shapely.from_wkb(data)
    except (shapely.errors.ShapelyError, TypeError, ValueError, NotImplementedError) as error:
        raise FormatError("", f"this is not WKB: {quoted(str(error).strip())}") from None
    if geometry is None or geometry.is_empty:
        raise FormatError("", "an empty geometry has no place in a PSLG")
    return pslg_from_geo(geometry)


def wkb_from_pslg(pslg: Pslg) -> bytes:
    """Return well-known binary; needs shapely. Raises as `geo_from_pslg`."""
    shapely = library("shapely", "formats")
    data: bytes = shapely.to_wkb(shapely.geometry.shape(geo_from_pslg(pslg)))
    return data


def _pair(point: Point) -> tuple[float, float]:
    for value in point:
        if nearest_double(value) != value:
            raise FormatError("", f"{value} is no double, and this format has nothing else")
    return float(point.x), float(point.y)


def _json(value: Any) -> Json:
    if isinstance(value, Mapping):
        return {str(key): _json(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_json(item) for item in value]
    if value is None or isinstance(value, bool | str):
        return value
    if hasattr(value, "tolist"):  # arrays and scalars of numpy
        return _json(value.tolist())
    if isinstance(value, int):
        return Number(str(value))
    # A double is a finite decimal, which is written in full here; infinities and NaN are refused as no number.
    return Number(format(Decimal(value), "f")) if isinstance(value, float) else str(value)
