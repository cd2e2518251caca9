"""Layered triangulations: proper, small, and no worse than the logarithm allows."""

import random
from fractions import Fraction
from itertools import pairwise

import families
import pytest
from gmpy2 import mpq

from exactmesh import mesh, verify
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import corners_of, face_feature_squared
from exactmesh.planar.cycles import directed_edges, sides
from exactmesh.steps.frame import frame_of
from exactmesh.steps.layers import layered_candidates
from exactmesh.steps.one_sided import triangulate_one_sided

G = mpq(29, 125)


def strip(gaps, height=G):
    xs = [mpq(0)]
    for gap in gaps:
        xs.append(xs[-1] + gap)
    return [Point(x, mpq(0)) for x in xs], Point(xs[0], height), Point(xs[-1], height)


@pytest.mark.parametrize("count", [1, 2, 3, 4, 5, 7, 8, 9, 16, 17, 33, 64])
def test_a_strip_is_tiled_properly_within_the_logarithm(count):
    rng = random.Random(count)
    for _ in range(10):
        t_side, a, b = strip([mpq(rng.randint(15, 400), 100) for _ in range(count)])
        piece = triangulate_one_sided(t_side, a, b, proper=True)
        points = [*t_side, a, b, *piece.steiner]
        first = len(t_side) + 2
        faces = [tuple(v if v >= 0 else first - 1 - v for v in face) for face in piece.faces]
        owner, repeated = directed_edges(faces)
        m = len(t_side) - 1
        assert not repeated and all(len(face) == 3 for face in faces)
        assert {s for s in owner if s[::-1] not in owner} == set(sides((*range(m + 1), m + 2, m + 1)))
        least = min(face_feature_squared(points, face, corners_of(points, face)) for face in faces)
        rows = 2 + (count - 1).bit_length()
        # The argument for the rows gives 0.597 of their spacing; elsewhere g/5 is reached.
        assert least >= min(G / 5, mpq(597, 1000) * G / rows) ** 2
        assert len(piece.steiner) <= 2 * count + (count - 1).bit_length()


def test_rows_halve():
    t_side, a, b = strip([mpq(1)] * 8)
    for candidate in layered_candidates(frame_of(t_side, a, b)):
        heights = [p.y for p in candidate.steiner]
        sizes = [heights.count(y) for y in sorted(set(heights))]
        assert sizes[-1] == 1 and all(2 * after in (before, before + 1) for before, after in pairwise(sizes))


@pytest.mark.parametrize("name", sorted(families.ALL_SMALL | families.SMALL_PSLGS))
def test_proper_meshes_keep_their_bound(name):
    pslg = (families.ALL_SMALL | families.SMALL_PSLGS)[name]
    result = mesh(pslg, kind="proper")
    assert result.holds and result.verification.valid
    assert verify(pslg, result.mesh).kind == "proper"
    assert "repaired.proper-degradation" in {j.claim.id for j in result.judgements}


def test_the_degradation_of_combs_grows_no_faster_than_the_logarithm():
    squares = []
    for teeth in (4, 16, 64):
        result = mesh(families.comb(teeth), kind="proper")
        squares.append(Fraction(str(result.verification.degradation_squared)))
    assert squares[0] < squares[1] < squares[2]
    # From 4 to 64 teeth the logarithm grows by less than 3.
    assert squares[2] < 9 * squares[0]
