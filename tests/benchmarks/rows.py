"""A family against the coarse construction: rows of isolated points on almost equal levels, in a slanted box.

    exactmesh search coarse.degradation --strategy random --family tests/benchmarks/rows.py:rows --store rows.db

One to four in a hundred of its figures break it. Points are 1 or more apart, so T-vertices are as dense as they can be.
"""

import random
from fractions import Fraction

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg

_LEVEL = Fraction(723, 5000)
_Place = tuple[Fraction, Fraction]


def rows(source: random.Random, n: int = 0) -> Pslg:
    """Return rows of up to n (0: 20) points at heights that differ by about a level, some points beyond them, a box."""
    points: list[_Place] = []
    slope = source.choice((Fraction(0), Fraction(0), Fraction(1, 1000), Fraction(1, 100), Fraction(1, 20)))

    def put(x: Fraction, y: Fraction) -> None:
        if all((x - u) ** 2 + (y - v) ** 2 >= 1 for u, v in points):
            points.append((x, y))

    x = Fraction(0)
    for _ in range(source.randint(1, 6)):
        y = source.randint(-4, 4) * _LEVEL + Fraction(source.randint(-20, 20), 200)
        jitter = source.choice((Fraction(0), Fraction(0), Fraction(1, 100), Fraction(1, 30)))
        pitch = source.choice((Fraction(1), Fraction(1), Fraction(101, 100), Fraction(13, 10), Fraction(2)))
        for _ in range(source.randint(1, n or source.choice((1, 2, 5, 13, 20)))):
            put(x, y + slope * x + jitter * source.randint(-3, 3))
            x += pitch
        x += source.choice((0, 0, 1, 5, 50, 400))
    side = source.choice((-1, 1))
    for k in range(source.randint(0, 10)):
        beyond = side * k * source.choice((Fraction(1), Fraction(11, 10), Fraction(10), Fraction(100)))
        put((x if side > 0 else Fraction(0)) + 2 * side + beyond,
            source.choice((-1, 1)) * k * _LEVEL + Fraction(source.randint(-10, 10), 300))
    return _boxed(points, source)


def _boxed(points: list[_Place], source: random.Random) -> Pslg:
    left, right = min(x for x, _ in points) - 2, max(x for x, _ in points) + 2
    low, high = (min(y for _, y in points) - source.choice((1, 2, 10)),
                 max(y for _, y in points) + source.choice((1, 2, 10)))
    out = [source.choice((0, 0, 5, 300)) for _ in range(4)]
    slants = [source.choice((0, 0, 1, 20)) for _ in range(2)]
    box = [(left - out[0], low), (right + out[1], low - slants[0]), (right + out[2], high + slants[1]),
           (left - out[3], high)]
    count, up = len(points), Fraction(source.randint(0, 99), 100) * _LEVEL
    return Pslg(tuple(Point(mpq(x), mpq(y + up)) for x, y in points + box),
                tuple((count + i, count + (i + 1) % 4) for i in range(4)))
