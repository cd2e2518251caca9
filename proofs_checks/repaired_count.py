"""Prove `repaired.steiner-count`: at most 35 new vertices a corner in a nonproper mesh, 51 in a proper one.

Given   `repaired.trapezoidation`, `repaired.chord-gap`, `repaired.caps-whole`, A1-A3 of `repaired_clean`, W2 of
        `repaired_wedges`. New vertices are those of Q, chord ends, feet of wedges, and those in quadrilaterals: at most
        one in a clean one, and in a one-sided one at most as many as it has gaps, or L(N) <= 20/9 N of N gaps in a
        proper mesh, L(N) = N + L(ceil(N/2)), L(1) = 1.
Claim   With u = 1, or 20/9 in a proper mesh, for what a gap may bring, a chord end or foot costs 1 + u: itself and one
        more gap of an edge of Q. Costs are charged thus, `charges` being the most there can be at a corner:
        vertex     1.
        direction  1 + u for each side of a vertex, left or right, where the inside is above and below: for the chord
                   end there, or for half of the two vertices in clean trapezoids above and below the chord.
        T-vertex   1 + u: for its foot, or its gap.
        T-group    1, or u - 1 if that is more, for what is left of a trapezoid with T-vertices, or its last gap.
        flat       1 for a clean trapezoid on a level edge of a cap.
        e'         u + 1 + (1 + u): its first gap; a clean trapezoid or part of a wedge that it bounds, when level; the
                   foot of one of its ends.
Method  the charges of a vertex by the letters of `repaired_sweep`, of a corner by the run of K1 it has; `check_pieces`
        counts the pieces of all small trapezoids, `check_candidates` the new vertices of all candidates.
Tight   34 for an isolated vertex, 50.6 for a cap of five vertices; 15.3 is the most that was seen.
By hand the list of charges (`CHARGES`).
"""

from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, main, more, states
from repaired_clean import STATEMENTS as CLEAN
from repaired_sweep import STEPS, Letter, State
from repaired_tilings import check_candidates, rooms
from repaired_wedges import W2

from exactmesh.geometry.point import Point
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import LEVEL, PROPER_VERTICES_PER_CORNER, VERTICES_PER_CORNER, WEDGE_HEIGHTS
from exactmesh.steps.interior import _triangulate
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Trapezoid
from exactmesh.steps.wedges import Leftover

c, d, h, k, n, r, H, L, M = variables("c d h k n r H L M")
# What a gap may bring, by `proper`.
UNIT = {False: mpq(1), True: mpq(20, 9)}
PLACES = 6
GAPS_TRIED = 5
# Vertices of K1 clockwise, by the number of their level: from an upper left one around.
LEVEL_OF = (1, 1, 0, -1, -2, -2, -1, 0)
INSIDE = (True, True)


def at_vertex(state: State, letter: Letter) -> tuple[int, int]:
    """Return the number of directions and of T-vertices at a vertex."""
    after = STEPS[state, letter]
    return ((state == INSIDE) + (after == INSIDE),
            (letter.ending == 0 and state[1] and after[1]) + (letter.starting == 0 and state[0] and after[0]))


LETTERS = {(letter, at_vertex(state, letter)) for state, letter in STEPS if not letter.passes}
assert all(t <= 1 for _, (_, t) in LETTERS), "a vertex is a T-vertex of one side"


class Counted(NamedTuple):
    """Directions, T-vertices, groups of T-vertices in one trapezoid, and level edges of a cap without T-vertices."""

    directions: int
    t_vertices: int
    groups: int
    flats: int


