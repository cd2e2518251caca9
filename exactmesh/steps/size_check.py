"""Check the size of numbers: a bound of the bits of every coordinate, from those of the input alone.

The bound follows the formulas of the steps. A value is kept as a numerator of so many bits over a product of factors,
the denominators and divisors that went into it, so that a sum of values over common factors does not multiply them
again. With |a| < 2**k, |b| < 2**l over the same factors, |a + b|, |a - b| < 2**(max(k, l) + 1), |a b| < 2**(k + l), and
what is chosen from several values has the greatest of their sizes. Sums and differences are alike: all are written +.
The depth of all formulas is fixed, but for the rows of `layers`: for proper meshes nothing is claimed. So sizes are
linear in those of the input, whatever its length.

Not checked: that the formulas below are those of the steps. The bound is asserted of the numbers that came out.
"""

from collections import Counter
from collections.abc import Iterable, Sequence
from functools import reduce
from typing import NamedTuple

from exactmesh.geometry.point import Point
from exactmesh.measure.verdict import Verdict, failed
from exactmesh.steps.constants import FLAT, LEVEL, WIDE
from exactmesh.steps.records import Offset, Patch, Shape, Trapezoidation

# What stands for a divisor, by identity, and its bits.
Factor = tuple[object, int]


class Size:
    """A numerator of so many bits over a product of factors, each with its power."""

    __slots__ = ("bits", "factors")

    def __init__(self, bits: int, factors: "Counter[Factor] | None" = None) -> None:
        self.bits, self.factors = bits, factors or Counter()

    @property
    def denominator(self) -> int:
        """The bits of the denominator."""
        return _bits(self.factors)

    def over(self, factors: "Counter[Factor]") -> int:
        """Return the bits of the numerator over more factors."""
        return self.bits + _bits(factors - self.factors)

    def or_(self, *others: "Size") -> "Size":
        """Return the size of what is one of several values."""
        factors = reduce(lambda a, b: a | b.factors, others, self.factors)
        return Size(max(one.over(factors) for one in (self, *others)), factors)

    def __add__(self, other: "Size") -> "Size":
        either = self.or_(other)
        return Size(either.bits + 1, either.factors)

    def __mul__(self, other: "Size") -> "Size":
        return Size(self.bits + other.bits, self.factors + other.factors)

    def divided(self, other: "Size") -> "Size":
        """Return the size of the quotient; the numerator of `other` becomes a factor."""
        return Size(self.bits + _bits(other.factors - self.factors),
                    (self.factors - other.factors) + Counter({(other, other.bits): 1}))


def _bits(factors: "Counter[Factor]") -> int:
    return sum(bits * power for (_, bits), power in factors.items())


def _value(bits: int, denominator: int) -> Size:
    """Return the size of a value with a denominator of its own."""
    return Size(bits, Counter({(object(), denominator): 1}))


class Place(NamedTuple):
    """The sizes of the coordinates of a point or vector."""

    x: Size
    y: Size

    def minus(self, other: "Place") -> "Place":
        """Return the size of the vector from another point."""
        return Place(self.x + other.x, self.y + other.y)

    def dot(self, other: "Place") -> Size:
        """Return the size of a scalar or cross product."""
        return self.x * other.x + self.y * other.y

    def or_(self, *others: "Place") -> "Place":
        """Return the size of what is one of several points."""
        return Place(self.x.or_(*(o.x for o in others)), self.y.or_(*(o.y for o in others)))


class Bits(NamedTuple):
    """The greatest numbers of bits of numerator and denominator of a coordinate."""

    numerator: int
    denominator: int


class Limits(NamedTuple):
    """Bounds for the vertices of Q, for chord ends, and for what the Interior and the Tube add, in units of m."""

    offset: Bits
    chords: Bits
    interior: Bits
    tube: Bits


# The shares in the rules for new vertices, of up to 7 bits over 1000 at most, and parts of sums.
_SHARE = Size(7, Counter({("share", 10): 1}))
_HALF, _QUARTER = Size(1, Counter({("2", 2): 1})), Size(1, Counter({("2", 2): 2}))


def bits_of(points: Iterable[Point]) -> Bits:
    """Return the greatest numbers of bits in a coordinate."""
    numerator = denominator = 1
    for p in points:
        for value in p:
            numerator = max(numerator, int(value.numerator.bit_length()))
            denominator = max(denominator, int(value.denominator.bit_length()))
    return Bits(numerator, denominator)


