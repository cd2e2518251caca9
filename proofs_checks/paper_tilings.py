"""Prove that Lemma 3's figure and Theorem 2's layers tile their rectangle: `lemma-3.positions`, `lemma-3.boundary`,
`lemma-3.triangulation`, `theorem-2.proper-rectangle`; and `section-1.classic-triangulation`.

Given   Lemma 3: places as in `paper_lemma_3`, x in units of w, y of h; A = (0,1), C = (c,1); nodes E_i = (x_i, 1/3),
        0 < x_i < c, 2 x_i <= x_i+1; vertices on the edge e_i+1 from A to E_i+1 between x_i and x_i+1, the first one,
        top_i, at x_i. A position u is below e_i+1 by v. Layers: rows at heights y and y + d <= 1.
Claim   Every face turns left, and directed sides cancel but for the rectangle's, cut at the occupied positions. So
        the faces tile it: about any point winding numbers, 1 inside a face and 0 outside, add up to the rectangle's.
Method  `lemma_3` and `layers` list the faces of each kind of block of the figure, here alone; `assert_blocks` adds up
        their directed sides for all kinds, that is for nodes with a foot or without, over one gap or several, both
        kinds of teeth, and up to LONGEST teeth; or rows of up to LONGEST vertices. One more tooth or two more vertices
        add faces of the same kind beside these. The sums of neighbouring blocks cancel by what they are asserted to be.
        Faces turn left: one inequality a kind of face.
Tight   no bounds.
By hand that the blocks are those of the programs; the tests compare them for all sets of positions up to 8.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise, product

from gmpy2 import mpq
from kit import Hint, Spot, Statement, Theorem, at_least, cross, equal, main, more, spot, states

from exactmesh.proofs.certificate import Constraint
from exactmesh.proofs.polynomial import variables

x, y, a, b, c, d, v, g, t, s, j, w, X, m = variables("x y a b c d v g t s j w X m")
LOW = mpq(1, 3)
LONGEST = 7
Face = tuple[str, ...]


def sides(cycle: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the directed sides of a face."""
    yield from pairwise((*cycle, cycle[0]))


def boundary(faces: Iterable[Face]) -> Counter[tuple[str, str]]:
    """Return the directed sides that are left when opposite ones cancel; each counts once at most."""
    found = Counter(side for face in faces for side in sides(face))
    left = Counter({side: n - found[side[::-1]] for side, n in found.items() if n > found[side[::-1]]})
    assert all(n == 1 for n in left.values())
    return left


def path(*places: str) -> Counter[tuple[str, str]]:
    """Return the directed sides of a path."""
    return Counter(pairwise(places))


def lemma_3(has_foot: bool, next_foot: bool, teeth: int, retiled: bool, before: Sequence[str]
            ) -> tuple[list[Face], list[str]]:
    """Return the faces between two nodes E and F over different gaps, and the vertices on A F from A on.

    Positions u0 .. are those from the foot of E, or the first one beyond E, to the foot of F, or the last one before
    it; `teeth` is the number of gaps between them. `before` are the vertices on A E.
    """
    faces: list[Face] = [("A", *before, "T")]
    start = 0
    own = has_foot
    apex = {i: f"a{i}" for i in range(teeth)}
    if retiled and has_foot and teeth:
        faces.append(("u0", "u1", "E"))
        start, own = 1, False
        del apex[0]
    elif retiled and not teeth:
        own = False
    if retiled and next_foot and teeth > start:
        apex[teeth - 1] = "F"
    row = [apex[i] for i in range(start, teeth)]
    first, u = (row or ["F"])[0], f"u{start}"
    if own:
        faces.append((u, first, "T", "E"))
    elif row:
        faces += [(u, first, "T"), (u, "T", "E")]
    else:
        faces += [("E", u, "F"), ("E", "F", "T")]
    faces += [(f"u{i}", f"u{i + 1}", apex[i]) for i in range(start, teeth)]
    faces += [(p, f"u{i}", q) for i, (p, q) in enumerate(pairwise(row), start + 1)]
    if row and row[-1] != "F":
        faces.append((row[-1], f"u{teeth}", "F"))
    return faces, ["T", *(p for p in row if p != "F"), "F"]


def gap(nodes: Sequence[str]) -> list[Face]:
    """Return the faces over a gap from p to q below its nodes, which have no foot."""
    return [("p", "q", nodes[-1]), *(("p", f, e) for e, f in pairwise(nodes))]


