"""Prove the trapezoidation and I5 of the repaired construction: its trapezoids are those of the definition, they tile
the inside of Q, and each of their horizontal sides holds a vertex of Q.

Given   Q, disjoint simple rings on levels with the inside on the left (I3). The definition: between neighbouring levels
        with vertices of Q, the edges across, from left to right, bound slabs in pairs; slabs one above the other with
        the same two edges are one trapezoid, unless a vertex of Q is on the closed segment between.
Claim   The sweep makes these; they tile the inside, as slabs do; where one begins or ends there is a vertex.
        order: edges across two levels keep their order between them.
        end: a chord end is inside its edge.
Method  What a level does is told by what is on it, from left to right: edges that pass, and vertices, each with the
        edges that end there from below (0 to 2), that start upwards (0 to 2) and that are level (the rest to 2). Beside
        each the region is inside or outside, above and below; a level edge lies where the two differ. These are the
        paths of an automaton of four states (`STEPS`). `check_levels` draws rings for all stacks of such levels, up to
        the sizes in `STACKS`, 3177 in all, and compares the sweep with the definition.
By hand that longer paths do nothing else (`ARGUMENT`); that floats place edges within their error bounds.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise, product
from typing import NamedTuple

from gmpy2 import mpq
from kit import Theorem, at_least, main, more, states

from exactmesh.geometry.point import Point
from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import LEVEL
from exactmesh.steps.records import Offset, Trapezoidation
from exactmesh.steps.trapezoidation import trapezoidate

a, b, d, e, t, i, j, k = variables("a b d e t i j k")

# Whether the region is inside above and below a place on the level.
State = tuple[bool, bool]
# Levels one above the other, and the most letters on each, of the rings that are compared.
STACKS = ((1, 5), (2, 3), (3, 2))


class Letter(NamedTuple):
    """What is met on a level: how many edges end there, how many start; one that passes does both, without a vertex."""

    ending: int
    starting: int
    passes: bool = False


PASS = Letter(1, 1, passes=True)
VERTICES = tuple(Letter(ending, starting) for ending in range(3) for starting in range(3 - ending))


def step(state: State, letter: Letter) -> State | None:
    """Return the state behind a letter; None where the letter cannot be: a vertex has two edges."""
    above, below = state
    after = above ^ (letter.starting % 2 == 1), below ^ (letter.ending % 2 == 1)
    level = (above != below) + (after[0] != after[1])
    fits = level == 0 if letter.passes else level == 2 - letter.ending - letter.starting
    return after if fits else None


STEPS = {(state, letter): after for state in ((x, y) for x in (False, True) for y in (False, True))
         for letter in (*VERTICES, PASS) if (after := step(state, letter)) is not None}
assert len(STEPS) == 18 and {letter for _, letter in STEPS} == {*VERTICES, PASS}


Word = tuple[Letter, ...]


def paths(most: int, state: State = (False, False)) -> Iterator[Word]:
    """Yield what may be on a level: all words of at most so many letters that end outside."""
    if state == (False, False):
        yield ()
    for (before, letter), after in STEPS.items():
        if before == state and most:
            yield from ((letter, *rest) for rest in paths(most - 1, after))


class Drawn:
    """Rings with given words on the levels from 1 on, closed by level edges below and above; abscissae are found by
    linear programming, as far apart as 1 on every level, and rounded."""

    def __init__(self, words: Sequence[Word]) -> None:
        self.level: list[int] = []
        self.following: dict[int, int] = {}
        self.edges: list[tuple[int, int]] = []
        # On each level, what is met from left to right: a vertex twice, or the two ends of an edge that passes.
        self.met: list[list[list[int]]] = [[] for _ in range(len(words) + 2)]
        # Edges across the levels so far, from left to right, each a list of its lower end and later its upper one.
        across = [[self._vertex(0)] for letter in words[0] for _ in range(letter.ending)]
        for left, right in zip(across[::2], across[1::2], strict=True):
            self.following[left[0]] = right[0]
        for level, word in enumerate(words, 1):
            across = self._passed(level, word, across)
        tops = [self._end(edge, number, self._vertex(len(words) + 1)) for number, edge in enumerate(across)]
        for left_top, right_top in zip(tops[::2], tops[1::2], strict=True):
            self.following[right_top] = left_top

    def _vertex(self, level: int) -> int:
        self.level.append(level)
        self.met[level].append([len(self.level) - 1] * 2)
        return len(self.level) - 1

    def _end(self, edge: list[int], number: int, v: int) -> int:
        """End an edge; the inside is on the left, so a left leg, of even number, runs down."""
        edge.append(v)
        self.following[edge[1 - number % 2]] = edge[number % 2]
        self.edges.append((edge[0], v))
        return v

    def is_straight(self) -> bool:
        """Return whether no two edges have the same ends; then straight edges can be drawn."""
        return len(set(self.edges)) == len(self.edges)

    def _passed(self, level: int, word: Word, across: list[list[int]]) -> list[list[int]]:
        state, last, number = (False, False), -1, 0
        above: list[list[int]] = []
        for letter in word:
            ending = across[number:number + letter.ending]
            if letter.passes:
                self.met[level].append(ending[0])
                above.append(ending[0])
            else:
                v = self._vertex(level)
                for n, edge in enumerate(ending, number):
                    self._end(edge, n, v)
                above += [[v] for _ in range(letter.starting)]
                if state[0] != state[1]:
                    # With the inside above, a level edge runs to the right.
                    self.following[last if state[0] else v] = v if state[0] else last
                last = v
            number += letter.ending
            state = STEPS[state, letter]
        return above

    def _abscissae(self) -> list[mpq]:
        from scipy.optimize import linprog

        rows = []
        for level, row in enumerate(self.met):
            for before, after in pairwise(row):
                weights = [0.0] * len(self.level)
                for sign, (u, v) in ((1, before), (-1, after)):
                    share = (level - self.level[u]) / (self.level[v] - self.level[u]) if u != v else 0.0
                    weights[u] += sign * (1 - share)
                    weights[v] += sign * share
                rows.append(weights)
        return [mpq(round(x * 4096), 4096) for x in linprog([1.0] * len(self.level), rows, [-1.0] * len(rows)).x]

    def rings(self) -> Offset:
        """Return the rings."""
        order: list[int] = []
        rings = []
        left = dict.fromkeys(self.following)
        assert len(set(self.following.values())) == len(left) == len(self.level)
        while left:
            start, v = len(order), next(iter(left))
            while v in left:
                del left[v]
                order.append(v)
                v = self.following[v]
            assert v == order[start]
            rings.append((start, len(order)))
        x = self._abscissae()
        points = tuple(Point(x[v], (self.level[v] + mpq(1, 2)) * LEVEL) for v in order)
        none = (0,) * len(order)
        return Offset(0, tuple(x[v] for v in order), tuple(self.level[v] for v in order), none, none, tuple(rings),
                      points)


# A corner is a vertex of Q, or a place of an edge on a level.
Corner = tuple[int, int]
Shape = tuple[int, int, int, int, tuple[Corner, ...], tuple[int, ...], tuple[int, ...]]


def defined(q: Offset) -> set[Shape]:
    """Return the trapezoids by their definition: levels, edges, corners bl, br, tr, tl, and vertices between them."""
    ends = list(enumerate(q.successors()))
    levels = sorted(set(q.level))

    def x_at(edge: int, level: mpq) -> mpq:
        u, v = ends[edge]
        return q.x[u] + (q.x[v] - q.x[u]) * (level - q.level[u]) / (q.level[v] - q.level[u])

    def corner(edge: int, level: int) -> Corner:
        return next(((v, -1) for v in ends[edge] if q.level[v] == level), (edge, level))

    def on(left: int, right: int, level: int) -> list[int]:
        low, high = x_at(left, level), x_at(right, level)
        touching = (v for v in range(len(q.x)) if q.level[v] == level and low <= q.x[v] <= high)
        return sorted(touching, key=q.x.__getitem__)

    found: set[Shape] = set()
    begun: dict[tuple[int, int], int] = {}
    for low, high in pairwise(levels):
        across = sorted((n for n, (u, v) in enumerate(ends)
                         if min(q.level[u], q.level[v]) <= low and max(q.level[u], q.level[v]) >= high),
                        key=lambda n, low=low, high=high: x_at(n, mpq(low + high) / 2))
        assert len(across) % 2 == 0
        slabs = list(zip(across[::2], across[1::2], strict=True))
        start = {}
        for slab in slabs:
            goes_on = slab in begun and not on(*slab, low)
            start[slab] = begun[slab] if goes_on else low
            assert goes_on or on(*slab, low), "a trapezoid begins at a vertex"
        begun = start
        for left, right in slabs:
            touching = on(left, right, high)
            if touching:
                begin = begun[left, right]
                corners = tuple(corner(edge, level) for edge, level in (
                    (left, begin), (right, begin), (right, high), (left, high)))
                bottom, top = (tuple(v for v in on(left, right, level) if (v, -1) not in corners)
                               for level in (begin, high))
                found.add((begin, high, left, right, corners, bottom, top))
    return found


def swept(q: Offset, made: Trapezoidation) -> set[Shape]:
    """Return what the sweep made, in the same form."""
    level_of = {point.y: level for point, level in zip(q.points, q.level, strict=True)}
    names: dict[int, Corner] = {v: (v, -1) for v in range(len(q.x))}
    for n, (edge, point) in enumerate(zip(made.edge, made.points, strict=True)):
        assert (edge, level_of[point.y]) not in names.values(), "a chord end is made once"
        names[made.first + n] = edge, level_of[point.y]
    return {(z.low, z.high, z.left, z.right, (names[z.bl], names[z.br], names[z.tr], names[z.tl]), z.bottom, z.top)
            for z in made.trapezoids}


def stacks(count: int, letters: int) -> Iterator[tuple[Word, ...]]:
    """Yield what may be on so many levels one above the other, with at most so many letters each."""
    words = [word for word in paths(letters) if any(not letter.passes for letter in word)]
    for stack in product(words, repeat=count):
        if all(sum(letter.starting for letter in low) == sum(letter.ending for letter in high)
               for low, high in pairwise(stack)):
            yield stack


def check_levels(count: int, letters: int) -> int:
    """Return how many stacks were compared, all there are; raises `AssertionError` at a difference."""
    number = 0
    for stack in stacks(count, letters):
        drawn = Drawn(stack)
        if drawn.is_straight():
            q = drawn.rings()
            assert swept(q, trapezoidate(q)) == defined(q), stack
            number += 1
    return number


STATEMENTS = [
    states("sweep.order", "d and e, how far an edge is right of another on two levels, not negative, not both 0",
           (at_least(d), at_least(e), more(d + e), more(t), more(1, t)), more(d + t * (e - d))),
    states("sweep.end", "on a level i strictly between those of its ends, j and k, an edge is between them",
           (more(i, j), more(k, i), more(a), at_least(b, a)), more((k - i) * a + (i - j) * b)),
]

ARGUMENT = (
    "By definition the trapezoids tile the inside. Two edges that pass a level with nothing between are neighbours "
    "below and above, and the inside is between them below if it is above: so where a trapezoid begins or ends, a "
    "vertex is on that side. The sweep makes no others: by induction over the levels it knows the edges just above in "
    "their order, and what is open between each left leg and the edge next to it. At a vertex `before` and `after` are "
    "the edges below next to it; so `touched` has the pairs below with a vertex on the closed segment between, and "
    "lists those inside. `_beside` has the edges above next to it: those of the vertex before it when no edge passes "
    "between. So `begun` and `going_on` have the pairs above with a vertex between: a left leg that passes has its "
    "neighbour above at or beside the first vertex on its right. A vertex alone on its level, with one edge below and "
    "one above, ends what is open beside it and begins it anew. What is done at a vertex depends on what is next to "
    "it, so longer levels do nothing that is not among those compared.")
GROUP = "sweep"
NAMES = tuple(statement.id for statement in STATEMENTS)
THEOREMS = [
    Theorem("repaired.trapezoidation", "claim", "the trapezoids tile the inside of Q", NAMES, ARGUMENT,
            "by program: 3177 stacks of levels", ("repaired.offset-nesting",)),
    Theorem("repaired.chord-touch", "claim", "each horizontal side holds a vertex of Q", NAMES, ARGUMENT,
            "one vertex, attained at every chord with one", ("repaired.offset-nesting",)),
]

if __name__ == "__main__":
    print(*(f"{check_levels(*stack)} stacks compared: {stack}" for stack in STACKS), sep="\n")
    main(GROUP, THEOREMS, STATEMENTS)
