"""Sizes beyond the limits are refused before memory is spent, by every reader and on every command."""

import io
import json
import os
import re
import time
import tracemalloc
from collections.abc import Callable
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.certificate.part import check_part
from exactmesh.cli import main
from exactmesh.dissection.dissection_json import dissection_from_json
from exactmesh.errors import FormatError
from exactmesh.io.geojson import pslg_from_geojson
from exactmesh.io.limits import JSON_SEPARATORS, TEXT_SEPARATORS, Limits, bytes_of, check_text, limited
from exactmesh.io.mesh_json import mesh_from_json
from exactmesh.io.pslg_json import pslg_from_json
from exactmesh.io.read import read_pslg
from exactmesh.io.triangle_poly import pslg_from_poly
from exactmesh.io.wkt import pslg_from_wkt

MEGABYTE = 1 << 20
READERS: dict[str, tuple[Callable[[str], object], str]] = {
    "pslg": (pslg_from_json, '{{"format": "exactmesh-pslg/1", "vertices": [["0", {0}]], "edges": []}}'),
    "mesh": (mesh_from_json, '{{"format": "exactmesh-mesh/1", "kind": "proper", "vertices": [[0, {0}]], "faces": []}}'),
    "geojson": (pslg_from_geojson, '{{"type": "Point", "coordinates": [0, {0}]}}'),
    "dissection": (dissection_from_json, '{{"format": "exactmesh-dissection/1", "scales": [{0}], "pieces": []}}'),
    "wkt": (pslg_from_wkt, "POINT (0 {0})"),
    "poly": (pslg_from_poly, "1\n0 0 {0}\n0\n0\n"),
}


def refused(read: Callable[[str], object], text: str) -> str:
    """Return the reason for which a text is refused; little memory goes into the refusal."""
    tracemalloc.start()
    with pytest.raises(FormatError) as caught:
        read(text)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < MEGABYTE // 2
    return caught.value.reason


@pytest.mark.parametrize("name", READERS)
class TestReaders:
    def test_what_is_within_the_limits_is_read(self, name: str) -> None:
        read, frame = READERS[name]
        with limited(Limits(bytes=10_000, digits=30, items=40)):
            read(frame.format("9" * 30))

    def test_a_number_of_a_million_digits(self, name: str) -> None:
        read, frame = READERS[name]
        for shift in (0, 1, 7):
            text = " " * shift + frame.format("1" + "7" * 10**6)
            assert "more than 100000 digits" in refused(read, text)
        with limited(Limits(digits=10**6 + 1)):
            if name != "dissection":  # its expressions have a limit of their own
                read(text)

    def test_many_items(self, name: str) -> None:
        read, frame = READERS[name]
        many = " 1" * 100 if name in ("wkt", "poly") else ", ".join(["1"] * 100)
        with limited(Limits(items=90)):
            assert refused(read, frame.format(many)) == "more than 90 items: --max-items N allows more"

    def test_exponents_of_many_numbers(self, name: str) -> None:
        read, frame = READERS[name]
        number = "1e90000" if name in ("geojson", "wkt", "poly") else '"1e90000"'
        many = (" " if name in ("wkt", "poly") else ", ").join([number] * 20)
        with limited(Limits(bytes=10**6)):
            assert "more than 1000000 bytes when the exponents" in refused(read, frame.format(many))
        with limited(Limits(digits=89_999)):
            assert "more than 89999 digits by the exponent" in refused(read, frame.format(number))


@given(st.text("01e.+-, [\"'a", max_size=40), st.integers(1, 6))
def test_exactly_the_runs_that_are_too_long_are_refused(text: str, digits: int) -> None:
    longest = max(map(len, re.findall(r"\d+", text)), default=0)
    exponents = [int(e) for e in re.findall(r"(?<![\w.])[+-]?[\d.]+e[+-]?(\d+)(?![\w.])", text)]
    with limited(Limits(digits=digits)):
        try:
            check_text(text, ",")
            assert longest <= digits and max(exponents, default=0) <= digits
        except FormatError:
            assert longest > digits or max(exponents, default=0) > digits


def test_numbers_in_escapes_are_seen() -> None:
    digit, letter = "\\u0037", "\\u0065"
    assert json.loads(f'"{digit}{letter}5"') == "7e5"
    with limited(Limits(digits=50)):
        for text in ('"' + digit * 51 + '"', f'"1{letter}51"', f'"{digit}{letter.upper().replace("U", "u")}51"'):
            with pytest.raises(FormatError, match="more than 50 digits"):
                check_text(text, JSON_SEPARATORS)
        check_text('"' + digit * 50 + '"', JSON_SEPARATORS)


def test_words_that_look_like_exponents_are_none() -> None:
    with limited(Limits(digits=50)):
        for text in ("7f3e12345", "abc1e999", "1e999abc", "x.1e77", "1e000000000000000000000000050"):
            check_text(text, TEXT_SEPARATORS)


