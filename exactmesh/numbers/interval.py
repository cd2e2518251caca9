"""Intervals that certainly contain a real number: the filter in front of every exact sign.

An end is an MPFR number, and every operation rounds the low end down and the high end up at a stated
precision, so the result contains every value that the operands allow. MPFR rounds each operation correctly
(www.mpfr.org, "MPFR Basics"); it comes with gmpy2, which the kernel needs anyway. Overflow, beyond
2**(10**9), raises `gmpy2.OverflowResultError`, so no end is ever infinite or not a number; underflow widens
to zero.
"""

from collections.abc import Callable
from functools import lru_cache
from typing import Any, Protocol

from gmpy2 import RoundDown, RoundUp, context, mpfr, mpq, mpz

FIRST_BITS = 64
# Beyond this, `sign_of` multiplies out; by then an undecided sign is most often a zero.
LAST_FILTER_BITS = 512


@lru_cache(maxsize=256)
def _rounding(bits: int) -> tuple[Any, Any]:
    """Return the contexts of `bits` bits that round down and up."""
    down = context(precision=bits, round=RoundDown, trap_overflow=True, trap_invalid=True)
    up = context(precision=bits, round=RoundUp, trap_overflow=True, trap_invalid=True)
    return down, up


class Interval:
    """The reals from `low` to `high`; + - * with intervals, int, mpz and mpq enclose the exact result."""

    __slots__ = ("bits", "high", "low")

    def __init__(self, low: mpfr, high: mpfr, bits: int) -> None:
        self.low = low
        self.high = high
        self.bits = bits

    @classmethod
    def of(cls, value: int | mpz | mpq, bits: int) -> "Interval":
        """Return the narrowest interval around `value` with ends of `bits` bits."""
        down, up = _rounding(bits)
        return cls(mpfr(value, 0, down), mpfr(value, 0, up), bits)

    def sign(self) -> int | None:
        """Return the sign of every number inside, or None when they differ."""
        if self.low > 0:
            return 1
        if self.high < 0:
            return -1
        return 0 if self.low == 0 == self.high else None

    def __add__(self, other: "Interval | int | mpz | mpq") -> "Interval":
        if not isinstance(other, Interval):
            other = Interval.of(other, self.bits)
        down, up = _rounding(self.bits)
        return Interval(down.add(self.low, other.low), up.add(self.high, other.high), self.bits)

    __radd__ = __add__

    def __sub__(self, other: "Interval | int | mpz | mpq") -> "Interval":
        if not isinstance(other, Interval):
            other = Interval.of(other, self.bits)
        down, up = _rounding(self.bits)
        return Interval(down.sub(self.low, other.high), up.sub(self.high, other.low), self.bits)

    def __rsub__(self, other: int | mpz | mpq) -> "Interval":
        return Interval.of(other, self.bits) - self

    def __neg__(self) -> "Interval":
        down, up = _rounding(self.bits)
        return Interval(down.minus(self.high), up.minus(self.low), self.bits)

    def __mul__(self, other: "Interval | int | mpz | mpq") -> "Interval":
        if not isinstance(other, Interval):
            other = Interval.of(other, self.bits)
        down, up = _rounding(self.bits)
        a, b, c, d = self.low, self.high, other.low, other.high
        if a >= 0:
            low = down.mul(a if c >= 0 else b, c)
            high = up.mul(b if d >= 0 else a, d)
        elif b <= 0:
            low = down.mul(a if d >= 0 else b, d)
            high = up.mul(b if c >= 0 else a, c)
        elif c >= 0:
            low, high = down.mul(a, d), up.mul(b, d)
        elif d <= 0:
            low, high = down.mul(b, c), up.mul(a, c)
        else:
            low = min(down.mul(a, d), down.mul(b, c))
            high = max(up.mul(a, c), up.mul(b, d))
        return Interval(low, high, self.bits)

    __rmul__ = __mul__

    def root(self) -> "Interval":
        """Return an interval around the square roots of the numbers inside that are not negative."""
        down, up = _rounding(self.bits)
        low = down.sqrt(self.low) if self.low > 0 else mpfr(0)
        return Interval(low, up.sqrt(self.high), self.bits)


def sign_by_widening(enclosure: Callable[[int], Interval]) -> int:
    """Return the sign of a number known not to be zero, from `enclosure(bits)` at 64, 128, 256, ... bits.

    The loop ends because the intervals shrink to a number that is not zero; nothing else bounds it.
    """
    bits = FIRST_BITS
    while True:
        sign = enclosure(bits).sign()
        if sign:
            return sign
        bits *= 2


class Enclosed(Protocol):
    """An exact number that can be enclosed, such as `exactmesh.numbers.algebraic.Real`."""

    def interval(self, bits: int) -> Interval: ...


def sign_of(polynomial: Callable[..., Any], *values: Enclosed) -> int:
    """Return the exact sign of polynomial(*values), which uses + - * on its arguments and rationals.

    `polynomial` is called with intervals of 64, 128, 256 and 512 bits, and with `values` themselves only if
    zero is inside all of these: most signs cost no exact product. It must not branch on its arguments.
    """
    bits = FIRST_BITS
    while bits <= LAST_FILTER_BITS:
        sign = polynomial(*[value.interval(bits) for value in values]).sign()
        if sign is not None:
            return int(sign)
        bits *= 2
    return int(polynomial(*values).sign())
