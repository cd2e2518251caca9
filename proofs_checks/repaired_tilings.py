"""Prove that the faces of the Interior tile the inside of Q, those of the Tube what lies between P and Q, and so
Theorem 2's triangulation.

Given   `repaired.trapezoidation`, I1, I2, I3; nonproper and proper meshes (internal ones are checked on every run).
        Trapezoids have their sides on two levels. In the Tube: e from (0,0) to (l,0), l >= 1, e' from (x,y) to (z,w)
        above it, y, w >= g; 0.4247 the reach of K1.
Claim   All faces turn left, and their directed sides cancel but for those of the region, cut at chord ends and feet. So
        they tile it: about any point winding numbers, 1 inside a face and 0 outside, add up to the region's.
        wedge: its triangles and quadrilaterals turn left; feet are inside legs; a leg and a side lose a part but once.
        level: in what has its corners on two levels, diagonals and fans turn left. So a diagonal and a split do.
        tube: e' runs forward along e; it is not beyond e; so one end of e at least is below the line of e', the
        quadrilateral turns left, and the split that is the fan of that end has faces that turn left. Caps turn left.
Method  `check_trapezoids` triangulates all trapezoids with corners and T-vertices at up to `PLACES` places, of which a
        wedge reaches 3/2, and adds up the sides of the faces; `check_candidates` those of all candidates for up to
        `GAPS` gaps of two lengths; `tube_blocks` those of the Tube about rings of up to four corners. More T-vertices,
        gaps or corners add faces of the same kinds beside these.
Tight   no bounds.
By hand that `quad` takes the better diagonal, or what is better still, for a clean quadrilateral, and for a one-sided
        one the first candidate is taken that is good enough, or the best: of those whose value is positive.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, pairwise, product
from typing import NamedTuple

from gmpy2 import mpq
from kit import Hint, Spot, Statement, Theorem, at_least, cross, equal, main, more, spot, states
from repaired_caps import OCTAGON
from repaired_separation import STATEMENTS as SEPARATION

from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of
from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import LEVEL, WEDGE_HEIGHTS
from exactmesh.steps.frame import frame_of
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.one_sided import _candidates
from exactmesh.steps.records import Offset, Trapezoid, Trapezoidation

a, b, c, d, h, k, l, m, s, v, w, x, y, z, H, M, X = variables("a b c d h k l m s v w x y z H M X")  # noqa: E741
REACH = mpq(4247, 10000)
PLACES = 6
GAPS = 5
Side = tuple[int, int]


def boundary(faces: Iterable[Sequence[int]]) -> Counter[Side]:
    """Return the directed sides that are left when opposite ones cancel."""
    found = Counter(side for face in faces for side in pairwise((*face, face[0])))
    return Counter({side: n - found[side[::-1]] for side, n in found.items() if n > found[side[::-1]]})


class Room(NamedTuple):
    """A trapezoid: the places of its corners and T-vertices, and whether tl, tr, bl, br are vertices of Q."""

    top: tuple[int, ...]
    bottom: tuple[int, ...]
    of_q: tuple[bool, ...]


def rooms(places: int) -> Iterator[Room]:
    """Yield all trapezoids with corners and T-vertices at so many places on either level, the leftmost at 0.

    A wedge reaches 3/2 places: where no corner is so far from the one on the other level, which are of Q is all one.
    """
    sides = [(left, *inner, right) for left in range(places) for right in range(left, places)
             for n in range(max(0, right - left)) for inner in combinations(range(left + 1, right), n)]
    sides += [(left, left) for left in range(places)]
    for top, bottom in product(dict.fromkeys(sides), repeat=2):
        if min(top[0], bottom[0]) or (top[0] == top[-1] and bottom[0] == bottom[-1]):
            continue
        # An end of a side that a wedge at its other end reaches.
        reached = (bottom[-1] + 1 < top[0], top[-1] + 1 < bottom[0], top[-1] + 1 < bottom[0], bottom[-1] + 1 < top[0])
        for of_q in product(*((False, True) if is_reached else (True,) for is_reached in reached)):
            # At an apex two corners are one.
            if (top[0] != top[-1] or of_q[0] == of_q[1]) and (bottom[0] != bottom[-1] or of_q[2] == of_q[3]):
                yield Room(top, bottom, of_q)


def check_trapezoids(places: int, proper: bool) -> int:
    """Return how many trapezoids were triangulated; raises `AssertionError` for a face that does not turn left, and for
    sides that do not add up."""
    unit = WEDGE_HEIGHTS * LEVEL * 2 / 3
    found = list(rooms(places))
    at: list[Point] = []
    names: list[dict[tuple[str, int], int]] = [{} for _ in found]
    # Vertices of Q have the first numbers.
    for wanted in (True, False):
        for room, name in zip(found, names, strict=True):
            for side, row, flags in (("top", room.top, room.of_q[:2]), ("bottom", room.bottom, room.of_q[2:])):
                for i, place in enumerate(row):
                    of_q = flags[0] if i == 0 else flags[1] if i == len(row) - 1 else True
                    if of_q == wanted and (side, place) not in name:
                        name[side, place] = len(at)
                        at.append(Point(place * unit, LEVEL * (1 if side == "top" else 0)))
        if wanted:
            first = len(at)
    outlines = []
    trapezoids = []
    for number, (room, name) in enumerate(zip(found, names, strict=True)):
        top, bottom = ([name[side, place] for place in row]
                       for side, row in (("top", room.top), ("bottom", room.bottom)))
        trapezoids.append(Trapezoid(0, 1, 2 * number, 2 * number + 1, bottom[0], bottom[-1], top[-1], top[0],
                                    tuple(bottom[1:-1]), tuple(top[1:-1])))
        outlines.append([*dict.fromkeys(bottom), *dict.fromkeys(reversed(top))])
    none: tuple[int, ...] = ()
    patch = triangulate_interior(Offset(0, (), none, none, none, (), ()), Trapezoidation(
        first, tuple(at[first:]), none, tuple(trapezoids)), at, proper)
    points = (*at, *patch.points)
    for face in patch.faces:
        assert not isinstance(corners_of(points, face), NotTriangle), face
        assert not proper or len(face) == 3
    assert boundary(patch.faces) == boundary(_cut(trapezoids, outlines, patch.on_edge, points))
    return len(found)


def _cut(trapezoids: Sequence[Trapezoid], outlines: Sequence[Sequence[int]], feet: Iterable[Side],
         points: Sequence[Point]) -> list[list[int]]:
    """Return outlines with the feet on their legs."""
    on: dict[int, list[int]] = {}
    for edge, foot in feet:
        on.setdefault(edge, []).append(foot)
    cut = []
    for z, outline in zip(trapezoids, outlines, strict=True):
        left, right = (sorted(on.get(edge, []), key=lambda foot: points[foot].y) for edge in (z.left, z.right))
        for leg, low, high in ((left, z.bl, z.tl), (right, z.br, z.tr)):
            assert all(points[p].y < points[q].y for p, q in pairwise([low, *leg, high]))
        after_br = outline.index(z.br) + 1
        cut.append([*outline[:after_br], *right, *outline[after_br:], *reversed(left)])
    return cut


def check_candidates(gaps: int) -> Counter[tuple[bool, int, int]]:
    """Return how many candidates there were, by whether they are proper, the number of gaps and that of new vertices;
    raises `AssertionError` where sides do not add up, or where a face of a positive one does not turn left."""
    seen: Counter[tuple[bool, int, int]] = Counter()
    for lengths in (some for n in range(1, gaps + 1) for some in product((1, 5), repeat=n)):
        u = [mpq(sum(lengths[:i])) for i in range(len(lengths) + 1)]
        t_side = [Point(p, mpq(0)) for p in u]
        for low, high, left, right, proper in product((1, 2), (1, 3), (0, -2), (0, 7), (False, True)):
            anchors = Point(mpq(left, 3), mpq(low)), Point(u[-1] + mpq(right, 3), mpq(high))
            frame = frame_of(t_side, *anchors)
            outline = [*range(len(u)), frame.right, frame.left]
            for candidate in _candidates(frame, proper):
                assert boundary(candidate.faces) == boundary([outline]), candidate
                seen[proper, len(lengths), len(candidate.steiner)] += 1
                if candidate.value > 0:
                    # New vertices from the last to the first, so that -1 - i counts from the end.
                    points = (*frame.points(), *reversed(candidate.steiner))
                    for face in candidate.faces:
                        places = tuple(range(len(points))[j] for j in face)
                        assert not isinstance(corners_of(points, places), NotTriangle), candidate
    return seen


def tube_blocks() -> int:
    """Return for how many rings the sides of the Tube were added up; raises `AssertionError` where they do not."""
    count = 0
    for corners in (some for n in range(2, 5) for some in product(range(1, 6), repeat=n)):
        # Corner i of P is i, its vertices of Q 10 (i + 1) and on, a vertex recorded on edge i is -1 - i.
        size = len(corners)
        caps = [[10 * (i + 1) + j for j in range(number)] for i, number in enumerate(corners)]
        faces: list[tuple[int, ...]] = []
        ring: list[int] = []
        for i, cap in enumerate(caps):
            after = (i + 1) % size
            faces += [(i, q, p) for p, q in pairwise(cap)]
            faces.append((i, after, caps[after][0], -1 - i, cap[-1]))
            ring += [*cap, -1 - i]
        assert boundary(faces) == boundary([range(size), ring[::-1]])
        count += 1
    assert boundary((8, (j + 1) % 8, j) for j in range(8)) == boundary([range(8)[::-1]])
    return count + 1


def turns(id_: str, says: str, hypotheses: tuple[Constraint, ...], corners: Sequence[Spot]) -> Statement:
    """Return that three points turn left."""
    p, q, r = corners
    return states(f"tiles.{id_}", f"{says}: turns left", hypotheses, more(cross(q.minus(p), r.minus(p))),
                  Hint(degrees=(2, 3)))


LEFT, RIGHT = (spot(0, 0), spot(0, -d)), (spot(x, 0), spot(x, -c))
WEDGES = [
    turns("near", "the near corner, a foot d below, the vertex x beside", (more(x), more(d)),
          (spot(0, 0), spot(x, -d), spot(x, 0))),
    turns("far", "a foot d below its vertex, the far corner, the vertex", (more(M), more(d)),
          (spot(0, -d), spot(M, -H), spot(0, 0))),
    *(turns(f"between-{name}", "vertices x apart, feet c and d below", (more(x), more(d), more(c)), corners)
      for name, corners in (
          ("lower-left", (LEFT[1], RIGHT[1], LEFT[0])), ("lower-right", (LEFT[1], RIGHT[1], RIGHT[0])),
          ("upper-left", (LEFT[1], RIGHT[0], LEFT[0])), ("upper-right", (RIGHT[1], RIGHT[0], LEFT[0])))),
    states("tiles.foot-below", "the foot of a vertex x beside the near corner is below it",
           (more(x), more(M, x), more(H), equal(d * M, x * H)), more(d), Hint(degrees=(2, 3))),
    states("tiles.foot-above", "and above the far corner", (more(x), more(M, x), more(H), equal(d * M, x * H)),
           more(H, d), Hint(degrees=(2, 3))),
    states("tiles.leg-once", "a left leg, from a above to b below, is not reached from both sides, at v and at w",
           (more(X), at_least(v, a), more(b - X, v), at_least(w, b), more(a - X, w)), None),
    states("tiles.side-once", "v is not dropped on both legs, which are at b and c >= b on the other level",
           (more(X), more(b - X, v), more(v, c + X), at_least(c, b)), None),
    states("tiles.side-order", "what is dropped to the left, v, is before what is dropped to the right, w",
           (more(X), more(b - X, v), more(w, c + X), at_least(c, b)), more(w, v)),
]
LEVELS = [
    turns("level-below", "a side of length a on one level, a vertex on the other", (more(a), more(H)),
          (spot(0, 0), spot(a, 0), spot(x, H))),
    turns("level-above", "the same upside down", (more(a), more(H)), (spot(0, H), spot(x, 0), spot(a, H))),
]
E = (at_least(l, 1), more(z, x), at_least(y, LEVEL), at_least(w, LEVEL))
AT_0 = z * y - x * w  # z - x times the height of the line of e' over (0, 0)
AT_L = AT_0 + l * (w - y)
TUBE = [
    states("tiles.forward", "e' = (m c, d) is not level and e = (c, k) not upright, or both as e: forward",
           (more(m), more(c * c), at_least(d * k)), more(m * c * c + d * k)),
    states("tiles.begin-acute", "l s >= 1, e' begins at x, s x = h + k c, and snaps: before the end of e",
           (at_least(l, 1), more(s), at_least(1, s), at_least(c), at_least(1, c), at_least(l * s, 1),
            equal(s * x, h + k * c), at_least(REACH, h), at_least(REACH, k), at_least(k), at_least(LEVEL, 2 * d)),
           more(l, x + d), Hint(degrees=(2, 3))),
    states("tiles.begin", "e' begins at x <= 0.4247, and snaps: before the end of e",
           (at_least(l, 1), at_least(REACH, x), at_least(LEVEL, 2 * d)), more(l, x + d)),
    states("tiles.begin-obtuse", "s x = h - c k, h <= s m + c k: x <= m", (more(s), equal(s * x, h - c * k),
           at_least(s * m + c * k, h)), at_least(m, x), Hint(degrees=(2,))),
    states("tiles.line-within", "e' begins over e: its line is not above both ends of e on the wrong side",
           (*E, at_least(x), more(l, x), at_least(0, AT_0), at_least(0, AT_L)), None, Hint(degrees=(3,))),
    states("tiles.line-ends", "e' ends over e", (*E, more(z), at_least(l, z), at_least(0, AT_0), at_least(0, AT_L)),
           None, Hint(degrees=(3,))),
    states("tiles.line-around", "e' begins before e and ends beyond", (*E, more(0, x), more(z, l), at_least(0, AT_0)),
           None, Hint(degrees=(2,))),
    states("tiles.area-first", "the first end below the line: p, p', u_m, u_0 turn left", (*E, more(AT_0)),
           more(AT_0 + l * w), Hint(degrees=(2,))),
    states("tiles.area-last", "the last end", (*E, more(AT_L)), more(AT_0 + l * w), Hint(degrees=(2,))),
    turns("tube-base", "p, p' and a vertex on e'", (at_least(l, 1), at_least(y, LEVEL)),
          (spot(0, 0), spot(l, 0), spot(x, y))),
    *(turns(f"cap-{i}", "an edge of K1 after at most half a level, and p, all m times their size",
            (more(m), at_least(2 * s, -LEVEL * m), at_least(LEVEL * m, 2 * s)),
            (spot(0, 0), spot(m * p.x, m * p.y + s), spot(m * q.x, m * q.y + s)))
      for i, (p, q) in enumerate(zip(OCTAGON, (*OCTAGON[1:], OCTAGON[0]), strict=True))),
]
STATEMENTS = [*WEDGES, *LEVELS, *TUBE]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


# Of `repaired.offset-separation`: how far the far end of an edge is from the one before it.
FAR = tuple(s.id for s in SEPARATION if s.id.startswith(("separation.edge-sine", "separation.longer")))
assert len(FAR) == 3
FACES = ("Faces that turn left and whose sides cancel but for the region's tile it, by winding numbers. Every kind of "
         "candidate has the sides of its piece, by program; it is taken only if its faces turn left. ")
INTERIOR = (
    FACES + "Trapezoids tile by `repaired.trapezoidation`. A leg has a wedge from one side only (`leg-once`), a side "
    "loses vertices to the left before those to the right (`side-once`, `side-order`): so what a wedge leaves has its "
    "sides on two levels, each from left to right or a point. Cross edges go from one to the other, from left to "
    "right, and leave the same. There a diagonal, and every split, turns left (`level`): a piece has a candidate. The "
    "quadrilaterals of a wedge are between verticals (`between`). Feet are inside legs, and no two of one trapezoid on "
    "one leg are below the same vertex; different trapezoids have different parts of an edge.")
TUBE_WORDS = (
    FACES + "K1 is about p, so caps turn left. e' has the direction (m c, d) where e has (c, k): snapping keeps the "
    "sign of d weakly, and e' does not vanish (I2). The beginning of e': p + k begins at 0.4247 at most; a crossing at "
    "x with s x = h + k c, h and k the extents of K1 along the normals, s and c of the angle: `begin-acute`, where "
    "l s >= 1 by `edge-sine`; from 90 degrees on c < 0, and h is at most s times K1's extent m along e and -c k. The "
    "other end by reflection: so e' is over a part of e. Then an end of e is below the line of e' (`line`), the frame "
    "is on its side (`area`), and the fan of that end, with the triangle of e (`tube-base`), turns left. P and Q are "
    "what is left over: the region between, as Q is simple and inside (I3).")
GROUP = "repaired-tilings"
THEOREMS = [
    Theorem("repaired.interior-tiling", "claim", "the faces of the Interior tile the inside of Q, in nonproper and "
            "proper meshes", names(WEDGES, LEVELS), INTERIOR, "nothing is left out", ("repaired.trapezoidation",)),
    Theorem("repaired.tube-tiling", "claim", "the faces of the Tube tile what lies between P and Q",
            (*names(TUBE), *FAR, "gaps.reach", "gaps.reach-upper"), TUBE_WORDS, "nothing is left out",
            ("repaired.offset-thickness", "repaired.offset-separation", "repaired.offset-nesting",
             "repaired.caps-whole")),
    Theorem("theorem-2.triangulation", "claim", "a proper mesh is a triangulation that leaves the boundary whole",
            names(WEDGES, LEVELS), "The Interior and the Tube meet along Q; triangles stay as they are. Sides cancel "
            "whole, so no vertex is inside one; faces of candidates for proper meshes have three sides, by program; no "
            "vertex is put on P.", "", ("repaired.interior-tiling", "repaired.tube-tiling")),
]

if __name__ == "__main__":
    print(*(f"{check_trapezoids(PLACES, proper)} trapezoids" for proper in (False, True)),
          f"{sum(check_candidates(GAPS).values())} candidates", f"{tube_blocks()} rings", sep="\n")
    main(GROUP, THEOREMS, STATEMENTS)
