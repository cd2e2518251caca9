"""The families and the example data are what they say: valid, of the stated size, in the right place."""

import json
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

import families
import pytest
import shapely
from gmpy2 import mpq

from exactmesh.data import EXAMPLES
from exactmesh.errors import InputError
from exactmesh.geometry.point import Point, cross, minus
from exactmesh.planar.pslg import Pslg
from exactmesh.planar.validate import validate

ISSUE_LIST = families.issue_list()


def is_one_cycle(pslg: Pslg) -> bool:
    """Return whether the edges form a single closed walk through all vertices."""
    neighbours: dict[int, list[int]] = {v: [] for v in range(len(pslg.vertices))}
    for u, v in pslg.edges:
        neighbours[u].append(v)
        neighbours[v].append(u)
    if any(len(pair) != 2 for pair in neighbours.values()):
        return False
    previous, at, seen = -1, 0, 0
    while seen == 0 or at != 0:
        first, second = neighbours[at]
        previous, at, seen = at, second if first == previous else first, seen + 1
    return seen == len(pslg.vertices)


def doubled_area(pslg: Pslg) -> mpq:
    return sum((cross(pslg.vertices[u], pslg.vertices[v]) for u, v in pslg.edges), mpq(0))


# --- collections ---


@pytest.mark.parametrize("name", families.ALL_SMALL)
def test_small_inputs_are_small_simple_polygons(name: str) -> None:
    pslg = families.ALL_SMALL[name]
    validate(pslg)
    assert is_one_cycle(pslg) and 3 <= len(pslg.vertices) <= 60 and pslg.name == name and not pslg.holes


@pytest.mark.parametrize("name", ISSUE_LIST)
def test_the_issue_list_is_of_simple_polygons(name: str) -> None:
    pslg = ISSUE_LIST[name]
    validate(pslg)
    assert is_one_cycle(pslg) and len(pslg.vertices) <= 200 and pslg.name == name


@pytest.mark.parametrize("name", families.SMALL_PSLGS)
def test_small_pslgs_are_valid(name: str) -> None:
    pslg = families.SMALL_PSLGS[name]
    validate(pslg)
    assert len(pslg.vertices) <= 60 and not is_one_cycle(pslg)


def test_coordinates_are_rationals_and_polygons_counter_clockwise_unless_turned() -> None:
    for name, pslg in (families.ALL_SMALL | ISSUE_LIST | families.SMALL_PSLGS).items():
        assert all(type(p) is Point and type(p.x) is type(p.y) is mpq for p in (*pslg.vertices, *pslg.holes))
        if name not in families.SMALL_PSLGS:
            assert (doubled_area(pslg) > 0) == (not name.endswith(("mirrored", "reversed"))), name


# --- families ---


@pytest.mark.parametrize("n", [3, 4, 5, 7, 12, 100, 1000])
def test_regular_polygon_lies_on_the_unit_circle_and_is_strictly_convex(n: int) -> None:
    points = families.regular_polygon(n).vertices
    assert len(points) == n and all(p.x**2 + p.y**2 == 1 for p in points)
    for i in range(n):
        a, b, c = points[i - 2], points[i - 1], points[i]
        assert cross(minus(b, a), minus(c, b)) > 0
    sides = [float(minus(points[i], points[i - 1]).x ** 2 + minus(points[i], points[i - 1]).y ** 2)
             for i in range(n)]
    assert max(sides) / min(sides) < 1.05


@pytest.mark.parametrize(("pslg", "count"), [
    (families.rectangle_with_two_midway_vertices(50), 6), (families.comb(7), 17), (families.comb(1), 5),
    (families.spike_room(9), 7), (families.l_shape(9), 6), (families.rectangular_spiral(3), 26),
    (families.curved_spiral(2, 16), 66), (families.convex_spike(), 7), (families.reflex_notch(), 7),
    (families.sliver(100), 4), (families.sliver(100, families.SHARP, 6), 16), (families.star(7), 14),
    (families.staircase(8), 18), (families.grid_map(3, 2, 0), 12),
    (families.with_collinear_vertices(families.l_shape(9), 2), 18)])