def limits(p: Bits) -> Limits:
    """Return the bounds for an input whose coordinates, in units of m, are of size `p`."""
    n, d = p
    # A level is (2 j + 1) LEVEL / 2 with an integer j that is less than 5 bits longer than the ordinate.
    half = bits_of([Point(LEVEL / 2, LEVEL / 2)])
    level = n + 6
    height = _value(level + half.numerator, half.denominator)
    # The line a x + b y = c of two points, moved by a vertex of the body, all multiplied by its denominators: four of
    # coordinates, one of the body. Two lines cross at x = (c b' - c' b) / (a b' - a' b).
    body = bits_of([Point(FLAT, WIDE)])
    ab = n + 3 * d + 1 + body.denominator
    c = max(2 * (n + d), n + 3 * d) + 3 + body.denominator
    q = Bits(max(ab + c + 1, n + d + body.numerator + body.denominator), max(2 * ab + 1, d + body.denominator))
    # A chord end is a mean of two abscissae with numbers of levels as weights.
    chord = Bits(q.numerator + q.denominator + level + 1, 2 * q.denominator + level)

    def of_q() -> Place:
        return Place(_value(*q), height)

    a, b, v = of_q(), of_q(), of_q()
    foot = height + height * (v.x + a.x).divided(b.x + a.x)
    # What the Interior and the Tube begin with: any vertex on Q, or in a quadrilateral between dropped verticals.
    on_q = Bits(max(q.numerator, chord.numerator), max(q.denominator, chord.denominator))
    foot_y = Bits(max(foot.bits, height.bits), max(foot.denominator, height.denominator))

    def recorded() -> Place:
        return Place(_value(*on_q), height)

    def dropped() -> Place:
        return Place(_value(*on_q), _value(*foot_y))

    def given() -> Place:
        return Place(_value(n, d), _value(n, d))

    centre = _centre(dropped(), dropped(), dropped(), dropped())
    o, e, *others = (recorded() for _ in range(6))
    way = e.x + o.x
    shares = [(w.x + o.x).divided(way) for w in others]
    inside = _new(o, e, recorded(), recorded(), shares)
    # In the Tube, chord ends are shares of the way by numbers of levels, feet stand where a vertex of Q does.
    o, e, *others = (of_q() for _ in range(6))
    way = e.x + o.x
    by_level = _value(level, level)
    shares = [by_level.or_((w.x + o.x).divided(way)) for w in others]
    in_tube = _new(o, e, given(), given(), shares)
    return Limits(_greatest(_value(*q), height), _greatest(_value(*chord), height),
                  _greatest(_value(*on_q), foot, *centre, *inside), _greatest(*in_tube))


def _greatest(*sizes: Size) -> Bits:
    return Bits(max(size.bits for size in sizes), max(size.denominator for size in sizes))


def _centre(a: Place, b: Place, c: Place, d: Place) -> Place:
    """Return the size of a vertex in a clean quadrilateral: the mean, or one over the middle of a b towards c d."""
    mean = Place((a.x + b.x + (c.x + d.x)) * _QUARTER, (a.y + b.y + (c.y + d.y)) * _QUARTER)
    middle = Place((a.x + b.x) * _HALF, (a.y + b.y) * _HALF)
    along = d.minus(c)
    t = middle.minus(c).dot(along).divided(along.dot(along))
    foot = Place(c.x + t * along.x, c.y + t * along.y)
    beyond = foot.minus(middle)
    return mean.or_(Place(middle.x + _SHARE * beyond.x, middle.y + _SHARE * beyond.y))


def _new(o: Place, e: Place, a: Place, b: Place, shares: Sequence[Size]) -> Place:
    """Return the size of a vertex in a one-sided quadrilateral with the T-side from o to e and the anchors a and b.

    `shares` are the shares of the way from o to e of four T-vertices: two beside the vertex, two beside its leader.
    """
    along = e.minus(o)
    squared = along.dot(along)
    to_a, to_b = (anchor.minus(o).dot(along).divided(squared) for anchor in (a, b))
    # What is known of an anchor or an end of the T-side, which are at 0 and 1.
    known = Size(1).or_(to_a, to_b)
    slope = (to_b + to_a).divided(to_b + to_a)
    clean = to_a + slope * (known + to_a)
    x, leader = (((u + v) * _HALF).or_(u + clean, v + clean, (to_a + to_b) * _HALF)
                 for u, v in (shares[:2], shares[2:]))
    top = _SHARE * clean
    y = top.or_(known + (x + known) * (top + known).divided(leader + known))
    hub = Place(to_a + _SHARE * (to_b + to_a), _SHARE * (to_a + _SHARE * (to_b + to_a)))
    corner = Place(known, known)
    star = Place(_HALF, _HALF * (to_a + slope * (_HALF + to_a)))
    below = _below(Place(to_a, to_a), Place(to_b, to_b), shares)
    back = Place(x, y).or_(hub, star, below, _centre(corner, corner, corner, corner)).dot(along)
    return Place(o.x + back, o.y + back)


def _below(a: Place, b: Place, shares: Sequence[Size]) -> Place:
    """Return the size, in the frame, of a vertex that is laid out along the clean side from a to b, as in `_new`."""
    along = b.minus(a)
    squared = along.dot(along)
    beside, beyond, *leaders = (Place(share + a.x, a.y).dot(along).divided(squared) for share in shares)
    end = Place(Size(1) + a.x, a.y).or_(a).dot(along).divided(squared)
    slope = (end + end).divided(end + end)
    height = end + _SHARE * end * (Size(1) + slope * slope * _HALF)
    x, leader = (((u + v) * _HALF).or_(u + _HALF * end, v + _HALF * end, _HALF)
                 for u, v in ((beside, beyond), leaders))
    y = height.or_((x + Size(1)) * height.divided(leader + Size(1)))
    back = x * along.x + y * along.y
    return Place(a.x + back, a.y + back)


def check_sizes(shape: Shape, offset: Offset, chords: Trapezoidation, interior: Patch, tube: Patch) -> Verdict:
    """Return whether no coordinate is longer than the input's allow; one instance a vertex. Nonproper meshes only."""
    number = len(shape.points)
    parts = (offset.points, chords.points, interior.points, tube.points)
    for points, most in zip(parts, limits(bits_of(shape.points)), strict=True):
        for point in points:
            number += 1
            found = bits_of([point])
            if found.numerator > most.numerator or found.denominator > most.denominator:
                return failed(number, "coordinates are as short as their formulas", vertex=number - 1, bits=found,
                              at_most=most)
    return Verdict(number, True)
