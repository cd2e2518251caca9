"""The paper's P2 and P3 at every kind of corner by hand, their laws, and their equations by a second sign procedure."""

from fractions import Fraction
from itertools import chain

import families
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.claims.run import Run
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.separation import Expr
from exactmesh.paper import PaperOptions, simple_polygon
from exactmesh.steps.offset_curve import offset_curve
from exactmesh.steps.records import RealPoint

few = settings(max_examples=20, deadline=None, derandomize=True)
polygons = st.builds(families.random_simple_polygon, st.integers(4, 12), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))
EVERY = families.ring([(0, 0), (6, 0), (12, 0), (12, 8), (9, 8), (8, 3), (7, 8), (4, 7), (0, 8)])
QUARTER = mpq(1, 4)


def curve_of(pslg, **options):
    return Run(pslg, "paper", options=PaperOptions(**options)).curve


def by_vertex(pslg, **options):
    """Return the record of each corner by the vertex of P it belongs to."""
    run = Run(pslg, "paper", options=PaperOptions(**options))
    origin = run.subdivision.half_edges.origin
    return {origin[c.corner]: c for c in chain.from_iterable(run.curve.rings)}


def place(x, y):
    return RealPoint(Real(x), Real(y))


def test_the_unit_square():
    corners = by_vertex(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]))
    low, high = QUARTER, 1 - QUARTER
    assert [corners[v].vertices for v in range(4)] == [
        (place(low, low),), (place(high, low),), (place(high, high),), (place(low, high),)]
    assert all(c.kind == "convex" and c.arc is None for c in corners.values())


def test_every_kind_of_corner_is_named():
    kinds = {v: c.kind for v, c in by_vertex(EVERY).items()}
    assert kinds == {0: "convex", 1: "flat", 2: "convex", 3: "convex", 4: "convex", 5: "chords", 6: "convex",
                     7: "prolonged", 8: "convex"}
    flat = by_vertex(EVERY)[1].vertices
    assert flat == (place(6, sqrt(curve_of(EVERY).mfs_squared) / 4),)


def test_an_arc_of_90_degrees_follows_the_option():
    ell = families.l_shape(4)
    arc = (place(2, 1 + QUARTER), place(2 + QUARTER, 1))
    diagonal = sqrt(2) / 8
    chords, prolonged = by_vertex(ell)[1], by_vertex(ell, right_angle="prolonged")[1]
    assert chords.kind == "chords" and chords.arc == arc
    assert chords.vertices == (arc[0], place(2 + diagonal, 1 + diagonal), arc[1])
    assert prolonged.kind == "prolonged" and prolonged.arc == arc
    assert prolonged.vertices == (place(2 + QUARTER, 1 + QUARTER),)


def test_the_middle_of_an_arc_is_straight_ahead():
    # A wedge that points down, symmetric about the vertical.
    wedge = families.ring([(-40, -40), (40, -40), (40, 40), (4, 7), (0, 0), (-4, 7), (-40, 40)])
    tip = by_vertex(wedge)[4]
    assert tip.kind == "chords" and tip.vertices[1] == place(0, -sqrt(curve_of(wedge).mfs_squared) / 4)


def test_half_a_circle_at_a_dangling_end():
    # The construction refuses such inputs; the step itself treats the end as an arc over 90 degrees.
    box = families.ring([(0, 0), (8, 0), (8, 8), (0, 8), (4, 0), (4, 4)])
    pslg = type(box)(box.vertices, ((0, 4), (4, 1), (1, 2), (2, 3), (3, 0), (4, 5)))
    run = Run(pslg, "paper")
    half_edges = run.subdivision.half_edges
    walk = run.subdivision.domain[0].walks
    shape = simple_polygon(Run(families.ring([(0, 0), (8, 0), (8, 8), (0, 8)]), "paper").subdivision)
    shape = type(shape)(mpq(1), pslg.vertices, half_edges.origin, (walk,), ((),), ())
    corners = [c for c in chain.from_iterable(offset_curve(shape, mpq(16)).rings) if half_edges.origin[c.corner] == 5]
    assert [c.vertices for c in corners] == [(place(3, 4), place(4, 5), place(5, 4))]


