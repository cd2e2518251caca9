"""The quick readers: what they take they read as the plain readers do, and what those refuse they leave alone."""

import json
import random

import families
import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io import as_written
from exactmesh.io.as_written import mesh_as_written, pslg_as_written
from exactmesh.io.limits import Limits, limited
from exactmesh.io.mesh_json import json_from_mesh, mesh_from_json, mesh_from_value
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json, pslg_from_value
from exactmesh.io.strict_json import parse_json
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

GRAPHS = families.ALL_SMALL | families.SMALL_PSLGS
MARKED = Pslg(tuple(Point(mpq(x, 3), mpq(-y, 7)) for x, y in [(0, 0), (9, 0), (9, 9), (0, 9)]),
              ((0, 1), (1, 2), (2, 3), (3, 0)), (Point(mpq(1), mpq(-1, 2)),), 'a "name" \udc00')
MESH = Mesh("nonproper", MARKED.vertices, ((0, 1, 2), (0, 2, 3)))


def plain_pslg(text: str) -> Pslg | None:
    try:
        return pslg_from_value(parse_json(text))
    except FormatError:
        return None


def plain_mesh(text: str) -> Mesh | None:
    try:
        return mesh_from_value(parse_json(text))
    except FormatError:
        return None


@pytest.mark.parametrize("name", GRAPHS)
def test_what_is_written_is_read_quickly_and_is_the_same(name: str) -> None:
    graph = GRAPHS[name]
    text = json_from_pslg(graph)
    found = pslg_as_written(text)
    if graph.edges:
        assert found is not None
        assert found == graph == plain_pslg(text) and found.name == graph.name


def test_holes_name_and_a_mesh_are_read_quickly() -> None:
    found = pslg_as_written(json_from_pslg(MARKED))
    assert found is not None
    assert found == MARKED and found.holes == MARKED.holes and found.name == MARKED.name
    assert mesh_as_written(json_from_mesh(MESH)) == MESH


@pytest.mark.parametrize("indent", [None, 0, 1])
def test_white_space_may_be_anywhere(indent: int | None) -> None:
    for text in (json_from_pslg(MARKED), json_from_mesh(MESH)):
        laid_out = json.dumps(json.loads(text), indent=indent) if indent is not None else json.dumps(
            json.loads(text), separators=(",", ":"))
        if "edges" in text:
            assert pslg_as_written(laid_out) == MARKED
        else:
            assert mesh_as_written(laid_out) == MESH


@pytest.mark.parametrize("stretch", [1, 2, 7, 20, 64])
def test_stretches_of_any_length_make_no_difference(stretch: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(as_written, "_STRETCH", stretch)
    result = exactmesh.mesh(families.comb(3))
    assert mesh_as_written(json_from_mesh(result.mesh)) == result.mesh
    assert pslg_as_written(json_from_pslg(MARKED)) == MARKED


# Scalars that `mpq` takes and the format does not, or the other way about, and much else.
SCALARS = ["1/-2", "--1", "-", "", "1/0", "1/", "/2", "1/2/3", "+1", "0.5", "1e3", " 1", "1_0", "\\u0031", "\u0661",
           "-0", "007", "-1/2", "0x1", "nan", "1-", "-/1", "1/-0"]


@pytest.mark.parametrize("scalar", SCALARS)
@pytest.mark.parametrize("bare", [False, True])
def test_any_scalar_is_read_as_by_the_plain_reader(scalar: str, bare: bool) -> None:
    for text, quick, plain in ((json_from_pslg(MARKED), pslg_as_written, plain_pslg),
                               (json_from_mesh(MESH), mesh_as_written, plain_mesh)):
        changed = text.replace('"3"', scalar if bare else f'"{scalar}"', 1)
        assert changed != text
        found = quick(changed)
        assert found is None or found == plain(changed)


PIECES = [*'0123456789-/"[],:{} \n', "[[", "]]", '"-', "-0", "1.5", '["1", "2"],', "[0, 1],"]


def test_random_harm_to_the_text_is_never_read_in_another_way() -> None:
    source = random.Random(7)
    taken = 0
    for text, quick, plain in ((json_from_pslg(MARKED), pslg_as_written, plain_pslg),
                               (json_from_mesh(MESH), mesh_as_written, plain_mesh)):
        for _ in range(6000):
            place = source.randrange(len(text))
            how = source.randrange(4)
            piece = source.choice(PIECES)
            end = place + (how > 0)
            if how == 3:
                end = min(len(text), place + source.randrange(20))
            changed = text[:place] + ("" if how == 2 else piece) + text[end:]
            found = quick(changed)
            if found is not None:
                taken += 1
                assert found == plain(changed), changed
    assert taken > 500


@pytest.mark.parametrize("text", [
    '{"format": "exactmesh-mesh/1", "kind": "best", "vertices": [["0", "0"]], "faces": [[0, 0, 0]]}',
    '{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [["0", "0"]], "faces": [[0, 0]]}',
    '{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [["0", "0"]], "faces": [[0, 0, 1]]}',
    '{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [["0", "0"]], "faces": [[]]}',
    '{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [["0", "0"]], "faces": [[0, 0, 0]], "more": 1}',
    '{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [["0", "0"]], "faces": [[0, [0], 0]]}',
    '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": [[0, 0]]}',
    '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": [[0, 1, 1]]}',
    '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": [[0, 1]], "edges": [[0, 1]]}',
    '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": [[0, 1]], "format": ""}',
    '{"format": "exactmesh-pslg/1", "vertices": [["0", "0"], ["1", "0"]], "edges": [[0, 1]], "name": 3}',
])
def test_what_is_wrong_is_left_to_the_plain_reader(text: str) -> None:
    quick, read = (mesh_as_written, mesh_from_json) if "mesh" in text else (pslg_as_written, pslg_from_json)
    assert quick(text) is None
    with pytest.raises(FormatError):
        read(text)


def test_the_limits_hold_for_the_quick_readers() -> None:
    for text, quick in ((json_from_pslg(MARKED), pslg_as_written), (json_from_mesh(MESH), mesh_as_written)):
        with limited(Limits(items=3)), pytest.raises(FormatError, match="more than 3 items"):
            quick(text)