def test_every_space_separates() -> None:
    text = "POINT(" + "\N{EM SPACE}\x1c\v".join("12345678") + ")"
    assert len(text.replace("(", " ").split()) == 9
    with limited(Limits(items=10)), pytest.raises(FormatError, match="items"):
        pslg_from_wkt(text)


# --- files ---


@pytest.mark.parametrize("name", ["pslg.json", "outline.wkt", "outline.poly", "outline.geojson"])
def test_a_file_of_two_gigabytes_is_not_read(name: str, tmp_path: Path) -> None:
    path = tmp_path / name
    with open(path, "wb") as file:
        file.truncate(2 << 30)  # takes no room
    begin = time.perf_counter()
    tracemalloc.start()
    with pytest.raises(FormatError) as caught:
        read_pslg(str(path))
    assert tracemalloc.get_traced_memory()[1] < MEGABYTE
    tracemalloc.stop()
    assert str(caught.value) == f"{path}: more than 1610612736 bytes: --max-bytes N allows more"
    assert time.perf_counter() - begin < 1


def test_a_pipe_is_read_up_to_the_limit() -> None:
    with limited(Limits(bytes=1000)):
        assert bytes_of(io.BytesIO(b"7" * 1000)) == b"7" * 1000
        endless = open("/dev/zero", "rb") if os.path.exists("/dev/zero") else io.BytesIO(b"7" * 1001)  # noqa: SIM115
        with endless, pytest.raises(FormatError, match="more than 1000 bytes"):
            bytes_of(endless)


def test_a_file_of_just_the_limit_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a"
    for size in (0, 1, 999, 1000):
        path.write_bytes(b"x" * size)
        with limited(Limits(bytes=1000)), open(path, "rb") as file:
            assert bytes_of(file) == b"x" * size


def test_limits_end_with_their_block() -> None:
    with limited(Limits(items=1)), limited(Limits(items=3)):
        check_text("1,2,3", ",")
    check_text("1,2,3", ",")
    with limited(Limits(items=1)), pytest.raises(FormatError, match="items"):
        check_text("1,2,3", ",")


# --- what would take more than linear memory ---


def test_deep_collections_with_many_parts_take_little_memory() -> None:
    depth, parts = 300, 2000
    points = ",".join(['{"type":"Point","coordinates":[1,2]}'] * parts)
    text = '{"type":"GeometryCollection","geometries":[' * depth + points + "]}" * depth
    tracemalloc.start()
    assert len(pslg_from_geojson(text).vertices) == 1
    assert tracemalloc.get_traced_memory()[1] < 6 * MEGABYTE
    tracemalloc.stop()


def test_polygons_within_polygons_take_little_memory() -> None:
    count = 600
    rings = ", ".join(f"(({-i} {-i}, {i} {-i}, {i} {i}, {-i} {i}, {-i} {-i}))" for i in range(1, count + 1))
    tracemalloc.start()
    assert not pslg_from_wkt(f"MULTIPOLYGON ({rings})").holes
    assert tracemalloc.get_traced_memory()[1] < 6 * MEGABYTE  # with the rings around all faces: 14
    tracemalloc.stop()


# --- the command line ---


@pytest.mark.parametrize("words", [["mfs"], ["ifs"], ["mesh"], ["verify", "{}"], ["dissect", "-o", "-", "{}"],
                                   ["verify-dissection", "{}", "{}"], ["claims", "lemma-1.side-distance", "--on"]])
def test_every_command_has_the_limits(words: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "a.wkt"
    path.write_text("POLYGON ((0 0, 12345 0, 0 1, 0 0))")
    for option, reason in (("bytes", "bytes"), ("digits", "digits in a number at character 15"), ("items", "items")):
        status = main([*(word.format(path) for word in words), str(path), f"--max-{option}", "4"])
        assert status == 2
        assert capsys.readouterr().err == (
            f"exactmesh: {path}: more than 4 {reason}: --max-{option} N allows more\n")


def test_a_limit_is_a_positive_number(capsys: pytest.CaptureFixture[str]) -> None:
    for text in ("0", "-1", "x", "1e3", "9" * 16):
        with pytest.raises(SystemExit) as caught:
            main(["mfs", "-", "--max-digits", text])
        assert caught.value.code == 2 and "is not a positive number" in capsys.readouterr().err


def test_a_random_part_of_a_certificate_has_the_limits(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    path.write_text('{"vertices": ["' + "7" * 101 + '"]}')
    with limited(Limits(digits=100)):
        assert check_part(str(path), str(path), str(path), 1, 0) == (
            False, "INVALID size: PSLG: more than 100 digits in a number at character 15: --max-digits N allows more")
