"""The claims of Section 2 up to the Interior's trapezoids, and of Appendix A, judged on the published construction.

Lengths are in units of mfs(P). Bounds that mention d3 follow the reading of the run; the grid's spacing, a rational
just below the paper's 1/(2 d3), changes none of them.
"""

from collections.abc import Callable

from exactmesh.claims.claim import Claim
from exactmesh.claims.run import Run
from exactmesh.measure.verdict import Verdict
from exactmesh.numbers.algebraic import Real
from exactmesh.paper import simple_polygon
from exactmesh.steps import appendix_a_check, offset_curve_check, p5_check, snap_check, trapezoidation_check
from exactmesh.steps.reading import READINGS
from exactmesh.steps.records import OffsetCurve, Shape

_APPENDIX = "Appendix A"
_P3 = "Section 2, Refinement of P2"
_P4 = "Section 2, Refinement of P2 (snapping)"
_INTERIOR = "Section 2, Triangulation of Interior"
_TUBE = "Section 2, Triangulation of Tube"
_POLYGON = ("P is a simple polygon",)
_FOUR = "P has at least four vertices"
_TRIANGLES = "triangles are left as they are, and no bound of the repaired construction rests on offset edges' lengths"
_OCTAGON = "the repaired construction has no arcs: its offset body is an octagon on the levels"


def _on_curve(check: Callable[[Shape, OffsetCurve], Verdict]) -> Callable[[Run], Verdict]:
    """Return a check that needs P2 and P3 only, not the steps after them."""
    return lambda run: check(simple_polygon(run.subdivision), run.curve)


def _next_edge(shape: Shape, curve: OffsetCurve) -> Verdict:
    return appendix_a_check.check_quarter_circle(shape, curve, only_next=True)


def _inverse_d3(run: Run) -> Real:
    return READINGS[run.options.reading].inverse_d3


def _snap_motion(run: Run) -> Verdict:
    return snap_check.check_motion(run.curve, run.paper.p4, _inverse_d3(run))


def _p4_feature_size(run: Run) -> Verdict:
    return snap_check.check_feature_size(run.curve, run.paper.p4, _inverse_d3(run))


def _p4_tube_distance(run: Run) -> Verdict:
    return snap_check.check_tube_distance(run.paper.shape, run.curve, run.paper.p4, _inverse_d3(run))


def _p4_both_regions(run: Run) -> Verdict:
    return snap_check.check_both_regions(run.paper.shape, run.curve, run.paper.p4, _inverse_d3(run))


def _perturbation(run: Run) -> Verdict:
    return snap_check.check_perturbation(run.curve, run.paper.p4)


def _p5_grid(run: Run) -> Verdict:
    return p5_check.check_grid(run.paper.p4, run.paper.trapezoidation)


def _p5_tiles(run: Run) -> Verdict:
    return trapezoidation_check.check_tiling(run.paper.p4, run.paper.trapezoidation, run.paper.points)


def _p5_feature_size(run: Run) -> Verdict:
    return p5_check.check_kept(run.paper.p4, run.paper.trapezoidation, run.paper.points)


def _p5_above_grid(run: Run) -> Verdict:
    return p5_check.check_above_grid(run.paper.p4, run.paper.trapezoidation, run.paper.points)


def _tube_keeps_boundary(run: Run) -> Verdict:
    made = run.paper
    return p5_check.check_boundary(made.shape, made.p4, made.trapezoidation, made.tube.patch, made.points)


_LEMMA_2 = (
    Claim("lemma-2.perturbation", "Lemma 2",
          "moving vertices by a mfs costs a factor of at most 1/(1 - 2 a) and keeps the drawing",
          ("judged on the step from P3 to P4", "every vertex is on an edge that meets another edge"),
          "(mfs(P4) + 2 motion)/mfs(P3) >= 1", "square", check=_perturbation),
)

