"""Prove what Section 2 says of the clean Interior and of the snapped Tube: `section-2.clean-interior-feature-size`,
`phase-1.snapped-angle`, `phase-1.fan-value`, `phase-2.projection`, `phase-2.q-prime-feature-size`,
`phase-2.lower-feature-size`, `phase-2.side-triangles`, `phase-3.feature-size`, `phase-4.spacing`,
`phase-4.longer-side`.

Given   mfs(P) = 1 but for the clean Interior. r <= n is the spacing of the grid, n = 2/21, or 3/34 if d3 = 4 sqrt 2;
        vertices move by m <= 1/(4 d3) <= s/8, s = sin(pi/8): by r/2 up or down, and by 2^-17 to the side. P and P4
        keep 1/(4 sqrt 2) - s/8 (both readings: 1/(4 d3) is less with d3 = 4 sqrt 2), and also r.
        Rectangle: a is the origin, T' runs along y = 0 to b = (w,0), w >= 2 r, as there is a vertex between; P is
        below; a' = (0,-D), b' = (w,-D), D <= (1/4 - n)(1 - 2^-26), less by a millionth at most. The corner L of P
        beside a is (-u,y), u > 0 and u >= |y|: an angle of 135 degrees or more; R beside b is (x2,y2), x2 > w.
Claim   angles: fans have a sine of 1/4 or more, other edges at spokes 7/25. rectangle: its corners are in Q', and Q'
        keeps r, the triangles beside R r/2, those at the vertex below R r/4 less a millionth. spacing: neighbours on a
        top are r apart, |a b| >= |a a'|. clean Interior: trapezoids without T-vertices keep r, triangles r/2.
Method  fan: over a chord, seen from the corner p at an angle f, 45 <= f <= 90, S, C the sine and cosine of f/2, the
        ends t, q are (1/4) unit vectors. Twice the area of p t q was S C/8 and changes by at most r/2 times the sum of
        the sizes of their abscissae, which is C/2 at most, and by 2^-17 (1/2 + 2/21) for the motion to the side. The
        base is S/2 + 2 m at most, and p is 1/4 + m or less from its points.
        spokes: the angle of A = p - t and U, an edge from t, is 45 degrees or more before snapping, or 90 in triangles.
        A/|A| changes by m/(1/4) at most, U/|U| by 2 m/(1/2), or 2 m/(sqrt(3)/6) in triangles: each time a unit vector
        changes by k or less, and stays outside a cone: `turn` with a normal of the cone, of rational coordinates.
        clean: `beyond`: the foot of q on an edge from p, on the level of q, is on that edge, or q is farther than r
        from its line, for the edge goes on for a level. `third`: two heights of r leave r/2 for the third.
Tight   spacing: a vertical edge. third: a triangle that tends to heights r, r, r/2. The angles are not: the least that
        was found is 33.97 degrees.
By hand which vertices and edges there are, which the theorems say.
"""

from types import ModuleType

import lemma_1
import refinement
import tube_spokes
from gmpy2 import mpq
from kit import Hint, Statement, Theorem, at_least, bounded, equal, main, more, square, states

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables

S, C, s, q, bx, by, ex, ey = variables("S C s q bx by ex ey")
u, w, x, x2, y, y2, D, r, n, h, v, B, c, e, p, d, k, m = variables("u w x x2 y y2 D r n h v B c e p d k m")
HALF_STEP, ASIDE = mpq(1, 21), mpq(1, 2**17)
LESS_A_MILLIONTH = 1 - mpq(1, 10**6)
DEEP = (mpq(1, 4) - mpq(2, 21)) * LESS_A_MILLIONTH
AWAY = mpq(1289, 10000)
TURN, TURN_3 = mpq(1914, 10000), mpq(3315, 10000)

AREA = S * C / 8 - HALF_STEP / 2 * C - ASIDE * (mpq(1, 2) + 2 * HALF_STEP)
BASE, REACH = S / 2 + 2 * HALF_STEP + 2 * ASIDE, mpq(1, 4) + HALF_STEP + ASIDE


