"""GeoJSON."""

import json

import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.io.geojson import pslg_from_geojson

SQUARE = [[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]
HOLE = [[1, 1], [1, 2], [2, 2], [1, 1]]


def read(kind, coordinates):
    return pslg_from_geojson(json.dumps({"type": kind, "coordinates": coordinates}))


def test_a_polygon_with_a_hole():
    pslg = read("Polygon", [SQUARE, HOLE])
    assert pslg.vertices == ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (1, 2), (2, 2))
    assert pslg.edges == ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 4))
    (x, y), = pslg.holes
    assert 1 < x < y < 2


def test_a_filled_hole_is_none():
    assert read("MultiPolygon", [[SQUARE, HOLE], [HOLE]]).holes == ()


def test_decimals_are_exact():
    digits = "7" * 5000
    pslg = pslg_from_geojson(f'{{"type": "LineString", "coordinates": [[0.1, 1e-3], [1e400, {digits}]]}}')
    assert pslg.vertices == ((mpq(1, 10), mpq(1, 1000)), (mpz(10) ** 400, mpz(digits)))


def test_an_altitude_is_ignored():
    pslg = read("Polygon", [[[0, 0, 1], [4, 0, 2.5], [4, 4], [0, 0, 9]]])
    assert pslg.vertices == ((0, 0), (4, 0), (4, 4))


@pytest.mark.parametrize("kind, coordinates, vertices, edges", [
    ("Point", [1, 2], 1, 0),
    ("MultiPoint", [[1, 2], [3, 4], [1, 2]], 2, 0),
    ("LineString", [[1, 2], [3, 4], [5, 5]], 3, 2),
    ("MultiLineString", [[[1, 2], [3, 4]], [[3, 4], [1, 2]], [[3, 4], [0, 0]]], 3, 2),
    ("Polygon", [SQUARE], 4, 4),
    ("MultiPolygon", [[SQUARE], [[[4, 0], [8, 0], [4, 4], [4, 0]]]], 5, 6),
])
def test_every_geometry_is_read(kind, coordinates, vertices, edges):
    pslg = read(kind, coordinates)
    assert (len(pslg.vertices), len(pslg.edges), pslg.holes) == (vertices, edges, ())


