"""Figures 6 to 10: the Tube in its four phases, on real runs, with its angles and distances."""

from collections.abc import Iterator, Sequence
from math import acos, degrees, hypot

from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.geometry.distance import distance_squared, line_distance_squared
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.measure.face_feature import face_witness
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text
from exactmesh.paper import PaperOptions
from exactmesh.pictures.canvas import Canvas, foot
from exactmesh.pictures.curve import near, span
from exactmesh.pictures.palette import BLUE, GREEN, INK, ORANGE, RED
from exactmesh.pictures.scene import Scene
from exactmesh.pictures.view import view_of
from exactmesh.planar.cycles import Cycle
from exactmesh.reproduce.figure_kit import DIGITS, HALL, Figure, Parts, degradation, part, run_of, witness
from exactmesh.steps.curve_view import rings_of
from exactmesh.steps.records import Phase, RealPoint, Rectangle

_REPAIRED = "repaired: one routine for the whole quasi-trapz"


def figure_6() -> Figure:
    """The Tube cut into fans and quasi-trapz."""
    parts = Parts()
    run = run_of(HALL, "paper")
    canvas = parts.canvas(run, "phase1", view_of(HALL.vertices, 860.0))
    for ring in rings_of(run.paper.shape, run.paper.curve):
        for corner in ring:
            if corner.record.arc is not None:
                canvas.note(canvas.view.place(corner.p), f"arc of {span(corner):.1f}°", ORANGE)
    return parts.figure("fig-06", "Figure 6", Scene(
        "Figure 6: phase 1 cuts the Tube into fans and quasi-trapz", ((canvas.panel("phase1", ""),),),
        ("A chain that replaced an arc over 90 degrees is seen from its reflex vertex, a fan; all else are quasi-trapz "
         "with an edge of P for the bottom and one of P4 for the top. Angles are spans of arcs.",)))


def figure_7() -> Figure:
    """A fan with its angles and least distances."""
    parts = Parts()
    run = run_of(HALL, "paper")
    view = part(("6.3", "2.4"), ("7.7", "3.2"), 860.0)
    canvas = parts.canvas(run, "phase1", view)
    _draw_fan(canvas, run)
    return parts.figure("fig-07", "Figure 7", Scene(
        "Figure 7: a fan, the angles between its edges and P4, and its least distances",
        ((canvas.panel("phase1", ""),),), (
            "Before snapping the angles are at least 45 degrees; these are after it. Blue: P4; red: the least distance "
            f"in each triangle, in units of the mfs. The reflex vertex is at (7, 3) of {HALL.name}.",)))


def figure_7_fails() -> Figure:
    """A snapped fan that keeps less than stated."""
    parts = Parts()
    run, repaired = run_of(witness("snapped-fan"), "paper"), run_of(witness("snapped-fan"), "repaired")
    view = part(("3.85", "1.87"), ("4.25", "2.17"), 560.0)
    canvas = parts.canvas(run, "phase1", view)
    found = [face_witness(run.paper.points, face) for face in _faces(run, "fan")]
    _draw_nearest(canvas, run, min(found, key=lambda nearest: nearest.squared))
    claim = "phase-1.fan-feature-size"
    return parts.figure("fig-07-fails", "Figure 7", Scene(
        "Figure 7, companion: after snapping a fan keeps less than 1/(2 d3 sqrt 2)",
        ((canvas.panel("phase1", "the fan, snapped"),
          parts.panel(repaired, "mesh", f"repaired: {degradation(repaired)}", view)),),
        (parts.judged(claim, run),)), (claim,))


def figure_8() -> Figure:
    """Triangles cut off a quasi-trapz."""
    parts = Parts()
    run = run_of(HALL, "paper")
    panels = []
    for low, high, title in ((("-0.3", "2"), ("4.4", "6.2"), "until no Steiner vertex is left"),
                             (("8.2", "-0.2"), ("11.2", "6.2"), "until both angles are 135° or more")):
        canvas = parts.canvas(run, "phase2", part(low, high, 620.0))
        for left, top, right in _tops(run):
            for ends, beyond, at in (((top[0], top[1]), left, top[0]), ((top[-1], top[-2]), right, top[-1])):
                _angle(canvas, run, at, ends[1], beyond)
        panels.append(canvas.panel("phase2", title))
    return parts.figure("fig-08", "Figure 8", Scene(
        "Figure 8: phase 2 cuts triangles off a quasi-trapz Q", (tuple(panels),),
        ("At each end of the top, triangles are cut off until the angle is at least 135 degrees or there is no Steiner "
         "vertex left. Angles, rounded: at the ends of what is left of the top.",)))


