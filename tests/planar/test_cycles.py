"""Boundaries of sets of cycles, by index alone."""

from collections import Counter

from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.planar.cycles import directed_edges, sides

few = settings(max_examples=200, deadline=None, derandomize=True)
cycles = st.lists(st.integers(0, 6), max_size=5, unique=True).map(tuple)


def test_sides_of_a_cycle_end_with_the_closing_one() -> None:
    assert list(sides((4, 7, 2))) == [(4, 7), (7, 2), (2, 4)]
    assert list(sides((4, 7))) == [(4, 7), (7, 4)]
    assert list(sides((4,))) == [(4, 4)]
    assert list(sides(())) == []


def test_each_directed_edge_has_the_first_cycle_that_has_it() -> None:
    owner, repeated = directed_edges([(0, 1, 2), (2, 1, 3), (3, 0, 1)])
    assert owner == {(0, 1): 0, (1, 2): 0, (2, 0): 0, (2, 1): 1, (1, 3): 1, (3, 2): 1, (3, 0): 2}
    assert repeated == [((0, 1), 2), ((1, 3), 2)]


@few
@given(st.lists(cycles, max_size=6))
def test_owners_and_repetitions_are_all_the_sides(faces: list[tuple[int, ...]]) -> None:
    owner, repeated = directed_edges(faces)
    count = Counter(side for face in faces for side in sides(face))
    assert count == Counter(list(owner) + [side for side, _ in repeated])
    for side, number in owner.items():
        assert number == min(i for i, face in enumerate(faces) if side in list(sides(face)))
    assert all(number > owner[side] and side in list(sides(faces[number])) for side, number in repeated)


@few
@given(cycles, st.integers(0, 4))
def test_turning_a_cycle_keeps_its_sides(cycle: tuple[int, ...], k: int) -> None:
    assert set(sides(cycle)) == set(sides(cycle[k:] + cycle[:k]))