def test_sizes(pslg: Pslg, count: int) -> None:
    validate(pslg)
    assert len(pslg.vertices) == count


@pytest.mark.parametrize("spacing", ["even", "uneven", "doubling"])
def test_all_teeth_of_a_comb_end_on_one_level(spacing: str) -> None:
    pslg = families.comb(9, 100, spacing)
    validate(pslg)
    tips = [p for p in pslg.vertices if 0 < p.y < 4]
    assert len(tips) == 9 and {p.y for p in tips} == {1}
    nearly = families.comb(9, 100, spacing, families.SHARP)
    validate(nearly)
    levels = {p.y for p in nearly.vertices if 0 < p.y < 4}
    assert levels == {1 + k * mpq(families.SHARP) for k in range(5)}


def test_midway_vertices_are_at_unit_distance_in_the_middle() -> None:
    points = families.rectangle_with_two_midway_vertices(7).vertices
    assert points[:4] == ((0, 0), (3, 0), (4, 0), (7, 0))


def test_the_sharp_angles_are_a_millionth() -> None:
    spike, notch = families.convex_spike().vertices, families.reflex_notch().vertices
    for a, tip, b in (spike[2:5], notch[4:7]):
        u, v = minus(a, tip), minus(b, tip)
        tangent = abs(cross(u, v)) / (u.x * v.x + u.y * v.y)
        assert abs(tangent * 10**6 - 1) < mpq(1, 1000)


# --- random families ---


@pytest.mark.parametrize("kind", families.KINDS)
@pytest.mark.parametrize("n", [3, 4, 5, 6, 7, 8, 9, 10, 31, 100])
def test_random_polygons_are_simple_and_have_n_vertices(kind: str, n: int) -> None:
    for seed in range(5):
        pslg = families.random_simple_polygon(n, seed, kind)
        validate(pslg)
        assert len(pslg.vertices) == n and is_one_cycle(pslg) and doubled_area(pslg) > 0


@pytest.mark.parametrize("kind", [kind for kind in families.KINDS if kind != "two-opt"])
def test_large_random_polygons(kind: str) -> None:
    pslg = families.random_simple_polygon(5000, 1, kind)
    validate(pslg)
    assert len(pslg.vertices) == 5000 and is_one_cycle(pslg)


@pytest.mark.parametrize("make", [
    lambda seed: families.random_simple_polygon(40, seed), lambda seed: families.random_pslg(seed),
    lambda seed: families.grid_map(4, 4, seed),
    lambda seed: families.big_coordinates(families.l_shape(9), seed)])
def test_random_families_depend_on_the_seed_only(make: Callable[[int], Pslg]) -> None:
    assert make(1) == make(1) != make(2)


def test_too_few_vertices_and_unknown_kinds_are_refused() -> None:
    with pytest.raises(ValueError, match="at least 3"):
        families.random_simple_polygon(2, 0)
    with pytest.raises(KeyError):
        families.random_simple_polygon(9, 0, "round")


def test_random_pslgs_are_valid_and_of_every_sort() -> None:
    found = set()
    for seed in range(60):
        pslg = families.random_pslg(seed)
        validate(pslg)
        degree = [0] * len(pslg.vertices)
        for e in pslg.edges:
            for v in e:
                degree[v] += 1
        found |= {("degree", d) for d in degree} | {("holes", bool(pslg.holes))}
        validate(families.grid_map(5, 4, seed))
    assert found >= {("degree", d) for d in range(4)} | {("holes", True), ("holes", False)}


# --- changes ---


