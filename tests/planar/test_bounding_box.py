"""The bounding box: the outside becomes a face, and nothing else changes."""

import families
import pytest
from gmpy2 import mpq

from exactmesh import InputError, Pslg, mesh, polygon, verify
from exactmesh.planar.bounding_box import with_bounding_box
from exactmesh.planar.faces import domain_of


def test_the_outside_becomes_a_face():
    square = polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
    boxed = with_bounding_box(square, mpq(3, 2))
    assert boxed.vertices[:4] == square.vertices and boxed.edges[:4] == square.edges
    assert {(str(p.x), str(p.y)) for p in boxed.vertices[4:]} == {
        ("-3/2", "-3/2"), ("11/2", "-3/2"), ("11/2", "11/2"), ("-3/2", "11/2")}
    assert len(domain_of(boxed).domain) == 2


@pytest.mark.parametrize("name", sorted(families.SMALL_PSLGS))
def test_the_outside_is_meshed_within_the_bound(name):
    boxed = with_bounding_box(families.SMALL_PSLGS[name], mpq(5))
    result = mesh(boxed)
    assert result.holds
    assert verify(boxed, result.mesh).degradation_squared <= mpq(108, 5) ** 2


def test_holes_stay_empty():
    ring = polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
    hollow = Pslg(ring.vertices, ring.edges, (type(ring.vertices[0])(mpq(2), mpq(2)),))
    assert len(domain_of(with_bounding_box(hollow, mpq(1))).domain) == 1


@pytest.mark.parametrize("margin", [0, -1])
def test_a_margin_must_be_positive(margin):
    with pytest.raises(InputError, match="must be positive"):
        with_bounding_box(polygon([(0, 0), (4, 0), (4, 4)]), mpq(margin))


def test_nothing_has_no_box():
    with pytest.raises(InputError, match="nothing"):
        with_bounding_box(Pslg((), ()), mpq(1))
