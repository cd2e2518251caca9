"""Find certificates and points. Nothing here is trusted: what is found is re-checked by `exactmesh.proofs`.

Combinations are found by linear programming in floating point over products of assumptions; the columns that are used
are then solved for exactly. Boxes are halved until Bernstein coefficients decide. Points come from z3.
"""

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gmpy2 import mpq

from exactmesh.proofs.certificate import (
    Cell,
    Constraint,
    Refused,
    bernstein,
    halves,
    is_violated,
    refute,
    to_unit_box,
)
from exactmesh.proofs.polynomial import Polynomial, polynomial
from exactmesh.proofs.problem import Problem


@dataclass(frozen=True)
class Hint:
    """How to look for a certificate.

    `cases` are split on in turn before anything else. `degrees` are the total degrees of combinations to try;
    `squares` are polynomials whose squares may be factors. `cells` limits the boxes, none: no boxes.
    """

    cases: tuple[Constraint, ...] = ()
    degrees: tuple[int, ...] = ()
    squares: tuple[Polynomial, ...] = ()
    cells: int = 0
    columns: int = 12000
    given: Mapping[str, Any] | None = None


PLAIN = Hint()


def find(assumptions: Sequence[Constraint], hint: Hint) -> Mapping[str, Any] | None:
    """Return a certificate that re-checks, or None."""
    node = hint.given or _find(list(assumptions), hint, hint.cases)
    if node is None:
        return None
    refute(assumptions, node)
    return node


def _find(given: list[Constraint], hint: Hint, cases: Sequence[Constraint]) -> dict[str, Any] | None:
    if cases:
        first, rest = cases[0], cases[1:]
        holds = _find([*given, first], hint, rest)
        fails = _find([*given, first.negated()], hint, rest) if holds else None
        return {"kind": "cases", "on": str(first), "holds": holds, "fails": fails} if fails else None
    for i, c in enumerate(given):
        constant = c.polynomial.terms.get((), mpq(0))
        if c.polynomial == polynomial(constant) and c.relation == ">" and constant == 0:
            return {"kind": "combination", "terms": [["1", [i], None]], "equalities": []}
        if c.polynomial == polynomial(constant) and c.relation != "==" and constant < 0:
            return {"kind": "combination", "terms": [["1", [i], None], [str(-constant), [], None]], "equalities": []}
    top = max(_degree(c.polynomial) for c in given)
    for degree in hint.degrees or (top, top + 1, top + 2):
        node = combination(given, degree, hint.squares, hint.columns)
        if node is not None:
            return node
    return boxes(given, hint.cells) if hint.cells else None


def _degree(p: Polynomial) -> int:
    return max((sum(exponent for _, exponent in monomial) for monomial in p.terms), default=0)


def _products(given: Sequence[Constraint], degree: int, start: int = 0) -> Iterator[tuple[list[int], Polynomial]]:
    """Yield the products of inequalities of total degree at most `degree`."""
    yield [], polynomial(1)
    for i in range(start, len(given)):
        own = _degree(given[i].polynomial)
        if given[i].relation != "==" and 0 < own <= degree:
            for factors, p in _products(given, degree - own, i):
                yield [i, *factors], p * given[i].polynomial


def combination(given: Sequence[Constraint], degree: int, squares: Sequence[Polynomial], most: int
                ) -> dict[str, Any] | None:
    """Return a combination of that total degree, or None."""
    import numpy as np
    from scipy.optimize import linprog
    from scipy.sparse import csc_matrix

    homogeneous = all(len({sum(e for _, e in m) for m in c.polynomial.terms}) <= 1 for c in given)
    columns: list[tuple[list[int], Polynomial | None, Polynomial]] = []
    for factors, p in _products(given, degree):
        if not homogeneous or _degree(p) == degree:
            columns.append((factors, None, p))
        columns += [(factors, s, p * s * s) for s in squares if _degree(p) + 2 * _degree(s) <= degree
                    and (not homogeneous or _degree(p) + 2 * _degree(s) == degree)]
        if len(columns) > most:
            return None
    names = sorted(set().union(*(c.polynomial.names() for c in given)))
    free: list[tuple[int, Polynomial, Polynomial]] = []
    for i, c in enumerate(given):
        if c.relation == "==":
            free += [(i, m, c.polynomial * m) for m in _monomials(names, degree - _degree(c.polynomial))]
    polynomials = [p for _, _, p in columns] + [p for _, _, p in free]
    rows = {m: k for k, m in enumerate(sorted({m for p in polynomials for m in p.terms}))}
    strict = [s is None and all(given[i].relation == ">" for i in factors) for factors, s, _ in columns]
    if not any(strict):
        return None
    data, at, which = [], [], []
    for k, p in enumerate(polynomials):
        size = max((abs(c) for c in p.terms.values()), default=mpq(1))
        for m, c in p.terms.items():
            data.append(float(c / size))
            at.append(rows[m])
            which.append(k)
        if k < len(strict) and strict[k]:
            data.append(1.0)
            at.append(len(rows))
            which.append(k)
    matrix = csc_matrix((data, (at, which)), shape=(len(rows) + 1, len(polynomials)))
    wanted = np.zeros(len(rows) + 1)
    wanted[-1] = 1
    limits = [(0, None)] * len(columns) + [(None, None)] * len(free)
    cost = np.array([1.0 + len(f) for f, _, _ in columns] + [0.0] * len(free))
    result = linprog(cost, A_eq=matrix, b_eq=wanted, bounds=limits, method="highs-ds", options={"time_limit": 60})
    if result.x is None or result.status != 0:
        return None
    for cut in (1e-9, 1e-7, 1e-11):
        used = [k for k, x in enumerate(result.x) if abs(x) > cut]
        exact = _solve([polynomials[k] for k in used], [k < len(strict) and strict[k] for k in used])
        if exact is not None and all(x > 0 for k, x in zip(used, exact, strict=True) if k < len(columns)):
            break
    else:
        return None
    terms = [[str(x), columns[k][0], None if columns[k][1] is None else str(columns[k][1])]
             for k, x in zip(used, exact, strict=True) if k < len(columns)]
    multipliers: dict[int, Polynomial] = {}
    for k, x in zip(used, exact, strict=True):
        if k >= len(columns):
            i, m, _ = free[k - len(columns)]
            multipliers[i] = multipliers.get(i, polynomial(0)) + m * x
    node = {"kind": "combination", "terms": terms, "equalities": [[i, str(p)] for i, p in multipliers.items()]}
    try:
        refute(given, node)
    except Refused:
        return None
    return node