@pytest.mark.parametrize("pslg", [families.comb(4, 30, "uneven"), families.random_pslg(3)])
def test_changes_keep_a_pslg_valid_and_do_what_they_say(pslg: Pslg) -> None:
    t = Fraction(2, 7)
    changed = {
        "scaled": families.scaled(pslg, Fraction(1, 10**30)),
        "moved": families.translated(pslg, 5, Fraction(1, 3)),
        "turned": families.rotated(pslg, t), "mirrored": families.mirrored(pslg),
        "reversed": families.reversed_orientation(pslg), "start": families.with_start(pslg, 3),
        "cut": families.with_collinear_vertices(pslg, 2), "big": families.big_coordinates(pslg, 1)}
    for result in changed.values():
        validate(result)
        assert len(result.holes) == len(pslg.holes)
    assert families.scaled(changed["scaled"], 10**30) == pslg
    assert families.translated(changed["moved"], -5, Fraction(-1, 3)) == pslg
    assert families.rotated(changed["turned"], -t) == pslg
    assert families.mirrored(changed["mirrored"]) == pslg
    assert families.reversed_orientation(changed["reversed"]) == pslg
    assert changed["reversed"].vertices == pslg.vertices[::-1]
    assert changed["start"].vertices == pslg.vertices[3:] + pslg.vertices[:3]
    for same in ("turned", "reversed", "start"):
        assert sorted(lengths_squared(changed[same])) == sorted(lengths_squared(pslg))
    assert len(changed["cut"].vertices) == len(pslg.vertices) + 2 * len(pslg.edges)
    assert all(length * 9 in lengths_squared(pslg) for length in lengths_squared(changed["cut"]))
    big = changed["big"].vertices
    assert all(len(str(value)) == 30 for p in big for value in p)


def lengths_squared(pslg: Pslg) -> list[mpq]:
    steps = [minus(pslg.vertices[u], pslg.vertices[v]) for u, v in pslg.edges]
    return [d.x**2 + d.y**2 for d in steps]


def test_a_polygon_stays_in_cyclic_order_when_reversed_cut_or_started_elsewhere() -> None:
    pslg = families.l_shape(5)
    assert families.with_start(pslg, 2).edges == pslg.edges
    assert families.with_collinear_vertices(pslg, 1).edges == families.regular_polygon(12).edges
    assert doubled_area(families.reversed_orientation(pslg)) == -doubled_area(pslg)


# --- example data ---


def rings(name: str) -> list[list[tuple[mpq, mpq]]]:
    """Return the rings of an example without their repeated last point, as the decimals that are written."""
    data = json.loads(EXAMPLES.path(name).read_text(encoding="utf-8"), parse_float=Decimal)
    found: list[list[tuple[mpq, mpq]]] = []
    for feature in data.get("features", [data]):
        assert "Natural Earth" in feature["properties"]["source"]
        geometry: dict[str, Any] = feature["geometry"]
        polygons = geometry["coordinates"]
        for polygon in [polygons] if geometry["type"] == "Polygon" else polygons:
            for ring in polygon:
                assert ring[0] == ring[-1]
                found.append([(mpq(str(x)), mpq(str(y))) for x, y in ring[:-1]])
    return found


def test_there_are_large_and_small_outlines() -> None:
    sizes = {name: sum(map(len, rings(name))) for name in EXAMPLES.names() if name != "south-america"}
    assert len(sizes) >= 6 and min(sizes.values()) < 200 and sum(size > 1000 for size in sizes.values()) >= 2


@pytest.mark.parametrize("name", [name for name in EXAMPLES.names() if name != "south-america"])
def test_outlines_are_simple_polygons(name: str) -> None:
    (ring,) = rings(name)
    pslg = families.ring(ring, name)
    validate(pslg)
    assert doubled_area(pslg) > 0
    assert shapely.Polygon([(float(x), float(y)) for x, y in ring]).is_valid
    assert all((10**4 * value).denominator == 1 for p in ring for value in p)


def test_the_map_is_a_pslg_whose_countries_share_their_borders() -> None:
    index: dict[tuple[mpq, mpq], int] = {}
    sides: list[tuple[int, int]] = []
    for ring in rings("south-america"):
        ids = [index.setdefault(p, len(index)) for p in ring]
        sides += zip(ids, ids[1:] + ids[:1], strict=True)
    edges = {(min(side), max(side)) for side in sides}
    validate(Pslg(tuple(Point(*p) for p in index), tuple(edges)))
    # A shared side is run once in each direction.
    assert len(set(sides)) == len(sides) > len(edges) + 200


def test_an_unknown_example_is_refused_with_the_names_there_are() -> None:
    with pytest.raises(InputError, match=r"no example 'atlantis'; there are: .*iceland"):
        EXAMPLES.path("atlantis")