def stays_out(id_: str, says: str, most: mpq, sine: int, cosine: int, hypotenuse: int, turn: mpq,
              sharp: dict[str, str]) -> list[Statement]:
    """Return that a unit vector b of angle arccos(most) or more from (1,0), changed by `turn` at most, does not come
    nearer to it than the angle with that sine and cosine, times hypotenuse."""
    return [
        bounded(f"tube.{id_}-before", f"{says}: b, by >= 0, is farther than {turn} from the cone's side",
                (equal(bx * bx + by * by, 1), at_least(by), at_least(1, by), at_least(most, bx), at_least(bx, -1)),
                lambda f: at_least(cosine * by - sine * bx, hypotenuse * turn * mpq(f)), Hint(cells=4000), sharp),
        bounded(f"tube.{id_}-change", f"{says}: a change of {turn} at most does not reach it",
                (at_least(turn * turn, ex * ex + ey * ey),),
                lambda f: at_least(hypotenuse * turn / mpq(f), sine * ex - cosine * ey),
                Hint(squares=(cosine * ex + sine * ey,), degrees=(2, 3))),
    ]


ANGLES = [
    bounded("tube.fan", "the sine of a fan's edge with its chord is 1/4 or more, after snapping",
            (at_least(1, S * S + C * C), at_least(S * S + C * C, mpq(999, 1000)), at_least(S, mpq(191, 500)),
             at_least(mpq(71, 100), S), at_least(C, mpq(7, 10)), at_least(mpq(93, 100), C)),
            lambda f: at_least(4 * AREA, BASE * REACH * mpq(f)), Hint(cells=4000),
            {"S": "5/13", "C": "12/13"}),
    *stays_out("edge", "45 degrees and an edge that turns leave more than 28", mpq(7072, 10000), 8, 15, 17, TURN,
               {"bx": "20/29", "by": "21/29"}),
    *stays_out("edge-of-triangle", "so do 90 degrees in triangles", mpq(0), 8, 15, 17, TURN_3,
               {"bx": "-1", "by": "0"}),
    *stays_out("spoke", "a spoke that turns leaves a sine of 7/25", mpq(15, 17), 7, 24, 25, TURN,
               {"bx": "15/17", "by": "8/17"}),
    bounded("tube.turn", "4 m = s/2 <= 0.1914", refinement.below, lambda f: at_least(2 * TURN, s * mpq(f)),
            Hint(cells=400)),
    bounded("tube.turn-of-triangle", "12 m / sqrt 3 <= 0.3315: 3 s^2 <= 4 0.3315^2", refinement.below,
            lambda f: at_least(4 * TURN_3**2, 3 * s * s * mpq(f)), Hint(cells=400)),
]
VALUE = [
    bounded("tube.fan-value", "sin(pi/8)/(4 sqrt 2) >= 0.067", (*refinement.above, more(q), at_least(2, q * q)),
            lambda f: at_least(s, mpq(67, 1000) * 4 * q * mpq(f)), Hint(cells=400)),
    bounded("tube.fan-value-roughly", "and at most 0.068", (*refinement.below, more(q), at_least(q * q, 2)),
            lambda f: at_least(mpq(68, 1000) * 4 * q, s * mpq(f)), Hint(cells=400)),
    states("tube.fan-value-otherwise", "with d3 = 4 sqrt 2 it is 1/(8 q^2) = 1/16, less than 0.067",
           (more(q), at_least(q * q, 2)), more(8 * q * q * mpq(67, 1000), 1)),
]
BESIDE = (more(u), more(D), more(w), more(x2, w))
BEYOND_BOTH = (*BESIDE, at_least(y, -D), at_least(y2, -D))
PROJECTION = [
    states("tube.left-turn", "L, a', a turn left: D u > 0", BESIDE, more(D * u)),
    states("tube.right-turn", "R, b, b' turn left: (x2 - w) D > 0", BESIDE, more((x2 - w) * D)),
    states("tube.left-diagonal", "L, b', a' turn left if L is below a' b'", (*BESIDE, more(-D, y)), more((-D - y) * w)),
    states("tube.right-diagonal", "R, b', a' turn left if R is below a' b'", (*BESIDE, more(-D, y2)),
           more((-D - y2) * w)),
    states("tube.not-both-above", "if neither is, a' is not above L R",
           BEYOND_BOTH, at_least(0, (x2 + u) * (-D - y) - (y2 - y) * u)),
    bounded("tube.corner-above", "a' and b' are above L R: 1/4 - m - D > 0, as n >= 3/34",
            (*refinement.below, at_least(8 * n, mpq(24, 34)), at_least(mpq(1, 4) - n, D)),
            lambda f: more(mpq(1, 4) - D, s * mpq(f) / 8), Hint(cells=400, degrees=(1, 2, 3, 4))),
]
UPPER = [
    bounded("tube.beside", "points on either side of a strip r wide, across T', are r apart",
            (more(r), at_least(x, r), at_least(u)),
            lambda f: at_least((x + u)**2 + (y - y2)**2, square(f) * r * r), Hint(squares=(y - y2,), degrees=(2, 3)),
            {"r": "1", "x": "1", "u": "0", "y": "0", "y2": "0"}),
]
LEANING = (more(u), at_least(u, y), at_least(u, -y), at_least(u * u + y * y, AWAY**2), at_least(D, DEEP))
SIDES = [
    bounded("tube.away", "1/(4 sqrt 2) - sin(pi/8)/8 >= 0.1289", (*refinement.below, more(q), at_least(q * q, 2)),
            lambda f: at_least(q - s, 8 * AWAY * mpq(f)), Hint(cells=400)),
    bounded("tube.side-upright", "L is 1/21 from a a'", LEANING,
            lambda f: at_least(u * u, square(f) * HALF_STEP**2), Hint(degrees=(2, 3, 4))),
    bounded("tube.side-spoke", "a' is 1/21 from L a", LEANING,
            lambda f: at_least((D * u)**2, square(f) * HALF_STEP**2 * (u * u + y * y)), Hint(degrees=(4, 5))),
    bounded("tube.side-low", "a is 1/21 from L a'", LEANING,
            lambda f: at_least((D * u)**2, square(f) * HALF_STEP**2 * (u * u + (y + D)**2)),
            Hint(degrees=(4, 5), squares=(u, y, D, u - y, u + y))),
]
SPACING = [
    bounded("tube.spacing", "points on different levels are r apart", (more(r), at_least(y, r)),
            lambda f: at_least(x * x + y * y, square(f) * r * r), Hint(squares=(x,), degrees=(2,)),
            {"r": "1", "x": "0", "y": "1"}),
    bounded("tube.longer", "two spacings of n less 10^-9 are more than the height 1/4 - n, n >= 3/34",
            (at_least(n, mpq(3, 34)), at_least(r, n * (1 - mpq(1, 10**9))), at_least(w, 2 * r),
             at_least(mpq(1, 4) - n, D), more(D)),
            lambda f: at_least(w, D * mpq(f)), sharp={"n": "3/34", "r": "3/34", "w": "6/34", "D": "11/68"}),
]
TILT, LEVELLED = mpq(3315, 10000), mpq(943, 1000)
# The frame of the rectangle turned: B runs along (c,e), c^2 + e^2 = 1; a' - L = (u,-D - y).
TILTED = (at_least(1, c * c + e * e), at_least(c * c + e * e, 1), at_least(c, LEVELLED), at_least(1, c),
          at_least(TILT, e), at_least(e, -TILT))
