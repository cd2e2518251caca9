"""Numbers, rational or algebraic, and square roots of them, as text for reports."""

from gmpy2 import is_square, isqrt, mpq

from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.rational import decimal_text, sqrt_text, text_from_rational


def exact_text(value: mpq | Real) -> str:
    """Return an exact expression that Python and SymPy read: both types are written so by `str`."""
    return str(value)


def number_text(value: mpq | Real, digits: int = 12) -> str:
    """Return a decimal for reading."""
    return value.decimal(digits) if isinstance(value, Real) else decimal_text(value, digits)


def root_expression(squared: mpq | Real) -> str:
    """Return the square root of `squared` >= 0 as an exact expression that Python and SymPy read.

    >>> root_expression(mpq(9, 4)), root_expression(mpq(1, 2))
    ('3/2', 'sqrt(1/2)')
    """
    if isinstance(squared, Real):
        if not squared.is_rational():
            return f"sqrt({squared.expression()})"
        squared = squared.rational()
    p, q = squared.numerator, squared.denominator
    if is_square(p) and is_square(q):
        return text_from_rational(mpq(isqrt(p), isqrt(q)))
    return f"sqrt({text_from_rational(squared)})"


def root_text(squared: mpq | Real, digits: int = 12) -> str:
    """Return the square root of `squared` >= 0 as a decimal for reading."""
    if isinstance(squared, Real):
        # Rounded twice, the second time far below the digits shown: this is for reading only.
        squared, _ = squared.enclosure(8 * digits)
    return sqrt_text(squared, digits)
