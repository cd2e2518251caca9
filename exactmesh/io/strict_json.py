"""JSON as it is written: numbers keep their text, and what JSON leaves open is refused.

Python's parser would round decimals to doubles, refuse integers beyond 4300 digits, accept NaN, and keep the
last of two equal keys; each of its hooks used here takes one of these decisions from it.
"""

import json
import re
from typing import NamedTuple, NoReturn, TypeAlias

from exactmesh.errors import FormatError
from exactmesh.io.limits import JSON_SEPARATORS, check_text
from exactmesh.io.text import place_at, quoted, shortened


class Number(NamedTuple):
    """A JSON number: the characters of the file, never converted here."""

    text: str


Json: TypeAlias = bool | str | Number | list["Json"] | dict[str, "Json"] | None

# A string is skipped whole, so that a NaN inside one is not taken for the token.
_STRING_OR_CONSTANT = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"|-?Infinity|NaN', re.DOTALL)


def parse_json(text: str) -> Json:
    """Return the value that `text` holds.

    Raises `FormatError`, naming line and column, for text that is not JSON, NaN and infinities included; and
    for an object with two equal keys, nesting beyond what the parser can follow, and sizes beyond the limits.
    """

    def refuse_constant(name: str) -> NoReturn:
        # The parser has met no error before this token, so the first match outside a string is the token.
        tokens = _STRING_OR_CONSTANT.finditer(text)
        offset = next((match.start() for match in tokens if match[0][0] != '"'), 0)
        raise FormatError(place_at(text, offset), f"{name} is not a number in JSON")

    if not text or text.isspace():
        raise FormatError("", "the file is empty")
    check_text(text, JSON_SEPARATORS)
    try:
        value: Json = json.loads(text.removeprefix("\ufeff"), parse_int=Number, parse_float=Number,
                                 parse_constant=refuse_constant, object_pairs_hook=_object)
    except json.JSONDecodeError as error:
        place = f"line {error.lineno}, column {error.colno}"
        raise FormatError(place, f"invalid JSON: {error.msg}") from None
    except RecursionError:
        raise FormatError("", "the JSON is nested too deeply") from None
    return value


def described(value: Json) -> str:
    """Return what a JSON value is, for a message: 'the string "x"', 'a list of 3', ..."""
    match value:
        case None:
            return "null"
        case bool():
            return "true" if value else "false"
        case str():
            return f"the string {quoted(value)}"
        case Number():
            return f"the number {shortened(value.text)}"
        case list():
            return f"a list of {len(value)}"
        case dict():
            return "an object"


def _object(pairs: list[tuple[str, Json]]) -> dict[str, Json]:
    found = dict(pairs)
    if len(found) != len(pairs):
        seen: set[str] = set()
        for key, _ in pairs:
            if key in seen:
                raise FormatError("", f"the key {quoted(key)} occurs twice in one object")
            seen.add(key)
    return found
