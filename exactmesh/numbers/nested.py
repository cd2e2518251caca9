"""Values with roots of sums of roots: elements of towers of square-root extensions of K (see `surd_sum`).

A `Root` is t = sqrt(d), d > 0 an element of lower depth; a `Nested` is a + b*t with b not zero, where a and b
contain only roots that come before t in the order of `Root.key` (depth, then text), so t is the greatest root
inside.

Invariant: the roots in one value are independent, that is, each t is not an element of the field generated
over K by the others that come before it. Then a + b*t is zero only for a = b = 0: zero is `ZERO` of
`surd_sum`, and every `Nested` is irrational. Independence depends on the set of roots, not on their order,
and subsets inherit it. `root` and `aligned` keep it: before two values meet, `aligned` rewrites one of them
so that their roots together are independent. The recursions below are as deep as a value has different nested
roots, never as an input is long.
"""

from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import chain
from typing import Any, Protocol, TypeVar

from gmpy2 import gcd, lcm, mpq

from exactmesh.numbers.interval import Interval, sign_by_widening
from exactmesh.numbers.radicals import TooManyRoots
from exactmesh.numbers.surd_sum import UNIT, ZERO, SurdSum


class Ring(Protocol):
    """Whatever can be added and multiplied."""

    def __add__(self, other: Any, /) -> Any: ...
    def __mul__(self, other: Any, /) -> Any: ...


T = TypeVar("T", bound=Ring)
# Whether a value is a square takes about 4**n steps over n nested roots.
MAX_ROOTS = 8
_HALF = SurdSum.of(mpq(1, 2))


class Root:
    """sqrt(square), positive. Two are equal when they are written alike."""

    __slots__ = ("_enclosure", "_hash", "inside", "key", "square")

    def __init__(self, square: "Element") -> None:
        self.square = square
        self.inside = _roots(square)
        depth = 1 + max((t.key[0] for t in self.inside), default=0)
        self.key: tuple[int, str] = (depth, f"sqrt({text(square)})")
        self._hash = hash(self.key)
        self._enclosure = Interval.of(0, 1)

    def __hash__(self) -> int:
        return self._hash

    def __eq__(self, other: object) -> bool:
        return self is other or (isinstance(other, Root) and self.key == other.key)

    def __reduce__(self) -> tuple[type["Root"], tuple["Element"]]:
        return Root, (self.square,)

    def enclosure(self, bits: int) -> Interval:
        """Return an interval around the root; the last one is kept."""
        if self._enclosure.bits != bits:
            self._enclosure = self.square.enclosure(bits).root()
        return self._enclosure


class Nested:
    """a + b * root, b not zero; `roots` are all those inside. Never changed once made."""

    __slots__ = ("a", "b", "root", "roots")

    def __init__(self, root: Root, a: "Element", b: "Element") -> None:
        self.root = root
        self.a = a
        self.b = b
        self.roots = _roots(a) | _roots(b) | root.inside | {root}

    def __reduce__(self) -> tuple[type["Nested"], tuple[Root, "Element", "Element"]]:
        return Nested, (self.root, self.a, self.b)

    def rational(self) -> None:
        """Return None: the value is irrational."""

    def __neg__(self) -> "Nested":
        return Nested(self.root, -self.a, -self.b)

    def __add__(self, other: "Element") -> "Element":
        if isinstance(other, Nested):
            if self.root == other.root:
                return _made(self.root, self.a + other.a, self.b + other.b)
            if self.root.key < other.root.key:
                return Nested(other.root, other.a + self, other.b)
        return Nested(self.root, self.a + other, self.b)

    __radd__ = __add__

    def __sub__(self, other: "Element") -> "Element":
        return self + -other

    def __rsub__(self, other: "Element") -> "Element":
        return -self + other

    def __mul__(self, other: "Element") -> "Element":
        if isinstance(other, Nested):
            if self.root == other.root:
                a = self.a * other.a + self.b * other.b * self.root.square
                return _made(self.root, a, self.a * other.b + self.b * other.a)
            if self.root.key < other.root.key:
                return _made(other.root, other.a * self, other.b * self)
        return _made(self.root, self.a * other, self.b * other)

    __rmul__ = __mul__

    def scaled(self, factor: mpq) -> "Element":
        """Return the product with a rational."""
        return _made(self.root, self.a.scaled(factor), self.b.scaled(factor))

    def inverse(self) -> "Element":
        """Return 1 / self. Raises `TooManyRoots`."""
        norm = (self.a * self.a - self.b * self.b * self.root.square).inverse()
        return _made(self.root, self.a * norm, -self.b * norm)

    def sign(self) -> int:
        """Return -1 or 1."""
        return sign_by_widening(self.enclosure)

    def enclosure(self, bits: int) -> Interval:
        """Return an interval around the value, computed with `bits` bits."""
        return self.a.enclosure(bits) + self.b.enclosure(bits) * self.root.enclosure(bits)

    def content(self) -> mpq:
        """Return the largest rational by which all coefficients are integers."""
        a, b = self.a.content(), self.b.content()
        return mpq(gcd(a.numerator, b.numerator), lcm(a.denominator, b.denominator)) if a else b

    def products(self) -> Iterator[tuple[mpq, tuple[str, ...]]]:
        """Yield coefficient and factors of each product when multiplied out."""
        yield from self.a.products()
        for c, factors in self.b.products():
            yield c, (*factors, self.root.key[1])


