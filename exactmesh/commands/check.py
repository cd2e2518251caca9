"""The command `check`."""

import argparse

from exactmesh import check
from exactmesh.certificate.part import check_part
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, count


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("check", help="check a mesh by its certificate, as the stand-alone checkers do")
    for name in ("PSLG", "MESH", "CERTIFICATE"):
        command.add_argument(name.lower(), metavar=name, help=f"exactmesh-{name.lower()}/1")
    add_random_part(command)
    add_limits(command, check.DEFAULT)
    command.set_defaults(run=run_check)


def add_random_part(command: argparse.ArgumentParser) -> None:
    """Add `--random-part` and `--seed`, which `run_check` obeys."""
    command.add_argument("--random-part", metavar="K", type=count, help="look at K random faces, edges and vertices of "
                         "what the certificate covers only: may find a fault, proves nothing")
    command.add_argument("--seed", metavar="N", type=count, default=0, help="for --random-part (default: 0)")


def run_check(args: argparse.Namespace) -> int:
    """Check the three files that are named; print one line, return the exit status."""
    if args.random_part is not None:
        valid, line = check_part(args.pslg, args.mesh, args.certificate, args.random_part, args.seed)
        print(line)
        return HOLDS if valid else FAILS
    # The stand-alone checkers take numbers of nine digits.
    limits = [text for name in check.DEFAULT._fields
              for text in (f"--max-{name}", str(min(getattr(args, f"max_{name}"), 999_999_999)))]
    return check.main([*limits, "--", args.pslg, args.mesh, args.certificate])
