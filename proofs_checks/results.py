"""Prove what the paper promises of nonproper triangulations, by the repaired construction: `abstract.nonproper`,
`table-1.nonproper`; `repaired.degradation`; and Theorem 1's bounds, in runs of that construction.

Given   m <= mfs(P) <= (1 + 10^-6) m; every face of the Interior and of the Tube keeps m g/5; they tile what is to be
        meshed, and no vertex is put on P.
Claim   the mesh keeps mfs(P)/21.6; so it does mfs(P)/45 and 0.022 mfs(P), for which 0.0223 m is enough.
Method  a shortest segment from a vertex to a feature without it crosses no edge, so it lies in a face of the mesh, or
        of P where nothing is meshed. The rest is linear.
Tight   5/g = 21.5517 is attained, with 21.6 there is room for m.
By hand that nothing crosses a shortest segment: an edge across it would have a nearer point.
"""

from gmpy2 import mpq
from kit import Theorem, at_least, bounded, main, more, states

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import DESIGN_DEGRADATION, FEATURE, TUBE_FEATURE

m, M, f = variables("m M f")
UNIT = (more(m), at_least(M, m), at_least(m * (1 + mpq(1, 10**6)), M))
MESH = (*UNIT, at_least(f, TUBE_FEATURE * m))
STATEMENTS = [
    bounded("results.below-45", "what the Tube keeps is more than mfs/45", MESH, lambda k: more(45 * f, M * mpq(k))),
    bounded("results.above-0-022", "and more than 0.022 mfs", MESH, lambda k: more(f, mpq(22, 1000) * M * mpq(k))),
    states("results.interior", "the Interior keeps more", (more(m), at_least(f, FEATURE * m)),
           at_least(f, TUBE_FEATURE * m)),
]
DESIGN = bounded("results.design", "what all faces keep is mfs/21.6 or more", (*UNIT, at_least(f, FEATURE * m)),
                 lambda k: at_least(DESIGN_DEGRADATION * f, M * mpq(k)))


NAMES = tuple(statement.id for statement in STATEMENTS)
STATEMENTS.append(DESIGN)
RESTS_ON = ("repaired.unit", "repaired.interior-feature", "repaired.tube-feature-45", "repaired.interior-tiling",
            "repaired.tube-tiling")
BY_FACES = ("By `repaired.interior-tiling` and `repaired.tube-tiling` the faces are a triangulation, but for "
            "triangles, which stay as they are and keep their heights. A shortest segment from a vertex to an edge or "
            "vertex without it is in one face of it, or in what is not meshed, where nothing is new.")
LEAST = "not tight: all that is known keeps mfs/21.6"
GROUP = "results"
THEOREMS = [
    Theorem("repaired.degradation", "claim", "the degradation is at most 21.6", (DESIGN.id,), BY_FACES,
            "5/g = 21.5517 is attained", ("repaired.unit", "repaired.interior-feature", "repaired.tube-feature",
                                          "repaired.interior-tiling", "repaired.tube-tiling")),
    Theorem("abstract.nonproper", "claim", "every n-gon or PSLG has a nonproper triangulation of degradation below 45",
            NAMES, BY_FACES, LEAST, RESTS_ON),
    Theorem("table-1.nonproper", "claim", "so the degradation is O(1)", NAMES, BY_FACES, LEAST, RESTS_ON),
    Theorem("theorem-1.degradation", "repaired", "below 45", NAMES, BY_FACES, LEAST, RESTS_ON),
    Theorem("theorem-1.feature-size", "repaired", "at least 0.022 of the input's", NAMES, BY_FACES, LEAST,
            RESTS_ON),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
