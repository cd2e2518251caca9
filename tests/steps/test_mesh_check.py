"""The checkers of the finished mesh: every bound is exact, and an invalid mesh fails them all."""

from dataclasses import replace
from math import log2

import pytest
from constructions import clauses_of, run
from gmpy2 import mpq
from recorded import recorded

from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import Violation
from exactmesh.steps import mesh_check
from exactmesh.steps.mesh_check import (
    check_design_degradation,
    check_internal_degradation,
    check_paper_degradation,
    check_paper_feature,
    check_proper_degradation,
    check_proper_logarithm,
    check_valid,
    check_vertex_count,
)

FAMILIES = ["hall", "triangle", "comb 5", "turned comb", "random pslg 1", "star 24", "tiny", "huge"]
GOOD = run("hall").verification
INPUT = GOOD.input_mfs.squared
TINY = mpq(1, 10**40)
ON_MESH = [check_paper_degradation, check_design_degradation, check_paper_feature]


def degraded(squared):
    """Return the verification of a mesh of this squared degradation."""
    return replace(GOOD, mesh_mfs=Nearest(INPUT / mpq(squared), 3, (1, 2)))


def invalid():
    """Return the verification of a mesh with two violations."""
    return replace(GOOD, mesh_mfs=None, violations=(Violation("overlap", {"face": 7}),
                                                    Violation("unused-vertex", {"vertex": 1})))


@pytest.mark.parametrize("name", FAMILIES)
def test_good_results_are_accepted(name):
    made = run(name)
    for check in (*ON_MESH, check_valid):
        assert check(made.verification).holds
    assert check_vertex_count(made.verification, made.construction.shape.corner_count).holds
    assert check_valid(made.verification).instances == len(made.construction.mesh.faces)


@pytest.mark.parametrize("check, squared, holds, clause", [
    (check_paper_degradation, 45**2 - TINY, True, "degradation < 45"),
    (check_paper_degradation, 45**2, False, "degradation < 45"),
    (check_paper_degradation, 45**2 + TINY, False, "degradation < 45"),
    (check_design_degradation, mpq("108/5") ** 2, True, "degradation <= 21.6"),
    (check_design_degradation, mpq("108/5") ** 2 + TINY, False, "degradation <= 21.6"),
    (check_paper_feature, 1 / mpq("22/1000") ** 2, True, "mfs >= 0.022 mfs(P)"),
    (check_paper_feature, 1 / mpq("22/1000") ** 2 + TINY, False, "mfs >= 0.022 mfs(P)"),
])
def test_the_bounds_are_exact(check, squared, holds, clause):
    verdict = check(degraded(squared))
    assert verdict.holds == holds and verdict.witness.clause == clause and verdict.instances == 1
    assert verdict.witness.place == {"vertex": 3, "edge": [1, 2]}


def test_a_mesh_no_worse_than_its_input_holds():
    assert all(check(degraded(1)).holds for check in ON_MESH)


@pytest.mark.parametrize("kind, limit", [("nonproper", 35), ("proper", 51)])
def test_so_many_vertices_a_corner_are_allowed(kind, limit):
    for steiner, holds in ((0, True), (10 * limit, True), (10 * limit + 1, False)):
        verdict = check_vertex_count(replace(GOOD, kind=kind, steiner=steiner), 10)
        assert verdict.holds == holds and verdict.worst == mpq(steiner, 10)
        assert verdict.witness.clause == f"Steiner vertices <= {limit} a corner"


@pytest.mark.parametrize("corners, bound", [(2, "108/5"), (4, 27), (8, 36), (1024, 99)])
def test_a_proper_mesh_pays_a_logarithm(corners, bound):
    exact = mpq(bound) ** 2
    assert check_proper_degradation(degraded(exact), corners).holds
    verdict = check_proper_degradation(degraded(exact + TINY), corners)
    assert not verdict.holds and verdict.witness.clause == "degradation <= max(21.6, 9 (1 + log2 n))"


