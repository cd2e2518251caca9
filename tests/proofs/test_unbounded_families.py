"""The families that proofs speak of in a parameter are what the construction makes, for many values of it."""

import families
import pytest
from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.paper import PaperOptions
from exactmesh.planar.pslg import polygon
from exactmesh.steps.offset_curve import RightAngle
from exactmesh.steps.reading import ReadingName


@pytest.mark.parametrize("length", [6, 7, mpq(31, 4), 44, 101, 1000])
@pytest.mark.parametrize(("reading", "height"), [("octagon", mpq(10, 21)), ("tube", mpq(9, 17))])
@pytest.mark.parametrize(("right_angle", "first"), [("chords", mpq(2)), ("prolonged", mpq(9, 4))])
def test_the_trapezoid_of_the_p6_gap(length: mpq, reading: ReadingName, height: mpq, right_angle: RightAngle,
                                     first: mpq) -> None:
    pslg = families.l_shape(length)
    nearest = minimum_feature_size(pslg)
    assert nearest is not None and nearest.squared == 1
    made = Run(pslg, "paper", "nonproper", PaperOptions(reading=reading, right_angle=right_angle)).paper
    z, = (z for z in made.trapezoidation.trapezoids if z.bottom or z.top)
    bl, br, tr, tl = (made.points[v] for v in (z.bl, z.br, z.tr, z.tl))
    assert [made.points[v].x for v in z.bottom] == [first] and not z.top
    assert (bl.x, br.x, tr.x, tl.x) == (mpq(1, 4), length - mpq(1, 4), length - mpq(1, 4), mpq(1, 4))
    assert bl.y == br.y and tr.y == tl.y == bl.y + height
    face, = (face for face in made.interior.faces if len(face) > 3)
    apex, = {made.points[v] for v in face} - {bl, br, made.points[z.bottom[0]]}
    assert (apex.x, apex.y) == (length / mpq(2), bl.y + height / 2)
    # The T-vertex against the line from the corner to the apex: below (18/17)/(L - 1/2), as proved.
    across = (first - mpq(1, 4)) * height / 2
    spoke_squared = (apex.x - bl.x) ** 2 + (height / 2) ** 2
    assert across**2 / spoke_squared < (mpq(18, 17) / (length - mpq(1, 2))) ** 2


@pytest.mark.parametrize("height", [100, 1000, 2**20, 2**60])
@pytest.mark.parametrize("reading", ["octagon", "tube"])
def test_one_far_vertex_on_the_rectangle_of_a_long_triangle(height: int, reading: ReadingName) -> None:
    triangle = polygon([(0, 0), (4, height), (0, 2 * height)])
    made = Run(triangle, "paper", "nonproper", PaperOptions(reading=reading)).paper
    rectangle, = made.tube.rectangles
    start, inner, end = rectangle.grid
    assert start == 0 and height <= inner <= end - height
    assert made.mfs_squared == 16
    # All nodes are joined to the corner below b: one for two octaves, at least.
    assert 4 ** sum(rectangle.b_below in face for face in made.tube.patch.faces) > height
