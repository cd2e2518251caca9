"""The functions of the package: what they return, what they refuse, and that they agree with each other."""

import doctest
import inspect
import sys

import families
import pytest
from constructions import HALL, graph
from gmpy2 import mpq

import exactmesh
from exactmesh.errors import FormatError, GeometryError, InputError
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.measure.mfs import Nearest
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])
BAD = {
    "crossing": graph([(0, 0), (4, 4), (4, 0), (0, 4)]),
    "overlapping": graph([(0, 0), (4, 0), (2, 0), (2, 3)]),
    "vertex on edge": graph([(0, 0), (4, 0), (4, 4), (2, 0), (0, 4)]),
    "vertices coincide": graph([(0, 0), (4, 0), (0, 0), (0, 4)]),
    "hole outside": Pslg(SQUARE.vertices, SQUARE.edges, graph([(9, 9), (0, 0), (1, 1)]).vertices[:1]),
    "hole on an edge": Pslg(SQUARE.vertices, SQUARE.edges, graph([(2, 0), (0, 0), (1, 1)]).vertices[:1]),
}
EMPTY = {
    "nothing": Pslg((), ()),
    "a point": Pslg(SQUARE.vertices[:1], ()),
    "an edge": graph([(0, 0), (4, 0)], [(0, 1)]),
    "a path": graph([(0, 0), (4, 0), (4, 4)], [(0, 1), (1, 2)]),
    "all holes": Pslg(SQUARE.vertices, SQUARE.edges, graph([(1, 1), (0, 0), (1, 0)]).vertices[:1]),
}


def test_the_examples_in_the_docstrings_run() -> None:
    assert exactmesh.__doc__ and ">>>" in exactmesh.__doc__
    assert doctest.testmod(exactmesh).failed == 0


def test_everything_that_is_promised_is_there() -> None:
    assert sorted(exactmesh.__all__) == sorted(set(exactmesh.__all__))
    assert all(hasattr(exactmesh, name) for name in exactmesh.__all__)


def test_the_mfs_of_a_square() -> None:
    assert exactmesh.mfs(SQUARE) == Nearest(mpq(16), 2, (0, 1))


@pytest.mark.parametrize("pslg, nearest", [
    (Pslg((), ()), None), (Pslg(SQUARE.vertices[:1], ()), None),
    (Pslg(SQUARE.vertices[:2], ()), Nearest(mpq(16), 1, (0, 0))),
    (graph([(0, 0), (4, 0)], [(0, 1)]), Nearest(mpq(16), 1, (0, 0))),
])
def test_the_mfs_where_there_is_next_to_nothing(pslg: Pslg, nearest: Nearest | None) -> None:
    assert exactmesh.mfs(pslg) == nearest


@pytest.mark.parametrize("name", BAD)
def test_what_is_no_pslg_is_refused_everywhere(name: str) -> None:
    for function in (exactmesh.mfs, exactmesh.mesh, lambda p: exactmesh.verify(p, Mesh("classic", (), ()))):
        with pytest.raises(GeometryError):
            function(BAD[name])


@pytest.mark.parametrize("name", EMPTY)
def test_what_encloses_nothing_has_no_mesh(name: str) -> None:
    for function in (exactmesh.mesh, lambda p: exactmesh.verify(p, Mesh("classic", p.vertices, ()))):
        with pytest.raises(InputError, match="nothing"):
            function(EMPTY[name])
    exactmesh.mfs(EMPTY[name])


@pytest.mark.parametrize("name", ["hall", "comb 5", "random pslg 4", "triangle"])
def test_a_meshing_is_consistent(name: str) -> None:
    pslg = HALL if name == "hall" else (families.ALL_SMALL | families.SMALL_PSLGS)[name]
    result = exactmesh.mesh(pslg)
    assert result.holds and all(j.verdict.holds for j in result.judgements)
    assert result.verification == exactmesh.verify(pslg, result.mesh)
    assert result.verification.input_mfs == exactmesh.mfs(pslg)
    assert result.verification.faces == len(result.mesh.faces)
    assert result.verification.steiner == len(result.mesh.vertices) - len(pslg.vertices)


def test_the_same_input_gives_the_same_mesh() -> None:
    assert exactmesh.mesh(HALL).mesh == exactmesh.mesh(HALL).mesh


def test_progress_is_told_the_steps_in_order() -> None:
    told: list[str] = []
    exactmesh.mesh(SQUARE, progress=told.append)
    steps = ["validation", "offset", "trapezoidation", "interior", "tube", "verification"]
    assert [step for step in told if step in steps] == steps


def test_a_mesh_of_another_tool_is_verified() -> None:
    half = Mesh("classic", SQUARE.vertices, ((0, 1, 2), (0, 2, 3)))
    verification = exactmesh.verify(SQUARE, half)
    assert verification.valid and verification.degradation_squared == 2 and verification.steiner == 0


def test_a_bad_mesh_is_no_error() -> None:
    verification = exactmesh.verify(SQUARE, Mesh("classic", SQUARE.vertices, ((0, 1, 2),)))
    assert not verification.valid and verification.degradation_squared is None and verification.mesh_mfs is None


def test_a_file_is_read(tmp_path) -> None:  # type: ignore[no-untyped-def]
    path = tmp_path / "a.json"
    path.write_text(json_from_pslg(HALL), encoding="utf-8")
    assert exactmesh.read(str(path)) == HALL
    with pytest.raises(InputError, match="no such file"):
        exactmesh.read(str(tmp_path / "b.json"))


def test_polygon_takes_numbers_and_text_but_no_floats() -> None:
    assert exactmesh.polygon([(0, 0), ("7/2", 0), (0, "0.1")]).vertices[1].x == mpq(7, 2)
    with pytest.raises(FormatError):
        exactmesh.polygon([(0, 0), ("nan", 0), (0, 1)])


def test_deep_and_long_inputs_do_not_recurse() -> None:
    limit = sys.getrecursionlimit()
    try:
        sys.setrecursionlimit(len(inspect.stack()) + 90)
        assert exactmesh.mesh(families.comb(98)).holds
    finally:
        sys.setrecursionlimit(limit)


def test_the_kind_decides_on_the_construction():
    room = exactmesh.polygon([(0, 0), (9, 0), (9, 1), (5, 1), (4, 1), (0, 1)])
    fast, best = (exactmesh.mesh(room, kind="classic", optimal=optimal) for optimal in (False, True))
    assert fast.mesh.kind == best.mesh.kind == "classic" and fast.holds and best.holds
    assert best.verification.degradation_squared == 26 <= fast.verification.degradation_squared
    assert exactmesh.mesh(room, kind="internal").verification.ifs_degradation_squared < 45**2
