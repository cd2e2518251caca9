"""Random expressions in + - * / and sqrt, evaluated in any number type, for the tests of exact numbers."""

from collections.abc import Callable
from typing import Any

from hypothesis import strategies as st

RADICANDS = (2, 3, 5, 6, 8, 10, 12, 18, 50)

Tree = tuple[Any, ...]


def leaves() -> st.SearchStrategy[Tree]:
    """Rationals and square roots of small integers, often dependent ones."""
    rationals = st.fractions(-4, 4, max_denominator=6).map(lambda q: ("rational", q))
    roots = st.sampled_from(RADICANDS).map(lambda n: ("root", ("rational", n)))
    return st.one_of(rationals, roots)


def sums() -> st.SearchStrategy[Tree]:
    """Elements of multiquadratic fields, without nested roots."""
    pairs = st.tuples(st.sampled_from("+-*/"), leaves(), leaves())
    return st.one_of(leaves(), pairs, st.tuples(st.sampled_from("+-*"), pairs, pairs))


def trees() -> st.SearchStrategy[Tree]:
    """Sums and products of such elements and of square roots of their absolute values."""
    nested = st.tuples(st.just("root"), st.tuples(st.sampled_from("+-"), leaves(), leaves()))
    part = st.one_of(leaves(), nested)
    return st.one_of(sums(), nested, st.tuples(st.sampled_from("+-*/"), part, part))


def value(
    tree: Tree, rational: Callable[[Any], Any], sqrt: Callable[[Any], Any], sign: Callable[[Any], int]
) -> Any:
    """Return the value of `tree`; a root is that of the absolute value, and x / 0 is taken as x."""
    operation, *arguments = tree
    if operation == "rational":
        return rational(arguments[0])
    x = value(arguments[0], rational, sqrt, sign)
    if operation == "root":
        return sqrt(-x if sign(x) < 0 else x)
    y = value(arguments[1], rational, sqrt, sign)
    match operation:
        case "+":
            return x + y
        case "-":
            return x - y
        case "*":
            return x * y
    return x / y if sign(y) else x
