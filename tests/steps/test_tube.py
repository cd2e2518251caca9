"""The Tube between P and Q: a fan a cap, a one-sided quadrilateral an edge."""

import random
from collections import Counter

import families
import oracle
import pytest
from constructions import cycle_area, face_feature_squared, graph, run, unit_shape, untiled

from exactmesh.steps.constants import FEATURE_SQUARED
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.offset import offset
from exactmesh.steps.patch_check import check_tube_tiling, recorded_on_edges
from exactmesh.steps.trapezoidation import trapezoidate
from exactmesh.steps.tube import triangulate_tube

NAMES = [*sorted(families.ALL_SMALL | families.SMALL_PSLGS), "hall"]
BOX = [(0, 0), (10, 0), (10, 10), (0, 10)]


def tube_of(pslg):
    """Return shape, offset, points and Tube; no vertices are recorded on edges of Q."""
    shape = unit_shape(pslg)
    q = offset(shape)
    points = [*shape.points, *q.points]
    return shape, q, points, triangulate_tube(shape, q, [], points)


def test_the_tube_of_a_square():
    _, _, points, tube = tube_of(graph(BOX))
    assert len(tube.faces) == 8 and tube.points == () and tube.on_edge == ()
    for k in range(4):
        strip = [face for face in tube.faces if set(face) <= {k, (k + 1) % 4, 4 + k, 4 + (k + 1) % 4}]
        assert untiled(points, [k, (k + 1) % 4, 4 + (k + 1) % 4, 4 + k], strip) == []


def test_the_cap_of_a_reflex_corner_is_a_fan_of_it():
    _, q, points, tube = tube_of(graph([(0, 0), (10, 0), (10, 5), (5, 5), (5, 10), (0, 10)]))
    cap = [k for k, corner in enumerate(q.corner) if corner == 6]
    fan = [face for face in tube.faces if set(face) == {3, *(6 + k for k in cap)}]
    assert len(fan) == 1 and untiled(points, fan[0], fan) == []


def test_an_isolated_vertex_has_eight_triangles():
    _, q, points, tube = tube_of(graph([*BOX, (3, 6)], graph(BOX).edges))
    around = [face for face in tube.faces if 4 in face]
    assert len(around) == 8
    ring = [k for k, corner in enumerate(q.corner) if corner == -5]
    assert untiled(points, [q.first + k for k in reversed(ring)], around) == []


def test_the_end_of_a_slit_is_a_fan():
    pslg = graph([*BOX, (4, 5), (6, 5)], [*graph(BOX).edges, (4, 5)])
    shape, q, points, tube = tube_of(pslg)
    assert [len(set(face) & {4, 5}) for face in tube.faces].count(2) == 2
    chords = trapezoidate(q)
    everything = [*points, *chords.points]
    interior = triangulate_interior(q, chords, everything)
    everything += interior.points
    tube = triangulate_tube(shape, q, recorded_on_edges(chords, interior), everything)
    assert check_tube_tiling(shape, q, chords, interior, tube, [*everything, *tube.points]).holds


@pytest.mark.parametrize("name", NAMES)
def test_the_tube_fills_what_lies_between_p_and_q(name):
    made = run(name).construction
    q, shape = made.offset, made.shape
    assert check_tube_tiling(shape, q, made.trapezoidation, made.interior, made.tube, made.points).holds
    of_p = sum(cycle_area(shape.points, [shape.origin[h] for h in walk]) for face in shape.faces for walk in face)
    of_q = sum(oracle.polygon_area(q.points[start:end]) for start, end in q.rings)
    # Walks and rings around what lies inside are clockwise and count negative.
    assert sum(cycle_area(made.points, face) for face in made.tube.faces) == of_p - of_q


@pytest.mark.parametrize("name", NAMES)
def test_each_cap_edge_has_one_triangle_with_its_corner(name):
    made = run(name).construction
    q, faces = made.offset, set(map(frozenset, made.tube.faces))
    for k, (source, corner, end) in enumerate(zip(q.source, q.corner, q.successors(), strict=True)):
        if source < 0:
            apex = made.shape.origin[corner] if corner >= 0 else -1 - corner
            assert frozenset((apex, q.first + k, q.first + end)) in faces


@pytest.mark.parametrize("name", NAMES)
def test_every_face_keeps_a_fifth_of_a_level(name):
    made = run(name).construction
    for face in made.tube.faces:
        assert face_feature_squared(made.points, face) >= FEATURE_SQUARED


@pytest.mark.parametrize("name", ["hall", "turned comb", "random pslg 1"])
def test_the_order_of_the_records_does_not_matter(name):
    made = run(name).construction
    recorded = recorded_on_edges(made.trapezoidation, made.interior)
    random.Random(5).shuffle(recorded)
    assert triangulate_tube(made.shape, made.offset, recorded, made.points[: made.tube.first]) == made.tube


@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_put_on_p_or_q(name):
    made = run(name).construction
    sides = Counter((face[i - 1], face[i]) for face in made.tube.faces for i in range(len(face)))
    for walk in (walk for face in made.shape.faces for walk in face):
        for h in walk:
            assert sides[made.shape.origin[h], made.shape.origin[h ^ 1]] == 1
    assert made.tube.on_edge == ()
