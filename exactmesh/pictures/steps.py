"""A panel for every step of a construction, by name.

paper      P, P2, P3, P4, P5, P6, the Tube's phase1 to phase4, tube (all phases), mesh
repaired   P, Q, trapezoids, interior, tube, mesh
classic    P, mesh
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.claims.run import REPAIRED_STEPS, Run
from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import decimal_text
from exactmesh.pictures.canvas import Canvas
from exactmesh.pictures.curve import arcs, near
from exactmesh.pictures.faces import FaceLooks, face_looks
from exactmesh.pictures.palette import BLUE, FAINT, GREEN, GREY, INK, ORANGE, PURPLE, RED, SKY, YELLOW, Maker, tint
from exactmesh.pictures.scene import Panel
from exactmesh.pictures.view import View
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.curve_view import p3_of, rings_of, straights_of
from exactmesh.steps.records import Offset, PaperTube, Phase, Trapezoid, Trapezoidation

PHASES: dict[Phase, tuple[int, str, str]] = {
    "fan": (1, tint(SKY, 0.6), "phase 1: fans"),
    "cut": (2, tint(ORANGE, 0.65), "phase 2: triangles cut off"),
    "rest": (2, tint(YELLOW, 0.7), "phase 2: beside R"),
    "tall": (3, tint(GREEN, 0.45), "phase 3: without vertices on the top"),
    "low": (3, tint(PURPLE, 0.5), "phase 3: below R"),
    "rectangle": (4, tint(BLUE, 0.4), "phase 4: rectangles R"),
}
# More lines of the grid than this are not drawn.
_GRID_LINES = 90


def step_names(run: Run) -> tuple[str, ...]:
    """Return the names of the steps of a run's construction, in order; the last is "mesh"."""
    return tuple(_steps_of(run))


def steps_in_turn(run: Run) -> tuple[str, ...]:
    """Return the steps without the one that only sums up those before it: the paper's Tube after its phases."""
    return tuple(step for step in step_names(run) if run.construction != "paper" or step != "tube")


def step_panel(run: Run, step: str, view: View, title: str = "") -> Panel:
    """Return a panel of one step.

    Raises `InputError` for a step that the construction does not have, and what the steps raise.
    """
    words, draw = _step(run, step)
    run.progress(f"drawing {step}")
    return draw(run, view).panel(step, title or f"{step}: {words}")


def step_canvas(run: Run, step: str, view: View) -> Canvas:
    """Return the canvas of one step, for more to be drawn on it; raises what `step_panel` raises."""
    return _step(run, step)[1](run, view)


def makers_of(run: Run) -> dict[Maker, range]:
    """Return the vertices of a run's mesh by who placed them."""
    total = len(run.mesh.vertices)
    if run.construction == "classic":
        return {"given": range(total)}
    if run.construction == "paper":
        firsts = [run.paper.p4.first, run.paper.trapezoidation.first, run.paper.interior.first,
                  run.paper.tube.patch.first]
    else:
        firsts = [record.first for record in (run.repaired.offset, run.repaired.trapezoidation, run.repaired.interior,
                                              run.repaired.tube)]
    names: tuple[Maker, ...] = ("given", "offset", "chord", "interior", "tube")
    return {name: range(*ends) for name, ends in zip(names, pairwise([0, *firsts, total]), strict=True)}


def draw_input(canvas: Canvas, pslg: Pslg, width: float = 1.8) -> None:
    """Draw the edges of a PSLG, its isolated vertices and its hole points."""
    points = pslg.vertices
    canvas.edges("input", ((points[u], points[v]) for u, v in pslg.edges), INK, width, key="P, the input")
    met = {v for edge in pslg.edges for v in edge}
    canvas.dots("isolated", (p for v, p in enumerate(points) if v not in met), INK, 2.6)
    canvas.dots("hole", pslg.holes, GREY, 3.0, "mark of a hole")


def mesh_canvas(view: View, pslg: Pslg, mesh: Mesh, looks: FaceLooks, makers: Mapping[Maker, Iterable[int]]) -> Canvas:
    """Return a drawing of a mesh: faces by feature size, vertices by maker, T-vertices ringed."""
    points = mesh.vertices
    canvas = Canvas(view, points, looks.corners)
    canvas.features(points, looks)
    draw_input(canvas, pslg, width=max(0.7, min(1.8, 0.3 * canvas.grain)))
    canvas.vertices(points, makers, looks.on_sides)
    return canvas


