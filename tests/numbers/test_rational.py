"""`exactmesh.numbers.rational`: text in, text out, and square roots from below."""

from decimal import ROUND_HALF_UP, Context, Decimal
from fractions import Fraction
from math import inf, nan

import pytest
from gmpy2 import mpq
from hypothesis import example, given, settings
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.numbers.rational import (
    MAX_EXPONENT,
    decimal_text,
    rational,
    rational_from_float,
    rational_from_text,
    sqrt_below,
    sqrt_text,
    text_from_rational,
)

few = settings(max_examples=200, deadline=None, derandomize=True)
WIDE = Context(prec=900, Emin=-(10**6), Emax=10**6)


def rationals() -> st.SearchStrategy[mpq]:
    """Rationals of all sizes, near powers of ten among them."""
    plain = st.fractions().map(mpq)
    near = st.builds(lambda k, d: mpq(10**k + d), st.integers(0, 20), st.integers(-1, 1))
    scaled = st.builds(lambda q, k: q * mpq(10) ** k, st.one_of(plain, near), st.integers(-300, 300))
    return st.one_of(plain, near, scaled)


def rounded(value: Decimal, digits: int) -> Decimal:
    """The oracle: half up in absolute value, as the module rounds."""
    return Context(prec=digits, rounding=ROUND_HALF_UP, Emin=-(10**6), Emax=10**6).plus(value)


def decimal_of(q: mpq) -> Decimal:
    return WIDE.divide(Decimal(int(q.numerator)), Decimal(int(q.denominator)))


class TestRoundTrips:
    @few
    @given(rationals())
    def test_text(self, q: mpq) -> None:
        assert rational_from_text(text_from_rational(q)) == q == rational(text_from_rational(q))
        assert rational_from_text(f" {q.numerator}/{q.denominator}\n") == q

    @few
    @given(st.floats(allow_nan=False, allow_infinity=False))
    def test_doubles(self, x: float) -> None:
        assert float(rational_from_float(x)) == x
        assert rational_from_float(x) == Fraction(x)
        assert float(rational_from_text(repr(x))) == x

    @few
    @given(st.decimals(allow_nan=False, allow_infinity=False))
    def test_decimals_are_read_as_written(self, d: Decimal) -> None:
        assert rational_from_text(str(d)) == Fraction(d)

    @pytest.mark.parametrize("value", [3, "3", Fraction(3), mpq(3)])
    def test_what_rational_takes(self, value: int | str | Fraction | mpq) -> None:
        assert rational(value) == 3 and type(rational(value)) is type(mpq())

    def test_numbers_of_many_digits(self) -> None:
        # Python's own int() and str() refuse more than 4300 digits.
        text = "7" * 50_000
        q = rational_from_text(f"{text}/{text}1")
        assert text_from_rational(q) == f"{text}/{text}1"
        assert text_from_rational(rational_from_text(f"-0.{text}") * mpq(10) ** 50_000) == f"-{text}"


