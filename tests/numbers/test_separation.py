"""`exactmesh.numbers.separation`: signs by ball arithmetic and a root bound, and harm done to the bound."""

from fractions import Fraction
from math import comb
from pathlib import Path
from typing import Any

import pytest
from algebraic_values import sums, trees, value
from gmpy2 import mpq
from hypothesis import given, settings
from sympy import Rational, Symbol, minimal_polynomial
from sympy import sqrt as sympy_sqrt

from exactmesh.numbers import separation
from exactmesh.numbers.separation import Expr, Undecided, separation_bits

few = settings(max_examples=60, deadline=None, derandomize=True)


def root(n: int | Fraction | mpq) -> Expr:
    return Expr(n).sqrt()


ZEROS = [
    Expr(0),
    root(2) * root(3) - root(6),
    (5 + 2 * root(6)).sqrt() - root(2) - root(3),
    (2 - root(2)).sqrt() * (2 + root(2)).sqrt() - root(2),
    root(mpq(1, 2)) - root(2) / 2,
    1 / (1 + root(2)) - root(2) + 1,
    (root(6) - root(2) * root(3)).sqrt(),
    (16 - 2 * root(29) + 2 * (55 - 10 * root(29)).sqrt()).sqrt()
    - (22 + 2 * root(5)).sqrt() + (11 + 2 * root(29)).sqrt() - root(5),
]


@pytest.mark.parametrize("zero", ZEROS)
@pytest.mark.parametrize("digits", [0, 10, 100, 1000])
def test_zero_is_told_from_what_is_next_to_it(zero: Expr, digits: int) -> None:
    assert zero.sign() == 0
    assert (zero + Fraction(1, 10**digits)).sign() == 1 and (zero - mpq(1, 10**digits)).sign() == -1


@pytest.mark.parametrize("order", range(1, 13))
def test_differences_of_roots_have_the_sign_of_the_derivative(order: int) -> None:
    n = 10**6 - 20
    x = Expr(0)
    for i in range(order + 1):
        x = x + (-1) ** (order - i) * comb(order, i) * root(n + i)
    assert x.sign() == (-1) ** (order - 1)


@few
@given(trees())
def test_negation_and_squares(tree: Any) -> None:
    x = value(tree, Expr, Expr.sqrt, Expr.sign)
    assert (0 - x).sign() == -x.sign() and (x * x).sign() == x.sign() ** 2
    assert ((x * x).sqrt() - (x if x.sign() >= 0 else 0 - x)).sign() == 0


@settings(max_examples=12, deadline=None, derandomize=True)
@given(sums())
def test_no_conjugate_is_nearer_to_zero_than_the_bound(tree: Any) -> None:
    x = value(tree, Expr, Expr.sqrt, Expr.sign)
    exact = value(tree, lambda q: Rational(str(q)), sympy_sqrt, lambda v: _expr_of(v).sign())
    bits = separation_bits(x, _roots(tree))
    roots = minimal_polynomial(exact, Symbol("x"), polys=True).nroots(n=60)
    assert all(abs(r) < 1e-40 or abs(r) * 2**bits >= 1 for r in roots)


def _roots(tree: Any) -> int:
    return (tree[0] == "root") + sum(_roots(t) for t in tree[1:] if isinstance(t, tuple))


def _expr_of(v: Any) -> Expr:
    """Return a SymPy number made of sums, products and square roots as an `Expr`."""
    if v.is_Rational:
        return Expr(Fraction(int(v.p), int(v.q)))
    if v.is_Pow:
        base = _expr_of(v.base)
        inverse = v.exp < 0
        base = base.sqrt() if abs(v.exp) == Rational(1, 2) else base
        return 1 / base if inverse else base
    result, *rest = (_expr_of(part) for part in v.args)
    for part in rest:
        result = result + part if v.is_Add else result * part
    return result


def test_a_chain_of_thirty_thousand_additions() -> None:
    x, s = Expr(0), root(2)
    for _ in range(30_000):
        x = x + s
    assert x.sign() == 1 and (x - 30_000 * root(2)).sign() == 0 and (x - 30_000 * root(3)).sign() == -1


def test_what_has_no_value_is_refused() -> None:
    with pytest.raises(ZeroDivisionError):
        (1 / (root(2) * root(3) - root(6))).sign()
    with pytest.raises(ValueError, match="negative"):
        (root(2) - root(3)).sqrt().sign()
    with pytest.raises(TypeError):
        Expr(1) + 0.5


def test_giving_up_says_so() -> None:
    with pytest.raises(Undecided) as caught:
        (root(10**200 + 1) - 10**100).sign(max_bits=512)
    assert caught.value.bits == 512
    assert (root(10**200 + 1) - 10**100).sign(max_bits=1024) == 1


def laws() -> None:
    assert (root(2) * root(3) - root(6)).sign() == 0
    assert (root(10**200 + 1) - 10**100).sign() == 1
    x = 1 / (1 + root(10**40)) - 1 / (1 + root(10**40 + 1))
    assert x.sign() == 1 and (root(mpq(1, 10**80)) - mpq(1, 10**40)).sign() == 0


@pytest.mark.parametrize("bits", [lambda x, roots: 1, lambda x, roots: x.log_l, lambda x, roots: 60])
def test_a_bound_that_is_too_large_is_noticed(bits: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    laws()
    monkeypatch.setattr(separation, "separation_bits", bits)
    with pytest.raises((AssertionError, ZeroDivisionError)):
        laws()


def test_the_bound_does_not_use_the_exact_types() -> None:
    source = Path(separation.__file__).read_text()
    assert "from exactmesh" not in source and "import exactmesh" not in source
