"""The claims of section 2 on its lemmas and the Interior, then those on the Tube, in the order of the paper.

Where the paper has 1/(2 d3), the construction has the spacing of its grid, a rational less than half a percent below;
bounds that are made of 1/(2 d3) are taken with that spacing, because it is what the argument is about. Numbers that the
paper states are taken as they are.
"""

from collections.abc import Callable

from exactmesh.claims.claim import Claim
from exactmesh.claims.run import Run
from exactmesh.claims.section_2_tube import TUBE_CLAIMS
from exactmesh.measure.verdict import Verdict
from exactmesh.steps import lemma_1_check, lemma_3_check, paper_interior_check

Check = Callable[[Run], Verdict]

_BEFORE = "Section 2, before Lemma 1"
_INTERIOR = "Section 2, Triangulation of Interior"
_SIMPLE = ("P is a simple polygon",)
_SHAPE = (*_SIMPLE, "T-vertices on the trapezoids of P5 are left out of account")
_NESTED = (*_SIMPLE, "the rectangles of the Tube are filled by Lemma 3",
           "what its text leaves open, the right end and free positions, is as in `lemma_3.py`")
_ALL_OCCUPIED = (*_NESTED, "there is a vertex at every position")
_SPACING = "the grid's spacing stands for 1/(2 d3)"
_INTERIOR_REPAIR = "T-vertices are absorbed by wedges, cross edges and nested apexes, so every face keeps g/5"
_TEETH = ("teeth with their tips over the middle of each gap keep min(f1, h w / sqrt(25 h^2 + 9 w^2)), with 16 for "
          "25 where each anchored edge reaches just twice as far as the last one; with the "
          "middles of g_i as the tips of the gaps beside them, min(f1, f2) is kept")
_NESTED_REPAIR = "one routine for one-sided quadrilaterals, as many nested apexes as gaps, keeps g/5; there is no R"


def _centre(fits: bool) -> Check:
    return lambda run: lemma_1_check.check_centre(run.paper.trapezoidation, run.paper.points, fits)


def _shapes(check: Callable[..., Verdict]) -> Check:
    return lambda run: check(run.paper.trapezoidation, run.paper.points)


def _rectangles(check: Callable[..., Verdict]) -> Check:
    """Judge the rectangles of runs that use Lemma 3; in others there is nothing to judge."""
    return lambda run: (check(run.paper.tube, run.paper.points) if run.options.rectangle == "nested"
                        else Verdict(0, True))


def _count(run: Run) -> Verdict:
    return _rectangles(lambda tube, points: lemma_3_check.check_count(tube, points, occupied=False))(run)


def _lemma_1(run: Run) -> Verdict:
    return lemma_1_check.check_lemma(run.paper.trapezoidation, run.paper.interior, run.paper.points)


def _p6_tiles(run: Run) -> Verdict:
    made = run.paper
    return paper_interior_check.check_tiling(made.p4, made.trapezoidation, made.interior, made.points)


def _p6_degradation(run: Run) -> Verdict:
    made = run.paper
    return paper_interior_check.check_degradation(made.p4, made.trapezoidation, made.interior, made.points)


def _p6_feature(clean_only: bool) -> Check:
    def check(run: Run) -> Verdict:
        made = run.paper
        return paper_interior_check.check_feature(made.trapezoidation, made.interior, made.points, made.p4.spacing,
                                                  made.mfs_squared, clean_only)
    return check


