"""The format `exactmesh-dissection/1` (docs/dissection.md).

Read here: keys, types, exact expressions. Not checked: whether this is a dissection, which is for the checker to say.
"""

from collections.abc import Iterable

from exactmesh.dissection.expressions import ExpressionReader
from exactmesh.dissection.records import Dissection, Motion, Piece, Polygon, Vector
from exactmesh.errors import FormatError
from exactmesh.io.json_fields import each, fields, rows
from exactmesh.io.read import blaming, bytes_at
from exactmesh.io.strict_json import Json, Number, described, parse_json
from exactmesh.io.text import quoted, text_from_bytes
from exactmesh.numbers.algebraic import Real

FORMAT = "exactmesh-dissection/1"


def json_from_dissection(dissection: Dissection) -> str:
    """Return the text of a file that is read back as the same dissection."""
    scales = ", ".join(f'"{scale}"' for scale in dissection.scales)
    return (f'{{"format": "{FORMAT}",\n "scales": [{scales}],\n '
            f'"pieces": {rows(_piece_text(piece) for piece in dissection.pieces)}}}\n')


def dissection_from_json(text: str) -> Dissection:
    """Return the dissection of a file's text; raises `FormatError` naming the place, as `pieces[3].polygons[0][1]`."""
    found = fields(parse_json(text), FORMAT, ("scales", "pieces"))
    reader = _Reader()
    return Dissection(each(found["scales"], "scales", reader.scalar), each(found["pieces"], "pieces", reader.piece))


def read_dissection(path: str) -> Dissection:
    """Return the dissection in a file, `-` for standard input; raises `InputError`, which begins with the path."""
    with blaming(path):
        return dissection_from_json(text_from_bytes(bytes_at(path)))


class _Reader:
    """Reads the parts of a file; numbers that occur often are evaluated once."""

    def __init__(self) -> None:
        self.expression = ExpressionReader()

    def scalar(self, value: Json) -> Real:
        if isinstance(value, str):
            return self.expression(value)
        if isinstance(value, Number) and value.text.lstrip("-").isdigit():
            return self.expression(value.text)
        raise FormatError("", f"an integer is expected, or a string with an exact number, not {described(value)}")

    def vector(self, value: Json) -> Vector:
        return Vector._make(self._list(value, "", 2))

    def polygon(self, value: Json) -> Polygon:
        return each(value, "", self.vector)

    def piece(self, value: Json) -> Piece:
        found = _object(value, ("polygons", "motions"))
        return Piece(each(found["polygons"], ".polygons", self.polygon),
                     each(found["motions"], ".motions", self.motion))

    def motion(self, value: Json) -> Motion:
        found = _object(value, ("matrix", "translation"))
        matrix = each(found["matrix"], ".matrix", lambda row: self._list(row, "", 2))
        if len(matrix) != 2:
            raise FormatError(".matrix", f"two rows are expected, not {len(matrix)}")
        x, y = self._list(found["translation"], ".translation", 2)
        (a, b), (c, d) = matrix
        return Motion(a, b, c, d, x, y)

    def _list(self, value: Json, place: str, count: int) -> tuple[Real, ...]:
        if not isinstance(value, list) or len(value) != count:
            raise FormatError(place, f"a list of {count} exact numbers is expected, not {described(value)}")
        return each(value, place, self.scalar)


def _object(value: Json, keys: tuple[str, ...]) -> dict[str, Json]:
    if not isinstance(value, dict) or set(value) != set(keys):
        found = f"an object with {quoted(', '.join(value))}" if isinstance(value, dict) else described(value)
        raise FormatError("", f"an object with {' and '.join(keys)} is expected, not {found}")
    return value


def _piece_text(piece: Piece) -> str:
    polygons = ", ".join(f"[{_vectors(polygon)}]" for polygon in piece.polygons)
    motions = ", ".join(
        f'{{"matrix": [["{m.a}", "{m.b}"], ["{m.c}", "{m.d}"]], "translation": ["{m.x}", "{m.y}"]}}'
        for m in piece.motions)
    return f'{{"polygons": [{polygons}], "motions": [{motions}]}}'


def _vectors(vectors: Iterable[Vector]) -> str:
    return ", ".join(f'["{p.x}", "{p.y}"]' for p in vectors)