def draw_witnesses(canvas: Canvas, pslg: Pslg, mesh: Mesh, input_mfs: Nearest | None, mesh_mfs: Nearest | None) -> None:
    """Draw the nearest pair of a PSLG and that of a mesh of it, with their distances."""
    if input_mfs is not None:
        canvas.nearest(pslg.vertices, input_mfs, "input-witness", "mfs of the input")
    if mesh_mfs is not None:
        canvas.nearest(mesh.vertices, mesh_mfs, "witness", "mfs of the mesh")


def outline(z: Trapezoid) -> Cycle:
    """Return all vertices around a trapezoid, each once."""
    return tuple(dict.fromkeys((z.bl, *z.bottom, z.br, z.tr, *z.top[::-1], z.tl)))


def _input(run: Run, view: View) -> Canvas:
    canvas = Canvas(view)
    draw_input(canvas, run.pslg)
    canvas.dots("given", run.pslg.vertices, INK, canvas.radius)
    canvas.nearest(run.pslg.vertices, run.mfs, "input-witness", "mfs")
    return canvas


def _p2(run: Run, view: View) -> Canvas:
    canvas = _faint(run, view)
    _draw_p2(canvas, run)
    return canvas


def _p3(run: Run, view: View) -> Canvas:
    canvas = _faint(run, view)
    _draw_p2(canvas, run, faint=True)
    p3 = p3_of(rings_of(run.paper.shape, run.paper.curve))
    places = [near(place) for place in p3.places]
    canvas.edges("p3", ((places[u], places[v]) for u, v in p3.edges), PURPLE, 1.8, key="P3")
    canvas.dots("p3-vertex", places, PURPLE, 2.4)
    return canvas


def _p4(run: Run, view: View) -> Canvas:
    p4 = run.paper.p4
    canvas = _grid(run, view, p4)
    p3 = p3_of(rings_of(run.paper.shape, run.paper.curve))
    places = [near(place) for place in p3.places]
    canvas.edges("p3", ((places[u], places[v]) for u, v in p3.edges), tint(PURPLE, 0.5), 1.2, (3, 3), "P3")
    _draw_ring(canvas, run.paper.points, p4, "P4")
    canvas.edges("motion", ((p, q) for p, q in zip(places, p4.points, strict=True) if p != q), RED, 1.6,
                 key="vertices snap")
    return canvas


def _p5(run: Run, view: View) -> Canvas:
    return _trapezoids(run, view, run.paper.p4, run.paper.trapezoidation, "P4")


def _p6(run: Run, view: View) -> Canvas:
    return _patch(run, view, run.paper.interior.faces, run.paper.p4, "P4", ("given", "offset", "chord", "interior"))


def _q(run: Run, view: View) -> Canvas:
    canvas = _grid(run, view, run.repaired.offset)
    _draw_ring(canvas, run.mesh.vertices, run.repaired.offset, "Q")
    return canvas


def _trapezoids_of_q(run: Run, view: View) -> Canvas:
    return _trapezoids(run, view, run.repaired.offset, run.repaired.trapezoidation, "Q")


def _interior(run: Run, view: View) -> Canvas:
    made = run.repaired
    return _patch(run, view, made.interior.faces, made.offset, "Q", ("given", "offset", "chord", "interior"))


def _tube(run: Run, view: View) -> Canvas:
    return _patch(run, view, run.repaired.tube.faces, run.repaired.offset, "Q", tuple(makers_of(run)))


def _phase(number: int) -> Callable[[Run, View], Canvas]:
    def draw(run: Run, view: View) -> Canvas:
        return _phases(run, view, range(1, number + 1))

    return draw


def _all_phases(run: Run, view: View) -> Canvas:
    return _phases(run, view, range(1, 5))


def _mesh(run: Run, view: View) -> Canvas:
    found = run.verification
    looks = face_looks(run.mesh.vertices, run.mesh.faces, run.mfs.squared)
    canvas = mesh_canvas(view, run.pslg, run.mesh, looks, makers_of(run))
    draw_witnesses(canvas, run.pslg, run.mesh, found.input_mfs, found.mesh_mfs)
    return canvas


