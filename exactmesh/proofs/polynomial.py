"""Polynomials with rational coefficients in named variables: sums, products, values, text. Nothing is rounded.

`Polynomial.terms` maps monomials to nonzero coefficients; a monomial is the sorted tuple of its (name, exponent)
pairs with positive exponents. Equal polynomials have equal terms.
"""

import ast
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Union

from gmpy2 import mpq

Monomial = tuple[tuple[str, int], ...]
Scalar = Union["Polynomial", mpq, int]


class NotPolynomial(ValueError):
    """A text is no polynomial with rational coefficients."""


@dataclass(frozen=True)
class Polynomial:
    """A polynomial; made by `polynomial`, `variables` and arithmetic."""

    terms: Mapping[Monomial, mpq]

    def __add__(self, other: Scalar) -> "Polynomial":
        return _collect([*self.terms.items(), *polynomial(other).terms.items()])

    __radd__ = __add__

    def __neg__(self) -> "Polynomial":
        return Polynomial({monomial: -c for monomial, c in self.terms.items()})

    def __sub__(self, other: Scalar) -> "Polynomial":
        return self + -polynomial(other)

    def __rsub__(self, other: Scalar) -> "Polynomial":
        return polynomial(other) - self

    def __mul__(self, other: Scalar) -> "Polynomial":
        return _collect((_join(a, b), c * d) for a, c in self.terms.items() for b, d in polynomial(other).terms.items())

    __rmul__ = __mul__

    def __truediv__(self, other: mpq | int) -> "Polynomial":
        return self * polynomial(1 / mpq(other))

    def __pow__(self, exponent: int) -> "Polynomial":
        result = polynomial(1)
        for _ in range(exponent):
            result = result * self
        return result

    def in_order(self) -> list[tuple[Monomial, mpq]]:
        """Return the terms, higher degrees first."""
        return sorted(self.terms.items(), key=_order)

    def names(self) -> set[str]:
        """Return the variables that occur."""
        return {name for monomial in self.terms for name, _ in monomial}

    def degree(self, name: str) -> int:
        """Return the degree in one variable, 0 for the zero polynomial."""
        return max((dict(monomial).get(name, 0) for monomial in self.terms), default=0)

    def substitute(self, values: Mapping[str, Scalar]) -> "Polynomial":
        """Return the polynomial with some variables replaced."""
        result = Polynomial({})
        for monomial, c in self.terms.items():
            product = polynomial(c)
            for name, exponent in monomial:
                product = product * polynomial(values.get(name, Polynomial({((name, 1),): mpq(1)}))) ** exponent
            result = result + product
        return result

    def value(self, point: Mapping[str, mpq]) -> mpq:
        """Return the value at a point; raises `KeyError` when a variable has none."""
        total = mpq(0)
        for monomial, c in self.terms.items():
            for name, exponent in monomial:
                c = c * point[name] ** exponent
            total += c
        return total

    def __str__(self) -> str:
        parts = [_term(monomial, c) for monomial, c in self.in_order()]
        return " + ".join(parts).replace("+ -", "- ") or "0"


def polynomial(value: Scalar) -> Polynomial:
    """Return a number as a polynomial, a polynomial as it is."""
    if isinstance(value, Polynomial):
        return value
    return Polynomial({(): mpq(value)} if value else {})


def variables(names: str) -> list[Polynomial]:
    """Return the variables of the given names, which are separated by blanks."""
    return [Polynomial({((name, 1),): mpq(1)}) for name in names.split()]


def polynomial_from_text(text: str) -> Polynomial:
    """Return what a text such as `3/4*x*y**2 - (x - 1)**2` says; raises `NotPolynomial`."""
    try:
        return _from_node(ast.parse(text, mode="eval").body)
    except (SyntaxError, TypeError, ZeroDivisionError, RecursionError, MemoryError, ValueError) as error:
        raise NotPolynomial(f"no polynomial: {text[:60]!r}") from error


def _from_node(node: ast.expr) -> Polynomial:
    match node:
        case ast.Constant(value=int() as number) if not isinstance(number, bool):
            return polynomial(number)
        case ast.Name(id=name):
            return variables(name)[0]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_from_node(operand)
        case ast.BinOp(left=left, op=ast.Add(), right=right):
            return _from_node(left) + _from_node(right)
        case ast.BinOp(left=left, op=ast.Sub(), right=right):
            return _from_node(left) - _from_node(right)
        case ast.BinOp(left=left, op=ast.Mult(), right=right):
            return _from_node(left) * _from_node(right)
        case ast.BinOp(left=left, op=ast.Div(), right=ast.Constant(value=int() as divisor)):
            return _from_node(left) / divisor
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(value=int() as exponent)) if 0 <= exponent <= 64:
            return _from_node(left) ** exponent
    raise TypeError(f"unexpected {type(node).__name__}")


def _collect(terms: Iterable[tuple[Monomial, mpq]]) -> Polynomial:
    total: dict[Monomial, mpq] = {}
    for monomial, c in terms:
        total[monomial] = total.get(monomial, mpq(0)) + c
    return Polynomial({monomial: c for monomial, c in total.items() if c})


def _join(a: Monomial, b: Monomial) -> Monomial:
    if not a or not b:
        return a or b
    exponents = dict(a)
    for name, exponent in b:
        exponents[name] = exponents.get(name, 0) + exponent
    return tuple(sorted(exponents.items()))


def _order(term: tuple[Monomial, mpq]) -> tuple[int, Monomial]:
    return -sum(exponent for _, exponent in term[0]), term[0]


def _term(monomial: Monomial, c: mpq) -> str:
    factors = [name if exponent == 1 else f"{name}**{exponent}" for name, exponent in monomial]
    if abs(c) != 1 or not factors:
        return "*".join([str(c), *factors])
    return ("-" if c < 0 else "") + "*".join(factors)
