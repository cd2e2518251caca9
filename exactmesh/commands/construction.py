"""The options that choose a construction."""

import argparse

from exactmesh.paper import PAPER_CHOICES


def add_construction(command: argparse.ArgumentParser, default: str | None) -> None:
    """Add `--construction`, and `--paper` for what the paper leaves open."""
    command.add_argument("--construction", choices=("repaired", "paper", "coarse"), default=default,
                         help="the repaired construction; the published one to the letter; or the repaired one with "
                         "thinner levels, designed for 17.3, which some inputs break (nonproper meshes)")
    command.add_argument("--paper", metavar="NAME=VALUE", action="append", default=[], type=_paper_option,
                         help="what the paper leaves open, for --construction paper: " + "; ".join(
                             f"{name}={'|'.join(values)}" for name, values in PAPER_CHOICES.items()))


def _paper_option(text: str) -> tuple[str, str]:
    name, _, value = text.partition("=")
    if value not in PAPER_CHOICES.get(name, ()):
        raise argparse.ArgumentTypeError(f"{text!r} is none of the choices")
    return name, value
