"""Prove that every face of the Interior keeps f* = g/5 in the repaired construction.

Given   the trapezoids of `repaired.trapezoidation`, H >= g high. A corner is a vertex of Q or crosses its edge, which
        goes on for g beyond it (`repaired.chord-clearance`); a side has a vertex of Q (`repaired.chord-touch`); these
        keep F = 0.0599 from the edges of Q without them (`repaired.offset-separation`, `repaired.chord-leg`), and
        T-vertices w = 0.15 from their neighbours, unless a level edge leads to a corner, whose leg then leans to the
        T-vertex's side (`repaired.chord-gap`, the last case of `repaired.edge-gap`).
Claim   steeper: a point F or more from a leg that leans outwards is so from a steeper one from the same corner.
        far: a leg that leans by 2 H or more is far from what is as far from its end.
Method  All trapezoids are enumerated: which corners are vertices, apexes, leans of legs, what each of the four wedges
        drops (nothing, T-vertices, also the corner), on which sides T-vertices are left. Order and reaches are
        differences of abscissae in units of H, of which `possible` tells exactly whether they contradict each other.
        `leaves` names the lemma for whatever `interior.py` makes of each; where none is named, an assertion fails.
Tight   see `pieces` and `clean`.
By hand that `leaves` reads `wedges.py` and `interior.py` rightly (tests compare), and the lemmas' own arguments.
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import product

from kit import Hint, Theorem, at_least, main, states
from repaired_clean import STATEMENTS as CLEAN
from repaired_gaps import NAMES as GAPS
from repaired_pieces import NESTS, SPLITS
from repaired_pieces import STATEMENTS as PIECES
from repaired_wedges import STATEMENTS as WEDGES

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FEATURE, LEVEL, SEPARATION, WEDGE_HEIGHTS

LEFT, RIGHT, TOP, BOTTOM = 1, -1, 1, -1
CORNERS = tuple(product((LEFT, RIGHT), (TOP, BOTTOM)))
NOTHING, SOME, CORNER = "nothing", "T-vertices", "also the corner"
VERTEX, CROSSING, DROPPED = "vertex", "crossing", "dropped"
REACH = int(WEDGE_HEIGHTS)
# x_a - x_b <= c, or < c.
Difference = tuple[object, object, int, bool]


def possible(differences: Sequence[Difference]) -> bool:
    """Return whether there are abscissae with these differences: no cycle of them adds up to less than nothing."""
    # Numbers are multiples of 1000, less one for each strict bound: at most 1000 of these are in a cycle.
    bound: dict[tuple[object, object], int] = {}
    for a, b, c, strict in differences:
        bound[a, b] = min(bound.get((a, b), 10**9), 1000 * c - strict)
    names = sorted({name for pair in bound for name in pair}, key=str)
    for k, i in product(names, names):
        if (i, k) in bound:
            for j in names:
                if (k, j) in bound:
                    bound[i, j] = min(bound.get((i, j), 10**9), bound[i, k] + bound[k, j])
    return all(bound.get((name, name), 0) >= 0 for name in names)


def at_most(s: int, a: object, b: object, c: int = 0, strict: bool = False) -> Difference:
    """Return s x_a <= s x_b + c, or <."""
    return (a, b, c, strict) if s > 0 else (b, a, c, strict)


@dataclass
class Case:
    """A kind of trapezoid: `vertex[s, t]` whether the corner at the end s of side t is one, `apex` the side that is a
    point, `lean[s]` whether a leg leans outwards (1) or inwards (-1) on its way down, `wedge[s, t]` what is dropped at
    the end s of side t, `left[t]` whether T-vertices are left on side t, `given` what that means.

    Abscissae: corners are (s, t), the last T-vertex dropped is (s, t, "v"), any that is left is (t, "u").
    """

    vertex: dict[tuple[int, int], bool]
    apex: int
    lean: dict[int, int]
    wedge: dict[tuple[int, int], str]
    left: dict[int, bool]
    given: list[Difference] = field(default_factory=list)

    def follows(self, difference: Difference) -> bool:
        """Return whether a difference is implied."""
        a, b, c, strict = difference
        return not possible([*self.given, (b, a, -c, not strict)])

    def is_new(self, s: int) -> bool:
        """Return whether the leg goes to a dropped vertex."""
        return any(self.wedge[s, t] != NOTHING for t in (TOP, BOTTOM))

    def corner(self, s: int, t: int) -> object:
        """Return the corner that is left."""
        dropped = self.wedge[s, t]
        return (s, t, "v") if dropped == SOME else (-s, t) if dropped == CORNER else self._apex(s, t)

    def _apex(self, s: int, t: int) -> object:
        return (LEFT, t) if self.apex == t else (s, t)

    def is_point(self, t: int) -> bool:
        """Return whether nothing but a point is left of a side."""
        return self.apex == t or CORNER in (self.wedge[LEFT, t], self.wedge[RIGHT, t])

    def kind(self, s: int, t: int) -> str:
        """Return what the corner that is left is."""
        dropped = self.wedge[s, t]
        return DROPPED if dropped == SOME else VERTEX if dropped == CORNER or self.vertex[s, t] else CROSSING

    def leans(self, s: int, t: int) -> int:
        """Return 1 where the original leg leans outwards as seen from side t, 0 where it is straight, else -1."""
        return self.lean[s] * t

    def is_outward(self, s: int, t: int) -> bool:
        """Return whether the leg that is left leans outwards as seen from side t."""
        return self.follows(at_most(s, self.corner(s, -t), self.corner(s, t), 0, strict=True))


def of_order(vertex: dict[tuple[int, int], bool], apex: int, lean: dict[int, int]) -> list[Difference]:
    """Return the order of the corners."""
    given: list[Difference] = []
    for t in (TOP, BOTTOM):
        given.append(at_most(1, (LEFT, t), (RIGHT, t), 0, strict=apex != t))
        if apex == t:
            given.append(at_most(1, (RIGHT, t), (LEFT, t)))
    for s in (LEFT, RIGHT):
        # The leg leans outwards downwards, is straight, or leans inwards.
        if lean[s] > 0:
            given.append(at_most(s, (s, BOTTOM), (s, TOP), 0, strict=True))
        elif lean[s] < 0:
            given.append(at_most(s, (s, TOP), (s, BOTTOM), 0, strict=True))
        else:
            given += [at_most(s, (s, TOP), (s, BOTTOM)), at_most(s, (s, BOTTOM), (s, TOP))]
    return given


def of_wedge(case: Case, s: int, t: int) -> list[Difference] | None:
    """Return what it means that a wedge drops what it does, None where it cannot."""
    far, near, end = (s, -t), (s, t), (-s, t)
    can_go = case.vertex[end] and case.apex != t
    dropped = case.wedge[s, t]
    found = []
    if dropped == CORNER:
        return [at_most(s, end, far, -REACH, strict=True)] if can_go and not case.left[t] else None
    if can_go:
        # It stays, or no T-vertex before it does not.
        found.append(at_most(s, far, end, REACH))
    if dropped == SOME:
        v = (s, t, "v")
        found += [at_most(s, near, v, 0, strict=True), at_most(s, v, end, 0, strict=True),
                  at_most(s, v, far, -REACH, strict=True)]
    if case.left[t]:
        u = (t, "u")
        found += [at_most(s, far, u, REACH), at_most(s, near, u, 0, strict=True)]
        if dropped == SOME:
            found.append(at_most(s, (s, t, "v"), u, 0, strict=True))
    return found


def cases() -> Iterator[Case]:
    """Yield every kind of trapezoid that there can be; without T-vertices nothing is dropped."""
    for apex, lean in product((0, TOP, BOTTOM), product((-1, 0, 1), repeat=2)):
        leans = dict(zip((LEFT, RIGHT), lean, strict=True))
        for flags in product((False, True), repeat=4):
            vertex = dict(zip(CORNERS, flags, strict=True))
            # An apex is a vertex.
            if apex and not (vertex[LEFT, apex] and vertex[RIGHT, apex]):
                continue
            order = of_order(vertex, apex, leans)
            if possible(order):
                clean = Case(vertex, apex, leans, dict.fromkeys(CORNERS, NOTHING), {TOP: False, BOTTOM: False}, order)
                if all(has_vertex(clean, t) for t in (TOP, BOTTOM)):
                    yield clean
                for some in product((False, True), repeat=2):
                    left = dict(zip((TOP, BOTTOM), some, strict=True))
                    yield from _wedged(Case(vertex, apex, leans, {}, left, order))


def _wedged(case: Case) -> Iterator[Case]:
    if len(case.wedge) == len(CORNERS):
        if all(has_vertex(case, t) for t in (TOP, BOTTOM)):
            yield case
        return
    s, t = CORNERS[len(case.wedge)]
    for dropped in (NOTHING, SOME, CORNER):
        longer = Case(case.vertex, case.apex, case.lean, {**case.wedge, (s, t): dropped}, case.left, case.given)
        added = of_wedge(longer, s, t)
        if added is not None and (not added or possible([*case.given, *added])):
            longer.given = [*case.given, *added]
            yield from _wedged(longer)


def has_vertex(case: Case, t: int) -> bool:
    """Return whether a side has a vertex of Q, a corner or a T-vertex (I5); only those do that come up."""
    return case.vertex[LEFT, t] or case.vertex[RIGHT, t] or case.left[t] or SOME in (
        case.wedge[LEFT, t], case.wedge[RIGHT, t])


def is_off(case: Case, s: int, t: int) -> str:
    """Return why the corner (s, t) that is left is at F or more from the line of the leg on the other side, or ""."""
    if case.kind(s, t) == CROSSING:
        return ""
    other = -s
    if case.wedge[other, t] != NOTHING:
        x, z = case.corner(s, t), case.corner(other, -t)
        return "interior.far" if case.follows(at_most(s, x, z)) else ""
    if case.kind(other, t) == CROSSING:
        return "interior.steeper" if case.is_new(other) else "clean.a1"
    return "clean.a1" if not case.is_new(other) and case.leans(other, t) <= 0 else ""


def is_wide(case: Case, s: int, t: int) -> bool:
    """Return whether the vertex of Q (s, t) that is left keeps w from the T-vertex beside it: unless its original leg
    leans to that side."""
    return case.kind(s, t) == DROPPED or (case.kind(s, t) == VERTEX and case.leans(s, t) > 0)


def leaves(case: Case) -> Iterator[str]:
    """Yield what the steps make of a trapezoid, each with its lemma."""
    for s, t in CORNERS:
        if case.wedge[s, t] != NOTHING:
            assert case.wedge[s, -t] == NOTHING
            yield "wedge: W1, W2, W3"
            # What is dropped last is w from its neighbour: a T-vertex, or a corner whose leg leans away.
            assert case.wedge[s, t] == SOME or case.leans(-s, t) > 0
    ts = [t for t in (TOP, BOTTOM) if case.left[t]]
    if not ts:
        yield of_quad(case)
    elif len(ts) == 1:
        yield of_piece(case, ts[0], (LEFT, RIGHT))
    else:
        # The first run is on either side, and so is the last; between them are runs between cross edges.
        yield from (of_piece(case, t, (s,)) for t in ts for s in (LEFT, RIGHT))
        yield "between cross edges: " + of_clean_side(case, TOP, ())
        yield "one T-vertex between cross edges: C"


def of_quad(case: Case) -> str:
    """Return the lemma for what is left without T-vertices."""
    points = [t for t in (TOP, BOTTOM) if case.is_point(t)]
    if len(points) == 2:
        return "nothing left"
    for t in (TOP, BOTTOM):
        if points == [-t]:
            if is_off(case, LEFT, t) or is_off(case, RIGHT, t):
                return "triangle left: A0"
            assert any(is_cut(case, s, t) for s in (LEFT, RIGHT)), case
            return "triangle left: W4"
    if all(is_off(case, LEFT, t) or is_off(case, RIGHT, t) or is_open(case, t) for t in (TOP, BOTTOM)):
        return "quadrilateral left: A2, A3"
    assert any(is_cut(case, s, t) for s, t in CORNERS), case
    return "quadrilateral left: W4, then R or W4"


def is_open(case: Case, t: int) -> bool:
    """Return whether both legs lean outwards from a side of F or more: then A3, unless a corner is off."""
    return (case.is_outward(LEFT, t) and case.is_outward(RIGHT, t)
            and CROSSING not in (case.kind(LEFT, t), case.kind(RIGHT, t)))


def is_cut(case: Case, s: int, t: int) -> bool:
    """Return whether a diagonal to the end of a new leg is good."""
    y = case.corner(-s, t)
    far = case.corner(s, -t)
    if not (case.wedge[s, t] == SOME and case.kind(-s, t) == VERTEX and is_wide(case, -s, t)
            and case.follows(at_most(s, far, y, REACH))):
        return False
    # The triangle beyond: R with either vertex, or W4 upside down. The leg beyond leans outwards.
    return (case.is_point(-t) or (case.kind(s, -t) == VERTEX and is_off(case, s, -t) == "clean.a1")
            or (case.kind(s, -t) == CROSSING and is_off(case, -s, -t) == "interior.steeper")
            or (case.wedge[-s, -t] == SOME and is_wide(case, s, -t) and case.leans(s, -t) > 0))


def of_piece(case: Case, t: int, legs: tuple[int, ...]) -> str:
    """Return the lemma for a piece with its T-side on side t; `legs` are those of its ends that are no cross edges."""
    assert not any(case.wedge[s, side] == CORNER for s, side in CORNERS if side == -t or s in legs)
    for s in legs:
        # No T-vertex of the piece is farther than the reach before the anchor.
        assert case.follows(at_most(s, case.corner(s, -t), (t, "u"), REACH))
        if case.kind(s, t) == VERTEX and case.is_new(s):
            assert is_wide(case, s, t)
    if len(legs) == 2 and case.apex == -t:
        return "piece under one anchor: fan"
    kind = of_clean_side(case, -t, legs)
    return f"piece with {len(legs)} of the legs: {kind}"


def of_clean_side(case: Case, t: int, legs: tuple[int, ...]) -> str:
    """Return what is known of the width of a clean side on side t: it is w, or F with a condition."""
    corners = [s for s in legs if case.kind(s, t) != DROPPED]
    if len(corners) < 2:
        if all(is_wide(case, s, t) for s in corners):
            return "D >= w"
        # A corner that crosses its edge, or a vertex at the end of a short level edge.
        (s,) = corners
        assert case.kind(s, t) == CROSSING or not case.is_new(s)
        return "D >= w or F off one leg"
    if is_off(case, LEFT, t) or is_off(case, RIGHT, t):
        return "F off one leg"
    assert is_open(case, t), case
    return "both legs outwards"


LEAVES = Counter(leaf for case in cases() for leaf in leaves(case))
assert set(LEAVES) == {
    "wedge: W1, W2, W3", "nothing left", "triangle left: A0", "triangle left: W4", "quadrilateral left: A2, A3",
    "quadrilateral left: W4, then R or W4", "one T-vertex between cross edges: C", "between cross edges: D >= w",
    "piece under one anchor: fan", "piece with 1 of the legs: D >= w",
    "piece with 1 of the legs: D >= w or F off one leg", "piece with 2 of the legs: D >= w",
    "piece with 2 of the legs: D >= w or F off one leg", "piece with 2 of the legs: F off one leg",
    "piece with 2 of the legs: both legs outwards"}, LEAVES

b, r, H, M = variables("b r H M")
g, F, GOOD = LEVEL, SEPARATION, LEVEL * FEATURE / (LEVEL - FEATURE)
STATEMENTS = [
    states("interior.steeper", "b beside the end of a leg that leans outwards by M, then by r: off its line",
           (at_least(b), at_least(H, g), at_least(r), at_least(M, r), at_least(b * b * H * H, F * F * (M * M + H * H))),
           at_least(b * b * H * H, F * F * (r * r + H * H))),
    states("interior.far", "b, not less than the lean r >= 2 H of a leg, beside its end: off its line",
           (at_least(H, g), at_least(r, WEDGE_HEIGHTS * H), at_least(b, r)),
           at_least(b * b * H * H, GOOD * GOOD * (r * r + H * H)), Hint(degrees=(4,))),
]

GROUP = "interior"
NAMES = tuple(statement.id for statement in (*STATEMENTS, *CLEAN, *WEDGES, *PIECES) if statement.true)
ARGUMENT = (
    "A level edge at a T-vertex that is shorter than w leads to a corner whose leg leans to the T-vertex's side: "
    "`repaired.edge-gap` has the argument. "
    "An edge of Q is 0.0688 long or longer where it is level, two vertices on a level are F apart otherwise: so D >= "
    "F. Quadrilaterals left over: with a corner of each side off the leg beyond, A2; if both legs lean outwards from "
    "a side and no corner of it is off, A3; else a diagonal to the far end of a wedge's leg: on one side of it W4, on "
    "the other R, or W4 upside down. What is dropped last is w from its neighbour, as W2 wants. Pieces: "
    + SPLITS + " " + NESTS)
THEOREMS = [Theorem(
    "repaired.interior-feature", "claim", "every face of the Interior keeps f* = g/5", (*NAMES, *GAPS), ARGUMENT,
    f"by program: {sum(1 for _ in cases())} kinds of trapezoid, {sum(LEAVES.values())} faces and pieces of them; a "
    "strip of height g with many T-vertices keeps no more than g/5")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
