"""Arrays of floats with proven error bounds: the filter in front of exact arithmetic, for whole arrays at once.

A ball stands for an unknown number within `rad` of `mid`. Let u = 2**-53. A float operation with the result m is off
by at most u |m|, plus 2**-1075 where a product or quotient is subnormal (TINY is far more). So, with the errors of the
operands,

    a + b, a - b    a.rad + b.rad + u |m|
    a b             |a| b.rad + |b| a.rad + a.rad b.rad + u |m| + TINY
    a / b           (a.rad + |m| (1 + u) b.rad) / (|b| - b.rad) + u |m| + TINY      for |b| > b.rad, else infinite

bounds the error of the result. The bounds are rounded as well: each operation loses at most a factor 1 + 2**-50 of
them, which `PADDING` makes up for in every decision, for expressions of up to 1000 operations. Overflow makes bounds
infinite or not a number, and then nothing is decided. Whoever asks decides the rest exactly.
"""

from collections.abc import Sequence
from functools import reduce

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

_U = 2.0**-53
_TINY = 2.0**-1000
PADDING = 1 + 2.0**-40
_quiet = np.errstate(all="ignore")


class Balls:
    """An array of balls; operands have equal shapes, or one of them is one ball for all of the other."""

    __slots__ = ("mid", "rad")

    def __init__(self, mid: Floats, rad: Floats) -> None:
        self.mid, self.rad = mid, rad

    def __len__(self) -> int:
        return len(self.mid)

    def __getitem__(self, index: "Ints | Bools | slice") -> "Balls":
        return Balls(self.mid[index], self.rad[index])

    def __neg__(self) -> "Balls":
        return Balls(-self.mid, self.rad)

    @_quiet
    def __add__(self, other: "Balls") -> "Balls":
        mid = self.mid + other.mid
        return Balls(mid, self.rad + other.rad + _U * np.abs(mid))

    @_quiet
    def __sub__(self, other: "Balls") -> "Balls":
        mid = self.mid - other.mid
        return Balls(mid, self.rad + other.rad + _U * np.abs(mid))

    @_quiet
    def __mul__(self, other: "Balls") -> "Balls":
        mid = self.mid * other.mid
        rad = np.abs(self.mid) * other.rad
        rad += (np.abs(other.mid) + other.rad) * self.rad
        rad += _U * np.abs(mid) + _TINY
        return Balls(mid, rad)

    @_quiet
    def __truediv__(self, other: "Balls") -> "Balls":
        mid = self.mid / other.mid
        room = np.abs(other.mid) - other.rad * PADDING
        size = np.abs(mid)
        rad = (self.rad + size * (1 + 2 * _U) * other.rad) / room + (_U * size + _TINY)
        rad[~(room > 0)] = np.inf
        return Balls(mid, rad)

    @_quiet
    def squared(self) -> "Balls":
        """Return the squares."""
        mid = self.mid * self.mid
        return Balls(mid, (2 * np.abs(self.mid) + self.rad) * self.rad + (_U * np.abs(mid) + _TINY))

    @_quiet
    def scaled(self, factor: float) -> "Balls":
        """Return the product with a number that is a float exactly."""
        mid = self.mid * factor
        return Balls(mid, self.rad * abs(factor) + (_U * np.abs(mid) + _TINY))

    def sizes(self) -> "Balls":
        """Return the absolute values."""
        return Balls(np.abs(self.mid), self.rad)

    @_quiet
    def low(self) -> Floats:
        """Return floats that are not above the numbers."""
        low: Floats = self.mid - (self.rad * PADDING + 2 * _U * np.abs(self.mid))
        return low

    @_quiet
    def high(self) -> Floats:
        """Return floats that are not below the numbers."""
        high: Floats = self.mid + (self.rad * PADDING + 2 * _U * np.abs(self.mid))
        return high

    @_quiet
    def signs(self) -> NDArray[np.int8]:
        """Return 1 and -1 where the sign is sure, 0 where it is not decided."""
        rad = self.rad * PADDING
        signs: NDArray[np.int8] = (self.mid > rad).astype(np.int8) - (self.mid < -rad).astype(np.int8)
        return signs

    @_quiet
    def sums(self, start: Ints) -> "Balls":
        """Return the sums of stretches that begin at the given places, none of them empty, up to the end.

        Added in any order, k numbers are off by at most (k - 1) u times the sum of their sizes, and a bit.
        """
        size, count = np.add.reduceat(np.abs(self.mid), start), np.diff(start, append=len(self))
        return Balls(np.add.reduceat(self.mid, start), np.add.reduceat(self.rad, start) + 2 * _U * count * size)


def exact_balls(values: Sequence[float] | Floats) -> Balls:
    """Return balls for numbers that are floats exactly."""
    mid = np.asarray(values, dtype=np.float64)
    return Balls(mid, np.zeros_like(mid))


def ball_of(*values: mpq) -> Balls:
    """Return balls for rationals: `float` of one is off by less than 2**-52 of its size."""
    try:
        mid = np.fromiter(map(float, values), np.float64, len(values))
    except OverflowError:
        mid = np.full(len(values), np.inf)
    return Balls(mid, np.abs(mid) * (2 * _U) + _TINY)


def constant(value: float, shape: Balls) -> Balls:
    """Return as many balls for one number, a float exactly, as there are in `shape`."""
    return Balls(np.full_like(shape.mid, value), np.zeros_like(shape.mid))


@_quiet
def between(low: Floats, high: Floats) -> Balls:
    """Return balls that contain everything between floats; where a bound is infinite, nothing is known."""
    mid = low + (high - low) / 2
    return Balls(mid, (high - low) / 2 + 4 * _U * (np.abs(low) + np.abs(high)))


def least(*balls: Balls) -> Balls:
    """Return the least of balls, place by place: large ones, whose bounds are wide, do not widen the result."""
    return between(reduce(np.minimum, [b.low() for b in balls]), reduce(np.minimum, [b.high() for b in balls]))


def greatest(*balls: Balls) -> Balls:
    """Return the greatest of balls, place by place; a maximum is off by no more than one of its arguments."""
    return reduce(lambda a, b: Balls(np.maximum(a.mid, b.mid), np.maximum(a.rad, b.rad)), balls)


def joined(*balls: Balls) -> Balls:
    """Return balls one after the other."""
    return Balls(np.concatenate([b.mid for b in balls]), np.concatenate([b.rad for b in balls]))


def where(condition: Bools, yes: Balls, no: Balls) -> Balls:
    """Return the balls of `yes` where the condition holds, else those of `no`."""
    return Balls(np.where(condition, yes.mid, no.mid), np.where(condition, yes.rad, no.rad))
