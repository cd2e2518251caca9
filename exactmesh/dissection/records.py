"""The vocabulary of dissections, known to those who make them and to those who check them."""

from dataclasses import dataclass
from typing import NamedTuple

from exactmesh.numbers.algebraic import Real


class Vector(NamedTuple):
    """A place, or a vector, with algebraic coordinates."""

    x: Real
    y: Real


Polygon = tuple[Vector, ...]


class Motion(NamedTuple):
    """The map p -> (a p.x + b p.y + x, c p.x + d p.y + y); that it is rigid is for the checker to decide."""

    a: Real
    b: Real
    c: Real
    d: Real
    x: Real
    y: Real

    def __call__(self, p: Vector) -> Vector:
        return Vector(self.a * p.x + self.b * p.y + self.x, self.c * p.x + self.d * p.y + self.y)


@dataclass(frozen=True, slots=True)
class Piece:
    """One piece: its polygon in each figure, corners in the same order, counter-clockwise and convex.

    `motions[i]` carries the polygon in figure 0 to that in figure i + 1.
    """

    polygons: tuple[Polygon, ...]
    motions: tuple[Motion, ...]


@dataclass(frozen=True, slots=True)
class Dissection:
    """Pieces that tile each figure; figure i is the i-th polygon, scaled about the origin by `scales[i]`."""

    scales: tuple[Real, ...]
    pieces: tuple[Piece, ...]
