"""A second, independent way to the sign of an expression in + - * / and square roots, for checkers.

Nothing of the exact types is imported: an expression is evaluated in Arb's ball arithmetic (python-flint) at
64, 128, 256, ... bits until its ball leaves zero, or lies so close to zero that only zero itself is left.

How close is said by the separation bound of Burnikel, Funke, Mehlhorn, Schirra and Schmitt, "A separation
bound for real algebraic expressions" (ESA 2001). A value is written U/L with algebraic integers U, L; u and l
bound the absolute values of all their conjugates:

    integer n        u = |n|               l = 1
    x + y, x - y     u = ux*ly + lx*uy     l = lx*ly
    x * y            u = ux*uy             l = lx*ly
    x / y            u = ux*ly             l = lx*uy
    sqrt(x)          u = sqrt(ux*lx), l = lx    or    u = ux, l = sqrt(ux*lx)

With r square roots U lies in a field of degree at most D = 2**r, and if it is not zero then the product of
its conjugates is a nonzero integer: |U| * u**(D - 1) >= 1, so |U/L| >= 1 / (l * u**(D - 1)). Logarithms are
rounded up.
"""

from fractions import Fraction
from typing import Any

from flint import arb, ctx, fmpq

MAX_BITS = 1 << 20


class Undecided(ArithmeticError):
    """A sign needs more than `bits` bits; nothing is known of it."""

    def __init__(self, bits: int) -> None:
        super().__init__(f"the sign is not decided at {bits} bits")
        self.bits = bits


class Expr:
    """A node: a rational, or an operation on earlier nodes. Use a node again, and its roots count once."""

    __slots__ = ("arguments", "log_l", "log_u", "operation", "value")

    def __init__(self, value: Any, operation: str = "", arguments: tuple["Expr", ...] = ()) -> None:
        """Make a leaf of an int, Fraction or mpq; the other parameters are for this module."""
        self.operation, self.arguments = operation, arguments
        if not operation:
            numerator, denominator = int(value.numerator), int(value.denominator)
            self.value = fmpq(numerator, denominator)
            self.log_u, self.log_l = numerator.bit_length(), denominator.bit_length()
            if denominator == 1:
                self.log_l = 0
            return
        x, y = arguments[0], arguments[-1]
        if operation in "+-":
            self.log_u, self.log_l = 1 + max(x.log_u + y.log_l, x.log_l + y.log_u), x.log_l + y.log_l
        elif operation == "*":
            self.log_u, self.log_l = x.log_u + y.log_u, x.log_l + y.log_l
        elif operation == "/":
            self.log_u, self.log_l = x.log_u + y.log_l, x.log_l + y.log_u
        else:
            half = -(-(x.log_u + x.log_l) // 2)
            self.log_u, self.log_l = (half, x.log_l) if x.log_u >= x.log_l else (x.log_u, half)

    def __add__(self, other: Any) -> "Expr":
        return Expr(None, "+", (self, _expr(other)))

    def __sub__(self, other: Any) -> "Expr":
        return Expr(None, "-", (self, _expr(other)))

    def __mul__(self, other: Any) -> "Expr":
        return Expr(None, "*", (self, _expr(other)))

    def __truediv__(self, other: Any) -> "Expr":
        return Expr(None, "/", (self, _expr(other)))

    def __neg__(self) -> "Expr":
        return Expr(0) - self

    def __radd__(self, other: Any) -> "Expr":
        return _expr(other) + self

    def __rsub__(self, other: Any) -> "Expr":
        return _expr(other) - self

    def __rmul__(self, other: Any) -> "Expr":
        return _expr(other) * self

    def __rtruediv__(self, other: Any) -> "Expr":
        return _expr(other) / self

    def sqrt(self) -> "Expr":
        """Return the square root; `sign` raises `ValueError` when there is none."""
        return Expr(None, "sqrt", (self,))

    def sign(self, max_bits: int = MAX_BITS) -> int:
        """Return -1, 0 or 1. Raises `ZeroDivisionError`, `ValueError` (root below zero) and `Undecided`."""
        nodes = _in_order(self)
        roots = {_root_key(node) for node in nodes if node.operation == "sqrt"}
        bits = 64
        while bits <= max_bits:
            with ctx.workprec(bits):
                ball = _evaluated(nodes, len(roots))
                if ball is not None:
                    if ball > 0 or ball < 0:
                        return 1 if ball > 0 else -1
                    if _is_zero(self, ball, len(roots)):
                        return 0
            bits *= 2
        raise Undecided(max_bits)


def separation_bits(node: Expr, roots: int) -> int:
    """Return b such that `node`, with at most `roots` different square roots, is 0 or at least 2**-b."""
    return ((1 << roots) - 1) * node.log_u + node.log_l


def _expr(value: Any) -> Expr:
    if isinstance(value, Expr):
        return value
    if not isinstance(value, int | Fraction) and not hasattr(value, "denominator"):
        raise TypeError(f"an Expr is made of int, Fraction or mpq, not {type(value).__name__}")
    return Expr(value)


def _root_key(node: Expr) -> object:
    """Return the same key for roots that are surely the same: of one rational, or of one node."""
    x = node.arguments[0]
    return id(x) if x.operation else (int(x.value.p), int(x.value.q))


def _in_order(last: Expr) -> list[Expr]:
    """Return all nodes under `last`, arguments first, each once; no recursion, for chains are long."""
    order: list[Expr] = []
    done: set[int] = set()
    stack = [(last, False)]
    while stack:
        node, is_ready = stack.pop()
        if id(node) in done:
            continue
        if is_ready:
            done.add(id(node))
            order.append(node)
        else:
            stack.append((node, True))
            stack.extend((x, False) for x in node.arguments)
    return order


def _evaluated(nodes: list[Expr], roots: int) -> arb | None:
    """Return a ball around the last node, or None when a divisor or radicand is not yet told from zero."""
    balls: dict[int, arb] = {}
    for node in nodes:
        if not node.operation:
            balls[id(node)] = arb(node.value)
            continue
        x, y = balls[id(node.arguments[0])], balls[id(node.arguments[-1])]
        match node.operation:
            case "+":
                ball = x + y
            case "-":
                ball = x - y
            case "*":
                ball = x * y
            case "/" if y.contains(0):
                if _is_zero(node.arguments[1], y, roots):
                    raise ZeroDivisionError("division by an expression that is zero")
                return None
            case "/":
                ball = x / y
            case _ if x > 0:
                ball = x.sqrt()
            case _ if x < 0:
                raise ValueError("square root of a negative expression")
            case _:
                if not _is_zero(node.arguments[0], x, roots):
                    return None
                ball = arb(0)
        balls[id(node)] = ball
    return balls[id(nodes[-1])]


def _is_zero(node: Expr, ball: arb, roots: int) -> bool:
    return bool(ball.abs_upper() < arb((1, -separation_bits(node, roots))))
