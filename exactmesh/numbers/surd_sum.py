"""Sums of square roots: the field K generated over Q by the square roots of all positive integers.

A value is a sum of c * sqrt(n) over radicals n of different classes, c rational and not zero. Such roots are
linearly independent (see `radicals`), so the value is zero exactly when the sum is empty: no sign or equality
needs a bound.

Automorphisms of K change signs of roots; `_split` picks one by a Legendre symbol. With u the part that it
fixes and m the part that it negates, (u + m)(u - m) = u*u - m*m has smaller rank, which gives inverses, and
square roots in K.
"""

from collections.abc import Iterable, Iterator

from gmpy2 import gcd, lcm, legendre, mpq, mpz

from exactmesh.numbers.interval import Interval, sign_by_widening
from exactmesh.numbers.radicals import (
    MAX_RANK,
    ONE,
    Radical,
    TooManyRoots,
    product,
    radical,
    rank,
    root_enclosure,
    separating_prime,
)

_Terms = dict[Radical, tuple[Radical, mpq]]


class SurdSum:
    """An element of K: `terms` maps each class to the radical written and its coefficient. Immutable."""

    __slots__ = ("terms",)

    def __init__(self, terms: _Terms) -> None:
        self.terms = terms

    @classmethod
    def of(cls, value: mpq) -> "SurdSum":
        """Return the rational `value`."""
        return cls({ONE: (ONE, value)} if value else {})

    @classmethod
    def root_of(cls, value: mpq) -> "SurdSum":
        """Return sqrt(value) for a rational `value` >= 0."""
        if not value:
            return ZERO
        q, r = radical(value.numerator * value.denominator)
        return cls({r: (r, q / mpq(value.denominator))})

    def __bool__(self) -> bool:
        return bool(self.terms)

    def rational(self) -> mpq | None:
        """Return the value if it is rational, otherwise None."""
        if not self.terms:
            return mpq(0)
        return self.terms[ONE][1] if len(self.terms) == 1 and ONE in self.terms else None

    def __neg__(self) -> "SurdSum":
        return SurdSum({r: (r, -c) for r, c in self.terms.values()})

    def __add__(self, other: "SurdSum") -> "SurdSum":
        if not isinstance(other, SurdSum):
            return NotImplemented
        long, short = (self, other) if len(self.terms) >= len(other.terms) else (other, self)
        terms = dict(long.terms)
        for r, c in short.terms.values():
            _accumulate(terms, r, c)
        return SurdSum(terms)

    def __sub__(self, other: "SurdSum") -> "SurdSum":
        if not isinstance(other, SurdSum):
            return NotImplemented
        return self + -other

    def __mul__(self, other: "SurdSum") -> "SurdSum":
        if not isinstance(other, SurdSum):
            return NotImplemented
        terms: _Terms = {}
        for r, c in self.terms.values():
            for s, d in other.terms.values():
                if r is ONE:
                    _accumulate(terms, s, c * d)
                elif s is ONE:
                    _accumulate(terms, r, c * d)
                else:
                    q, t = product(r.n, s.n)
                    _accumulate(terms, t, c * d * q)
        return SurdSum(terms)

    def scaled(self, factor: mpq) -> "SurdSum":
        """Return the product with a rational."""
        return SurdSum({r: (r, c * factor) for r, c in self.terms.values()}) if factor else ZERO

    def inverse(self) -> "SurdSum":
        """Return 1 / self. Raises `ZeroDivisionError` and `TooManyRoots`."""
        if not self.terms:
            raise ZeroDivisionError("division by an exact zero")
        self._require_small_rank()
        numerator, norm = UNIT, self
        while len(norm.terms) > 1:
            fixed, moved = norm._split()
            numerator = numerator * (fixed - moved)
            norm = fixed * fixed - moved * moved
        ((r, c),) = norm.terms.values()
        return numerator * SurdSum({r: (r, 1 / (c * r.n))})

    def root(self) -> "SurdSum | None":
        """Return a square root of self in K, of either sign, None if there is none. Raises `TooManyRoots`.

        Let s*s = self = u + m as in `_split`, and s' the image of s. The roots of x*x - 2*u*x + N, N = u*u -
        m*m, show that K over the fixed field F of u, m*m contains s only if N = w*w with w in F, because the
        group is of exponent two; w = s * s'. Then ((s + s') / 2)**2 = (u + w) / 2 =: x must have a root e,
        and s = e + m / (2*e). Conversely such s squares to x + m + m*m / (4*x) = self, since (u + w)(u - w) =
        m*m.
        """
        value = self.rational()
        if value is not None:
            return SurdSum.root_of(value) if value >= 0 else None
        self._require_small_rank()
        if self.sign() < 0:
            return None
        fixed, moved = self._split()
        w = (fixed * fixed - moved * moved).root()
        if w is None or not _lies_in(w, fixed, moved):
            return None
        e = (fixed + w).scaled(_HALF).root()
        return None if e is None else e + moved * e.inverse().scaled(_HALF)

    def sign(self) -> int:
        """Return -1, 0 or 1."""
        return sign_by_widening(self.enclosure) if self.terms else 0

    def enclosure(self, bits: int) -> Interval:
        """Return an interval around the value, computed with `bits` bits."""
        total = Interval.of(0, bits)
        for r, c in self.terms.values():
            total = total + (Interval.of(c, bits) if r is ONE else root_enclosure(r.n, bits) * c)
        return total

    def content(self) -> mpq:
        """Return the largest rational by which the coefficients are integers; 0 for zero."""
        numerator, denominator = mpz(0), mpz(1)
        for _, c in self.terms.values():
            numerator, denominator = gcd(numerator, c.numerator), lcm(denominator, c.denominator)
        return mpq(numerator, denominator)

    def products(self) -> Iterator[tuple[mpq, tuple[str, ...]]]:
        """Yield coefficient and factors of each term, by increasing radicand."""
        for r, c in sorted(self.terms.values(), key=lambda term: term[0].n):
            yield c, () if r is ONE else (f"sqrt({r.n})",)

    def _split(self) -> tuple["SurdSum", "SurdSum"]:
        """Return u and m != 0 with self = u + m, where an automorphism fixes u, negates m."""
        radicals = self.terms.keys()
        p = separating_prime(next(r for r in radicals if r is not ONE), radicals)
        fixed: _Terms = {}
        moved: _Terms = {}
        for r, c in self.terms.values():
            (moved if legendre(r.n, p) == -1 else fixed)[r] = (r, c)
        return SurdSum(fixed), SurdSum(moved)

    def _require_small_rank(self) -> None:
        if len(self.terms) > MAX_RANK:
            if len(self.terms) > 1 << MAX_RANK:
                raise TooManyRoots(MAX_RANK)
            rank(self.terms.keys())


def total(values: Iterable[SurdSum]) -> SurdSum:
    """Return the sum of all, in time linear in the number of terms."""
    terms: _Terms = {}
    for value in values:
        for r, c in value.terms.values():
            _accumulate(terms, r, c)
    return SurdSum(terms)


def _accumulate(terms: _Terms, r: Radical, c: mpq) -> None:
    """Add c * sqrt(r.n) to `terms`, written with the radical that stands there already."""
    held = terms.get(r)
    if held is None:
        terms[r] = (r, c)
        return
    written, d = held
    if written is not r and written.n != r.n:
        numerator, denominator = r.ratio(written)
        c = c * numerator / denominator
    if c + d:
        terms[written] = (written, c + d)
    else:
        del terms[written]


def _lies_in(w: SurdSum, fixed: SurdSum, moved: SurdSum) -> bool:
    """Tell whether w lies in the field of the radicals of `fixed` and the quotients of those of `moved`."""
    first = next(iter(moved.terms))
    field = [*fixed.terms, *(product(r.n, first.n)[1] for r in moved.terms)]
    return rank([*field, *w.terms]) == rank(field)


ZERO = SurdSum({})
UNIT = SurdSum.of(mpq(1))
_HALF = mpq(1, 2)
