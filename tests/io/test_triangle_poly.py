"""Triangle's `.poly`."""

import pytest
from gmpy2 import mpq, mpz
from hypothesis import example, given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.triangle_poly import poly_from_pslg, pslg_from_poly
from exactmesh.planar.pslg import Pslg

# With comments, blank lines, attributes, markers and regions, numbered from 1.
FULL = """# a box with a square hole
8 2 1 1   # vertices

1  0 0    1.5 1
2  3 0    1.5 1
3  3 3    1.5 1
4  0 3    1.5 1
5  1 1    -2  0
6  2 1    -2  0
7  2 0.2e1  -2  0
8  1 2    -2  0
8 1
 1 1 2 5
 2 2 3 5
 3 3 4 5
 4 4 1 5
 5 5 6 7
 6 6 7 7
 7 7 8 7
 8 8 5 7
1
1 1.5 1.5
1
1 0.5 0.5 7 0.1
"""
BOX = "3 2 0 0\n0 0 0\n1 1 0\n2 0 1\n3 0\n0 0 1\n1 1 2\n2 2 0\n0\n"
DECIMALS = st.builds(lambda n, e: mpq(n) * mpq(10) ** e, st.integers(), st.integers(-40, 40))
DYADICS = st.floats(allow_nan=False, allow_infinity=False).map(lambda x: mpq(*x.as_integer_ratio()))
POINTS = st.builds(Point, DECIMALS | DYADICS, DECIMALS | DYADICS)


@st.composite
def pslgs(draw):
    """Return a record that need not be planar."""
    vertices = draw(st.lists(POINTS, min_size=1, max_size=6))
    ends = st.integers(0, len(vertices) - 1)
    edges = st.lists(st.tuples(ends, ends).filter(lambda e: e[0] != e[1]), max_size=6)
    return Pslg(tuple(vertices), tuple(draw(edges)) if len(vertices) > 1 else (),
                tuple(draw(st.lists(POINTS, max_size=3))))


@given(pslgs())
@example(Pslg((Point(mpq(mpz(10) ** 6000 + 1, 2), mpq(-1, 5**50)),), ()))
def test_what_was_written_is_read(pslg):
    assert pslg_from_poly(poly_from_pslg(pslg)) == pslg


def test_the_text_of_a_box():
    points = [Point(mpq(x), mpq(y, 8)) for x, y in [(0, 0), (1, -20), (0, 1)]]
    pslg = Pslg(tuple(points), ((0, 1), (1, 2), (2, 0)), (Point(mpq(1, 10), mpq(50)),))
    assert poly_from_pslg(pslg) == (
        "3 2 0 0\n0 0 0\n1 1 -2.5\n2 0 0.125\n3 0\n0 0 1\n1 1 2\n2 2 0\n1\n0 0.1 50\n")


def test_what_no_decimal_spells_is_not_written():
    with pytest.raises(FormatError) as caught:
        poly_from_pslg(Pslg((Point(mpq(0), mpq(0)), Point(mpq(1), mpq(1, 3))), ()))
    assert str(caught.value) == "vertices[1]: 1/3 is no finite decimal, and this format has nothing else"


def test_a_full_file():
    pslg = pslg_from_poly(FULL)
    assert pslg.vertices == ((0, 0), (3, 0), (3, 3), (0, 3), (1, 1), (2, 1), (2, 2), (1, 2))
    assert pslg.edges == ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4))
    assert pslg.holes == ((mpq(3, 2), mpq(3, 2)),)


def test_the_first_line_may_be_a_count_alone():
    assert pslg_from_poly("2\n0 .1 1.\n1 1 1\n0\n0") == pslg_from_poly("2 2 0 0\n1 0.1 1\n2 1 1\n0 0\n0\n0\n")


def test_vertices_in_a_node_file():
    text = "0 2 0 1\n1 0\n1 1 2\n0\n"
    assert pslg_from_poly(text, lambda: "2 2 0 1\n1 5 5 9\n2 6 6\n").vertices == ((5, 5), (6, 6))
    with pytest.raises(FormatError, match=r"^the vertices are in a \.node file, which is not at hand$"):
        pslg_from_poly(text)
    with pytest.raises(FormatError,
                       match=r"^\.node line 2: 3 numbers are expected in a line of the vertices, not 1$"):
        pslg_from_poly(text, lambda: "1\n1\n")
    with pytest.raises(FormatError, match=r"^\.node line 3: the file should end before this line$"):
        pslg_from_poly(text, lambda: "1\n1 0 0\n2 0 0\n")