def test_collections_are_read_in_order_and_other_members_ignored():
    geometry = {"type": "GeometryCollection", "geometries": [
        {"type": "Point", "coordinates": [3, 0], "bbox": [3, 0, 3, 0]},
        {"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1, 0]}]},
        {"type": "Point", "coordinates": [2, 0]}]}
    value = {"type": "FeatureCollection", "crs": {}, "features": [
        {"type": "Feature", "geometry": geometry, "properties": {"type": 5}, "id": 1},
        {"type": "Feature", "geometry": None, "properties": None},
        {"type": "Feature", "geometry": {"type": "Point", "coordinates": [0, 0]}}]}
    assert [p.x for p in pslg_from_geojson(json.dumps(value)).vertices] == [3, 1, 2, 0]


@pytest.mark.parametrize("value, place, reason", [
    ([], "", "a GeoJSON object is expected, not a list of 0"),
    ({}, "", "the key 'type' is missing"),
    ({"type": "Topology"}, "type",
     "one of Point, MultiPoint, LineString, MultiLineString, Polygon, MultiPolygon, "
     "GeometryCollection, Feature, FeatureCollection is expected, not the string 'Topology'"),
    ({"type": ["Point"]}, "type",
     "one of Point, MultiPoint, LineString, MultiLineString, Polygon, MultiPolygon, "
     "GeometryCollection, Feature, FeatureCollection is expected, not a list of 1"),
    ({"type": "Point"}, "", "the key 'coordinates' is missing"),
    ({"type": "Feature"}, "", "the key 'geometry' is missing"),
    ({"type": "Feature", "geometry": 5}, "geometry", "a GeoJSON object is expected, not the number 5"),
    ({"type": "Feature", "geometry": {"type": "Polygon"}}, "geometry", "the key 'coordinates' is missing"),
    ({"type": "FeatureCollection", "features": {}}, "features", "a list is expected, not an object"),
    ({"type": "FeatureCollection", "features": []}, "", "there is no geometry in it"),
    ({"type": "GeometryCollection", "geometries": [{"type": "Point", "coordinates": [1]}]},
     "geometries[0].coordinates", "a position is a list of two or three numbers, not a list of 1"),
])
def test_what_is_no_geojson_is_named_with_its_place(value, place, reason):
    with pytest.raises(FormatError) as caught:
        pslg_from_geojson(json.dumps(value))
    assert (caught.value.place, caught.value.reason) == (place, reason)


@pytest.mark.parametrize("kind, coordinates, place, reason", [
    ("Point", [1, "2"], "coordinates[1]", "a number is expected, not the string '2'"),
    ("Point", [1, 2, None], "coordinates[2]", "a number is expected, not null"),
    ("Point", [1, 2, 3, 4], "coordinates", "a position is a list of two or three numbers, not a list of 4"),
    ("Point", [], "coordinates", "a position is a list of two or three numbers, not a list of 0"),
    ("MultiPoint", [], "coordinates", "a list that is not empty is expected, not a list of 0"),
    ("MultiPoint", [[1, 2], [True, 2]], "coordinates[1][0]", "a number is expected, not true"),
    ("LineString", [[1, 2]], "coordinates", "a line needs at least two positions, not 1"),
    ("LineString", [[1, 2], 5], "coordinates[1]",
     "a position is a list of two or three numbers, not the number 5"),
    ("LineString", 5, "coordinates", "a list is expected, not the number 5"),
    ("MultiLineString", [[[0, 0], [1, 1]], [[0, 0], [0, 0, 5]]], "coordinates[1][1]",
     "a zero-length edge: (0, 0) is repeated"),
    ("Polygon", [], "coordinates", "a list that is not empty is expected, not a list of 0"),
    ("Polygon", [SQUARE, HOLE[:3]], "coordinates[1]", "the ring is not closed: from (1, 1) to (2, 2)"),
    ("Polygon", [SQUARE[:1] + SQUARE], "coordinates[0][1]", "a zero-length edge: (0, 0) is repeated"),
    ("Polygon", [[[0, 0], [1, 0], [0, 0]]], "coordinates[0]",
     "a ring needs at least three distinct points, not 2"),
    ("Polygon", [[]], "coordinates[0]", "a ring needs at least three distinct points, not 0"),
    ("MultiPolygon", [[SQUARE], [SQUARE, [[0, 0], [1, "x"]]]], "coordinates[1][1][1][1]",
     "a number is expected, not the string 'x'"),
    ("MultiPolygon", [None], "coordinates[0]", "a list that is not empty is expected, not null"),
])
def test_wrong_coordinates_are_named_with_their_place(kind, coordinates, place, reason):
    with pytest.raises(FormatError) as caught:
        read(kind, coordinates)
    assert (caught.value.place, caught.value.reason) == (place, reason)


def test_an_exponent_that_asks_for_gigabytes_is_refused():
    with pytest.raises(FormatError, match=r"coordinates\[1\]: the exponent of '1e9999999' is beyond 100000"):
        pslg_from_geojson('{"type": "Point", "coordinates": [0, 1e9999999]}')


@given(st.data())
def test_a_mutated_file_is_read_or_refused(data):
    text = json.dumps({"type": "Feature",
                       "geometry": {"type": "MultiPolygon", "coordinates": [[SQUARE, HOLE]]}})
    at = data.draw(st.integers(0, len(text)))
    new = data.draw(st.text(alphabet='{}[]",:0123456789.eE+-truefalsn \\\n', max_size=4))
    try:
        pslg_from_geojson(text[:at] + new + text[at + data.draw(st.integers(0, 3)):])
    except InputError as error:
        assert "\n" not in str(error)


@given(st.recursive(
    st.none() | st.integers() | st.sampled_from(["Point", "Polygon", "Feature"]),
    lambda inner: st.lists(inner, max_size=4) | st.fixed_dictionaries(
        {"type": st.sampled_from(["Point", "MultiPoint", "LineString", "Polygon", "MultiPolygon"]),
         "coordinates": inner})
    | st.fixed_dictionaries({"type": st.just("GeometryCollection"), "geometries": inner}), max_leaves=30))
def test_any_json_is_read_or_refused(value):
    try:
        pslg_from_geojson(json.dumps(value))
    except InputError as error:
        assert "\n" not in str(error)
