"""Files are recognized by content, and every error begins with the path."""

import errno
import gc
import hashlib
import io
import json
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exactmesh.errors import FormatError, InputError
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.read import MeshSource, Source, read_mesh, read_pslg
from exactmesh.io.triangle_poly import poly_from_pslg
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import polygon

TRIANGLE = polygon([(0, 0), ("0.5", 0), (0, 1)])
MESH = Mesh("classic", TRIANGLE.vertices, ((0, 1, 2),))
TEXTS = {
    "pslg": json_from_pslg(TRIANGLE),
    "geojson": '\n {"coordinates": [[[0, 0], [0.5, 0], [0, 1], [0, 0]]], "type": "Polygon"}',
    "wkt": " polygon((0 0, 0.5 0, 0 1, 0 0))",
    "poly": "# from 0\n\n" + poly_from_pslg(TRIANGLE),
}
NAMES = ["a.json", "a.geojson", "a.wkt", "a.poly", "a", "a.txt"]


@pytest.fixture
def file(tmp_path):
    def write(content, name="a"):
        path = tmp_path / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return str(path)
    return write


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("kind", TEXTS)
def test_the_content_decides_and_not_the_name(file, kind, name):
    path = file(TEXTS[kind], name)
    digest = hashlib.sha256(TEXTS[kind].encode()).hexdigest()
    assert read_pslg(path) == Source(TRIANGLE, digest, path)


@pytest.mark.parametrize("kind", TEXTS)
def test_a_byte_order_mark_and_foreign_line_ends_do_no_harm(file, kind):
    data = b"\xef\xbb\xbf" + TEXTS[kind].replace("\n", "\r\n").encode()
    assert read_pslg(file(data)).pslg == TRIANGLE


def test_a_mesh(file):
    text = json_from_mesh(MESH)
    path = file(text)
    assert read_mesh(path) == MeshSource(MESH, hashlib.sha256(text.encode()).hexdigest(), path)


def test_a_dash_is_standard_input(monkeypatch):
    for read, text in ((read_pslg, TEXTS["wkt"]), (read_mesh, json_from_mesh(MESH))):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
        assert read("-").path == "-"
    for text, message in (("", "standard input: the file is empty"),
                          ("0\n0\n0",
                           "standard input: the vertices are in a .node file, which is not at hand")):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
        with pytest.raises(FormatError) as caught:
            read_pslg("-")
        assert str(caught.value) == message


def test_vertices_in_the_node_file_beside(file):
    whole = poly_from_pslg(TRIANGLE)
    node, rest = whole[:whole.index("3 0\n")], "0 2 0 0\n" + whole[whole.index("3 0\n"):]
    path = file(rest, "b.1.poly")
    with pytest.raises(InputError) as caught:
        read_pslg(path)
    assert str(caught.value) == f"{path}: the vertices are in {path[:-5]}.node: no such file"
    file(node, "b.1.node")
    digest = hashlib.sha256((rest + node).encode()).hexdigest()
    assert read_pslg(path) == Source(TRIANGLE, digest, path)
    file(b"\xff", "b.1.node")
    with pytest.raises(FormatError) as caught:
        read_pslg(path)
    assert str(caught.value) == f"{path}: .node byte 0: this is not UTF-8 text"


KNOWN = "known are exactmesh-pslg/1, GeoJSON, WKT, WKB, Triangle's .poly, SVG, DXF and CG:SHOP instances"


@pytest.mark.parametrize("content, message", [
    ("", "the file is empty"),
    (b"\xef\xbb\xbf\n", "the file is empty"),
    (b"\x89PNG\r\n", "byte 0: this is not UTF-8 text"),
    (b"POINT\0", "byte 5: a NUL byte: this is not a text file"),
    ("hello\nworld", rf"not a format we know: it begins with 'hello\nworld'; {KNOWN}"),
    ("x,y\n1,2", rf"not a format we know: it begins with 'x,y\n1,2'; {KNOWN}"),
    ("1,2\n3,4", rf"not a format we know: it begins with '1,2\n3,4'; {KNOWN}"),
    ("# nothing", f"not a format we know: it begins with '# nothing'; {KNOWN}"),
    ("NaN", f"not a format we know: it begins with 'NaN'; {KNOWN}"),
    ("[1, 2]", f"not a format we know: the JSON is a list of 2; {KNOWN}"),
    ('"x"', f"not a format we know: the JSON is the string 'x'; {KNOWN}"),
    ('{"a": 1}', f'not a format we know: the JSON is an object without "format" or "type"; {KNOWN}'),
    ('{"type": "Point", "coordinates": [NaN, 0]}', "line 1, column 35: NaN is not a number in JSON"),
    ('{"type": "Point"', "line 1, column 17: invalid JSON: Expecting ',' delimiter"),
    ('{"format": "exactmesh-mesh/1"}',
     "format: 'exactmesh-pslg/1' is expected here, not the string 'exactmesh-mesh/1'"),
    ("SRID=1;POINT(0 0)",
     "line 1, column 1: this is EWKT: take the SRID away, coordinates are read as they are"),
    ("3 2 0 0", "the file ends where line 1 of 3 of the vertices is expected"),
    ("[" * 100000, "the JSON is nested too deeply"),
])
def test_what_is_not_known_is_refused(file, content, message):
    path = file(content)
    with pytest.raises(FormatError) as caught:
        read_pslg(path)
    assert str(caught.value) == f"{path}: {message}"
    assert caught.value.place.startswith(path)


