"""`Faces.replace`, the judge of every step: what it accepts is a mesh and no worse, what it refuses changes nothing."""

import sys
from collections.abc import Callable
from types import FrameType
from typing import Any

import pytest
from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.optimize.faces import Faces

# A 4 x 2 rectangle in two triangles, the diagonal from 0 to 2.
CORNERS = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (4, 0), (4, 2), (0, 2))]
OUTLINE = {(0, 1), (1, 0), (1, 2), (2, 1), (2, 3), (3, 2), (3, 0), (0, 3)}
MIDDLE = Point(mpq(2), mpq(1))


def rectangle(constrained: frozenset[tuple[int, int]] = frozenset()) -> Faces:
    return Faces(CORNERS, 4, OUTLINE | constrained, [(0, 1, 2), (0, 2, 3)])


def cycles(faces: Faces) -> set[tuple[int, ...]]:
    return set(faces.cycle.values())


def state(faces: Faces) -> Any:
    return (dict(faces.cycle), dict(faces.owner), {v: set(around) for v, around in faces.around.items() if around},
            dict(faces.feature))


def test_a_flip_that_is_no_better_is_refused_but_kept_when_equal_is_enough() -> None:
    faces = rectangle()
    before = state(faces)
    flipped = [(0, 1, 3), (1, 2, 3)]
    assert faces.replace({0, 1}, flipped) is None
    assert state(faces) == before
    assert faces.replace({0, 1}, flipped, at_least=faces.feature[0]) == [2, 3]
    assert cycles(faces) == set(flipped)
    assert faces.owner[3, 1] == 3 == faces.owner[1, 2] and faces.around[0] == {2}


def test_a_better_step_is_taken_and_the_least_feature_size_comes_first() -> None:
    # The height of the flat triangle 0 1 2 grows when its apex moves up.
    points = [Point(mpq(x), mpq(y)) for x, y in ((0, 0), (4, 0), (2, 4), (2, 1))]
    faces = Faces(points, 3, {(0, 1), (1, 0), (1, 2), (2, 1), (2, 0), (0, 2)}, [(0, 1, 3), (1, 2, 3), (2, 0, 3)])
    worst = faces.feature[faces.worst()]
    made = faces.replace({0, 1, 2}, [(0, 1, -1), (1, 2, -1), (2, 0, -1)], [Point(mpq(2), mpq(5, 4))])
    assert made is not None
    assert faces.feature[faces.worst()] == min(faces.feature.values()) > worst
    assert faces.point[4] == Point(mpq(2), mpq(5, 4)) and not faces.around[3]


@pytest.mark.parametrize("new", [
    pytest.param([(0, 1, 2)], id="a part is left bare"),
    pytest.param([(0, 1, 2), (0, 3, 2)], id="turned the other way"),
    pytest.param([(0, 1, 2), (0, 1, 2)], id="a side twice"),
    pytest.param([(0, 1, 3), (0, 2, 3)], id="overlapping"),
    pytest.param([(0, 1, -1), (1, 2, -1), (2, 3, -1), (3, 0, -1), (0, 2, 1)], id="a face too many"),
    pytest.param([(0, 1, -2), (1, 2, -2), (2, 3, -2), (3, 0, -2)], id="from outside"),
    pytest.param([(0, 1, 2, 3)], id="a quadrilateral"),
    pytest.param([(0, 1, -3), (1, 2, -3), (2, 3, -3), (3, 0, -3)], id="a flat face"),
])
def test_what_is_no_tiling_is_refused_whatever_it_promises(new: list[tuple[int, ...]]) -> None:
    faces = rectangle()
    before = state(faces)
    added = [MIDDLE, Point(mpq(2), mpq(3)), Point(mpq(2), mpq(0))]
    assert faces.replace({0, 1}, new, added, at_least=mpq(0)) is None
    assert state(faces) == before and len(faces.point) == 4


