"""A second road to the exact value of a claim: from its definition, with rational numbers and all pairs.

Nothing of the product is imported: what comes in are the input and, as plain numbers, what the steps have written down
(`Made`). What a step *decides* (the paper's P4, the octagon's Q, faces) is taken from there; distances, feature sizes,
the offset curve, the trapezoidation P5 and counts are computed here anew. Values with square roots are enclosed in
intervals of rationals: `math.isqrt` bounds a root from both sides, so an enclosure is rigorous and about 2^-190 wide.

Slow and plain on purpose: for the small figures that shrinking leaves over.
"""

import ast
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import isqrt

Place = tuple[Fraction, Fraction]
Edge = tuple[int, int]
_BITS = 200


@dataclass(frozen=True, slots=True)
class Between:
    """A number known to lie between two rationals."""

    low: Fraction
    high: Fraction

    def __add__(self, other: "Between") -> "Between":
        return Between(self.low + other.low, self.high + other.high)

    def __sub__(self, other: "Between") -> "Between":
        return Between(self.low - other.high, self.high - other.low)

    def __mul__(self, other: "Between") -> "Between":
        products = [a * b for a in (self.low, self.high) for b in (other.low, other.high)]
        return _rounded(min(products), max(products))

    def __truediv__(self, other: "Between") -> "Between":
        if other.low <= 0 <= other.high:
            raise ZeroDivisionError("the divisor may be zero")
        quotients = [a / b for a in (self.low, self.high) for b in (other.low, other.high)]
        return _rounded(min(quotients), max(quotients))

    def root(self) -> "Between":
        """Return the square root of a number that is not negative."""
        return Between(_root(max(self.low, Fraction(0)))[0], _root(max(self.high, Fraction(0)))[1])

    @property
    def middle(self) -> Fraction:
        """The rational in the middle."""
        return (self.low + self.high) / 2


Value = Fraction | Between


@dataclass(frozen=True, slots=True)
class Made:
    """An input and what a construction wrote down of it, in the input's units but for `q`.

    `corners` are those of a simple polygon, empty for any other input. `p4` and `p4_corner` have the vertices of P4
    with the corner each belongs to, `spacing` is that of its grid. `q` are the vertices of Q in units of `unit`,
    `q_next` the vertex that follows each, `q_source` the ends of the edge of P that each edge of Q belongs to, or None.
    `interior` and `tube` are faces as lists of their vertices' places, in units of `unit`. `mesh` and `mesh_edges` are
    vertices and edges of the mesh as read from its file, `corner_count` the number of corners of the input's faces.
    """

    points: Sequence[Place]
    edges: Sequence[Edge]
    corners: Sequence[Place] = ()
    p4: Sequence[Place] = ()
    p4_corner: Sequence[int] = ()
    spacing: Fraction = Fraction(0)
    unit: Fraction = Fraction(1)
    q: Sequence[Place] = ()
    q_next: Sequence[int] = ()
    q_source: Sequence[tuple[Place, Place] | None] = ()
    interior: Sequence[Sequence[Place]] = ()
    tube: Sequence[Sequence[Place]] = ()
    mesh: Sequence[Place] = ()
    mesh_edges: Sequence[Edge] = field(default=())
    corner_count: int = 0

    @property
    def mfs_squared(self) -> Fraction:
        """The squared mfs of the input, from its definition."""
        return mfs_squared(self.points, self.edges)


def second_value(claim: str, made: Made) -> Value | None:
    """Return the worst value of a claim on an input; None when there is no second road to it.

    Raises `ValueError` when what a step wrote down is not what it has to be.
    """
    road = _ROADS.get(_name(claim))
    return None if road is None else road(made)


def has_road(claim: str) -> bool:
    """Return whether there is a second road to the claim's value."""
    return _name(claim) in _ROADS


def _name(claim: str) -> str:
    """Return the claim of the repaired construction that one of the coarse construction is a copy of."""
    return claim.replace("coarse.", "repaired.", 1) if claim.startswith("coarse.") else claim


