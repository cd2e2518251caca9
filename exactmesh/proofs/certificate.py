"""Re-check certificates: that no real point satisfies a list of polynomial constraints. Rational arithmetic only.

A certificate is a tree in JSON. Assumptions are numbered from 0; a case appends one.

combination  `terms` [c, [i, ..], square]: c > 0 times assumptions i, .. (not negative), times the square of a
             polynomial where one is given; `equalities` [i, multiplier]: an assumption p == 0 times any polynomial.
             All together are the zero polynomial, although one term without a square has positive assumptions only.
cases        `on`, a constraint >= or >: certificates when it `holds`, and when it `fails`.
boxes        Every variable has a lower bound among the assumptions, most an upper one. x = low + (high - low) t, or
             low + t/(1 - t) where there is no upper bound, makes the unit box of them. `tree` in preorder: -1-k halves
             the box across the k-th of `variables`, i >= 0 says that assumption i is violated throughout the box,
             because its Bernstein coefficients there, between which all values lie, have the wrong sign.

The opposite is a counterexample: a rational point that satisfies all assumptions.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from math import comb
from typing import Any, Literal

from gmpy2 import mpq

from exactmesh.proofs.polynomial import Monomial, NotPolynomial, Polynomial, polynomial, polynomial_from_text, variables

Relation = Literal[">=", ">", "=="]
Cell = tuple[tuple[mpq, mpq], ...]


class Refused(Exception):
    """A certificate does not show what it should."""


@dataclass(frozen=True)
class Constraint:
    """`polynomial` `relation` 0."""

    polynomial: Polynomial
    relation: Relation

    def holds(self, point: Mapping[str, mpq]) -> bool:
        """Return whether the constraint is satisfied at a point."""
        value = self.polynomial.value(point)
        return bool({">=": value >= 0, ">": value > 0, "==": value == 0}[self.relation])

    def negated(self) -> "Constraint":
        """Return the opposite of an inequality; raises `Refused` for an equality."""
        if self.relation == "==":
            raise Refused("an equality has no single opposite")
        return Constraint(-self.polynomial, ">" if self.relation == ">=" else ">=")

    def __str__(self) -> str:
        return f"{self.polynomial} {self.relation} 0"


def constraint_from_text(text: str) -> Constraint:
    """Return the constraint that a text like `x*y - 1 >= 0` says; raises `Refused`."""
    relations: tuple[Relation, ...] = (">=", ">", "==")
    for relation in relations:
        if text.endswith(f" {relation} 0"):
            return Constraint(_parsed(text.removesuffix(f" {relation} 0")), relation)
    raise Refused(f"no constraint: {text[:60]!r}")


def refute(assumptions: Sequence[Constraint], certificate: Mapping[str, Any]) -> None:
    """Return when the certificate shows that the assumptions contradict each other; raises `Refused` when not."""
    open_cases: list[tuple[list[Constraint], Any]] = [(list(assumptions), certificate)]
    while open_cases:
        given, node = open_cases.pop()
        try:
            match node:
                case {"kind": "combination", "terms": terms, "equalities": equalities}:
                    _check_combination(given, terms, equalities)
                case {"kind": "cases", "on": str(on), "holds": holds, "fails": fails}:
                    case = constraint_from_text(on)
                    open_cases += [([*given, case], holds), ([*given, case.negated()], fails)]
                case {"kind": "boxes", "variables": names, "tree": tree}:
                    _check_boxes(given, names, tree)
                case _:
                    raise Refused("no certificate, or one of an unknown kind")
        except (TypeError, ValueError, KeyError, IndexError, ArithmeticError) as error:
            raise Refused(f"malformed certificate: {error}") from error


def satisfy(assumptions: Sequence[Constraint], point: Mapping[str, str]) -> None:
    """Return when the point satisfies the assumptions; raises `Refused` when not."""
    try:
        place = {name: mpq(value) for name, value in point.items()}
        broken = [str(c) for c in assumptions if not c.holds(place)]
    except (TypeError, ValueError, KeyError, AttributeError, ArithmeticError) as error:
        raise Refused(f"malformed point: {error}") from error
    if broken:
        raise Refused(f"the point does not satisfy {broken[0]}")


def _parsed(text: str) -> Polynomial:
    try:
        return polynomial_from_text(text)
    except NotPolynomial as error:
        raise Refused(str(error)) from error


def _assumption(given: Sequence[Constraint], index: int) -> Constraint:
    if not isinstance(index, int) or isinstance(index, bool) or not 0 <= index < len(given):
        raise Refused(f"there is no assumption {index}")
    return given[index]


def _check_combination(given: Sequence[Constraint], terms: Sequence[Any], equalities: Sequence[Any]) -> None:
    total = polynomial(0)
    positive = False
    for c, factors, square in terms:
        term = polynomial(mpq(c))
        if mpq(c) <= 0:
            raise Refused("a coefficient is not positive")
        chosen = [_assumption(given, index) for index in factors]
        for factor in chosen:
            term = term * factor.polynomial
        if square is not None:
            term = term * _parsed(square) ** 2
        positive = positive or (square is None and all(factor.relation == ">" for factor in chosen))
        total = total + term
    for index, multiplier in equalities:
        equality = _assumption(given, index)
        if equality.relation != "==":
            raise Refused("only an equality may have any multiplier")
        total = total + equality.polynomial * _parsed(multiplier)
    if not positive:
        raise Refused("no term is positive")
    if total.terms:
        raise Refused("the combination is not zero")


def _check_boxes(given: Sequence[Constraint], names: Sequence[str], tree: Sequence[int]) -> None:
    if len(set(names)) != len(names) or not set(names) >= set().union(*(c.polynomial.names() for c in given)):
        raise Refused("the variables of the box are not those of the assumptions")
    unit = [Constraint(to_unit_box(c.polynomial, given, names), c.relation) for c in given]
    cells: list[Cell] = [((mpq(0), mpq(1)),) * len(names)]
    for token in tree:
        if not cells:
            raise Refused("the tree goes on after its last box")
        cell = cells.pop()
        if token >= 0:
            if not is_violated(_assumption(unit, token), names, cell):
                raise Refused("an assumption is not violated throughout its box")
        else:
            cells += reversed(halves(cell, -1 - token))
    if cells:
        raise Refused("a box is left out")


def bounds(given: Sequence[Constraint], name: str) -> tuple[mpq | None, mpq | None]:
    """Return the best lower and upper bounds of a variable among the assumptions of the form c x + d >= 0 or > 0."""
    lows: list[mpq] = []
    highs: list[mpq] = []
    for c in given:
        if c.relation != "==" and c.polynomial.names() == {name} and c.polynomial.degree(name) == 1:
            slope, start = c.polynomial.terms[((name, 1),)], c.polynomial.terms.get((), mpq(0))
            (lows if slope > 0 else highs).append(-start / slope)
    return max(lows, default=None), min(highs, default=None)


def to_unit_box(p: Polynomial, given: Sequence[Constraint], names: Sequence[str]) -> Polynomial:
    """Return a polynomial in t, of the same sign as p in x at all t below 1; the letters stay."""
    for name in names:
        low, high = bounds(given, name)
        if low is None:
            raise Refused(f"{name} has no lower bound")
        t = variables(name)[0]
        if high is not None:
            p = p.substitute({name: low + (high - low) * t})
        else:
            degree = p.degree(name)
            powers = [(low * (1 - t) + t) ** k * (1 - t) ** (degree - k) for k in range(degree + 1)]
            p = sum((powers[dict(monomial).get(name, 0)] * _without(monomial, c, name)
                     for monomial, c in p.terms.items()), polynomial(0))
    return p


def _without(monomial: Monomial, c: mpq, name: str) -> Polynomial:
    return Polynomial({tuple(factor for factor in monomial if factor[0] != name): c})


def halves(cell: Cell, k: int) -> list[Cell]:
    """Return the two halves of a box across its k-th variable."""
    if not 0 <= k < len(cell):
        raise Refused(f"the box has no side {k}")
    low, high = cell[k]
    middle = (low + high) / 2
    return [(*cell[:k], part, *cell[k + 1:]) for part in ((low, middle), (middle, high))]


def is_violated(constraint: Constraint, names: Sequence[str], cell: Cell) -> bool:
    """Return whether Bernstein coefficients show that the constraint fails all over the box, t = 1 aside."""
    values = bernstein(constraint.polynomial, names, cell)
    match constraint.relation:
        case ">=":
            return all(value < 0 for value in values)
        case ">":
            return all(value <= 0 for value in values)
    return all(value < 0 for value in values) or all(value > 0 for value in values)


def bernstein(p: Polynomial, names: Sequence[str], cell: Cell) -> list[mpq]:
    """Return the Bernstein coefficients of p on a box: the values of p there lie between the least and the greatest."""
    tensor: dict[tuple[int, ...], mpq] = {
        tuple(dict(monomial).get(name, 0) for name in names): c for monomial, c in p.terms.items()}
    degrees = [p.degree(name) for name in names]
    for k, (n, (low, high)) in enumerate(zip(degrees, cell, strict=True)):
        # The coefficient of index j of x^m is its polar form at j times `high` and n - j times `low`.
        rows = [[sum((comb(j, i) * comb(n - j, m - i) * high**i * low**(m - i) for i in range(m + 1)), mpq(0))
                 / comb(n, m) for j in range(n + 1)] for m in range(n + 1)]
        changed: dict[tuple[int, ...], mpq] = {}
        for index, c in tensor.items():
            for j, weight in enumerate(rows[index[k]]):
                key = (*index[:k], j, *index[k + 1:])
                changed[key] = changed.get(key, mpq(0)) + c * weight
        tensor = changed
    return [tensor.get(index, mpq(0)) for index in product(*(range(n + 1) for n in degrees))]
