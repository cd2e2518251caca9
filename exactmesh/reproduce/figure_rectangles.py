"""Figures 1 to 3: kinds of triangulations, and rectangles with vertices on one side (Lemma 3)."""

from collections.abc import Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import face_witness
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text
from exactmesh.paper import PaperOptions
from exactmesh.pictures.canvas import Canvas
from exactmesh.pictures.faces import face_looks
from exactmesh.pictures.palette import BLUE, INK
from exactmesh.pictures.scene import Panel, Scene
from exactmesh.pictures.view import View, view_of, window
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.pslg import Pslg, polygon
from exactmesh.reproduce.figure_kit import DIGITS, Figure, Parts, degradation, part, run_of, value_text, witness
from exactmesh.steps.constants import FEATURE
from exactmesh.steps.layered_rectangle import triangulate_in_layers
from exactmesh.steps.lemma_3 import Teeth, triangulate_rectangle
from exactmesh.steps.one_sided import triangulate_one_sided
from exactmesh.steps.records import UnitPiece

_WIDE = 960.0


@dataclass(frozen=True, slots=True)
class _Box:
    """A rectangle of a height with positions w = 1 apart on its lower side."""

    positions: int
    height: mpq

    @property
    def given(self) -> list[Point]:
        """The positions, then the upper corners."""
        last = mpq(self.positions - 1)
        return [*(Point(mpq(j), mpq(0)) for j in range(self.positions)), Point(mpq(0), self.height),
                Point(last, self.height)]


# Figure 2 has 66 positions; the height is not given, this one is ours. A flat one needs nested apexes.
_BOX = _Box(66, mpq(13))
_FLAT = _Box(40, mpq(3, 4))


def figure_1() -> Figure:
    """Classic, proper, nonproper."""
    pslg = polygon([(0, 0), (7, 0), (7, 3), (4, 3), (4, 1), (3, 3), (0, 3)], "room")
    parts = Parts()
    panels, words = [], []
    for kind in ("classic", "proper", "nonproper"):
        run = run_of(pslg, "classic" if kind == "classic" else "repaired", kind)
        panels.append(parts.panel(run, "mesh", f"{kind}: {degradation(run)}", view_of(pslg.vertices, 430.0)))
        on_sides = len(face_looks(run.mesh.vertices, run.mesh.faces, mpq(1)).on_sides)
        words.append(f"{kind}: {len(run.mesh.faces)} faces, {run.verification.steiner} Steiner vertices, "
                     f"{on_sides} of them on sides of faces")
    return parts.figure("fig-01", "Figure 1", Scene(
        "Figure 1: classic, proper and nonproper triangulations of one polygon", (tuple(panels),),
        ("; ".join(words) + ".",)))


def figure_2() -> Figure:
    """A fan, layers, Lemma 3, and why vertices must not be put on the boundary."""
    count = _BOX.positions
    positions, last = range(count), count - 1
    fan = UnitPiece((*((count, j, j + 1) for j in range(last)), (last, count + 1, count)), ())
    layers, nested = triangulate_in_layers(positions), triangulate_rectangle(positions)
    rows = [(_rectangle(piece, name),) for piece, name in (
        (fan, "(A) the fan from a corner"), (layers, "(B) layers, each with half as many vertices: proper, O(log n)"),
        (nested, "(C) Lemma 3: edges to (2^i w, h/3) from the upper left corner, teeth below"))]
    parts = Parts()
    run = run_of(_long_room(), "repaired", "internal")
    inside = run_of(_long_room(), "repaired")
    rows += [(parts.panel(run, "mesh", f"(D) vertices on the upper wall too, for the ifs only: {degradation(run)}",
                          view_of(run.pslg.vertices, _WIDE)),),
             (parts.panel(inside, "mesh", f"(D) none on the boundary: {degradation(inside)}",
                          view_of(run.pslg.vertices, _WIDE)),)]
    return parts.figure("fig-02", "Figure 2", Scene(
        f"Figure 2: a rectangle with {count} positions on one side, and why none may be added on the others",
        tuple(rows), (
            f"In (A) to (C) w = 1 and h = {_BOX.height}. (D) is a long room seen from outside: behind its upper wall "
            "the outside is a sharp wedge, so a vertex put on that wall comes near the other side of the wedge.",)))