def _monomials(names: Sequence[str], degree: int) -> list[Polynomial]:
    found = [polynomial(1)]
    for name in names:
        x = Polynomial({((name, 1),): mpq(1)})
        found = [m * x**k for m in found for k in range(degree + 1) if _degree(m) + k <= degree]
    return found


def _solve(polynomials: Sequence[Polynomial], strict: Sequence[bool]) -> list[mpq] | None:
    """Return the one exact solution of sum x_k p_k = 0 with the strict x_k summing to 1; None if there is not one."""
    width = len(polynomials)
    table = [[p.terms.get(m, mpq(0)) for p in polynomials] + [mpq(0)]
             for m in sorted({m for p in polynomials for m in p.terms})]
    table.append([mpq(1 if s else 0) for s in strict] + [mpq(1)])
    row = 0
    for column in range(width):
        pivot = next((r for r in range(row, len(table)) if table[r][column]), None)
        if pivot is None:
            return None
        table[row], table[pivot] = table[pivot], table[row]
        lead = table[row][column]
        table[row] = [x / lead for x in table[row]]
        for r in range(len(table)):
            if r != row and table[r][column]:
                factor = table[r][column]
                table[r] = [x - factor * y for x, y in zip(table[r], table[row], strict=True)]
        row += 1
    if any(line[width] for line in table[row:]):
        return None
    return [table[k][width] for k in range(width)]


def boxes(given: Sequence[Constraint], most: int) -> dict[str, Any] | None:
    """Return a tree of at most that many boxes, or None."""
    names = sorted(set().union(*(c.polynomial.names() for c in given)))
    try:
        unit = [Constraint(to_unit_box(c.polynomial, given, names), c.relation) for c in given]
    except Refused:
        return None
    tree: list[int] = []
    cells: list[tuple[Cell, int]] = [(((mpq(0), mpq(1)),) * len(names), 0)]
    while cells:
        if len(tree) + len(cells) > most or cells[-1][1] > 60:
            return None
        cell, depth = cells.pop()
        decided = next((i for i, c in enumerate(unit) if is_violated(c, names, cell)), None)
        if decided is not None:
            tree.append(decided)
            continue
        k = _side(unit, names, cell)
        tree.append(-1 - k)
        cells += [(half, depth + 1) for half in reversed(halves(cell, k))]
    return {"kind": "boxes", "variables": names, "tree": tree}


def _side(unit: Sequence[Constraint], names: Sequence[str], cell: Cell) -> int:
    """Return the side to halve: the one along which the most nearly violated assumptions vary most."""
    scores = [0.0] * len(names)
    for c in unit:
        values = [float(v) for v in bernstein(c.polynomial, names, cell)]
        size = max(abs(v) for v in values)
        if not size:
            continue
        weight = 1.0 / (0.02 + max(0.0, max(values) / size)) ** 2
        degrees = [c.polynomial.degree(name) for name in names]
        step = 1
        for k in range(len(names) - 1, -1, -1):
            n = degrees[k] + 1
            if n > 1:
                spread = max(abs(values[j + step] - values[j]) for j in range(len(values)) if (j // step) % n < n - 1)
                scores[k] += weight * spread / size
            step *= n
    return max(range(len(names)), key=lambda k: (scores[k], cell[k][1] - cell[k][0]))


def example_of(constraints: Sequence[Constraint], seconds: float = 10) -> dict[str, mpq] | None:
    """Return a rational point that satisfies the constraints, or None when none was found."""
    import z3

    problem = Problem("example", "", tuple(constraints), None)
    script = problem.smt_lib()
    for _ in range(2):
        solver = z3.SolverFor("QF_NRA")
        solver.set("timeout", int(seconds * 1000))
        solver.from_string(script)
        if solver.check() != z3.sat:
            return None
        model = solver.model()
        values = {d.name(): model[d] for d in model.decls()}
        for digits in (0, 2, 4, 8, 16, 30):
            point = {name: _rational(values.get(name), digits) for name in problem.names()}
            if all(c.holds(point) for c in constraints):
                return point
        # An algebraic model on the boundary: move off it.
        if any(c.relation == ">=" for c in constraints):
            constraints_inside = tuple(Constraint(c.polynomial, ">" if c.relation == ">=" else c.relation)
                                       for c in constraints)
            script = Problem("example", "", constraints_inside, None).smt_lib()
    return None


def _rational(value: Any, digits: int) -> mpq:
    import z3

    if value is None:
        return mpq(1)
    if z3.is_rational_value(value):
        return mpq(value.numerator_as_long(), value.denominator_as_long())
    near = value.approx(40)
    exact = Fraction(near.numerator_as_long(), near.denominator_as_long())
    return mpq(exact.limit_denominator(10**digits) if digits else Fraction(round(exact)))


def timed(action: Any) -> tuple[Any, float]:
    """Return what an action gives and the seconds it took."""
    start = time.monotonic()
    return action(), time.monotonic() - start