def test_an_edge_of_the_input_between_two_faces_stays() -> None:
    faces = rectangle(frozenset({(0, 2), (2, 0)}))
    assert faces.neighbour((2, 0)) is None
    assert faces.replace({0, 1}, [(0, 1, 3), (1, 2, 3)], at_least=mpq(0)) is None


def test_a_vertex_of_the_input_stays_and_a_steiner_vertex_may_go() -> None:
    fan = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    for given, gone in ((5, False), (4, True)):
        faces = Faces([*CORNERS, MIDDLE], given, OUTLINE, fan)
        assert (faces.replace({0, 1, 2, 3}, [(0, 1, 2), (0, 2, 3)], at_least=mpq(0)) is not None) == gone


def test_a_ring_goes_around_both_sides_of_an_edge_between_faces_and_is_none_where_it_is_not_one_walk() -> None:
    fan = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)]
    faces = Faces([*CORNERS, MIDDLE], 4, OUTLINE, fan)
    assert sorted(faces.ring({0, 1, 2, 3}) or ()) == [0, 1, 2, 3]
    assert sorted(faces.ring({0, 1}) or ()) == [0, 1, 2, 4]
    assert faces.ring({0, 2}) is None
    slit = Faces([*CORNERS, MIDDLE], 5, OUTLINE | {(0, 4), (4, 0)}, fan)
    assert slit.ring({0, 1, 2, 3}) is None  # vertex 0 is passed twice


def test_faces_with_t_vertices_are_known_and_can_go() -> None:
    points = [*CORNERS, MIDDLE]
    faces = Faces(points, 4, OUTLINE, [(0, 1, 4), (1, 2, 4), (0, 4, 2, 3)])
    assert faces.around[4] == {0, 1, 2}
    assert faces.replace({0, 1, 2}, [(0, 1, 3), (1, 2, 3)], at_least=mpq(0)) is not None


def test_a_cycle_that_is_no_triangle_is_not_taken_in() -> None:
    with pytest.raises(ValueError, match="counter-clockwise"):
        Faces(CORNERS, 4, OUTLINE, [(0, 2, 1), (0, 2, 3)])


def interrupting(at: int) -> Callable[[FrameType, str, Any], Any]:
    """Return a trace function that interrupts `Faces.settle` when its `at`-th line is reached."""
    count = 0

    def in_settle(frame: FrameType, event: str, _: Any) -> Any:
        nonlocal count
        if event == "line":
            count += 1
            if count == at:
                raise KeyboardInterrupt
        return in_settle

    def trace(frame: FrameType, event: str, _: Any) -> Any:
        return in_settle if frame.f_code.co_name in ("settle", "_insert") else None

    return trace


def test_a_step_interrupted_at_any_line_is_made_whole_afterwards() -> None:
    fan = [(0, 1, -1), (1, 2, -1), (2, 3, -1), (3, 0, -1)]
    whole = rectangle()
    assert whole.replace({0, 1}, fan, [MIDDLE], at_least=mpq(0)) == [2, 3, 4, 5]
    before = state(rectangle())
    seen: set[str] = set()
    for at in range(1, 400):
        faces = rectangle()
        old = sys.gettrace()
        sys.settrace(interrupting(at))
        try:
            faces.replace({0, 1}, fan, [MIDDLE], at_least=mpq(0))
            break
        except KeyboardInterrupt:
            pass
        finally:
            sys.settrace(old)
        faces.settle()
        assert state(faces) in (before, state(whole)), at
        seen.add("before" if state(faces) == before else "whole")
        # The next step finds everything in order.
        if state(faces) == state(whole):
            assert faces.replace({2, 3, 4, 5}, [(0, 1, 3), (1, 2, 3)], at_least=mpq(0)) == [6, 7]
            assert faces.worst() in (6, 7)
    else:
        pytest.fail("the step has more lines than expected")
    assert at > 30 and "whole" in seen
