"""Parts become one PSLG."""

import pytest
from gmpy2 import mpq, mpz

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.rings import Assembly, Run


def run(*corners):
    points = [Point(mpq(x), mpq(y)) for x, y in corners]
    return Run(points, lambda index: "the run" if index is None else f"position {index}")


SQUARE = run((0, 0), (2, 0), (2, 2), (0, 2), (0, 0))


def test_a_shared_border_is_shared():
    assembly = Assembly()
    assembly.add_polygon([SQUARE])
    assembly.add_polygon([run((2, 0), (4, 0), (4, 2), (2, 2), (2, 0))])
    pslg = assembly.pslg()
    assert pslg.vertices == ((0, 0), (2, 0), (2, 2), (0, 2), (4, 0), (4, 2))
    assert pslg.edges == ((0, 1), (1, 2), (2, 3), (3, 0), (1, 4), (4, 5), (5, 2))
    assert pslg.holes == ()


def test_a_segment_there_and_back_is_one_edge():
    assembly = Assembly()
    assembly.add_line(run((0, 0), (1, 0), (0, 0)))
    assembly.add_line(run((1, 0), (0, 0)))
    assert assembly.pslg().edges == ((0, 1),)


def test_a_point_is_a_vertex_once():
    assembly = Assembly()
    for x in (1, 1, 0):
        assembly.add_point(Point(mpq(x), mpq(0)))
    assembly.add_line(run((0, 0), (5, 5)))
    assert assembly.pslg().vertices == ((1, 0), (0, 0), (5, 5))


def test_a_ring_through_one_vertex_twice_is_merged_there():
    assembly = Assembly()
    assembly.add_polygon([run((0, 0), (2, 1), (2, -1), (0, 0), (-2, 1), (-2, -1), (0, 0))])
    pslg = assembly.pslg()
    assert len(pslg.vertices) == 5 and len(pslg.edges) == 6 and pslg.holes == ()


@pytest.mark.parametrize("add, corners, place, reason", [
    ("line", [(0, 0)], "the run", "a line needs at least two positions, not 1"),
    ("line", [], "the run", "a line needs at least two positions, not 0"),
    ("line", [(0, 0), (1, 0), (1, 0)], "position 2", "a zero-length edge: (1, 0) is repeated"),
    ("ring", [], "the run", "a ring needs at least three distinct points, not 0"),
    ("ring", [(0, 0)], "the run", "a ring needs at least three distinct points, not 1"),
    ("ring", [(0, 0), (1, 0), (0, 0)], "the run", "a ring needs at least three distinct points, not 2"),
    ("ring", [(0, 0), (1, 0), (0, 1)], "the run", "the ring is not closed: from (0, 0) to (0, 1)"),
    ("ring", [(0, 0), (1, 0), (1, 0), (0, 1), (0, 0)], "position 2",
     "a zero-length edge: (1, 0) is repeated"),
    ("ring", [(0, 0), (1, 0), (0, 1), (0, 0), (0, 0)], "position 4",
     "a zero-length edge: (0, 0) is repeated"),
])
def test_what_does_not_fit_is_named_with_its_place(add, corners, place, reason):
    assembly = Assembly()
    with pytest.raises(FormatError) as caught:
        assembly.add_line(run(*corners)) if add == "line" else assembly.add_polygon([SQUARE, run(*corners)])
    assert (caught.value.place, caught.value.reason) == (place, reason)


def test_a_message_stays_short():
    far = mpz(10) ** 5000
    with pytest.raises(FormatError) as caught:
        Assembly().add_polygon([run((far, 0), (1, far), (far, far))])
    assert len(str(caught.value)) < 250


def test_nothing_is_no_pslg():
    with pytest.raises(FormatError, match="there is no geometry in it"):
        Assembly().pslg()
