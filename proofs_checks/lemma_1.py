"""Prove Lemma 1: one vertex triangulates any trapezoid with degradation at most 2 (`lemma-1.degradation`).

Given   the trapezoid H with the shorter parallel side from (0,0) to (l,0) and the longer one at height h.
        Case 1, R fits: the longer side reaches from (-a,h) to (l+b,h), a, b >= 0.
        Case 2, R does not fit, mirrored to lean to the right: it reaches from (a,h) to (a+l+b,h), a > 0, b >= 0.
        A number m > 0 with 2 m <= mfs(H).
Claim   with the lemma's vertex s every vertex of the mesh is at distance m or more from every edge without it: 24
        pairs a case, the 8 of H among them at distance 2 m. Also the formulas mfs(H) = min(h, l) and
        mfs(H) = mfs(P) = min(h, l h / sqrt(a^2 + h^2)), in both directions.
Method  of mfs(H) >= 2 m only h >= 2 m and the distance of one corner are used; `foot` and `near` are the reasons why
        mfs(H) is no larger. Every pair is split by where the foot of the vertex is: before, beyond, on the edge.
        Each part is settled by a nonnegative combination of products of hypotheses.
Tight   rectangles: s is exactly h/2 from the sides, and mfs(H) = h.
By hand mirror images; that a shorter side below and a positive lean are no restriction; that a vertex and an edge
        that are not in one triangle are farther apart than some pair in one (a nearest pair crosses no edge) is not
        needed, because all pairs are proved.
"""

from kit import Hint, Spot, Statement, Theorem, at_least, cross, dot, keeps_distance, main, more, refuted, spot, states

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import Polynomial, variables

l, h, a, b, m = variables("l h a b m")  # noqa: E741
WLOG = ("Moved, turned by 180 degrees and mirrored so that the shorter parallel side is below and the lean is to the "
        "right; the feature size is taken over all 24 pairs, so none is left out.")
SIDES = (("bottom", 0, 1), ("right leg", 1, 2), ("top", 2, 3), ("left leg", 3, 0))
NAMES = ("BL", "BR", "TR", "TL", "s")


def pairs(case: str, hypotheses: tuple[Constraint, ...], corners: list[Spot], centre: Spot) -> list[Statement]:
    """Return the 24 pairs of one case."""
    places = [*corners, centre]
    edges = [(name, i, j, True) for name, i, j in SIDES] + [(f"spoke {NAMES[i]}", i, 4, False) for i in range(4)]
    found = []
    for name, i, j, is_side in edges:
        for v in range(5):
            if v not in (i, j):
                bound = 4 * m * m if is_side and v < 4 else m * m
                words = "2 m" if is_side and v < 4 else "m"
                found += keeps_distance(f"lemma-1.{case}.{NAMES[v]}-{name.replace(' ', '-')}",
                                        f"{NAMES[v]} is at distance {words} or more from the {name}", hypotheses,
                                        places[v], places[i], places[j], bound, Hint(squares=(a - l,)))
    return found


def statements() -> list[Statement]:
    """Return all statements of the lemma."""
    sizes = (more(m), at_least(h, 2 * m), at_least(b))
    fits = (*sizes, at_least(l, 2 * m), at_least(a))
    corners = [spot(0, 0), spot(l, 0), spot(l + b, h), spot(-a, h)]
    found = pairs("case-1", fits, corners, spot(l / 2, h / 2))
    found += [
        states("lemma-1.case-1.near-left", "the top side begins to the left of the foot of BL, so mfs(H) <= h",
               (at_least(a), at_least(b), more(l), more(h)), at_least(0, -a)),
        states("lemma-1.case-1.near-right", "the top side ends to the right of the foot of BL",
               (at_least(a), at_least(b), more(l), more(h)), at_least(l + b)),
    ]
    leans = (*sizes, more(l), more(a), at_least(l * l * h * h, 4 * m * m * (a * a + h * h)))
    corners = [spot(0, 0), spot(l, 0), spot(a + l + b, h), spot(a, h)]
    found += pairs("case-2", leans, corners, spot((a + l) / 2, h / 2))
    along, to, centre = corners[3], corners[1], spot((a + l) / 2, h / 2)
    free = (more(m), at_least(b), more(l), more(a), more(h))
    steep = (*free, more(a, l))
    found += [
        states("lemma-1.case-2.foot-after", "the foot of BR on the line of the left leg does not lie before BL",
               free, at_least(dot(to, along))),
        states("lemma-1.case-2.foot-beyond", "if the foot of BR lies beyond TL, l h / |left leg| is more than h",
               (*free, more(dot(to, along), dot(along, along))), more(l * l * h * h, h * h * (a * a + h * h))),
        states("lemma-1.case-2.flat", "if a <= l, the foot of BR on the top is not after its end, so mfs(H) <= h",
               (*free, at_least(l, a)), at_least(a + l + b, l)),
        states("lemma-1.case-2.steep-foot", "if a > l, the foot of BR is on the left leg",
               steep, at_least(dot(along, along), dot(to, along))),
        states("lemma-1.case-2.steep", "if a > l, l h / |left leg| is less than h",
               steep, more(h * h * (a * a + h * h), l * l * h * h)),
        states("lemma-1.case-2.half-height", "if a <= l, the foot of s is on the bottom, at distance h/2",
               (*free, at_least(l, a)), at_least(l, (a + l) / 2)),
        states("lemma-1.case-2.half-leg", "if the foot of BR is on the left leg, so is that of s",
               (*free, at_least(dot(along, along), dot(to, along))),
               at_least(dot(along, along), dot(centre, along))),
        equality("lemma-1.case-2.half-distance", "s is half as far from the line of the left leg as BR", free,
                 cross(along, centre) * 2, cross(along, to)),
    ]
    flat = (more(l), more(h), at_least(a), at_least(b))
    corners = [spot(0, 0), spot(l, 0), spot(l + b, h), spot(-a, h)]
    for name, i, j in (SIDES[1], SIDES[3]):
        found += keeps_distance(f"lemma-1.case-1.half-{name.replace(' ', '-')}",
                                f"in case 1 s is at distance l/2 or more from the {name}", flat, spot(l / 2, h / 2),
                                corners[i], corners[j], l * l / 4)
    found.append(refuted("lemma-1.case-1.strictly", "in case 1 s is farther than l/2 from the right leg", flat,
                         more(4 * cross(corners[2].minus(corners[1]), spot(-l / 2, h / 2))**2,
                              l * l * dot(corners[2].minus(corners[1]), corners[2].minus(corners[1]))),
                         {"l": "1", "h": "1", "a": "0", "b": "0"}))
    return found


