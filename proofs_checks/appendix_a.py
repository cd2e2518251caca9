"""Prove Appendix A for n >= 4, and its exact constant sqrt(3)/6 for triangles (`appendix-a.offset-edge-length`).

Given   mfs(P) = 1, e from p1 = (0,0) to p2 = (L,0), P below e; w1, w2 the angles there, k = cot(w1/2), j = cot(w2/2);
        u, before e, ends in q1 = c (k^2 - 1, -2 k), c > 0, and e_r, after e, in q2 = p2 + d (1 - j^2, -2 j), d > 0.
        An angle is acute when its k is above 1. A convex end takes k/4 off e', a reflex one nothing.
Claim   L - (k + j)/4 >= 1/2 for n >= 4; with one reflex end L - k/4 >= sqrt(2)/2; with w1 acute and w2 not,
        L - (k + j)/4 >= (k + 1/k)/4 = 1/(2 sin w1). In triangles L - (k + j)/4 >= sqrt(3)/6.
Method  a chain. `csc`: at an acute angle p2 keeps distance 1 from u, so L >= 1/sin w1. `depth`: u reaches depth 1, in
        y1 = ((k^2 - 1)/(2 k), -1). Two acute angles: y1 and y2 are on u and e_r, which are disjoint for n >= 4 and so
        at distance 1 or more, and y1 is on the left, because u and e_r would cross. One acute angle: y1 is at distance
        1 or more from e_r, so p2 is at least j to the right of z.
        Triangles: X, Y, Z are the lengths from the corners to the touching points of the incircle, r is its radius,
        r^2 (X + Y + Z) = X Y Z, and |e'| = (X + Y)(1 - 1/(4 r)).
Tight   1/2 at right angles (unit square); sqrt(2)/2 at k = sqrt 2; sqrt(3)/6 for the equilateral triangle.
By hand two edges that do not cross are nearest at an end of one of them, so disjoint edges keep distance mfs; the point
        that a foot is on an edge, before or beyond it decides which distance is meant. For n = 3 u and e_r meet, which
        is where the argument for n >= 4 fails.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, equal, main, more, refuted, square, states

from exactmesh.proofs.polynomial import variables

L, k, j, c, d, D = variables("L k j c d D")
X, Y, Z, r, e = variables("X Y Z r e")
acute = (more(k, 1),)
u_length = c * (1 + k * k)**2
beyond = more(L * (k * k - 1), u_length)
csc = at_least(2 * k * L, 1 + k * k)
depth = at_least(2 * c * k, 1)

CSC = [
    states("appendix-a.csc-foot-on-u", "w1 acute, the foot of p2 on u, at distance 1 or more: L >= 1/sin w1",
           (*acute, more(L), at_least(4 * k * k * L * L, (1 + k * k)**2)), csc),
    states("appendix-a.q1-foot", "if the foot of p2 is beyond u, that of q1 is on e, so that q1 is at depth 1 or more",
           (*acute, more(c), beyond), more(L, c * (k * k - 1))),
    states("appendix-a.csc-foot-beyond", "w1 acute, the foot of p2 beyond u: L >= 1/sin w1",
           (*acute, more(c), beyond, depth), csc),
]
DEPTH = [states("appendix-a.depth", "w1 acute: u reaches depth 1 also where the foot of q1 is beyond p2",
                (*acute, more(c), csc, more(c * (k * k - 1), L)), depth)]
ONE_REFLEX = [
    bounded("appendix-a.one-reflex-acute", "one reflex end, w1 acute: |e'| >= sqrt(2)/2", (*acute, csc),
            lambda f: at_least(2 * (L - k / 4)**2, square(f)), Hint(squares=(k * k - 2, k * L - 1, k - L))),
    states("appendix-a.one-reflex-positive", "one reflex end, w1 acute: |e'| > 1/2", (*acute, csc),
           more(L - k / 4, mpq(1, 2)), Hint(squares=(k - 1, k - 2, 2 * k - 3))),
    bounded("appendix-a.one-reflex-obtuse", "one reflex end, w1 not acute: |e'| >= 3/4",
            (at_least(k), at_least(1, k), at_least(L, 1)), lambda f: at_least(L - k / 4, mpq(3, 4) * mpq(f))),
]
UNIT = [states("appendix-a.unit-edge", "at an edge of length 1 no angle is acute", (*acute, at_least(1, L), csc), None,
               Hint(squares=(k - 1,)))]
REACH = [bounded("appendix-a.reach", "w1 acute: t1 is at most 1/4 beyond z", acute,
                 lambda f: at_least(mpq(1, 4) / mpq(f) * 4 * k, k * k - 2 * (k * k - 1)))]
OBTUSE = [bounded("appendix-a.no-acute-end", "no acute angle: |e'| >= 1/2",
                  (at_least(k), at_least(1, k), at_least(j), at_least(1, j), at_least(L, 1)),
                  lambda f: at_least(L - (k + j) / 4, mpq(1, 2) * mpq(f)))]
ACUTE = [bounded("appendix-a.two-acute-ends", "both angles acute, y1 and y2 at distance 1 or more: |e'| >= 1/2",
                 (more(k, 1), more(j, 1),
                  at_least(2 * k * j * L - j * (k * k - 1) - k * (j * j - 1), 2 * k * j)),
                 lambda f: at_least(L - (k + j) / 4, mpq(1, 2) * mpq(f)))]
flat = (at_least(j), at_least(1, j), more(D))
FORMULA = [
    states("appendix-a.z-left-of-p2", "w1 acute: D = L - (k^2 - 1)/(2 k) >= 1/k",
           (*acute, csc, equal(2 * k * D, 2 * k * L - k * k + 1)), at_least(k * D, 1)),
    states("appendix-a.tangent-before", "w2 not acute, the foot of y1 before e_r: D >= j",
           (*flat, at_least(D * (1 - j * j), 2 * j)), at_least(D, j)),
    states("appendix-a.tangent-beyond", "w2 not acute: the foot of y1 is not beyond q2, because e_r is 1 or longer",
           (*flat, more(d), at_least(d * (1 + j * j), 1), more(2 * j - D * (1 - j * j), d * (1 + j * j)**2)), None,
           Hint(squares=(j - 1,))),
    states("appendix-a.tangent-on", "w2 not acute, the foot of y1 on e_r: D >= j",
           (*flat, at_least((2 * D * j + 1 - j * j)**2, (1 + j * j)**2), more(j)), at_least(D, j)),
    bounded("appendix-a.one-acute-end", "one acute angle: |e'| >= (k + 1/k)/4 = 1/(2 sin w1)",
            (*acute, at_least(j), at_least(D, j), at_least(k * D, 1)),
            lambda f: at_least(4 * k * D + 2 * (k * k - 1) - k * k - j * k, (k * k + 1) * mpq(f))),
    states("appendix-a.formula-above-half", "1/(2 sin w1) >= 1/2", acute, at_least(k * k + 1, 2 * k),
           Hint(squares=(k - 1,))),
]
sides = (more(e), more(Z), more(r))
amount = at_least(e * e * Z, 4 * r * r * (e + Z))
heights = at_least(4 * r * (e + Z), e + 2 * Z)
third = at_least(3 * r, 1)
TRIANGLE = [
    states("appendix-a.triangle-means", "r^2 (X + Y + Z) = X Y Z gives 4 r^2 (X + Y + Z) <= (X + Y)^2 Z",
           (more(X), more(Y), more(Z), more(r), equal(r * r * (X + Y + Z), X * Y * Z)),
           at_least((X + Y)**2 * Z, 4 * r * r * (X + Y + Z)), Hint(squares=(X - Y,))),
    states("appendix-a.triangle-heights", "two heights of 1 or more: 4 r (e + Z) >= e + 2 Z, where e = X + Y",
           (at_least(2 * r * (X + Y + Z), Y + Z), at_least(2 * r * (X + Y + Z), X + Z)),
           at_least(4 * r * (X + Y + Z), X + Y + 2 * Z)),
    states("appendix-a.triangle-radius", "three heights of 1 or more: r >= 1/3",
           (more(X), more(Y), more(Z), at_least(2 * r * (X + Y + Z), Y + Z), at_least(2 * r * (X + Y + Z), X + Z),
            at_least(2 * r * (X + Y + Z), X + Y)), third),
    states("appendix-a.triangle-thick", "e > 2 r", (*sides, amount), more(e, 2 * r)),
    states("appendix-a.triangle-thin", "for r < 1/2 the two constraints give e^2 (4 r - 1) >= 4 r^2",
           (*sides, amount, heights, third, more(1, 2 * r), more(e, 2 * r)), at_least(e * e * (4 * r - 1), 4 * r * r),
           Hint(degrees=(5, 6))),
    bounded("appendix-a.triangle-small", "for r < 1/2: |e'| = e (1 - 1/(4 r)) >= sqrt(3)/6",
            (*sides, third, at_least(e * e * (4 * r - 1), 4 * r * r)),
            lambda f: at_least(3 * e * e * (4 * r - 1)**2, 4 * r * r * square(f))),
    bounded("appendix-a.triangle-large", "for r >= 1/2: |e'| >= sqrt(3)/6",
            (*sides, more(e, 2 * r), at_least(2 * r, 1)),
            lambda f: at_least(3 * e * e * (4 * r - 1)**2, 4 * r * r * square(f))),
]
NOT_HALF = [
    refuted("appendix-a.triangle-13-14-15", "heights of 1 or more make |e'| = (X + Y)(1 - 1/(4 r)) >= 1/2",
            (more(X), more(Y), more(Z), more(4 * r, 1), equal(r * r * (X + Y + Z), X * Y * Z),
             at_least(2 * r * (X + Y + Z), Y + Z), at_least(2 * r * (X + Y + Z), X + Z),
             at_least(2 * r * (X + Y + Z), X + Y)),
            at_least((X + Y) * (4 * r - 1), 2 * r), {"X": "15/28", "Y": "5/8", "Z": "5/7", "r": "5/14"}),
]
NOT_ONE = [
    refuted("appendix-a.two-acute-not-one", "both angles acute, y1 and y2 at distance 1 or more: |e'| > 1",
            (more(k, 1), more(j, 1),
             at_least(2 * k * j * L - j * (k * k - 1) - k * (j * j - 1), 2 * k * j)), more(L - (k + j) / 4, 1)),
]
STATEMENTS = [*NOT_HALF, *NOT_ONE, *CSC, *DEPTH, *ONE_REFLEX, *UNIT, *REACH, *OBTUSE, *ACUTE, *FORMULA, *TRIANGLE]
GEOMETRY = ("mfs(P) = 1; coordinates along e as in the script; a distance is to an edge's line where the foot is on it "
            "and to its nearer end elsewhere; two edges that do not cross are nearest at an end of one of them. ")


def names(*parts: list) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


GROUP = "appendix-a"
THEOREMS = [
    Theorem("appendix-a.offset-edge-length", "corrected", "1/2 for n >= 4, sqrt(3)/6 for triangles",
            names(CSC, DEPTH, ONE_REFLEX, OBTUSE, ACUTE, FORMULA, TRIANGLE),
            GEOMETRY + "Cases by which ends are reflex, acute, neither.",
            "1/2: unit square; sqrt(3)/6: the infimum over triangles, attained by the equilateral one"),
    Theorem("appendix-a.offset-edge-length", "refuted", "false of the triangle with sides 13, 14, 15", names(NOT_HALF),
            "X, Y, Z, r as in the script; twice the area over a side is the height on it."),
    Theorem("appendix-a.both-angles-acute", "refuted", "|e'| > 1 does not follow from the distances used",
            names(NOT_ONE), GEOMETRY + "The witness of the ledger is a trapezoid of this kind."),
    Theorem("appendix-a.one-end-reflex", "claim", "|e'| >= sqrt(2)/2 > 1/2", names(CSC, ONE_REFLEX), GEOMETRY +
            "Triangles have no reflex corner.", "sqrt(2)/2 is approached at k = sqrt 2"),
    Theorem("appendix-a.unit-edge-angles", "claim", "|e| = 1 makes both angles 90 degrees or more", names(CSC, UNIT),
            GEOMETRY, "the unit square has angles of 90 degrees"),
    Theorem("appendix-a.acute-end-reach", "claim", "t1 - z = (2 T^2 - 1)/(4 T) <= 1/4, T = 1/k",
            names(CSC, DEPTH, REACH), GEOMETRY, "the supremum is 1/4, at 90 degrees"),
    Theorem("appendix-a.next-edge-misses-quarter-circle", "corrected", "for n >= 4 y is on u, at distance 1 from e_r",
            names(CSC, DEPTH), GEOMETRY + "u and e_r are disjoint for n >= 4."),
    Theorem("appendix-a.both-angles-acute", "corrected", "1/2 or longer for n >= 4", names(CSC, DEPTH, ACUTE),
            GEOMETRY + "y1 is to the left of y2: where u and e_r are ordered otherwise at depth 1, they cross above.",
            "1/2 is approached as both angles tend to 90 degrees"),
    Theorem("appendix-a.final-formula", "claim", "|e'| >= 1/(2 sin w) for one acute angle, n >= 4",
            names(CSC, DEPTH, FORMULA), GEOMETRY, "equality when p2 is at distance 1 from u and e_r parallel to it"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
