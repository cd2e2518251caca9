"""Exhaustive polygons, against a second method: all tours of all point sets, brought to canonical form."""

from itertools import combinations, permutations

import pytest

from exactmesh.search.corners import canonical, images, is_simple, normalised
from exactmesh.search.lattice import count_polygons, lattice_polygons, prefixes
from exactmesh.search.spec import Spec, search_tasks
from exactmesh.search.work import run_task


def brute_force(n: int, m: int) -> set[tuple[tuple[int, int], ...]]:
    points = [(x, y) for x in range(m) for y in range(m)]
    return {canonical(tour) for chosen in combinations(points, n)
            for tour in ((chosen[0], *rest) for rest in permutations(chosen[1:])) if is_simple(tour)}


@pytest.mark.parametrize(("n", "m"), [(3, 2), (4, 2), (3, 3), (4, 3), (5, 3), (6, 3), (3, 4), (4, 4)])
def test_the_polygons_are_those_of_brute_force(n: int, m: int) -> None:
    found = [polygon for prefix in prefixes(m) for polygon in lattice_polygons(n, m, prefix)]
    assert len(found) == len(set(found)) and set(found) == brute_force(n, m)


@pytest.mark.parametrize(("n", "m", "count"), [(3, 3, 8), (4, 3, 22), (5, 3, 33), (6, 3, 40), (3, 4, 29), (4, 4, 183)])
def test_counts(n: int, m: int, count: int) -> None:
    assert count_polygons(n, m) == count


def test_triangles_by_a_formula() -> None:
    # In a grid of 2 by 2 points there is one triangle, and of 3 by 3 points there are 76 = C(9, 3) - 8 in all.
    seen = {moved for prefix in prefixes(3) for polygon in lattice_polygons(3, 3, prefix) for image in images(polygon)
            for moved in [image]}
    placed = {frozenset((x + dx, y + dy) for x, y in image) for image in seen for dx in range(3) for dy in range(3)
              if max(x for x, _ in image) + dx < 3 and max(y for _, y in image) + dy < 3}
    assert count_polygons(3, 2) == 1 and len(placed) == 76


def test_without_straight_angles_there_are_fewer() -> None:
    assert count_polygons(5, 3, straight=False) < count_polygons(5, 3)


def test_shards_partition_the_work() -> None:
    def keys(shard: tuple[int, int]) -> list[str]:
        spec = Spec((("steiner-per-vertex", "repaired", "nonproper"),), "exhaustive", "lattice",
                    (("m", 3), ("n", 4)), shard=shard).checked()
        return [task.key for task in search_tasks(spec)]

    parts = [keys((residue, 3)) for residue in range(3)]
    together = [key for part in parts for key in part]
    assert sorted(together) == sorted(keys((0, 1))) and len(set(together)) == len(together)


def test_every_image_is_judged_once() -> None:
    spec = Spec((("steiner-per-vertex", "repaired", "nonproper"),), "exhaustive", "lattice",
                (("m", 2), ("n", 3))).checked()
    reports = [run_task(spec.to_json(), task.key) for task in search_tasks(spec)]
    assert sum(int(str(report["evaluated"])) for report in reports) == 4  # the right triangle in four positions


def test_normal_form() -> None:
    square = ((5, 5), (5, 6), (6, 6), (6, 5))
    assert normalised(square) == ((0, 0), (1, 0), (1, 1), (0, 1)) == canonical(square[::-1])
