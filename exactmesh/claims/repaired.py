"""The claims judged on every run of the repaired construction, in the order of its steps."""

from collections.abc import Callable, Iterator

from exactmesh.claims.claim import Claim, Judgement, Run
from exactmesh.measure.verdict import Verdict
from exactmesh.steps import mesh_check, offset_check, patch_check, shape_check, trapezoidation_check
from exactmesh.steps.constants import (
    DESIGN_DEGRADATION,
    EDGE_GAP,
    FEATURE,
    GAP,
    LEVEL,
    PAPER_DEGRADATION,
    PAPER_FEATURE,
    SEPARATION,
    THICKNESS_MAX,
    UNIT_SLACK,
    VERTICES_PER_CORNER,
)

_REPAIRED = "repaired construction"
_GIVEN = ("the input is a planar straight-line graph", "the face is bounded and no bare triangle")


def _unit(run: Run) -> Verdict:
    return shape_check.check_unit(run.subdivision.pslg, run.mfs.squared, run.construction.shape)


def _thickness_least(run: Run) -> Verdict:
    return offset_check.check_thickness(run.construction.shape, run.construction.offset)[0]


def _thickness_greatest(run: Run) -> Verdict:
    return offset_check.check_thickness(run.construction.shape, run.construction.offset)[1]


def _separation(run: Run) -> Verdict:
    return offset_check.check_separation(run.construction.offset)


def _nesting(run: Run) -> Verdict:
    return offset_check.check_nesting(run.construction.shape, run.construction.offset)


def _trapezoids_tile(run: Run) -> Verdict:
    made = run.construction
    return trapezoidation_check.check_tiling(made.offset, made.trapezoidation, made.points)


def _chord_gap(run: Run) -> Verdict:
    made = run.construction
    return trapezoidation_check.check_gaps(made.offset, made.trapezoidation, made.points)[0]


def _chord_leg(run: Run) -> Verdict:
    made = run.construction
    return trapezoidation_check.check_gaps(made.offset, made.trapezoidation, made.points)[1]


def _chord_touch(run: Run) -> Verdict:
    return trapezoidation_check.check_touch(run.construction.offset, run.construction.trapezoidation)


def _chord_clearance(run: Run) -> Verdict:
    made = run.construction
    return trapezoidation_check.check_clearance(made.offset, made.trapezoidation, made.points)


def _caps_whole(run: Run) -> Verdict:
    made = run.construction
    return patch_check.check_caps(made.offset, made.trapezoidation, made.interior)


def _edge_gap(run: Run) -> Verdict:
    made = run.construction
    return patch_check.check_edge_gaps(made.offset, made.trapezoidation, made.interior, made.points)


def _interior_tiles(run: Run) -> Verdict:
    made = run.construction
    return patch_check.check_interior_tiling(made.offset, made.trapezoidation, made.interior, made.points)


def _interior_feature(run: Run) -> Verdict:
    return patch_check.check_feature(run.construction.interior, run.construction.points)


def _tube_tiles(run: Run) -> Verdict:
    made = run.construction
    return patch_check.check_tube_tiling(made.shape, made.offset, made.trapezoidation, made.interior, made.tube,
                                         made.points)


def _tube_feature(run: Run) -> Verdict:
    return patch_check.check_feature(run.construction.tube, run.construction.points)


def _vertex_count(run: Run) -> Verdict:
    return mesh_check.check_vertex_count(run.verification, run.construction.shape.corner_count)


def _design_degradation(run: Run) -> Verdict:
    return mesh_check.check_design_degradation(run.verification)


def _valid(run: Run) -> Verdict:
    return mesh_check.check_valid(run.verification)


def _paper_feature(run: Run) -> Verdict:
    return mesh_check.check_paper_feature(run.verification)


def _paper_degradation(run: Run) -> Verdict:
    return mesh_check.check_paper_degradation(run.verification)


