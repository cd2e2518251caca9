"""Triangulate a small polygon without new vertices, with the greatest least height: Klincsek's dynamic program.

On floats, for proposals. No visibility is tested: triangles that all turn left over the whole boundary tile it.
"""

from collections.abc import Sequence

from exactmesh.classic import Triangle, chosen_triangles
from exactmesh.optimize.place import Spot, height


def best_triangles(ring: Sequence[Spot], low: float, high: float) -> tuple[float, list[Triangle]]:
    """Return the least height, up to `high`, and the triangles, as places in the ring; none unless it exceeds `low`.
    """
    count = len(ring)
    best = [[high] * count for _ in ring]
    third = [[-1] * count for _ in ring]
    for length in range(2, count):
        for i in range(count - length):
            j = i + length
            greatest, at = low, -1
            row = best[i]
            for k in range(i + 1, j):
                least = min(row[k], best[k][j])
                if least > greatest:
                    least = min(least, height(ring[i], ring[k], ring[j]))
                    if least > greatest:
                        greatest, at = least, k
                        if least >= high:
                            break
            row[j] = greatest if at >= 0 else -1.0
            third[i][j] = at
    if best[0][count - 1] <= low:
        return low, []
    return best[0][count - 1], chosen_triangles(third)