def equality(id_: str, says: str, hypotheses: tuple[Constraint, ...], p: Polynomial, q: Polynomial) -> Statement:
    """Return that p = q under the hypotheses, stated as (p - q)^2 <= 0."""
    return states(id_, says, hypotheses, at_least(0, (p - q)**2))


def theorems(found: list[Statement]) -> list[Theorem]:
    """Return what the statements show."""
    def having(*prefixes: str) -> tuple[str, ...]:
        return tuple(s.id for s in found if s.id.startswith(tuple(f"lemma-1.{prefix}" for prefix in prefixes)))
    case_1 = tuple(s for s in having("case-1.") if s != "lemma-1.case-1.strictly")
    case_2 = having("case-2.")
    own = tuple(f"{v}-{side.replace(' ', '-')}." for side, i, j in SIDES for k, v in enumerate(NAMES[:4])
                if k not in (i, j))
    own_1, own_2 = having(*(f"case-1.{o}" for o in own)), having(*(f"case-2.{o}" for o in own))
    reasons = having("case-2.foot", "case-2.flat", "case-2.steep")
    halves = having("case-2.half")
    near = having("case-1.near")
    return [
        Theorem("lemma-1.degradation", "claim", "every trapezoid: mfs with the new vertex >= mfs(H)/2",
                (*case_1, *case_2), WLOG, "rectangles with h <= l: the distance of s from the longer sides is h/2"),
        Theorem("lemma-1.case-1-feature-size", "claim", "mfs(H) = min(h, l) where R fits", (*own_1, *near),
                WLOG + " That mfs(H) <= l is the distance of two corners.", "an equality"),
        Theorem("lemma-1.case-2-feature-size", "claim", "mfs(H) = mfs(P) = min(h, l h / sqrt(a^2 + h^2))",
                (*own_2, *reasons), WLOG + " P is H with b = 0, and b is not in the formula.", "an equality"),
        Theorem("section-2.parallelogram-feature-size", "claim", "the formula, for b = 0", (*own_2, *reasons), WLOG,
                "an equality"),
        Theorem("section-2.parallelogram-centre", "claim", "case 2 with b = 0: exactly half is left",
                (*case_2,), WLOG + " Where mfs(P) = h, a <= l and half of it is the distance of s from the bottom; "
                "where not, the foot of BR, so that of s, is on the left leg, and s is half as far.", "an equality"),
        Theorem("section-2.rectangle-centre", "claim", "case 1 with a = b = 0: exactly half is left", case_1,
                WLOG + " The centre of a rectangle is h/2 and l/2 from its sides.", "an equality"),
        Theorem("lemma-1.side-distance", "corrected", "s is l/2 or more from the legs", having("case-1.half"), WLOG,
                "equality where a leg is vertical, which is why 'farther' is false"),
        Theorem("lemma-1.side-distance", "refuted", "'farther' is false", having("case-1.strictly"), WLOG, "a square"),
        Theorem("lemma-1.degradation", "part", "half of mfs(P) is attained", halves, WLOG),
    ]


GROUP = "lemma-1"
STATEMENTS = statements()
THEOREMS = theorems(STATEMENTS)

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