CLAIMS: tuple[Claim, ...] = (
    Claim("repaired.unit", _REPAIRED, "the unit m is at most mfs(P), and less by one millionth at most",
          (), f"mfs/m <= 1 + {UNIT_SLACK}", True, _unit),
    Claim("repaired.offset-thickness", _REPAIRED, "an offset edge keeps its distance from its edge (I1)",
          _GIVEN, f">= {LEVEL} mfs", True, _thickness_least),
    Claim("repaired.offset-reach", _REPAIRED, "an offset edge stays near its edge (I1)",
          _GIVEN, f"<= {THICKNESS_MAX} mfs", True, _thickness_greatest),
    Claim("repaired.offset-separation", _REPAIRED, "vertices of Q keep their distance from edges of Q without them (I2)",
          _GIVEN, f">= {SEPARATION} mfs", True, _separation),
    Claim("repaired.offset-nesting", _REPAIRED, "Q is simple, on levels, turned like P and inside its face (I3)",
          _GIVEN, "", False, _nesting),
    Claim("repaired.trapezoidation", _REPAIRED, "the trapezoids tile the inside of Q",
          _GIVEN, "", False, _trapezoids_tile),
    Claim("repaired.chord-gap", _REPAIRED, "a T-vertex keeps its distance from other vertices of Q on its side (I4)",
          _GIVEN, f">= {GAP} mfs", True, _chord_gap),
    Claim("repaired.chord-leg", _REPAIRED, "a T-vertex keeps its distance from the legs (I4)",
          _GIVEN, f">= {SEPARATION} mfs", True, _chord_leg),
    Claim("repaired.chord-touch", _REPAIRED, "each horizontal side holds a vertex of Q (I5)",
          _GIVEN, ">= 1", False, _chord_touch),
    Claim("repaired.chord-clearance", _REPAIRED, "an edge of Q goes on for a level beyond a chord end (I5')",
          _GIVEN, f">= {LEVEL} mfs", False, _chord_clearance),
    Claim("repaired.caps-whole", _REPAIRED, "no vertex is put on an edge of a cap",
          _GIVEN, "", False, _caps_whole),
    Claim("repaired.edge-gap", _REPAIRED, "neighbours on an edge of Q keep their distance",
          _GIVEN, f">= {EDGE_GAP} mfs", True, _edge_gap),
    Claim("repaired.interior-tiling", _REPAIRED, "the faces of the Interior tile the inside of Q",
          _GIVEN, "", False, _interior_tiles),
    Claim("repaired.interior-feature", _REPAIRED, "every face of the Interior keeps its feature size",
          _GIVEN, f">= {FEATURE} mfs", True, _interior_feature),
    Claim("repaired.tube-tiling", _REPAIRED, "the faces of the Tube tile what lies between P and Q",
          _GIVEN, "", False, _tube_tiles),
    Claim("repaired.tube-feature", _REPAIRED, "every face of the Tube keeps its feature size",
          _GIVEN, f">= {FEATURE} mfs", True, _tube_feature),
    Claim("repaired.steiner-count", _REPAIRED, "the number of Steiner vertices is linear, whatever the spread",
          (), f"<= {VERTICES_PER_CORNER} a corner", False, _vertex_count),
    Claim("repaired.degradation", _REPAIRED, "the degradation is at most the design value",
          (), f"<= {DESIGN_DEGRADATION}", True, _design_degradation),
    Claim("theorem-1.triangulation", "Theorem 1", "the mesh is a nonproper triangulation that leaves the boundary whole",
          (), "", False, _valid),
    Claim("theorem-1.feature-size", "Theorem 1, phase 3", "the feature size of the mesh is at least 0.022 of the input's",
          (), f">= {PAPER_FEATURE} mfs", True, _paper_feature),
    Claim("theorem-1.degradation", "Theorem 1", "the degradation is below 45",
          (), f"< {PAPER_DEGRADATION}", True, _paper_degradation),
)


def judge(run: Run, progress: Callable[[str], None]) -> Iterator[Judgement]:
    """Yield the verdict on each claim in turn; `progress` is told its id beforehand."""
    for claim in CLAIMS:
        progress(claim.id)
        yield Judgement(claim, claim.check(run))