# From here in units of n: B from (0,0) to (B,0), a' = (p,k), b' = (p + 2 d,h), s = (p + d,v).
FLOOR = mpq(1, 2) - mpq(1, 10**8)
# What a rectangle's height is less by, and what it saves below.
DEPTH = 1 - mpq(1, 2**26)
SLACK = (mpq(1, 4) - mpq(2, 21)) * (1 - DEPTH)
LEAST_STEP = mpq(3, 34) * (1 - mpq(1, 10**9))
MORE = mpq(1, 10**8) + mpq(1, 10**16)  # (1/2 + 10^-8)^2 - 1/4
QUARTER = mpq(1, 4)
KEPT = QUARTER * LESS_A_MILLIONTH
LOW = (at_least(p, mpq(5, 4)), at_least(d, mpq(9, 10)), at_least(k, FLOOR), at_least(QUARTER, v),
       at_least(v, QUARTER * (1 - mpq(1, 2**22))))


def low_height(id_: str, says: str, hypotheses: tuple[Constraint, ...], area: Polynomial, side_squared: Polynomial
               ) -> Statement:
    """Return that doubled area over a side is a quarter less a millionth."""
    return bounded(f"tube.low-{id_}", says, hypotheses,
                   lambda f: at_least(area * area, square(f) * KEPT**2 * side_squared), Hint(degrees=(4, 5)))


