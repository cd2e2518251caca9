"""Scalars, points and indices of the exact JSON formats."""

import json
from fractions import Fraction

import pytest
from gmpy2 import mpq, mpz
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError
from exactmesh.io.json_fields import each, fields, point, row_parts, rows, scalar, vertex_index
from exactmesh.io.strict_json import Number


@given(st.fractions())
def test_a_string_is_the_rational_it_spells(value):
    assert scalar(str(value)) == mpq(value)


@given(st.integers())
def test_an_integer_is_itself(value):
    assert scalar(Number(str(value))) == value


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_another_number_is_exactly_its_double(value):
    assert scalar(Number(repr(value))) == mpq(Fraction(value))


@pytest.mark.parametrize("text, value", [
    ("0.1", mpq(Fraction(0.1))),
    ("1e23", mpq(Fraction(1e23))),
    ("-0.0", mpq(0)),
    ("0e-999", mpq(0)),
    ("0.10000000000000000000000000001", mpq(Fraction(0.1))),
    ("9007199254740993", mpq(9007199254740993)),
    ("1" * 5000, mpq(mpz("1" * 5000))),
])
def test_numbers_by_hand(text, value):
    assert scalar(Number(text)) == value


def test_strings_of_many_digits_are_read():
    assert scalar("7" * 10000 + "/" + "3" * 10000) == mpq(7, 3)


@pytest.mark.parametrize("value, reason", [
    (Number("1e400"), "1e400 is beyond the range of a double: write it as a string"),
    (Number("-1e400"), "-1e400 is beyond the range of a double: write it as a string"),
    (Number("0.001e-400"), "0.001e-400 is beyond the range of a double: write it as a string"),
    ("1/0", "denominator of '1/0' is zero"),
    ("x", "'x' is not an integer, a finite decimal or a fraction p/q"),
    ("1e999999", "the exponent of '1e999999' is beyond 100000"),
    (True, "a number is expected, or a string that spells one, not true"),
    (None, "a number is expected, or a string that spells one, not null"),
])
def test_other_scalars_are_refused(value, reason):
    with pytest.raises(FormatError) as caught:
        scalar(value)
    assert (caught.value.place, caught.value.reason) == ("", reason)


@pytest.mark.parametrize("value, place, reason", [
    (["1"], "", "a point is a list of two scalars, not a list of 1"),
    (["1", "2", "3"], "", "a point is a list of two scalars, not a list of 3"),
    ("12", "", "a point is a list of two scalars, not the string '12'"),
    (["1", "y"], "[1]", "'y' is not an integer, a finite decimal or a fraction p/q"),
])
def test_other_points_are_refused(value, place, reason):
    with pytest.raises(FormatError) as caught:
        point(value)
    assert (caught.value.place, caught.value.reason) == (place, reason)


@pytest.mark.parametrize("value, reason", [
    (Number("3"), "vertex 3 does not exist (there are 3)"),
    (Number("-1"), "vertex -1 does not exist (there are 3)"),
    (Number("9" * 5000), "vertex " + "9" * 37 + "... does not exist (there are 3)"),
    (Number("1.0"), "a vertex index is expected, not the number 1.0"),
    ("1", "a vertex index is expected, not the string '1'"),
    (False, "a vertex index is expected, not false"),
])
def test_other_indices_are_refused(value, reason):
    with pytest.raises(FormatError) as caught:
        vertex_index(value, 3)
    assert caught.value.reason == reason


def test_places_are_put_together_from_inside():
    with pytest.raises(FormatError) as caught:
        each([["1"], ["1", None]], "a", lambda item: each(item, "", scalar))
    assert caught.value.place == "a[1][1]"


@pytest.mark.parametrize("value, place, reason", [
    ([], "", "an object of format 'f/1' is expected, not a list of 0"),
    ({"a": None}, "", "the key 'format' is missing; it should be 'f/1'"),
    ({"format": "g/1", "a": None}, "format", "'f/1' is expected here, not the string 'g/1'"),
    ({"format": "f/1"}, "", "the key 'a' is missing"),
    ({"format": "f/1", "a": None, "c\n": None}, "", r"unknown key 'c\n'; f/1 has format, a, b"),
])
def test_other_objects_are_refused(value, place, reason):
    with pytest.raises(FormatError) as caught:
        fields(value, "f/1", ("a",), ("b",))
    assert (caught.value.place, caught.value.reason) == (place, reason)


def test_an_optional_key_may_be_there_or_not():
    for value in ({"format": "f/1", "a": None}, {"format": "f/1", "a": None, "b": None}):
        assert fields(value, "f/1", ("a",), ("b",)) is value


def test_rows_are_lines():
    assert rows([]) == "[]"
    assert rows(["1", "2"]) == "[\n  1,\n  2]"


@pytest.mark.parametrize("count", [0, 1, 2, 4095, 4096, 4097, 8192, 8193])
def test_the_parts_of_a_list_are_the_list(count):
    items = [str(i) for i in range(count)]
    parts = list(row_parts(items))
    assert "".join(parts) == rows(items) == ("[\n  " + ",\n  ".join(items) + "]" if items else "[]")
    assert json.loads(rows(items)) == list(range(count))
    assert max(map(len, parts)) < 10 * 4096
