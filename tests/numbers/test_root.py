"""Roots of squares as exact expressions."""

from decimal import Decimal
from math import isclose, sqrt

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.numbers.rational import rational
from exactmesh.numbers.root import root_expression

few = settings(max_examples=200, deadline=None, derandomize=True)
positive = st.builds(mpq, st.integers(0, 10**40), st.integers(1, 10**40))


@pytest.mark.parametrize(("squared", "text"), [
    ("0", "0"), ("1", "1"), ("4", "2"), ("9/4", "3/2"), ("1/2", "sqrt(1/2)"), ("2", "sqrt(2)"),
    ("8", "sqrt(8)"), ("4/3", "sqrt(4/3)"), ("3/4", "sqrt(3/4)"), ("1e-60", f"1/1{'0' * 30}")])
def test_a_square_gets_its_root_and_anything_else_an_expression(squared: str, text: str) -> None:
    assert root_expression(rational(squared)) == text


@few
@given(positive)
def test_the_root_of_a_square_is_written_without_an_expression(root: mpq) -> None:
    assert mpq(root_expression(root * root)) == root


@few
@given(positive)
def test_the_expression_says_what_is_under_the_root(squared: mpq) -> None:
    text = root_expression(squared)
    if text.startswith("sqrt("):
        assert mpq(text[5:-1]) == squared
        assert isclose(eval(text, {"sqrt": sqrt}), float(Decimal(int(squared.numerator)).sqrt()
                                                         / Decimal(int(squared.denominator)).sqrt()))
    else:
        assert mpq(text) ** 2 == squared


def test_one_more_than_a_large_square_is_no_square() -> None:
    square = mpq(10**40) ** 2
    assert root_expression(square) == str(10**40)
    assert root_expression(square + 1) == f"sqrt({10**80 + 1})"
