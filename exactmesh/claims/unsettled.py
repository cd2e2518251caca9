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
        "polygons between columns from chord to chord are proved; those with parts of legs or steps, at the ends of "
        "rooms and at the ends of edges, some 40 kinds, are not; the worst of all searches is 22.04"),
    "repaired.proper-degradation": (
        "proved is 22 (1 + log2 n), `repaired.proper-degradation-22`: the number of gaps in a piece is counted with "
        "room to spare; the worst of all searches is 8.04 (1 + log2 n)"),
})
