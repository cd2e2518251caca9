"""Claims of the paper that no single input settles: about families, all meshes, other work, running times.

They are in the ledger so that it is complete; without a checker their status reads "open" until a proof is tied to
them. `corrected` says what an audit found to be the true statement.
"""

from collections.abc import Iterator

from exactmesh.claims.claim import Claim

# id, place, the statement, the corrected statement ("" where the statement is believed as it stands)
_STATEMENTS: tuple[tuple[str, str, str, str], ...] = (
    ("abstract.nonproper", "Abstract", "every n-gon or PSLG has a nonproper triangulation of degradation O(1)", ""),
    ("abstract.proper", "Abstract", "every PSLG of n vertices has a proper triangulation of degradation O(log n)", ""),
    ("section-1.drawing", "section 1", "the mfs is the greatest uniform thickness edges can be drawn with", ""),
    ("section-1.vertex-error", "section 1", "the mfs is the greatest error of vertices that keeps the topology",
     "any error below half the mfs is safe, and half the mfs is not"),
    ("section-1.regular-polygon", "section 1", "classic triangulations of the regular n-gon have degradation Omega(n)",
     "exactly at least 1/sin(pi/n), which is attained, for n >= 4"),
    ("section-1.rectangle", "section 1", "classic triangulations of the r x 1 rectangle with two middle vertices have "
     "degradation Omega(r)", "exactly at least sqrt(((r + 1)/2)^2 + 1), which is attained"),
    ("section-1.bounded-faces", "section 1", "both lower bounds extend to faces of bounded complexity", ""),
    ("section-1.steiner-needed", "section 1", "Steiner points are needed for sublinear degradation", ""),
    ("section-1.heights", "section 1", "if all heights of a proper triangulation are at least h, so is its ifs", ""),
    ("section-1.linear-size", "section 1", "the mesh has O(n) Steiner points and triangles",
     "needs a version of Lemma 3 that counts occupied positions"),
    ("section-1.linear-time", "section 1", "the algorithm runs in O(n) time",
     "for simple polygons, with linear-time medial axis and trapezoidation and a floor function"),
    ("section-1.proper-lower-bound", "section 1",
     "proper triangulations need Omega(log n / log log n) degradation", ""),
    ("section-1.holes", "section 1", "the extension to polygons with holes is trivial",
     "one offset curve a boundary component; not the O(n) time"),
    ("section-1.faces-apart", "section 1", "the construction can be applied to each face of a PSLG separately",
     "once distances between two vertices count in the mfs: two isolated vertices close together refute it otherwise"),
    ("table-1.classic", "Table 1", "classic triangulations: Omega(n + r)", ""),
    ("table-1.proper", "Table 1", "proper triangulations: O(log n)", ""),
    ("table-1.nonproper", "Table 1", "nonproper triangulations: O(1)", ""),
    ("table-1.internal", "Table 1", "internal feature size: O(1), proper", ""),
    ("theorem-2.degradation", "Theorem 2", "every polygon has a proper triangulation of degradation O(log n)", ""),
    ("theorem-3.degradation", "Theorem 3", "every polygon has a proper triangulation of O(1) ifs degradation", ""),
    ("section-5.lower-bound", "section 5", "dissecting a square into an r x 1 rectangle needs Omega(sqrt r) pieces",
     ""),
    ("section-5.pieces", "section 5", "two polygons have a dissection of (n1 + n2)(r1 + r2) pieces", ""),
    ("section-5.pieces-many", "section 5", "k polygons have one of k (sum of n)(sum of r) pieces", ""),
    ("section-5.epsilon", "section 5", "half the least height of the triangles is half the ifs of the triangulation",
     "the heights are at least the ifs, with equality for proper triangulations"),
    ("section-5.strip", "section 5", "one polygon is cut into O(n A/epsilon) pieces",
     "after scaling to A = 1: at most 6/epsilon pieces a triangle"),
    ("section-5.vertical-line", "section 5", "a vertical line meets O(1) cuts of the strip", ""),
    ("section-5.overlay", "section 5", "overlaying two strips adds a constant factor", ""),
    ("section-5.scaling", "section 5", "scaling to area 1 uses a factor no smaller than O(1/D)", ""),
)

# How some of them are read.
_FEATURES = "distances of two vertices count in the mfs: see `section-1.faces-apart`"
_CONSTANT = "up to a constant factor, as it is derived"
_GIVEN = {
    "abstract.nonproper": (_FEATURES, "of a PSLG the bounded faces are meshed"),
    "abstract.proper": (_FEATURES, "of a PSLG the bounded faces are meshed"),
    "table-1.nonproper": (_FEATURES, "of the minimum feature size"),
    "section-1.bounded-faces": ("faces have at most k vertices, for a fixed k, and there are no Steiner points",),
    "section-1.drawing": ("vertices and edges are drawn as all points nearer than half the thickness",
                          "what is not to be obscured are vertices, by vertices and edges that they are not on"),
    "section-5.overlay": ("the strips are dissected as in docs/dissection.md",),
    "section-5.pieces": (_CONSTANT,),
    "section-5.pieces-many": (_CONSTANT,),
    "section-5.scaling": ("read: at least a constant over D",),
    "section-5.vertical-line": ("the strip is dissected as in docs/dissection.md",
                                "the line contains no cut and no corner"),
    "table-1.classic": ("for all n >= 6 and r >= 2 n, by a polygon with n vertices and a spread between r and r + 1",),
}


def _claims() -> Iterator[Claim]:
    for id_, place, says, corrected in _STATEMENTS:
        yield Claim(id_, place, says, _GIVEN.get(id_, ()), runs=(), corrected=corrected)


ELSEWHERE_CLAIMS: tuple[Claim, ...] = tuple(_claims())
