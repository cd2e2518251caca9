"""The constrained Delaunay triangulation of the domain, exactly, by Lawson's flips.

A side that is no input edge is flipped while one of the two vertices opposite to it lies strictly inside the circle
through the triangle on its other side. Each flip lowers the lifted surface, so the flips end; then every circle
through a triangle is empty of the vertices that see its inside (Lee and Lin 1986). Where four vertices lie on one circle,
the diagonal stays as it was met, so the result is unique but for these.
"""

from collections.abc import Sequence

from exactmesh.geometry.incircle import CirclePoints
from exactmesh.geometry.point import Point
from exactmesh.planar.cycles import Side
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.triangulation import Triangulation, triangles_from, triangulate


def constrained_delaunay(subdivision: Subdivision) -> Triangulation:
    """Return the constrained Delaunay triangulation of the domain."""
    return flipped(subdivision.pslg.vertices, triangulate(subdivision))


def flipped(points: Sequence[Point], start: Triangulation) -> Triangulation:
    """Return `start` after all flips of sides that are not locally Delaunay; its constrained sides stay."""
    apex = dict(start.apex)
    constrained = start.constrained
    in_circle = CirclePoints(points).in_circle
    pending: list[Side] = [side for side in apex if side[0] < side[1] and side not in constrained]
    while pending:
        side = pending.pop()
        # A side may have been flipped away, and met again, since it was put here.
        if side not in apex:
            continue
        u, v = side
        w, x = apex[side], apex[v, u]
        if in_circle(u, v, w, x) <= 0:
            continue
        # The triangles u v w and v u x become u x w and x v w.
        del apex[side], apex[v, u]
        apex[u, x] = apex[x, v] = w
        apex[v, w] = apex[w, u] = x
        apex[x, w], apex[w, x] = u, v
        pending += [outer for outer in ((v, w), (w, u), (u, x), (x, v)) if outer not in constrained]
    return Triangulation(triangles_from(apex), constrained, apex)
