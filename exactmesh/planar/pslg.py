"""The record of a planar straight-line graph (PSLG)."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.numbers.rational import rational

Edge = tuple[int, int]


@dataclass(frozen=True, slots=True)
class Pslg:
    """Vertices, edges between them, and points that mark faces to be left empty.

    Indices are in range and the two ends of an edge differ (`FormatError` otherwise); that no two features meet
    where they must not is decided by `exactmesh.planar.validate`.
    """

    vertices: tuple[Point, ...]
    edges: tuple[Edge, ...]
    holes: tuple[Point, ...] = ()
    name: str = field(default="", compare=False)

    def __post_init__(self) -> None:
        count = len(self.vertices)
        for index, (u, v) in enumerate(self.edges):
            for end in (u, v):
                if not 0 <= end < count:
                    raise FormatError(f"edge {index}", f"vertex {end} does not exist (there are {count})")
            if u == v:
                raise FormatError(f"edge {index}", f"both ends are vertex {u}: an edge needs two")


def polygon(corners: Iterable[Sequence[int | str]], name: str = "") -> Pslg:
    """Return the PSLG of one closed polygon given by its corners in order, either way round.

    >>> polygon([(0, 0), ("7/2", 0), (0, "0.1")]).edges
    ((0, 1), (1, 2), (2, 0))
    """
    vertices = tuple(Point(rational(x), rational(y)) for x, y in corners)
    count = len(vertices)
    return Pslg(vertices, tuple((i, (i + 1) % count) for i in range(count)), name=name)