_APPENDIX_A = (
    Claim("appendix-a.offset-edge-length", _APPENDIX, "every straight segment of P2 has length 1/2 or more",
          _POLYGON, ">= 1/2 mfs", "square", check=_on_curve(appendix_a_check.check_edge_length),
          corrected="true of polygons with at least four vertices; triangles keep sqrt(3)/6, and the equilateral one, "
                    "which has no rational coordinates, keeps no more",
          repair=_TRIANGLES, witness="triangle-near-equilateral"),
    Claim("appendix-a.both-ends-reflex", _APPENDIX, "between two reflex corners the segment is as long as the edge",
          _POLYGON, "|e'|/|e| = 1", "square", check=_on_curve(appendix_a_check.check_both_reflex)),
    Claim("appendix-a.one-end-reflex", _APPENDIX, "at one reflex corner the segment is longer than 1/2",
          _POLYGON, "> 1/2 mfs", "square", check=_on_curve(appendix_a_check.check_one_reflex)),
    Claim("appendix-a.unit-edge-angles", _APPENDIX, "an edge as short as mfs has no angle below 90 degrees",
          (*_POLYGON, "both corners of the edge are convex"), "cosine <= 0", "number",
          check=_on_curve(appendix_a_check.check_unit_edges)),
    Claim("appendix-a.acute-end-reach", _APPENDIX, "t1 lies at most 1/4 beyond z",
          (*_POLYGON, "the angle at p1 is acute"), "<= 1/4 mfs", "number",
          check=_on_curve(appendix_a_check.check_reach)),
    Claim("appendix-a.no-part-meets-quarter-circle", _APPENDIX, "no part of P other than e and u enters J_y",
          (*_POLYGON, "the angle at p1 is acute, that at p2 convex"), ">= 1 mfs", "square",
          check=_on_curve(appendix_a_check.check_quarter_circle),
          corrected="an edge that shares the far end of u may pass near y, which is no vertex; the proof needs no more "
                    "than that the edge after e misses J_y",
          repair=_TRIANGLES, witness="trapezoid-two-acute"),
    Claim("appendix-a.next-edge-misses-quarter-circle", _APPENDIX, "the edge after e misses J_y",
          (*_POLYGON, "the angle at p1 is acute, that at p2 convex"), ">= 1 mfs", "square", check=_on_curve(_next_edge),
          corrected="true of polygons with at least four vertices, where that edge and u have no common vertex; in a "
                    "triangle it ends on u and cannot be \"too close\" to e, which it meets",
          repair=_TRIANGLES, witness="triangle-13-14-15"),
    Claim("appendix-a.both-angles-acute", _APPENDIX, "between two acute angles the segment is longer than 1",
          _POLYGON, "> 1 mfs", "square", check=_on_curve(appendix_a_check.check_both_acute),
          corrected="it is 1/2 or longer in polygons with at least four vertices, and no greater constant will do",
          repair=_TRIANGLES, witness="trapezoid-two-acute"),
    Claim("appendix-a.sine", _APPENDIX, "sin w = 1/|e'| when p2 is at distance 1 from u",
          (*_POLYGON, "the angle at p1 is acute, that at p2 convex, and p2 is at distance mfs from u"),
          "|e'| sin w = 1 mfs", "square", check=_on_curve(appendix_a_check.check_sine),
          corrected="sin w = 1/|e|: a misprint, the formulas after it use |e|",
          repair=_TRIANGLES, witness="rhombus-5"),
    Claim("appendix-a.final-formula", _APPENDIX, "with one acute angle w the segment is 1/(2 sin w) or longer",
          (*_POLYGON, _FOUR, "the angle at p2 is convex and not acute"),
          "2 |e'| sin w >= 1 mfs", "square", check=_on_curve(appendix_a_check.check_formula)),
)

