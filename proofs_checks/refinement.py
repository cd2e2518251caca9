"""Prove what Section 2 says of P3 and P4: distances from P, feature sizes, snapping, and the numbers 8 d3.

Given   v, a reflex vertex at the origin, mfs(P) = 1; a, m on the circle of radius 1/4 about v; s = sin(pi/8), the
        only root of 8 s^4 - 8 s^2 + 1 with 0 <= s <= 1/2, q = sqrt 2. Of s and q only bounds are used, written so that
        they are hypotheses with rational solutions: 8 s^4 - 8 s^2 + 1 >= 0 says s <= sin(pi/8), <= 0 says >=.
Claim   P3 keeps 1/(4 sqrt 2) from P; prolonged edges keep more than 1/4 from P and stay within sqrt(2)/4 of v;
        mfs(P3) >= 1/d3 = s/2; snapping by 1/(4 d3) leaves mfs(P4) >= 1/(2 d3), and 1/(4 sqrt 2) - 1/(4 d3) to P;
        8 d3 = 16/s < 45 with this reading, 8 d3 = 32 sqrt 2 > 45 with d3 = 4 sqrt 2.
Method  chords, turned so that a = (1/4,0): |(1-t) a + t m|^2 = (1-t)^2/16 + t^2/16 + 2 t (1-t) a.m, a.m >= 0.
        `nearest-end`: where an angle is 90 degrees or more, the nearest point of the other leg is the vertex.
        mfs(P3), n >= 4: a point of P3 is within sqrt(2)/4 of what it comes from, an edge or a vertex of P. A vertex of
        P3 and an edge of P3 that come from disjoint features are 1 - sqrt(2)/2 or more apart; that is all pairs but
        those at one reflex vertex, where all angles of P3 are obtuse and the nearest point is an end: chords are
        s/2 or longer, edges 1/2 or longer (Appendix A). n = 3: P3 is P scaled by 1 - 1/(4 r) >= 1/4, r >= 1/3.
        P4: Lemma 2 with a motion of half the spacing.
Tight   1/(4 sqrt 2): two perpendicular radii (arcs of 180 degrees, the limit); s/2: a right angle.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, equal, main, more, square, states

from exactmesh.proofs.polynomial import variables

ax, ay, mx, my, t, c, s, q, x, y, ux, uy, b = variables("ax ay mx my t c s q x y ux uy b")
circle = (equal(16 * (ax * ax + ay * ay), 1), equal(16 * (mx * mx + my * my), 1))
within = (at_least(t), at_least(1, t))
px, py = (1 - t) / 4 + t * mx, t * my
below = (at_least(s), at_least(1, 2 * s), at_least(8 * s**4 - 8 * s**2 + 1))
above = (at_least(s), at_least(1, 2 * s), at_least(0, 8 * s**4 - 8 * s**2 + 1))

CHORD = [bounded("refinement.chord", "a chord of 90 degrees or less keeps 1/(4 sqrt 2) from the centre",
                 (circle[1], *within, at_least(mx)),
                 lambda f: at_least(32 * (px * px + py * py), square(f)), Hint(squares=(2 * t - 1,), degrees=(4,)),
                 {"mx": "0", "my": "1/4", "t": "1/2"})]
NEAREST = [bounded("refinement.nearest-end", "at an angle of 90 degrees or more the nearest point is the vertex",
                   (at_least(b), at_least(0, x * ux + y * uy), more(x * x + y * y)),
                   lambda f: at_least((x - b * ux)**2 + (y - b * uy)**2, square(f) * (x * x + y * y)),
                   Hint(squares=(b * ux, b * uy), degrees=(4,)))]
PROLONGED = [
    states("refinement.prolonged-from-p", "a point b > 0 beyond the end of the arc is farther than 1/4 from v",
           (more(b),), more(16 * b * b + 1, 1)),
    bounded("refinement.prolonged-reach", "for b <= 1/4, tan of half of 90 degrees, it is within sqrt(2)/4 of v",
            (more(b), at_least(1, 4 * b)), lambda f: at_least(mpq(1, 8) / square(f), b * b + mpq(1, 16))),
    states("refinement.prolonged-others", "1 - sqrt(2)/4 > 1/4: edges that do not end in v are farther",
           (more(q), at_least(2, q * q)), more(3, q), Hint(degrees=(2, 3))),
]
OTHERS = [states("refinement.chord-others", "3/4 > 1/(4 sqrt 2), as q >= sqrt 2 >= 1: other edges are farther",
                 (more(q), at_least(q * q, 2)), more(3 * q, 1))]
LENGTH = [
    bounded("refinement.chord-length", "16 a.m <= c makes a chord at least sqrt((1 - c)/8) long; c = cos 45",
            (*circle, at_least(c, 16 * (ax * mx + ay * my)), at_least(c), at_least(1, c)),
            lambda f: at_least(16 * ((ax - mx)**2 + (ay - my)**2), square(f) * (2 - 2 * c)),
            sharp={"ax": "1/4", "ay": "0", "mx": "3/20", "my": "1/5", "c": "3/5"}),
    bounded("refinement.apart", "1 - sqrt(2)/2 > sin(pi/8)/2", (*below, more(q), at_least(2, q * q)),
            lambda f: more(2 - q, s * mpq(f)), Hint(cells=400)),
    states("refinement.half", "1/2 > sin(pi/8)/2", below, more(1, s)),
    states("refinement.triangle", "1/4 > sin(pi/8)/2 and 1/4 <= 1 - 1/(4 r) for 3 r >= 1",
           (*below, at_least(3 * b, 1)), at_least(4 * (4 * b - 1), 4 * b)),
    bounded("refinement.quarter", "1/4 > sin(pi/8)/2", below, lambda f: more(1, 2 * s * mpq(f)), Hint(cells=400)),
]
SNAP = [
    bounded("refinement.both-regions", "1/(4 sqrt 2) - sin(pi/8)/8 >= sin(pi/8)/4",
            (*below, more(q), at_least(q * q, 2)), lambda f: at_least(q, 3 * s * mpq(f)), Hint(cells=400)),
    bounded("refinement.8-d3-octagon", "16/sin(pi/8) < 45", above,
            lambda f: more(45 * s / mpq(f), 16), Hint(cells=400)),
    bounded("refinement.8-d3-tube", "32 sqrt 2 > 45", (more(q), at_least(q * q, 2)),
            lambda f: more(32 * q, 45 * mpq(f)), Hint(squares=(q - mpq(7, 5),))),
]
STATEMENTS = [*CHORD, *NEAREST, *PROLONGED, *OTHERS, *LENGTH, *SNAP]
LEMMA_2 = ("lemma-2.point-of-edge", "lemma-2.triangle-inequality", "lemma-2.distance-left")
FROM_P = ("A point of P3 over an arc has v as its nearest point among the two edges of v, because it makes angles of "
          "90 degrees or more with them; other edges are 1 or more from v. Elsewhere P3 is on P2.")
APART = (FROM_P + " Pairs of a vertex and an edge of P3 are sorted by what they come from, as in the script; edges are "
         "1/2 or longer by Appendix A.")


def names(*parts: list) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


APPENDIX = tuple(f"appendix-a.{name}" for name in (
    "csc-foot-on-u", "q1-foot", "csc-foot-beyond", "depth", "one-reflex-acute", "one-reflex-positive",
    "one-reflex-obtuse", "no-acute-end", "two-acute-ends", "z-left-of-p2", "tangent-before", "tangent-beyond",
    "tangent-on", "one-acute-end", "formula-above-half", "triangle-radius"))
P3 = (*names(NEAREST, PROLONGED, LENGTH), *APPENDIX)
GROUP = "refinement"
THEOREMS = [
    Theorem("section-2.p3-tube-distance", "claim", "P3 keeps 1/(4 sqrt 2) from P", names(CHORD, NEAREST, PROLONGED,
            OTHERS), FROM_P, "the infimum, for arcs that tend to 180 degrees"),
    Theorem("section-2.extension-distance-from-p", "claim", "a prolonged edge keeps more than 1/4 from P",
            names(NEAREST, PROLONGED), FROM_P, "1/4 at the end of the arc"),
    Theorem("section-2.extension-distance-from-vertex", "claim", "a prolonged edge stays within sqrt(2)/4 of v",
            names(PROLONGED[1:2]), "v is the origin, the edge runs at height 1/4 from the end of the arc on.",
            "attained at 90 degrees"),
    Theorem("section-2.p3-octagon-reason", "corrected", "the chord of 45 degrees is sin(pi/8)/2 long",
            names(LENGTH[:1]), "2 - 2 cos 45 = 4 sin(22.5)^2.", "an equality"),
    Theorem("section-2.p3-feature-size", "claim", "mfs(P3) >= sin(pi/8)/2", P3, APART, "attained at right angles"),
    Theorem("section-2.p4-feature-size", "claim", "mfs(P4) >= 1/(2 d3)", (*P3, *LEMMA_2),
            APART + " Lemma 2: each vertex moves by at most 1/(4 d3), which is asserted on every run; with d3 = "
            "4 sqrt 2 1/d3 is less.", "vertices nearly above each other at distance 1/d3"),
    Theorem("section-2.p4-tube-distance", "claim", "P4 keeps 1/(4 sqrt 2) - 1/(4 d3) from P",
            (*names(CHORD, NEAREST, PROLONGED, OTHERS), *LEMMA_2), FROM_P + " P stays, P4 moves by at most 1/(4 d3)."),
    Theorem("section-2.p4-both-regions", "claim", "P and P4 together keep 1/(2 d3)",
            (*P3, *names(CHORD, OTHERS, SNAP[:1]), *LEMMA_2), APART + " With d3 = 4 sqrt 2 the distance is 3/(16 sqrt "
            "2), above 1/(2 d3)."),
    Theorem("theorem-1.degradation", "part", "8 d3 is 41.81 or 45.25: only the first reading is below 45",
            names(SNAP[1:]), "8 d3 = 16/sin(pi/8) or 32 sqrt 2."),
]

if __name__ == "__main__":

    main(GROUP, THEOREMS, STATEMENTS)