class TestReading:
    @pytest.mark.parametrize("text, value", [
        ("1", 1), ("+1.50", mpq(3, 2)), ("-.5", mpq(-1, 2)), ("5.", 5), ("1e5", 10**5),
        ("-3/6", mpq(-1, 2)), ("+3/6", mpq(1, 2)), ("-0", 0), ("0.1", mpq(1, 10)), ("1.25e+2", 125),
        ("0/5", 0), ("1E-3", mpq(1, 1000)),
        ("1e0000000000000000005", 10**5), ("0e100000", 0), ("\t2 \n", 2), ("007", 7),
    ])
    def test_accepted(self, text: str, value: mpq) -> None:
        assert rational_from_text(text) == value

    @pytest.mark.parametrize("text", [
        "", " ", ".", "-", "+", "e5", "1e", "1e+", ".e1", "--1", "+-1", "1_000", "1,5", "1 2", "0x10", "nan",
        "1/", "/2", "1/2/3", "1/-2", "1.5/2", "1/2e3", "1//2", "1/0", "-7/000", "٣", "½", "1\x00", "sqrt(2)",
        "True", "inf", "1e100001", "1e-100001", "1e99999999999999999999",
        "1.5.2", "1e1.5", "-inf", "1j", "1" * 50 + "x",
    ])
    def test_refused_with_the_place(self, text: str) -> None:
        with pytest.raises(FormatError) as caught:
            rational_from_text(text, "line 7")
        assert caught.value.place == "line 7" and str(caught.value).startswith("line 7: ")
        assert isinstance(caught.value, InputError) and len(str(caught.value)) < 150

    def test_the_largest_exponents(self) -> None:
        assert rational_from_text(f"1e{MAX_EXPONENT}") == mpq(10) ** MAX_EXPONENT
        assert rational_from_text(f"1e-{MAX_EXPONENT}") * mpq(10) ** MAX_EXPONENT == 1

    @pytest.mark.parametrize("value", [nan, inf, -inf])
    def test_doubles_that_are_no_numbers(self, value: float) -> None:
        with pytest.raises(FormatError) as caught:
            rational_from_float(value, "x of vertex 3")
        assert caught.value.place == "x of vertex 3" and "finite" in caught.value.reason


class TestForReaders:

    @few
    @given(rationals(), st.integers(1, 30))
    @example(mpq(999999, 10), 6)
    @example(mpq(457412, 7), 1)
    @example(mpq(10**8 + 1, 10**30), 1)
    @example(mpq(19, 2), 1)
    @example(mpq(-1, 8), 2)
    def test_decimal_text_is_rounded_half_up(self, q: mpq, digits: int) -> None:
        assert Decimal(decimal_text(q, digits)) == rounded(decimal_of(q), digits)


    @few
    @given(rationals(), st.integers(1, 30))
    @example(mpq(457412, 7), 1)
    @example(mpq(361, 4), 1)
    @example(mpq(2), 1)
    def test_sqrt_text_is_rounded_half_up(self, q: mpq, digits: int) -> None:
        assert Decimal(sqrt_text(abs(q), digits)) == rounded(WIDE.sqrt(decimal_of(abs(q))), digits)

    @pytest.mark.parametrize("q, digits, text", [
        (mpq(0), 5, "0"), (mpq(1, 3), 4, "0.3333"), (mpq(-2, 3), 4, "-0.6667"), (mpq(120), 5, "120"),
        (mpq(10) ** 20, 5, "100000000000000000000"), (mpq(10) ** 21, 5, "1e21"), (mpq(12345, 100), 3, "123"),
        (mpq(1, 10**5), 3, "0.00001"), (mpq(123, 10**9), 2, "1.2e-7"), (mpq(9999, 1000), 2, "10"),
        (mpq(1, 8), 3, "0.125"),
    ])
    def test_the_form_of_the_text(self, q: mpq, digits: int, text: str) -> None:
        assert decimal_text(q, digits) == text
        assert sqrt_text(q * q, digits) == text.lstrip("-")


class TestSquareRootFromBelow:
    @few
    @given(rationals().filter(lambda q: q != 0), st.integers(1, 200))
    @example(mpq(4), 1)
    @example(mpq(1) / 3, 2)
    @example(mpq(10) ** 2000 - 1, 53)
    @example(mpq(2) ** 106 - 1, 53)
    def test_the_bounds_hold_and_the_result_is_short(self, q: mpq, bits: int) -> None:
        q = abs(q)
        r = sqrt_below(q, bits)
        assert r > 0 and r * r <= q < (r * (1 + mpq(2) ** (1 - bits))) ** 2
        assert r.denominator & (r.denominator - 1) == 0
        odd = r.numerator >> ((r.numerator & -r.numerator).bit_length() - 1)
        assert odd.bit_length() <= bits

    @pytest.mark.parametrize("squared", [mpq(0), mpq(-1, 3)])
    def test_what_is_not_positive_is_refused(self, squared: mpq) -> None:
        with pytest.raises(ValueError, match="positive"):
            sqrt_below(squared, 53)
