"""Why the claims that are neither proved nor refuted are not: a sentence each, and what is known.

Whatever is proved or refuted later leaves this list; the tests see to it that it holds those claims and no others.
"""

from types import MappingProxyType

_WHOLE = ("it follows from claims about faces of the repaired construction, not all of which are proved; ")

UNSETTLED = MappingProxyType({
    "section-1.linear-time": (
        "a running time is no statement about numbers; ours is near-linear, measured by `exactmesh bench`"),
    "section-1.proper-lower-bound": (
        "it speaks of all triangulations there may be, and of growth as n grows; the paper gives neither a proof nor "
        "the inputs, but cites them"),
    "section-1.holes": (
        "what is trivial is no statement about numbers; the bounds are proved of polygons with holes by the repaired "
        "construction (`abstract.nonproper`, `abstract.proper`)"),
    "table-1.internal": _WHOLE + "`exactmesh reproduce table1` shows the growth",
    "theorem-3.degradation": (
        _WHOLE + "for the repaired construction it is checked on every run (`repaired.internal-degradation`)"),
    "repaired.internal-degradation": (
        "given the gaps between feet, faces of the Tube, polygons from chord to chord and those with one leg are "
        "proved; those with legs on both sides or more parts are not; the worst of all searches is 22.04"),
    "repaired.proper-degradation": (
        "proved is 22 (1 + log2 n), `repaired.proper-degradation-22`: the number of gaps in a piece is counted with "
        "room to spare; the worst of all searches is 8.04 (1 + log2 n)"),
})
