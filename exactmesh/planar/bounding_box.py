"""Put a PSLG into a box, so that its outside is meshed as well."""

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg


def with_bounding_box(pslg: Pslg, margin: mpq) -> Pslg:
    """Return `pslg` with the four corners and edges of an upright rectangle `margin` away from it on every side.

    Raises `InputError` when the margin is not positive or there is no vertex to go around.
    """
    if margin <= 0:
        raise InputError(f"the margin of a bounding box must be positive, not {margin}")
    if not pslg.vertices:
        raise InputError("there is nothing to put a bounding box around")
    xs, ys = [p.x for p in pslg.vertices], [p.y for p in pslg.vertices]
    left, right, low, high = min(xs) - margin, max(xs) + margin, min(ys) - margin, max(ys) + margin
    corners = Point(left, low), Point(right, low), Point(right, high), Point(left, high)
    first = len(pslg.vertices)
    edges = tuple((first + i, first + (i + 1) % 4) for i in range(4))
    return Pslg(pslg.vertices + corners, pslg.edges + edges, pslg.holes, pslg.name)
