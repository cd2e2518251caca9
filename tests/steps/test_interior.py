"""Triangulated trapezoids: T-vertices are absorbed, wedges are cut off, every trapezoid is tiled."""

from dataclasses import replace
from fractions import Fraction

import families
import pytest
from constructions import face_feature_squared, graph, point, points_of, rings_on_levels, run, untiled
from gmpy2 import mpq

from exactmesh.api import mesh
from exactmesh.steps.constants import FEATURE_SQUARED
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.patch_check import check_interior_tiling
from exactmesh.steps.trapezoidation import trapezoidate

NAMES = [*sorted(families.ALL_SMALL | families.SMALL_PSLGS), "hall"]
# A ledge on level 1 between a long wedge below it and a room on its right.
LEDGE = [(40, 0), (60, 0), (60, 5), (30, 5), (30, 1), (20, 1), (10, 1), (0, 1)]
# A nearly flat band whose whole top lies above the wedge, the corner at its end as well.
BAND = [(40, 0), (42, 0), (2, 1), (1, 1), (0, 1)]
VIEWS = [(1, 1), (-1, 1), (1, -1), (-1, -1)]


def made(*rings):
    """Return offset, trapezoidation, points and the patch of rings on levels."""
    q = rings_on_levels(*rings)
    chords = trapezoidate(q)
    points = points_of(q, chords)
    patch = triangulate_interior(q, chords, points)
    return q, chords, [*points, *patch.points], patch


def seen(ring, view):
    """Return the ring seen from another side, counter-clockwise still."""
    sx, sy = view
    turned = [(sx * x, sy * y) for x, y in ring]
    return turned if sx * sy > 0 else turned[::-1]


# --- hand cases ---


def test_a_rectangle_gets_a_diagonal():
    _, _, _, patch = made([(0, 0), (5, 0), (5, 3), (0, 3)])
    assert len(patch.faces) == 2 and patch.points == () and patch.on_edge == ()


def test_a_trapezoid_with_a_t_vertex_is_one_fan_or_two():
    q, chords, points, patch = made([(0, 0), (9, 0), (9, 9), (5, 9), (4, 4), (3, 9), (0, 9)])
    assert check_interior_tiling(q, chords, patch, points).holds
    # The tip of the tooth is a vertex of the chord, and of some face below it.
    assert any(104 in face for face in patch.faces if any(v in face for v in (100, 101)))


@pytest.mark.parametrize("view", VIEWS)
def test_t_vertices_over_a_leg_are_dropped_onto_it(view):
    q, chords, points, patch = made(seen(LEDGE, view))
    assert check_interior_tiling(q, chords, patch, points).holds
    ledge = sorted((points[100 + k].x, 100 + k) for k in range(8) if q.level[k] == view[1])
    feet = sorted((points[v].x, v) for _, v in patch.on_edge)
    # X = 2 g before the lower end of the leg at 40: the T-vertices at 10, 20 and 30, straight below.
    assert [x for x, _ in feet] == sorted(view[0] * x for x in (10, 20, 30))
    assert {x for x, _ in feet} <= {x for x, _ in ledge}
    (leg,) = {edge for edge, _ in patch.on_edge}
    assert {q.x[leg], q.x[q.successors()[leg]]} == {view[0] * 0, view[0] * 40}


@pytest.mark.parametrize("view", VIEWS)
def test_the_corner_at_the_end_is_dropped_as_well(view):
    q, chords, points, patch = made(seen(BAND, view))
    assert check_interior_tiling(q, chords, patch, points).holds
    # Seen from the other leg, the lower left corner is such an end as well.
    assert sorted(points[v].x for _, v in patch.on_edge) == sorted(view[0] * x for x in (1, 2, 40))


@pytest.mark.parametrize("view", VIEWS)
def test_without_t_vertices_there_are_no_wedges(view):
    q, chords, points, patch = made(seen([(40, 0), (42, 0), (2, 1), (0, 1)], view))
    assert patch.on_edge == () and check_interior_tiling(q, chords, patch, points).holds


def test_a_t_vertex_near_the_end_of_the_leg_stays():
    # Less than X = 2 g = 0.464 before the lower end of the leg.
    ring = [(4, 0), (9, 0), (9, 5), ("39/10", 5), ("39/10", 1), (0, 1)]
    q, chords, points, patch = made([(mpq(x), y) for x, y in ring])
    assert patch.on_edge == () and check_interior_tiling(q, chords, patch, points).holds


def test_wedges_on_both_sides():
    ring = [(40, 0), (60, 0), (100, 1), (70, 1), (70, 5), (30, 5), (30, 1), (0, 1)]
    q, chords, points, patch = made(ring)
    assert sorted(points[v].x for _, v in patch.on_edge) == [30, 70]
    assert check_interior_tiling(q, chords, patch, points).holds


