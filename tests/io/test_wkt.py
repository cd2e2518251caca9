"""Well-known text."""

import json

import pytest
import shapely
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.io.geojson import pslg_from_geojson
from exactmesh.io.wkt import pslg_from_wkt

KINDS = ("POINT, MULTIPOINT, LINESTRING, MULTILINESTRING, POLYGON, MULTIPOLYGON, GEOMETRYCOLLECTION")


def test_a_polygon_with_a_hole():
    pslg = pslg_from_wkt("POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0),\n (1 1, 1 2, 2 2, 1 1))\n")
    assert pslg.vertices == ((0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (1, 2), (2, 2))
    assert pslg.edges == ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 4))
    assert len(pslg.holes) == 1


def test_decimals_are_exact():
    pslg = pslg_from_wkt(f"point({'7' * 5000} -1.e-3)")
    assert pslg.vertices == ((mpz("7" * 5000), mpq(-1, 1000)),)


@pytest.mark.parametrize("text, vertices, edges", [
    ("Point(1 2)", 1, 0),
    ("POINT Z (1 2 3)", 1, 0),
    ("POINT (1 2 3)", 1, 0),
    ("MULTIPOINT (1 2, 3 4)", 2, 0),
    ("MULTIPOINT ((1 2), (3 4), (1 2))", 2, 0),
    ("lineString(1 2,3 4,5 5)", 3, 2),
    ("LINESTRING z (1 2 0,3 4 1)", 2, 1),
    ("MULTILINESTRING ((1 2, 3 4), (3 4, 1 2), (3 4, 0 0))", 3, 2),
    ("MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((1 0, 1 1, 0 1, 1 0)))", 4, 5),
    ("GEOMETRYCOLLECTION (POINT (1 2), GEOMETRYCOLLECTION (LINESTRING (0 0, 1 1)), POINT (3 4))", 4, 1),
])
def test_every_geometry_is_read(text, vertices, edges):
    pslg = pslg_from_wkt(text)
    assert (len(pslg.vertices), len(pslg.edges), pslg.holes) == (vertices, edges, ())


def test_collections_nest_without_bound():
    depth = 100_000
    assert len(pslg_from_wkt("GEOMETRYCOLLECTION(" * depth + "POINT(0 0)" + ")" * depth).vertices) == 1


@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=8, unique=True),
       st.lists(st.tuples(st.integers(10, 20), st.integers(-9, 9)), min_size=2, max_size=4, unique=True))
def test_shapely_writes_the_same_as_wkt_and_geojson(corners, line):
    shape = shapely.GeometryCollection([shapely.Polygon(corners), shapely.LineString(line),
                                        shapely.Point(line[0])])
    text = json.dumps(json.loads(shapely.to_geojson(shape)))
    assert pslg_from_wkt(shape.wkt) == pslg_from_geojson(text)


@pytest.mark.parametrize("text, place, reason", [
    ("POLYGON ((0 0, 1 0,\n  0 1))", "line 1, column 10", "the ring is not closed: from (0, 0) to (0, 1)"),
    ("POLYGON ((0 0, 1 0,\n  1 0, 0 1, 0 0))", "line 2, column 3", "a zero-length edge: (1, 0) is repeated"),
    ("POLYGON ((0 0, 9 0, 0 9, 0 0),\n (1 1, 2 1, 1 1))", "line 2, column 2",
     "a ring needs at least three distinct points, not 2"),
    ("LINESTRING (0 0)", "line 1, column 12", "a line needs at least two positions, not 1"),
    ("LINESTRING (0 0, 1 x)", "line 1, column 20", "'x' is not a finite decimal"),
    ("LINESTRING (0 0, 1/2 1)", "line 1, column 18", "'1/2' is not a finite decimal"),
    ("LINESTRING (0 0, nan 1)", "line 1, column 18", "'nan' is not a finite decimal"),
    ("POINT (0 1e999999)", "line 1, column 10", "the exponent of '1e999999' is beyond 100000"),
    ("LINESTRING (0 0, 1)", "line 1, column 18", "a position has 2 or 3 numbers here, not 1"),
    ("LINESTRING (0 0, 1 2 3 4)", "line 1, column 18", "a position has 2 or 3 numbers here, not 4"),
    ("LINESTRING (0 0, )", "line 1, column 18", "a position has 2 or 3 numbers here, not 0"),
    ("LINESTRING Z (0 0, 1 1)", "line 1, column 15", "a position has 3 numbers here, not 2"),
    ("POINT M (0 0 1)", "line 1, column 7", "measures are not read: only Z may be left aside"),
    ("POINT zm (0 0 1 2)", "line 1, column 7", "measures are not read: only Z may be left aside"),
    ("POLYGON EMPTY", "line 1, column 9", "an empty geometry has no place in a PSLG"),
    ("POLYGON Z EMPTY", "line 1, column 11", "an empty geometry has no place in a PSLG"),
    ("GEOMETRYCOLLECTION empty", "line 1, column 20", "an empty geometry has no place in a PSLG"),
    ("SRID=4326;POINT(0 0)", "line 1, column 1",
     "this is EWKT: take the SRID away, "
     "coordinates are read as they are"),
    ("CIRCLE (0 0)", "line 1, column 1", f"one of {KINDS} is expected, not 'CIRCLE'"),
    ("", "line 1, column 1", f"one of {KINDS} is expected, not the end of the text"),
    ("GEOMETRYCOLLECTION ()", "line 1, column 21", f"one of {KINDS} is expected, not ')'"),
    ("GEOMETRYCOLLECTION (POINT (0 0) POINT (1 1))", "line 1, column 33",
     """"," or ")" is expected, not 'POINT'"""),
    ("GEOMETRYCOLLECTION (POINT (0 0)", "line 1, column 32",
     '"," or ")" is expected, not the end of the text'),
    ("POINT 0 0", "line 1, column 7", "\"(\" is expected, not '0'"),
    ("POINT (0 0", "line 1, column 11", '")" is expected, not the end of the text'),
    ("POINT (0 0, 1 1)", "line 1, column 11", "\")\" is expected, not ','"),
    ("LINESTRING (0 0, 1 1 (", "line 1, column 22", """"," or ")" is expected, not '('"""),
    ("POINT (0 0)\nPOINT (1 1)", "line 2, column 1",
     "the end of the text, or a GEOMETRYCOLLECTION around all "
     "geometries, is expected, not 'POINT'"),
])
def test_what_is_wrong_is_named_with_its_place(text, place, reason):
    with pytest.raises(FormatError) as caught:
        pslg_from_wkt(text)
    assert (caught.value.place, caught.value.reason) == (place, reason)


@given(st.data())
def test_a_mutated_text_is_read_or_refused(data):
    text = ("GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4, 0 0), (2 1, 3 1, 3 2, 2 1)), "
            "MULTIPOINT (1 2.5e1, (3 4)))")
    at = data.draw(st.integers(0, len(text)))
    new = data.draw(st.text(alphabet="(),0123456789.eE+-ZMPOINT \n", max_size=4) | st.text(max_size=2))
    try:
        pslg_from_wkt(text[:at] + new + text[at + data.draw(st.integers(0, 4)):])
    except InputError as error:
        assert "\n" not in str(error)