def figure_8_fails() -> Figure:
    """The triangles cut off may be thinner than those of fans."""
    parts = Parts()
    run, narrow = run_of(witness("inner-corner"), "paper"), run_of(witness("narrow-cut"), "paper")
    canvas = parts.canvas(run, "phase2", part(("10", "3.2"), ("12.2", "4.8"), 470.0))
    points = run.paper.points
    for face in _faces(run, "cut"):
        _angle(canvas, run, *_flattest(points, face))
    other = parts.canvas(narrow, "phase2", part(("5.2", "1.6"), ("7.2", "3.1"), 470.0))
    for face in _faces(narrow, "cut"):
        _draw_nearest(other, narrow, face_witness(narrow.paper.points, face))
    repaired = run_of(witness("inner-corner"), "repaired")
    claims = ("phase-2.cut-angle", "phase-2.cut-feature-size")
    return parts.figure("fig-08-fails", "Figure 8", Scene(
        "Figure 8, companion: what is cut off is not like a fan",
        ((canvas.panel("phase2", "an angle below 45 degrees"), other.panel("phase2", "a distance below 0.067 mfs"),
          parts.panel(repaired, "mesh", _REPAIRED, part(("10", "3.2"), ("12.2", "4.8"), 470.0))),),
        tuple(parts.judged(claim, on) for claim, on in zip(claims, (run, narrow), strict=True))), claims)


def figure_9() -> Figure:
    """Q' is cut into R, Q'' and two triangles."""
    parts = Parts()
    run = run_of(witness("inner-corner"), "paper")
    canvas = parts.canvas(run, "phase2", part(("7.6", "0.7"), ("12.3", "4.4"), 860.0))
    (record,) = run.paper.tube.rectangles
    _name_corners(canvas, run, record)
    points = run.paper.points
    ends = [points[run.paper.shape.origin[h]] for h in (record.edge, record.edge ^ 1)]
    a, b, a_below, b_below = (points[v] for v in (record.side[-1], record.side[0], record.a_below, record.b_below))
    for text, corners in (("R", (a, b, a_below, b_below)), ("Q''", (a_below, b_below, *ends))):
        canvas.word(canvas.view.place(_middle(corners)), text, INK, 15)
    x, y = canvas.view.place(_middle(ends))
    canvas.word((x - 14, y + 12), "B", INK, 15)
    return parts.figure("fig-09", "Figure 9", Scene(
        "Figure 9: phase 2 cuts Q' into a rectangle R, a quasi-trapz Q'' and two triangles",
        ((canvas.panel("phase2", ""),),),
        ("a' and b' are 1/4 - 1/(2 d3) below a and b, hence 1/(2 d3) above B before snapping; R has the vertices of "
         "the top on one side.",)))


def figure_9_fails() -> Figure:
    """Before snapping a' may be near a spoke; snapping moves it farther than a."""
    parts = Parts()
    run, repaired = run_of(witness("inner-corner"), "paper"), run_of(witness("inner-corner"), "repaired")
    view = part(("7.6", "0.7"), ("12.3", "4.4"), 560.0)
    canvas = parts.canvas(run, "phase2", view)
    (record,) = run.paper.tube.rectangles
    before = _unsnapped(run, record)
    canvas.edges("unsnapped", zip(before, [*before[1:], before[0]], strict=True), ORANGE, 1.6, (5, 3),
                 key="R before snapping")
    points = run.paper.points
    for start, end in zip(before[2:], (points[record.b_below], points[record.a_below]), strict=True):
        moved = (start.x - end.x) ** 2 + (start.y - end.y) ** 2
        canvas.distance(start, end, f"moves by {sqrt_text(moved / run.mfs.squared, DIGITS)} mfs", "motion")
    claims = ("phase-2.inner-corner-distance", "phase-2.rectangle-motion")
    return parts.figure("fig-09-fails", "Figure 9", Scene(
        "Figure 9, companion: R does not move rigidly, and a' moves farther than a",
        ((canvas.panel("phase2", "R before and after snapping"), parts.panel(repaired, "mesh", _REPAIRED, view)),),
        (*(parts.judged(claim, run) for claim in claims), parts.judged("phase-2.motion-value", run))),
        (*claims, "phase-2.motion-value"))