@pytest.mark.parametrize("corners, bound", [(4, 66), (8, 88), (1024, 242)])
def test_what_is_proved_of_a_proper_mesh(corners, bound):
    exact = mpq(bound) ** 2
    assert check_proper_logarithm(degraded(exact), corners).holds
    verdict = check_proper_logarithm(degraded(exact + TINY), corners)
    assert not verdict.holds and verdict.witness.clause == "degradation <= 22 (1 + log2 n)"
    assert check_proper_logarithm(invalid(), corners).witness.clause == "the mesh is valid"


@pytest.mark.parametrize("corners", [3, 5, 6, 7, 100, 999, 10**6 + 1])
def test_the_logarithm_is_rounded_down_and_by_little(corners):
    bound = 9 * (1 + log2(corners))
    assert check_proper_degradation(degraded(mpq(bound - 0.01) ** 2), corners).holds
    assert not check_proper_degradation(degraded(mpq(bound + 0.0001) ** 2), corners).holds


@pytest.mark.parametrize("check", ON_MESH)
def test_an_invalid_mesh_has_no_degradation(check):
    verdict = check(invalid())
    assert not verdict.holds and verdict.worst is None
    assert (verdict.witness.clause, verdict.witness.place) == ("the mesh is valid", {"violations": 2})


def test_the_first_violation_is_the_witness():
    verdict = check_valid(invalid())
    assert not verdict.holds and (verdict.witness.clause, verdict.witness.place) == ("overlap", {"face": 7})


def test_a_pair_of_vertices_is_named_as_such():
    verdict = check_paper_degradation(replace(GOOD, mesh_mfs=Nearest(INPUT, 3, (8, 8))))
    assert verdict.witness.place == {"vertex": 3, "other": 8}


@pytest.mark.parametrize("corners", [1, 10])
def test_an_invalid_proper_mesh_has_no_degradation(corners):
    assert check_proper_degradation(invalid(), corners).witness.clause == "the mesh is valid"


@pytest.mark.parametrize("squared, holds", [(mpq(45) ** 2, False), (mpq(45) ** 2 - TINY, True), (mpq(1), True)])
def test_the_bound_of_internal_meshes_is_strict(squared, holds):
    internal = replace(GOOD, kind="internal", input_ifs=Nearest(mpq(1), 0, (1, 2)),
                       mesh_ifs=Nearest(1 / squared, 4, (5, 6)))
    verdict = check_internal_degradation(internal)
    assert verdict.holds == holds and verdict.worst == squared and verdict.witness.clause == "ifs degradation < 45"
    assert verdict.witness.place == {"vertex": 4, "edge": [5, 6]}
    assert not check_internal_degradation(GOOD).holds


def test_every_clause_is_tested_above():
    assert clauses_of(mesh_check) == {
        "degradation < 45", "degradation <= 21.6", "degradation <= max(21.6, 9 (1 + log2 n))",
        "degradation <= 22 (1 + log2 n)", "ifs degradation < 45", "mfs >= 0.022 mfs(P)",
        "Steiner vertices <= {} a corner", "the mesh is valid"}


def test_verdicts_say_all_there_is_to_say():
    with recorded("mesh", mesh_check) as lines:
        internal = replace(GOOD, kind="internal", input_ifs=Nearest(mpq(1), 0, (1, 2)),
                           mesh_ifs=Nearest(mpq(1, 45**2), 4, (5, 6)))
        pair = replace(GOOD, mesh_mfs=Nearest(INPUT / 3, 3, (8, 8)))
        verdicts = []
        for name, found in (("good", GOOD), ("invalid", invalid()), ("pair", pair), ("internal", internal)):
            verdicts += [(f"{name}: {check.__name__}", check(found))
                         for check in (*ON_MESH, check_valid, check_internal_degradation)]
            verdicts += [(f"{name}: {check.__name__}", check(found, 7))
                         for check in (check_proper_degradation, check_vertex_count)]
        lines += verdicts


def test_an_internal_mesh_needs_both_feature_sizes():
    near = Nearest(mpq(1), 0, (1, 2))
    for input_ifs, mesh_ifs in ((near, None), (None, near)):
        verdict = check_internal_degradation(replace(GOOD, kind="internal", input_ifs=input_ifs, mesh_ifs=mesh_ifs))
        assert not verdict.holds and verdict.witness.clause == "the mesh is valid"
