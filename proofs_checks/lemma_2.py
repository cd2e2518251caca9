"""Prove Lemma 2: moving vertices by a mfs costs a factor of at most 1/(1 - 2 a) (`lemma-2.perturbation`).

Given   a vertex p and a point x = u + t (v - u), 0 <= t <= 1, of an edge u v without p, |x - p| >= d = mfs(G);
        p, u, v move by at most r = a d, 2 r < d.
Claim   the moved x' = u' + t (v' - u') is at distance d - 2 r = (1 - 2 a) d or more from the moved p'.
Method  x moves by at most r: r^2 - |(1-t) du + t dv|^2 = (1-t)(r^2 - |du|^2) + t (r^2 - |dv|^2) + t (1-t) |du - dv|^2.
        So x - p changes by dx - dp of length at most 2 r, and the triangle inequality, itself an identity, does the
        rest. The drawing is kept because the same holds for every a' <= a on the way from G to G': no vertex reaches
        an edge without it, and a crossing can only begin where one does.
Tight   for every a: p over the middle of u v at distance d, and both move towards each other by a d.
"""

from kit import Hint, Theorem, at_least, bounded, main, more, square

from exactmesh.proofs.polynomial import polynomial, variables

t, r, s, ux, vx, vy = variables("t r s ux vx vy")
bx, cx, cy = variables("bx cx cy")
# Turned so that the motion of u, and b, are horizontal.
uy = by = polynomial(0)

mx, my = (1 - t) * ux + t * vx, (1 - t) * uy + t * vy
STATEMENTS = [
    bounded("lemma-2.point-of-edge", "if both ends of an edge move by at most r, so does each of its points",
            (more(r), at_least(t), at_least(1, t), at_least(r * r, ux * ux + uy * uy),
             at_least(r * r, vx * vx + vy * vy)),
            lambda f: at_least(r * r / square(f), mx * mx + my * my), Hint(squares=(ux - vx, uy - vy), degrees=(4,))),
    bounded("lemma-2.triangle-inequality", "|b| <= r and |c| <= s imply |b - c| <= r + s",
            (more(r), more(s), at_least(r * r, bx * bx + by * by), at_least(s * s, cx * cx + cy * cy)),
            lambda f: at_least((r + s) * (r + s) / square(f), (bx - cx) * (bx - cx) + (by - cy) * (by - cy)),
            Hint(squares=(r * cx + s * bx, r * cy + s * by), degrees=(4,))),
    bounded("lemma-2.distance-left", "|c| >= d = s + 2 r and |b| <= 2 r imply |c - b| >= s = d - 2 r",
            (more(r), more(s), at_least(cx * cx + cy * cy, (s + 2 * r)**2), at_least(2 * r, bx), at_least(bx, -2 * r)),
            lambda f: at_least((cx - bx)**2 + cy * cy, square(f) * s * s),
            Hint(squares=(2 * r * (cx - bx) - s * bx, cy, cx - bx, s * bx - r * cx, cx), degrees=(4,))),
]

GROUP = "lemma-2"
THEOREMS = [Theorem(
    "lemma-2.perturbation", "claim", "every distance of a vertex from an edge without it is at least (1 - 2 a) d",
    tuple(statement.id for statement in STATEMENTS),
    "Distances of two vertices count where a vertex is on no edge that meets another, and move in the same way. The "
    "drawing is kept because the bound holds all along the straight motion from G to G'.",
    "attained for every a: p and an edge at distance d move towards each other by a d")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
