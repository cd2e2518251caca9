"""The format exactmesh-mesh/1."""

import pytest
from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.mesh_json import json_from_mesh, mesh_from_json
from exactmesh.planar.mesh import KINDS, Mesh

POINTS = st.builds(Point, st.fractions().map(mpq), st.fractions().map(mpq))


@st.composite
def meshes(draw):
    """Return a record that need not be a triangulation."""
    vertices = draw(st.lists(POINTS, min_size=1, max_size=6))
    face = st.lists(st.integers(0, len(vertices) - 1), min_size=3, max_size=6).map(tuple)
    return Mesh(draw(st.sampled_from(KINDS)), tuple(vertices), tuple(draw(st.lists(face, max_size=5))))


@given(meshes())
def test_what_was_written_is_read(mesh):
    text = json_from_mesh(mesh)
    assert mesh_from_json(text) == mesh
    assert json_from_mesh(mesh_from_json(text)) == text


def test_the_text_of_a_mesh():
    mesh = Mesh("nonproper", tuple(Point(mpq(x), mpq(y, 2)) for x, y in [(0, 0), (1, 0), (0, 1)]),
                ((0, 1, 2),))
    assert json_from_mesh(mesh) == """{"format": "exactmesh-mesh/1",
 "kind": "nonproper",
 "vertices": [
  ["0", "0"],
  ["1", "0"],
  ["0", "1/2"]],
 "faces": [
  [0, 1, 2]]}
"""


def file_with(**parts):
    defaults = {"format": '"exactmesh-mesh/1"', "kind": '"proper"', "vertices": "[[0, 0], [1, 0], [0, 1]]",
                "faces": "[[0, 1, 2]]"}
    return "{" + ", ".join(f'"{k}": {v}' for k, v in (defaults | parts).items() if v is not None) + "}"


@pytest.mark.parametrize("parts, place, reason", [
    ({"kind": '"other"'}, "kind",
     "one of classic, nonproper, proper, internal is expected, not the string 'other'"),
    ({"kind": "[]"}, "kind", "one of classic, nonproper, proper, internal is expected, not a list of 0"),
    ({"faces": "[[0, 1, 2], [0, 1, 3]]"}, "faces[1][2]", "vertex 3 does not exist (there are 3)"),
    ({"faces": "[[0, 1]]"}, "faces[0]", "a face has at least three vertices, not 2"),
    ({"faces": "[7]"}, "faces[0]", "a list is expected, not the number 7"),
    ({"faces": "[[0, 1, true]]"}, "faces[0][2]", "a vertex index is expected, not true"),
    ({"vertices": '[[0, "a"]]'}, "vertices[0][1]",
     "'a' is not an integer, a finite decimal or a fraction p/q"),
    ({"faces": None}, "", "the key 'faces' is missing"),
    ({"name": '"n"'}, "", "unknown key 'name'; exactmesh-mesh/1 has format, kind, vertices, faces"),
    ({"format": '"exactmesh-pslg/1"'}, "format",
     "'exactmesh-mesh/1' is expected here, not the string 'exactmesh-pslg/1'"),
])
def test_what_is_wrong_is_named_with_its_place(parts, place, reason):
    with pytest.raises(FormatError) as caught:
        mesh_from_json(file_with(**parts))
    assert (caught.value.place, caught.value.reason) == (place, reason)


@given(st.data())
def test_a_mutated_file_is_read_or_refused(data):
    text = file_with()
    at = data.draw(st.integers(0, len(text)))
    new = data.draw(st.text(alphabet='{}[]",:/0123456789.eE+-truefalsn \\\n', max_size=4))
    try:
        mesh_from_json(text[:at] + new + text[at + data.draw(st.integers(0, 3)):])
    except InputError as error:
        assert "\n" not in str(error)
