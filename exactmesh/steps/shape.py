"""Bring a PSLG into the units of the construction: lengths are divided by m, just below the mfs.

In      `Subdivision` of the PSLG, its squared mfs.
Out     `Shape`.
Exact   m is dyadic with 24 significant bits, m <= mfs < m (1 + 2^-23); the division is exact.
Check   `shape_check.py`
"""

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.numbers.rational import sqrt_below
from exactmesh.planar.faces import Face, Subdivision
from exactmesh.steps.records import Shape

_UNIT_BITS = 24


def shape_of(subdivision: Subdivision, mfs_squared: mpq) -> Shape:
    """Return the domain of `subdivision` in units of a rational just below the square root of `mfs_squared`."""
    unit = sqrt_below(mfs_squared, _UNIT_BITS)
    points = tuple(Point(p.x / unit, p.y / unit) for p in subdivision.pslg.vertices)
    origin = subdivision.half_edges.origin
    meshed = [face for face in subdivision.domain if not _is_bare_triangle(face)]
    return Shape(
        unit, points, origin,
        faces=tuple(face.walks for face in meshed),
        isolated=tuple(face.isolated for face in meshed),
        triangles=tuple(tuple(origin[h] for h in face.outer or ()) for face in subdivision.domain
                        if _is_bare_triangle(face)),
    )


def _is_bare_triangle(face: Face) -> bool:
    return len(face.outer or ()) == 3 and not face.inner and not face.isolated
