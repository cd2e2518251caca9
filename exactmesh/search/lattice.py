"""All simple polygons with n corners among m x k lattice points, each once up to symmetry.

Two polygons are the same when a translation, a symmetry of the grid (eight of a square one, four of another), reversal
or another start makes them equal. A polygon is built corner by corner from its least corner (by x, then y), counter-
clockwise, so that it is met once in each position; of the images that fit it is kept when it equals `canonical`. The
first three corners of the canonical form are its `Prefix`: prefixes partition the polygons, so any division of them
into shards does.
"""

from collections.abc import Iterator, Sequence

from exactmesh.families.build import doubled_area, turn
from exactmesh.search.corners import Corner, Corners, canonical, folds_back, images, segments_meet

Prefix = tuple[Corner, Corner, Corner]


def prefixes(m: int, k: int = 0) -> Iterator[Prefix]:
    """Yield what the first three corners may be, in a fixed order; k rows of m points, as many as columns if 0."""
    points = [(x, y) for x in range(m) for y in range(k or m)]
    for first in points[: k or m]:
        for second in points:
            for third in points:
                if second > first and third > first and third != second and not folds_back(first, second, third):
                    yield first, second, third


def lattice_polygons(n: int, m: int, prefix: Prefix, straight: bool = True, k: int = 0) -> Iterator[Corners]:
    """Yield the canonical polygons with n corners that begin with `prefix`; angles of 180 degrees if `straight`."""
    points = [(x, y) for x in range(m) for y in range(k or m) if (x, y) > prefix[0]]
    swaps = k in (0, m)
    if len(points) < n - 1 or (not straight and turn(*prefix) == 0):
        return
    stack: list[list[Corner]] = [list(prefix)]
    while stack:
        path = stack.pop()
        if len(path) == n:
            if _closes(path, straight) and canonical(path, swaps) == tuple(path):
                yield tuple(path)
            continue
        stack += [[*path, p] for p in points if p not in path and _extends(path, p, straight)]


def count_polygons(n: int, m: int, straight: bool = True, k: int = 0) -> int:
    """Return how many there are."""
    return sum(1 for prefix in prefixes(m, k) for _ in lattice_polygons(n, m, prefix, straight, k))


def count_placed(n: int, m: int, straight: bool = True, k: int = 0) -> int:
    """Return how many there are when polygons in different places, or turned or mirrored, are different."""
    placed = 0
    for prefix in prefixes(m, k):
        for polygon in lattice_polygons(n, m, prefix, straight, k):
            for image in set(images(polygon, k in (0, m))):
                width, height = max(x for x, _ in image), max(y for _, y in image)
                placed += max(0, m - width) * max(0, (k or m) - height)
    return placed


def _extends(path: Sequence[Corner], p: Corner, straight: bool) -> bool:
    """Return whether the edge from the last corner to p touches the path at that corner only."""
    a, b = path[-2], path[-1]
    if turn(a, b, p) == 0 and (not straight or folds_back(a, b, p)):
        return False
    return not any(segments_meet(path[i], path[i + 1], b, p) for i in range(len(path) - 2))


def _closes(path: Sequence[Corner], straight: bool) -> bool:
    """Return whether the edge back to the first corner makes the path a counter-clockwise simple polygon."""
    first, last = path[0], path[-1]
    if doubled_area(path) <= 0:
        return False
    if len(path) == 3:
        return True
    for a, b, c in ((path[-2], last, first), (last, first, path[1])):
        if turn(a, b, c) == 0 and (not straight or folds_back(a, b, c)):
            return False
    return not any(segments_meet(path[i], path[i + 1], last, first) for i in range(1, len(path) - 2))
