"""The paper's Interior: one vertex in every trapezoid, joined to its corners (paper §2, P6).

In      `Trapezoidation` of P4, and the points of all vertices so far.
Out     `Patch`.
Exact   rational.
Paper   says that the feature size at most halves (Lemma 1). That is true of trapezoids without T-vertices only; the
        T-vertices that the trapezoidation leaves on the sides stay there, as in the text, and the degradation is
        unbounded: the hexagon (0,1), (2,1), (2,0), (L,0), (L,2), (0,2) has degradation above L for L = 44, 192.
        Triangular trapezoids, of which the paper does not speak, are left as they are.
Check   `paper_interior_check.py`
"""

from collections.abc import Sequence

from exactmesh.geometry.point import Point
from exactmesh.steps.lemma_1 import lemma_1_abscissa
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Patch, Trapezoid, Trapezoidation


def triangulate_with_centres(trapezoidation: Trapezoidation, points: Sequence[Point]) -> Patch:
    """Return P6: the triangles between each trapezoid's vertex and its four sides."""
    mesh = PatchBuilder(points)
    for z in trapezoidation.trapezoids:
        _add(mesh, z)
    return mesh.finished()


def _add(mesh: PatchBuilder, z: Trapezoid) -> None:
    bottom, top = (z.bl, *z.bottom, z.br), (z.tr, *z.top[::-1], z.tl)
    if z.bl == z.br:
        mesh.add_face((z.bl, *top))
    elif z.tl == z.tr:
        mesh.add_face((*bottom, z.tl))
    else:
        bl, br, tr, tl = (mesh.points[v] for v in (z.bl, z.br, z.tr, z.tl))
        s = mesh.add(Point(lemma_1_abscissa(bl.x, br.x, tl.x, tr.x), (bl.y + tl.y) / 2))
        for side in (bottom, (z.br, z.tr), top, (z.tl, z.bl)):
            mesh.add_face((*side, s))