_SECTION_2_P3 = (
    Claim("section-2.p2-single-curve", "Section 2, Theorem 1",
          "P2 is a closed curve of one segment an edge and one arc a reflex vertex, at distance 1/4 from P",
          _POLYGON, ">= 1/4 mfs from other edges", "square", check=_on_curve(offset_curve_check.check_single_curve)),
    Claim("section-2.arc-below-180", "Section 2, Theorem 1", "each arc spans less than 180 degrees",
          _POLYGON, "cosine > -1", "number", check=_on_curve(offset_curve_check.check_arcs)),
    Claim("section-2.p3-refinement", _P3, "P3 has two chords for an arc over 90 degrees and prolongs one under 90",
          (*_POLYGON, "at 90 degrees either will do: the text leaves it open"),
          check=_on_curve(offset_curve_check.check_refinement)),
    Claim("section-2.p3-tube-distance", _P3, "P3 keeps its distance from P",
          _POLYGON, ">= 1/(4 sqrt 2) mfs", "square", check=_on_curve(offset_curve_check.check_tube_distance)),
    Claim("section-2.p3-octagon-reason", _P3, "at 90 degrees a chord is the side of an octagon of diameter 1/4",
          _POLYGON, "= sin(pi/8)/4 mfs", "square", check=_on_curve(offset_curve_check.check_octagon),
          corrected="of radius 1/4: the side is sin(pi/8)/2, the number that the text gives; being above 1/(4 sqrt 2), "
                    "it is no reason for the Tube's bound either, which comes from wide arcs",
          repair=_OCTAGON, witness="l-shape-4"),
    Claim("section-2.p3-feature-size", _P3, "the feature size of P3",
          _POLYGON, ">= sin(pi/8)/2 mfs", "square", check=_on_curve(offset_curve_check.check_feature_size)),
    Claim("section-2.p3-through-interior", _P3, "distances through the interior of P3 are 1/2 or more",
          (*_POLYGON, "between a vertex of P3 and an edge that belongs to other corners"),
          ">= 1/2 mfs", "square", check=_on_curve(offset_curve_check.check_through_interior),
          corrected="true with at least four vertices as long as no arc is prolonged; afterwards 1 - sqrt(2)/2, and "
                    "1/4 in triangles",
          repair="the repaired construction asks for a separation of 0.0599 only, 1 less twice its reach, and "
                 "checks it on every run",
          witness="facing-wedges"),
    Claim("section-2.extension-distance-from-p", _P3, "a prolonged segment stays farther than 1/4 from P",
          (*_POLYGON, "beyond the end of its arc, where the distance is 1/4"),
          "> 1/4 mfs", "square", check=_on_curve(offset_curve_check.check_extension_from_p)),
    Claim("section-2.extension-distance-from-vertex", _P3, "a prolonged segment stays within sqrt(2)/4 of its vertex",
          _POLYGON, "<= sqrt(2)/4 mfs", "square", check=_on_curve(offset_curve_check.check_extension_from_vertex)),
    Claim("section-2.p3-separation", _P3, "points of different edges of P3 keep their distance",
          (*_POLYGON, "between a vertex of P3 and an edge that belongs to other corners: chords of one arc are nearer, "
                      "and edges that meet are not apart at all"),
          ">= 1 - sqrt(2)/2 mfs", "square", check=_on_curve(offset_curve_check.check_separation),
          corrected="true with at least four vertices; a triangle's P3 keeps 1/4",
          repair="the repaired construction leaves triangles as they are", witness="triangle-51-52-53"),
)

_SECTION_2_P4 = (
    Claim("section-2.snap-motion", _P4, "a vertex snaps by at most half the grid",
          (*_POLYGON, "the spacing is a rational just below 1/(2 d3)", "x may move by 2^-17 mfs, to a rational"),
          "<= 1/(4 d3) mfs", "square", check=_snap_motion),
    Claim("section-2.p4-feature-size", _P4, "snapping at most halves the feature size of P3",
          _POLYGON, ">= 1/(2 d3) mfs", "square", check=_p4_feature_size),
    Claim("section-2.p4-tube-distance", _P4, "P4 keeps its distance from P",
          _POLYGON, ">= 1/d_tube3 - 1/(4 d3) mfs", "square", check=_p4_tube_distance),
    Claim("section-2.p4-both-regions", _P4, "with P4, the feature size of both regions",
          (*_POLYGON, "read as a lower bound: it need not be attained on P4"),
          ">= 1/(2 d3) mfs", "square", check=_p4_both_regions),
)

_LOSS = ("the loss is bounded and confined to triangles at a corner, which get no vertex: mfs(P5) > 0.7628 of the "
         "spacing, > 0.8086 with at least four vertices")
_LOSS_REPAIR = "the repaired construction asks g/5 of every face, not the spacing g, and checks it on every run"

_SECTION_2_P5 = (
    Claim("section-2.p5-grid", _INTERIOR, "all vertices of P5 lie on the grid", _POLYGON, check=_p5_grid),
    Claim("section-2.p5-tiles", _INTERIOR, "P5 is a horizontal trapezoidation of the inside of P4", _POLYGON,
          check=_p5_tiles),
    Claim("section-2.p5-feature-size", _INTERIOR, "P5 preserves the feature size of P4",
          _POLYGON, "mfs(P5)/mfs(P4) >= 1", "square", check=_p5_feature_size,
          corrected=_LOSS, repair=_LOSS_REPAIR, witness="parallelogram-flat"),
    Claim("section-2.p5-above-grid", _INTERIOR, "being on the grid, P5 has a feature size of its spacing or more",
          (*_POLYGON, "the spacing is a rational just below 1/(2 d3)"),
          "mfs(P5)/spacing >= 1", "square", check=_p5_above_grid,
          corrected=_LOSS, repair=_LOSS_REPAIR, witness="parallelogram-flat"),
    Claim("section-2.tube-keeps-boundary", _TUBE, "the Tube puts no vertex on its boundary", _POLYGON,
          check=_tube_keeps_boundary),
)

BOUNDARY_CLAIMS: tuple[Claim, ...] = _LEMMA_2 + _APPENDIX_A + _SECTION_2_P3 + _SECTION_2_P4 + _SECTION_2_P5