def figure_2_fails() -> Figure:
    """What Lemma 3's teeth lose, and the routine that replaces it."""
    kinds: tuple[tuple[Teeth, str], ...] = (
        ("midpoint", "Lemma 3, teeth over the middle of each gap"),
        ("retiled", "Lemma 3 with the middles of g_i as the tips of the teeth beside them"))
    rows = [(_rectangle(triangulate_rectangle(range(_BOX.positions), teeth), title),) for teeth, title in kinds]
    rows += [(_repaired_rectangle(_BOX, "the repaired routine, Lemma 3*: here a fan keeps enough"),),
             (_repaired_rectangle(_FLAT, "the left end of a flat rectangle, h = 3/4: nested apexes",
                                  part(("-0.3", "-0.2"), ("14", "1"), _WIDE)),)]
    f1, f2 = _f1(), _f2()
    parts = Parts()
    claims = {"lemma-3.feature-size": "long-teeth", "lemma-3.hypothesis": "inner-corner",
              "phase-4.vertex-count": "one-far-vertex", "theorem-1.steiner-count": "one-far-vertex"}
    return parts.figure("fig-02-fails", "Figure 2", Scene(
        "Figure 2, companion: Lemma 3's bound with either sort of teeth, and the repaired routine", tuple(rows), (
            f"Lemma 3 states min(f1, f2) = {sqrt_text(min(f1, f2), DIGITS)} for w = 1, h = {_BOX.height}: "
            f"f1 = {sqrt_text(f1, DIGITS)}, f2 = {sqrt_text(f2, DIGITS)}. Its text leaves open how teeth meet g_i and "
            "how the right end is closed. The repaired routine takes the first triangulation that keeps g/5 = "
            f"{value_text(FEATURE)}: a fan, or one apex over each gap at most, for any gaps and slanted sides.",
            *(parts.judged(claim, run_of(witness(name), "paper")) for claim, name in claims.items()))), tuple(claims))


def figure_3() -> Figure:
    """The leftmost teeth, and the distance that is said to be the least."""
    canvas, points, faces = _close_up("midpoint")
    right = _right_component(points, faces)
    canvas.nearest(points, face_witness(points, right), "claimed", "at its right side:", BLUE)
    return Figure("fig-03", "Figure 3", Scene(
        "Figure 3: closeup of Figure 2 (C), the leftmost teeth",
        ((canvas.panel("lemma-3", "between g_0 and g_2"),),), (
            "Blue: the least distance in the right-hand component of the leftmost sawtooth, which is said to be the "
            f"least of all teeth, at least f2 = {sqrt_text(_f2(), DIGITS)}.",)))


def figure_3_fails() -> Figure:
    """The least distance is at the left end, and less than stated."""
    claimed, points, faces = _close_up("midpoint")
    claimed.nearest(points, face_witness(points, _right_component(points, faces)), "claimed", "said to be least:", BLUE)
    least = _least(points, [face for face in faces if _is_tooth(face)])
    x = points[least.vertex].x
    canvas = _base(window(Point(x - mpq(5, 2), mpq(-3, 5)), Point(x + mpq(5, 2), mpq(48, 5)), 640.0), points, faces)
    canvas.nearest(points, least, "witness", "least:")
    again, retiled, others = _close_up("retiled")
    again.nearest(retiled, _least(retiled, [face for face in others if _is_tooth(face)]), "witness", "least:")
    parts = Parts()
    pslg = witness("long-teeth")
    view = part(("3.1", "0.5"), ("3.8", "1.2"), 420.0)
    runs = [(run_of(pslg, "paper"), {}, "paper"),
            (run_of(pslg, "paper", options=PaperOptions(teeth="retiled")), {"teeth": "retiled"}, "teeth re-tiled"),
            (run_of(pslg, "repaired"), {}, "repaired")]
    row = tuple(parts.panel(run, "mesh", f"{name}: {degradation(run)}", view, chosen) for run, chosen, name in runs)
    claims = ("lemma-3.teeth-distance", "phase-4.feature-size", "tube.feature-size", "theorem-1.degradation")
    return parts.figure("fig-03-fails", "Figure 3", Scene(
        "Figure 3, companion: the least distance is at the left end of the teeth",
        ((claimed.panel("lemma-3", "the leftmost teeth"), canvas.panel("lemma-3", "at the left end of the last teeth"),
          again.panel("lemma-3", "teeth re-tiled")), row),
        (parts.judged(claims[0], run_of(witness("three-columns"), "paper")),
         *(parts.judged(claim, runs[0][0]) for claim in claims[1:]))), claims)


