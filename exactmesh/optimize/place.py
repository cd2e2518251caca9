"""Where to put the centre of a star: the places from which every triangle of a fan keeps a given feature size.

For a fan over the side u v of a ring, the triangle u v p has heights of at least t exactly when p lies on the left of
u v at distance t, and the angles at u and v are at least alpha, sin(alpha) = t / |u v|: the heights from v and u are
|u v| times the sines of these angles, which add up to less than half a turn. So the places are an intersection of
half-planes, three a side, and shrink as t grows; the best t is found by bisection. Floats propose here, and decide
nothing.
"""

from collections.abc import Sequence
from math import hypot, sqrt

Spot = tuple[float, float]
_STEPS = 6


def places(ring: Sequence[Spot], size: float) -> list[Spot]:
    """Return the corners of the convex polygon from which each triangle over a side of the ring keeps `size`."""
    xs, ys = [x for x, _ in ring], [y for _, y in ring]
    left, right, low, high = min(xs), max(xs), min(ys), max(ys)
    region = [(left, low), (right, low), (right, high), (left, high)]
    x, y = ring[-1]
    for u, v in ring:
        dx, dy = u - x, v - y
        length = hypot(dx, dy)
        if length <= size:
            return []
        s = size / length
        c = sqrt(1 - s * s)
        # The side leads from (x, y) to (u, v); the last two half-planes are turned about its ends by alpha.
        for a, b, e, f in ((-dy, dx, x - dy * s, y + dx * s), (-dx * s - dy * c, dx * c - dy * s, x, y),
                           (dx * s - dy * c, dx * c + dy * s, u, v)):
            region = _clipped(region, a, b, a * e + b * f)
            if not region:
                return []
        x, y = u, v
    return region


def _clipped(region: list[Spot], a: float, b: float, c: float) -> list[Spot]:
    """Return the part of a convex polygon with a x + b y >= c."""
    depth = [a * x + b * y - c for x, y in region]
    if min(depth) >= 0:
        return region
    kept = []
    for i, e in enumerate(depth):
        d = depth[i - 1]
        if (d < 0) != (e < 0):
            (r, s), (x, y) = region[i - 1], region[i]
            share = d / (d - e)
            kept.append((r + share * (x - r), s + share * (y - s)))
        if e >= 0:
            kept.append(region[i])
    return kept


def best_places(ring: Sequence[Spot], low: float, high: float) -> tuple[float, list[Spot]]:
    """Return the greatest size up to `high` found to have a place, and its places; none unless it exceeds `low`."""
    if region := places(ring, high):
        return high, region
    if not (region := places(ring, low)):
        return low, []
    for _ in range(_STEPS):
        middle = (low + high) / 2
        if found := places(ring, middle):
            low, region = middle, found
        else:
            high = middle
    return low, region


def middle_of(region: Sequence[Spot]) -> Spot:
    """Return the mean of the corners, which lies in the convex polygon."""
    return sum(x for x, _ in region) / len(region), sum(y for _, y in region) / len(region)


def height(a: Spot, b: Spot, c: Spot) -> float:
    """Return the least height of the triangle a b c; negative when it turns right."""
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]
    wx, wy = vx - ux, vy - uy
    longest = max(ux * ux + uy * uy, vx * vx + vy * vy, wx * wx + wy * wy)
    return (ux * vy - uy * vx) / sqrt(longest) if longest > 0 else 0.0