def figure_10() -> Figure:
    """The vertex of Q'' at 1/(8 d3) above B."""
    parts = Parts()
    run = run_of(witness("inner-corner"), "paper")
    canvas = parts.canvas(run, "phase3", part(("7.6", "0.7"), ("12.3", "4.4"), 860.0))
    _draw_heights(canvas, run, "low", "1/(8 d3)")
    return parts.figure("fig-10", "Figure 10", Scene(
        "Figure 10: phase 3 puts one vertex into Q'', 1/(8 d3) above B", ((canvas.panel("phase3", ""),),),
        ("Its distance from B is given in units of the mfs, in which 1/(8 d3) is a quarter of the spacing of the grid, "
         f"{sqrt_text((run.paper.p4.spacing / 4) ** 2 / run.mfs.squared, DIGITS)}.",)))


def figure_10_fails() -> Figure:
    """A quasi-trapz without vertices on its top is too high for that rule."""
    parts = Parts()
    pslg = witness("leaning-roof")
    literal, lemma_1 = run_of(pslg, "paper", options=PaperOptions(tall="low")), run_of(pslg, "paper")
    repaired = run_of(pslg, "repaired")
    view = part(("0.7", "0.75"), ("1.3", "1.35"), 430.0)
    low = parts.canvas(literal, "phase3", view, {"tall": "low"})
    _draw_heights(low, literal, "tall", "1/(8 d3)", edge=3)
    high = parts.canvas(lemma_1, "phase3", view)
    _draw_heights(high, lemma_1, "tall", "half way up", edge=3)
    claim = "phase-3.low-vertex"
    return parts.figure("fig-10-fails", "Figure 10", Scene(
        "Figure 10, companion: a Steiner-free quasi-trapz that phase 2 left alone is about 1/4 high",
        ((low.panel("phase3", "the vertex at 1/(8 d3), to the letter"), high.panel("phase3", "Lemma 1's own vertex"),
          parts.panel(repaired, "mesh", f"repaired: {degradation(repaired)}", view)),),
        (parts.judged(claim, lemma_1), parts.judged("phase-3.value", lemma_1))), (claim, "phase-3.value"))


def _faces(run: Run, phase: Phase) -> Iterator[Cycle]:
    """Yield the faces of the Tube that a phase made."""
    tube = run.paper.tube
    for face, of in zip(tube.patch.faces, tube.phase, strict=True):
        if of == phase:
            yield face


def _draw_nearest(canvas: Canvas, run: Run, nearest: Nearest, colour: str = RED) -> None:
    """Draw a nearest pair with its distance in units of the mfs."""
    points = run.mesh.vertices
    p = points[nearest.vertex]
    q = foot(p, *(points[v] for v in nearest.feature))
    canvas.distance(p, q, f"{sqrt_text(nearest.squared / run.mfs.squared, DIGITS)} mfs", "witness", colour)


def _draw_fan(canvas: Canvas, run: Run) -> None:
    """Draw the edges of fans, their angles with P4 and the least distance in each triangle."""
    points = run.paper.points
    for face in _faces(run, "fan"):
        corner, later, earlier = face
        canvas.edges("fan-edge", ((points[corner], points[v]) for v in (later, earlier)), GREEN, 1.8)
        for at, beyond in ((later, earlier), (earlier, later)):
            _angle(canvas, run, at, beyond, corner)
        _draw_nearest(canvas, run, face_witness(points, face))