def _long_room() -> Pslg:
    """Return a room whose lower wall has a vertex at each unit, and whose upper wall is a side of an outside wedge."""
    length = 48
    floor = [(i, 0) for i in range(length + 1)]
    return polygon([*floor, (length, 3), (2, 3), (length, 4), (length, 7), (-3, 7), (-3, 0)], "long room")


def _f1() -> mpq:
    """Return the square of Lemma 3's first term for w = 1."""
    return 1 / (1 + 36 / _BOX.height**2)


def _f2() -> mpq:
    """Return the square of Lemma 3's second term for w = 1."""
    return _BOX.height**2 / (4 * _BOX.height**2 + 9)


def _placed(piece: UnitPiece) -> tuple[list[Point], list[Cycle]]:
    """Return the points and faces of a triangulated rectangle: positions, upper corners, new vertices."""
    points = [*_BOX.given, *(Point(p.x, _BOX.height * p.y) for p in piece.steiner)]
    return points, _numbered(piece.faces, _BOX)


def _numbered(faces: Sequence[Cycle], box: _Box) -> list[Cycle]:
    """Return faces in which new vertices, negative numbers, follow the given ones."""
    return [tuple(v if v >= 0 else box.positions + 1 - v for v in face) for face in faces]


def _rectangle(piece: UnitPiece, title: str) -> Panel:
    return _drawn(*_placed(piece), _BOX, title)


def _repaired_rectangle(box: _Box, title: str, view: View | None = None) -> Panel:
    *side, a, b = box.given
    piece = triangulate_one_sided(side, a, b)
    return _drawn([*box.given, *piece.steiner], _numbered(piece.faces, box), box, title, view)


def _drawn(points: Sequence[Point], faces: Sequence[Cycle], box: _Box, title: str,
           view: View | None = None) -> Panel:
    canvas = _base(view or view_of(points, _WIDE), points, faces, box)
    least = _least(points, faces)
    canvas.nearest(points, least)
    return canvas.panel("lemma-3", f"{title}: mfs {sqrt_text(least.squared, DIGITS)} w, "
                        f"{len(points) - len(box.given)} new vertices")


def _base(view: View, points: Sequence[Point], faces: Sequence[Cycle], box: _Box = _BOX) -> Canvas:
    looks = face_looks(points, faces, mpq(1))
    canvas = Canvas(view, points, looks.corners)
    canvas.features(points, looks)
    count = box.positions
    corners = [points[v] for v in (0, count - 1, count + 1, count)]
    canvas.edges("input", zip(corners, [*corners[1:], corners[0]], strict=True), INK, 1.6)
    canvas.vertices(points, {"given": range(count + 2), "steiner": range(count + 2, len(points))},
                    looks.on_sides)
    return canvas


def _close_up(teeth: Teeth) -> tuple[Canvas, list[Point], list[Cycle]]:
    points, faces = _placed(triangulate_rectangle(range(_BOX.positions), teeth))
    view = part(("-0.3", "-0.6"), ("4.7", "9.6"), 640.0)
    canvas = _base(view, points, faces)
    for text, x in (("g_0", 1), ("g_1", 2), ("g_2", 4)):
        canvas.word(view.place(Point(mpq(x), mpq(11, 5))), text)
    return canvas, points, faces


def _is_tooth(face: Cycle) -> bool:
    """Return whether a face is away from the upper corners."""
    return not {_BOX.positions, _BOX.positions + 1} & set(face)


def _right_component(points: Sequence[Point], faces: Sequence[Cycle]) -> Cycle:
    """Return the face of the leftmost sawtooth, between g_0 and g_1, that has the lower half of g_1 for a side."""
    low, high = Point(mpq(2), mpq(0)), Point(mpq(2), _BOX.height / 3)
    return next(face for face in faces if {low, high} <= {points[v] for v in face}
                and all(points[v].x <= 2 for v in face))


def _least(points: Sequence[Point], faces: Sequence[Cycle]) -> Nearest:
    """Return the nearest pair of all faces, the first one of the same distance."""
    return min((face_witness(points, face) for face in faces), key=lambda near: near.squared)
