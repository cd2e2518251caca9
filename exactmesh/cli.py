"""The command line: arguments in, exit status out. No geometry here.

Exit status: 0 all that was asked for holds; 1 a claim fails (results are still written, the witness is printed);
2 usage or input refused; 130 interrupted.
"""

import contextlib
import os
import sys
from collections.abc import Sequence

from exactmesh.commands.exit_status import FAILS, INTERRUPTED, REFUSED
from exactmesh.commands.limits import limits_of
from exactmesh.commands.parser import parser_of
from exactmesh.errors import ConstructionFailed, InputError


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; return its exit status."""
    words = sys.argv[1:] if argv is None else argv
    try:
        args = parser_of(words[0] if words else "").parse_args(words)
        with limits_of(args):
            status: int = args.run(args)
        if sys.stdout is not None:  # None when the caller has closed it
            sys.stdout.flush()
        return status
    except InputError as error:
        if isinstance(error.__cause__, BrokenPipeError):
            _abandon_output()
            return FAILS
        print(f"exactmesh: {error}", file=sys.stderr)
        return REFUSED
    except ConstructionFailed as error:
        print(f"exactmesh: {error}\nThis is a counterexample to the construction: please report the input.",
              file=sys.stderr)
        return FAILS
    except KeyboardInterrupt:
        print("exactmesh: interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _abandon_output()
        return FAILS
    except OSError as error:
        # Files are left to `exactmesh.io`, which raises `InputError`: this is standard output.
        _abandon_output()
        print(f"exactmesh: standard output: cannot be written: {error.strerror or error}", file=sys.stderr)
        return REFUSED


def _abandon_output() -> None:
    """Leave nothing for the interpreter to flush into a pipe without a reader, or onto a full disk."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
