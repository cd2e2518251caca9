"""Prove that an edge e' stays 0.15 away from the cap at its own end, however snapping tilts it (step (d)).

Given   K1, the octagon of the construction; k, the vertex of K1 that is extreme for the normal of e and ends the cap of
        a corner (or begins it); up to four other vertices of the cap, which precede k clockwise (or follow it); e' has
        the direction (dx, dy) of e before snapping. Vertices are rounded to levels by one monotone rule, so e' keeps
        dx, and the sign of dy weakly, and is level if it was: afterwards it has the direction (dx, dz).
Claim   each other vertex of the cap is at distance 0.15 or more from the whole ray from k in the direction (dx, dz),
        away from the cap for an outgoing e', backwards for an incoming one.
Method  dy > 0, dy < 0, dy = 0; k is extreme: (-dy, dx).(k - k') >= 0 for the two neighbours k'; a problem for each
        other vertex, with its foot on the ray.
Tight   0.15 is the width of a flat cap: its two vertices, with e' leaving at 90 degrees or more.
By hand that caps have at most five vertices (a corner turns by at most 180 degrees more than a half octagon); that
        rounding is monotone; that it holds at every moment of the motion, because the statement is about every dz.
"""

from kit import Spot, Statement, Theorem, at_least, bounded, cross, dot, main, more, spot, square

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FLAT, GAP, LEVEL, WIDE

dx, dy, dz = variables("dx dy dz")
HALF = LEVEL / 2
OCTAGON = [spot(x, y) for x, y in ((WIDE, -HALF), (WIDE, HALF), (FLAT, 3 * HALF), (-FLAT, 3 * HALF), (-WIDE, HALF),
                                   (-WIDE, -HALF), (-FLAT, -3 * HALF), (FLAT, -3 * HALF))]


def statements() -> list[Statement]:
    """Return the statements for every k, direction of e', sign of dy and other vertex of the cap."""
    normal = spot(-dy, dx)
    found = []
    for i, k in enumerate(OCTAGON):
        extreme = tuple(at_least(dot(normal, k.minus(OCTAGON[(i + turn) % 8]))) for turn in (1, -1))
        for way, sign in (("out", 1), ("in", -1)):
            for slope, up in (("up", 1), ("down", -1), ("level", 0)):
                ray = spot(sign * dx, sign * dz if up else 0)
                given = ((*extreme, more(up * dy), at_least(up * dz)) if up else
                         tuple(Constraint(c.polynomial.substitute({"dy": 0}), c.relation) for c in extreme))
                for step in range(1, 5):
                    other = OCTAGON[(i + sign * step) % 8].minus(k)
                    where = f"k{i}, e' {way}, {slope}, vertex {step} steps away"
                    id_ = f"caps.k{i}-{way}-{slope}-{step}"
                    found += ray_statements(id_, where, given, ray, other)
    return found


def ray_statements(id_: str, where: str, given: tuple[Constraint, ...], ray: Spot, other: Spot) -> list[Statement]:
    """Return that `other` keeps its distance from the ray from the origin; behind it, the distance is a constant."""
    return [bounded(f"{id_}.ahead", f"{where}; the foot is on the ray",
                    (*given, at_least(dot(other, ray)), more(dot(ray, ray))),
                    lambda f: at_least(cross(ray, other)**2, square(f) * GAP**2 * dot(ray, ray)))]


GROUP = "caps"
STATEMENTS = statements()
THEOREMS = [Theorem(
    "repaired.offset-separation", "part", "e' keeps 0.15 from the cap at its own end", tuple(s.id for s in STATEMENTS),
    "Where the foot is behind the ray the nearest point is k, and two vertices of the octagon are 0.15 or more apart. "
    "Rounding is monotone. Other pairs are not covered.", "0.15 is the width of a flat cap")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