_STEPS: dict[str, dict[str, tuple[str, Callable[[Run, View], Canvas]]]] = {
    "paper": {
        "P": ("the input", _input),
        "P2": ("the offset curve at mfs/4", _p2),
        "P3": ("arcs become chords or corners", _p3),
        "P4": ("P3 snapped to the grid", _p4),
        "P5": ("horizontal trapezoidation", _p5),
        "P6": ("a vertex in every trapezoid", _p6),
        "phase1": ("fans, quasi-trapz", _phase(1)),
        "phase2": ("triangles cut off, rectangles R", _phase(2)),
        "phase3": ("Steiner-free quasi-trapz", _phase(3)),
        "phase4": ("Lemma 3 in every rectangle", _phase(4)),
        "tube": ("the Tube, phase by phase", _all_phases),
        "mesh": ("the finished mesh", _mesh),
    },
    "repaired": {
        "P": ("the input", _input),
        "Q": ("the offset by an octagon, on levels", _q),
        "trapezoids": ("horizontal trapezoidation of Q", _trapezoids_of_q),
        "interior": ("the Interior, triangulated", _interior),
        "tube": ("the Tube, triangulated", _tube),
        "mesh": ("the finished mesh", _mesh),
    },
    "classic": {"P": ("the input", _input), "mesh": ("the finished mesh", _mesh)},
}


def _steps_of(run: Run) -> dict[str, tuple[str, Callable[[Run, View], Canvas]]]:
    return _STEPS["repaired" if run.construction in REPAIRED_STEPS else run.construction]


def _step(run: Run, step: str) -> tuple[str, Callable[[Run, View], Canvas]]:
    steps = _steps_of(run)
    if step not in steps:
        raise InputError(f"the {run.construction} construction has no step {step!r}; it has: {', '.join(steps)}")
    return steps[step]


def _faint(run: Run, view: View) -> Canvas:
    canvas = Canvas(view)
    draw_input(canvas, run.pslg)
    return canvas


def _grid(run: Run, view: View, q: Offset) -> Canvas:
    """Return a canvas with the input and the levels in the window, unless they are too many to see."""
    canvas = Canvas(view)
    # Heights are in units of the shape's own unit.
    unit = run.repaired.shape.unit if run.construction in REPAIRED_STEPS else mpq(1)
    step, shift = q.spacing * unit, q.shift
    first, last = (int(y / step - shift) for y in (view.low.y, view.high.y))
    if last - first <= _GRID_LINES:
        heights = [(level + shift) * step for level in range(first, last + 2)]
        canvas.edges("level", ((Point(view.low.x, y), Point(view.high.x, y)) for y in heights), FAINT, 0.7,
                     key=f"levels, {decimal_text(step, 6)} apart")
    draw_input(canvas, run.pslg)
    return canvas


def _draw_p2(canvas: Canvas, run: Run, faint: bool = False) -> None:
    rings = rings_of(run.paper.shape, run.paper.curve)
    share = 0.45 if faint else 1.0
    canvas.edges("p2", ((near(s.start), near(s.end)) for s in straights_of(rings)), tint(BLUE, share), 1.6,
                 key="P2" if faint else "P2: a segment for each edge")
    for _, chain in arcs(rings):
        canvas.edges("p2-arc", pairwise(chain), tint(ORANGE, max(share, 0.7)), 2.2,
                     key="P2, arcs" if faint else "P2: an arc for each reflex vertex")


def _ring_edges(points: Sequence[Point], q: Offset) -> Iterable[tuple[Point, Point]]:
    return ((points[q.first + k], points[q.first + after]) for k, after in enumerate(q.successors()))


def _draw_ring(canvas: Canvas, points: Sequence[Point], q: Offset, name: str) -> None:
    canvas.edges("ring", _ring_edges(points, q), BLUE, 1.8, key=name)
    canvas.vertices(points, {"offset": range(q.first, q.first + len(q.x))})


