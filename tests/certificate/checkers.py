"""Both checkers as functions of three files' bytes."""

import io
import shutil
import subprocess
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import exactmesh
from exactmesh import check

SOURCE = Path(exactmesh.__file__).with_name("check.c")
COMPILER = next((path for name in ("cc", "gcc", "clang") if (path := shutil.which(name))), None)
FLAGS = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]
SECONDS = 60


def by_python(files: Sequence[bytes]) -> tuple[int, str]:
    """Return exit status and verdict of check.py."""
    valid, line = check.check(*map(io.BytesIO, files))
    return 0 if valid else 1, line


def build(folder: Path, *flags: str) -> Path:
    """Compile check.c; raises `CalledProcessError` with the compiler's words."""
    target = folder / "check"
    subprocess.run([str(COMPILER), *FLAGS, *(flags or ("-O2",)), "-o", str(target), str(SOURCE)], check=True,
                   capture_output=True, text=True)
    return target


@contextmanager
def sanitized_or_plain(folder: Path) -> Iterator[Path]:
    """Build with the address and undefined-behaviour sanitizers where they are there."""
    try:
        yield build(folder, "-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all")
    except subprocess.CalledProcessError:
        yield build(folder)


class ByC:
    """check.c, compiled, called with files in a folder of its own."""

    def __init__(self, program: Path) -> None:
        self.program = program
        self.folder = Path(tempfile.mkdtemp(prefix="exactmesh-check-"))
        self.paths = [self.folder / name for name in ("pslg.json", "mesh.json", "certificate.json")]

    def __call__(self, files: Sequence[bytes], *flags: str) -> tuple[int, str]:
        """Return exit status and verdict; what is on standard error is an error of its own."""
        for path, data in zip(self.paths, files, strict=True):
            path.write_bytes(data)
        done = subprocess.run([str(self.program), *map(str, self.paths), *flags], capture_output=True, timeout=SECONDS)
        if done.stderr:
            return done.returncode, "CRASH " + done.stderr.decode(errors="replace")
        return done.returncode, done.stdout.decode().removesuffix("\n")

    def close(self) -> None:
        shutil.rmtree(self.folder)
