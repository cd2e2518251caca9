"""check.py in detail: the command line, limits to the unit, what a place is called, and the geometry by itself."""

import sys
from collections.abc import Sequence
from pathlib import Path

import pytest
from triples import base

from exactmesh import check

# --- the command line ---


@pytest.fixture
def paths(tmp_path: Path) -> list[str]:
    """Return the paths of a valid triple."""
    found = []
    for name, data in zip(("pslg", "mesh", "certificate"), base("square").files(), strict=True):
        (tmp_path / name).write_bytes(data)
        found.append(str(tmp_path / name))
    return found


def refused_usage(args: Sequence[str], capsys: pytest.CaptureFixture[str]) -> str:
    """Return what is written on standard error about arguments that are refused."""
    with pytest.raises(SystemExit) as caught:
        check.main(args)
    assert caught.value.code == 2
    return capsys.readouterr().err


def test_one_line_and_the_status(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert check.main(paths) == 0
    t = base("square").certificate
    assert capsys.readouterr() == (
        f"VALID nonproper mesh: mfs_squared >= {t['mfs_squared_at_least']} (mfs >= {t['mfs_at_least']}), "
        f"degradation_squared <= {t['degradation_squared_at_most']} (degradation <= {t['degradation_at_most']})\n", "")
    assert check.main([paths[1], paths[0], paths[2]]) == 1
    assert capsys.readouterr() == ('INVALID format: PSLG: byte 11: "exactmesh-pslg/1" expected\n', "")
    assert check.main([paths[0], paths[0], paths[2]]) == 1
    assert capsys.readouterr() == ('INVALID format: MESH: byte 11: "exactmesh-mesh/1" expected\n', "")
    assert check.main([paths[0], paths[1], paths[1]]) == 1
    assert capsys.readouterr() == ('INVALID format: CERTIFICATE: byte 11: "exactmesh-certificate/1" expected\n', "")


def test_arguments_come_from_the_command_line(paths: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["check.py", *paths])
    assert check.main() == 0


def test_each_limit_is_that_of_its_option(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    size = Path(paths[0]).stat().st_size
    for option, line in ((f"--max-bytes={size - 1}", f"size: PSLG: more than {size - 1} bytes"),
                         ("--max-items=7", "size: PSLG: more than 7 items"),
                         ("--max-digits=0", "size: PSLG: byte 11: too long")):
        assert check.main([*paths, option]) == 1
        assert capsys.readouterr().out == f"INVALID {line}\n"


def test_a_limit_is_a_number_of_nine_digits_at_most(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    for option in ("bytes", "digits", "items"):
        assert check.main([*paths, f"--max-{option}", "999999999"]) == 0
        for text in ("1234567890", "-1", "1x", "x", ""):
            assert f"{text!r} is not a number of at most nine digits" in refused_usage(
                [*paths, f"--max-{option}={text}"], capsys)


def test_what_cannot_be_read_is_named(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    for place in range(3):
        for path in (str(Path(paths[0]).parent), "missing", "a\0b"):
            assert check.main([*paths[:place], path, *paths[place + 1 :]]) == 2
            out, err = capsys.readouterr()
            assert out == "" and err.startswith("check: ") and err.count("\n") == 1
            assert path in err or "null" in err
    assert "the following arguments are required: CERTIFICATE" in refused_usage(paths[:2], capsys)


@pytest.mark.parametrize("error, status, line", [
    (MemoryError(), 2, "check: out of memory"), (KeyboardInterrupt(), 130, "check: interrupted")])
def test_trouble_is_one_line(error: BaseException, status: int, line: str, paths: list[str],
                             capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*args: object) -> tuple[bool, str]:
        raise error

    monkeypatch.setattr(check, "check", fails)
    assert check.main(paths) == status
    assert capsys.readouterr() == ("", f"{line}\n")


def test_the_verdict_is_out_before_the_program_ends(paths: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        """A standard output that takes nothing."""

        def write(self, text: str) -> int:
            return len(text)

        def flush(self) -> None:
            raise OSError("no space")

    monkeypatch.setattr(sys, "stdout", Full())
    assert check.main(paths) == 2


def test_help_says_what_is_needed(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    with pytest.raises(SystemExit):
        check.main(["--help"])
    lines = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]
    assert lines[0].endswith("[--max-bytes N] [--max-digits N] [--max-items N] PSLG MESH CERTIFICATE")
    assert {"Check a mesh and its certificate. Exit status: 0 valid, 1 invalid, 2 usage or unreadable file.",
            "PSLG exactmesh-pslg/1", "MESH exactmesh-mesh/1", "CERTIFICATE exactmesh-certificate/1",
            "--max-bytes N refuse a file with more bytes (default: 268435456)",
            "--max-digits N refuse a file with more digits (default: 4000)",
            "--max-items N refuse a file with more items (default: 20000000)"} <= set(lines)
