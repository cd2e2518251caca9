"""Prove that in internal meshes polygons between a chord and one leg keep 0.0223, and those with a step of a trimmed
chord as much as those without it, a part of `repaired.internal-degradation`.

Given   a chord along y = 0 and a leg below it that goes down by s for 1 across, s >= 0. A column goes from P on the
        chord to F on the leg, MERGE = 0.075 at most from upright. Neighbours on the chord, and feet and ends of the leg
        sideways, are 0.0688 apart. Chord vertices are 0.0565 or more above the leg and 0.045 from its line; vertices
        of the leg are 0.0522 or more below the chord.
Claim   depth   these depths: a chord is trimmed where the leg is 0.057 below it, unless the slope is 0.76 or more;
                then vertices are 0.075 or more from the corner.
        step    the triangle of a trimmed corner, its foot and k, by which a polygon can be made simpler.
        end     the triangle of a corner, the first chord vertex and the leg.
        between two columns: the diagonal from the upper end of the one where the leg is deeper.
Method  combinations and boxes, a problem a height.
Tight   below: 0.0252 at the least depth and gap.
By hand what leads to the inequalities (in `CASES`).
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, bounded, main, spot, states
from repaired_tube import height, triangle, within

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import LEVEL_EDGE, MERGE, TRIM, TUBE_FEATURE

f, FAR, DEEP, LOW = TUBE_FEATURE, mpq(45, 1000), mpq(565, 10000), mpq(522, 10000)
e, p, q, s, w, x, y = variables("e p q s w x y")
MANY = Hint(degrees=(2, 3, 4, 5, 6))
DEPTH = [
    bounded("columns-legs.depth-trimmed", "a chord vertex is 0.057 or more above a leg of slope 0.76 or less",
            (at_least(y, TRIM), *within(s, 0, TRIM / MERGE)),
            lambda m: at_least(y * y, mpq(m)**2 * FAR**2 * (1 + s * s)), MANY),
    bounded("columns-legs.depth-steep", "a chord vertex is 0.075 or more from the corner, the slope 0.76 or more",
            (at_least(x, MERGE), at_least(s, TRIM / MERGE)),
            lambda m: at_least((x * s)**2, mpq(m)**2 * FAR**2 * (1 + s * s)), MANY),
    bounded("columns-legs.depth-corner", "that high above the leg", (at_least(x, MERGE), at_least(s, TRIM / MERGE)),
            lambda m: at_least(x * s, DEEP * mpq(m)), MANY),
    bounded("columns-legs.depth-foot", "a vertex of the leg is 0.0688 or more beside the corner",
            (at_least(x, LEVEL_EDGE), at_least(s, TRIM / MERGE)), lambda m: at_least(x * s, LOW * mpq(m)),
            MANY),
]
STEP = triangle("columns-legs.step", "corner, foot, k", (at_least(x, MERGE), at_least(y, TRIM)),
                (spot(0, 0), spot(x, -y), spot(x, 0)), f, MANY)
# The corner at (0, 0), P = (p, 0), F = (x, -y).
CORNER = (at_least(p, LEVEL_EDGE), at_least(y, FAR), *within(x - p, -MERGE, MERGE), at_least(x))
END = [
    height("columns-legs.end-column", "(corner, F, P): the height over P-F", CORNER, p * y, spot(x - p, y), f, MANY),
    bounded("columns-legs.end-chord", "the height over the chord", CORNER, lambda m: at_least(y, f * mpq(m)), MANY),
    bounded("columns-legs.end-leg", "the height over the leg, p from its line", (at_least(p, FAR),),
            lambda m: at_least(p, f * mpq(m)), MANY),
]
UPPER = (at_least(p, LEVEL_EDGE), *within(x, -MERGE, MERGE), at_least(y, LOW))
BETWEEN = triangle("columns-legs.above", "(P0, F0, P1), P0 = (0, 0), F0 = (x, -y), P1 = (p, 0)", UPPER,
                   (spot(0, 0), spot(x, -y), spot(p, 0)), f, MANY)
# From F0, P1 is at (q, y), F1 at (x, -s x), x = q + e; w = y + s q is how high P1 is above the leg. Twice the area is
# x w.
LOWER = (at_least(x, LEVEL_EDGE), *within(e, -MERGE, MERGE), at_least(s), at_least(w, DEEP),
         at_least(w * w, FAR**2 * (1 + s * s)))
SLOPE = at_least(w, FAR * s)
BETWEEN += [
    states("columns-legs.below-slope", "(F0, F1, P1): how steep the leg is", LOWER, SLOPE, MANY),
    height("columns-legs.below-leg", "the height over the leg", (*LOWER,), x * w, spot(x, s * x), f, MANY),
    height("columns-legs.below-column", "the height over F1-P1", (*LOWER, SLOPE), x * w, spot(e, w + s * e), f, MANY),
    height("columns-legs.below-ahead", "the height over F0-P1, P1 right of F0", (
        *LOWER[:1], at_least(w, DEEP), *within(q, 0, x + MERGE), *within(y, 0, w)), x * w, spot(q, y), f, MANY),
    states("columns-legs.below-near", "else P1 is 0.0062 at most beside F0", (
        at_least(x, LEVEL_EDGE), at_least(q + MERGE, x)), at_least(q, -mpq(62, 10000)), MANY),
    states("columns-legs.below-high", "and 1.14 w at most above it", (
        SLOPE, at_least(s), *within(q, -mpq(62, 10000), 0), at_least(w)), at_least(mpq(114, 100) * w, w - s * q), MANY),
    height("columns-legs.below-behind", "the height over F0-P1 then", (
        *LOWER[:1], at_least(w, DEEP), *within(q, -mpq(62, 10000), 0), *within(y, 0, mpq(114, 100) * w)), x * w,
           spot(q, y), f, MANY),
]
STATEMENTS = [*DEPTH, *STEP, *END, *BETWEEN]

CASES = (
    "A corner that is not trimmed though its leg is less steep than 0.76 has its chord vertices 0.0599 from the leg "
    "(`repaired.chord-leg`). step: a chord is trimmed at 0.057 above the leg, or at its end, where the leg is farther, "
    "and then x > 0.075. Corner and k are on the level, so a polygon with the parts corner-foot-k is this triangle and "
    "the polygon with the chord in their place; `triangulate_small` finds no worse one. "
    "end: `.c/l|`. x >= 0 as the leg is on that side of the corner; the height over the leg is the distance of P. "
    "Between two columns, `|c/l|`, or from k and its foot, `:c/l|`, up to reflection the leg goes down to the right: "
    "`above`, `below`; F0 is left of F1. ")
GROUP = "columns-legs"
THEOREMS = [Theorem(
    "repaired.internal-degradation", "part", "polygons between a chord and one leg keep 0.0223, steps cost nothing",
    tuple(statement.id for statement in STATEMENTS),
    "Not proved here: the gaps, the depth of a leg's vertices at corners that are not trimmed, and polygons with two "
    "or more parts on a side, but for steps, or with legs on both. " + CASES,
    "0.0252 at the least depth and gap")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