def agree(value: Value, text: str) -> bool:
    """Return whether a value is the one written as an exact expression: equal, or equal within their enclosures, which
    are less than 10^-30 wide relative to the value or to 1."""
    stated = evaluate(text)
    if isinstance(value, Fraction) and stated.low == stated.high:
        return value == stated.low
    mine = _between(value)
    narrow = Fraction(1, 10**30) * max(Fraction(1), abs(mine.middle))
    meet = mine.low <= stated.high and stated.low <= mine.high
    return meet and mine.high - mine.low < narrow and stated.high - stated.low < narrow


def evaluate(text: str) -> Between:
    """Return an enclosure of an expression of integers, + - * / and sqrt( ); raises `ValueError` for anything else."""
    return _evaluate(ast.parse(text, mode="eval").body)


def _evaluate(node: ast.expr) -> Between:
    if isinstance(node, ast.Constant) and isinstance(node.value, int):
        return _between(Fraction(node.value))
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return _between(Fraction(0)) - _evaluate(node.operand)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "sqrt":
        return _evaluate(node.args[0]).root()
    if isinstance(node, ast.BinOp):
        a, b = _evaluate(node.left), _evaluate(node.right)
        if isinstance(node.op, ast.Add):
            return a + b
        if isinstance(node.op, ast.Sub):
            return a - b
        if isinstance(node.op, ast.Mult):
            return a * b
        if isinstance(node.op, ast.Div):
            return a / b
    raise ValueError(f"not an exact expression: {ast.unparse(node)}")


# --- distances ---


def mfs_squared(points: Sequence[Place], edges: Sequence[Edge]) -> Fraction:
    """Return the least squared distance of a vertex from another vertex, or from an edge without it: all with all.

    A place is a triple of integers (X, Y, W) for (X/W, Y/W), and a square one of two integers, over and under: sums of
    `Fraction` would spend their time on common divisors.
    """
    at = [_triple(p) for p in points]
    squares = [_square_between(at[u], at[v]) for u in range(len(at)) for v in range(u)]
    if not squares:
        raise ValueError("there is one vertex only")
    for u, v in edges:
        a, b = at[u], at[v]
        x, y = _step(a, b)
        length = x * x + y * y
        for w, p in enumerate(at):
            (px, py), (qx, qy) = _step(a, p), _step(b, p)
            # Otherwise the nearest place is an end, and that distance is among those above.
            if w not in (u, v) and x * px + y * py > 0 > x * qx + y * qy:
                squares.append(((x * py - y * px) ** 2, length * (a[2] * p[2]) ** 2))
    over, under = squares[0]
    for square, unit in squares:
        if square * under < over * unit:
            over, under = square, unit
    return Fraction(over, under)


def _triple(p: Place) -> tuple[int, int, int]:
    (x, y) = p
    return x.numerator * y.denominator, y.numerator * x.denominator, x.denominator * y.denominator


def _step(a: tuple[int, int, int], b: tuple[int, int, int]) -> tuple[int, int]:
    """Return the vector from a to b, times the product of their last numbers."""
    return b[0] * a[2] - a[0] * b[2], b[1] * a[2] - a[1] * b[2]


def _square_between(a: tuple[int, int, int], b: tuple[int, int, int]) -> tuple[int, int]:
    x, y = _step(a, b)
    return x * x + y * y, (a[2] * b[2]) ** 2


def from_segment(p: Place, a: Place, b: Place) -> Fraction:
    """Return the squared distance of a place from a segment."""
    (px, py), (ax, ay), (bx, by) = p, a, b
    x, y = bx - ax, by - ay
    t = min(Fraction(1), max(Fraction(0), (x * (px - ax) + y * (py - ay)) / (x * x + y * y)))
    return (px - ax - t * x) ** 2 + (py - ay - t * y) ** 2


def _squared(p: Place, q: Place) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def _cycle(count: int) -> list[Edge]:
    return [(i, (i + 1) % count) for i in range(count)]


def _face_feature(faces: Sequence[Sequence[Place]]) -> Fraction:
    """Return the least squared distance within a face: of each vertex on it from each side without it."""
    return min(mfs_squared(face, _cycle(len(face))) if _is_triangle(face) else Fraction(0) for face in faces)


def _is_triangle(face: Sequence[Place]) -> bool:
    turns = [_cross(face[i - 2], face[i - 1], p) for i, p in enumerate(face)]
    return min(turns) >= 0 and sum(turn > 0 for turn in turns) == 3


