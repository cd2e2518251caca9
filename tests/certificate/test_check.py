"""check.py: alone, strict, and every clause of it refused once by hand."""

import ast
import io
import json
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from checkers import by_python
from triples import BASES, base

from exactmesh import check

SOURCE = Path(check.__file__)
TREE = ast.parse(SOURCE.read_text(encoding="utf-8"))


def changed(name: str, change: Callable[[Any], object], keep_hashes: bool = False) -> tuple[int, str]:
    """Return the verdict on a base with one change."""
    import copy

    triple = copy.deepcopy(base(name))
    triple.files()
    change(triple)
    return by_python(triple.files(keep_hashes))


# --- the file stands alone ---


def test_it_is_short_and_imports_the_standard_library_only() -> None:
    assert len(SOURCE.read_text().splitlines()) <= 700
    names = {alias.name for node in ast.walk(TREE) if isinstance(node, ast.Import) for alias in node.names}
    names |= {str(node.module) for node in ast.walk(TREE) if isinstance(node, ast.ImportFrom)}
    assert {name.split(".")[0] for name in names} <= set(sys.stdlib_module_names)
    assert not any(isinstance(node, ast.ImportFrom) and node.level for node in ast.walk(TREE))


def test_no_float_and_no_division_that_rounds_is_in_it() -> None:
    for node in ast.walk(TREE):
        assert not (isinstance(node, ast.Constant) and isinstance(node.value, float))
        assert not isinstance(node, ast.Div)
        assert not (isinstance(node, ast.Name) and node.id in ("float", "Fraction", "Decimal", "eval", "exec"))


def test_no_function_reaches_itself() -> None:
    functions = {node.name: node for node in ast.walk(TREE) if isinstance(node, ast.FunctionDef)}
    calls = {name: {call.func.id if isinstance(call.func, ast.Name) else call.func.attr
                    for call in ast.walk(node) if isinstance(call, ast.Call)
                    and isinstance(call.func, ast.Name | ast.Attribute)} & set(functions)
             for name, node in functions.items()}
    # Names of methods of the standard library that are also ours.
    calls["count"].discard("count")
    for _ in functions:
        calls = {name: reached | {far for near in reached for far in calls[near]} for name, reached in calls.items()}
    assert [name for name, reached in calls.items() if name in reached] == []


