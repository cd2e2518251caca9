"""Rational numbers as text, and what can be said of their square roots without rounding.

Every rational is a `gmpy2.mpq` in lowest terms. Text is read exactly (a decimal is the decimal that is written) and
written exactly; `decimal_text` and `sqrt_text` are for readers and decide nothing.
"""

import re
from fractions import Fraction
from math import isfinite

from gmpy2 import isqrt, mpq, mpz

from exactmesh.errors import FormatError

_DECIMAL = re.compile(r"([+-]?)(?:(\d+)(?:\.(\d*))?|\.(\d+))(?:[eE]([+-]?\d+))?", re.ASCII)
_FRACTION = re.compile(r"([+-]?\d+)/(\d+)", re.ASCII)
# A larger exponent would let a file of a few bytes ask for gigabytes.
MAX_EXPONENT = 100_000


def rational(value: int | str | Fraction | mpq) -> mpq:
    """Return `value` as an exact rational; text is read by `rational_from_text`."""
    return rational_from_text(value) if isinstance(value, str) else mpq(value)


def rational_from_text(text: str, place: str = "") -> mpq:
    """Return the integer, finite decimal or fraction `p/q` that `text` spells, exactly.

    Raises `FormatError`, naming `place`, for anything else, a zero denominator or an exponent beyond 100000.
    """
    stripped = text.strip()
    if match := _FRACTION.fullmatch(stripped):
        denominator = mpz(match[2])
        if denominator == 0:
            raise FormatError(place, f"denominator of {_quoted(text)} is zero")
        return mpq(mpz(match[1]), denominator)
    match = _DECIMAL.fullmatch(stripped)
    if match is None:
        raise FormatError(place, f"{_quoted(text)} is not an integer, a finite decimal or a fraction p/q")
    sign, whole, part, only_part, exponent_text = match.groups()
    part = part or only_part or ""
    exponent = 0
    if exponent_text:
        # Leading zeros are stripped so that the length test below sees the size, not the spelling.
        digits = exponent_text.lstrip("+-").lstrip("0") or "0"
        if len(digits) > len(str(MAX_EXPONENT)) or int(digits) > MAX_EXPONENT:
            raise FormatError(place, f"the exponent of {_quoted(text)} is beyond {MAX_EXPONENT}")
        exponent = -int(digits) if exponent_text[0] == "-" else int(digits)
    mantissa = mpz((whole or "") + part)
    if sign == "-":
        mantissa = -mantissa
    return mantissa * mpq(10) ** (exponent - len(part))


def rational_from_float(value: float, place: str = "") -> mpq:
    """Return exactly the value of a binary double; raises `FormatError` for NaN and infinities."""
    if not isfinite(value):
        raise FormatError(place, f"{value} is not a finite number")
    return mpq(*value.as_integer_ratio())


def text_from_rational(value: mpq) -> str:
    """Return `value` in lowest terms: `p`, or `p/q` with q > 1."""
    return str(value)


def decimal_text(value: mpq, digits: int = 12) -> str:
    """Return `value` rounded to `digits` significant digits, for reading only."""
    return _significant(mpq(abs(value)), digits, squared=False, negative=value < 0)


def sqrt_text(squared: mpq, digits: int = 12) -> str:
    """Return the square root of `squared` >= 0 rounded to `digits` significant digits, for reading only."""
    return _significant(squared, digits, squared=True, negative=False)


def sqrt_below(squared: mpq, bits: int) -> mpq:
    """Return a dyadic rational r with r <= sqrt(squared) < r * (1 + 2**(1 - bits)), for squared > 0.

    It has at most `bits` significant bits. Raises `ValueError` when `squared` or `bits` is not positive.
    """
    if squared <= 0 or bits <= 0:
        raise ValueError(f"squared and bits must be positive, not {squared} and {bits}")
    numerator, denominator = squared.numerator, squared.denominator
    # 2**(2 * bits - 1) < squared * 4**shift < 2**(2 * bits + 2), so the root has `bits` bits or one more.
    shift = bits - (numerator.bit_length() - denominator.bit_length()) // 2
    root = _floor_sqrt(squared, shift)
    if root.bit_length() > bits:
        shift -= 1
        root = _floor_sqrt(squared, shift)
    return mpq(root) * mpq(2) ** -shift


def _floor_sqrt(squared: mpq, shift: int) -> mpz:
    """Return floor(sqrt(squared) * 2**shift)."""
    scaled = squared * mpq(4) ** shift
    return isqrt(scaled.numerator // scaled.denominator)


def _significant(value: mpq, digits: int, *, squared: bool, negative: bool) -> str:
    if value == 0:
        return "0"
    # 0.30103 = log10(2): a guess of the leading digit's place, corrected below.
    magnitude = value.numerator.bit_length() - value.denominator.bit_length()
    leading = int(magnitude * 0.30103 / (2 if squared else 1))
    for place in range(leading + 2, leading - 4, -1):
        shift = digits - 1 - place
        scaled = value * mpq(10) ** (2 * shift if squared else shift)
        # floor(2t) + 1 halved is t rounded to the nearest integer, for t itself and for its root alike.
        doubled = isqrt((4 * scaled).numerator // (4 * scaled).denominator) if squared else (
            (2 * scaled).numerator // (2 * scaled).denominator)
        if doubled // 2 >= mpz(10) ** (digits - 1):
            break
    text = str((doubled + 1) // 2)
    if len(text) > digits:
        text, place = text[:digits], place + 1
    return ("-" if negative else "") + _placed(text, place)


def _placed(text: str, place: int) -> str:
    """Return the digits `text`, the first of which stands at 10**place, without trailing zeros."""
    if -5 <= place < len(text):
        if place < 0:
            return "0." + "0" * (-place - 1) + text.rstrip("0")
        whole, part = text[: place + 1], text[place + 1 :].rstrip("0")
        return f"{whole}.{part}" if part else whole
    if len(text) <= place <= 20:
        return text + "0" * (place + 1 - len(text))
    head, tail = text[0], text[1:].rstrip("0")
    return f"{head}.{tail}e{place}" if tail else f"{head}e{place}"


def _quoted(text: str) -> str:
    return repr(text if len(text) <= 40 else text[:37] + "...")
