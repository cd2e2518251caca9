"""All simple polygons with n corners among the m x m points (0..m-1)^2, each once up to symmetry.

Two polygons are the same when a translation, one of the eight symmetries of the square, reversal or another start
makes them equal. A polygon is built corner by corner from its least corner (by x, then y), counter-clockwise, so that
it is met once in each position; of the images that fit it is kept when it equals `canonical`. The first three corners
of the canonical form are its `Prefix`: prefixes partition the polygons, so any division of them into shards does.
"""

from collections.abc import Iterator, Sequence

from exactmesh.search.corners import Corner, Corners, canonical, doubled_area, folds_back, segments_meet, turn

Prefix = tuple[Corner, Corner, Corner]


def prefixes(m: int) -> Iterator[Prefix]:
    """Yield what the first three corners may be, in a fixed order."""
    points = [(x, y) for x in range(m) for y in range(m)]
    for first in points[:m]:
        for second in points:
            for third in points:
                if second > first and third > first and third != second and not folds_back(first, second, third):
                    yield first, second, third


def lattice_polygons(n: int, m: int, prefix: Prefix, straight: bool = True) -> Iterator[Corners]:
    """Yield the canonical polygons with n corners that begin with `prefix`; angles of 180 degrees if `straight`."""
    points = [(x, y) for x in range(m) for y in range(m) if (x, y) > prefix[0]]
    if not straight and turn(*prefix) == 0:
        return
    stack: list[list[Corner]] = [list(prefix)]
    while stack:
        path = stack.pop()
        if len(path) == n:
            if _closes(path, straight) and canonical(path) == tuple(path):
                yield tuple(path)
            continue
        stack += [[*path, p] for p in points if p not in path and _extends(path, p, straight)]


def count_polygons(n: int, m: int, straight: bool = True) -> int:
    """Return how many there are."""
    return sum(1 for prefix in prefixes(m) for _ in lattice_polygons(n, m, prefix, straight))


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
