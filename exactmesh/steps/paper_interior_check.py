"""Check P6 from what it has to be; `paper_interior.py` is not imported. Values are squares.

Tiling       each trapezoid with four corners has one new vertex, joined to them; the faces tile the inside of P4.
Degradation  the faces keep half of the mfs of P5, which is that of the planar graph of all trapezoids, T-vertices
             included.
Feature      the faces keep 1/(4 d3) of mfs(P), where half the grid's spacing stands for 1/(4 d3). With `clean_only`
             the trapezoids with T-vertices are left out.
"""

from collections.abc import Sequence

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.cycles import directed_edges, sides
from exactmesh.planar.pslg import Pslg
from exactmesh.steps import patch_check
from exactmesh.steps.records import Cycle, Offset, Patch, Trapezoid, Trapezoidation


def check_tiling(p4: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Verdict:
    """Return whether P6 has one vertex in each trapezoid and tiles the inside of P4; one instance a face."""
    owner, _ = directed_edges(interior.faces)
    inside: list[int] = []
    for number, z in enumerate(chords.trapezoids):
        apexes = {v for face in _faces_along(z, owner, interior) for v in face if v >= interior.first}
        if len(apexes) != (0 if z.bl == z.br or z.tl == z.tr else 1):
            return failed(number + 1, "one vertex in each trapezoid, none in a triangle", trapezoid=number,
                          vertices=sorted(apexes))
        inside += apexes
    if sorted(inside) != list(range(interior.first, interior.first + len(interior.points))):
        return failed(len(interior.faces), "every new vertex is in one trapezoid", vertices=len(interior.points))
    return patch_check.check_interior_tiling(p4, chords, interior, points)


def check_degradation(p4: Offset, chords: Trapezoidation, interior: Patch, points: Sequence[Point]) -> Verdict:
    """Return the verdict on the least squared feature size of the faces over mfs(P5)^2; one instance a face."""
    tally = Tally("half of mfs(P5) is left", ">=", mpq(1, 4))
    last = chords.first + len(chords.points)
    edges = {(min(side), max(side)) for z in chords.trapezoids for side in sides(boundary(z))}
    p5 = Pslg(tuple(points[p4.first : last]), tuple(sorted((u - p4.first, v - p4.first) for u, v in edges)))
    nearest = minimum_feature_size(p5)
    for face in interior.faces:
        value = _feature(points, face)
        tally.see(value / nearest.squared if nearest is not None else mpq(0), face=list(face), at=str(points[face[-1]]))
    return tally.verdict()


def check_feature(chords: Trapezoidation, interior: Patch, points: Sequence[Point], spacing: mpq, mfs_squared: mpq,
                  clean_only: bool = False) -> Verdict:
    """Return the verdict on the least squared feature size of the faces, in units of the mfs; one instance a face."""
    tally = Tally("feature size >= 1/(4 d3)", ">=", spacing**2 / (4 * mfs_squared))
    owner, _ = directed_edges(interior.faces)
    dirty = {face for z in chords.trapezoids if z.bottom or z.top for face in _faces_along(z, owner, interior)
             } if clean_only else set()
    for face in interior.faces:
        if face not in dirty:
            tally.see(_feature(points, face) / mfs_squared, face=list(face), at=str(points[face[-1]]))
    return tally.verdict()


def boundary(z: Trapezoid) -> Cycle:
    """Return the boundary of a trapezoid, counter-clockwise, with its T-vertices; an apex counts once."""
    bottom = (z.bl, *z.bottom, z.br) if z.bl != z.br else (z.bl,)
    top = (z.tr, *z.top[::-1], z.tl) if z.tr != z.tl else (z.tl,)
    return (*bottom, *top)


def _faces_along(z: Trapezoid, owner: dict[tuple[int, int], int], interior: Patch) -> set[Cycle]:
    return {interior.faces[owner[side]] for side in sides(boundary(z)) if side in owner}


def _feature(points: Sequence[Point], face: Cycle) -> mpq:
    """Return the squared feature size of a face, zero for what is no triangle."""
    corners = corners_of(points, face)
    return mpq(0) if isinstance(corners, NotTriangle) else face_feature_squared(points, face, corners)
