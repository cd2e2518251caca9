"""Bytes to text, decimals and places."""

from contextlib import suppress
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError
from exactmesh.io.text import decimal_from_text, place_at, printable, quoted, shortened, text_from_bytes


def test_a_byte_order_mark_and_foreign_line_ends_are_taken_away():
    assert text_from_bytes(b"\xef\xbb\xbfa\r\nb\rc\n") == "a\nb\nc\n"


@pytest.mark.parametrize("data, place, reason", [
    (b"", "", "the file is empty"),
    (b"\xef\xbb\xbf", "", "the file is empty"),
    (b" \r\n\t", "", "the file is empty"),
    (b"ab\0", "byte 2", "a NUL byte: this is not a text file"),
    (b"abc\xff", "byte 3", "this is not UTF-8 text"),
    ("{}".encode("utf-16"), "byte 0", "this is not UTF-8 text"),
])
def test_what_is_no_text_is_refused(data, place, reason):
    with pytest.raises(FormatError) as caught:
        text_from_bytes(data)
    assert (caught.value.place, caught.value.reason) == (place, reason)


@given(st.binary(max_size=30))
def test_any_bytes_are_text_or_refused(data):
    with suppress(FormatError):
        assert "\r" not in text_from_bytes(data)


@given(st.from_regex(r"[+-]?([0-9]{1,30}\.?[0-9]{0,30}|\.[0-9]{1,30})([eE][+-]?[0-9]{1,2})?", fullmatch=True))
def test_a_decimal_is_what_fractions_make_of_it(text):
    value = decimal_from_text(text)
    # `Fraction` does not read "1.": the digit changes nothing.
    mantissa, e, exponent = text.lower().partition("e")
    assert value == Fraction(mantissa + ("0" if mantissa.endswith(".") else "") + e + exponent)


@pytest.mark.parametrize("text", ["", "1/2", "nan", "inf", "1e", ".", "0x10", "1_0", "--1", "٣", " 1"])
def test_what_is_no_decimal_is_refused(text):
    with pytest.raises(FormatError, match="is not a finite decimal"):
        decimal_from_text(text)


def test_an_exponent_that_asks_for_gigabytes_is_refused():
    with pytest.raises(FormatError, match="exponent"):
        decimal_from_text("1e999999999")


def test_places_count_from_one():
    text = "ab\ncd\n"
    assert [place_at(text, k) for k in (0, 2, 3, 4)] == [
        "line 1, column 1", "line 1, column 3", "line 2, column 1", "line 2, column 2"]


def test_extracts_are_short_and_on_one_line():
    assert shortened("x" * 50) == "x" * 37 + "..."
    assert shortened("x" * 40) == "x" * 40
    assert quoted("a\nb") == r"'a\nb'"
    assert printable("a b.json") == "a b.json"
    assert printable("a\nb\0") == r"a\nb\x00"
