"""Figures 4 and 5: the offset curve P2 and its refinement P3; what Appendix A says of them."""

from exactmesh.claims.run import Run
from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point
from exactmesh.numbers.algebraic import sqrt
from exactmesh.numbers.rational import sqrt_text
from exactmesh.pictures.canvas import foot
from exactmesh.pictures.curve import near, span
from exactmesh.pictures.palette import ORANGE, RED
from exactmesh.pictures.scene import Panel, Scene
from exactmesh.pictures.view import View, view_of
from exactmesh.reproduce.figure_kit import DIGITS, HALL, Figure, Parts, degradation, part, run_of, witness
from exactmesh.steps.curve_view import p3_of, rings_of, straights_of


def figure_4() -> Figure:
    """A polygon and P2."""
    parts = Parts()
    run = run_of(HALL, "paper")
    panel = parts.panel(run, "P2", "", view_of(HALL.vertices, 800.0))
    return parts.figure("fig-04", "Figure 4", Scene(
        "Figure 4: a polygon P and the curve P2 at distance mfs(P)/4", ((panel,),),
        ("A segment for each edge, an arc for each reflex vertex.",)))


def figure_4_fails() -> Figure:
    """A triangle whose P2 has edges shorter than 1/2."""
    parts = Parts()
    run = run_of(witness("triangle-13-14-15"), "paper")
    view = view_of(run.pslg.vertices, 480.0)
    canvas = parts.canvas(run, "P2", view)
    for straight in straights_of(rings_of(run.paper.shape, run.paper.curve)):
        length = sqrt(straight.length_squared() / run.mfs.squared)
        a, b = near(straight.start), near(straight.end)
        canvas.note(view.place(Point((a.x + b.x) / 2, (a.y + b.y) / 2)), f"|e'| = {length.decimal(6)} mfs", RED)
    repaired = run_of(run.pslg, "repaired")
    claims = ("appendix-a.offset-edge-length", "appendix-a.both-angles-acute",
              "appendix-a.next-edge-misses-quarter-circle", "appendix-a.sine")
    return parts.figure("fig-04-fails", "Figure 4, Appendix A", Scene(
        "Figure 4, companion: a triangle, where the edges of P2 are shorter than mfs/2",
        ((canvas.panel("P2", "P2 of the triangle with sides 13 : 14 : 15"),
          parts.panel(repaired, "mesh", f"repaired: left as it is, {degradation(repaired)}", view)),),
        tuple(parts.judged(claim, run) for claim in claims)), claims)


def figure_5() -> Figure:
    """P2 to P3 at a wide and at a narrow arc."""
    parts = Parts()
    run = run_of(HALL, "paper")
    panels = [_arc(parts, run, part(low, high, 460.0), title) for low, high, title in (
        (("6", "1.7"), ("8", "3.7"), "over 90 degrees: two chords"),
        (("4", "0.5"), ("6", "2.5"), "under 90 degrees: its neighbours meet"))]
    return parts.figure("fig-05", "Figure 5", Scene(
        "Figure 5: from P2 to P3", (tuple(panels),),
        ("Chords through the middle of a wide arc; for a narrow one the segments beside it are prolonged until they "
         "meet.",)))


def figure_5_fails() -> Figure:
    """In triangles, different edges of P3 come nearer than stated."""
    parts = Parts()
    run = run_of(witness("triangle-51-52-53"), "paper")
    view = view_of(run.pslg.vertices, 480.0)
    canvas = parts.canvas(run, "P3", view)
    p3 = p3_of(rings_of(run.paper.shape, run.paper.curve))
    places = [near(place) for place in p3.places]
    # P3 is a triangle: its nearest pair is the least of its heights.
    pairs = [(places[v], foot(places[v], places[v - 1], places[v - 2])) for v in range(3)]
    p, q = min(pairs, key=lambda pair: distance_squared(*pair))
    canvas.distance(p, q, f"{sqrt_text(distance_squared(p, q) / run.mfs.squared, DIGITS)} mfs")
    repaired = run_of(run.pslg, "repaired")
    claims = ("section-2.p3-separation", "section-2.p3-through-interior")
    octagon = run_of(witness("long-teeth"), "paper")
    return parts.figure("fig-05-fails", "Figure 5", Scene(
        "Figure 5, companion: edges of P3 that are nearer than stated, in a triangle",
        ((canvas.panel("P3", "P3 of the triangle with sides 51 : 52 : 53"),
          parts.panel(repaired, "mesh", f"repaired: left as it is, {degradation(repaired)}", view)),),
        (*(parts.judged(claim, run) for claim in claims),
         parts.judged("section-2.p3-octagon-reason", octagon))), (*claims, "section-2.p3-octagon-reason"))


def _arc(parts: Parts, run: Run, view: View, title: str) -> Panel:
    """Return P3 around a reflex corner, with the span of its arc."""
    canvas = parts.canvas(run, "P3", view)
    for ring in rings_of(run.paper.shape, run.paper.curve):
        for corner in ring:
            if corner.record.arc is not None and view.holds(view.place(corner.p)):
                ends = [near(end) for end in corner.record.arc]
                canvas.edges("radius", ((corner.p, end) for end in ends), ORANGE, 0.8, (3, 3))
                canvas.angle(corner.p, ends[0], ends[1], f"{span(corner):.1f}°", ORANGE)
                for place, name in zip(corner.record.vertices, ("a1", "m", "a2") if len(
                        corner.record.vertices) == 3 else ("",), strict=True):
                    if name:
                        canvas.note(view.place(near(place)), name)
    return canvas.panel("P3", title)

