"""JSON as it is written."""

import json
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError
from exactmesh.io.strict_json import Number, described, parse_json

MARKED = st.recursive(
    st.none() | st.booleans() | st.text() | st.integers().map(lambda n: Number(str(n))),
    lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner), max_leaves=20)


def plain(value):
    """Return `value` with plain integers for numbers."""
    match value:
        case Number():
            return int(value.text)
        case list():
            return [plain(item) for item in value]
        case dict():
            return {key: plain(item) for key, item in value.items()}
    return value


@given(MARKED, st.sampled_from([None, 1]), st.booleans())
def test_what_was_written_is_read(value, indent, ascii_only):
    assert parse_json(json.dumps(plain(value), indent=indent, ensure_ascii=ascii_only)) == value


@pytest.mark.parametrize("text", ["0", "-0", "1.50", "1E+3", "1e400", "0." + "1" * 5000, "9" * 5000])
def test_numbers_keep_their_text(text):
    assert parse_json(f"[{text}]") == [Number(text)]


def test_a_byte_order_mark_is_tolerated():
    assert parse_json("\ufeff[]") == []


@pytest.mark.parametrize("text, place, reason", [
    ("", "", "the file is empty"),
    (" \n", "", "the file is empty"),
    ("[1,\n 2,,]", "line 2, column 4", "invalid JSON: Expecting value"),
    ('{"a": 1', "line 1, column 8", "invalid JSON: Expecting ',' delimiter"),
    ("[1] [2]", "line 1, column 5", "invalid JSON: Extra data"),
    ("[01]", "line 1, column 3", "invalid JSON: Expecting ',' delimiter"),
    ("[+1]", "line 1, column 2", "invalid JSON: Expecting value"),
    ('["a\tb"]', "line 1, column 4", "invalid JSON: Invalid control character at"),
    ('{"a": "NaN \\" -Infinity",\n "b": NaN}', "line 2, column 7", "NaN is not a number in JSON"),
    ("[1, Infinity]", "line 1, column 5", "Infinity is not a number in JSON"),
    ("-Infinity", "line 1, column 1", "-Infinity is not a number in JSON"),
    ('[{"a": 1, "b": 2, "a": 3}]', "", "the key 'a' occurs twice in one object"),
])
def test_what_is_no_json_is_refused(text, place, reason):
    with pytest.raises(FormatError) as caught:
        parse_json(text)
    assert (caught.value.place, caught.value.reason) == (place, reason)


@pytest.mark.parametrize("opening, closing", [("[", "]"), ('{"a":', "}")])
def test_deep_nesting_is_refused_and_not_followed(opening, closing):
    depth = 10 * sys.getrecursionlimit()
    with pytest.raises(FormatError, match="nested too deeply"):
        parse_json(opening * depth + "1" + closing * depth)


@given(st.text() | st.text(alphabet='{}[]",:0123456789.eE+-NaInfty \n\\', max_size=40))
def test_any_text_is_json_or_refused(text):
    try:
        parse_json(text)
    except FormatError as error:
        assert "\n" not in str(error)


def test_values_are_described():
    values = [None, True, False, "x\ny", "y" * 50, Number("1" * 50), [1, 2], {}]
    assert [described(value) for value in values] == [
        "null", "true", "false", r"the string 'x\ny'", "the string '" + "y" * 37 + "...'",
        "the number " + "1" * 37 + "...", "a list of 2", "an object"]
