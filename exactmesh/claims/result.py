"""The claims on every finished mesh, whatever made it: what the paper's Theorem 1 promises."""

from exactmesh.claims.claim import Claim
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.measure.verdict import Verdict
from exactmesh.steps import mesh_check
from exactmesh.steps.constants import PAPER_DEGRADATION, PAPER_FEATURE

_RUNS: tuple[ConstructionName, ...] = ("paper", "repaired")
_GAP = ("false of the published construction, whose P6 leaves T-vertices on the sides of long trapezoids; what a "
        "triangulation can do is another matter: the repaired construction is judged by the same sentence")
_REPAIR = "T-vertices are absorbed by wedges, cross edges and nested apexes, so every face keeps g/5"


def _valid(run: Run) -> Verdict:
    return mesh_check.check_valid(run.verification)


def _paper_feature(run: Run) -> Verdict:
    return mesh_check.check_paper_feature(run.verification)


def _paper_degradation(run: Run) -> Verdict:
    return mesh_check.check_paper_degradation(run.verification)


RESULT_CLAIMS: tuple[Claim, ...] = (
    Claim("section-1.classic-triangulation", "section 1",
          "a classic triangulation tiles the polygon and adds no vertex",
          (), "", "truth", ("classic",), _valid, kinds=("classic",)),
    Claim("theorem-1.triangulation", "Theorem 1", "the mesh is a triangulation that leaves the boundary whole",
          ("P is a simple polygon",), "", "truth", _RUNS, _valid, kinds=("nonproper",)),
    Claim("theorem-1.feature-size", "Theorem 1, phase 3",
          "the feature size of the mesh is at least 0.022 of the input's", ("P is a simple polygon",),
          f">= {PAPER_FEATURE} mfs", "square", _RUNS, _paper_feature, _GAP, _REPAIR, "l-shape-192",
          kinds=("nonproper",)),
    Claim("theorem-1.degradation", "Theorem 1", "the degradation is below 45",
          ("P is a simple polygon",), f"< {PAPER_DEGRADATION}", "square", _RUNS, _paper_degradation, _GAP, _REPAIR,
          "l-shape-192", kinds=("nonproper",)),
    Claim("theorem-2.triangulation", "Theorem 2", "the mesh is a proper triangulation that leaves the boundary whole",
          (), "", "truth", ("repaired",), _valid, kinds=("proper",)),
    Claim("theorem-3.triangulation", "Theorem 3", "a proper triangulation with vertices on the boundary",
          ("no edge of the input has the domain on both sides",), "", "truth", ("repaired",), _valid,
          kinds=("internal",)),
)