BESIDE_LOW = p * (k - v) + k * d
GAP = (k + h - 2 * v) * d
LOW_VERTEX = [
    bounded("tube.motion", "r/2 and 2^-17 to the side are together at most n (1/2 + 10^-8), r <= n, n >= 3/34",
            (at_least(n, mpq(3, 34)), at_least(n, r), at_least(r)),
            lambda f: at_least((n * (mpq(1, 2) + mpq(1, 10**8)))**2, mpq(f)**2 * (r * r / 4 + ASIDE**2)),
            Hint(given={"kind": "combination", "equalities": [], "terms": [
                ["1", [3], None], ["1/4", [1, 1], None], ["1/2", [1, 2], None], [str(MORE), [0, 0], None],
                [str(MORE * mpq(3, 17)), [0], None], [str(MORE * mpq(3, 34)**2 - ASIDE**2), [], None]]})),
    states("tube.sinks", "they are together at most r/2 and a bit, SLACK",
           (at_least(r, LEAST_STEP), at_least(m), at_least(r * r / 4 + ASIDE**2, m * m)), at_least(r / 2 + SLACK, m),
           Hint(given={"kind": "combination", "equalities": [], "terms": [
               ["1", [2], None], ["1", [3, 3], None], [str(2 * SLACK + LEAST_STEP), [3], None], ["1", [0, 3], None],
               [str(SLACK), [0], None], [str(SLACK**2 + SLACK * LEAST_STEP - ASIDE**2), [], None]]})),
    states("tube.height", "so that a' and b', D below, are r/2 above B",
           (at_least(r / 2 + SLACK, m), at_least((mpq(1, 4) - n) * DEPTH, D), at_least(n, r), at_least(mpq(2, 21), n)),
           at_least(mpq(1, 4) - m - D, r / 2), Hint(given={"kind": "combination", "equalities": [], "terms": [
               ["1", [0], None], ["1", [1], None], ["1", [2], None], [str(1 - DEPTH), [3], None], ["1", [4], None]]})),
    bounded("tube.levelled", "a sine of 0.3315 or less has a cosine of 0.943 or more, and half of 2 n of it 9/10 n",
            (at_least(c * c + e * e, 1), at_least(TILT, e), at_least(e, -TILT), more(c)),
            lambda f: at_least(c, LEVELLED * mpq(f)), Hint(degrees=(2, 3))),
    bounded("tube.reach", "a' is 0.12, or 5/4 n, beyond L along B, if it is above L R",
            (*TILTED, at_least(u, -y), at_least(D, DEEP), at_least((-D - y) * c, u * e)),
            lambda f: at_least(u * c + (-D - y) * e, mpq(12, 100) * mpq(f)),
            Hint(cases=(at_least(e),), degrees=(3, 4))),
    low_height("left", "(L, R, s) onto R s", (*LOW, at_least(B, p + d)), B * v, (B - p - d)**2 + v * v),
    low_height("spoke", "(a', L, s) onto L s", LOW, BESIDE_LOW, (p + d)**2 + v * v),
    low_height("outside", "(a', L, s) onto L a'", LOW, BESIDE_LOW, p * p + k * k),
    low_height("across", "(a', L, s) onto a' s", LOW, BESIDE_LOW, d * d + (k - v)**2),
    low_height("above", "(b', a', s) onto a' s", (*LOW, at_least(h, FLOOR)), GAP, d * d + (k - v)**2),
    low_height("top", "(b', a', s) onto a' b'", (*LOW, at_least(h, FLOOR)), GAP, 4 * d * d + (h - k)**2),
]
LEVEL = (more(r), at_least(h, r))
CLEAN = [
    bounded("clean.beyond", "q on the level of p, B away: its foot on the line of an edge from p to (x,h) is on it, "
            "or q is r from the line", (*LEVEL, more(x), more(B), more(B * x, x * x + h * h)),
            lambda f: at_least((B * h)**2, square(f) * r * r * (x * x + h * h)), Hint(degrees=(6, 7), cells=0)),
    states("clean.steeper", "with the longer side b longer: if BL is r from the right leg, so is BR from the left one",
           (*LEVEL, more(x), more(B), at_least(w), at_least((B * h)**2, r * r * ((x + w)**2 + h * h))),
           at_least((B * h)**2, r * r * (x * x + h * h))),
    bounded("clean.third", "apex (0,0), p = (x,h), q = (x + B,h), q r from the line of p: p is r/2 from that of q",
            (*LEVEL, more(B), at_least((B * h)**2, r * r * (x * x + h * h))),
            lambda f: at_least(4 * (B * h)**2, square(f) * r * r * ((x + B)**2 + h * h)),
            Hint(degrees=(4,), squares=(r * (x - B), r * x, r * h, r * B))),
    bounded("clean.obtuse", "where the angle at the apex is not acute, p and q are r from the nearest point, the apex",
            LEVEL, lambda f: at_least(x * x + h * h, square(f) * r * r), Hint(squares=(x,), degrees=(2,)),
            {"x": "0", "h": "1", "r": "1"}),
]
STATEMENTS = [*ANGLES, *VALUE, *PROJECTION, *UPPER, *SIDES, *LOW_VERTEX, *SPACING, *CLEAN]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


