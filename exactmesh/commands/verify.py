"""The command `verify`."""

import argparse
import sys

from exactmesh import report
from exactmesh.api import verify
from exactmesh.commands.check import add_random_part, run_check
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_box, add_quiet, read_source
from exactmesh.errors import InputError
from exactmesh.io.read import read_mesh
from exactmesh.numbers.rational import decimal_text, rational_from_text
from exactmesh.progress import Progress


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("verify", help="decide whether a mesh, from anywhere, is valid, and its degradation")
    command.add_argument("pslg", metavar="PSLG")
    command.add_argument("mesh", metavar="MESH", help="exactmesh-mesh/1")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_box(command)
    command.add_argument("--max-degradation", metavar="D", help="also demand that the degradation is at most D")
    command.add_argument("--certificate", metavar="C", help="check this certificate (exactmesh-certificate/1) instead, "
                         "as `check` does")
    add_random_part(command)
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    bound = None
    if args.max_degradation is not None:
        bound = rational_from_text(args.max_degradation, "--max-degradation")
    if args.certificate is not None:
        if args.json or args.bounding_box is not None or bound is not None:
            raise InputError("a certificate has a verdict of its own, for the files as they are: --json, "
                             "--bounding-box and --max-degradation do not go with it")
        return run_check(args)
    if args.random_part is not None:
        raise InputError("--random-part is a part of a certificate: give --certificate C as well")
    if args.pslg == args.mesh == "-":
        raise InputError("PSLG and MESH cannot both be standard input")
    with Progress(args.quiet) as progress:
        progress("reading")
        pslg, candidate = read_source(args, args.pslg).pslg, read_mesh(args.mesh).mesh
        progress("verification")
        verification = verify(pslg, candidate)
    print(report.verification_json(verification) if args.json else report.verification_text(verification))
    if not verification.valid:
        return FAILS
    degradation = verification.degradation_squared
    if bound is not None and degradation is not None and (bound < 0 or degradation > bound * bound):
        print(f"exactmesh: the degradation is above {decimal_text(bound)}", file=sys.stderr)
        return FAILS
    return HOLDS
