"""Real numbers made of integers by + - * / and square roots, exactly: the coordinates of offset curves.

A `Real` holds one canonical element of a tower of square-root extensions (see `surd_sum`, `nested`); it never
grows with the number of operations that led to it. Zero is known by its form, so a sign needs only intervals,
narrowed until they leave zero. Nothing rounds and no float decides: `float()` is refused, and so are
operations with floats; `enclosure` and `decimal` are for those who want digits.

Cost: sums and products grow with the number of terms. Division and `sqrt` multiply over 2**n conjugates for n
independent roots of rationals and raise `TooManyRoots` beyond n = 10. Any operation that must bring together
more than 8 nested roots raises it too, comparison among them when 64 bits do not decide. For signs of
polynomials use `interval.sign_of`.

Trusted: `interval`, `radicals`, `surd_sum`, `nested` and this module. Not checked: the memory that big values
take.
"""

from collections.abc import Callable, Iterable
from fractions import Fraction
from itertools import count
from typing import NoReturn, TypeAlias

from gmpy2 import mpfr, mpq, mpz

from exactmesh.numbers import nested, surd_sum
from exactmesh.numbers.interval import FIRST_BITS, Interval
from exactmesh.numbers.nested import Element, T, aligned
from exactmesh.numbers.rational import decimal_text
from exactmesh.numbers.surd_sum import SurdSum

Number: TypeAlias = "int | Fraction | mpz | mpq | Real"


