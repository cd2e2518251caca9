"""The options that limit what a file may ask for, on every command that reads one."""

import argparse
from contextlib import AbstractContextManager, nullcontext

from exactmesh.io.limits import Limits, limited

DEFAULT = Limits()
_ABOUT = {"bytes": "bytes", "digits": "digits of one number, in a row or by its exponent", "items": "items of lists"}


def add_limits(command: argparse.ArgumentParser, default: tuple[int, int, int] = DEFAULT) -> None:
    """Add `--max-bytes`, `--max-digits` and `--max-items`."""
    group = command.add_argument_group("limits", "What a file may ask for before it is refused.")
    for (name, about), value in zip(_ABOUT.items(), default, strict=True):
        group.add_argument(f"--max-{name}", metavar="N", type=_limit, default=value,
                           help=f"{about} (default: %(default)s)")


def limits_of(args: argparse.Namespace) -> AbstractContextManager[None]:
    """Return the context in which the limits hold that a command line asks for."""
    return limited(Limits(args.max_bytes, args.max_digits, args.max_items)) if "max_bytes" in args else nullcontext()


def _limit(text: str) -> int:
    if not (text.isdecimal() and text.isascii() and len(text) <= 15 and int(text)):
        raise argparse.ArgumentTypeError(f"{text!r} is not a positive number of at most 15 digits")
    return int(text)
