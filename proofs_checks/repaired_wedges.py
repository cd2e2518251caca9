"""Prove that the triangles of wedges and cross edges keep f* = g/5 in the repaired construction, at the full value.

Given   a trapezoid of height H >= g with the left leg from TL = (0,0) to BL = (M,-H); T-vertices v = (c,0) of its top
        keep F = 599/10000 from the line of the leg (I2; the foot is on the leg), neighbours are w = 0.15 or more apart,
        and those with c < M - 2 H are dropped to feet v' on the leg; so is TR if it is a vertex of Q that far left.
Claim   W1  triangle (TL, v1', v1); W2 between two dropped vertices, cut by the diagonal from the left foot to the right
        vertex; W3 triangle (vr', BL, vr); W4 triangle (vr, BL, u) with the next vertex u at s >= w, s >= M - 2 H, where
        vr = (0,0) now; R triangle (BL, BR, TR), one wedge, TR = (s,0) a vertex of Q and the right leg leaning out;
        C triangle of a cross edge: base at least F, the apex above it. All their heights are f* or more.
Method  one problem a height; combinations.
Tight   W4 is false without the rule for the corner, s >= M - 2 H (`wedges.no-corner-rule`).
By hand the split into these pieces; R has two cases, by which of BL and BR is a vertex of Q and so keeps F from the
        other leg. Quadrilaterals left over are those of `repaired_clean.py`.
"""

from kit import Hint, Theorem, at_least, main, more, refuted, spot
from repaired_clean import heights

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FEATURE, GAP, LEVEL, SEPARATION

g, F, f_star, w = LEVEL, SEPARATION, FEATURE, GAP
M, H, c, d, x, s, b = variables("M H c d x s b")
PLAIN = Hint(degrees=(4, 5, 6))

W1 = heights("wedges.w1", "TL, v1', v1; s is the slope of the leg, below 1/2",
             (more(c), more(s), at_least(1, 2 * s), at_least(c * c * s * s, F * F * (1 + s * s))),
             (spot(0, 0), spot(c, -c * s), spot(c, 0)), f_star, PLAIN)
W3 = heights("wedges.w3", "vr, vr', BL; vr = (0,0), vr' is d below, BL = (x,-H), x > 2 H",
             (more(x, 2 * H), at_least(H, g), at_least(d, F), more(H, d)),
             (spot(0, 0), spot(0, -d), spot(x, -H)), f_star, PLAIN)
between = (at_least(s), at_least(1, 2 * s), at_least(x, w), more(d), at_least(d * d, F * F * (1 + s * s)))
left, right, right_foot, left_foot = spot(0, 0), spot(x, 0), spot(x, -d - s * x), spot(0, -d)
W2 = heights("wedges.w2-upper", "v_i, v_i', v_i+1", between, (left, left_foot, right), f_star, PLAIN)
W2 += heights("wedges.w2-lower", "v_i', v_i+1', v_i+1", between, (left_foot, right_foot, right), f_star, PLAIN)
next_one = (at_least(s, w), at_least(s, M - 2 * H), at_least(H, g), more(M, 2 * H))
W4 = heights("wedges.w4", "vr, BL, u", next_one, (spot(0, 0), spot(M, -H), spot(s, 0)), f_star, PLAIN)
leaning = (*next_one, more(b), at_least(M + b, s))
to_br, to_tr = M + b - s, H
R1 = heights("wedges.r-bl", "BL, BR, TR, BL a vertex of Q off the right leg",
             (*leaning, at_least(b * b * H * H, F * F * (to_br * to_br + H * H))),
             (spot(M, -H), spot(M + b, -H), spot(s, 0)), f_star, PLAIN)
R2 = heights("wedges.r-br", "BL, BR, TR, BR a vertex of Q off the left leg",
             (*leaning, at_least(b * b * H * H, F * F * (M * M + H * H))),
             (spot(M, -H), spot(M + b, -H), spot(s, 0)), f_star, PLAIN)
C = heights("wedges.cross", "cross edge: apex above a base of F or more",
            (at_least(s, F), at_least(x), at_least(s, x), at_least(H, g)),
            (spot(0, 0), spot(s, 0), spot(x, H)), f_star, PLAIN)
NO_RULE = refuted("wedges.no-corner-rule", "without s >= M - 2 H the height of (vr, BL, u) from BL is f* or more",
                  (at_least(s, w), at_least(H, g), more(M, 2 * H)),
                  at_least(s * s * H * H, f_star**2 * ((M - s) * (M - s) + H * H)))
STATEMENTS = [*W1, *W2, *W3, *W4, *R1, *R2, *C, NO_RULE]

GROUP = "wedges"
THEOREMS = [Theorem(
    "repaired.interior-feature", "part", "wedges and cross edges keep f* = g/5", tuple(s.id for s in STATEMENTS),
    "The split of a face with T-vertices into these pieces and one-sided quadrilaterals is in `repaired_interior`.",
    "W4 needs the rule for corners")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
