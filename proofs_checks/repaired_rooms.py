"""Prove `theorem-3.triangulation`: internal meshes are proper triangulations. And I1, I2, chord-leg in units of ifs.

Given   ifs 1 (m <= ifs): a path in the closed face between features without a common vertex is 1 long or longer. Q by
        `repaired.offset-nesting`, trapezoids by `repaired.trapezoidation`; no edge has the face on both sides.
        A piece of a chord of length L begins at c and ends at f; a leg of slope s beside it at c has reach r = 0.057/s,
        one at f has o. g = 0.232, `MERGE` = 0.075.
Claim   trimming: a foot is inside its leg, less than g from the chord; what is left of a piece is longer than `MERGE`.
        columns: of two columns of a room the ends on both chains are in the same order.
        tube: the quadrilaterals between feet have a diagonal with triangles that turn left, and so have those at p.
Method  combinations. By program: `pieces` lists the kinds of pieces of chords, `check_sides` looks at all kinds of
        corner, `check_polygons` triangulates polygons between two chains, all on a small grid.
Tight   nothing: these are orders and signs.
By hand what leads to the inequalities: `PATHS`, `ROOMS`, `TUBE_WORDS`.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise, product

from gmpy2 import mpq
from kit import Hint, Spot, Statement, Theorem, at_least, bounded, cross, equal, main, more, spot, states
from repaired_nesting import directions, vertices_at
from repaired_offset import REACH as REACHES
from repaired_offset import THICK, names
from repaired_separation import STATEMENTS as SEPARATIONS
from repaired_tilings import FAR, TUBE, boundary

from exactmesh.geometry.point import Point
from exactmesh.geometry.point import cross as cross_of
from exactmesh.geometry.predicates import orientation
from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import GAP, LEVEL, MERGE, SEPARATION, TRIM
from exactmesh.steps.quad import quad
from exactmesh.steps.small_polygon import triangulate_small

a, b, c, d, h, k, l, m, o, p, q, r, s, t, u, v, w, x, y, z, L = variables(  # noqa: E741
    "a b c d h k l m o p q r s t u v w x y z L")
REACH = mpq(4247, 10000)
GRID = 4, 3

# What lies beside the chord at an end of a piece that is a vertex of Q: no leg, one below, one above, both. At a chord
# end one edge goes on: a leg on one side of the chord, unless it is upright.
AT_VERTEX = ((), ("below",), ("above",), ("below", "above"))
AT_CHORD_END = ((), ("below",), ("above",))
LABELS = {
    "whole": "no leg beside the chord at f on the other side: o <= r, or both legs belong to one room",
    "same": "the leg at f is on the same side: of one room, and they do not cross within a level (`same-side`)",
    "vertex": "c is a vertex of Q and the leg of f passes over it (`near`)",
    "edges": "c is a chord end and the edges of c and f do not cross within a level (`edges`)",
    "touch": "c and f are chord ends: the side has no vertex of Q, against `repaired.chord-touch`",
}


def pieces() -> Iterator[tuple[str, tuple[object, ...]]]:
    """Yield, with its label, every kind of piece that is trimmed from c along a leg: what c and f are, the side of that
    leg, and the side of the leg with the greatest reach at f, if there is one."""
    for c_of_q, f_of_q in product((True, False), repeat=2):
        for at_c, at_f in product(AT_VERTEX if c_of_q else AT_CHORD_END, AT_VERTEX if f_of_q else AT_CHORD_END):
            for own in at_c:
                for opposite in at_f or (None,):
                    label = ("touch" if not c_of_q and not f_of_q else "whole" if opposite is None else
                             "same" if opposite == own else "vertex" if c_of_q else "edges")
                    yield label, (c_of_q, f_of_q, at_c, at_f, own, opposite)


def polygons(places: int, heights: int) -> Iterator[list[Point]]:
    """Yield all polygons on a grid between a top and a bottom chain that go from left to right, share their ends or
    have upright edges there, and touch nowhere else."""
    rows = list(product((None, *range(heights)), repeat=places - 2))
    chains = [(first, *inner, last) for first in range(heights) for last in range(heights) for inner in rows]
    for bottom, top in product(chains, repeat=2):
        low, high = ([_height(chain, i) for i in range(places)] for chain in (bottom, top))
        ends = [high[i] - low[i] for i in (0, -1)]
        if min(ends) < 0 or any(high[i] <= low[i] for i in range(1, places - 1)):
            continue
        lower, upper = ([Point(mpq(i), mpq(height)) for i, height in enumerate(chain) if height is not None]
                        for chain in (bottom, top))
        yield list(dict.fromkeys((*lower, *reversed(upper))))


def _height(chain: Sequence[int | None], place: int) -> mpq:
    """Return the height of a chain at a place, between its vertices."""
    i, before = max((i, height) for i, height in enumerate(chain[:place + 1]) if height is not None)
    j, after = min((j, height) for j, height in enumerate(chain) if j >= place and height is not None)
    return mpq(before) if i == j else before + mpq(after - before) * (place - i) / (j - i)


def check_polygons(places: int, heights: int) -> int:
    """Return how many polygons were triangulated; raises `AssertionError` for a face that does not turn left, and for
    sides that do not add up, by `triangulate_small` and, with four vertices, by `quad`."""
    count = 0
    for outline in polygons(places, heights):
        if len(outline) < 3 or all(orientation(outline[0], outline[1], at) == 0 for at in outline):
            continue
        ring = tuple(range(len(outline)))
        ways = [(triangulate_small(outline), tuple(outline))]
        if len(outline) == 4:
            piece = quad(outline)
            ways.append((piece.faces, (*outline, *reversed(piece.steiner))))
        for faces, points in ways:
            places_of = range(len(points))
            turned = [tuple(places_of[i] for i in face) for face in faces]
            assert all(len(face) == 3 and orientation(*(points[i] for i in face)) > 0 for face in turned), outline
            assert boundary(turned) == boundary([ring]), outline
        count += 1
    return count


def check_sides() -> int:
    """Return at how many vertices of Q, one of each kind of corner, an edge comes from the right and one goes to the
    right, or the same on the left; raises `AssertionError` where the angle inside is above 180 degrees at one."""
    count = 0
    for d0, d1 in product(directions(), repeat=2):
        made = vertices_at(d0, d1)
        ways = [d0, *(Point(after.x - before.x, after.y - before.y) for before, after in pairwise(made)), d1]
        for coming, going in pairwise(ways):
            if coming.x * going.x < 0:
                count += 1
                assert cross_of(coming, going) > 0, (d0, d1)
    return count


PIECES = Counter(label for label, _ in pieces())
assert set(PIECES) == set(LABELS), PIECES

LEG = more(r, MERGE)
TRIMMING = [
    states("rooms.foot", "o <= r and L <= r + o + 0.075: at f the leg is less than a level from the chord",
           (LEG, at_least(o), at_least(r, o), at_least(r + o + MERGE, L)), more(LEVEL * r, TRIM * L)),
    states("rooms.same-side", "both legs go down, and do not cross within a level: there is room for both trims",
           (LEG, at_least(o), at_least(TRIM * L, LEVEL * (r + o))), more(L, r + o + MERGE)),
    states("rooms.near", "L < o: the leg of f passes over c within 0.057, but c is 0.0599 from it",
           (more(L), more(o, L), equal(h * o, TRIM * L), at_least(h, SEPARATION)), None, Hint(degrees=(2, 3))),
    states("rooms.edges", "L < o: the edges of c and f do not cross within the level above, so o is near r",
           (LEG, more(L), more(o, L), at_least(TRIM * L, LEVEL * (o - r))), more(LEVEL * r, TRIM * L)),
    states("rooms.corner", "a leg of a level's height, not steeper than one that is trimmed, is longer than 0.075",
           (more(s), more(TRIM, t * MERGE), at_least(t, s), more(x), at_least(s * x, LEVEL)), more(x, MERGE),
           Hint(degrees=(2, 3))),
    states("rooms.two", "two neighbours of Q on a chord on the same side of a vertex are not both within 0.075",
           (at_least(x, SEPARATION), at_least(y, SEPARATION)), more(x + y, MERGE)),
]
GAPS = [
    states("rooms.depth", "o <= r: the foot at f is within 0.171 of the chord",
           (LEG, at_least(o), at_least(r, o), at_least(r + o + MERGE, L)), more(3 * r, L)),
    states("rooms.depth-edges", "L < o: the same, as the edges of c and f do not cross",
           (LEG, more(L), more(o, L), at_least(TRIM * L, LEVEL * (o - r))), more(3 * r, L)),
    bounded("rooms.far", "a foot h before the far level, on a leg of slope 0.057/r, and the corner there",
            (LEG, at_least(h, LEVEL - 3 * TRIM)),
            lambda f: at_least(h * h * (TRIM * TRIM + r * r), MERGE**2 * mpq(f)**2 * TRIM**2),
            Hint(degrees=(2, 3, 4), squares=(h, r))),
    bounded("rooms.beside", "v, x beside the end of a leg of slope s, is 0.0599 from it: that end and what is below v",
            (more(s), more(x), at_least(s * s * x * x, SEPARATION**2 * (1 + s * s))),
            lambda f: at_least(x * x * (1 + s * s), MERGE**2 * mpq(f)**2),
            Hint(degrees=(2, 3, 4, 6), squares=(s, x, s * s - 1))),
]
COLUMNS = [
    states("rooms.order", "columns from x and y > x: where both are ends to choose from, the nearest are in order",
           (more(y, x), more(p, q), at_least((q - x)**2, (p - x)**2), at_least((p - y)**2, (q - y)**2)), None,
           Hint(degrees=(2, 3))),
    states("rooms.before", "the nearest of w is z < v, where v could be chosen: then w < v",
           (more(v, z), at_least((v - w)**2, (z - w)**2)), more(v, w), Hint(degrees=(2, 3))),
    states("rooms.nearer", "a vertex w between u and v is nearer to v than u is", (more(w, u), more(v, w)),
           more((v - u)**2, (v - w)**2), Hint(degrees=(2, 3))),
    states("rooms.within", "v is within 0.075 of u, and p and w are between, p first: w is within 0.075 of p",
           (at_least(u + MERGE, v), at_least(p, u), at_least(v, w)), at_least(p + MERGE, w)),
]
ANGLE = (equal(c * c + k * k, 1), at_least(c), at_least(k))
AT_P = [
    bounded("rooms.edge", "from w to w1 by an e' before it snaps: it is 0.15 long", (at_least(m + 2 * REACH, 1),),
            lambda f: at_least(m, GAP * mpq(f))),
    states("rooms.tilt-slanted", "e' = (m c, d) is not level, e = (c, k): forward by more than 0.075 c",
           (*ANGLE, at_least(m, GAP), at_least(d, LEVEL)), more(m * c * c + d * k, MERGE * c),
           Hint(degrees=(2, 3, 4), squares=(c - mpq(1, 2), c - 1, k))),
    states("rooms.line-slanted", "forward by u > 0.075 c, up by g c at most, from (x, y), x <= 0.075: above p",
           (at_least(c), more(u, MERGE * c), at_least(LEVEL * c, z), at_least(z), at_least(MERGE, x), at_least(x),
            at_least(y, LEVEL)), more(u * y, z * x), Hint(degrees=(2, 3))),
    states("rooms.line-level", "e' = (m c, 0) has a vertex inside, so m c >= 0.15, and m k <= g: above p",
           (more(m), more(c), at_least(k), at_least(m * c, 2 * MERGE), at_least(LEVEL, m * k), at_least(MERGE, x),
            at_least(x), at_least(y, LEVEL)), more(m * c * c * y, m * c * k * x), Hint(degrees=(2, 3, 4, 5))),
    states("rooms.line-behind", "e' begins before p and ends beyond: its line is above p",
           (at_least(0, x), more(z), at_least(y, LEVEL), at_least(w, LEVEL)), more(z * y, x * w), Hint(degrees=(2,))),
    states("rooms.fan", "vertices (x, y), (x + t a, y + t b) of an e' whose line is above p: p, the later, the earlier",
           (more(t), more(a * y, b * x)), more((x + t * a) * y, (y + t * b) * x), Hint(degrees=(2, 3))),
]




def left(id_: str, says: str, given: tuple[Constraint, ...], corners: Sequence[Spot]) -> Statement:
    """Return that three points turn left."""
    first, second, third = corners
    return states(f"rooms.{id_}", f"{says}: turns left", given, more(cross(second.minus(first), third.minus(first))),
                  Hint(degrees=(2, 3)))


BETWEEN = (more(l), at_least(y, LEVEL), at_least(w, LEVEL))
AT_END = (*BETWEEN, more(l, x))
FEET = [
    left("feet-lower", "two feet l apart, and the second vertex", BETWEEN, (spot(0, 0), spot(l, 0), spot(l, w))),
    left("feet-upper", "the first foot, and both vertices", BETWEEN, (spot(0, 0), spot(l, w), spot(0, y))),
    left("end-lower", "p, a foot at l, and a vertex before it", AT_END, (spot(0, 0), spot(l, 0), spot(x, y))),
    left("end-upper", "that foot, its vertex, and the one before", AT_END, (spot(l, 0), spot(l, w), spot(x, y))),
]
STATEMENTS = [*TRIMMING, *GAPS, *COLUMNS, *AT_P, *FEET]

PATHS = (
    "In units of the ifs. I1 (`offset`) speaks of a corner and its edges alone. "
    "A vertex q of Q and a point y of an edge f of Q, |q y| < 0.0599. If the segment q y is in the closed face: q, and "
    "y, are joined to their sources by segments in the face of length 0.47003 at most (`repaired.offset-nesting`), so "
    "with q y there is a path of length below 1, and sources have a common vertex. What is left of the list of pairs "
    "is at one corner, or at one vertex, where Q's other corners are outside the wedge and so g away, or in a "
    "triangle: of all vertices in it take the one nearest to its sides; it sees its foot there, so the inradius is 1 "
    "or more. If q y leaves the face, it first meets P at a point z of an edge: q z is in the face, so that edge has "
    "a vertex with q's source in common, it is not inside the wedge of q, and q is g away from it. ")
ROOMS = (
    "Trimming: `LABELS`, for every kind of piece. A foot is at 0.057 from the chord, or at that of the leg at f: then "
    "L <= r + o + 0.075 and o <= r, or L < o (`_end_of_chord`). So it is inside its leg, before the other level; a "
    "room loses what is left (right) of an upright line through k, at most once at either side, of two on different "
    "levels they are on either side of the far corner of the leg. So what is left of a trapezoid is convex, its chains "
    "go from left to right, and it gains slivers below c k or above. A piece that is left is over 0.075 long, by the "
    "first case of `_end_of_chord`. "
    "What needs an edge is on the level of its chord: other places on legs stay, feet and corners of a leg and a chord "
    "are convex; so is that of two legs but for a c that is followed by a sliver, and then the leg before is not "
    "steeper than the trimmed one (`corner`). No f that is all that is left of a piece has a leg of the same chain "
    "after it: at a chord end the foot would be beyond that leg, which goes on below; at a vertex of Q, one edge would "
    "go up and away and the other the same way, with the inside around it (`check_sides`; snapping keeps abscissae, "
    "and Q is simple, so an angle between edges to one side stays below 180 degrees). "
    "A column from v ends at u, straight below or within 0.075. No k or c of the other chain is between (`nearer`), "
    "none of its own is at another level; so the column is in the convex part, or crosses the level between c and k. "
    "A neighbour that is on both chains is passed over; it is within 0.075 only of a v on its chord (`corner`), and "
    "then of no vertex beyond v (`two`, and new vertices are over 0.075 from their neighbours on a chord): it is the "
    "end of no column from its own chord, and a vertex made for v is on a leg. "
    "Order: from one chain, left to right: the nearest are in order (`order`); a vertex made in between, at w, had u "
    "not within 0.075 (`within`). From the bottom afterwards: w has no column. If u < w and its end z < v, then w < v "
    "(`before`), and w was not there for v (`nearer`): it was made from below, on a chord, without the vertex p before "
    "it within 0.075, where u <= p (`within`). So segments within a room, in order, do not cross; what is between is a "
    "simple polygon. It has a triangulation with all its vertices as corners, and all faces left, flat vertices too: "
    "`triangulate_small` and `quad` take the best, and a centre only if it is better. "
    "On a chord both rooms have the same vertices: what is put into one is put into the other, or on a level edge of "
    "Q, or a leg, and is recorded. So all sides cancel but for the edges of Q, cut at what is recorded. ")
TUBE_WORDS = (
    "Tube: e' is forward (`tiles.forward`), before and after the ends of e as in `repaired.tube-tiling`; there the "
    "far end of e0 is 1 from the line of e1 also in the ifs: an upright of e1 up to e0 that moves away from the corner "
    "first meets a vertex, which sees its foot on e1. Feet are in order, those at p first, those at q last, as |e| is "
    "1 or more. Between two feet: `feet`. From p to a foot inside: `end`, whatever is before; to q: by reflection. "
    "From p to q: one of them is below the line of e' (`tiles.line`). Two vertices with foot p: the second has x <= "
    "0.075, so e' begins there; it is 0.15 long before it snaps (`edge`: its ends are joined to e0 and e2 by ribs, or "
    "around a triangle to p and p'; in one, e' is longer), or level with a vertex inside, over 0.075 from its ends: "
    "its line is above p (`line`), and they are a triangle (`fan`). Caps turn left, divided or not. No edge has the "
    "face on both sides, so what is put on it splits nothing else, and it is split at all feet.")
GAP_WORDS = (
    "Neighbours on an edge of Q: vertices on two levels are g apart. A foot is over 0.075 beside c, and from the far "
    "corner of its leg as `far` says. A new vertex is over 0.075 beside all of its room's chain but a neighbour of v "
    "that is on both chains, where v is on the chord that begins there: `beside`. On a level edge it is over 0.075 "
    "from its neighbours, as on a chord. Two vertices of Q on a chord or a level edge are on different edges of Q, and "
    "a chord end is on one: 0.0599 apart. ")
INTERNAL = tuple(statement.id for statement in (*TRIMMING, *COLUMNS, *AT_P, *FEET))
TUBE_NAMES = (*(statement.id for statement in TUBE), *FAR, "gaps.reach", "gaps.reach-upper")
SEPARATE = (*(statement.id for statement in SEPARATIONS), "offset.separation", "offset.reaches", "nesting.wedge")
GROUP = "rooms"
THEOREMS = [
    Theorem("repaired.offset-separation", "part", "in internal meshes, in units of the ifs", SEPARATE, PATHS,
            "what is wide enough across the outside", ("repaired.offset-nesting", "repaired.offset-thickness")),
    Theorem("repaired.chord-leg", "part", "in internal meshes, in units of the ifs", SEPARATE, PATHS,
            "", ("repaired.offset-separation",)),
    Theorem("repaired.offset-thickness", "part", "in internal meshes", names([*THICK]),
            "It speaks of a corner and its edges alone, in units of m, whatever m is.", ""),
    Theorem("repaired.offset-reach", "part", "in internal meshes", names([*REACHES]),
            "It speaks of a corner and its edges alone, in units of m, whatever m is.", ""),
    Theorem("repaired.interior-tiling", "part", "in internal meshes", tuple(
        statement.id for statement in (*TRIMMING, *COLUMNS)), ROOMS + PATHS, "", (
            "repaired.trapezoidation", "repaired.chord-touch", "repaired.chord-clearance", "repaired.chord-leg")),
    Theorem("theorem-3.triangulation", "claim", "an internal mesh is a proper triangulation", (
        *INTERNAL, *TUBE_NAMES), ROOMS + TUBE_WORDS + " " + PATHS,
            "by program: 48 kinds of pieces, 1024 corners, small polygons", (
            "repaired.interior-tiling", "repaired.offset-thickness", "repaired.offset-separation",
            "repaired.offset-nesting")),
    Theorem("repaired.internal-degradation", "part", "neighbours on an edge of Q keep 0.075, but 0.0599 where two "
            "vertices of Q are joined by a level edge; on chords 0.0599, and over 0.075 if one of them is new", tuple(
                statement.id for statement in (*GAPS, *TRIMMING, *COLUMNS)), GAP_WORDS + ROOMS + PATHS,
            "0.0763 is the least that was seen on a leg, 0.0755 on a chord", ("repaired.offset-separation",)),
]

if __name__ == "__main__":
    print(f"{sum(PIECES.values())} kinds of pieces", f"{check_sides()} vertices", f"{check_polygons(*GRID)} polygons",
          sep="\n")
    main(GROUP, THEOREMS, STATEMENTS)
