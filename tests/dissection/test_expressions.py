"""Exact numbers as text: what is written is read back, what is no number is refused with a reason."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.dissection.expressions import MAX_LENGTH, ExpressionReader
from exactmesh.errors import FormatError
from exactmesh.numbers.algebraic import Real, sqrt

ROOTS = (2, 3, 5, 7)
VALUES = st.lists(st.tuples(st.fractions(max_denominator=99), st.sampled_from(ROOTS), st.sampled_from(ROOTS)),
                  max_size=4).map(lambda terms: sum((sqrt(m) * sqrt(n) * c for c, m, n in terms), Real(0)))


@given(VALUES)
def test_what_is_written_is_read_back(value: Real) -> None:
    assert ExpressionReader()(value.expression()) == value


@pytest.mark.parametrize("text, value", [
    ("3/2 + 5*sqrt(2)/4", Fraction(3, 2) + sqrt(2) * Fraction(5, 4)), ("-7", Real(-7)), ("0.125", Real(Fraction(1, 8))),
    ("22/7", Real(Fraction(22, 7))), ("2 - 3*(1 - 5)", Real(14)), ("--3", Real(3)), ("1/2/2", Real(Fraction(1, 4))),
    ("sqrt(2 - sqrt(3))", (sqrt(6) - sqrt(2)) / 2), (" ( 1 + sqrt ( 4 ) ) ", Real(3)), ("2*-3", Real(-6))])
def test_the_usual_rules_hold(text: str, value: Real) -> None:
    assert ExpressionReader()(text) == value


@pytest.mark.parametrize("text, reason", [
    ("", "ends too early"), ("1 +", "ends too early"), ("sqrt 2", "cannot be"), ("(1", "ends too early"),
    ("1)", "cannot be"), ("x", "cannot be"), ("2**3", "cannot be"), ("1e5", "cannot be"), ("sqrt(-1)", "negative"),
    ("1/(2 - 2)", "divides by zero"), ("1/0", "zero"), ("sqrtx(2)", "cannot be"), ("1/2/0", "by zero"),
    ("(" * 41 + "1" + ")" * 41, "nested"), ("1+" * MAX_LENGTH + "1", "too long"), ("1.2.3", "cannot be"),
    ("1/(" + "+".join(f"sqrt({p})" for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)) + ")", "roots"),
    ("__import__('os')", "cannot be"), ("٣", "cannot be")])
def test_what_is_no_exact_number_is_refused(text: str, reason: str) -> None:
    with pytest.raises(FormatError, match=reason):
        ExpressionReader()(text)