@pytest.mark.parametrize("old, new, place, reason", [
    (BOX, "", "", "the file ends where the number of vertices is expected"),
    (BOX, "3 2 0 0\n0 0 0\n", "", "the file ends where line 2 of 3 of the vertices is expected"),
    ("3 0\n", "", "line 5", "the number of segments stands in a line of at most 2, not 3"),
    ("3 2 0 0", "3 3 0 0", "line 1", "the dimension should be 2, not 3"),
    ("3 2 0 0", "3 2 0 0 0", "line 1", "the number of vertices stands in a line of at most 4, not 5"),
    ("3 2 0 0", "x 2 0 0", "line 1", "the number of vertices is expected, not 'x'"),
    ("3 2 0 0", "-3 2 0 0", "line 1", "the number of vertices is expected, not '-3'"),
    ("3 2 0 0", "9" * 5000, "line 1", "the number of vertices is expected, not '" + "9" * 37 + "...'"),
    ("3 2 0 0", "999999999999999999", "line 5", "3 numbers are expected in a line of the vertices, not 2"),
    ("0 0 0\n", "2 0 0\n", "line 2", "vertex 0 or 1 is expected, not 2"),
    ("1 1 0\n", "2 1 0\n", "line 3", "vertex 1 is expected, not 2"),
    ("1 1 0\n", "1 1\n", "line 3", "3 numbers are expected in a line of the vertices, not 2"),
    ("1 1 0\n", "1 1 0 5\n", "line 3", "3 numbers are expected in a line of the vertices, not 4"),
    ("1 1 0\n", "1 1 y\n", "line 3", "'y' is not a finite decimal"),
    ("1 1 0\n", "1 1/2 0\n", "line 3", "'1/2' is not a finite decimal"),
    ("1 1 0\n", "1 1e999999 0\n", "line 3", "the exponent of '1e999999' is beyond 100000"),
    ("2 2 0\n", "2 2 3\n", "line 8", "vertex 3 does not exist (there are 3, from 0)"),
    ("2 2 0\n", "2 2 -1\n", "line 8", "a vertex is expected, not '-1'"),
    ("2 2 0\n", "2 2 2\n", "line 8", "both ends are vertex 2: a segment needs two"),
    ("2 2 0\n", "2 2 0 1 1\n", "line 8", "3 to 4 numbers are expected in a line of the segments, not 5"),
    ("2 2 0\n0\n", "2 2 0\n", "", "the file ends where the number of holes is expected"),
    ("2 2 0\n0\n", "2 2 0\n1\n0 1\n", "line 10", "3 numbers are expected in a line of the holes, not 2"),
    ("2 2 0\n0\n", "2 2 0\n0\n1\n0 0 0\n", "line 11",
     "4 to 5 numbers are expected in a line of the regions, not 3"),
    ("2 2 0\n0\n", "2 2 0\n0\n0\n5\n", "line 11", "the file should end before this line"),
])
def test_what_is_wrong_is_named_with_its_line(old, new, place, reason):
    assert BOX.count(old) == 1
    with pytest.raises(FormatError) as caught:
        pslg_from_poly(BOX.replace(old, new))
    assert (caught.value.place, caught.value.reason) == (place, reason)


def test_vertices_from_one_are_named_as_written():
    with pytest.raises(FormatError) as caught:
        pslg_from_poly("1\n1 0 0\n1\n1 0 1\n0\n")
    assert str(caught.value) == "line 4: vertex 0 does not exist (there are 1, from 1)"
    with pytest.raises(FormatError) as caught:
        pslg_from_poly("1\n1 0 0\n1\n1 1 1\n0\n")
    assert str(caught.value) == "line 4: both ends are vertex 1: a segment needs two"


@given(st.data())
def test_a_mutated_file_is_read_or_refused(data):
    at = data.draw(st.integers(0, len(FULL)))
    new = data.draw(st.text(alphabet="0123456789.eE+-# \n", max_size=4) | st.text(max_size=2))
    try:
        pslg_from_poly(FULL[:at] + new + FULL[at + data.draw(st.integers(0, 4)):])
    except InputError as error:
        assert "\n" not in str(error)