def test_opposite_t_vertices_are_joined():
    # Tips from above at 2, 3 and 9, from below at 5 and 6; the runs close at 5 and at 9.
    upper = [(20, 9), (9, 1), (8, 9), (3, 1), ("5/2", 9), (2, 1), (0, 9)]
    lower = [(0, -8), (5, 0), ("11/2", -8), (6, 0), (20, -8)]
    q, chords, points, patch = made([(mpq(x), y) for x, y in [*lower, *upper]])
    assert check_interior_tiling(q, chords, patch, points).holds
    number = {(int(x), level): 100 + k for k, (x, level) in enumerate(zip(q.x, q.level, strict=True))}
    sides = {(face[i - 1], face[i]) for face in patch.faces for i in range(len(face))}
    assert (number[3, 1], number[5, 0]) in sides and (number[6, 0], number[9, 1]) in sides


def test_at_one_abscissa_the_upper_t_vertex_comes_first():
    ring = [(0, -8), (4, 0), (5, -8), (9, -8), (9, 9), (5, 9), (4, 1), (3, 9), (0, 9)]
    q, chords, points, patch = made(ring)
    assert check_interior_tiling(q, chords, patch, points).holds
    sides = {frozenset((face[i - 1], face[i])) for face in patch.faces for i in range(len(face))}
    assert frozenset((101, 106)) in sides


# --- the builder ---


def test_triangles_are_turned_counter_clockwise():
    builder = PatchBuilder([point(0, 0), point(1, 0), point(0, 1)])
    builder.add_triangle(0, 1, 2)
    builder.add_triangle(0, 2, 1)
    assert builder.finished().faces == ((0, 1, 2), (0, 1, 2))


def test_a_t_side_of_one_vertex_is_a_triangle():
    builder = PatchBuilder([point(0, 0), point(1, 0), point(0, 1)])
    builder.add_one_sided([0], 2, 1)
    assert builder.finished().faces == ((0, 1, 2),)


def test_new_vertices_are_numbered_after_the_given_ones():
    builder = PatchBuilder([point(0, 0), point(1, 0)])
    assert (builder.add(point(5, 5)), builder.add(point(6, 6))) == (2, 3)
    patch = builder.finished()
    assert patch.first == 2 and patch.points == (point(5, 5), point(6, 6))


def test_the_given_points_are_not_changed():
    points = [point(0, 0), point(1, 0), point(0, 1)]
    PatchBuilder(points).add(point(9, 9))
    assert len(points) == 3


# --- runs ---


@pytest.mark.parametrize("name", NAMES)
def test_every_trapezoid_is_tiled_by_its_own_faces(name):
    construction = run(name).construction
    q, chords, points = construction.offset, construction.trapezoidation, construction.points
    for z in chords.trapezoids:
        alone = triangulate_interior(q, replace(chords, trapezoids=(z,)), points[: construction.interior.first])
        here = [*points[: construction.interior.first], *alone.points]

        def on_leg(edge, low, high, here=here, alone=alone):
            feet = [v for e, v in alone.on_edge if e == edge]
            return [v for v in sorted(feet, key=lambda v: here[v].y)
                    if min(here[low].y, here[high].y) < here[v].y < max(here[low].y, here[high].y)]

        outline = [z.bl, *z.bottom, z.br, *on_leg(z.right, z.br, z.tr), z.tr, *z.top[::-1], z.tl,
                   *on_leg(z.left, z.bl, z.tl)[::-1]]
        outline = [v for i, v in enumerate(outline) if v != outline[i - 1]]
        assert untiled(here, outline, alone.faces) == []


@pytest.mark.parametrize("name", NAMES)
def test_every_face_keeps_a_fifth_of_a_level(name):
    construction = run(name).construction
    for face in construction.interior.faces:
        assert face_feature_squared(construction.points, face) >= FEATURE_SQUARED


def test_q_and_the_chord_ends_stay_as_they_are():
    construction = run("turned comb").construction
    assert construction.interior.first == construction.trapezoidation.first + len(construction.trapezoidation.points)


# --- cases found by search: numbered, kept ---


def spike_with_a_ledge(length, slope, ledge=1):
    """Return a long spike whose floor has a ledge of length 1 near the tip, with a drop behind it."""
    slope = Fraction(slope)
    return graph([(-length, 0), (-3, -3 * slope), (ledge - 3, -3 * slope), (ledge - 3, -8), (9, -8), (9, 6),
                  (3, 2 + slope * length)])


@pytest.mark.parametrize("turn", [0, "1/2000", "-1/1000", "1/500"])
@pytest.mark.parametrize("length, slope", [(100, "1/1000"), (300, "1/1000"), (400, "3/1000"), (1000, "1/10000")])
def test_1_a_ledge_in_a_long_spike(length, slope, turn):
    # Without the rule that drops the corner as well, the degradation is 300 and grows with the length.
    assert mesh(families.rotated(spike_with_a_ledge(length, slope), mpq(turn))).holds


@pytest.mark.parametrize("turn", [0, "1/300", "-1/170", "1/40", "-1/85"])
@pytest.mark.parametrize("length", [20, 85, 200])
def test_2_a_spike_next_to_a_reflex_vertex(length, turn):
    # Its corner can lie on the wrong side of the line of its offset edge.
    pslg = graph([(0, 0), (2, 1), (length, "3/2"), (3, 3), (3, 9), (-1, 9), (-1, 0)])
    assert mesh(families.rotated(pslg, mpq(turn))).holds
