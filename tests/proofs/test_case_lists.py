"""The lists of cases that programs make for the proofs are complete, and the comparisons see what is wrong."""

import importlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.one_sided import _candidates
from exactmesh.steps.records import Patch, Trapezoidation
from exactmesh.steps.trapezoidation import trapezoidate


@pytest.fixture
def scripts(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(Path(exactmesh.__file__).parents[1] / "proofs_checks"))
    return importlib.import_module


class TestSweep:
    @pytest.mark.parametrize("levels, letters, count", [(1, 3, 61), (2, 2, 49), (3, 2, 245)])
    def test_all_stacks_of_small_levels_are_swept_as_defined(self, scripts: Any, levels: int, letters: int, count: int
                                                             ) -> None:
        assert scripts("repaired_sweep").check_levels(levels, letters) == count

    def test_what_is_compared(self, scripts: Any) -> None:
        sweep = scripts("repaired_sweep")
        # With one letter there are two that lead outside again; of two letters, two that pass have no vertex.
        assert [len(list(sweep.stacks(1, n))) for n in (1, 2, 3)] == [2, 11, 61]
        assert all(sweep.step((above, True), letter) == sweep.STEPS.get(((above, True), letter))
                   for above in (False, True) for letter in (*sweep.VERTICES, sweep.PASS))
        drawn = sweep.Drawn(((sweep.Letter(0, 2),), (sweep.Letter(2, 0),)))
        assert not drawn.is_straight()

    @pytest.mark.parametrize("harm", [
        lambda made: replace(made, trapezoids=made.trapezoids[1:]),
        lambda made: replace(made, trapezoids=tuple(replace(z, top=(), bottom=()) for z in made.trapezoids)),
        lambda made: replace(made, edge=made.edge[::-1])], ids=["one too few", "no T-vertices", "ends exchanged"])
    def test_a_harmed_sweep_is_seen(self, scripts: Any, monkeypatch: pytest.MonkeyPatch,
                                    harm: Callable[[Trapezoidation], Trapezoidation]) -> None:
        sweep = scripts("repaired_sweep")
        monkeypatch.setattr(sweep, "trapezoidate", lambda offset: harm(trapezoidate(offset)))
        with pytest.raises(AssertionError):
            sweep.check_levels(1, 3)


class TestOffset:
    def test_there_are_six_kinds_of_corner_and_every_pair_has_a_label(self, scripts: Any) -> None:
        nesting = scripts("repaired_nesting")
        assert sum(nesting.corner_kinds().values()) == 32**2 and set(nesting.corner_kinds()) == set(nesting.KINDS)
        assert {label for label, _ in nesting.pairs()} == set(nesting.LABELS)

    def test_a_cap_that_goes_the_other_way_is_seen(self, scripts: Any, monkeypatch: pytest.MonkeyPatch) -> None:
        nesting = scripts("repaired_nesting")
        vertices = nesting.vertices_at
        monkeypatch.setattr(nesting, "vertices_at", lambda d0, d1: vertices(d0, d1)[::-1])
        with pytest.raises(AssertionError):
            nesting.corner_kinds()


class TestTilings:
    @pytest.mark.parametrize("proper", [False, True])
    def test_faces_of_all_small_trapezoids_add_up(self, scripts: Any, proper: bool) -> None:
        tilings = scripts("repaired_tilings")
        # Sides of length n have 2^(n - 1) sets of T-vertices.
        assert [len(list(tilings.rooms(n))) for n in (2, 3)] == [5, 35]
        assert tilings.check_trapezoids(5, proper) == 749

    def test_wedges_fans_and_cross_edges_come_up(self, scripts: Any) -> None:
        tilings = scripts("repaired_tilings")
        rooms = list(tilings.rooms(6))
        assert tilings.Room((0, 1, 2, 3), (5, 5), (True, True, True, True)) in rooms
        assert tilings.Room((0, 2), (5, 5), (True, False, True, True)) in rooms
        assert tilings.Room((0, 1, 3, 5), (0, 2, 4, 5), (True,) * 4) in rooms

    @pytest.mark.parametrize("harm", [lambda faces: faces[1:], lambda faces: (*faces, faces[0]),
                                      lambda faces: (faces[0][::-1], *faces[1:])], ids=["fewer", "twice", "turned"])
    def test_a_wrong_face_is_seen(self, scripts: Any, monkeypatch: pytest.MonkeyPatch, harm: Callable[[Any], Any]
                                  ) -> None:
        tilings = scripts("repaired_tilings")

        def harmed(*given: Any) -> Patch:
            patch = triangulate_interior(*given)
            return replace(patch, faces=harm(patch.faces))
        monkeypatch.setattr(tilings, "triangulate_interior", harmed)
        with pytest.raises(AssertionError):
            tilings.check_trapezoids(3, False)
        monkeypatch.setattr(tilings, "_candidates", lambda frame, proper: (
            candidate._replace(faces=harm(candidate.faces)) for candidate in _candidates(frame, proper)))
        with pytest.raises(AssertionError):
            tilings.check_candidates(1)

    def test_sides_of_all_candidates_and_of_the_tube_add_up(self, scripts: Any) -> None:
        tilings = scripts("repaired_tilings")
        seen = tilings.check_candidates(3)
        # Splits, hubs or centres and one apex, two and three apexes; rows of three, two and one in a proper mesh.
        assert {(False, 3, 0), (False, 3, 1), (False, 3, 2), (False, 3, 3), (True, 3, 6)} <= set(seen)
        assert tilings.tube_blocks() == 25 + 125 + 625 + 1


class TestCount:
    def test_charges(self, scripts: Any) -> None:
        count = scripts("repaired_count")
        assert count.charges(False) == {1: 12, 2: 20, 3: 23, 4: 31, 5: 34, 8: 34}
        assert max(count.charges(True).values()) == mpq(455, 9) < 51

    def test_pieces_of_all_small_trapezoids_have_few_gaps(self, scripts: Any) -> None:
        assert scripts("repaired_count").check_pieces(5) == 615

    def test_candidates_have_few_new_vertices(self, scripts: Any, monkeypatch: pytest.MonkeyPatch) -> None:
        count = scripts("repaired_count")
        assert count.check_new_vertices(2) > 5
        monkeypatch.setattr(count, "check_candidates", lambda gaps: {(False, 2, 3): 1})
        with pytest.raises(AssertionError):
            count.check_new_vertices(2)

    def test_rows_over_gaps(self, scripts: Any) -> None:
        layers_of = scripts("repaired_count").layers_of
        assert [layers_of(n) for n in (1, 2, 3, 5, 9)] == [1, 3, 6, 11, 20]
        assert all(9 * layers_of(n) <= 20 * n for n in range(1, 3000))
