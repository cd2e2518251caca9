"""Read and write Triangle's `.poly` (Shewchuk, https://www.cs.cmu.edu/~quake/triangle.poly.html).

    vertices    <count> [2] [attributes] [markers 0/1]     <index> <x> <y> [attributes] [marker]
    segments    <count> [markers 0/1]                      <index> <end> <end> [marker]
    holes       <count>                                    <index> <x> <y>
    regions     <count>   (may be left out)                <index> <x> <y> <attribute> [area]

`#` begins a comment; blank lines do not count. Vertices are numbered from 0 or 1. Attributes, markers and
regions say nothing about the domain and are skipped. Coordinates are the exact decimals that are written.
"""

import re
from collections.abc import Callable, Iterator, Sequence

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.decimals import decimal_of
from exactmesh.io.limits import TEXT_SEPARATORS, check_text
from exactmesh.io.text import decimal_from_text, quoted
from exactmesh.planar.pslg import Edge, Pslg

# More digits than any count or index has, and few enough to convert.
_WHOLE = re.compile(r"\d{1,18}", re.ASCII)


def pslg_from_poly(text: str, node_text: Callable[[], str] | None = None) -> Pslg:
    """Return the PSLG of a `.poly` file; `node_text` returns the `.node` file, if the vertices are there.

    Raises `FormatError` naming the line: for text that is not `.poly`, a vertex that does not exist, a
    segment from a vertex to itself, vertices elsewhere when `node_text` is None, and sizes beyond the limits.
    """
    lines = Lines(text)
    vertices, first = _vertices(lines)
    if not vertices:
        if node_text is None:
            raise FormatError("", "the vertices are in a .node file, which is not at hand")
        vertices, first = points_from_node(node_text)
    edges = _segments(lines, first, len(vertices))
    holes = [_point(lines, tokens) for tokens in lines.records("holes", lines.header("holes", 1)[0], 3, 3)]
    if lines.has_more():
        for tokens in lines.records("regions", lines.header("regions", 1)[0], 4, 5):
            _point(lines, tokens)
    lines.finish()
    return Pslg(tuple(vertices), tuple(edges), tuple(holes))


def poly_from_pslg(pslg: Pslg) -> str:
    """Return the text of a `.poly` file that is read back as the same PSLG, but for its name.

    Raises `FormatError` naming a vertex or hole with a coordinate, such as 1/3, that no decimal spells
    exactly.
    """
    lines = [f"{len(pslg.vertices)} 2 0 0"]
    lines += node_lines("vertices", pslg.vertices)
    lines.append(f"{len(pslg.edges)} 0")
    lines += [f"{i} {u} {v}" for i, (u, v) in enumerate(pslg.edges)]
    lines.append(f"{len(pslg.holes)}")
    lines += node_lines("holes", pslg.holes)
    return "\n".join(lines) + "\n"


class Lines:
    """A cursor over the lines that say something."""

    def __init__(self, text: str) -> None:
        check_text(text, TEXT_SEPARATORS)
        numbered = ((n, line.partition("#")[0].split()) for n, line in enumerate(text.split("\n"), 1))
        self._lines = [(n, tokens) for n, tokens in numbered if tokens]
        self._next = 0

    def has_more(self) -> bool:
        """Whether a line is left."""
        return self._next < len(self._lines)

    def place(self) -> str:
        """Return the place of the line read last."""
        return f"line {self._lines[self._next - 1][0]}"

    def read(self, wanted: str) -> list[str]:
        """Return the tokens of the next line."""
        if not self.has_more():
            raise FormatError("", f"the file ends where {wanted} is expected")
        self._next += 1
        return self._lines[self._next - 1][1]

    def header(self, section: str, width: int) -> list[int]:
        """Read the line of whole numbers, at most `width`, that begins with the count of a section."""
        tokens = self.read(f"the number of {section}")
        if len(tokens) > width:
            raise FormatError(self.place(), f"the number of {section} stands in a line of at most {width}, "
                                            f"not {len(tokens)}")
        return [self.whole(token, f"the number of {section}") for token in tokens]

    def records(self, section: str, count: int, least: int, most: int) -> Iterator[list[str]]:
        """Read `count` lines of `least` to `most` numbers."""
        for index in range(count):
            tokens = self.read(f"line {index + 1} of {count} of the {section}")
            if not least <= len(tokens) <= most:
                wanted = f"{least} to {most}" if most > least else f"{least}"
                raise FormatError(self.place(), f"{wanted} numbers are expected in a line of the {section}, "
                                                f"not {len(tokens)}")
            yield tokens

    def whole(self, token: str, wanted: str) -> int:
        """Return the whole number that a token is."""
        if not _WHOLE.fullmatch(token):
            raise FormatError(self.place(), f"{wanted} is expected, not {quoted(token)}")
        return int(token)

    def index(self, token: str, first: int, count: int) -> int:
        """Return the index from 0 of a vertex, when they are numbered from `first`."""
        index = self.whole(token, "a vertex") - first
        if not 0 <= index < count:
            raise FormatError(self.place(), f"vertex {token} does not exist (there are {count}, from {first})")
        return index

    def finish(self) -> None:
        """Raise `FormatError` when a line is left."""
        if self.has_more():
            self.read("nothing")
            raise FormatError(self.place(), "the file should end before this line")


def points_from_node(node_text: Callable[[], str]) -> tuple[list[Point], int]:
    """Return the vertices of a `.node` file and the index of the first; raises `FormatError` naming the line."""
    try:
        lines = Lines(node_text())
        vertices, first = _vertices(lines)
        lines.finish()
    except FormatError as error:
        raise FormatError(f".node {error.place}".rstrip(), error.reason) from None
    return vertices, first


def _vertices(lines: Lines) -> tuple[list[Point], int]:
    """Read the vertices; return them and the index of the first, which is 0 or 1."""
    given = lines.header("vertices", 4)
    # Triangle's own defaults for what the line leaves out.
    count, dimension, attributes, markers = given + [2, 0, 0][len(given) - 1 :]
    if dimension != 2:
        raise FormatError(lines.place(), f"the dimension should be 2, not {dimension}")
    points: list[Point] = []
    first = 0
    for tokens in lines.records("vertices", count, 3, 3 + attributes + markers):
        number = lines.whole(tokens[0], "the index of a vertex")
        if not points and number in (0, 1):
            first = number
        if number != first + len(points):
            wanted = str(first + len(points)) if points else "0 or 1"
            raise FormatError(lines.place(), f"vertex {wanted} is expected, not {number}")
        points.append(_point(lines, tokens))
    return points, first


def _segments(lines: Lines, first: int, count: int) -> list[Edge]:
    edges = []
    # The marker is allowed where the header announces none, as by Triangle itself.
    for tokens in lines.records("segments", lines.header("segments", 2)[0], 3, 4):
        u, v = (lines.index(token, first, count) for token in tokens[1:3])
        if u == v:
            raise FormatError(lines.place(), f"both ends are vertex {u + first}: a segment needs two")
        edges.append((u, v))
    return edges


def _point(lines: Lines, tokens: list[str]) -> Point:
    try:
        return Point._make(decimal_from_text(token) for token in tokens[1:3])
    except FormatError as error:
        raise FormatError(lines.place(), error.reason) from None


def node_lines(section: str, points: Sequence[Point]) -> list[str]:
    """Return a line for each point; raises `FormatError` for a coordinate that no decimal spells."""
    return [f"{i} {decimal_of(p.x, f'{section}[{i}]')} {decimal_of(p.y, f'{section}[{i}]')}"
            for i, p in enumerate(points)]
