"""The inputs of Table 1: exact, valid, of the size they claim, and as near to the regular n-gon as is said."""

from math import pi, sin

import oracle
import pytest
from gmpy2 import get_context, mpq

from exactmesh.measure.ifs import internal_feature_size
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import domain_of
from exactmesh.reproduce.families import FAMILIES, WITHIN, Family, regular_polygon, sine_of_nth

BY_NAME = {family.name: family for family in FAMILIES}
SIZES = [(family, size) for family in FAMILIES for size in family.sizes(False)
         if size <= 64 or family.name == "rectangle"]
IDS = [f"{family.name} {size}" for family, size in SIZES]


def test_the_sizes_are_those_that_are_asked_for() -> None:
    assert list(BY_NAME) == ["regular", "rectangle", "floor", "comb"]
    for name in ("regular", "floor", "comb"):
        assert BY_NAME[name].sizes(False) == tuple(2**i for i in range(2, 11))
        assert max(BY_NAME[name].sizes(True)) == 256
    assert BY_NAME["rectangle"].sizes(False) == (4, *(10**i for i in range(1, 7)))
    assert max(BY_NAME["rectangle"].sizes(True)) == 10**4


@pytest.mark.parametrize("family, size", SIZES, ids=IDS)
def test_every_input_is_one_simple_polygon(family: Family, size: int) -> None:
    pslg = family.make(size)
    (face,) = domain_of(pslg).domain
    assert face.outer is not None and not face.inner and not face.isolated
    n = len(pslg.vertices)
    expected = {"regular": size, "rectangle": 6, "floor": size + 4, "comb": 2 * size + 3}
    assert len(face.outer) == n == expected[family.name]
    assert family.place(size, n) == (size if family.name == "rectangle" else n)


@pytest.mark.parametrize("family, size", SIZES, ids=IDS)
def test_the_mfs_is_what_the_arguments_take_it_for(family: Family, size: int) -> None:
    pslg = family.make(size)
    nearest = minimum_feature_size(pslg)
    assert nearest is not None
    if family.name == "regular":
        low, high = sine_of_nth(size)
        assert (2 * low - 2 * WITHIN) ** 2 <= nearest.squared <= (2 * high + 2 * WITHIN) ** 2
    else:
        assert nearest.squared == 1
    if size <= 16:
        assert nearest.squared == oracle.exact(oracle.mfs_squared(pslg.vertices, pslg.edges))
    if family.name != "comb":
        inside = internal_feature_size(domain_of(pslg))
        assert inside is not None and inside.squared == nearest.squared


@pytest.mark.parametrize("n", [4, 5, 6, 7, 12, 37, 64, 1024])
def test_the_regular_polygon_is_on_the_circle_and_within_the_error(n: int) -> None:
    points = regular_polygon(n).vertices
    assert len(set(points)) == n and points[0] == (1, 0)
    assert all(p.x**2 + p.y**2 == 1 for p in points)
    # Another road: 400 bits, and no half angles.
    context = get_context().copy()
    context.precision = 400
    for i, p in enumerate(points):
        angle = context.mul(context.const_pi(), mpq(2 * i, n))
        dx, dy = (mpq(context.cos(angle)) - p.x, mpq(context.sin(angle)) - p.y)
        assert dx**2 + dy**2 <= WITHIN**2


def test_a_square_is_exact_and_less_than_a_square_is_refused() -> None:
    assert [tuple(map(int, p)) for p in regular_polygon(4).vertices] == [(1, 0), (0, 1), (-1, 0), (0, -1)]
    with pytest.raises(ValueError, match="at least 4 vertices, not 3"):
        regular_polygon(3)


@pytest.mark.parametrize("n", [2, 3, 4, 6, 100, 1024])
def test_the_enclosure_of_the_sine(n: int) -> None:
    low, high = sine_of_nth(n)
    assert low <= high <= low + mpq(1, 2**140)
    assert float(low) == pytest.approx(sin(pi / n), rel=1e-15)
    if n == 6:
        assert low <= mpq(1, 2) <= high
    if n == 4:
        assert low**2 <= mpq(1, 2) <= high**2


def test_the_optima_at_hand() -> None:
    low, high = BY_NAME["regular"].optimum(6)  # type: ignore[misc]
    assert low < 4 < high < low + mpq(1, 10**9)
    assert BY_NAME["rectangle"].optimum(3) == (5, 5)  # type: ignore[misc]
    # The hardest edge of the floor of length 3 is the middle one, of length 4 one of the two in the middle.
    assert BY_NAME["floor"].optimum(2) == BY_NAME["floor"].optimum(3) == (5, 5)  # type: ignore[misc]
    assert BY_NAME["comb"].optimum is None