def layers(count: int) -> list[Face]:
    """Return the faces between a row b0 .. of that many vertices and the row a0 .. above every second one."""
    above = count // 2
    faces: list[Face] = [("A", "b0", "a0"), (f"a{above - 1}", f"b{count - 1}", "C")]
    faces += [(f"b{i}", f"b{i + 1}", f"a{i // 2}") for i in range(2 * above - 1 + count % 2)]
    return faces + [(f"b{2 * i}", f"a{i}", f"a{i - 1}") for i in range(1, above)]


def assert_blocks() -> int:
    """Assert what the directed sides of all blocks add up to; return the number of blocks."""
    seen = 0
    for has_foot, next_foot, teeth, retiled, on_edge in product(
            (False, True), (False, True), range(LONGEST + 1), (False, True), (["E"], ["s", "E"], ["s", "r", "E"])):
        faces, above = lemma_3(has_foot, next_foot, teeth, retiled, on_edge)
        floor = [f"u{i}" for i in range(teeth + 1)]
        assert boundary(faces) == path("A", *on_edge, *floor, *above[::-1], "A")
        seen += 1
    # Over one gap e_i+1 has no vertices but its top.
    for on_edge in (["E"], ["s", "E"], ["s", "r", "E"]):
        assert boundary([("A", *on_edge, "T"), ("E", "F", "T")]) == path("A", *on_edge, "F", "T", "A")
        seen += 1
    for number in range(1, LONGEST + 1):
        nodes = [f"e{i}" for i in range(number)]
        assert boundary(gap(nodes)) == path("p", "q", *nodes[::-1], "p")
        seen += 1
    # The ends: the first node has a foot u1, or none; the last one, over the last inner position, has one.
    assert boundary([("u0", "u1", "E"), ("u0", "E", "A")]) == path("u0", "u1", "E", "A", "u0")
    assert boundary([("u0", "E", "A")]) == path("u0", "E", "A", "u0")
    for on_edge in (["E"], ["s", "E"], ["s", "r", "E"]):
        assert boundary([("A", *on_edge, "C"), ("l", "m", "E"), ("m", "C", "E")]) == path(
            "A", *on_edge, "l", "m", "C", "A")
        seen += 1
    for number in range(2, LONGEST + 1):
        row, above = [f"b{i}" for i in range(number)], [f"a{i}" for i in range(number // 2)]
        faces = layers(number)
        assert boundary(faces) == path("A", *row, "C", *above[::-1], "A")
        assert all(len(face) == 3 for face in faces)
        seen += 1
    return seen + 2


BLOCKS = assert_blocks()


def left(id_: str, says: str, hypotheses: tuple[Constraint, ...], p: Spot, q: Spot, r: Spot, hint: Hint | None = None
         ) -> Statement:
    """Return that p, q, r turn left."""
    return states(f"tilings.{id_}", says, hypotheses, more(cross(q.minus(p), r.minus(p))), hint or Hint(degrees=(2, 3)))


A, ORIGIN = spot(0, 1), spot(0, 0)
E, F = spot(x, LOW), spot(X, LOW)
NODE = (more(x), more(X, x))
BELOW = (more(v), more(d))
TOPS = (more(x), at_least(X, 2 * x), more(y, LOW))
LEMMA_3 = [
    left("first", "(0, foot, E_1), and (u, u', E) for a gap u u' and an apex y > 0 above", (more(g), more(y)),
         ORIGIN, spot(g, 0), spot(x, y)),
    left("corner", "(0, E_1, A)", (more(x),), ORIGIN, E, A),
    left("gap", "(u, F, E), F beyond E, u below", NODE, ORIGIN, F, E),
    left("fan", "(A, E, top), top above E", (more(x), more(y, LOW)), A, E, spot(x, y)),
    states("tilings.top", "top is above E: X times its height is X - 2 x/3 > X/3", (more(x), at_least(X, 2 * x)),
           more(3 * X - 2 * x, X)),
    left("same-gap", "(E, F, top)", (*NODE, more(y, LOW)), E, F, spot(x, y)),
    left("foot", "(foot, first, top) with E on its side: the first apex or F beyond, top above", (more(y), more(d)),
         spot(x, 0), spot(x + d, t), spot(x, y)),
    left("beside", "(u, top, E), u beyond E", (more(d), more(y, LOW)), spot(x + d, 0), spot(x, y), E),
    left("beside-low", "(E, u, F), u anywhere on the side", (more(X, x),), E, spot(x + d, 0), F),
    left("below", "u below e_i+1 by v, with one of its points and another one d before it: (u, q, p)", BELOW,
         spot(b, -v + s * b), spot(a, s * a), spot(a - d, s * (a - d))),
    states("tilings.on-edge", "e_i+1 is at most at 1 and at least at 1/3: positions are below it, vertices inside",
           (more(x), at_least(X, x), equal(3 * X * y, 3 * X - 2 * x)), at_least(y, LOW), Hint(degrees=(2, 3))),
    states("tilings.on-edge-inside", "and below 1", (more(x), at_least(X, x), equal(3 * X * y, 3 * X - 2 * x)),
           more(1, y), Hint(degrees=(2, 3))),
    left("last", "(L, c, E_L)", (more(c, x),), spot(x, 0), spot(c, 0), E),
    left("last-side", "(c, C, E_L)", (more(c, x),), spot(c, 0), spot(c, 1), E),
    left("upper", "(A, E_L, C)", (more(c),), A, E, spot(c, 1)),
]
ROWS = (more(d), at_least(1, y + d), more(a), more(b, a))
LAYERED = [
    left("row-left", "(A, b_0, a_0), a_0 above the next vertex", ROWS, A, spot(a, y), spot(b, y + d)),
    left("row-right", "(a, b, C), b below a or after it", (more(d), at_least(1, y + d), at_least(a, b), more(c, a)),
         spot(b, y + d), spot(a, y), spot(c, 1)),
    left("row-low", "(b, b', a)", (more(g), more(d)), spot(a, y), spot(a + g, y), spot(x, y + d)),
    left("row-high", "(b, a', a)", (more(g), more(d)), spot(x, y), spot(a + g, y + d), spot(a, y + d)),
    left("row-ends", "(0, u_1, A)", (more(g),), ORIGIN, spot(g, 0), A),
    left("row-ends-right", "(u_m-1, c, C)", (more(g),), spot(c - g, 0), spot(c, 0), spot(c, 1)),
    left("row-upper", "(A, a, C)", (more(c), more(1, y)), A, spot(x, y), spot(c, 1)),
]
POSITIONS = [
    *(states(f"tilings.position-{name}", "on an edge that rises m levels, the point on level j is j w from its end, "
             "m w the edge's length", (more(m), equal(m * m * w * w, X * X + m * m * g * g), equal(m * x, j * X)),
             conclusion, Hint(degrees=(4, 5, 6)))
      for name, conclusion in (("least", at_least(m * m * (x * x + j * j * g * g), j * j * m * m * w * w)),
                               ("most", at_least(j * j * m * m * w * w, m * m * (x * x + j * j * g * g))))),
]
CLASSIC = [
    states("tilings.highest", "an edge whose ends are no higher than y has no point above y",
           (at_least(t), at_least(1, t), at_least(y, a), at_least(y, b)), at_least(y, (1 - t) * a + t * b),
           Hint(degrees=(2,))),
]
STATEMENTS = [*LEMMA_3, *LAYERED, *POSITIONS, *CLASSIC]


def names(*parts: list[Statement]) -> tuple[str, ...]:
    """Return the ids of some of the statements."""
    return tuple(statement.id for part in parts for statement in part)


GROUP = "paper-tilings"
THEOREMS = [
    Theorem("lemma-3.positions", "claim", "vertices on the top of a rectangle are at multiples of w from its end",
            names(POSITIONS), "They are on levels and on one edge of P4, not a level one, as chords end on none."),
    Theorem("lemma-3.boundary", "claim", "all new vertices are inside the rectangle", names(LEMMA_3[10:12]),
            "New vertices are nodes, at 1/3 and 1 <= x_i <= L < c, and vertices on anchored edges, 0 < x <= x_i."),
    Theorem("lemma-3.triangulation", "claim", "the faces tile the rectangle", names(LEMMA_3),
            "Sides of blocks cancel, as the script asserts, and faces turn left; vertices on e_i are in order because "
            "their abscissae are. Faces have no vertices on their sides but those listed: the figure's faces are the "
            "blocks between the left side, nodes in their order, gaps with nodes that have no foot, and the right "
            "side."),
    Theorem("theorem-2.proper-rectangle", "claim", "the faces tile the rectangle, three vertices each", names(LAYERED),
            "Sides of strips cancel, as the script asserts, and faces turn left. The rows begin with the inner "
            "vertices of the side; the faces at its ends and above the last row close the rectangle."),
    Theorem("section-1.classic-triangulation", "claim", "every polygon is cut into triangles by chords", names(CLASSIC),
            "At a convex corner v with the neighbours p, q: if no vertex but these is in the triangle p v q, p q is a "
            "chord or an edge. Else let z be one that is highest over p q: an edge across v z would be higher there, "
            "so an end of it would be higher than z, and in the triangle, as edges do not cross p v and v q. So v z is "
            "a chord. A chord cuts the polygon in two, or joins a hole to what is around it: after finitely many, "
            "triangles are left."),
]

if __name__ == "__main__":
    print(f"{BLOCKS} kinds of blocks add up")
    main(GROUP, THEOREMS, STATEMENTS)
