"""Files appear whole or not at all."""

import os
import stat
import sys
from pathlib import Path

import pytest

from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text


def test_a_file_is_made_and_replaced(tmp_path):
    path = tmp_path / "a.json"
    for text in ("old\n", "new é\n"):
        write_text(str(path), text)
        assert path.read_bytes() == text.encode()
    assert os.listdir(tmp_path) == ["a.json"]


def test_a_name_as_long_as_allowed_is_written(tmp_path):
    write_text(str(tmp_path / ("a" * 255)), "x")
    assert len(os.listdir(tmp_path)[0]) == 255


def test_a_relative_path_is_written(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_text("a", "x")
    assert (tmp_path / "a").read_text() == "x"


@pytest.mark.skipif(os.name != "posix", reason="permission bits")
def test_permissions_are_the_usual_ones_or_kept(tmp_path):
    plain, written = tmp_path / "plain", tmp_path / "written"
    plain.write_text("")
    write_text(str(written), "")
    assert written.stat().st_mode == plain.stat().st_mode
    written.chmod(0o600)
    write_text(str(written), "x")
    assert stat.S_IMODE(written.stat().st_mode) == 0o600


@pytest.mark.skipif(os.name != "posix", reason="links")
def test_a_link_is_followed(tmp_path):
    (tmp_path / "to").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "to" / "file")
    write_text(str(tmp_path / "link"), "x")
    assert (tmp_path / "link").is_symlink() and (tmp_path / "to" / "file").read_text() == "x"


@pytest.mark.skipif(not os.path.exists("/dev/null"), reason="no null device")
def test_a_device_is_not_replaced():
    write_text("/dev/null", "x")
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


@pytest.mark.parametrize("failing", ["fsync", "replace"])
@pytest.mark.parametrize("error",
                         [KeyboardInterrupt(), OSError(28, "No space left on device"), RuntimeError()])
def test_an_interruption_leaves_the_old_file_alone(tmp_path, monkeypatch, failing, error):
    path = tmp_path / "a"
    path.write_text("old")

    def fail(*args):
        raise error

    monkeypatch.setattr(os, failing, fail)
    with pytest.raises(InputError if isinstance(error, OSError) else type(error)) as caught:
        write_text(str(path), "new")
    assert path.read_text() == "old" and os.listdir(tmp_path) == ["a"]
    if isinstance(error, OSError):
        assert str(caught.value) == f"{path}: cannot be written: No space left on device"


def test_text_that_utf_8_cannot_hold_leaves_nothing(tmp_path):
    with pytest.raises(InputError, match="surrogates not allowed"):
        write_text(str(tmp_path / "a"), "\ud800")
    assert os.listdir(tmp_path) == []


def test_a_folder_that_does_not_exist(tmp_path):
    path = str(tmp_path / "no" / "a")
    with pytest.raises(InputError) as caught:
        write_text(path, "x")
    assert str(caught.value) == f"{path}: cannot be written: No such file or directory"


def test_a_folder_itself(tmp_path):
    with pytest.raises(InputError) as caught:
        write_text(str(tmp_path), "x")
    assert str(caught.value) == f"{tmp_path}: cannot be written: Is a directory"


def test_permission_denied(tmp_path, monkeypatch):
    def refuse(*args, **kwargs):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("builtins.open", refuse)
    with pytest.raises(InputError) as caught:
        write_text(str(tmp_path / "a"), "x")
    assert str(caught.value) == f"{tmp_path / 'a'}: cannot be written: Permission denied"


def test_a_nul_in_the_path(tmp_path):
    with pytest.raises(InputError, match=r"a\\x00b: cannot be written"):
        write_text("a\0b", "x")


def test_a_dash_is_standard_output(capsys):
    write_text("-", "x\n")
    assert capsys.readouterr().out == "x\n"


def test_a_closed_standard_output(monkeypatch):
    class Closed:
        def write(self, text):
            raise BrokenPipeError(32, "Broken pipe")

    monkeypatch.setattr(sys, "stdout", Closed())
    with pytest.raises(InputError, match="standard output: cannot be written: Broken pipe"):
        write_text("-", "x")


def test_a_closed_standard_output_is_said(monkeypatch):
    monkeypatch.setattr("sys.stdout", None)
    with pytest.raises(InputError, match="standard output: is closed"):
        write_text("-", "text")


def test_parts_are_written_one_after_the_other_and_none_if_one_fails(tmp_path, capsys):
    path = str(tmp_path / "a")
    write_text(path, (f"{i}\n" for i in range(3)))
    assert Path(path).read_text() == "0\n1\n2\n"

    def failing():
        yield "new"
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        write_text(path, failing())
    assert Path(path).read_text() == "0\n1\n2\n" and os.listdir(tmp_path) == ["a"]
    write_text("-", iter(["ä", "b\n"]))
    assert capsys.readouterr().out == "äb\n"