def at_run(levels: tuple[int, ...], closed: bool) -> set[Counted]:
    """Return what there can be at a run of vertices of K1.

    Before the first and after the last there are edges e' that go anywhere, unless the run is closed.
    """
    size = len(levels)
    choices = []
    for i, level in enumerate(levels):
        beside = [levels[j % size] for j in (i - 1, i + 1) if closed or 0 <= j < size]
        up, down = (sum((other - level) * way > 0 for other in beside) for way in (1, -1))
        choices.append({found for letter, found in LETTERS if up <= letter.starting and down <= letter.ending
                        and len(beside) - up - down <= 2 - letter.starting - letter.ending})
    level_edges = [(i, (i + 1) % size) for i in range(size if closed else size - 1)
                   if levels[i] == levels[(i + 1) % size]]
    seen = set()
    for found in product(*choices):
        ts = [t for _, t in found]
        seen.add(Counted(sum(of for of, _ in found), sum(ts), sum(ts) - sum(ts[i] and ts[j] for i, j in level_edges),
                         sum(not ts[i] and not ts[j] for i, j in level_edges)))
    return seen


def charges(proper: bool) -> dict[int, mpq]:
    """Return the greatest charge of a corner by the number of its vertices; eight are those of an isolated vertex."""
    u = UNIT[proper]
    at_edge = u + 1 + (1 + u)
    return {size: max(size + (1 + u) * (at.directions + at.t_vertices) + max(1, u - 1) * at.groups + at.flats
                      + (at_edge if size < 8 else 0)
                      for start in range(8)
                      for at in at_run(tuple(LEVEL_OF[(start + i) % 8] for i in range(size)), size == 8))
            for size in (1, 2, 3, 4, 5, 8)}


class _Counting(PatchBuilder):
    """Counts gaps of one-sided pieces, and clean quadrilaterals of four corners and others."""

    gaps = quads = degenerate = 0

    def add_one_sided(self, t_side: Sequence[int], a: int, b: int) -> None:
        """Count the gaps; a fan of one anchor has no new vertex."""
        if a != b:
            self.gaps += len(t_side) - 1

    def add_quad(self, corners: Sequence[int]) -> None:
        """Count the quadrilateral."""
        if len({self.points[v] for v in corners}) == 4:
            self.quads += 1
        else:
            self.degenerate += 1


def check_pieces(places: int) -> int:
    """Return for how many trapezoids with T-vertices pieces were counted; raises `AssertionError` for too many."""
    unit = WEDGE_HEIGHTS * LEVEL * 2 / 3
    count = 0
    for room in rooms(places):
        t_vertices = len(room.top[1:-1]) + len(room.bottom[1:-1])
        if not t_vertices:
            continue
        # Vertices of Q first; corners that are none have numbers from `first` on.
        at = [(place, side) for side, row in ((1, room.top), (0, room.bottom)) for place in dict.fromkeys(row)]
        corners = dict(zip(("tl", "tr", "bl", "br"), ((room.top[0], 1), (room.top[-1], 1), (room.bottom[0], 0),
                                                      (room.bottom[-1], 0)), strict=True))
        others = {corners[name] for name, of_q in zip(corners, room.of_q, strict=True) if not of_q}
        order = [v for v in at if v not in others] + [v for v in at if v in others]
        number = {v: i for i, v in enumerate(order)}
        mesh = _Counting([Point(place * unit, side * LEVEL) for place, side in order])
        z = Trapezoid(0, 1, 0, 1, **{name: number[v] for name, v in corners.items()},
                      bottom=tuple(number[place, 0] for place in room.bottom[1:-1]),
                      top=tuple(number[place, 1] for place in room.top[1:-1]))
        leftover = Leftover(mesh, range(len(order) - len(others)), z)
        _triangulate(leftover)
        wedges = len({edge for edge, _ in mesh.on_edge})
        rest = sum(map(len, leftover.side.values()))
        corner_feet = len(mesh.on_edge) - (t_vertices - rest)
        assert 0 <= corner_feet <= wedges <= 2
        clean = mesh.quads - (len(mesh.on_edge) - wedges)
        if rest:
            assert not corner_feet and not clean and mesh.gaps <= rest + 1, room
        else:
            assert mesh.gaps == 0 and clean <= (0 if corner_feet else 1), room
        count += 1
    return count


