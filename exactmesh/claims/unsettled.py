"""Why the claims that are neither proved nor refuted are not: a sentence each, and what is known.

Whatever is proved or refuted later leaves this list; the tests see to it that it holds those claims and no others.
"""

from types import MappingProxyType

_ANY = ("it speaks of all constructions there may be, and of growth as n grows, which is outside the algebra of reals;"
        " ")
_WHOLE = ("it follows from claims about faces of the repaired construction, not all of which are proved; ")
_SWEEP = ("it is about which vertices and edges a sweep joins, not about finitely many real numbers: no engine for "
          "polynomials settles it; ")
_RUN = _SWEEP + "checked on every run, and no exception is known"
_SECTION_5 = ("without O it says nothing of the constant; with 6875, which every run asserts, it follows from what is "
              "proved of strips for a mesh with O(n) triangles of heights Omega(mfs), which is `repaired.degradation` "
              "and `repaired.steiner-count`")

UNSETTLED = MappingProxyType({
    "section-1.linear-time": (
        "a running time is no statement about numbers; ours is near-linear, measured by `exactmesh bench`"),
    "section-1.proper-lower-bound": _ANY + "the paper gives neither a proof nor the inputs",
    "section-1.holes": (
        "it is about a program that the paper does not describe; the repaired construction takes holes, and is checked"
        " on each"),
    "table-1.internal": _WHOLE + "`exactmesh reproduce table1` shows the growth",
    "theorem-3.degradation": (
        _WHOLE + "for the repaired construction it is checked on every run (`repaired.internal-degradation`)"),
    "theorem-3.triangulation": _RUN,
    "section-5.pieces": _SECTION_5,
    "section-5.pieces-many": _SECTION_5,
    "repaired.tube-feature": (
        "strips with a parallel clean side are proved but for the last 8 percent, slanted ones are not; no search "
        "found a face below the bound"),
    "repaired.degradation": (
        "it is the least of its faces, of which those of the Interior are proved and those of the Tube as far as "
        "`repaired.tube-feature` is; the worst of all searches is 21.5518"),
    "repaired.internal-degradation": _WHOLE + "the worst of all searches is 22.04",
    "repaired.proper-degradation": (
        "proved is 22 (1 + log2 n), `repaired.proper-degradation-22`: the number of gaps in a piece is counted with "
        "room to spare; the worst of all searches is 8.04 (1 + log2 n)"),
})
