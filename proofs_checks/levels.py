"""Prove claims about rounding and levels: `repaired.unit`, `repaired.caps-whole`, `repaired.chord-clearance`,
`section-2.snap-motion`, `theorem-2.layer-count`.

Given   unit: 2^23 k is the whole part of 2^23 sqrt(N), with k >= 1: 24 bits are kept; m : mfs = k : sqrt(N).
        caps: an edge of K1 spans 0 or 1 levels and at most 817/2000 - 3/40 in x. A chord end is on a level strictly
        between the ends of its edge; a foot is at least X = 2 H >= 2 g from the far corner of its leg.
        clearance: levels are whole numbers; a chord end on level j lies inside an edge that ends on level b.
        snapping: j is the nearest whole number to t, the height in units of the spacing h.
        layers: each layer has at most half as many vertices as the one below.
Claim   unit: N <= k^2 (1 + 10^-6)^2.          caps: neither can be on an edge of a cap.
        clearance: the edge goes on for g.     snapping: by at most h/2.
        layers: after k halvings of n at most n/2^k are left, so there are at most 1 + floor(log2 n) layers.
Method  linear combinations.
Tight   clearance: one level; snapping: half the grid; layers: n a power of two.
By hand that whole numbers j < b differ by 1 at least; that induction over the layers is the sum of its steps; that a
        layer has a vertex.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, main, more, square, states

from exactmesh.proofs.polynomial import variables

N, k, a, j, b, x, t, h, m, q, up = variables("N k a j b x t h m q up")
G, WIDEST = mpq(29, 125), mpq(817, 2000) - mpq(3, 40)
MILLION = mpq(10**6)

STATEMENTS = [
    bounded("levels.unit", "a whole number of 24 bits below a root is less by a millionth at most",
            (at_least(k, 1), more((k + mpq(1, 2**23))**2, N)),
            lambda f: at_least(k * k * (1 + 1 / (MILLION * mpq(f)))**2, N), Hint(degrees=(2,))),
    states("levels.cap-chord", "no level lies strictly between the ends of an edge of a cap",
           (at_least(1, b - a), at_least(j, a + 1), at_least(b, j + 1)), None),
    states("levels.cap-foot", "no foot is so far from the corner", (at_least(x, 2 * G), at_least(WIDEST, x)), None),
    bounded("levels.clearance", "an edge from level j to level b >= j + 1, x to the side, is g long at least",
            (at_least(b, j + 1),), lambda f: at_least(x * x + ((b - j) * G)**2, square(f) * G * G),
            Hint(degrees=(2,), squares=(x,)), {"b": "1", "j": "0", "x": "0"}),
    bounded("levels.snap", "the nearest level is at most half a spacing away",
            (at_least(t, j - mpq(1, 2)), at_least(j + mpq(1, 2), t), more(h)),
            lambda f: at_least(h * h / (4 * square(f)), ((j - t) * h)**2), sharp={"t": "1/2", "j": "0", "h": "1"}),
    states("levels.halving", "if at most q are left, at most q/2 are left after one more layer",
           (at_least(q, m), at_least(m, 2 * up)), at_least(q / 2, up)),
]
GROUP = "levels"
THEOREMS = [
    Theorem("repaired.unit", "claim", "m <= mfs <= m (1 + 10^-6)", ("levels.unit",),
            "m is the largest number of 24 significant bits whose square is at most the squared mfs: scaled by a power "
            "of 4 it is the whole part of a root, at least 2^23.", "1 + 2^-23 at most, nearly ten times nearer"),
    Theorem("repaired.caps-whole", "claim", "no chord end and no foot is on an edge of a cap",
            ("levels.cap-chord", "levels.cap-foot"),
            "Vertices are put on edges of Q as chord ends, strictly between the levels of their ends, and as feet of "
            "wedges only. The ends of edges of K1 differ by 0 or g in y and by at most b - a in x."),
    Theorem("repaired.chord-clearance", "claim", "an edge goes on for a level beyond a chord end",
            ("levels.clearance",), "Both ends of an edge of Q are on levels, and a chord end is on a level strictly "
            "between: whole numbers that differ, differ by 1 at least.", "one level, attained"),
    Theorem("section-2.snap-motion", "claim", "by at most half the grid", ("levels.snap",),
            "A vertex of P3 goes to the nearest level, straight up or down, but for 2^-17 mfs by which its abscissa "
            "may become rational; the spacing is at most 1/(2 d3).", "half the grid, attained half way between levels"),
    Theorem("theorem-2.layer-count", "claim", "1 + floor(log2 n) layers", ("levels.halving",),
            "By induction at most n/2^k vertices are in the k-th layer above the side, and there is one at least: so "
            "k <= log2 n.", "attained where n is a power of two"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
