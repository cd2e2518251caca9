"""Prove that spokes make 45 degrees or more with P3 before snapping (`phase-1.spoke-angle`, `phase-2.start-angle`).

Given   v, the vertex of P that a spoke starts from, is the origin; its other end t is a vertex of P3, d the direction
        from t along an edge of P3. The cosine of the angle is (-t).d / (|t| |d|).
Claim   the cosine is at most 1/sqrt(2): 2 ((-t).d)^2 <= |t|^2 |d|^2 wherever (-t).d > 0.
Method  end of an arc over 90 degrees: t and the middle m of the arc are on the circle of radius 1/4, t.m >= 0, and the
        edge e' is perpendicular to t. Prolonged edges: t = (b, 1/4), 0 <= b <= 1/4, d = (-1,0). Convex corner, k the
        cotangent of half its angle: t = (k/4, -1/4), d = (1,0), an obtuse angle.
Tight   arcs of 180 degrees (the limit) and prolonged edges over 90 degrees: 45 degrees.
By hand the three kinds of corners are all there are; the middle of a chain is no end of a spoke.
"""

from kit import Hint, Theorem, at_least, bounded, equal, main, square, states

from exactmesh.proofs.polynomial import variables

mx, my, b, k = variables("mx my b k")
STATEMENTS = [
    # t = (0, 1/4), d = m - t: (-t).d = (1 - 4 my)/16, |t|^2 = 1/16, 16 |d|^2 = 16 mx^2 + (4 my - 1)^2.
    bounded("spokes.chain", "at the end of a chord of 90 degrees or less, turned so that t = (0, 1/4)",
            (equal(16 * (mx * mx + my * my), 1), at_least(my), at_least(1, 4 * my)),
            lambda f: at_least((16 * mx * mx + (4 * my - 1)**2) / square(f), 2 * (1 - 4 * my)**2),
            Hint(degrees=(2, 3)), {"mx": "1/4", "my": "0"}),
    # (-t).d = b, |t|^2 = b^2 + 1/16, |d| = 1.
    bounded("spokes.prolonged", "at the tip of a prolonged edge, b <= 1/4", (at_least(b), at_least(1, 4 * b)),
            lambda f: at_least((b * b * 16 + 1) / square(f), 32 * b * b)),
    states("spokes.convex", "at a convex corner the angle is obtuse: (-t).d = -k/4", (at_least(k),), at_least(0, -k)),
]
KINDS = ("By the three kinds of corners: chains of two chords, prolonged edges, convex corners. Edges e' at the end "
         "of a chain are perpendicular to the spoke.")
GROUP = "spokes"
NAMES = tuple(statement.id for statement in STATEMENTS)
THEOREMS = [
    Theorem("phase-1.spoke-angle", "claim", "spokes make 45 degrees or more with P3", NAMES, KINDS,
            "45 degrees at the tip of edges prolonged over 90 degrees"),
    Theorem("phase-2.start-angle", "claim", "so does the top with the spokes at its ends", NAMES, KINDS,
            "45 degrees at the tip of edges prolonged over 90 degrees"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
