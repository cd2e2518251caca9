"""Snap the paper's P3 vertically to a horizontal grid: P3 to P4 (paper §2, "Refinement of P2").

In      `OffsetCurve`, the spacing of the grid, and what happens halfway between two lines.
Out     `Offset` whose levels are the lines of the grid: height(j) = j * spacing.
Exact   y becomes the nearest multiple of the spacing, decided on algebraic numbers. x, algebraic so far, becomes the
        nearest multiple of a dyadic step below mfs/2^16, so that everything from here on is rational.
Paper   keeps x; it leaves ties open: `ties` decides, upwards by default. The spacing 1/(2 d3) is irrational in the
        paper: any rational in (4/45, sin(pi/8)/4] mfs keeps every bound that depends on it.
Check   `snap_check.py`
"""

from math import floor
from typing import Literal

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.rational import sqrt_below
from exactmesh.steps.records import Offset, OffsetCurve, Shape

Ties = Literal["up", "down"]
_HALF = mpq(1, 2)


def grid_spacing(mfs_squared: mpq, granularity: mpq) -> mpq:
    """Return a rational just below granularity * mfs, by less than one part in 10^9."""
    return granularity * sqrt_below(mfs_squared, 31)


def snap(shape: Shape, curve: OffsetCurve, spacing: mpq, ties: Ties = "up") -> Offset:
    """Return P4; raises `ValueError` when the spacing is not positive."""
    if spacing <= 0:
        raise ValueError(f"the spacing must be positive, not {spacing}")
    step = _dyadic_step(curve.mfs_squared)
    xs: list[mpq] = []
    levels: list[int] = []
    corners: list[int] = []
    sources: list[int] = []
    rings = []
    for ring in curve.rings:
        start = len(xs)
        for corner in ring:
            for vertex in corner.vertices:
                xs.append(floor(vertex.x / step + _HALF) * step)
                levels.append(_line(vertex.y / spacing, ties))
                corners.append(corner.corner)
                sources.append(-1)
            # The last vertex of a corner starts the offset edge of the corner's outgoing edge.
            sources[-1] = corner.corner
        rings.append((start, len(xs)))
    points = tuple(Point(x, j * spacing) for x, j in zip(xs, levels, strict=True))
    return Offset(len(shape.points), tuple(xs), tuple(levels), tuple(corners), tuple(sources), tuple(rings), points,
                  spacing, mpq(0))


def _line(height: Real, ties: Ties) -> int:
    if ties == "up":
        return int(floor(height + _HALF))  # noqa: RUF046 (the floor of an mpq is an mpz)
    return -int(floor(_HALF - height))  # noqa: RUF046


def _dyadic_step(mfs_squared: mpq) -> mpq:
    """Return a power of two between mfs/2^18 and mfs/2^16."""
    root = sqrt_below(mfs_squared, 8)
    bits = root.numerator.bit_length() - root.denominator.bit_length()
    return mpq(2) ** (bits - 17)