def _trapezoids(run: Run, view: View, q: Offset, chords: Trapezoidation, name: str) -> Canvas:
    points = run.mesh.vertices
    canvas = Canvas(view, points, map(outline, chords.trapezoids))
    with_t = [z for z in chords.trapezoids if z.bottom or z.top]
    clean = [z for z in chords.trapezoids if not (z.bottom or z.top)]
    for kind, group, fill, key in (("trapezoid", clean, tint(GREEN, 0.12), "trapezoids"),
                                   ("trapezoid-t", with_t, tint(ORANGE, 0.3), "trapezoids with T-vertices")):
        canvas.areas(kind, ([points[v] for v in outline(z)] for z in group), fill, GREEN, 0.9, key)
    draw_input(canvas, run.pslg)
    canvas.edges("ring", _ring_edges(points, q), BLUE, 1.6, key=name)
    ends = range(chords.first, chords.first + len(chords.points))
    canvas.vertices(points, {"offset": range(q.first, q.first + len(q.x)), "chord": ends},
                    sorted({v for z in with_t for v in (*z.bottom, *z.top)}))
    return canvas


def _patch(run: Run, view: View, faces: Sequence[Cycle], q: Offset, name: str, makers: Sequence[Maker]) -> Canvas:
    points = run.mesh.vertices
    looks = face_looks(points, faces, run.size.squared)
    canvas = Canvas(view, points, looks.corners)
    canvas.features(points, looks)
    draw_input(canvas, run.pslg)
    canvas.edges("ring", _ring_edges(points, q), BLUE, 1.4, key=name)
    used = {v for face in faces for v in face}
    by_maker = makers_of(run)
    canvas.vertices(points, {maker: [v for v in by_maker[maker] if v in used] for maker in makers},
                    looks.on_sides)
    return canvas


def _phases(run: Run, view: View, numbers: range) -> Canvas:
    made = run.paper
    tube: PaperTube = made.tube
    points = made.points
    canvas = Canvas(view, points, tube.patch.faces)
    faces: dict[Phase, list[Cycle]] = {phase: [] for phase in PHASES}
    for face, phase in zip(tube.patch.faces, tube.phase, strict=True):
        faces[phase].append(face)
    for phase, (number, fill, key) in PHASES.items():
        if number in numbers:
            canvas.areas(f"phase-{phase}", ([points[v] for v in face] for face in faces[phase]), fill, INK, 0.35, key)
    rectangles = [] if numbers[-1] < 2 else tube.rectangles
    canvas.edges("rectangle", (pair for r in rectangles for pair in pairwise(
        points[v] for v in (r.side[0], r.side[-1], r.a_below, r.b_below, r.side[0]))), INK, 1.3)
    if numbers[-1] == 1:
        canvas.areas("quasi-trapz", ([points[v] for v in cycle] for cycle in quasi_trapz(run)), tint(GREEN, 0.12),
                     key="quasi-trapz")
        canvas.edges("spoke", spokes(run), GREEN, 1.5, key="spokes")
    draw_input(canvas, run.pslg)
    canvas.edges("ring", _ring_edges(points, made.p4), BLUE, 1.5, key="P4")
    used = {v for phase in PHASES if PHASES[phase][0] in numbers for face in faces[phase] for v in face}
    canvas.vertices(points, {maker: [v for v in of if maker != "tube" or v in used]
                             for maker, of in makers_of(run).items() if maker != "interior"})
    return canvas


def spokes(run: Run) -> list[tuple[Point, Point]]:
    """Return the edges between corners of P and the first and last vertex that each has on P4."""
    made = run.paper
    p4, points = made.p4, made.points
    before = {after: k for k, after in enumerate(p4.successors())}
    return [(points[made.shape.origin[corner]], points[p4.first + k])
            for k, (corner, source) in enumerate(zip(p4.corner, p4.source, strict=True))
            if source >= 0 or p4.source[before[k]] >= 0]


def quasi_trapz(run: Run) -> list[Cycle]:
    """Return the paper's quasi-trapz: an edge of P, and the edge of P4 along it with its two ends only."""
    made = run.paper
    p4, origin = made.p4, made.shape.origin
    return [(origin[source], origin[source ^ 1], p4.first + after, p4.first + k)
            for k, (source, after) in enumerate(zip(p4.source, p4.successors(), strict=True)) if source >= 0]
