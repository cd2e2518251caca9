"""Least distances between algebraic places: by hand, against the rational oracle and a second sign procedure."""

from fractions import Fraction

import families
import oracle
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.measure import algebraic_mfs as module
from exactmesh.measure.algebraic_mfs import Labelled, algebraic_mfs, approximated, least_between, real_place
from exactmesh.numbers.algebraic import Real, sqrt
from exactmesh.numbers.separation import Expr

few = settings(max_examples=25, deadline=None, derandomize=True)
HAIR = mpq(1, 2**200)


def ring_edges(count):
    return [(i, (i + 1) % count) for i in range(count)]


def turned(points):
    """Return rational points turned by 45 degrees: algebraic places with the same distances."""
    c = sqrt(mpq(1, 2))
    return [(c * (p.x - p.y), c * (p.x + p.y)) for p in points]


polygons = st.builds(families.random_simple_polygon, st.integers(3, 14), st.integers(0, 10**6),
                     st.sampled_from(sorted(families.KINDS)))


@few
@given(polygons.filter(lambda p: len(p.vertices) > 3))
def test_turning_by_45_degrees_keeps_the_rational_mfs(pslg):
    wanted = oracle.mfs_squared(pslg.vertices, pslg.edges)
    found = algebraic_mfs(turned(pslg.vertices), pslg.edges)
    assert found is not None and found.squared == wanted and found.holds


@pytest.mark.parametrize("relation, bound, holds", [
    (">=", mpq(1), True), (">", mpq(1), False), (">=", 1 + mpq(1, 2**300), False), (">", 1 - mpq(1, 2**300), True)])
def test_a_bound_that_is_met_exactly_or_missed_by_a_hair(relation, bound, holds):
    square = turned(families.ring([(0, 0), (1, 0), (1, 1), (0, 1)]).vertices)
    found = algebraic_mfs(square, ring_edges(4), relation, bound)
    assert found is not None and found.squared == 1 and found.holds is holds


@pytest.mark.parametrize("hair", [0, 60, 90, 200, 400])
def test_the_worst_of_two_pairs_a_hair_apart(hair):
    # Two thin triangles: heights 1 and 1 - 2^-hair.
    less = 1 - mpq(1, 2**hair) if hair else mpq(1)
    points = [(0, 0), (4, 0), (2, 1), (0, 9), (4, 9), (2, 9 + less)]
    places = turned(families.ring(points).vertices)
    edges = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)]
    found = algebraic_mfs(places, edges, ">=", mpq(1))
    assert found is not None and found.holds is (hair == 0)
    # Closer than 256 bits the pairs are told apart by the bound, which the nearer one breaks.
    assert found.squared == less**2


def test_ties_beyond_the_intervals_report_the_first_pair():
    less = 1 - mpq(1, 2**400)
    places = turned(families.ring([(0, 0), (4, 0), (2, 1), (0, 9), (4, 9), (2, 9 + less)]).vertices)
    edges = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)]
    found = algebraic_mfs(places, edges)
    assert found is not None and found.holds and found.squared in (1, less**2)


@few
@given(polygons, st.integers(0, 3), st.data())
def test_labels_leave_out_exactly_the_pairs_that_share_one(pslg, modulus, data):
    points = pslg.vertices
    labels = [data.draw(st.integers(0, modulus)) for _ in points]
    edges = list(pslg.edges)
    edge_labels = [(labels[u], labels[v]) for u, v in edges]
    group = Labelled(range(len(points)), labels, edges, edge_labels)
    found = least_between([real_place(p) for p in points], [group])
    pairs = [oracle_distance(points, v, e) for v in range(len(points))
             for e, pair in zip(edges, edge_labels, strict=True) if labels[v] not in pair]
    if pairs:
        assert found is not None and found.squared == min(pairs)
    else:
        assert found is None


def oracle_distance(points, v, edge):
    p, a, b = (oracle.place(points[i]) for i in (v, *edge))
    d, q = (b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])
    t = min(max((d[0] * q[0] + d[1] * q[1]) / Fraction(d[0] ** 2 + d[1] ** 2), Fraction(0)), Fraction(1))
    return (q[0] - t * d[0]) ** 2 + (q[1] - t * d[1]) ** 2


def test_more_rows_than_a_block(monkeypatch):
    monkeypatch.setattr(module, "_ROW", 2)
    points = families.comb(5).vertices
    group = Labelled(range(len(points)), range(len(points)), ring_edges(len(points)), ring_edges(len(points)))
    found = least_between([real_place(p) for p in points], [group])
    assert found is not None and found.squared == oracle.mfs_squared(points, ring_edges(len(points)))


def test_nothing_to_compare():
    triangle = [real_place(p) for p in families.ring([(0, 0), (1, 0), (0, 1)]).vertices]
    assert least_between([], []) is None and algebraic_mfs(triangle, []) is None
    assert least_between(triangle, [Labelled([], [], [(0, 1)], [(0, 1)]), Labelled([0], [0], [], [])]) is None


@pytest.mark.parametrize("far", [0, 10**15, 10**40])
def test_approximations_are_within_2_to_the_minus_80_of_the_extent(far):
    places = [(far + sqrt(2), sqrt(3) - far), (far + sqrt(5), Real(-far)), (Real(far), sqrt(7) - far)]
    for place, p in zip(places, approximated(places), strict=True):
        assert all(abs(x - y) * 2**80 <= sqrt(7) for x, y in zip(place, p, strict=True))


def test_equal_places_have_no_extent():
    assert set(approximated([(sqrt(2), sqrt(3))] * 2)) == {(0, 0)}


@few
@given(st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=3, max_size=5, unique=True),
       st.sampled_from([2, 3, 5]))
def test_a_second_sign_procedure_agrees(pairs, n):
    places = [(x + sqrt(n) * y, (x * x + 2 + sqrt(2)).sqrt() - y) for x, y in pairs]
    found = algebraic_mfs(places, ring_edges(len(places)))
    if found is None:
        return
    if found.squared == 0:
        return
    least = found.squared.fold(Expr, Expr.sqrt)
    at = [tuple(c.fold(Expr, Expr.sqrt) for c in place) for place in places]
    values = [expr_distance(at[v], at[a], at[b]) for v in range(len(at)) for a, b in ring_edges(len(at))
              if v not in (a, b)]
    # A hair to either side, because a zero among nested roots costs the second procedure too many bits.
    assert all((value - least * (1 - HAIR)).sign() > 0 for value in values)
    assert any((value - least * (1 + HAIR)).sign() < 0 for value in values)


def expr_distance(p, a, b):
    d, q = (b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])
    along, length = d[0] * q[0] + d[1] * q[1], d[0] * d[0] + d[1] * d[1]
    if along.sign() <= 0:
        return q[0] * q[0] + q[1] * q[1]
    if (along - length).sign() >= 0:
        r = (p[0] - b[0], p[1] - b[1])
        return r[0] * r[0] + r[1] * r[1]
    area = d[0] * q[1] - d[1] * q[0]
    return area * area / length
