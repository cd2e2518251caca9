"""What the paper has no figure of and what decides: P5, P6 and Theorem 2, where they fail, and the repair."""

from collections.abc import Sequence

from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import face_witness
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text
from exactmesh.pictures.canvas import Canvas, foot
from exactmesh.pictures.faces import face_looks
from exactmesh.pictures.scene import Scene
from exactmesh.pictures.steps import outline
from exactmesh.pictures.view import view_of
from exactmesh.reproduce.figure_kit import DIGITS, Figure, Parts, degradation, part, run_of, witness
from exactmesh.reproduce.spread import l_shape

# Long enough for the degradation to pass 45, short enough to be seen.
_LENGTH = 44
_WIDE = 1000.0


def figure_p5_fails() -> Figure:
    """A chord end nearer to a side than the grid is wide."""
    parts = Parts()
    run, repaired = run_of(witness("parallelogram-flat"), "paper"), run_of(witness("parallelogram-flat"), "repaired")
    points = run.paper.points
    nearest = min((face_witness(points, outline(z)) for z in run.paper.trapezoidation.trapezoids),
                  key=lambda near: near.squared)
    p = points[nearest.vertex]
    view = part((f"{p.x - 1}", f"{p.y - 1}"), (f"{p.x + 1}", f"{p.y + 1}"), 480.0)
    canvas = parts.canvas(run, "P5", view)
    _draw(canvas, points, nearest, f"{sqrt_text(nearest.squared / run.paper.p4.spacing**2, DIGITS)} of the spacing")
    claims = ("section-2.p5-above-grid", "section-2.p5-feature-size")
    return parts.figure("p5-fails", "Section 2, P5 (no figure)", Scene(
        "P5 does not preserve the feature size of P4",
        ((canvas.panel("P5", "P5 around a chord end"),
          parts.panel(repaired, "mesh", f"repaired: {degradation(repaired)}", view)),),
        tuple(parts.judged(claim, run) for claim in claims)), claims)


def figure_p6_fails() -> Figure:
    """The one vertex of a long trapezoid is too far from its T-vertices."""
    parts = Parts()
    pslg = l_shape(_LENGTH)
    run, repaired = run_of(pslg, "paper"), run_of(pslg, "repaired")
    whole = view_of(pslg.vertices, _WIDE)
    corner = part(("0.6", "0.4"), ("3.6", "2.1"), 480.0)
    nearest = run.verification.mesh_mfs
    if nearest is None:
        raise AssertionError("the mesh of this room is valid")
    canvas = parts.canvas(run, "P6", corner)
    _draw(canvas, run.paper.points, nearest, f"{sqrt_text(nearest.squared / run.mfs.squared, DIGITS)} mfs")
    claims = ("section-2.p6-degradation", "section-2.interior-feature-size", "theorem-1.degradation")
    long = run_of(witness("l-shape-192"), "paper")
    return parts.figure("p6-fails", "Section 2, P6 (no figure)", Scene(
        "P6: T-vertices near the ends of long trapezoids make arbitrarily thin triangles", (
            (parts.panel(run, "P5", f"P5 of an L-shape of length {_LENGTH}", whole),),
            (parts.panel(run, "mesh", f"paper: {degradation(run)}", whole),),
            (parts.panel(repaired, "mesh", f"repaired: {degradation(repaired)}", whole),),
            (canvas.panel("P6", "P6 at the reflex corner"),
             parts.panel(repaired, "interior", "repaired, the same place", corner))),
        ("The trapezoid's one vertex is half its length away from the T-vertex at the reflex corner: the degradation "
         "grows with the length: exactmesh reproduce spread.", *(parts.judged(claim, long) for claim in claims))),
        claims)


def figure_theorem_2_fails() -> Figure:
    """Theorem 2's mesh is not proper in the Interior."""
    parts = Parts()
    pslg = witness("spike-room")
    run, repaired = run_of(pslg, "paper", "proper"), run_of(pslg, "repaired", "proper")
    view = part(("-0.2", "-0.2"), ("4", "2.2"), 560.0)
    count = len(face_looks(run.mesh.vertices, run.mesh.faces, run.mfs.squared).on_sides)
    claim = "theorem-2.only-rectangles"
    return parts.figure("theorem-2-fails", "Theorem 2 (no figure)", Scene(
        "Theorem 2: replacing the rectangles does not make the mesh proper",
        ((parts.panel(run, "mesh", f"paper: {count} vertices on sides of faces", view),
          parts.panel(repaired, "mesh", f"repaired: none, {degradation(repaired)}", view)),),
        (parts.judged(claim, run),)), (claim,))


def _draw(canvas: Canvas, points: Sequence[Point], nearest: Nearest, text: str) -> None:
    p = points[nearest.vertex]
    canvas.distance(p, foot(p, *(points[v] for v in nearest.feature)), text)