@pytest.mark.parametrize("name, message", [
    ("a.JSON", "line 1, column 1: invalid JSON: Expecting value"),
    ("a.geojson", "line 1, column 1: invalid JSON: Expecting value"),
    ("a.wkt", "line 1, column 1: one of POINT, "),
    ("a.poly", "line 1: the number of vertices is expected, not 'circle'"),
])
def test_the_name_chooses_the_message_when_the_content_says_nothing(file, name, message):
    path = file("circle", name)
    with pytest.raises(FormatError) as caught:
        read_pslg(path)
    assert str(caught.value).startswith(f"{path}: {message}")


@pytest.mark.parametrize("content, message", [
    (TEXTS["pslg"], "format: 'exactmesh-mesh/1' is expected here, not the string 'exactmesh-pslg/1'"),
    (TEXTS["wkt"], "not a mesh: exactmesh-mesh/1 is expected, not 'polygon((0 0, 0.5 0, 0 1, 0 0))'"),
    ("hello", f"not a format we know: it begins with 'hello'; {KNOWN}"),
    ("", "the file is empty"),
    ("[]", "an object of format 'exactmesh-mesh/1' is expected, not a list of 0"),
])
def test_what_is_no_mesh_is_refused(file, content, message):
    path = file(content)
    with pytest.raises(FormatError) as caught:
        read_mesh(path)
    assert str(caught.value) == f"{path}: {message}"


@pytest.mark.parametrize("read", [read_pslg, read_mesh])
def test_what_the_system_refuses(read, tmp_path, monkeypatch):
    def message(path):
        with pytest.raises(InputError) as caught:
            read(path)
        return str(caught.value)

    assert message(str(tmp_path)) == f"{tmp_path}: this is a directory"
    assert message(f"{tmp_path}/no\nfile") == rf"{tmp_path}/no\nfile: no such file"
    assert message("a\0b") == r"a\x00b: cannot be read: embedded null byte"
    for error, reason in ((PermissionError(errno.EACCES, "x"), "permission denied"),
                          (OSError(errno.EIO, "Input/output error"), "cannot be read: Input/output error")):
        def refuse(*args, error=error):
            raise error
        with monkeypatch.context() as patched:
            patched.setattr("builtins.open", refuse)
            assert message("a.json") == f"a.json: {reason}"


def test_the_collector_is_left_as_it_was(file):
    path = file(TEXTS["wkt"])
    read_pslg(path)
    assert gc.isenabled()
    with pytest.raises(InputError):
        read_pslg(path + "no")
    assert gc.isenabled()
    gc.disable()
    try:
        read_pslg(path)
        assert not gc.isenabled()
    finally:
        gc.enable()


@pytest.fixture(scope="session")
def scratch(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz")


def read_or_refuse(scratch, name, data):
    path = scratch / name
    path.write_bytes(data)
    for read in (read_pslg, read_mesh):
        try:
            read(str(path))
        except InputError as error:
            assert str(error).startswith(f"{path}: ") and "\n" not in str(error)


@given(data=st.binary(max_size=60) | st.text(max_size=60).map(lambda s: s.encode("utf-8", "surrogatepass")),
       name=st.sampled_from(NAMES))
def test_any_bytes_are_read_or_refused(scratch, data, name):
    read_or_refuse(scratch, name, data)


@given(st.data())
def test_a_mutated_file_is_read_or_refused(scratch, data):
    source = data.draw(st.sampled_from([*TEXTS.values(), json_from_mesh(MESH)])).encode()
    for _ in range(data.draw(st.integers(1, 3))):
        at = data.draw(st.integers(0, len(source)))
        new = data.draw(st.binary(max_size=3) | st.sampled_from([b"NaN", b"1e400", b"-", b"[", b"\n", b'"',
                                                                 b"9" * 5000]))
        source = source[:at] + new + source[at + data.draw(st.integers(0, 3)):]
    read_or_refuse(scratch, data.draw(st.sampled_from(NAMES)), source)


def test_json_of_a_value_with_both_keys_is_what_format_says(file):
    value = json.loads(TEXTS["pslg"]) | {"type": "Polygon"}
    with pytest.raises(FormatError, match="unknown key 'type'"):
        read_pslg(file(json.dumps(value)))


def test_a_closed_standard_input_is_said(monkeypatch):
    monkeypatch.setattr("sys.stdin", None)
    with pytest.raises(InputError, match="standard input is closed"):
        read_pslg("-")
