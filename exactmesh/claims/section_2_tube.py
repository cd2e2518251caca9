"""The claims of section 2 on the Tube and on Theorem 1's count, and of section 3 on its rectangles.

`section_2_mesh.py` says how 1/(2 d3) is read. Where the construction puts a vertex at such a distance, it takes a
rational that is less than a millionth smaller; bounds that depend on it allow for that.
"""

from collections.abc import Callable, Sequence

from gmpy2 import mpq

from exactmesh.claims.claim import Claim
from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.measure.verdict import Tally, Verdict
from exactmesh.planar.mesh import Kind
from exactmesh.steps import lemma_3_check, paper_tube_check, paper_tube_unsnapped_check
from exactmesh.steps.reading import READINGS, Reading
from exactmesh.steps.records import PaperTube, Phase

Check = Callable[[Run], Verdict]

_ONE, _TWO, _THREE, _FOUR = (f"Section 2, Triangulation of Tube, phase {phase}" for phase in (1, 2, 3, 4))
_NUMBER = "Theorem 1, number of vertices"
_SIMPLE = ("P is a simple polygon",)
_SPACING = (*_SIMPLE, "the grid's spacing stands for 1/(2 d3)")
_UNSNAPPED = (*_SIMPLE, "before snapping")
_WHOLE = (*_SIMPLE, "T' is all of T", "its ends before snapping are on P3")
_LAYERED = (*_SIMPLE, "the rectangles of the Tube are filled by layers")
_PROPER: tuple[Kind, ...] = ("proper",)
_LOW = "1/(8 d3) less a millionth"
_MILLIONTH = (1 - mpq(1, 10**6)) ** 2
_REPAIR = "one routine triangulates every quasi-trapz whole, so there are neither fans beside it nor a rectangle in it"
_READING = "the value depends on the reading of d3"


def _spacing_squared(run: Run) -> mpq:
    """Return the square of the grid's spacing in units of the mfs."""
    return run.paper.p4.spacing**2 / run.paper.mfs_squared


def _keeps(clause: str, share_squared: mpq, *phases: Phase) -> Check:
    """Judge whether the faces of some phases keep a share of the spacing."""
    def check(run: Run) -> Verdict:
        made = run.paper
        tally = Tally(clause, ">=", share_squared * _spacing_squared(run))
        return paper_tube_check.check_feature(made.tube, made.points, made.mfs_squared, tally, phases)
    return check


def _phase_4_value(run: Run) -> Verdict:
    if run.options.rectangle != "nested":
        return Verdict(0, True)
    tally = Tally("feature size > 0.024 mfs", ">", mpq(24, 1000) ** 2)
    made, phases = run.paper, frozenset[Phase](("rectangle",))
    return paper_tube_check.check_feature(made.tube, made.points, made.mfs_squared, tally, phases)


