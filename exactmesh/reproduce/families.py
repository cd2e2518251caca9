"""The inputs of Table 1: the paper's two families, and two on which proper meshes must degrade.

regular     the regular n-gon (Mitchell, in [BDE95]), on rational points of the unit circle within `WITHIN` of its
            vertices; every other family is exact
rectangle   the r x 1 rectangle with two vertices midway along its lower side, 1 apart (the same source): n = 6
floor       the same with more of them, as the paper has it at the end of that paragraph: k vertices on the lower side
            of a (k + 1) x 1 rectangle, all 1 apart. Their columns end at the clean ceiling 1 above: n = k + 4
comb        a room with one clean floor and k teeth 2 apart, the tips 1 above the floor: n = 2 k + 3. No theorem is
            tied to it; of the families tried, the repaired construction's proper meshes degrade most on it

What is known of classic meshes comes along (`Family.optimum`), from these arguments:

regular     A triangle on the vertices of the n-gon, with arcs of a <= b <= c edges, has the least height
            2 sin(a pi/n) sin(b pi/n), and an ear has a = b = 1. A triangulation has an ear, so its mfs is
            2 sin(pi/n)^2; the n-gon's is 2 sin(pi/n), n >= 4. So *each* classic mesh degrades by 1/sin(pi/n). Moving
            every vertex by at most e moves no distance between a vertex and an edge by more than 2 e.
rectangle   The triangle on the edge between the midway vertices has its third vertex on the upper side, at an end: its
            longest side has the squared length ((r + 1)/2)^2 + 1, its area is 1/2, and the mfs is 1 for r >= 3.
floor       The same for the edge of the lower side that is hardest to serve, in the middle.

Not checked here: the arguments. `optimum` is compared with meshes made by dynamic programming over all of them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from gmpy2 import RoundDown, RoundUp, context, mpfr, mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg

# How far a vertex of `regular_polygon` may be from that of the regular n-gon.
WITHIN = mpq(1, 2**40)

_DOWN, _UP = (context(precision=160, round=mode) for mode in (RoundDown, RoundUp))
# A point of the circle moves at most twice as fast as t, the tangent of half its angle; t is rounded by half of this.
_STEP = WITHIN / 2


@dataclass(frozen=True, slots=True)
class Family:
    """Inputs of one shape. `variable` is what a size stands for, `against` what growth is measured in: n or r.

    `optimum` gives for a size low and high: the squared degradation of *every* classic mesh is at least low, that of
    the best one at most high; None where nothing is known. `formula` says in words what both enclose, and `paper` what
    the paper says of classic meshes. The vertices are within `within` of what the family is meant to be.
    """

    name: str
    variable: str
    against: str
    make: Callable[[int], Pslg]
    short: tuple[int, ...]
    more: tuple[int, ...]
    paper: str = ""
    formula: str = ""
    optimum: Callable[[int], tuple[mpq, mpq]] | None = None
    within: mpq = field(default_factory=mpq)

    def sizes(self, short: bool) -> tuple[int, ...]:
        """Return the sizes, in rising order."""
        return self.short if short else self.short + self.more

    def place(self, size: int, n: int) -> int:
        """Return where an input with n vertices stands on the axis of growth."""
        return size if self.against == self.variable else n


def regular_polygon(n: int) -> Pslg:
    """Return n >= 4 rational points exactly on the unit circle, each within `WITHIN` of a vertex of the regular n-gon.

    Vertex 0 is (1, 0). The angle is brought below pi/4 by quarter turns; there the point is
    ((1 - t^2)/(1 + t^2), 2 t/(1 + t^2)), t a dyadic rational near the tangent of half the angle.
    """
    if n < 4:
        raise ValueError(f"the n-gons of this family have at least 4 vertices, not {n}")
    return _ring([_on_circle(i, n) for i in range(n)], f"regular {n}-gon")


def midway_rectangle(r: int) -> Pslg:
    """Return the r x 1 rectangle, r >= 3, with two vertices midway along its lower side, 1 apart."""
    middle, half = mpq(r, 2), mpq(1, 2)
    return _ring([(0, 0), (middle - half, 0), (middle + half, 0), (r, 0), (r, 1), (0, 1)], f"{r} x 1 rectangle")


def long_floor(k: int) -> Pslg:
    """Return the (k + 1) x 1 rectangle with k vertices on its lower side, all 1 apart."""
    return _ring([*((i, 0) for i in range(k + 2)), (k + 1, 1), (0, 1)], f"floor with {k} vertices")


def comb(k: int) -> Pslg:
    """Return a room of height 4 with k teeth that hang from the ceiling, their tips at 2, 4, .., 2 k, 1 above it."""
    corners: list[tuple[int | mpq, int]] = [(0, 0), (2 * k + 2, 0), (2 * k + 2, 4)]
    for i in range(k, 0, -1):
        corners += [(2 * i, 1), (2 * i - 1 if i > 1 else 0, 4)]
    return _ring(corners, f"comb of {k} teeth")


def sine_of_nth(n: int) -> tuple[mpq, mpq]:
    """Return rationals around sin(pi/n), n >= 2, less than 2^-140 apart."""
    low, high = _half_turns(1, n)
    return mpq(_DOWN.sin(mpfr(low, 0, _DOWN))), mpq(_UP.sin(mpfr(high, 0, _UP)))


def _on_circle(i: int, n: int) -> tuple[mpq, mpq]:
    """Return a rational point of the unit circle within `WITHIN` of the angle 2 pi i/n."""
    quarter = (8 * i + n) // (2 * n)
    # What is left is the angle pi turns/(2 n), at most pi/4.
    turns = 4 * i - quarter * n
    low, high = _half_turns(abs(turns), 4 * n)
    low, high = mpq(_DOWN.tan(mpfr(low, 0, _DOWN))), mpq(_UP.tan(mpfr(high, 0, _UP)))
    t = _STEP * round(low / _STEP)
    # This is the proof of the bound, not a safeguard: only the monotony of the tangent and MPFR's rounding enter.
    if 2 * max(high - t, t - low) > WITHIN:
        raise AssertionError("half a step and the width of the enclosure are less than the step")
    t = t if turns >= 0 else -t
    x, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarter % 4):
        x, y = -y, x
    return x, y


def _half_turns(share: int, of: int) -> tuple[mpq, mpq]:
    """Return rationals around pi share/of."""
    return mpq(_DOWN.const_pi()) * share / of, mpq(_UP.const_pi()) * share / of


def _ring(corners: Sequence[tuple[int | mpq, int | mpq]], name: str) -> Pslg:
    vertices = tuple(Point(mpq(x), mpq(y)) for x, y in corners)
    count = len(vertices)
    return Pslg(vertices, tuple((i, (i + 1) % count) for i in range(count)), name=name)


def _regular_optimum(n: int) -> tuple[mpq, mpq]:
    low, high = sine_of_nth(n)
    # 2 s and 2 s^2, each off by at most 2 WITHIN; the quotient falls as s grows.
    return ((high - WITHIN) / (high**2 + WITHIN)) ** 2, ((low + WITHIN) / (low**2 - WITHIN)) ** 2


def _rectangle_optimum(r: int) -> tuple[mpq, mpq]:
    squared = mpq(r + 1, 2) ** 2 + 1
    return squared, squared


def _floor_optimum(k: int) -> tuple[mpq, mpq]:
    squared = mpq((k + 2) // 2) ** 2 + 1
    return squared, squared


_POWERS, _MORE_POWERS = (4, 8, 16, 32, 64, 128, 256), (512, 1024)
FAMILIES: tuple[Family, ...] = (
    Family("regular", "n", "n", regular_polygon, _POWERS, _MORE_POWERS, "Omega(n)", "1/sin(pi/n)", _regular_optimum,
           WITHIN),
    Family("rectangle", "r", "r", midway_rectangle, (4, 10, 100, 1000, 10**4), (10**5, 10**6), "Omega(r)",
           "sqrt(((r+1)/2)^2 + 1)", _rectangle_optimum),
    Family("floor", "k", "n", long_floor, _POWERS, _MORE_POWERS, "Omega(n + r)", "sqrt(floor(k/2 + 1)^2 + 1)",
           _floor_optimum),
    Family("comb", "k", "n", comb, _POWERS, _MORE_POWERS),
)