def layers_of(gaps: int) -> int:
    """Return the number of new vertices in rows over that many gaps."""
    return gaps + layers_of((gaps + 1) // 2) if gaps > 1 else 1


def check_new_vertices(gaps: int) -> int:
    """Return how many kinds of candidates there are; raises `AssertionError` for one with too many new vertices."""
    seen = check_candidates(gaps)
    assert all(new <= (layers_of(number) if proper else number) for proper, number, new in seen)
    return len(seen)


assert all(max(charges(proper).values()) <= most for proper, most in (
    (False, VERTICES_PER_CORNER), (True, PROPER_VERTICES_PER_CORNER)))
assert all(layers_of(gaps) <= UNIT[True] * gaps for gaps in range(1, 10))

STATEMENTS = [
    states("count.layers", "h = ceil(n/2) gaps bring 20/9 h at most: n >= 10 bring n + 20/9 h <= 20/9 n",
           (at_least(n, 10), at_least(n + 1, 2 * h), at_least(h * 20, 9 * (L - n))), at_least(20 * n, 9 * L)),
    *(states(f"count.trapezoid-{name}", "d feet of T-vertices, r >= 1 others with r + 1 gaps: not above the charges",
             (at_least(d), at_least(r, 1)), at_least((1 + u) * (d + r) + max(mpq(1), u - 1), (1 + u) * d + u * (r + 1)))
      for name, u in (("nonproper", UNIT[False]), ("proper", UNIT[True]))),
    states("count.foot", "c before the lower end M of a leg: its foot is on the leg", (more(c), more(M, c), more(H)),
           more(M * M + H * H, c * M), Hint(degrees=(2,))),
    states("count.end", "a right leg from n to h, left corners c and k beside: it does not lean far out both ways",
           (more(r), at_least(h, k), at_least(n, c), more(k - r, n), more(c - r, h)), None),
]
CHARGES = (
    "A chord end is the corner of a trapezoid; on that side, the next vertex of Q has it in one of its directions. "
    "A clean trapezoid has a new vertex only if a side has no good vertex (`clean`), so that both its corners are of "
    "Q: on a chord, then in a direction of each, where no chord end is; on a level e'; or on a level edge of a cap. "
    "A trapezoid with T-vertices: a vertex of Q is a T-vertex of one at most. Those that are not dropped, r, leave "
    "r + 2 gaps, of which the clean side of a piece is one, so that T-sides have r + 1; if none is left, one "
    "quadrilateral, or none if a corner was dropped. A quadrilateral of a wedge has no new vertex (W2), as its "
    "vertices are 0.15 apart, unless a level e' joins them. A corner is dropped at the end of a leg that leans far, "
    "so on an e'; an e' leans one way (`end`), so at one end. The Tube has the gaps of each e', one and one more for "
    "each chord end and foot; none are on caps. A corner has an e', but for isolated vertices.")
GROUP = "count"
NAMES = tuple(statement.id for statement in STATEMENTS)
RESTS_ON = ("repaired.trapezoidation", "repaired.caps-whole", "repaired.chord-gap", "repaired.chord-leg",
            "repaired.chord-clearance", "repaired.offset-separation")
THEOREMS = [
    Theorem("repaired.steiner-count", "claim", "35 new vertices a corner, 51 in a proper mesh",
            (*NAMES, *(statement.id for statement in (*CLEAN, *W2))), CHARGES,
            "34 is the greatest charge, of an isolated vertex; 50.6 in a proper mesh, of five vertices", RESTS_ON),
    Theorem("section-1.linear-size", "corrected", "the repaired construction has O(n) Steiner points and triangles",
            NAMES, "By `repaired.steiner-count`; a plane graph has fewer than twice as many triangles as vertices.",
            "35 Steiner points a corner", ("repaired.steiner-count",)),
]

if __name__ == "__main__":
    print(f"{check_pieces(PLACES)} trapezoids, {check_new_vertices(GAPS_TRIED)} kinds of candidates")
    print({size: [str(charges(proper)[size]) for proper in (False, True)] for size in charges(False)})
    main(GROUP, THEOREMS, STATEMENTS)