def test_it_runs_as_a_file_in_an_empty_folder(tmp_path: Path) -> None:
    (tmp_path / "check.py").write_bytes(SOURCE.read_bytes())
    for name, data in zip("pmc", base("ring with a hole").files(), strict=True):
        (tmp_path / name).write_bytes(data)

    def run(*args: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([sys.executable, "-I", "-S", "check.py", *args], cwd=tmp_path, capture_output=True,
                              text=True, timeout=60)

    done = run("p", "m", "c")
    assert (done.returncode, done.stderr) == (0, "") and done.stdout.startswith("VALID nonproper mesh: mfs_squared >= ")
    assert done.stdout.count("\n") == 1
    done = run("m", "p", "c")
    assert (done.returncode, done.stdout) == (1, 'INVALID format: PSLG: byte 11: "exactmesh-pslg/1" expected\n')
    for args in (("p", "m"), ("p", "m", "missing"), ("p", "m", "."), ("p", "m", "\0"), ("p", "m", "c", "--max-bytes"),
                 ("p", "m", "c", "--max-bytes", "x"), ("p", "m", "c", "--max-digits", "9999999999"), ()):
        if "\0" in args:
            continue
        done = run(*args)
        assert done.returncode == 2 and done.stdout == "" and "Traceback" not in done.stderr, args
    done = run("p", "m", "c", "--max-items", "20")
    assert (done.returncode, done.stdout) == (1, "INVALID size: PSLG: more than 20 items\n")


def test_a_standard_output_that_is_full_is_no_verdict(tmp_path: Path) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("there is no /dev/full")
    paths = []
    for name, data in zip("pmc", base("square").files(), strict=True):
        (tmp_path / name).write_bytes(data)
        paths.append(str(tmp_path / name))
    with open("/dev/full", "w") as full:
        done = subprocess.run([sys.executable, str(SOURCE), *paths], stdout=full, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 2 and "Traceback" not in done.stderr


# --- each clause ---


def clauses() -> set[str]:
    """Return every clause that the source can name."""
    return {node.args[0].value for node in ast.walk(TREE) if isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name) and node.func.id == "Refused"
            and isinstance(node.args[0], ast.Constant)}


def put(document: str, key: str, value: object) -> Callable[[Any], object]:
    return lambda t: getattr(t, document).__setitem__(key, value)


def swap(rows: list[Any]) -> None:
    rows[0], rows[1] = rows[1], rows[0]


def double(face: list[int]) -> list[int]:
    return [*face[:1], *face]


CASES: list[tuple[str, str, Callable[[Any], object]]] = [
    ("square", "size: MESH: byte", lambda t: t.mesh["vertices"][4].__setitem__(0, "9" * 5000)),
    ("square", "format: CERTIFICATE: byte", put("certificate", "witness", "none")),
    ("square", "format: MESH: no kind", lambda t: t.mesh.pop("kind")),
    ("square", "kind: MESH", put("mesh", "kind", "internal")),
    ("square", "index: PSLG: edge 1", lambda t: t.pslg["edges"].__setitem__(1, [0, 4])),
    ("square", "index: PSLG: edge 2", lambda t: t.pslg["edges"].__setitem__(2, [0, 1, 2])),
    ("square", "index: MESH: face 0", lambda t: t.mesh["faces"][0].__setitem__(0, len(t.mesh["vertices"]))),
    ("square", "index: CERTIFICATE: face 0", lambda t: t.certificate["faces"][0].__setitem__(0, 999)),
    ("square", "index: CERTIFICATE: witness", put("certificate", "witness", [0, 1])),
    ("square", "index: CERTIFICATE: witness", put("certificate", "witness", [0, 1, 4])),
    ("square", "index: CERTIFICATE: hole_faces", put("certificate", "hole_faces", [0])),
    ("ring with a hole", "index: CERTIFICATE: hole_faces", put("certificate", "hole_faces", [999])),
    ("square", "input-vertices: vertex 0", lambda t: swap(t.pslg["vertices"])),
    ("square", "input-vertices: vertex", lambda t: t.pslg["vertices"].extend(
        [["50", str(v)] for v in range(len(t.mesh["vertices"]))])),
    ("square", "steiner: vertex 4", put("mesh", "kind", "classic")),
    ("square", "domain: MESH: no face", put("mesh", "faces", [])),
    ("square", "bound: mfs_squared_at_least is not positive", put("certificate", "mfs_squared_at_least", "0")),
    ("square", "face-shape: mesh face 1", lambda t: t.mesh["faces"][1].reverse()),
    ("square", "face-shape: rest face 1", lambda t: t.certificate["faces"][1].reverse()),
    ("square", "face-shape: mesh face 0", lambda t: t.mesh["faces"].__setitem__(0, double(t.mesh["faces"][0]))),
    ("comb", "face-size: mesh face", put("mesh", "kind", "proper")),
    ("square", "feature: mesh face", put("certificate", "mfs_squared_at_least", "1000")),
    ("square, classic", "feature: rest face", lambda t: t.certificate["vertices"].__setitem__(1, ["1000", "-8"])),
    ("square", "box: CERTIFICATE", lambda t: t.certificate["vertices"][0].__setitem__(0, "-9")),
    ("square", "box: CERTIFICATE", lambda t: t.certificate["vertices"][3].__setitem__(0, "-9")),
    ("square", "overlap: edge", lambda t: t.mesh["faces"].append(t.mesh["faces"][0])),
    ("square", "boundary: edge", lambda t: t.certificate["faces"].pop()),
    ("square", "boundary: edge", lambda t: t.certificate.__setitem__("faces", [])),
    ("square", "unused-vertex: vertex", lambda t: t.certificate["vertices"].append(["0", "1"])),
    ("ring with a hole", "input-edge: edge 8", lambda t: t.pslg["edges"].append([0, 6])),
    ("square", "repeated-edge: edge 4", lambda t: t.pslg["edges"].append([1, 0])),
    ("square, classic", "border: edge", lambda t: t.certificate["faces"].append(t.mesh["faces"].pop())),
    ("ring with a hole", "hole: hole 0: not inside", lambda t: t.pslg["holes"][0].__setitem__(0, "1")),
    ("ring with a hole", "hole: hole 0: not inside", lambda t: t.pslg["holes"].__setitem__(0, ["3", "3"])),
    ("ring with a hole", "hole: hole 0: not inside", lambda t: t.pslg["holes"].__setitem__(0, ["4", "3"])),
    ("ring with a hole", "hole: hole 1: outside", lambda t: (
        t.pslg["holes"].append(t.certificate["vertices"][0]), t.certificate["hole_faces"].append(
            next(i for i, face in enumerate(t.certificate["faces"]) if len(t.mesh["vertices"]) in face)))),
    ("ring with a hole", "domain: rest face", lambda t: (t.pslg["holes"].clear(),
                                                         t.certificate["hole_faces"].clear())),
    ("square", "witness: no pair of the input", put("certificate", "witness", [0, 0, 1])),
    ("square", "witness: no pair of the input", put("certificate", "witness", [1, 0, 2])),
    ("square", "witness: input_mfs_squared_at_most", put("certificate", "witness", [0, 2, 2])),
    ("square", "witness: input_mfs_squared_at_most", put("certificate", "input_mfs_squared_at_most", "15")),
    ("square", "claim: degradation_squared_at_most", put("certificate", "degradation_squared_at_most", "1")),
    ("square", "claim: mfs_at_least", put("certificate", "mfs_at_least", "1")),
    ("square", "claim: mfs_at_least", put("certificate", "mfs_at_least", "-1/9")),
    ("square", "claim: degradation_at_most", put("certificate", "degradation_at_most", "1")),
    ("square", "claim: degradation_at_most", put("certificate", "degradation_at_most", "-100"))]


@pytest.mark.parametrize("name, line, change", CASES, ids=[f"{i} {case[1]}" for i, case in enumerate(CASES)])
def test_each_clause_is_refused(name: str, line: str, change: Callable[[Any], object]) -> None:
    status, found = changed(name, change)
    if line.startswith("feature: rest"):  # the box is moved first
        assert status == 1
        return
    assert status == 1 and found.startswith(f"INVALID {line}"), found


def test_hashes_are_compared() -> None:
    for key, name in (("pslg_sha256", "PSLG"), ("mesh_sha256", "MESH")):
        assert changed("square", put("certificate", key, "0" * 64), True) == (1, f"INVALID hash: {name}")


def test_no_clause_is_without_a_case() -> None:
    assert clauses() == {line.split(":")[0] for _, line, _ in CASES} | {"hash"}
    text = SOURCE.parent.parent.joinpath("docs", "certificate.md").read_text(encoding="utf-8")
    assert clauses() <= set(re.findall(r"`([a-z-]+)`", text))


def test_what_the_bound_says_is_exact() -> None:
    from fractions import Fraction

    for name in BASES:
        least = Fraction(base(name).certificate["mfs_squared_at_least"])
        raised = least + Fraction(1, least.denominator * 10**40)
        status, line = changed(name, put("certificate", "mfs_squared_at_least", str(raised)))
        assert status == 1 and line.startswith("INVALID feature")


# --- reading ---


PSLG = '{"format": "exactmesh-pslg/1", "vertices": [["0", "-1/3"], [2, "1e1"]], "edges": [[0, 1]], "name": "a\\u00e9"}'


def read(text: str | bytes, limits: check.Limits = check.DEFAULT) -> dict[str, Any]:
    data = text if isinstance(text, bytes) else text.encode()
    return check.read_object(check.Tokens(io.BytesIO(data), "PSLG", limits), check.PSLG)


@pytest.mark.parametrize("block", [1, 2, 3, 7, 64, 65536])
def test_where_blocks_end_does_not_matter(block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = [by_python(base(name).files()) for name in ("square", "ring with a hole, rest meshed")]
    monkeypatch.setattr(check, "_BLOCK", block)
    assert whole == [by_python(base(name).files()) for name in ("square", "ring with a hole, rest meshed")]
    found = read(PSLG)
    assert found["vertices"] == [(0, -1, 3), (2, 10, 1)] and found["edges"][0].tolist() == [0, 1]
    assert found["name"] == "a\\u00e9"
    for end in range(len(PSLG)):
        with pytest.raises(check.Refused, match=r"format: PSLG: byte \d+: .* expected"):
            read(PSLG[:end])
    with pytest.raises(check.Refused, match="format: PSLG: byte 11: a string"):
        check.read_object(check.Tokens(io.BytesIO(b'{"name" :  [1]}'), "PSLG", check.DEFAULT), check.PSLG)


@pytest.mark.parametrize("text, value", [
    ("5", (5, 1)), ("-0", (0, 1)), ('"-5"', (-5, 1)), ('"+5/10"', (5, 10)), ('"0.125"', (125, 1000)), ('".5"', (5, 10)),
    ('"5."', (5, 1)), ('"-3e-7"', (-3, 10**7)), ('"12.50e1"', (125, 1)), ('"007"', (7, 1)), ('"1E+2"', (100, 1))])
def test_scalars(text: str, value: tuple[int, int]) -> None:
    p, q = check.scalar(check.Tokens(io.BytesIO(f"{text} ".encode()), "PSLG", check.DEFAULT))
    assert p * value[1] == q * value[0] and q > 0


@pytest.mark.parametrize("text", [
    "", "x", "[", "true", "null", "1.5", "01", "+1", "-", '""', '"."', '"e1"', '"1e"', '"1/0"', '"0/00"', '"1/2/3"',
    '"1 "', '"1_0"', '"\\u0031"', '"1', "'1'", "NaN", '"--1"', '"1/-2"', '"1.5/2"'])
def test_what_is_no_scalar(text: str) -> None:
    with pytest.raises(check.Refused, match="format"):
        check.points(check.Tokens(io.BytesIO(f'[["1", {text}]]'.encode()), "PSLG", check.DEFAULT))


def test_sizes_are_limited_as_they_are_read() -> None:
    class Endless(io.RawIOBase):
        """A file without end: its start, and then one byte again and again."""

        def __init__(self, start: bytes, more: bytes) -> None:
            self.start, self.more, self.given = start, more, 0

        def read(self, size: int = -1) -> bytes:
            data, self.start = self.start or self.more * size, b""
            self.given += len(data)
            return data

    begin = b'{"format": "exactmesh-pslg/1", "vertices": '
    edges = b'{"format": "exactmesh-pslg/1", "edges": ['
    limits = check.Limits(10**7, 4000, 10**5)
    for start, more, what in ((begin + b'[["', b"9", "too long"), (begin + b"[[", b"1", "too long"),
                              (begin, b" ", "more than 10000000 bytes"), (begin, b"[", "a scalar expected"),
                              (edges[:1] + b'"name": "', b"a", "too long"), (edges, b"[],", "more than 100000 items"),
                              (edges + b"[", b"1,", "more than 100000 items")):
        file = Endless(start, more)
        with pytest.raises(check.Refused, match=what):
            check.read_object(check.Tokens(file, "PSLG", limits), check.PSLG)  # type: ignore[arg-type]
        assert file.given < (2 * 10**7 if "bytes" in what else 10**6)


def test_limits_are_exact() -> None:
    digits = '{"format": "exactmesh-pslg/1", "vertices": [["%s", "0"]], "edges": []}'
    for text, length in (("9" * 50, 50), ("1/" + "9" * 50, 50), ("1e49", 50), ("-1e-49", 50), ("." + "1" * 50, 50)):
        assert read(digits % text, check.Limits(digits=length))
        with pytest.raises(check.Refused, match="size: PSLG: byte 45: too long"):
            read(digits % text, check.Limits(digits=length - 1))
    assert read(PSLG, check.Limits(bytes=len(PSLG)))
    with pytest.raises(check.Refused, match=f"more than {len(PSLG) - 1} bytes"):
        read(PSLG, check.Limits(bytes=len(PSLG) - 1))
    assert read(PSLG, check.Limits(items=5))
    with pytest.raises(check.Refused, match="more than 4 items"):
        read(PSLG, check.Limits(items=4))


def test_numbers_beyond_the_interpreters_limit_are_read() -> None:
    text = "7" * 20000
    value = check.integer(text.encode())
    assert value % 10**9 == 777777777 and value.bit_length() > 66000
    assert value == 7 * (10**20000 - 1) // 9


def test_it_is_checked_strictly_and_linted_like_the_rest() -> None:
    settings = tomllib.loads(SOURCE.parent.parent.joinpath("pyproject.toml").read_text())
    assert settings["tool"]["mypy"]["strict"] and settings["tool"]["mypy"]["packages"] == ["exactmesh"]


def test_every_key_of_a_certificate_is_needed() -> None:
    for key in base("square").certificate:
        status, line = changed("square", lambda t, key=key: t.certificate.pop(key), True)  # type: ignore[misc]
        assert (status, line) == (1, f"INVALID format: CERTIFICATE: no {key}")
    assert json.loads(base("square").files()[0])["format"] == "exactmesh-pslg/1"