def _cross(a: Place, b: Place, c: Place) -> Fraction:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


# --- the paper's offset curve, from angles ---


@dataclass(frozen=True, slots=True)
class _Side:
    """An edge of the polygon: its squared length, whether each end is reflex, convex and acute, and its segment of P2,
    in units of the mfs, negative when it runs against the edge."""

    squared: Fraction
    reflex: tuple[bool, bool]
    acute: tuple[bool, bool]
    offset: Between


def _sides(made: Made) -> list[_Side]:
    """Return the edges with their segments of P2: at a corner below 180 degrees the segment loses (mfs/4) cot(w/2),
    where cot(w/2) = (|u||v| + u.v)/(u x v) for the edges u, v that leave the corner; at any other, nothing."""
    corners = _counter_clockwise(made.corners)
    unit = _between(made.mfs_squared).root()
    quarter = _between(Fraction(1, 4))
    count = len(corners)
    losses, reflex, acute = [], [], []
    for i, p in enumerate(corners):
        (ux, uy), (vx, vy) = _vector(p, corners[(i + 1) % count]), _vector(p, corners[i - 1])
        area, along = ux * vy - uy * vx, ux * vx + uy * vy
        reflex.append(area < 0)
        acute.append(area > 0 and along > 0)
        lengths = _between((ux * ux + uy * uy) * (vx * vx + vy * vy)).root()
        losses.append(quarter * (lengths + _between(along)) / _between(area) if area > 0 else _between(Fraction(0)))
    sides = []
    for i, p in enumerate(corners):
        j = (i + 1) % count
        squared = _squared(p, corners[j])
        offset = _between(squared).root() / unit - losses[i] - losses[j]
        sides.append(_Side(squared, (reflex[i], reflex[j]), (acute[i], acute[j]), offset))
    return sides


def _shortest(keep: Callable[[_Side], bool]) -> Callable[[Made], Value | None]:
    """Return a road to the least squared segment of P2 over some edges; one that runs backwards counts as negative."""
    def road(made: Made) -> Value | None:
        lengths = [side.offset for side in _sides(made) if keep(side)]
        if not lengths:
            return None
        least = Between(min(length.low for length in lengths), min(length.high for length in lengths))
        if least.low < 0 < least.high:
            raise ValueError("the sign of the shortest segment is not decided")
        squared = least * least
        return squared if least.low >= 0 else _between(Fraction(0)) - squared

    return road


def _counter_clockwise(corners: Sequence[Place]) -> list[Place]:
    area = sum((p[0] * q[1] - p[1] * q[0] for p, q in pairwise([*corners, corners[0]])), Fraction(0))
    return list(corners) if area > 0 else list(corners)[::-1]


def _vector(p: Place, q: Place) -> Place:
    return q[0] - p[0], q[1] - p[1]


# --- the paper's P4 and P5 ---


def _checked_p4(made: Made) -> Sequence[Place]:
    """Return P4 after a look at what snapping has to do: y on the grid and the nearest line, x kept within mfs/2^17."""
    p3 = _refined(made)
    if len(p3) != len(made.p4):
        raise ValueError(f"P4 has {len(made.p4)} vertices, P3 has {len(p3)}")
    tiny = _between(made.mfs_squared).root().high / 2**17
    for (x, y), (mine_x, mine_y) in zip(made.p4, p3, strict=True):
        if (y / made.spacing).denominator != 1:
            raise ValueError(f"a vertex of P4 at {x}, {y} is on no line of the grid")
        if abs(y - mine_y.middle) > made.spacing / 2 + (mine_y.high - mine_y.low):
            raise ValueError(f"a vertex of P4 at {x}, {y} is not on the line nearest to its vertex of P3")
        if abs(x - mine_x.middle) > tiny + (mine_x.high - mine_x.low):
            raise ValueError(f"a vertex of P4 at {x}, {y} has moved sideways")
    return made.p4