@few
@given(polygons)
def test_vertices_of_p3_solve_their_equations_by_a_second_sign_procedure(pslg):
    run = Run(pslg, "paper")
    points, half_edges = pslg.vertices, run.subdivision.half_edges
    m = run.mfs.squared
    for ring in run.curve.rings:
        for before, corner in zip((ring[-1], *ring[:-1]), ring, strict=True):
            u, v = half_edges.origin[before.corner], half_edges.origin[corner.corner]
            w = half_edges.origin[corner.corner ^ 1]
            edges = [(points[v].x - points[u].x, points[v].y - points[u].y),
                     (points[w].x - points[v].x, points[w].y - points[v].y)]
            places = [[(c - o).fold(Expr, Expr.sqrt) for c, o in zip(p, points[v], strict=True)]
                      for p in corner.vertices]
            on_both = [places[0], places[-1]]
            for (dx, dy), (x, y) in zip(edges, on_both, strict=True):
                area = dx * y - dy * x
                assert (16 * area * area - m * (dx * dx + dy * dy)).sign() == 0 and area.sign() > 0
            if corner.kind == "chords":
                a, middle, b = places
                assert (16 * (middle[0] * middle[0] + middle[1] * middle[1]) - m).sign() == 0
                # As near to one end as to the other, up to a hair: the two ends have roots of their own.
                gap = middle[0] * (a[0] - b[0]) + middle[1] * (a[1] - b[1])
                hair = m / 2**200
                assert (gap - hair).sign() < 0 < (gap + hair).sign()


def vertices(pslg, **options):
    """Return the vertices of P3 as a set."""
    return {v for ring in curve_of(pslg, **options).rings for c in ring for v in c.vertices}


@few
@given(polygons, st.integers(-50, 50), st.fractions(-9, 9, max_denominator=20))
def test_translation(pslg, dx, dy):
    moved = vertices(families.translated(pslg, dx, dy))
    assert moved == {place(v.x + dx, v.y + mpq(dy)) for v in vertices(pslg)}


@few
@given(polygons, st.fractions(Fraction(1, 9), 9, max_denominator=20))
def test_scaling(pslg, factor):
    factor = mpq(factor)
    assert vertices(families.scaled(pslg, factor)) == {place(v.x * factor, v.y * factor) for v in vertices(pslg)}


@few
@given(polygons)
def test_reflection_reversal_and_start(pslg):
    wanted = vertices(pslg)
    assert vertices(families.mirrored(pslg)) == {place(-v.x, v.y) for v in wanted}
    assert vertices(families.reversed_orientation(pslg)) == vertices(families.with_start(pslg, 2)) == wanted


@few
@given(polygons)
def test_turning_by_the_angle_of_3_4_5(pslg):
    # tan of half the angle is 1/3: cosine 4/5, sine 3/5.
    turned = vertices(families.rotated(pslg, mpq(1, 3)))
    assert turned == {place((4 * v.x - 3 * v.y) / 5, (3 * v.x + 4 * v.y) / 5) for v in vertices(pslg)}


@pytest.mark.parametrize("name", ["comb 12 long floor", "star 12", "reflex notch 1e-6", "sliver with bends"])
def test_flat_vertices_change_nothing_but_themselves(name):
    # One vertex in the middle of each edge; where that changes no minimum feature size, P3 has the same corners.
    pslg = families.ALL_SMALL[name]
    cut = families.with_collinear_vertices(pslg, 1)
    if curve_of(cut).mfs_squared == curve_of(pslg).mfs_squared:
        assert vertices(pslg) < vertices(cut)