_LEMMA_CLAIMS: tuple[Claim, ...] = (
    Claim("section-2.rectangle-centre", _BEFORE, "its centre halves the mfs of a rectangle",
          _SHAPE, "= 1/2", "square", check=_centre(True)),
    Claim("section-2.parallelogram-feature-size", _BEFORE,
          "the mfs of a parallelogram is its height or the distance of its lower right vertex from the left leg",
          _SHAPE, "= min(h, l h / sqrt(a^2 + h^2))", "square", check=_shapes(lemma_1_check.check_slant)),
    Claim("section-2.parallelogram-centre", _BEFORE, "its centre halves the mfs of a parallelogram",
          _SHAPE, "= 1/2", "square", check=_centre(False)),
    Claim("lemma-1.case-1-feature-size", "Lemma 1, proof, first case",
          "where the rectangle over the shorter side fits, its sides are the mfs",
          _SHAPE, "mfs(H) = min(h, l)", "square", check=_shapes(lemma_1_check.check_case_1)),
    Claim("lemma-1.side-distance", "Lemma 1, proof, first case",
          "the new vertex is farther than l/2 from the sides of the trapezoid",
          _SHAPE, "> l/2", "square", check=_shapes(lemma_1_check.check_side_distance),
          corrected="it is at least l/2 away, and exactly l/2 where a side is vertical; the lemma needs no more",
          witness="unit-square"),
    Claim("lemma-1.case-2-feature-size", "Lemma 1, proof, second case",
          "where it does not fit, the parallelogram swept by the shorter side has the same mfs",
          _SHAPE, "mfs(H) = mfs(P)", "square", check=_shapes(lemma_1_check.check_case_2)),
    Claim("lemma-1.degradation", "Lemma 1", "one vertex triangulates a trapezoid with degradation 2",
          (*_SIMPLE, "the trapezoid has no T-vertices"), ">= mfs(H)/2", "square", check=_lemma_1),
    Claim("lemma-3.hypothesis", "Lemma 3, as used in phase 4", "each rectangle is higher than its positions are apart",
          _NESTED, "h > w", "square", check=_rectangles(lemma_3_check.check_hypothesis),
          corrected="h > w fails above edges that are less steep than about 38 degrees; what Lemma 3 keeps grows with "
                    "w, so the value of phase 4 does not depend on it", repair=_NESTED_REPAIR, witness="low-roof"),
    Claim("lemma-3.positions", "Lemma 3, as used in phase 4", "vertices stand only at multiples of the spacing w",
          _NESTED, check=_rectangles(lemma_3_check.check_positions)),
    Claim("lemma-3.triangulation", "Lemma 3", "the rectangle is nonproperly triangulated",
          _NESTED, check=_rectangles(lemma_3_check.check_tiling)),
    Claim("lemma-3.boundary", "Lemma 3", "no vertex is added on the boundary of the rectangle",
          _NESTED, check=_rectangles(lemma_3_check.check_boundary)),
    Claim("lemma-3.vertex-count", "Lemma 3", "the number of new vertices is linear in c",
          _NESTED, "<= 3 c", "number", check=_count),
    Claim("lemma-3.fan-distance", "Lemma 3, proof", "vertices on an anchored edge keep away from the next one",
          _NESTED, ">= f1 = w (h/6) / sqrt((h/6)^2 + w^2)", "square", check=_rectangles(lemma_3_check.check_fan)),
    Claim("lemma-3.teeth-distance", "Lemma 3, proof, Fig. 3", "the least distance in a sawtooth is on its right side",
          _ALL_OCCUPIED, ">= f2 = (h/3) (w/2) / sqrt((h/3)^2 + (w/2)^2)", "square",
          check=_rectangles(lemma_3_check.check_teeth), corrected="the least distance is at the left end: " + _TEETH,
          repair=_NESTED_REPAIR, witness="three-columns"),
    Claim("lemma-3.feature-size", "Lemma 3, proof", "both terms bound the feature size of the triangulated rectangle",
          _NESTED, ">= min(f1, f2)", "square", check=_rectangles(lemma_3_check.check_feature),
          corrected=_TEETH, repair=_NESTED_REPAIR, witness="doubling-columns"),
    Claim("lemma-3.degradation", "Lemma 3", "the degradation of the rectangle is constant",
          (*_NESTED, "it is measured against min(h, w), so that h > w is not needed"), ">= min(h, w) / sqrt(37)",
          "square", check=_rectangles(lemma_3_check.check_constant)),
)

_INTERIOR_CLAIMS: tuple[Claim, ...] = (
    Claim("section-2.p6-tiles", _INTERIOR, "P6 is a triangulation of P5 with one vertex in each trapezoid",
          (*_SIMPLE, "a trapezoid that is a triangle stays as it is"), check=_p6_tiles),
    Claim("section-2.p6-degradation", _INTERIOR, "the degradation from P5 to P6 is that of Lemma 1",
          _SIMPLE, ">= mfs(P5)/2", "square", check=_p6_degradation,
          corrected="true of P5 without T-vertices; with one at distance t from a corner of a trapezoid of length L "
                    "and height H, P6 keeps about t H / L, so the degradation grows with the spread of P",
          repair=_INTERIOR_REPAIR, witness="l-shape-192"),
    Claim("section-2.interior-feature-size", _INTERIOR, "the feature size of the Interior is a constant",
          (*_SIMPLE, _SPACING), ">= sin(pi/8)/8 mfs = 1/(4 d3) mfs", "square", check=_p6_feature(False),
          corrected="true of the trapezoids without T-vertices", repair=_INTERIOR_REPAIR, witness="spike-room"),
    Claim("section-2.clean-interior-feature-size", _INTERIOR,
          "the trapezoids without T-vertices keep the feature size of the Interior",
          (*_SIMPLE, _SPACING, "trapezoids with T-vertices are left out"), ">= 1/(4 d3) mfs", "square",
          check=_p6_feature(True)),
)

MESH_CLAIMS: tuple[Claim, ...] = (*_LEMMA_CLAIMS, *_INTERIOR_CLAIMS, *TUBE_CLAIMS)