def _refined(made: Made) -> list[tuple[Between, Between]]:
    """Return P3, corner by corner: one vertex where the offset lines meet, or three where P4 has three, at the ends and
    in the middle of the arc about a reflex corner."""
    corners = list(made.corners)
    radius = _between(made.mfs_squared / 16).root()
    found = []
    for corner in dict.fromkeys(made.p4_corner):
        vertices = made.p4_corner.count(corner)
        p = corners[corner]
        normals = []
        for a, b in ((corners[corner - 1], p), (p, corners[(corner + 1) % len(corners)])):
            x, y = _vector(a, b)
            length = _between(x * x + y * y).root()
            normals.append((_between(-y) / length, _between(x) / length))
        (ax, ay), (bx, by) = normals
        sx, sy = ax + bx, ay + by
        cosine = ax * bx + ay * by
        one = _between(Fraction(1))
        if vertices == 1:
            steps = [(sx / (one + cosine), sy / (one + cosine))]
        else:
            long = (one + one + cosine + cosine).root()
            steps = [normals[0], (sx / long, sy / long), normals[1]]
        found += [(_between(p[0]) + radius * x, _between(p[1]) + radius * y) for x, y in steps]
    return found


def _p4_mfs(made: Made) -> Fraction:
    return mfs_squared(_checked_p4(made), _cycle(len(made.p4)))


def _both_mfs(made: Made) -> Fraction:
    """Return the squared mfs of P and P4 together, over that of P."""
    count = len(made.points)
    edges = [*made.edges, *((u + count, v + count) for u, v in _cycle(len(made.p4)))]
    return mfs_squared([*made.points, *_checked_p4(made)], edges) / made.mfs_squared


def _between_p_and_p4(made: Made) -> Fraction:
    """Return the squared distance between P and P4, over the squared mfs of P."""
    p4 = _checked_p4(made)
    squares = [from_segment(p, *_ends(made.points, e)) for p in p4 for e in made.edges]
    squares += [from_segment(p, *_ends(p4, e)) for p in made.points for e in _cycle(len(p4))]
    return min(squares) / made.mfs_squared


def _p5_mfs(made: Made) -> Fraction:
    """Return the squared mfs of P5: from each vertex of P4 the horizontal lines into P4 are drawn as far as it goes."""
    p4 = _counter_clockwise(_checked_p4(made))
    edges = _cycle(len(p4))
    cuts: dict[Edge, set[Place]] = {e: set(_ends(p4, e)) for e in edges}
    chords: set[tuple[Place, Place]] = set()
    for v, p in enumerate(p4):
        for way in (-1, 1):
            if not _enters(p4, v, way):
                continue
            met = [(way * (x - p[0]), (x, p[1]), e) for e in edges for x in _at_height(_ends(p4, e), p[1])
                   if way * (x - p[0]) > 0]
            least = min(distance for distance, _, _ in met)
            for distance, place, e in met:
                if distance == least:
                    cuts[e].add(place)
                    chords.add((min(p, place), max(p, place)))
    pieces = set(chords)
    for e, places in cuts.items():
        a, b = _ends(p4, e)
        chain = sorted(places, key=lambda q: (q[0] - a[0]) * (b[0] - a[0]) + (q[1] - a[1]) * (b[1] - a[1]))
        pieces |= {(min(piece), max(piece)) for piece in pairwise(chain)}
    number = {place: i for i, place in enumerate(sorted({place for piece in pieces for place in piece}))}
    return mfs_squared(list(number), [(number[a], number[b]) for a, b in pieces])


def _enters(ring: Sequence[Place], v: int, way: int) -> bool:
    """Return whether the horizontal line from a corner runs strictly inside the polygon, which is counter-clockwise."""
    p = ring[v]
    (ox, oy), (ix, iy) = _vector(p, ring[(v + 1) % len(ring)]), _vector(p, ring[v - 1])
    after_out, before_in = ox * 0 - oy * way > 0, way * iy - 0 * ix > 0
    area = ox * iy - oy * ix
    if area > 0:
        return after_out and before_in
    if area == 0 and ox * ix + oy * iy < 0:
        return after_out
    return after_out or before_in


def _at_height(segment: tuple[Place, Place], height: Fraction) -> list[Fraction]:
    """Return the abscissae at which a segment meets a horizontal line; its ends if it is on the line."""
    (ax, ay), (bx, by) = segment
    if ay == by:
        return [ax, bx] if ay == height else []
    t = (height - ay) / (by - ay)
    return [ax + t * (bx - ax)] if 0 <= t <= 1 else []