class Real:
    """An exact real number. Operands may be int, Fraction, mpz, mpq or Real; floats raise `TypeError`.

    Equal values compare and hash equal, also with rational types, however they came about.
    """

    __slots__ = ("_element", "_interval")
    _element: Element
    _interval: Interval | None

    def __init__(self, value: "Number" = 0) -> None:
        element = _element(value)
        if element is None:
            raise TypeError(f"Real takes int, Fraction, mpz, mpq or Real, not {type(value).__name__}")
        self._element = element
        self._interval = None

    def sign(self) -> int:
        """Return -1, 0 or 1."""
        if not self._element:
            return 0
        return self.interval().sign() or self._element.sign()

    def sqrt(self) -> "Real":
        """Return the square root. Raises `ValueError` below zero, and `TooManyRoots`."""
        if self.sign() < 0:
            raise ValueError(f"square root of the negative number {self.decimal()}")
        return _real(nested.root(self._element))

    def is_rational(self) -> bool:
        """Tell whether the value is rational."""
        return self._element.rational() is not None

    def rational(self) -> mpq:
        """Return the value as mpq. Raises `ValueError` when it is irrational."""
        value = self._element.rational()
        if value is None:
            raise ValueError(f"{self.decimal()} is irrational")
        return value

    def enclosure(self, bits: int = 53) -> tuple[mpq, mpq]:
        """Return rationals lower <= self <= upper, at most 2**-bits * |self| apart, equal for a rational."""
        value = self._element.rational()
        if value is not None:
            return value, value
        # Zero is not between: there the bounds would be further apart than the smaller one is from zero.
        return next((lower, upper) for lower, upper in self._narrowing(bits + 8)
                    if (upper - lower) * mpq(2) ** bits <= min(abs(lower), abs(upper)))

    def decimal(self, digits: int = 12) -> str:
        """Return the value rounded to `digits` significant digits, for reading only."""
        value = self._element.rational()
        if value is not None:
            return decimal_text(value, digits)
        # An irrational number is never halfway between two decimals, so the two texts meet.
        return next(text for lower, upper in self._narrowing(4 * digits + 16)
                    if (text := decimal_text(lower, digits)) == decimal_text(upper, digits))

    def expression(self) -> str:
        """Return the exact value as Python (with math.sqrt) and SymPy read it: `sqrt(2 - sqrt(2))/16`."""
        return nested.text(self._element)

    def interval(self, bits: int = FIRST_BITS) -> Interval:
        """Return an interval around the value, computed with `bits` bits; the one of 64 bits is kept."""
        if bits != FIRST_BITS:
            return self._element.enclosure(bits)
        if self._interval is None:
            self._interval = self._element.enclosure(bits)
        return self._interval

    def fold(self, rational: Callable[[mpq], T], sqrt: Callable[[T], T]) -> T:
        """Return the value rebuilt in another number type, from its rationals, square roots, + and *."""
        return nested.fold(self._element, rational, sqrt)

    def __str__(self) -> str:
        return self.expression()

    def __repr__(self) -> str:
        return f"Real({self.expression()})"

    def __float__(self) -> NoReturn:
        raise TypeError("a Real is not rounded to a float silently: use enclosure(bits) or decimal(digits)")

    def __bool__(self) -> bool:
        return bool(self._element)

    def __floor__(self) -> int:
        value = self._element.rational()
        if value is not None:
            return int(value.numerator // value.denominator)
        return next(int(floor) for lower, upper in self._narrowing(FIRST_BITS)
                    if (floor := lower.numerator // lower.denominator) == upper.numerator // upper.denominator)

    def __ceil__(self) -> int:
        return -(-self).__floor__()

    def __hash__(self) -> int:
        value = self._element.rational()
        if value is not None:
            return hash(value)
        # The leading 64 bits depend on the value alone; an irrational number has no second expansion.
        return next(hash(leading) for lower, upper in self._narrowing(FIRST_BITS + 8)
                    if (leading := _leading_bits(lower)) == _leading_bits(upper))

    def __eq__(self, other: object) -> bool:
        if isinstance(other, Real) and self._apart(other):
            return False
        pair = self._aligned(other)
        return NotImplemented if pair is None else not pair[0] - pair[1]

    def __lt__(self, other: "Number") -> bool:
        order = self._compared(other)
        return NotImplemented if order is None else order < 0

    def __le__(self, other: "Number") -> bool:
        order = self._compared(other)
        return NotImplemented if order is None else order <= 0

    def __gt__(self, other: "Number") -> bool:
        order = self._compared(other)
        return NotImplemented if order is None else order > 0

    def __ge__(self, other: "Number") -> bool:
        order = self._compared(other)
        return NotImplemented if order is None else order >= 0

    def __neg__(self) -> "Real":
        return _real(-self._element)

    def __pos__(self) -> "Real":
        return self

    def __abs__(self) -> "Real":
        return -self if self.sign() < 0 else self

    def __add__(self, other: "Number") -> "Real":
        pair = self._aligned(other)
        return NotImplemented if pair is None else _real(pair[0] + pair[1])

    __radd__ = __add__

    def __sub__(self, other: "Number") -> "Real":
        pair = self._aligned(other)
        return NotImplemented if pair is None else _real(pair[0] - pair[1])

    def __rsub__(self, other: "Number") -> "Real":
        return -self + other

    def __mul__(self, other: "Number") -> "Real":
        pair = self._aligned(other)
        return NotImplemented if pair is None else _real(pair[0] * pair[1])

    __rmul__ = __mul__

    def __truediv__(self, other: "Number") -> "Real":
        element = _element(other)
        if element is None:
            return NotImplemented
        x, y = aligned(self._element, element.inverse())
        return _real(x * y)

    def __rtruediv__(self, other: "Number") -> "Real":
        return _real(self._element.inverse()) * other

    def __pow__(self, exponent: int) -> "Real":
        if not isinstance(exponent, int):
            return NotImplemented
        base, power = self, Real(1)
        if exponent < 0:
            base, exponent = 1 / self, -exponent
        while exponent:
            if exponent & 1:
                power = power * base
            exponent >>= 1
            if exponent:
                base = base * base
        return power

    def __reduce__(self) -> tuple[Callable[[Element], "Real"], tuple[Element]]:
        return _real, (self._element,)

    def _narrowing(self, bits: int) -> Iterable[tuple[mpq, mpq]]:
        """Yield ever narrower rational bounds, without end."""
        for doubling in count():
            interval = self._element.enclosure(bits << doubling)
            yield mpq(interval.low), mpq(interval.high)

    def _aligned(self, other: object) -> tuple[Element, Element] | None:
        element = _element(other)
        return None if element is None else aligned(self._element, element)

    def _apart(self, other: "Real") -> bool:
        mine, its = self.interval(), other.interval()
        return bool(mine.high < its.low or its.high < mine.low)

    def _compared(self, other: object) -> int | None:
        """Return the sign of self - other, or None when `other` is no number."""
        if not isinstance(other, Real):
            element = _element(other)
            if element is None:
                return None
            other = _real(element)
        if self._apart(other):
            return -1 if self.interval().high < other.interval().low else 1
        x, y = aligned(self._element, other._element)
        return (x - y).sign()


def sqrt(value: Number) -> Real:
    """Return the square root of `value`. Raises `ValueError` below zero, and `TooManyRoots`."""
    return Real(value).sqrt()


def total(values: Iterable[Real]) -> Real:
    """Return the sum of all, in linear time; each `+` copies the sum so far."""
    flat: list[SurdSum] = []
    rest = Real()
    for value in values:
        if isinstance(value._element, SurdSum):
            flat.append(value._element)
        else:
            rest += value
    return rest + _real(surd_sum.total(flat))


def _real(element: Element) -> Real:
    real = Real.__new__(Real)
    real._element = element
    real._interval = None
    return real


def _element(value: object) -> Element | None:
    """Return the element of a number, None for what is no number; raises `TypeError` for a float."""
    if isinstance(value, Real):
        return value._element
    if isinstance(value, int | Fraction | _RATIONAL):
        return SurdSum.of(mpq(value))
    if isinstance(value, float | complex | _FLOAT):
        raise TypeError(f"a {type(value).__name__} is not exact: use int, Fraction, mpz or mpq")
    return None


_RATIONAL = type(mpz(0)) | type(mpq(0))
_FLOAT = type(mpfr(0))


def _leading_bits(value: mpq) -> tuple[int, int]:
    """Return f, e with f = floor(value * 2**e) of 64 or 65 bits."""
    shift = 64 - (value.numerator.bit_length() - value.denominator.bit_length())
    scaled = value * mpq(2) ** shift
    return int(scaled.numerator // scaled.denominator), shift
