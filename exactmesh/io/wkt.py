"""Read one geometry of well-known text (OGC 06-103r4, section 7) as a PSLG.

    geometry = KIND ["Z"] "(" body ")"        in capitals or not; a position is two numbers, or three

Coordinates are the exact decimals that are written. The third of a position is ignored: everything is seen
from above. Measures (`M`) and the `SRID=...;` of EWKT are refused, and so is `EMPTY`.
"""

import re
from collections.abc import Callable
from itertools import islice

from gmpy2 import mpq

from exactmesh.errors import FormatError
from exactmesh.geometry.point import Point
from exactmesh.io.limits import TEXT_SEPARATORS, check_text
from exactmesh.io.rings import Assembly, Run
from exactmesh.io.text import decimal_from_text, place_at, quoted
from exactmesh.planar.pslg import Pslg

KINDS = ("POINT", "MULTIPOINT", "LINESTRING", "MULTILINESTRING", "POLYGON", "MULTIPOLYGON",
         "GEOMETRYCOLLECTION")

_TOKEN = re.compile(r"[(),]|[^\s(),]+")


def pslg_from_wkt(text: str) -> Pslg:
    """Return the PSLG of a file's text.

    Raises `FormatError` naming line and column: for text that is not WKT, a ring that is not closed or has
    fewer than three distinct points, a position repeated at once, and sizes beyond the limits.
    """
    check_text(text, TEXT_SEPARATORS)
    return _Parser(text).pslg()


class _Parser:
    """A cursor over the tokens; collections, which nest without bound, are counted and not recursed into."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = _TOKEN.findall(text)
        self.tokens.append("")  # the end
        self.next = 0
        self.widths: tuple[int, ...] = (2, 3)  # how many numbers a position may have
        self.assembly = Assembly()

    def pslg(self) -> Pslg:
        """Read the whole text: a geometry, and within a collection a comma or the end after each."""
        depth = 0
        while True:
            if self._opens_collection():
                depth += 1
                continue
            while depth and self._takes(")"):
                depth -= 1
            if depth == 0:
                break
            self._expect(",", '"," or ")"')
        self._expect("", "the end of the text, or a GEOMETRYCOLLECTION around all geometries,")
        return self.assembly.pslg()

    def _opens_collection(self) -> bool:
        """Read one geometry and return False, or only the beginning of a collection and return True."""
        kind = self.tokens[self.next].upper()
        if kind.startswith("SRID="):
            raise self._error("this is EWKT: take the SRID away, coordinates are read as they are")
        if kind not in KINDS:
            raise self._unexpected(f"one of {', '.join(KINDS)}")
        self.next += 1
        self._dimension()
        add = self.assembly
        if kind == "GEOMETRYCOLLECTION":
            self._expect("(")
            return True
        if kind == "POINT":
            self._bracketed_point()
        elif kind == "MULTIPOINT":
            self._separated(self._bracketed_or_bare_point)
        elif kind == "LINESTRING":
            add.add_line(self._run())
        elif kind == "MULTILINESTRING":
            self._separated(lambda: add.add_line(self._run()))
        elif kind == "POLYGON":
            self._polygon()
        else:
            self._separated(self._polygon)
        return False

    def _dimension(self) -> None:
        word = self.tokens[self.next].upper()
        self.widths = (3,) if word == "Z" else (2, 3)
        if word in ("M", "ZM"):
            raise self._error("measures are not read: only Z may be left aside")
        if word == "Z":
            self.next += 1
        if self.tokens[self.next].upper() == "EMPTY":
            raise self._error("an empty geometry has no place in a PSLG")

    def _polygon(self) -> None:
        rings: list[Run] = []
        self._separated(lambda: rings.append(self._run()))
        self.assembly.add_polygon(rings)

    def _run(self) -> Run:
        start = self.next
        points: list[Point] = []
        starts: list[int] = []

        def read() -> None:
            starts.append(self.next)
            points.append(self._position())

        self._separated(read)
        return Run(points, lambda index: self._place(start if index is None else starts[index]))

    def _bracketed_point(self) -> None:
        self._expect("(")
        self.assembly.add_point(self._position())
        self._expect(")")

    def _bracketed_or_bare_point(self) -> None:
        if self.tokens[self.next] == "(":
            self._bracketed_point()
        else:
            self.assembly.add_point(self._position())

    def _position(self) -> Point:
        start = self.next
        numbers: list[mpq] = []
        while self.tokens[self.next] not in ("(", ")", ",", ""):
            try:
                numbers.append(decimal_from_text(self.tokens[self.next]))
            except FormatError as error:
                raise self._error(error.reason) from None
            self.next += 1
        if len(numbers) not in self.widths:
            wanted = " or ".join(map(str, self.widths))
            raise FormatError(self._place(start), f"a position has {wanted} numbers here, not {len(numbers)}")
        return Point(*numbers[:2])

    def _separated(self, read: Callable[[], None]) -> None:
        """Read a bracketed list with commas."""
        self._expect("(")
        read()
        while self._takes(","):
            read()
        self._expect(")", '"," or ")"')

    def _takes(self, token: str) -> bool:
        if self.tokens[self.next] != token:
            return False
        self.next += 1
        return True

    def _expect(self, token: str, wanted: str = "") -> None:
        if not self._takes(token):
            raise self._unexpected(wanted or f'"{token}"')

    def _unexpected(self, wanted: str) -> FormatError:
        token = self.tokens[self.next]
        return self._error(f"{wanted} is expected, not {quoted(token) if token else 'the end of the text'}")

    def _error(self, reason: str) -> FormatError:
        return FormatError(self._place(self.next), reason)

    def _place(self, index: int) -> str:
        # Tokens do not carry their offsets, which only an error asks for.
        match = next(islice(_TOKEN.finditer(self.text), index, None), None)
        return place_at(self.text, match.start() if match else len(self.text.rstrip()))
