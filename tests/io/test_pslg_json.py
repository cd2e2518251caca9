"""The format exactmesh-pslg/1."""

import pytest
from gmpy2 import mpq, mpz
from hypothesis import example, given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.planar.pslg import Pslg

POINTS = st.builds(Point, st.fractions().map(mpq), st.fractions().map(mpq))


@st.composite
def pslgs(draw):
    """Return a record that need not be planar."""
    vertices = draw(st.lists(POINTS, max_size=6))
    ends = st.integers(0, len(vertices) - 1)
    edges = st.lists(st.tuples(ends, ends).filter(lambda e: e[0] != e[1]), max_size=6)
    return Pslg(tuple(vertices), tuple(draw(edges)) if len(vertices) > 1 else (),
                tuple(draw(st.lists(POINTS, max_size=3))), draw(st.text()))


HUGE = Pslg((Point(mpq(mpz(10) ** 6000 + 1, 3), mpq(0)),), (), (), '"\ud800')


@given(pslgs())
@example(HUGE)
def test_what_was_written_is_read(pslg):
    text = json_from_pslg(pslg)
    read = pslg_from_json(text)
    assert read == pslg and read.name == pslg.name
    assert text.isascii() and json_from_pslg(read) == text


def test_the_example_of_the_formats_document():
    pslg = pslg_from_json("""{"format": "exactmesh-pslg/1",
     "vertices": [["0", "0"], ["10", "0"], ["10", "7/2"], ["0", "7/2"]],
     "edges": [[0, 1], [1, 2], [2, 3], [3, 0]],
     "holes": [["5", "1"]],
     "name": "optional"}""")
    assert pslg.vertices[2] == (10, mpq(7, 2))
    assert pslg.edges == ((0, 1), (1, 2), (2, 3), (3, 0))
    assert pslg.holes == ((5, 1),) and pslg.name == "optional"


def test_the_spelling_of_a_scalar_does_not_matter():
    text = '{"format": "exactmesh-pslg/1", "edges": [], "vertices": [["14/4", 3.5], ["35e-1", 1]]}'
    pslg = pslg_from_json(text)
    assert pslg.vertices == ((mpq(7, 2), mpq(7, 2)), (mpq(7, 2), 1))


def file_with(**parts):
    defaults = {"format": '"exactmesh-pslg/1"', "vertices": '[["0", "0"], ["1", "0"]]', "edges": "[[0, 1]]"}
    return "{" + ", ".join(f'"{k}": {v}' for k, v in (defaults | parts).items() if v is not None) + "}"


@pytest.mark.parametrize("parts, place, reason", [
    ({"vertices": '[["0", "0"], ["1", "y"]]'}, "vertices[1][1]", "'y' is not an integer"),
    ({"vertices": "[[0, 0], [1e400, 0]]"}, "vertices[1][0]", "1e400 is beyond the range of a double"),
    ({"vertices": "[[0, 0], [1]]"}, "vertices[1]", "a point is a list of two scalars, not a list of 1"),
    ({"vertices": "{}"}, "vertices", "a list is expected, not an object"),
    ({"vertices": "[[0, 0], [NaN, 0]]"}, "line 1, column 54", "NaN is not a number in JSON"),
    ({"edges": "[[0, 1], [0, 2]]"}, "edges[1][1]", "vertex 2 does not exist (there are 2)"),
    ({"edges": "[[0, 1, 0]]"}, "edges[0]", "an edge is a list of two vertex indices, not a list of 3"),
    ({"edges": "[[1, 1]]"}, "edges[0]", "both ends are vertex 1: an edge needs two"),
    ({"edges": "[0]"}, "edges[0]", "an edge is a list of two vertex indices, not the number 0"),
    ({"edges": '[["0", 1]]'}, "edges[0][0]", "a vertex index is expected, not the string '0'"),
    ({"edges": "null"}, "edges", "a list is expected, not null"),
    ({"edges": None}, "", "the key 'edges' is missing"),
    ({"vertices": None}, "", "the key 'vertices' is missing"),
    ({"format": None}, "", "the key 'format' is missing"),
    ({"format": '"exactmesh-pslg/2"'}, "format", "'exactmesh-pslg/1' is expected here, not the string"),
    ({"format": "1"}, "format", "'exactmesh-pslg/1' is expected here, not the number 1"),
    ({"holes": '[["0", "0"], 5]'}, "holes[1]", "a point is a list of two scalars, not the number 5"),
    ({"holes": "null"}, "holes", "a list is expected, not null"),
    ({"name": "5"}, "name", "a string is expected, not the number 5"),
    ({"hole": "[]"}, "", "unknown key 'hole'; exactmesh-pslg/1 has format, vertices, edges, holes, name"),
])
def test_what_is_wrong_is_named_with_its_place(parts, place, reason):
    with pytest.raises(FormatError) as caught:
        pslg_from_json(file_with(**parts))
    assert caught.value.place == place
    assert caught.value.reason.startswith(reason)


@given(st.data())
def test_a_mutated_file_is_read_or_refused(data):
    text = file_with(holes='[["1/3", 0.5]]', name='"n"')
    at = data.draw(st.integers(0, len(text)))
    new = data.draw(st.text(alphabet='{}[]",:/0123456789.eE+-truefalsn \\\n', max_size=4))
    try:
        pslg_from_json(text[:at] + new + text[at + data.draw(st.integers(0, 3)):])
    except InputError as error:
        assert "\n" not in str(error)
