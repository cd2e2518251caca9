"""check.c: compiled without a warning, and to the letter of the same opinion as check.py."""

import random
import re
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from checkers import COMPILER, SOURCE, ByC, build, by_python, sanitized_or_plain
from harm import HARMS, harmed
from test_check import CASES, PSLG
from triples import BASES, base, harmless

from exactmesh import check

pytestmark = pytest.mark.skipif(COMPILER is None, reason="there is no C compiler (cc, gcc or clang)")


@pytest.fixture(scope="module")
def by_c(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ByC]:
    """Return the compiled checker, with sanitizers where the compiler has them."""
    with sanitized_or_plain(tmp_path_factory.mktemp("check")) as program:
        runner = ByC(program)
        yield runner
        runner.close()


def test_it_compiles_without_a_warning_and_is_short(tmp_path: Path) -> None:
    assert build(tmp_path).exists()
    lines = SOURCE.read_text(encoding="ascii").splitlines()
    assert len(lines) <= 1200 and max(map(len, lines)) <= 120
    assert set(re.findall(r"#include (\S+)", SOURCE.read_text())) <= {
        "<stdarg.h>", "<stdint.h>", "<stdio.h>", "<stdlib.h>", "<string.h>"}
    assert not re.search(r"\b(double|float)\b", SOURCE.read_text())


@pytest.mark.parametrize("name", BASES)
def test_both_accept_each_base(name: str, by_c: ByC) -> None:
    for files in (base(name).files(), harmless(name, 3)):
        verdict = by_python(files)
        assert verdict[0] == 0 and by_c(files) == verdict


@pytest.mark.parametrize("place", range(len(CASES)))
def test_both_refuse_with_the_same_line(place: int, by_c: ByC) -> None:
    import copy

    name, _, change = CASES[place]
    triple = copy.deepcopy(base(name))
    triple.files()
    change(triple)
    files = triple.files()
    assert by_c(files) == by_python(files)


@pytest.mark.parametrize("kind", HARMS)
def test_both_agree_on_each_kind_of_harm(kind: str, by_c: ByC) -> None:
    for seed, name in enumerate(("ring with a hole", "square, classic", "midway 100")):
        files = harmed(name, kind, seed + 100)
        if files is not None:
            assert by_c(files) == by_python(files)


def test_both_agree_on_the_same_limits(by_c: ByC) -> None:
    files = base("square").files()
    source = random.Random(1)
    for name, values in (("bytes", [0, 1, 50, *(source.randrange(max(map(len, files))) for _ in range(12))]),
                         ("digits", [0, 1, 2, 5, 9, 12, 40]), ("items", [0, 1, 8, 9, 20, 60, 100])):
        for value in values:
            limits = check.DEFAULT._replace(**{name: value})
            found = check.check(*map(_opened, files), limits)
            assert by_c(files, f"--max-{name}", str(value)) == (0 if found[0] else 1, found[1])


def _opened(data: bytes) -> "check.BinaryIO":
    import io

    return io.BytesIO(data)


def test_both_agree_on_texts_cut_and_changed_at_any_byte(by_c: ByC) -> None:
    text = PSLG.encode()
    source = random.Random(2)
    for end in range(0, len(text), 2):
        files = [text[:end], b"", b""]
        assert by_c(files) == by_python(files)
    for _ in range(150):
        data = bytearray(text)
        data[source.randrange(len(data))] = source.choice(b'09-+.eE/\\u"[]{}:, \n\0\x7f\x80\xff')
        files = [bytes(data), b"{", b""]
        assert by_c(files) == by_python(files)


def test_usage_and_unreadable_files(by_c: ByC, tmp_path: Path) -> None:
    def status(*args: str) -> int:
        done = subprocess.run([str(by_c.program), *args], capture_output=True, timeout=60)
        assert done.stdout == b"" and done.stderr
        return done.returncode

    paths = [str(tmp_path / name) for name in "pmc"]
    for path, data in zip(paths, base("square").files(), strict=True):
        Path(path).write_bytes(data)
    for args in ([], paths[:2], [*paths, "more"], [*paths, "--max-bytes"], [*paths, "--max-bytes", "-1"],
                 [*paths, "--max-digits", "9999999999"], [*paths, "--other"], [*paths[:2], str(tmp_path)],
                 [*paths[:2], str(tmp_path / "missing")], [str(tmp_path), *paths[1:]]):
        assert status(*args) == 2
    if Path("/dev/full").exists():
        with open("/dev/full", "w") as full:
            assert subprocess.run([str(by_c.program), *paths], stdout=full, stderr=subprocess.PIPE).returncode == 2
    shutil.rmtree(tmp_path)
