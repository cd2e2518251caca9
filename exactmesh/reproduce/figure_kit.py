"""What all figures are made with: the record of one, panels of real runs with their commands, words from the ledger."""

import shlex
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from gmpy2 import mpq

from exactmesh.claims.claim import Claim
from exactmesh.claims.ledger import claim_by_id, judge_one
from exactmesh.claims.run import ConstructionName, Run, construction_for
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.geometry.point import Point
from exactmesh.io.read import read_pslg
from exactmesh.measure.verdict import Verdict
from exactmesh.numbers.rational import decimal_text, sqrt_text, text_from_rational
from exactmesh.paper import PaperOptions
from exactmesh.pictures.canvas import Canvas
from exactmesh.pictures.faces import face_looks
from exactmesh.pictures.scene import Panel, Scene
from exactmesh.pictures.steps import draw_witnesses, makers_of, mesh_canvas, step_canvas
from exactmesh.pictures.view import View, view_of, window
from exactmesh.planar.mesh import Kind
from exactmesh.planar.pslg import Pslg, polygon
from exactmesh.report import claim_json

DIGITS = 6
_LITERAL = PaperOptions()
# The room on which the figures of Section 2 are drawn: wide and narrow arcs, fans, quasi-trapz of every sort.
HALL = polygon([(0, 0), (5, 1), (11, 0), (11, 6), (8, 6), (7, 3), (6, 6), (4, 6), (0, 3)], "hall")


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure with all that is said of it.

    `paper` is the place in the paper, `commands` draw its panels from `inputs` (by file name), `refuted` are the claims
    whose failure it shows.
    """

    name: str
    paper: str
    scene: Scene
    commands: tuple[str, ...] = ()
    inputs: Mapping[str, Pslg] = field(default_factory=dict)
    refuted: tuple[str, ...] = ()

    @property
    def title(self) -> str:
        """The title of the picture."""
        return self.scene.title


class Parts:
    """The panels of one figure, with the commands that draw them alone and the inputs these read."""

    def __init__(self) -> None:
        self.commands: list[str] = []
        self.inputs: dict[str, Pslg] = {}

    def input_path(self, pslg: Pslg) -> str:
        """Return the file, in the folder of figures, that holds an input; inputs with one name are one."""
        name = "".join(c if c.isalnum() else "-" for c in pslg.name.lower())
        self.inputs[name] = pslg
        return f"inputs/{name}.json"

    def canvas(self, run: Run, step: str, view: View | None = None, paper: Mapping[str, str] | None = None) -> Canvas:
        """Return the canvas of a step of a run, and note the command that draws it."""
        self._note(run, step, view, paper or {})
        if step == "mesh":
            part = view or view_of(run.mesh.vertices, 520.0)
            looks = face_looks(run.mesh.vertices, run.mesh.faces, run.mfs.squared)
            canvas = mesh_canvas(part, run.pslg, run.mesh, looks, makers_of(run))
            draw_witnesses(canvas, run.pslg, run.mesh, None, run.verification.mesh_mfs)
            return canvas
        return step_canvas(run, step, view or view_of(run.pslg.vertices, 520.0))

    def panel(self, run: Run, step: str, title: str, view: View | None = None,
              paper: Mapping[str, str] | None = None) -> Panel:
        """Return `canvas` as a panel."""
        return self.canvas(run, step, view, paper).panel(step, title)

    def judged(self, claim: str, run: Run) -> str:
        """Note the command that judges a claim on a run's input, and say what it finds."""
        path = self.input_path(run.pslg)
        self._add(["exactmesh", "claims", claim, "--on", path, "--construction", run.construction])
        return judged(claim, run)

    def figure(self, name: str, paper: str, scene: Scene, refuted: Sequence[str] = ()) -> Figure:
        """Return the figure made of the panels so far."""
        return Figure(name, paper, scene, tuple(self.commands), self.inputs, tuple(refuted))

    def _note(self, run: Run, step: str, view: View | None, paper: Mapping[str, str]) -> None:
        words = ["exactmesh", "plot", self.input_path(run.pslg)]
        if run.construction != construction_for(run.kind):
            words += ["--construction", run.construction]
        if run.kind != "nonproper":
            words += ["--kind", run.kind]
        for item in paper.items():
            words += ["--paper", "=".join(item)]
        words += ["--step", step]
        if view is not None and view.is_part:
            corners = (view.low.x, view.low.y, view.high.x, view.high.y)
            # With an equals sign: a negative number would be taken for an option.
            words.append("--window=" + ",".join(map(text_from_rational, corners)))
        self._add([*words, "-o", "part.svg"])

    def _add(self, words: Sequence[str]) -> None:
        command = shlex.join(words)
        if command not in self.commands:
            self.commands.append(command)


def witness(name: str) -> Pslg:
    """Return a witness that comes along, named after its file."""
    return replace(read_pslg(str(WITNESSES.path(name))).pslg, name=name)


def part(low: tuple[str, str], high: tuple[str, str], size: float = 460.0) -> View:
    """Return the view of a rectangle given by decimals or fractions."""
    return window(Point(*map(mpq, low)), Point(*map(mpq, high)), size)


def run_of(pslg: Pslg, construction: ConstructionName, kind: Kind = "nonproper",
           options: PaperOptions = _LITERAL) -> Run:
    """Return a run that reports no progress."""
    return Run(pslg, construction, kind, options)


def degradation(run: Run) -> str:
    """Return the degradation of a run's mesh, for reading."""
    squared = run.verification.degradation_squared
    return "not valid" if squared is None else f"degradation {sqrt_text(squared, DIGITS)}"


def judged(claim: str, run: Run) -> str:
    """Return what a claim says, the worst value on a run and what is true instead.

    Raises `AssertionError` when the claim holds: a companion shows what fails.
    """
    record = claim_by_id(claim)
    verdict = judge_one(record, run).verdict
    if verdict.holds:
        raise AssertionError(f"{claim} holds on {run.pslg.name}")
    text = f"Refuted: {record.says}{f' ({record.bound})' if record.bound else ''}. {_worst(record, verdict)}"
    return text + (f" Correction: {record.corrected}." if record.corrected else "")


def value_text(value: mpq) -> str:
    """Return a rational for reading."""
    return decimal_text(value, DIGITS)


def _worst(record: Claim, verdict: Verdict) -> str:
    shown = claim_json(record, verdict)
    worst, found = shown["worst"], shown["witness"]
    clause = found["clause"] if isinstance(found, dict) else ""
    if not isinstance(worst, dict):
        return f"What fails here: {clause}."
    return f"The worst value here is {worst['decimal']}; asked for: {clause}."
