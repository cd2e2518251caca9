"""Hole points, against areas that Shapely adds up."""

from collections import Counter

import pytest
import shapely
from gmpy2 import mpq
from hypothesis import example, given
from hypothesis import strategies as st

from exactmesh.geometry.point import Point
from exactmesh.io.rings import Assembly, Run
from exactmesh.planar.faces import doubled_walk_area, subdivide
from exactmesh.planar.pslg import Pslg


def run(corners, linear=(1, 0, 0, 1)):
    a, b, c, d = linear
    return Run([Point(mpq(a * x + b * y), mpq(c * x + d * y)) for x, y in corners], str)


def box(x0, y0, x1, y1):
    return run([(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)])


def pslg_of(*polygons, lines=(), points=()):
    assembly = Assembly()
    for polygon in polygons:
        assembly.add_polygon(polygon)
    for line in lines:
        assembly.add_line(line)
    for x, y in points:
        assembly.add_point(Point(mpq(x), mpq(y)))
    return assembly.pslg()


def domain_area(pslg):
    """Return the area to be meshed; every hole point is in a bounded face, or this raises."""
    subdivision = subdivide(pslg)
    doubled = sum(doubled_walk_area(pslg, subdivision.half_edges, walk)
                  for face in subdivision.domain for walk in face.walks)
    return doubled / 2


OUTER, INNER = box(0, 0, 10, 10), box(2, 2, 8, 8)


@pytest.mark.parametrize("pslg, area, holes", [
    (pslg_of([OUTER]), 100, 0),
    (pslg_of([OUTER, INNER]), 64, 1),
    (pslg_of([OUTER, INNER], [INNER]), 100, 0),
    (pslg_of([OUTER, INNER], [box(3, 3, 7, 7)]), 80, 1),
    (pslg_of([OUTER, INNER], [box(3, 3, 7, 7), box(4, 4, 6, 6)]), 76, 2),
    # An island from wall to wall leaves two parts of the hole.
    (pslg_of([OUTER, run([(2, 2), (4, 2), (6, 2), (8, 2), (8, 8), (6, 8), (4, 8), (2, 8), (2, 2)])],
             [box(4, 2, 6, 8)]), 76, 2),
    # So does a line, and the vertical line through a hole point meets isolated points.
    (pslg_of([OUTER, INNER], lines=[run([(2, 2), (8, 8)])]), 64, 2),
    (pslg_of([OUTER, INNER], points=[(5, y) for y in (1, 3, 4, 5, 6, 7)]), 64, 1),
    # Two polygons around what neither covers.
    (pslg_of([run([(0, 0), (9, 0), (6, 3), (3, 3), (3, 6), (0, 9), (0, 0)])],
             [run([(9, 0), (9, 9), (0, 9), (3, 6), (6, 6), (6, 3), (9, 0)])]), 72, 1),
    # Lines alone enclose a domain; beside a polygon they do not.
    (pslg_of(lines=[OUTER]), 100, 0),
    (pslg_of([INNER], lines=[OUTER]), 36, 1),
    # A dangling line inside, and one outside.
    (pslg_of([OUTER, INNER], lines=[run([(0, 0), (1, 1)]), run([(5, 5), (6, 6)]), run([(0, 0), (-1, 1)])]),
     64, 1),
    # A polygon given twice, and an interior ring that runs along the exterior one.
    (pslg_of([OUTER], [OUTER]), 100, 0),
    (pslg_of([run([(0, 0), (2, 0), (10, 0), (10, 10), (0, 10), (0, 0)]),
              run([(0, 0), (2, 0), (2, 2), (0, 0)])]), 98, 1),
    # A ring with a spike, there and back.
    (pslg_of([run([(0, 0), (4, 0), (4, 4), (6, 6), (4, 4), (0, 4), (0, 0)])]), 16, 0),
])
def test_areas_by_hand(pslg, area, holes):
    assert domain_area(pslg) == area
    assert len(pslg.holes) == holes


def test_a_graph_that_is_not_planar_gets_no_hole_points():
    assert pslg_of([OUTER, box(5, 5, 15, 15)]).holes == ()


@given(st.lists(st.lists(st.integers(0, 3), min_size=5, max_size=5), min_size=5, max_size=5),
       st.sampled_from([(1, 0, 0, 1), (3, 1, -2, 5), (0, 1, 1, 0)]))
@example([[1] * 5, [1, 0, 1, 0, 1], [1, 1, 2, 1, 1], [1, 0, 0, 2, 1], [1] * 5], (3, 1, -2, 5))
@example([[1, 2, 1, 2, 1], [2, 1, 2, 1, 2]] * 2 + [[0] * 5], (1, 0, 0, 1))
def test_the_domain_is_the_union_of_polygons_of_cells(cells, linear):
    """Cells of one number make polygons, 0 makes none; they touch and share borders in every way."""
    assembly = Assembly()
    counts = Counter(label for row in cells for label in row if label)
    for label in counts:
        squares = [shapely.box(x, y, x + 1, y + 1)
                   for y, row in enumerate(cells) for x, cell in enumerate(row) if cell == label]
        # A vertex at every whole point, so that no vertex of one polygon lies within an edge of another.
        union = shapely.segmentize(shapely.union_all(squares), 1)
        for polygon in getattr(union, "geoms", [union]):
            rings = [polygon.exterior, *polygon.interiors]
            assembly.add_polygon([run([(int(x), int(y)) for x, y in ring.coords], linear) for ring in rings])
    if counts:
        a, b, c, d = linear
        assert domain_area(assembly.pslg()) == sum(counts.values()) * abs(a * d - b * c)


@given(st.permutations(range(3)), st.booleans())
def test_the_order_of_polygons_and_the_sense_of_rings_do_not_matter(order, backwards):
    polygons = [[OUTER, INNER], [box(3, 3, 7, 7), box(4, 4, 6, 6)], [box(20, 0, 30, 10)]]
    if backwards:
        polygons = [[Run(ring.points[::-1], str) for ring in polygon] for polygon in polygons]
    assert domain_area(pslg_of(*(polygons[i] for i in order))) == 64 + 12 + 100


def test_the_record_is_the_same_but_for_its_holes():
    pslg = pslg_of([OUTER, INNER])
    assert pslg == Pslg(pslg.vertices, ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4)),
                        pslg.holes)
