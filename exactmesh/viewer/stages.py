"""The steps of a construction as things to draw, by the numbers of vertices and faces of the finished mesh.

The vertices of every step are vertices of the mesh, but for the paper's P2 and P3, which are algebraic: their vertices
are `extra`, numbered after those of the mesh.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from exactmesh.claims.run import Run
from exactmesh.numbers.root import exact_text, number_text
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge, Pslg
from exactmesh.steps.paper_interior_check import boundary
from exactmesh.steps.records import Offset, OffsetCurve, PaperTube, Phase, RealPoint

# Digits of an algebraic coordinate that is to be drawn; the exact expression goes with it.
_DIGITS = 24
_PHASES: tuple[tuple[str, str, tuple[Phase, ...]], ...] = (
    ("Tube, phase 1", "reflex corners are joined to the chords of their arcs", ("fan",)),
    ("Tube, phase 2", "triangles at the ends of the tops are cut off, rests beside the rectangles are left",
     ("cut", "rest")),
    ("Tube, phase 3", "one vertex in each quasi-trapz without vertices on its sides", ("tall", "low")),
    ("Tube, phase 4", "the rectangles are filled", ("rectangle",)))


@dataclass(frozen=True, slots=True)
class Stage:
    """One step: edges drawn strong, cycles outlined, the mesh's faces made before and in this step, arcs.

    `old` and `new` are half-open ranges of face numbers. An arc is (centre, start, end) and less than half a circle.
    """

    name: str
    says: str
    edges: tuple[Edge, ...] = ()
    cycles: tuple[Cycle, ...] = ()
    old: tuple[range, ...] = ()
    new: tuple[range, ...] = ()
    arcs: tuple[tuple[int, int, int], ...] = ()


@dataclass(frozen=True, slots=True)
class ExtraPoint:
    """A vertex that is not one of the mesh: exact expressions for reading, and decimals near them for drawing."""

    exact: tuple[str, str]
    near: tuple[str, str]


@dataclass(frozen=True, slots=True)
class Stages:
    """The stages in order, input first and finished mesh last."""

    stages: tuple[Stage, ...]
    extra: tuple[ExtraPoint, ...] = ()


def whole(pslg: Pslg | None, mesh: Mesh) -> Stages:
    """Return the stages of a mesh of which no construction is known: the input, if there is one, and the mesh."""
    given = (_input(pslg),) if pslg is not None else ()
    return Stages((*given, _finished(mesh)))


def stages_of(run: Run) -> Stages:
    """Return the stages of a run; raises what its steps raise."""
    match run.construction:
        case "repaired" | "coarse":
            return Stages((_input(run.pslg), *_repaired(run), _finished(run.mesh)))
        case "paper":
            curve = _Curve(run.paper.curve, run.paper.shape.origin, len(run.mesh.vertices))
            return Stages((_input(run.pslg), *curve.stages(), *_paper(run), _finished(run.mesh)), tuple(curve.extra))
    return whole(run.pslg, run.mesh)


def _input(pslg: Pslg) -> Stage:
    return Stage("Input", f"{len(pslg.vertices)} vertices and {len(pslg.edges)} edges", pslg.edges)


def _finished(mesh: Mesh) -> Stage:
    return Stage("Mesh", f"the finished {mesh.kind} mesh: {len(mesh.faces)} faces", new=(range(len(mesh.faces)),))


def _repaired(run: Run) -> Iterator[Stage]:
    made = run.repaired
    q, chords = ring_edges(made.offset), made.trapezoidation
    bare, interior = len(made.shape.triangles), len(made.interior.faces)
    yield Stage("Q", f"the inner offset on horizontal levels: {len(made.offset.points)} vertices", q)
    yield Stage("Trapezoids", f"chords at the levels cut the inside of Q into {len(chords.trapezoids)} trapezoids", q,
                tuple(map(boundary, chords.trapezoids)))
    inside = range(bare, bare + interior)
    yield Stage("Interior", f"the trapezoids triangulated: {interior} faces", q, new=(inside,))
    yield Stage("Tube", f"what lies between input and Q triangulated: {len(made.tube.faces)} faces", q, old=(inside,),
                new=(range(inside.stop, inside.stop + len(made.tube.faces)),))


def _paper(run: Run) -> Iterator[Stage]:
    made = run.paper
    p4, p5 = ring_edges(made.p4), made.trapezoidation
    inside = range(len(made.interior.faces))
    yield Stage("P4", "P3 with its vertices moved to the horizontal grid", p4)
    yield Stage("P5", f"the horizontal trapezoidation of P4: {len(p5.trapezoids)} trapezoids", p4,
                tuple(map(boundary, p5.trapezoids)))
    yield Stage("P6", f"the Interior: one vertex in each trapezoid, {len(inside)} faces", p4, new=(inside,))
    old: tuple[range, ...] = (inside,)
    for name, says, phases in _PHASES:
        new = _runs(made.tube, phases, len(inside))
        count = sum(map(len, new))
        yield Stage(name, f"{says}: {count} faces", p4, old=old, new=new)
        old += new


def _runs(tube: PaperTube, phases: tuple[Phase, ...], first: int) -> tuple[range, ...]:
    """Return the runs of faces that come from the given phases; the Tube's first face has the number `first`."""
    inside = [phase in phases for phase in tube.phase]
    changes = [i for i, (before, now) in enumerate(pairwise((False, *inside, False))) if before != now]
    return tuple(range(first + start, first + stop) for start, stop in zip(changes[::2], changes[1::2], strict=True))