def _angle(canvas: Canvas, run: Run, at: int, p: int, q: int) -> None:
    """Mark the angle at a vertex between two others, in degrees, where it is in the panel."""
    points = run.paper.points
    if canvas.view.holds(canvas.view.place(points[at])):
        canvas.angle(points[at], points[p], points[q], f"{_degrees(points[at], points[p], points[q]):.1f}°", BLUE, 30)


def _degrees(at: Point, p: Point, q: Point) -> float:
    size = max(abs(z) for point in (p, q) for z in (point.x - at.x, point.y - at.y))
    (ax, ay), (bx, by) = ((float((z.x - at.x) / size), float((z.y - at.y) / size)) for z in (p, q))
    return degrees(acos(max(-1.0, min(1.0, (ax * bx + ay * by) / (hypot(ax, ay) * hypot(bx, by))))))


def _flattest(points: Sequence[Point], face: Cycle) -> tuple[int, int, int]:
    """Return the corner of a triangle cut off, at the vertex of the top that is cut to, and its two other vertices."""
    v, s, t = face
    return (s, t, v) if _degrees(points[s], points[t], points[v]) < _degrees(points[t], points[s], points[v]) else (
        t, s, v)


def _tops(run: Run) -> Iterator[tuple[int, tuple[int, ...], int]]:
    """Yield what is left of the tops that phase 2 worked on: the ends of the bottom beside it, and its vertices."""
    origin = run.paper.shape.origin
    for record in run.paper.tube.rectangles:
        yield origin[record.edge], record.side[::-1], origin[record.edge ^ 1]


def _name_corners(canvas: Canvas, run: Run, record: Rectangle) -> None:
    points = run.paper.points
    for name, v in (("a", record.side[-1]), ("b", record.side[0]), ("a'", record.a_below), ("b'", record.b_below)):
        canvas.note(canvas.view.place(points[v]), name, size=15)


def _middle(points: Sequence[Point]) -> Point:
    count = len(points)
    return Point(sum((p.x for p in points), mpq(0)) / count, sum((p.y for p in points), mpq(0)) / count)


def _unsnapped(run: Run, record: Rectangle) -> list[Point]:
    """Return about where a, b, b', a' would be on P3."""
    made = run.paper
    ring = made.curve.rings[0]
    at = next(i for i, corner in enumerate(ring) if corner.corner == record.edge)
    ends: tuple[RealPoint, RealPoint] = ring[at].vertices[-1], ring[(at + 1) % len(ring)].vertices[0]
    a, b = map(near, ends)
    p, q = (made.shape.points[made.shape.origin[h]] for h in (record.edge, record.edge ^ 1))
    # R is as high as the one that was built.
    points = made.points
    side, below = points[record.side[-1]], points[record.a_below]
    height = hypot(float(side.x - below.x), float(side.y - below.y))
    share = mpq(height / hypot(float(q.x - p.x), float(q.y - p.y)))
    down = Point((q.y - p.y) * share, -(q.x - p.x) * share)
    return [a, b, Point(b.x + down.x, b.y + down.y), Point(a.x + down.x, a.y + down.y)]


def _draw_heights(canvas: Canvas, run: Run, phase: Phase, text: str, edge: int | None = None) -> None:
    """Draw, for each vertex that phase 3 put into a quasi-trapz, its distance from the line of the bottom."""
    made = run.paper
    points, first = made.points, made.tube.patch.first
    for face in _faces(run, phase):
        new = [v for v in face if v >= first]
        ends = [v for v in face if v < len(made.shape.points)]
        wanted = edge is None or sorted(ends) == sorted(run.pslg.edges[edge])
        if len(new) == 1 and len(ends) == 2 and wanted:
            p, a, b = (points[v] for v in (new[0], *ends))
            squared = line_distance_squared(p, a, b) / run.mfs.squared
            canvas.edges("line-of-b", [(a, _line_foot(p, a, b))], INK, 1.0, (4, 3))
            canvas.distance(p, _line_foot(p, a, b), f"{text}: {sqrt_text(squared, DIGITS)} mfs", "height")


def _line_foot(p: Point, a: Point, b: Point) -> Point:
    """Return the foot of p on the line a b."""
    along = minus(b, a)
    t = dot(minus(p, a), along) / distance_squared(a, b)
    return Point(a.x + t * along.x, a.y + t * along.y)
