"""Exhaustive polygons, against a second method: all tours of all point sets, brought to canonical form."""

from itertools import combinations, permutations

import pytest

from exactmesh.search.corners import canonical, is_simple, normalised
from exactmesh.search.lattice import count_placed, count_polygons, lattice_polygons, prefixes
from exactmesh.search.spec import Spec, prefix_groups, search_tasks
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


# Published counts of polygons in all places, from the On-Line Encyclopedia of Integer Sequences: A045996 triangles in
# an m x m grid; A189412 concave and A189413 convex quadrilaterals; A331235 polygons through all points of a 3 x k grid,
# angles of 180 degrees allowed.
@pytest.mark.parametrize(("m", "count"), [(2, 4), (3, 76), (4, 516), (5, 2148), (6, 6768)])
def test_published_counts_of_triangles(m: int, count: int) -> None:
    assert count_placed(3, m) == count


@pytest.mark.parametrize(("m", "concave", "convex"), [(2, 0, 1), (3, 24, 70), (4, 720, 1038), (5, 6300, 7398)])
def test_published_counts_of_quadrilaterals(m: int, concave: int, convex: int) -> None:
    assert count_placed(4, m, straight=False) == concave + convex


@pytest.mark.parametrize(("k", "count"), [(2, 1), (3, 8), (4, 62)])
def test_published_counts_of_polygons_through_all_points(k: int, count: int) -> None:
    assert count_placed(3 * k, 3, k=k) == count


@pytest.mark.parametrize(("m", "count"), [(2, 1), (3, 8), (4, 29), (5, 79)])
def test_published_counts_of_congruence_classes_of_triangles(m: int, count: int) -> None:
    # A028419. Up to 5 x 5 points congruent triangles are images of each other; from 6 x 6 on they need not be, since
    # 5 is the length of (5, 0) and of (3, 4).
    assert count_polygons(3, m) == count


@pytest.mark.parametrize(("n", "m", "k"), [(3, 4, 2), (4, 4, 2), (5, 2, 4), (4, 3, 4)])
def test_polygons_of_other_grids_are_those_of_brute_force(n: int, m: int, k: int) -> None:
    points = [(x, y) for x in range(m) for y in range(k)]
    wanted = {canonical(tour, False) for chosen in combinations(points, n)
              for tour in ((chosen[0], *rest) for rest in permutations(chosen[1:])) if is_simple(tour)}
    found = [polygon for prefix in prefixes(m, k) for polygon in lattice_polygons(n, m, prefix, k=k)]
    assert len(found) == len(set(found)) and set(found) == wanted


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


def test_the_polygons_of_all_shards_are_the_polygons_each_once() -> None:
    seen: list[str] = []

    def polygons(shard: tuple[int, int]) -> list[str]:
        spec = Spec((("steiner-per-vertex", "repaired", "nonproper"),), "exhaustive", "lattice",
                    (("images", 0), ("m", 3), ("n", 4)), shard=shard).checked()
        return [str(polygon) for task in search_tasks(spec) for prefix in prefix_groups(3, 3)[int(task.key[2:])]
                for polygon in lattice_polygons(4, 3, prefix)]

    for residue in range(5):
        seen += polygons((residue, 5))
    assert len(seen) == len(set(seen)) == 22 and set(seen) == set(polygons((0, 1)))


def test_many_prefixes_are_dealt_out_to_fewer_tasks() -> None:
    groups = prefix_groups(10, 10)
    assert len(groups) == 2000 and sorted(prefix for group in groups for prefix in group) == sorted(prefixes(10))


def test_every_image_is_judged_once() -> None:
    spec = Spec((("steiner-per-vertex", "repaired", "nonproper"),), "exhaustive", "lattice",
                (("m", 2), ("n", 3))).checked()
    reports = [run_task(spec.to_json(), task.key) for task in search_tasks(spec)]
    assert sum(int(str(report["evaluated"])) for report in reports) == 4  # the right triangle in four positions


def test_normal_form() -> None:
    square = ((5, 5), (5, 6), (6, 6), (6, 5))
    assert normalised(square) == ((0, 0), (1, 0), (1, 1), (0, 1)) == canonical(square[::-1])