def ring_edges(offset: Offset) -> tuple[Edge, ...]:
    """Return the edges of Q (or P4) in order."""
    return tuple((offset.first + k, offset.first + following) for k, following in enumerate(offset.successors()))


class _Curve:
    """P2 and P3 with the numbers of their vertices; `first` is the number of the first one."""

    def __init__(self, curve: OffsetCurve, origin: Sequence[int], first: int) -> None:
        self.curve = curve
        self.origin = origin
        self.first = first
        self.extra: list[ExtraPoint] = []
        self.number: dict[RealPoint, int] = {}

    def stages(self) -> Iterator[Stage]:
        """Yield P2 and P3."""
        arcs = tuple((self.origin[corner.corner], self._named(corner.arc[0]), self._named(corner.arc[1]))
                     for ring in self.curve.rings for corner in ring if corner.arc is not None)
        straight = self._edges([[self._numbers(corner.arc or corner.vertices) for corner in ring]
                                for ring in self.curve.rings], within=False)
        chords = self._edges([[self._numbers(corner.vertices) for corner in ring] for ring in self.curve.rings],
                             within=True)
        says = f"the offset at a quarter of the mfs: segments {len(straight)}, arcs {len(arcs)}"
        yield Stage("P2", says, straight, arcs=arcs)
        yield Stage("P3", "wide arcs become two chords, narrow ones are prolonged to a corner", chords)

    def _numbers(self, points: Iterable[RealPoint]) -> tuple[int, ...]:
        return tuple(map(self._named, points))

    def _named(self, point: RealPoint) -> int:
        number = self.number.setdefault(point, self.first + len(self.extra))
        if number == self.first + len(self.extra):
            x, y = point
            self.extra.append(ExtraPoint((exact_text(x), exact_text(y)),
                                         (number_text(x, _DIGITS), number_text(y, _DIGITS))))
        return number

    @staticmethod
    def _edges(rings: Iterable[Sequence[tuple[int, ...]]], within: bool) -> tuple[Edge, ...]:
        """Return the edges between consecutive corners of each ring, and `within` the corners too."""
        found: list[Edge] = []
        for ring in rings:
            for here, following in zip(ring, (*ring[1:], ring[0]), strict=True):
                if within:
                    found += pairwise(here)
                found.append((here[-1], following[0]))
        return tuple(found)
