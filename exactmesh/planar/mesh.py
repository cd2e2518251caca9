"""The record of a mesh."""

from dataclasses import dataclass
from typing import Literal, get_args

from exactmesh.geometry.point import Point

Kind = Literal["classic", "nonproper", "proper", "internal"]
KINDS: tuple[Kind, ...] = get_args(Kind)


@dataclass(frozen=True, slots=True)
class Mesh:
    """A triangulation: the input's vertices first, in its order, then the Steiner vertices.

    A face is the counter-clockwise cycle of all vertices on its boundary; geometrically it is a triangle. Nothing is
    checked here: `exactmesh.verify` decides whether a mesh is one.
    """

    kind: Kind
    vertices: tuple[Point, ...]
    faces: tuple[tuple[int, ...], ...]