def known(script: ModuleType, claim: str) -> tuple[str, ...]:
    """Return the problems of the theorem of another script that proves a claim."""
    return next(t.problems for t in script.THEOREMS if t.claim == claim and t.shows in ("claim", "corrected"))


SPOKES = known(tube_spokes, "phase-1.spoke-angle")
BOTH = known(refinement, "section-2.p4-both-regions")
TUBE = known(refinement, "section-2.p4-tube-distance")
IN_THE_FRAME = ("The loops of phase 2 end with angles of 135 degrees or more at both ends of T', which a rectangle "
                "needs: so L and R are beyond a and b along T'. ")
LOWERED = ("T' is a part of an edge of P4, whose ends moved by m: before, it was 1/2 long or longer, in triangles "
           "sqrt(3)/6 (Appendix A), and parallel to B, 1/4 above it; the sine of its angle with B is 2 m over that at "
           "most. It sank by at most n (1/2 + 10^-8), a motion of r/2 upright and 2^-17 to the side: a' and b', D <= "
           "1/4 - n farther down, are n (1/2 - 10^-8) above B. ")
TURNS = (*names(ANGLES[-2:]), *refinement.APPENDIX)
GROUP = "paper-tube"
THEOREMS = [
    Theorem("phase-1.snapped-angle", "claim", "edges at spokes and fans keep a sine of 1/4", (
            *names(ANGLES), *SPOKES, *refinement.APPENDIX),
            "Chords of an arc are seen from its corner at half its angle, 45 to 90 degrees; all edges of fans end on "
            "one, and the sine at an end is the distance of p from the chord's line over that from the end. At other "
            "edges of P4: spokes make 45 degrees or more before snapping, 90 or more in triangles, which are convex; "
            "they are 1/4 long or longer, edges of P3 that are no chords 1/2, in triangles sqrt(3)/6 (Appendix A). "
            "Vertices move by 1/(4 d3) at most, which is asserted on every run.",
            "not tight: the least angle that was found has 33.97 degrees, a sine of 0.5588"),
    Theorem("phase-1.fan-value", "claim", "with 1/d3 = (1/4) 2 sin(pi/8), as the text defines it, it is between 0.067 "
            "and 0.068", names(VALUE[:2]), "1/(2 d3 sqrt 2) = sin(pi/8)/(4 sqrt 2). The ledger's runs read d3 so.",
            "0.06765"),
    Theorem("phase-1.fan-value", "part", "with d3 = 4 sqrt 2 it is 1/16 and the sentence is false", names(VALUE[2:]),
            "q = sqrt 2."),
    Theorem("phase-2.projection", "claim", "R lies in Q', T' projects onto B", names(PROJECTION), IN_THE_FRAME +
            "That is the projection. a and b are on the snapped edge, whose ends were 1/4 above the line of L R and "
            "moved by m at most; a' and b' are D from them: so both are above it, and one of the diagonals of L R b' "
            "a' cuts it into two left turns.", "the height of a' is at least 1/(2 d3) - 1/(4 d3)"),
    Theorem("phase-2.q-prime-feature-size", "claim", "mfs(Q') >= the spacing", (*names(UPPER, SPACING[:1]), *BOTH),
            IN_THE_FRAME + "Of a vertex and an edge of Q' without it, one is on P and one on P4, where "
            "`section-2.p4-both-regions` bounds the distance, also of points inside an edge of P4, as a distance of "
            "two segments is attained at an end of one; or both are on T', whose vertices are on different levels; or "
            "one is the spoke at a and the other b, R or a vertex on T', beyond a by the spacing or more along T'; or "
            "the mirror image.", "a vertical edge, with vertices on neighbouring levels"),
    Theorem("phase-2.side-triangles", "claim", "the triangles beside R keep half the spacing", (*names(SIDES), *TUBE),
            IN_THE_FRAME + "L is 0.1289 or more from a, which is on P4; r/2 <= 1/21 and D is as in the script, with "
            "d3 = 4 sqrt 2 D is more. The triangle beside b is the mirror image.",
            "not tight: 1.12 times the bound, and that only with L on the other side of the line of T'"),
    Theorem("phase-2.lower-feature-size", "claim", "mfs(Q'') is at least half the spacing", (
            *names(LOW_VERTEX[:5], UPPER, PROJECTION), *TURNS), IN_THE_FRAME + LOWERED + "In fact they are r/2 above "
            "it, as D is less than 1/4 - n by one part in 2^26. Edges of Q'' that do not meet are L R and a' b', and "
            "the two at L and R, which are 1.8 n apart along B.",
            "half the spacing: a horizontal edge, vertices half way between levels"),
    Theorem("phase-3.feature-size", "claim", "faces at the vertex of Q'' keep a quarter of the spacing, less a "
            "millionth", (*names(LOW_VERTEX), *names(PROJECTION), *TURNS), IN_THE_FRAME + LOWERED + "The vertex "
            "s is v above the middle between the feet of a' and b', v at most n/4 and less by one part in 2^22 at "
            "most; d is half of that between the feet, |a' b'| >= 2 r. The faces (L, R, s) and (a', L, s) have mirror "
            "images at R, and heights onto L R are v.",
            "tight up to the millionth: a horizontal edge, vertices half way between levels"),
    Theorem("phase-4.spacing", "claim", "neighbours on a rectangle's top are the spacing apart or more",
            names(SPACING[:1]), "Ends of chords are strictly between the levels of the ends of their edge, which is "
            "not horizontal; they and the vertices of P4 are on levels, each on its own: so neighbours differ by r "
            "in y.",
            "a vertical edge, with vertices on neighbouring levels"),
    Theorem("phase-4.longer-side", "claim", "|a b| >= |a a'|", names(SPACING),
            "A rectangle has a vertex between a and b, so they are two levels apart or more; the spacing is n mfs less "
            "one part in 10^9 at most, and |a a'| at most 1/4 - n.", "12/11 with n = 3/34, vertical edges"),
    Theorem("section-2.clean-interior-feature-size", "claim", "faces of trapezoids without T-vertices keep r/2",
            (*names(CLEAN), *BOTH, *known(lemma_1, "lemma-1.degradation"),
             *known(lemma_1, "lemma-1.case-1-feature-size"), *known(lemma_1, "lemma-1.case-2-feature-size")),
            "mfs(P4) >= 1/(2 d3) >= r, and all corners are on levels, r apart or more. A chord begins at a vertex of "
            "P4; without T-vertices one end of each parallel side is one, and the other end is on an edge without it: "
            "parallel sides are r long. Four corners: Lemma 1's mfs(H) is min(h, l), or the distance of BR from the "
            "line of the left leg, both leaning to the right, the shorter side below. If BR is a vertex, its distance "
            "from the left edge is r or more; its foot is on the leg, or beyond TL, h >= r higher. If not, BL is one, "
            "and the right edge goes on below BR for a level: the same for BL, and `steeper`. Then Lemma 1. Three "
            "corners: the legs meet in a vertex. If p and q are both vertices, all three distances are r. Else let q "
            "be the vertex; the edge through p goes on for a level, so q is r from its line unless the angle at the "
            "apex is not acute, and `third` bounds the third height.",
            "attained by no input that is known: the least of corner triangles is 0.7628 r (`section-2.p5-feature-"
            "size`), of trapezoids half of r, by rectangles on neighbouring levels"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
