"""Options and arguments that several commands share."""

import argparse
import os
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from exactmesh.errors import InputError
from exactmesh.io.read import Source, read_pslg
from exactmesh.io.text import printable
from exactmesh.numbers.rational import rational_from_text
from exactmesh.planar.bounding_box import with_bounding_box
from exactmesh.planar.pslg import Pslg

if TYPE_CHECKING:
    Subparsers = argparse._SubParsersAction[argparse.ArgumentParser]
else:
    Subparsers = object


def add_quiet(command: argparse.ArgumentParser) -> None:
    """Add `--quiet`."""
    command.add_argument("--quiet", action="store_true", help="no progress and no summary")


def add_box(command: argparse.ArgumentParser) -> None:
    """Add `--bounding-box`, which `read_source` obeys."""
    command.add_argument("--bounding-box", metavar="MARGIN",
                         help="put the input into an upright rectangle this far away on every side: the outside "
                         "becomes part of the domain")


def read_source(args: argparse.Namespace, path: str) -> Source:
    """Return the PSLG in a file, within a box where one is asked for."""
    source = read_pslg(path)
    if args.bounding_box is None:
        return source
    return replace(source, pslg=with_bounding_box(source.pslg, rational_from_text(args.bounding_box, "--bounding-box")))


def read_polygons(paths: Sequence[str], *others: str) -> list[Pslg]:
    """Return the PSLGs in files; raises `InputError` when there is one only, or standard input is named twice."""
    if len(paths) < 2:
        raise InputError("a dissection is of two polygons or more")
    if [*paths, *others].count("-") > 1:
        raise InputError("standard input can be read once only")
    return [read_pslg(path).pslg for path in paths]


def make_folder(path: str) -> None:
    """Make a folder where there is none; raises `InputError`."""
    if path == "-":
        raise InputError("several files are written: -o needs a folder, not standard output")
    try:
        os.makedirs(path, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise InputError(f"{printable(path)}: no folder can be made: {reason}") from error


def count(text: str) -> int:
    """Return the whole number that an argument is; raises `argparse.ArgumentTypeError`."""
    if not (text.isdecimal() and text.isascii() and len(text) <= 9):
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of at most nine digits")
    return int(text)


def positive(text: str) -> int:
    """Return the positive whole number that an argument is; raises `argparse.ArgumentTypeError`."""
    if not text.isdecimal() or len(text) > 9 or int(text) == 0:
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive whole number")
    return int(text)
