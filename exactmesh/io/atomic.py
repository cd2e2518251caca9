"""Write a file so that it appears whole or not at all."""

import contextlib
import os
import secrets
import shutil
import sys
from collections.abc import Iterable
from pathlib import Path

from exactmesh.errors import InputError
from exactmesh.io.text import printable


def write_text(path: str, text: str | Iterable[str]) -> None:
    """Write `text`, as UTF-8, to the file `path`, or to standard output when `path` is `-`; it may come in parts.

    The text goes to a new file in the same folder, which takes the place of `path` once it is on the disk:
    whatever interrupts the writing, `path` holds the old text or the new one, and the new file is gone. A
    link is followed, and permissions are kept. Only what is no regular file (a pipe, a terminal) is written
    in place.

    Raises `InputError`, which begins with the path, when the system refuses.
    """
    _write(path, (text,) if isinstance(text, str) else text)


def write_bytes(path: str, data: bytes) -> None:
    """Write `data` as `write_text` does a text."""
    _write(path, (data,))


def _write(path: str, parts: Iterable[str] | Iterable[bytes]) -> None:
    name = "standard output" if path == "-" else printable(path)
    try:
        if path == "-":
            # Python has no stream there when the shell closed it.
            if sys.stdout is None:
                raise InputError(f"{name}: is closed")
            for part in parts:
                if isinstance(part, str):
                    sys.stdout.write(part)
                else:
                    sys.stdout.flush()
                    sys.stdout.buffer.write(part)
            sys.stdout.flush()
            return
        data = (part.encode() if isinstance(part, str) else part for part in parts)
        if os.path.exists(path) and not os.path.isfile(path):
            with Path(path).open("wb") as file:
                file.writelines(data)
        else:
            _replace(os.path.realpath(path), data)
    except OSError as error:
        raise InputError(f"{name}: cannot be written: {error.strerror or error}") from error
    except ValueError as error:
        # A NUL in the path, or a lone surrogate in path or text: no such file can be made.
        raise InputError(f"{name}: cannot be written: {error}") from error


def _replace(path: str, data: Iterable[bytes]) -> None:
    # The name does not grow with the file's own, which may be as long as the system allows.
    temporary = os.path.join(os.path.dirname(path), f".exactmesh-{secrets.token_hex(8)}.tmp")
    try:
        # Mode "x" never opens a file of someone else, and permissions follow the umask, unlike `mkstemp`.
        with open(temporary, "xb") as file:
            if os.path.exists(path):
                shutil.copymode(path, temporary)
            file.writelines(data)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(temporary)
        raise
