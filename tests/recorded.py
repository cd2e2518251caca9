"""Verdicts in full, compared with those on record.

People read a verdict: how many instances were seen, the worst value, the clause, the place. `tests/steps/verdicts` has
one line for each verdict that a test of a checker names, read once against the input it is about. After a change that
is meant to change them, `RECORD=1 pytest ...` writes them anew, and the difference is to be read.
"""

import hashlib
import os
from collections.abc import Iterable
from pathlib import Path

from gmpy2 import mpq

from exactmesh.measure.verdict import Verdict
from exactmesh.numbers.rational import decimal_text

FOLDER = Path(__file__).parent / "steps" / "verdicts"
LONGEST = 60


def shortened(text: str) -> str:
    """Return a text, or the beginning of a long one with a digest of the whole."""
    digest = hashlib.sha256(text.encode()).hexdigest()[:12]
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}... #{digest}"


def line_of(name: str, verdict: Verdict) -> str:
    """Return all that a verdict says, on one line; long exact values to 20 digits."""
    worst = verdict.worst
    if worst is None:
        value = "-"
    elif isinstance(worst, mpq):
        value = str(worst) if len(str(worst)) <= LONGEST else decimal_text(worst, 20)
    else:
        value = worst.decimal(20)
    said = "-"
    if verdict.witness is not None:
        place = ", ".join(f"{key}={shortened(str(found))}" for key, found in verdict.witness.place.items())
        said = f"{verdict.witness.clause} | {place}"
    return f"{name} | {verdict.holds} | {verdict.instances} | {value} | {said}"


def agree(checker: str, verdicts: Iterable[tuple[str, Verdict]]) -> None:
    """Compare verdicts, each with a name, with those on record for a checker."""
    lines = [line_of(name, verdict) for name, verdict in verdicts]
    path = FOLDER / f"{checker}.txt"
    if "RECORD" in os.environ:
        FOLDER.mkdir(exist_ok=True)
        path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    assert lines == path.read_text(encoding="utf-8").splitlines()
