"""The claims judged on every run of the repaired construction, in the order of its steps."""

from exactmesh.claims.claim import Claim
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.measure.verdict import Verdict
from exactmesh.planar.mesh import Kind
from exactmesh.steps import mesh_check, offset_check, patch_check, shape_check, trapezoidation_check
from exactmesh.steps.constants import (
    DESIGN_DEGRADATION,
    EDGE_GAP,
    FEATURE,
    GAP,
    LEVEL,
    LEVEL_EDGE,
    PAPER_DEGRADATION,
    PROPER_FACTOR,
    PROPER_LOGARITHM,
    PROPER_VERTICES_PER_CORNER,
    SEPARATION,
    THICKNESS_MAX,
    TUBE_FEATURE,
    UNIT_SLACK,
    VERTICES_PER_CORNER,
)

_REPAIRED = "repaired construction"
_RUNS: tuple[ConstructionName, ...] = ("repaired",)
_NONPROPER: tuple[Kind, ...] = ("nonproper",)
_ALL: tuple[Kind, ...] = ("nonproper", "proper", "internal")
_GIVEN = ("the input is a planar straight-line graph", "the face is bounded and no bare triangle")
_NOT_INTERNAL = (*_GIVEN, "the mesh is no internal one: in those it is checked on every run, not proved")


def _unit(run: Run) -> Verdict:
    return shape_check.check_unit(run.subdivision.pslg, run.size.squared, run.repaired.shape)


def _thickness_least(run: Run) -> Verdict:
    return run.offset_thickness[0]


def _thickness_greatest(run: Run) -> Verdict:
    return run.offset_thickness[1]


def _separation(run: Run) -> Verdict:
    return offset_check.check_separation(run.repaired.offset)


def _nesting(run: Run) -> Verdict:
    return offset_check.check_nesting(run.repaired.shape, run.repaired.offset, run.columns)


def _trapezoids_tile(run: Run) -> Verdict:
    made = run.repaired
    return trapezoidation_check.check_tiling(made.offset, made.trapezoidation, run.columns, run.chains)


def _chord_gap(run: Run) -> Verdict:
    return run.chord_gaps[0]


def _level_edge(run: Run) -> Verdict:
    return run.chord_gaps[1]


def _chord_leg(run: Run) -> Verdict:
    return run.chord_gaps[2]


def _chord_touch(run: Run) -> Verdict:
    return trapezoidation_check.check_touch(run.repaired.offset, run.repaired.trapezoidation)


def _chord_clearance(run: Run) -> Verdict:
    made = run.repaired
    return trapezoidation_check.check_clearance(made.offset, made.trapezoidation, run.columns)


def _caps_whole(run: Run) -> Verdict:
    made = run.repaired
    return patch_check.check_caps(made.offset, made.trapezoidation, made.interior)


def _edge_gap(run: Run) -> Verdict:
    made = run.repaired
    return patch_check.check_edge_gaps(made.offset, made.trapezoidation, made.interior, run.columns, run.chains)


def _interior_tiles(run: Run) -> Verdict:
    made = run.repaired
    return patch_check.check_interior_tiling(made.offset, made.trapezoidation, made.interior, run.columns, run.chains,
                                             run.interior_columns)


def _interior_feature(run: Run) -> Verdict:
    return patch_check.check_feature(run.repaired.interior, run.columns, run.interior_columns)


def _tube_tiles(run: Run) -> Verdict:
    made = run.repaired
    return patch_check.check_tube_tiling(made.shape, made.offset, made.trapezoidation, made.interior, made.tube,
                                         run.columns, run.chains, run.tube_columns)


def _tube_feature(run: Run) -> Verdict:
    return run.tube_feature


def _tube_feature_45(run: Run) -> Verdict:
    return patch_check.with_bound(run.tube_feature, TUBE_FEATURE)


def _vertex_count(run: Run) -> Verdict:
    return mesh_check.check_vertex_count(run.verification, run.repaired.shape.corner_count)


def _design_degradation(run: Run) -> Verdict:
    return mesh_check.check_design_degradation(run.verification)


def _proper_degradation(run: Run) -> Verdict:
    return mesh_check.check_proper_degradation(run.verification, run.repaired.shape.corner_count)


def _proper_logarithm(run: Run) -> Verdict:
    return mesh_check.check_proper_logarithm(run.verification, run.repaired.shape.corner_count)


def _internal_degradation(run: Run) -> Verdict:
    return mesh_check.check_internal_degradation(run.verification)