def _ends(points: Sequence[Place], edge: Edge) -> tuple[Place, Place]:
    return points[edge[0]], points[edge[1]]


# --- the repaired construction's Q ---


def _thickness(made: Made) -> list[Fraction]:
    """Return the squared distances of the ends of edges of Q from the lines of their edges, in units of `unit`, those
    on the wrong side negative."""
    found = []
    for k, source in enumerate(made.q_source):
        if source is not None:
            a, b = source
            for end in (made.q[k], made.q[made.q_next[k]]):
                area = _cross(a, b, end)
                found.append(area * abs(area) / _squared(a, b))
    return found


# --- intervals ---


def _between(value: Value) -> Between:
    return value if isinstance(value, Between) else Between(value, value)


def _rounded(low: Fraction, high: Fraction) -> Between:
    """Return an enclosure with denominators of `_BITS` bits more than the number has before the point, unless exact."""
    if low == high:
        return Between(low, high)
    scale = 1 << _BITS + max(0, -_magnitude(low), -_magnitude(high))
    return Between(Fraction((low * scale).__floor__(), scale), Fraction((high * scale).__ceil__(), scale))


def _magnitude(value: Fraction) -> int:
    return value.numerator.bit_length() - value.denominator.bit_length() if value else 0


def _root(value: Fraction) -> tuple[Fraction, Fraction]:
    """Return rationals around a square root, equal when it is rational."""
    p, q = value.numerator, value.denominator
    low, bottom = isqrt(p), isqrt(q)
    if low * low == p and bottom * bottom == q:
        return Fraction(low, bottom), Fraction(low, bottom)
    scale = 1 << 2 * (_BITS + max(0, -_magnitude(value)))
    whole = isqrt(p * scale // q)
    step = isqrt(scale)
    return Fraction(whole, step), Fraction(whole + 1, step)


def _degradation(made: Made) -> Fraction:
    return made.mfs_squared / mfs_squared(made.mesh, made.mesh_edges)


_ROADS: dict[str, Callable[[Made], Value | None]] = {
    "appendix-a.offset-edge-length": _shortest(lambda side: True),
    "offset-edge-length": _shortest(lambda side: True),
    "appendix-a.one-end-reflex": _shortest(lambda side: side.reflex[0] != side.reflex[1]),
    "appendix-a.both-angles-acute": _shortest(lambda side: all(side.acute)),
    "section-2.p4-feature-size": lambda made: _p4_mfs(made) / made.mfs_squared,
    "section-2.p4-both-regions": _both_mfs,
    "section-2.p4-tube-distance": _between_p_and_p4,
    "section-2.p5-feature-size": lambda made: _p5_mfs(made) / _p4_mfs(made),
    "section-2.p5-above-grid": lambda made: _p5_mfs(made) / made.spacing**2,
    "section-2.interior-feature-size": lambda made: _face_feature(made.interior) / made.mfs_squared,
    "tube.feature-size": lambda made: _face_feature(made.tube) / made.mfs_squared,
    "theorem-1.feature-size": lambda made: 1 / _degradation(made),
    "theorem-1.degradation": _degradation,
    "repaired.degradation": _degradation,
    "repaired.proper-degradation": _degradation,
    "repaired.proper-degradation-22": _degradation,
    "degradation": _degradation,
    "proper-degradation": _degradation,
    "theorem-1.steiner-count": lambda made: Fraction(len(made.mesh) - len(made.points), len(made.corners)),
    "repaired.steiner-count": lambda made: Fraction(len(made.mesh) - len(made.points), made.corner_count),
    "steiner-per-vertex": lambda made: Fraction(len(made.mesh) - len(made.points), len(made.points)),
    "repaired.unit": lambda made: made.mfs_squared / made.unit**2,
    "repaired.offset-thickness": lambda made: min(_thickness(made)),
    "repaired.offset-reach": lambda made: max(_thickness(made)),
    "repaired.offset-separation": lambda made: mfs_squared(made.q, list(enumerate(made.q_next))),
    "repaired.interior-feature": lambda made: _face_feature(made.interior),
    "repaired.tube-feature": lambda made: _face_feature(made.tube),
    "repaired.tube-feature-45": lambda made: _face_feature(made.tube),
}