def _tiling(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_tiling(made.shape, made.p4, made.trapezoidation, made.interior, made.tube,
                                         made.points)


def _structure(run: Run) -> Verdict:
    return paper_tube_check.check_structure(run.paper.shape, run.paper.p4, run.paper.points)


def _snapped_angles(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_snapped_angles(made.shape, made.p4, made.tube, made.points)


def _cut_angle(run: Run) -> Verdict:
    return paper_tube_check.check_cut_angle(run.paper.trapezoidation, run.paper.tube, run.paper.points)


def _projection(run: Run) -> Verdict:
    return paper_tube_check.check_projection(run.paper.shape, run.paper.tube, run.paper.points)


def _upper(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_upper(made.shape, made.tube, made.points, made.mfs_squared, _spacing_squared(run))


def _lower(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_lower(made.shape, made.tube, made.points, made.mfs_squared, _spacing_squared(run) / 4)


def _low_vertex(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_low_vertex(made.shape, made.p4, made.tube, made.points, made.mfs_squared,
                                             _MILLIONTH * _spacing_squared(run) / 16)


def _spokes(tops_only: bool) -> Check:
    return lambda run: paper_tube_unsnapped_check.check_spokes(run.paper.shape, run.curve, tops_only)


def _inner_corners(run: Run) -> Verdict:
    made, reading = run.paper, READINGS[run.options.reading]
    return paper_tube_unsnapped_check.check_inner_corners(made.shape, made.curve, made.p4, made.tube, reading)


def _motion(run: Run) -> Verdict:
    made, reading = run.paper, READINGS[run.options.reading]
    return paper_tube_unsnapped_check.check_motion(made.shape, made.curve, made.p4, made.tube, made.points, reading)


def _number(check: Callable[[Reading], Verdict]) -> Check:
    return lambda run: check(READINGS[run.options.reading])


def _count(run: Run) -> Verdict:
    if run.options.rectangle != "nested":
        return Verdict(0, True)
    return lemma_3_check.check_count(run.paper.tube, run.paper.points, occupied=True)


def _steiner_count(run: Run) -> Verdict:
    made = run.paper
    return paper_tube_check.check_steiner_count(len(made.points), len(made.shape.points))


def _layers(check: Callable[[PaperTube, Sequence[Point]], Verdict]) -> Check:
    """Judge the rectangles of runs that fill them by layers; in others there is nothing to judge."""
    return lambda run: (check(run.paper.tube, run.paper.points) if run.options.rectangle == "layers"
                        else Verdict(0, True))


def _only_within(*phases: Phase) -> Check:
    return lambda run: paper_tube_check.check_proper_elsewhere(run.paper.interior, run.paper.tube, phases)


_PHASE_1: tuple[Claim, ...] = (
    Claim("tube.tiles", "Section 2, Triangulation of Tube", "the Tube is triangulated, its boundary left as it is",
          _SIMPLE, check=_tiling),
    Claim("phase-1.structure", _ONE, "spokes cut the Tube into triangles and quasi-trapz",
          (*_SIMPLE, "after snapping"), check=_structure),
    Claim("phase-1.spoke-angle", _ONE, "spokes make at least 45 degrees with P3",
          _UNSNAPPED, "cosine <= 1/sqrt(2)", "square", check=_spokes(False)),
    Claim("phase-1.snapped-angle", _ONE, "snapping leaves angles of more than 14 degrees",
          _SIMPLE, "sine >= 1/4", "square", check=_snapped_angles),
    Claim("phase-1.fan-value", _ONE, "1/(2 d3 sqrt 2) is roughly 0.067",
          (_READING,), ">= 0.067", "number", check=_number(paper_tube_unsnapped_check.check_fan_number)),
    Claim("phase-1.fan-feature-size", _ONE, "fans keep 1/sqrt 2 of the spacing, also after snapping",
          _SPACING, ">= 1/(2 d3 sqrt(2)) mfs", "square",
          check=_keeps("feature size >= 1/(2 d3 sqrt 2)", mpq(1, 2), "fan"),
          corrected="true before snapping; after it fans keep more than 1/20 mfs in all that was tried",
          repair=_REPAIR, witness="snapped-fan"),
)

_PHASE_2: tuple[Claim, ...] = (
    Claim("phase-2.start-angle", _TWO, "the top makes at least 45 degrees with the spokes at its ends",
          _UNSNAPPED, "cosine <= 1/sqrt(2)", "square", check=_spokes(True)),
    Claim("phase-2.cut-angle", _TWO, "the fans cut off are like those of phase 1: 45 degrees",
          (*_SIMPLE, "an angle is that of an edge to a Steiner vertex of the top, with the top"), "sine >= 1/sqrt(2)",
          "square", check=_cut_angle,
          corrected="the angle has no positive lower bound: the next Steiner vertex can be arbitrarily far along T",
          repair=_REPAIR, witness="wide-cut"),
    Claim("phase-2.cut-feature-size", _TWO, "the preceding analysis covers the triangles cut off",
          _SPACING, ">= 1/(2 d3 sqrt(2)) mfs", "square",
          check=_keeps("feature size >= 1/(2 d3 sqrt 2)", mpq(1, 2), "cut"),
          corrected="they keep more than 1/20 mfs in all that was tried, enough for a degradation below 45",
          repair=_REPAIR, witness="narrow-cut"),
    Claim("phase-2.projection", _TWO, "T' projects onto B, and R fits into Q'",
          (*_SIMPLE, "after snapping"), check=_projection),
    Claim("phase-2.q-prime-feature-size", _TWO, "mfs(Q') is the separation of the vertices on its top",
          (*_SPACING, "after snapping; before it, they can be nearer than 1/(2 d3)"), ">= 1/(2 d3) mfs", "square",
          check=_upper),
    Claim("phase-2.inner-corner-distance", _TWO, "a' and b' are farther from the sides of Q' than from B",
          (*_WHOLE, "the angles of 135 degrees are those after snapping"), "> 1/(2 d3) mfs", "square",
          check=_inner_corners,
          corrected="true where the angles are 135 degrees before snapping as well; snapping can raise smaller ones",
          repair=_REPAIR, witness="inner-corner"),
    Claim("phase-2.rectangle-motion", _TWO, "R moves rigidly, and a' by as little as a",
          (*_WHOLE, "both rectangles have the height 1/4 less the spacing"), "<= 1/(4 d3) mfs", "square", check=_motion,
          corrected="R is turned and stretched, a' and b' move farther; what survives is their height above B, at "
                    "least 1/(4 d3)", repair=_REPAIR, witness="turned-rectangle"),
    Claim("phase-2.motion-value", _TWO, "1/(4 d3) = 1/(16 sqrt 2), roughly 0.044",
          (_READING,), "= 1/(16 sqrt(2))", "number", check=_number(paper_tube_unsnapped_check.check_motion_number),
          corrected="sin(pi/8)/8 = 0.0478; the stated value belongs to d3 = 4 sqrt 2", witness="unit-square"),
    Claim("phase-2.lower-feature-size", _TWO, "snapping leaves half of the height of Q''",
          _SPACING, ">= 1/(4 d3) mfs", "square", check=_lower),
    Claim("phase-2.side-triangles", _TWO, "the triangles beside R are affected even less",
          _SPACING, ">= 1/(4 d3) mfs", "square", check=_keeps("feature size >= 1/(4 d3)", mpq(1, 4), "rest")),
)

_PHASES_3_4: tuple[Claim, ...] = (
    Claim("phase-3.feature-size", _THREE, "one vertex at 1/(8 d3) from B keeps that much in Q''",
          (*_SPACING, _LOW), ">= 1/(8 d3) mfs", "square",
          check=_keeps("feature size >= 1/(8 d3)", _MILLIONTH / 16, "low")),
    Claim("phase-3.tall", _THREE, "so it is in a quasi-trapz that never had vertices on its top",
          (*_SPACING, _LOW, "its vertex is Lemma 1's, half way up, unless the options say otherwise"),
          ">= 1/(8 d3) mfs", "square", check=_keeps("feature size >= 1/(8 d3)", _MILLIONTH / 16, "tall")),
    Claim("phase-3.low-vertex", _THREE, "any Steiner-free quasi-trapz takes its vertex at 1/(8 d3) from B",
          (*_SPACING, _LOW, "the vertex is over the abscissa that Lemma 1 gives"), ">= 1/(8 d3) mfs", "square",
          check=_low_vertex,
          corrected="the text's reason, a height of 1/(2 d3), is false where phase 2 left no rectangle: the height is "
                    "about 1/4, and the vertex can even lie outside; Lemma 1's own vertex keeps the bound",
          repair=_REPAIR, witness="leaning-roof"),
    Claim("phase-3.value", _THREE, "1/(8 d3) is roughly 0.022",
          (_READING, "roughly means: in three decimals"), "within 0.0005", "number",
          check=_number(paper_tube_unsnapped_check.check_low_number),
          corrected="sin(pi/8)/16 = 0.0239; the stated value belongs to d3 = 4 sqrt 2", witness="unit-square"),
    Claim("phase-4.spacing", _FOUR, "vertices on a rectangle are 1/(2 d3) apart",
          (*_SPACING, "read as: at least; the spacing is that of the grid over the sine of the edge's angle"),
          ">= 1/(2 d3) mfs", "square",
          check=lambda run: paper_tube_check.check_gaps(run.paper.tube, run.paper.points, run.paper.mfs_squared,
                                                        _spacing_squared(run))),
    Claim("phase-4.longer-side", _FOUR, "the vertices are on a longer side of the rectangle",
          _SIMPLE, ">= 1", "square",
          check=lambda run: paper_tube_check.check_longer_side(run.paper.tube, run.paper.points)),
    Claim("phase-4.feature-size", _FOUR, "the formula in Lemma 3 yields more than 0.024",
          (*_SIMPLE, "the rectangles are filled by Lemma 3"), "> 0.024 mfs", "square", check=_phase_4_value,
          corrected="true of f1, and of the whole rectangle when the middles of g_i are the tips of the gaps beside "
                    "them; with tips over the middle of each gap long rectangles fall below 0.018",
          repair=_REPAIR, witness="doubling-columns"),
    Claim("tube.feature-size", _THREE, "1/(8 d3) bounds the feature size of the Tube",
          (*_SPACING, _LOW), ">= 1/(8 d3) mfs", "square",
          check=_keeps("feature size >= 1/(8 d3)", _MILLIONTH / 16, *paper_tube_check.PHASES),
          corrected="true when Lemma 3's teeth are re-tiled", repair=_REPAIR, witness="long-teeth"),
    Claim("phase-4.vertex-count", _NUMBER, "new vertices are proportional to those on the rectangle's boundary",
          (*_SIMPLE, "the rectangles are filled by Lemma 3"), "<= 3 a gap", "number", check=_count,
          corrected="Lemma 3 bounds them by c, the length in units of w: one vertex far along takes about 2 log2 c",
          repair="the nested apexes are as many as the gaps, whatever their lengths", witness="one-far-vertex"),
    Claim("theorem-1.steiner-count", _NUMBER, "the number of Steiner vertices is linear",
          (*_SIMPLE, "a corner has at most 3 vertices of P4, 6 chord ends, 3 trapezoids; an edge 3 vertices of phases "
           "2 and 3, and with the proportion of Lemma 3 three for each of 7 gaps"), "<= 36 a corner", "number",
          check=_steiner_count,
          corrected="the number grows with the logarithm of the spread as well; it is linear if Lemma 3 leaves out the "
                    "edges of octaves without vertices", repair="at most 35 a corner, checked on every run",
          witness="one-far-vertex"),
)

_THEOREM_2: tuple[Claim, ...] = (
    Claim("theorem-2.layered-rectangle", "Theorem 2", "layers keep the feature size up to a factor O(log n)",
          _LAYERED, ">= min(h, w) / (sqrt(2) (1 + floor(log2 n)))", "square",
          check=_layers(lemma_3_check.check_layers_feature), kinds=_PROPER),
    Claim("theorem-2.layer-count", "Theorem 2", "there are O(log n) layers",
          _LAYERED, "<= 1 + floor(log2 n)", "number", check=_layers(lemma_3_check.check_layer_count), kinds=_PROPER),
    Claim("theorem-2.proper-rectangle", "Theorem 2, Fig. 2 B", "the layers are a proper triangulation",
          _LAYERED, check=_layers(lambda tube, points: lemma_3_check.check_proper(tube)),
          kinds=_PROPER),
    Claim("theorem-2.only-rectangles", "Theorem 2", "only the rectangles must be replaced to make all proper",
          _SIMPLE, check=_only_within("rectangle"),
          corrected="trapezoids with T-vertices are not properly triangulated either",
          repair="the proper version fills interior faces by layers as well", witness="l-shape-192"),
    Claim("theorem-3.only-tube", "Theorem 3", "the mesh is nonproper only within the quasi-trapz of the Tube",
          _SIMPLE, check=_only_within("cut", "rest", "tall", "low", "rectangle"),
          corrected="trapezoids of the Interior carry vertices on their sides as well",
          repair="internal meshes continue the vertices on chords across the Interior, up to P", witness="l-shape-192"),
)

TUBE_CLAIMS: tuple[Claim, ...] = (*_PHASE_1, *_PHASE_2, *_PHASES_3_4, *_THEOREM_2)
