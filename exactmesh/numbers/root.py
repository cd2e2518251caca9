"""Lengths and ratios that are known by their square: text for reports."""

from gmpy2 import is_square, isqrt, mpq

from exactmesh.numbers.rational import text_from_rational


def root_expression(squared: mpq) -> str:
    """Return the square root of `squared` >= 0 as an exact expression that Python and SymPy read.

    >>> root_expression(mpq(9, 4)), root_expression(mpq(1, 2))
    ('3/2', 'sqrt(1/2)')
    """
    p, q = squared.numerator, squared.denominator
    if is_square(p) and is_square(q):
        return text_from_rational(mpq(isqrt(p), isqrt(q)))
    return f"sqrt({text_from_rational(squared)})"
