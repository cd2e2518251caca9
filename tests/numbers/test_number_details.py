"""Numbers in detail: messages, defaults, limits, and the paths that broad laws do not tell apart."""

import pytest
from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.numbers.rational import (
    decimal_text,
    rational,
    rational_from_float,
    rational_from_text,
    sqrt_below,
    sqrt_text,
)


class TestRational:
    @pytest.mark.parametrize("text, reason", [
        ("x", "'x' is not an integer, a finite decimal or a fraction p/q"),
        ("1/0", "denominator of '1/0' is zero"),
        ("1e100001", "the exponent of '1e100001' is beyond 100000"),
        ("y" * 40, f"'{'y' * 40}' is not an integer, a finite decimal or a fraction p/q"),
        ("y" * 41, f"'{'y' * 37}...' is not an integer, a finite decimal or a fraction p/q")])
    def test_a_refusal_quotes_what_it_refuses_and_says_why(self, text: str, reason: str) -> None:
        for read in (rational, rational_from_text):
            with pytest.raises(FormatError) as caught:
                read(text)
            assert caught.value.reason == str(caught.value) == reason

    def test_a_double_without_a_place_is_refused_by_its_value(self) -> None:
        with pytest.raises(FormatError, match=r"^inf is not a finite number$"):
            rational_from_float(float("inf"))

    def test_an_exponent_of_zeros(self) -> None:
        assert rational_from_text("5e0") == rational_from_text("5e+00") == rational_from_text("5E-000") == 5

    def test_twelve_digits_unless_told_otherwise(self) -> None:
        assert decimal_text(mpq(1, 3)) == "0." + "3" * 12
        assert sqrt_text(mpq(1, 9)) == "0." + "3" * 12

    @pytest.mark.parametrize("value, digits, text", [
        (mpq(1, 10**5), 1, "0.00001"), (mpq(1, 10**6), 1, "1e-6"), (mpq(12, 10**7), 3, "1.2e-6"),
        (mpq(12), 1, "10"), (mpq(123), 3, "123"), (mpq(10**20), 1, "1" + 20 * "0"), (mpq(10**21), 1, "1e21"),
        (mpq(1234 * 10**18), 4, "1.234e21"), (mpq(123 * 10**18), 3, "123" + 18 * "0")])
    def test_where_the_point_stands(self, value: mpq, digits: int, text: str) -> None:
        assert decimal_text(value, digits) == text
        assert decimal_text(-value, digits) == f"-{text}"

    def test_a_root_from_below_has_at_least_one_bit(self) -> None:
        assert sqrt_below(mpq(3), 1) == 1 and sqrt_below(mpq(2), 2) == 1 and sqrt_below(mpq(2), 3) == mpq(5, 4)
        for squared, bits in ((mpq(0), 3), (mpq(2), 0), (mpq(2), -1)):
            with pytest.raises(ValueError, match=f"^squared and bits must be positive, not {squared} and {bits}$"):
                sqrt_below(squared, bits)

    @pytest.mark.parametrize("scale", range(-9, 10))
    def test_a_root_from_below_is_the_longest_that_fits(self, scale: int) -> None:
        for numerator in (1, 2, 3, 5, 7, 15, 16, 17):
            squared = numerator * mpq(2) ** scale
            r = sqrt_below(squared, 4)
            unit = max(mpq(2) ** k for k in range(-12, 12) if r >= 8 * mpq(2) ** k)
            assert (r / unit).denominator == 1 and r * r <= squared < (r + unit) ** 2 and r < 16 * unit
