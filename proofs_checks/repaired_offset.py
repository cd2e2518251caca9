"""Prove I1 of the repaired construction: an end q of an offset edge e' is at a distance in [g, 0.4701] from e.

Given   K1, the octagon of the construction, n the inner unit normal of e, k a vertex of K1 extreme for n; before
        snapping n.(q - p) = n.k (for a cap and for a convex corner alike), and snapping adds n_y s with |s| <= g/2.
Claim   g <= n.(q - p) <= 0.4701 in units of m. Also the numbers of I2 and I4: with the reach rho of K2, K1 and
        [-g/2, g/2] together, 1 - 2 rho >= 0.0599, and T-vertices keep 0.15 from other corners' vertices on their
        level.
Method  n.k is the greatest n.k' over K1, and K1 = K0 + [-g/2, g/2], so after snapping it is at least the greatest over
        K0, which contains the disc of radius g; and at most the greatest over K2, whose vertices are within rho.
Tight   g: n vertical, snapped by half a level towards e. rho = 0.470022.
By hand the extreme vertex of a Minkowski sum; that m <= mfs.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, dot, equal, main, spot, states

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FLAT, LEVEL, SEPARATION, THICKNESS_MAX, WIDE

nx, ny, s, r = variables("nx ny s r")
normal = spot(nx, ny)
unit = equal(nx * nx + ny * ny, 1)
first = (at_least(nx), at_least(ny))
K0 = [spot(FLAT, LEVEL), spot(WIDE, 0)]
K1 = [spot(FLAT, 3 * LEVEL / 2), spot(WIDE, LEVEL / 2)]
K2 = [spot(FLAT, 2 * LEVEL), spot(WIDE, LEVEL)]
snapped = (at_least(2 * s, -LEVEL), at_least(LEVEL, 2 * s))

THICK = [
    bounded(f"offset.thickness-{name}", f"n.k + n_y s >= g where {name} is extreme", (
        unit, *first, *snapped, at_least(dot(normal, k), dot(normal, other))),
        lambda f, k=k: at_least(dot(normal, k) + ny * s, LEVEL * mpq(f)), Hint(degrees=(2, 3, 4, 5)), sharp)
    for name, k, other, sharp in (
        ("upper", K1[0], K1[1], {"nx": "0", "ny": "1", "s": "-29/250"}), ("side", K1[1], K1[0], None))]
REACH = [
    bounded(f"offset.reach-{name}", f"n.k + n_y s <= 0.4701 for {name}", (unit, *first, *snapped),
            lambda f, k=k: at_least(THICKNESS_MAX / mpq(f), dot(normal, k) + ny * s),
            Hint(degrees=(2, 3, 4), squares=(nx - mpq(2, 5), ny - mpq(9, 10), nx * 464 - ny * 75,
                                             nx * 232 - ny * mpq(817, 2), ny - mpq(99, 100), nx - mpq(87, 100),
                                             ny - mpq(49, 100), nx - mpq(16, 100))), sharp)
    for name, k, sharp in (("upper", K1[0], {"nx": "100/629", "ny": "621/629", "s": "29/250"}),
                           ("side", K1[1], None))]
SEPARATE = [
    bounded("offset.separation", "1 - 2 rho >= 0.0599 for rho^2 = a^2 + 4 g^2, the longer of the two reaches",
            (at_least(r), at_least(FLAT**2 + 4 * LEVEL**2, r * r)),
            lambda f: at_least(1 - 2 * r, SEPARATION * mpq(f)), Hint(squares=(r - mpq(47, 100),))),
    states("offset.reaches", "the side vertices of K2 reach less far",
           (at_least(r), at_least(WIDE**2 + LEVEL**2, r * r)), at_least(FLAT**2 + 4 * LEVEL**2, r * r)),
    bounded("offset.chord-gap", "|p - c| >= 1 - rho, its vertical part at most 2 g: c is 0.15 + a or more beside p",
            (at_least(r), at_least(s), at_least(r * r, (1 - THICKNESS_MAX)**2), at_least(s * s + 4 * LEVEL**2, r * r)),
            lambda f: at_least(s - FLAT, 2 * FLAT * mpq(f)), Hint(squares=(s - mpq(1, 4),))),
]
STATEMENTS = [*THICK, *REACH, *SEPARATE]
FRAME = ("By symmetry n_x, n_y >= 0, where only two vertices of K1 can be extreme. An end of e' is p + k with k "
         "extreme for n, or on the line of e + k, before it moves vertically by at most g/2.")


def names(part: list) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for statement in part)


GROUP = "offset"
THEOREMS = [
    Theorem("repaired.offset-thickness", "claim", "e' keeps g from the line of e", names(THICK), FRAME,
            "attained by a horizontal e and a snap of half a level"),
    Theorem("repaired.offset-reach", "claim", "e' stays within 0.4701 of the line of e", names(REACH), FRAME,
            "rho = 0.470022"),
    Theorem("repaired.chord-gap", "part", "T-vertices keep 0.15 from vertices of other corners on their level",
            names(SEPARATE[2:]), "The flattened short edge is not covered.", "0.181 is proved, 0.15 used"),
]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