Element = SurdSum | Nested


def root(square: Element) -> Element:
    """Return the square root >= 0 of `square` >= 0. Raises `TooManyRoots`."""
    value = square.rational()
    if value is not None:
        return SurdSum.root_of(value)
    found = root_in(square, _tower(_roots(square)))
    if found is not None:
        return -found if found.sign() < 0 else found
    if len(_roots(square)) == MAX_ROOTS:
        raise TooManyRoots(MAX_ROOTS)
    # Rational factors are taken out, so that values which differ by one share their root.
    content = square.content()
    return Nested(Root(square.scaled(1 / content)), ZERO, SurdSum.root_of(content))


def root_in(square: Element, tower: tuple[Root, ...]) -> Element | None:
    """Return a square root, of either sign, of `square` in the field that `tower` generates over K.

    None when there is none. The roots in `tower` are independent. With t*t = d the last root, (p + q*t)**2 =
    u + v*t means p*p + q*q*d = u and 2*p*q = v. For v = 0 either u or u*d is a square below; otherwise p*p =
    (u + w) / 2 with w*w = u*u - v*v*d, and q = v / (2*p).
    """
    if not square or square.sign() < 0:
        return None if square else ZERO
    if not tower:
        assert isinstance(square, SurdSum)
        return square.root()
    *front, t = tower
    lower = tuple(front)
    u, v = (square.a, square.b) if isinstance(square, Nested) and square.root == t else (square, ZERO)
    if not v:
        below = root_in(u, lower)
        if below is not None:
            return below
        below = root_in(u * t.square, lower)
        return None if below is None else _made(t, ZERO, below * t.square.inverse())
    w = root_in(u * u - v * v * t.square, lower)
    if w is None:
        return None
    for half in ((u + w) * _HALF, (u - w) * _HALF):
        p = root_in(half, lower)
        if p is not None:
            return Nested(t, p, v * p.inverse() * _HALF)
    return None


def aligned(x: Element, y: Element) -> tuple[Element, Element]:
    """Return x and y, y rewritten so that their roots together are independent. Raises `TooManyRoots`."""
    ours, theirs = _roots(x), _roots(y)
    if theirs <= ours or ours <= theirs:
        return x, y
    return x, _substituted(y, _images(ours, theirs))


@lru_cache(maxsize=1024)
def _images(ours: frozenset[Root], theirs: frozenset[Root]) -> dict[Root, Element]:
    """Return those of `theirs` that must be rewritten, as values in an extension of the field of `ours`."""
    field = set(ours)
    images: dict[Root, Element] = {}
    for t in _tower(theirs):
        if t in field:
            continue
        square = _substituted(t.square, images)
        found = root_in(square, _tower(frozenset(field)))
        if found is not None:
            images[t] = -found if found.sign() < 0 else found
            continue
        rewritten = t if square is t.square else Root(square)
        if len(field) == MAX_ROOTS:
            raise TooManyRoots(MAX_ROOTS)
        field.add(rewritten)
        if rewritten is not t:
            images[t] = Nested(rewritten, ZERO, UNIT)
    return images


def _substituted(x: Element, images: dict[Root, Element]) -> Element:
    if isinstance(x, SurdSum) or x.roots.isdisjoint(images):
        return x
    t = images.get(x.root)
    image = Nested(x.root, ZERO, UNIT) if t is None else t
    return _substituted(x.a, images) + _substituted(x.b, images) * image


def text(x: Element) -> str:
    """Return an expression of integers, + - * / and sqrt, such as `sqrt(2 - sqrt(2))/16`."""
    written = ""
    for c, factors in x.products():
        sign = ("- " if c < 0 else "+ ") if written else ("-" if c < 0 else "")
        size = abs(c.numerator)
        product = "*".join(chain(() if size == 1 and factors else (str(size),), factors))
        divisor = f"/{c.denominator}" if c.denominator > 1 else ""
        written += f"{' ' if written else ''}{sign}{product}{divisor}"
    return written or "0"


def fold(x: Element, rational: Callable[[mpq], T], sqrt: Callable[[T], T]) -> T:
    """Return x rebuilt from its rationals and square roots by the given functions, + and *."""
    if isinstance(x, Nested):
        a, b = fold(x.a, rational, sqrt), fold(x.b, rational, sqrt)
        result: T = a + b * sqrt(fold(x.root.square, rational, sqrt))
        return result
    result = rational(mpq(0))
    for r, c in x.terms.values():
        result = result + rational(c) * sqrt(rational(mpq(r.n)))
    return result


def _made(t: Root, a: Element, b: Element) -> Element:
    return Nested(t, a, b) if b else a


def _roots(x: Element) -> frozenset[Root]:
    return x.roots if isinstance(x, Nested) else frozenset()


def _tower(roots: frozenset[Root]) -> tuple[Root, ...]:
    return tuple(sorted(roots, key=lambda t: t.key))
