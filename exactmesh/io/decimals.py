"""Coordinates as formats other than ours can hold them: finite decimals, or binary doubles.

A writer never rounds. `rounded` does, before, so that what is lost is known, and can be measured.
"""

from collections.abc import Callable

from gmpy2 import mpq, mpz, remove

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.text import shortened
from exactmesh.numbers.rational import rational_from_float

# A double in text: as many digits as tell every double from its neighbours.
_DIGITS = 17


def nearest_double(value: mpq) -> mpq:
    """Return the value of the binary double nearest to `value`; raises `FormatError` when it overflows."""
    try:
        return rational_from_float(float(value))
    except (FormatError, OverflowError):
        raise FormatError("", f"{shortened(str(value))} is beyond the range of a double") from None


def nearest_decimal(value: mpq) -> mpq:
    """Return `value` itself when it is a finite decimal, else rounded to 17 significant digits."""
    if _fives_and_twos(value) is not None:
        return value
    # 2**k < |value| < 2**(k + 2), so the first digit stands at about 10**(0.301 k).
    magnitude = value.numerator.bit_length() - value.denominator.bit_length() - 1
    place = _DIGITS - int(magnitude * 0.30103)
    scaled = value * mpq(10) ** place
    doubled = (2 * scaled.numerator + scaled.denominator) // (2 * scaled.denominator)
    return mpq(doubled) / mpq(10) ** place


def rounded(points: tuple[Point, ...], nearest: Callable[[mpq], mpq]) -> tuple[Point, ...]:
    """Return points with coordinates that a format can hold."""
    return tuple(Point(nearest(p.x), nearest(p.y)) for p in points)


def decimal_of(value: mpq, place: str = "") -> str:
    """Return the finite decimal that is `value`; raises `FormatError` naming `place` when there is none."""
    shift = _fives_and_twos(value)
    if shift is None:
        raise FormatError(place, f"{shortened(str(value))} is no finite decimal, and this format has nothing else")
    digits = str(abs(value.numerator) * mpz(10) ** shift // value.denominator).zfill(shift + 1)
    whole, part = digits[: len(digits) - shift], digits[len(digits) - shift :]
    return ("-" if value < 0 else "") + whole + ("." + part if part else "")


def _fives_and_twos(value: mpq) -> int | None:
    """Return how many decimals `value` has; None when a prime other than 2 and 5 divides its denominator."""
    rest, twos = remove(value.denominator, 2)
    rest, fives = remove(rest, 5)
    return max(int(twos), int(fives)) if rest == 1 else None