REPAIRED_CLAIMS: tuple[Claim, ...] = (
    Claim("repaired.unit", _REPAIRED,
          "the unit m is at most the feature size to keep, and less by one millionth at most",
          (), f"mfs/m <= 1 + {UNIT_SLACK}", "square", _RUNS, _unit, kinds=_ALL),
    Claim("repaired.offset-thickness", _REPAIRED, "an offset edge keeps its distance from its edge (I1)",
          _GIVEN, f">= {LEVEL} mfs", "square", _RUNS, _thickness_least, kinds=_ALL),
    Claim("repaired.offset-reach", _REPAIRED, "an offset edge stays near its edge (I1)",
          _GIVEN, f"<= {THICKNESS_MAX} mfs", "square", _RUNS, _thickness_greatest, kinds=_ALL),
    Claim("repaired.offset-separation", _REPAIRED,
          "vertices of Q keep their distance from edges of Q without them (I2)", _GIVEN,
          f">= {SEPARATION} mfs", "square", _RUNS, _separation, kinds=_ALL),
    Claim("repaired.offset-nesting", _REPAIRED, "Q is simple, on levels, turned like P and inside its face (I3)",
          _GIVEN, "", "truth", _RUNS, _nesting, kinds=_ALL),
    Claim("repaired.trapezoidation", _REPAIRED, "the trapezoids tile the inside of Q",
          _GIVEN, "", "truth", _RUNS, _trapezoids_tile, kinds=_ALL),
    Claim("repaired.chord-gap", _REPAIRED, "a T-vertex keeps its distance from other vertices of Q on its side (I4)",
          (*_NOT_INTERNAL, "no edge of Q joins the two"), f">= {GAP} mfs", "square", _RUNS, _chord_gap, kinds=_ALL),
    Claim("repaired.level-edge", _REPAIRED, "a level edge of Q at a T-vertex keeps its length (I4)",
          _NOT_INTERNAL, f">= {LEVEL_EDGE} mfs", "square", _RUNS, _level_edge, kinds=_ALL),
    Claim("repaired.chord-leg", _REPAIRED, "a T-vertex keeps its distance from the legs (I4)",
          _GIVEN, f">= {SEPARATION} mfs", "square", _RUNS, _chord_leg, kinds=_ALL),
    Claim("repaired.chord-touch", _REPAIRED, "each horizontal side holds a vertex of Q (I5)",
          _GIVEN, ">= 1", "number", _RUNS, _chord_touch, kinds=_ALL),
    Claim("repaired.chord-clearance", _REPAIRED, "an edge of Q goes on for a level beyond a chord end (I5')",
          _GIVEN, f">= {LEVEL} mfs", "number", _RUNS, _chord_clearance, kinds=_ALL),
    Claim("repaired.caps-whole", _REPAIRED, "no vertex is put on an edge of a cap",
          _GIVEN, "", "truth", _RUNS, _caps_whole),
    Claim("repaired.edge-gap", _REPAIRED, "neighbours on an edge of Q keep their distance",
          _GIVEN, f">= {EDGE_GAP} mfs", "square", _RUNS, _edge_gap),
    Claim("repaired.interior-tiling", _REPAIRED, "the faces of the Interior tile the inside of Q",
          _GIVEN, "", "truth", _RUNS, _interior_tiles, kinds=_ALL),
    Claim("repaired.interior-feature", _REPAIRED, "every face of the Interior keeps its feature size",
          _GIVEN, f">= {FEATURE} mfs", "square", _RUNS, _interior_feature, kinds=_NONPROPER),
    Claim("repaired.tube-tiling", _REPAIRED, "the faces of the Tube tile what lies between P and Q",
          _GIVEN, "", "truth", _RUNS, _tube_tiles),
    Claim("repaired.tube-feature", _REPAIRED, "every face of the Tube keeps its feature size",
          _GIVEN, f">= {FEATURE} mfs", "square", _RUNS, _tube_feature, kinds=_NONPROPER),
    Claim("repaired.tube-feature-45", _REPAIRED, "every face of the Tube keeps what a degradation below 45 needs",
          _GIVEN, f">= {TUBE_FEATURE} mfs", "square", _RUNS, _tube_feature_45, kinds=_NONPROPER),
    Claim("repaired.steiner-count", _REPAIRED, "the number of Steiner vertices is linear, whatever the spread",
          (), f"<= {VERTICES_PER_CORNER} a corner ({PROPER_VERTICES_PER_CORNER} in a proper mesh)", "number", _RUNS,
          _vertex_count),
    Claim("repaired.degradation", _REPAIRED, "the degradation is at most the design value",
          (), f"<= {DESIGN_DEGRADATION}", "square", _RUNS, _design_degradation, kinds=_NONPROPER),
    Claim("repaired.internal-degradation", "repaired construction, for Theorem 3",
          "an internal mesh is proper and degrades the internal feature size by less than 45",
          ("no edge of the input has the domain on both sides",), f"< {PAPER_DEGRADATION}", "square", _RUNS,
          _internal_degradation, kinds=("internal",)),
    Claim("repaired.proper-degradation", "repaired construction, for Theorem 2",
          "the degradation of a proper mesh grows at most with the logarithm of the number n of corners",
          ("n >= 4",), f"<= max({DESIGN_DEGRADATION}, {PROPER_FACTOR} (1 + log2 n))", "square", _RUNS,
          _proper_degradation, kinds=("proper",)),
    Claim("repaired.proper-degradation-22", "repaired construction, for Theorem 2",
          "the degradation of a proper mesh is at most a constant times the logarithm of the number n of corners",
          ("n >= 4",), f"<= {PROPER_LOGARITHM} (1 + log2 n)", "square", _RUNS, _proper_logarithm, kinds=("proper",)),
)

# The claims on the steps alone, before the mesh is verified.
STEP_CLAIMS: tuple[Claim, ...] = tuple(claim for claim in REPAIRED_CLAIMS if claim.check not in (
    _vertex_count, _design_degradation, _proper_degradation, _proper_logarithm, _internal_degradation))
