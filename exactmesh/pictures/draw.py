"""Pictures of inputs, meshes and runs: what `exactmesh plot`, `.plot(ax)` and notebooks show.

A picture is for looking at: places are rounded here and nowhere else. What colours say is exact.
"""

from collections.abc import Sequence
from dataclasses import replace

from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification
from exactmesh.numbers.rational import sqrt_below, sqrt_text
from exactmesh.pictures.canvas import EDGE, Canvas, foot
from exactmesh.pictures.faces import face_looks
from exactmesh.pictures.palette import FEATURE_FILLS, INK, Maker
from exactmesh.pictures.scene import Panel, Scene, in_rows
from exactmesh.pictures.steps import (
    draw_input,
    draw_witnesses,
    makers_of,
    mesh_canvas,
    step_panel,
    steps_in_turn,
)
from exactmesh.pictures.svg import svg_text
from exactmesh.pictures.view import View, around, view_of
from exactmesh.planar.cycles import directed_edges
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

# Panels of a picture of all steps, and their number in a row.
_SMALL, _COLUMNS = 460.0, 3
# A nearest pair less than this share of the picture apart is shown again, this many times its distance wide.
_TINY, _ROOM = mpq(1, 40), 4
_CLOSE = 500.0


def picture_of_input(pslg: Pslg, view: View | None = None, mfs: Nearest | None = None) -> Scene:
    """Return a picture of a PSLG with its nearest pair; `mfs` is that, when it is known. Nothing is validated."""
    canvas = Canvas(view or view_of(pslg.vertices))
    draw_input(canvas, pslg)
    canvas.dots("given", pslg.vertices, INK, canvas.radius)
    nearest = mfs or minimum_feature_size(pslg)
    size = f"{len(pslg.vertices)} vertices, {len(pslg.edges)} edges"
    title = f"{pslg.name + ': ' if pslg.name else ''}{size}"
    if nearest is not None:
        canvas.nearest(pslg.vertices, nearest, "input-witness", "mfs")
        title += f", mfs {sqrt_text(nearest.squared, 6)}"
    return Scene(title, ((canvas.panel("P", ""),),))


def picture_of_faces(mesh: Mesh, view: View | None = None) -> Scene:
    """Return a picture of a mesh whose input is not known: faces, T-vertices, and edges of one face only in bold."""
    points = mesh.vertices
    looks = face_looks(points, mesh.faces, mpq(0))
    canvas = Canvas(view or view_of(points), points, looks.corners)
    canvas.areas("faces", ([points[v] for v in face] for face in looks.corners), FEATURE_FILLS[1], EDGE, canvas.thin)
    count = len(points)
    faces = [face for face in mesh.faces if all(0 <= v < count for v in face)]
    owner, _ = directed_edges(faces)
    canvas.edges("rim", ((points[u], points[v]) for u, v in owner if (v, u) not in owner), INK, 1.8,
                 key="edges of one face only")
    canvas.vertices(points, {"given": range(len(points))}, looks.on_sides)
    return Scene(f"{mesh.kind} mesh: {len(mesh.faces)} faces, {len(mesh.vertices)} vertices",
                 ((canvas.panel("mesh", ""),),))


def picture_of_mesh(pslg: Pslg, mesh: Mesh, verification: Verification,
                    makers: dict[Maker, range] | None = None, view: View | None = None) -> Scene:
    """Return a picture of a mesh of `pslg`: faces by feature size, T-vertices, both nearest pairs with their distances.

    Where a pair is too near to be seen there is a panel of its surroundings. `makers` says who placed which vertex.
    """
    given = len(pslg.vertices)
    by = makers or {"given": range(min(given, len(mesh.vertices))), "steiner": range(given, len(mesh.vertices))}
    both = verification.input_mfs, verification.mesh_mfs
    looks = face_looks(mesh.vertices, mesh.faces, both[0].squared if both[0] else mpq(0))

    def panel(part: View, title: str) -> Panel:
        canvas = mesh_canvas(part, pslg, mesh, looks, by)
        draw_witnesses(canvas, pslg, mesh, *both)
        return canvas.panel("mesh", title)

    whole = view or view_of(mesh.vertices)
    close: list[Panel] = []
    reach = max(whole.high.x - whole.low.x, whole.high.y - whole.low.y)
    names = ("around the mfs of the input", "around the mfs of the mesh")
    for nearest, name, points in zip(both, names, (pslg.vertices, mesh.vertices), strict=True):
        if view is None and nearest is not None and nearest.squared < (reach * _TINY) ** 2:
            close.append(panel(_close(points, nearest), name))
    rows = ((panel(whole, ""),), tuple(close)) if close else ((panel(whole, ""),),)
    return Scene(_mesh_title(pslg, verification), rows)


def picture_of_run(run: Run, step: str = "mesh", view: View | None = None) -> Scene:
    """Return a picture of one step of a run, or of all with `step` "all", each in its panel.

    Raises `InputError` for a step that the construction does not have, and what the steps raise.
    """
    name = run.pslg.name
    if step == "all":
        part = view or view_of(run.pslg.vertices, _SMALL)
        panels = tuple(step_panel(run, each, part) for each in steps_in_turn(run))
        title = f"{name + ': ' if name else ''}{run.construction} construction, step by step"
        return Scene(title, in_rows(panels, _COLUMNS))
    if step == "mesh":
        return picture_of_mesh(run.pslg, run.mesh, run.verification, makers_of(run), view)
    panel = step_panel(run, step, view or view_of(run.pslg.vertices))
    return Scene(f"{name + ', ' if name else ''}{panel.title}", ((replace(panel, title=""),),))


def svg_from_mesh(pslg: Pslg, mesh: Mesh, verification: Verification, makers: dict[Maker, range] | None = None
                  ) -> str:
    """Return `picture_of_mesh` as SVG."""
    return svg_text(picture_of_mesh(pslg, mesh, verification, makers))


def _close(points: Sequence[Point], nearest: Nearest) -> View:
    """Return a view of the surroundings of a nearest pair; how wide it is need not be exact."""
    p = points[nearest.vertex]
    q = foot(p, *(points[v] for v in nearest.feature))
    return around(Point((p.x + q.x) / 2, (p.y + q.y) / 2), _ROOM * sqrt_below(nearest.squared, 20), _CLOSE)


def _mesh_title(pslg: Pslg, verification: Verification) -> str:
    text = f"{verification.faces} faces, {verification.steiner} Steiner vertices"
    if verification.degradation_squared is not None:
        text += f", degradation {sqrt_text(verification.degradation_squared, 6)}"
    if not verification.valid:
        text += ", not valid"
    return f"{pslg.name + ': ' if pslg.name else ''}{text}"
