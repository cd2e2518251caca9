"""Prove what the paper promises of nonproper triangulations, by the repaired construction: `abstract.nonproper`,
`table-1.nonproper`; and Theorem 1's bounds, in their corrected form.

Given   m <= mfs(P) <= (1 + 10^-6) m; every face of the Interior keeps m g/5, every face of the Tube 0.0223 m; they tile
        what is to be meshed, and no vertex is put on P.
Claim   the mesh keeps mfs(P)/45 and 0.022 mfs(P).
Method  a shortest segment from a vertex to a feature without it crosses no edge, so it lies in a face of the mesh, or
        of P where nothing is meshed. The rest is linear.
Tight   no: the least that is known is mfs(P)/21.6.
By hand that nothing crosses a shortest segment: an edge across it would have a nearer point.
"""

from gmpy2 import mpq
from kit import Theorem, at_least, bounded, main, more, states

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FEATURE, TUBE_FEATURE

m, M, f = variables("m M f")
MESH = (more(m), at_least(M, m), at_least(m * (1 + mpq(1, 10**6)), M), at_least(f, TUBE_FEATURE * m))
STATEMENTS = [
    bounded("results.below-45", "what the Tube keeps is more than mfs/45", MESH, lambda k: more(45 * f, M * mpq(k))),
    bounded("results.above-0-022", "and more than 0.022 mfs", MESH, lambda k: more(f, mpq(22, 1000) * M * mpq(k))),
    states("results.interior", "the Interior keeps more", (more(m), at_least(f, FEATURE * m)),
           at_least(f, TUBE_FEATURE * m)),
]


NAMES = tuple(statement.id for statement in STATEMENTS)
RESTS_ON = ("repaired.unit", "repaired.interior-feature", "repaired.tube-feature-45", "repaired.interior-tiling",
            "repaired.tube-tiling")
BY_FACES = ("By `repaired.interior-tiling` and `repaired.tube-tiling` the faces are a triangulation, but for "
            "triangles, which stay as they are and keep their heights. A shortest segment from a vertex to an edge or "
            "vertex without it is in one face of it, or in what is not meshed, where nothing is new.")
LEAST = "not tight: all that is known keeps mfs/21.6"
GROUP = "results"
THEOREMS = [
    Theorem("abstract.nonproper", "claim", "every n-gon or PSLG has a nonproper triangulation of degradation below 45",
            NAMES, BY_FACES, LEAST, RESTS_ON),
    Theorem("table-1.nonproper", "claim", "so the degradation is O(1)", NAMES, BY_FACES, LEAST, RESTS_ON),
    Theorem("theorem-1.degradation", "corrected", "below 45, by the repaired construction", NAMES, BY_FACES,
            LEAST, RESTS_ON),
    Theorem("theorem-1.feature-size", "corrected", "at least 0.022 of the input's, by the repaired construction", NAMES,
            BY_FACES, LEAST, RESTS_ON),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
