"""Cutting edges below vertices: still a Delaunay triangulation of the same domain, every cut exactly on its edge."""

from fractions import Fraction
from itertools import pairwise

import constructions
import families
import oracle
import pytest

from exactmesh.geometry.incircle import in_circle
from exactmesh.geometry.predicates import is_between, orientation
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import domain_of
from exactmesh.planar.projection import Projected, project
from exactmesh.planar.pslg import Pslg

INPUTS = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": constructions.HALL}


def projected(pslg: Pslg, shortest: float) -> Projected:
    return project(pslg.vertices, constrained_delaunay(domain_of(pslg)), shortest)


@pytest.mark.parametrize("name", INPUTS)
@pytest.mark.parametrize("shortest", [0.01, 0.3])
def test_the_domain_and_its_edges_stay(name: str, shortest: float) -> None:
    pslg = INPUTS[name]
    cut = projected(pslg, shortest)
    points, found = cut.points, cut.triangulation
    assert points[: len(pslg.vertices)] == pslg.vertices
    assert all(orientation(points[u], points[v], points[w]) == 1 for u, v, w in found.triangles)
    area = sum((oracle.polygon_area([points[v] for v in triangle]) for triangle in found.triangles), Fraction(0))
    assert area == oracle.domain_area(pslg.vertices, pslg.edges, pslg.holes)
    for (u, v), w in found.apex.items():
        if (u, v) in found.constrained:
            a, b = cut.edge_of.get((u, v), (u, v))
            assert (a, b) in pslg.edges or (b, a) in pslg.edges
            for p in (points[u], points[v]):
                assert orientation(points[a], points[b], p) == 0 and is_between(points[a], p, points[b])
        else:
            assert in_circle(points[u], points[v], points[w], points[found.apex[v, u]]) <= 0
    assert {(v, u) for u, v in found.constrained} == found.constrained


def test_a_floor_below_many_tips_is_cut_below_them() -> None:
    comb = families.comb(20)
    cut = projected(comb, 0.01)
    floor = sorted(p.x for p in cut.points if p.y == 0)
    tips = sorted(p.x for p in comb.vertices if p.y == 1)
    assert len(floor) == len(tips) + 2
    assert all(abs(x - tip) * 10**9 < 1 for x, tip in zip(floor[1:-1], tips, strict=True))
    assert all(q - p > 1 for p, q in pairwise(floor))


def test_short_sides_are_not_cut() -> None:
    comb = families.comb(20)
    whole = constrained_delaunay(domain_of(comb))
    cut = project(comb.vertices, whole, 3.0)
    assert (cut.points, cut.edge_of, cut.triangulation) == (comb.vertices, {}, whole)
