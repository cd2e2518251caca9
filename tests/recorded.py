"""Verdicts in full, compared with those on record.

People read a verdict: how many instances were seen, the worst value, the clause, the place; and a bound is a claim.
`tests/steps/verdicts` has one line for each verdict that a test of a checker names, and for each bound, read once
against the input it is about. After a change that is meant to change them, `RECORD=1 pytest ...` writes them anew, and
the difference is to be read.
"""

import hashlib
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType

import pytest
from gmpy2 import mpq

from exactmesh.measure.verdict import Relation, Tally, Verdict
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.rational import decimal_text

FOLDER = Path(__file__).parent / "steps" / "verdicts"
LONGEST = 60


def shortened(text: str) -> str:
    """Return a text, or the beginning of a long one with a digest of the whole."""
    digest = hashlib.sha256(text.encode()).hexdigest()[:12]
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}... #{digest}"


def value_of(value: mpq | Real) -> str:
    """Return a value, a long or irrational one to 20 digits."""
    if not isinstance(value, mpq):
        return value.decimal(20)
    return str(value) if len(str(value)) <= LONGEST else decimal_text(value, 20)


def line_of(name: str, verdict: Verdict) -> str:
    """Return all that a verdict says, on one line."""
    value = "-" if verdict.worst is None else value_of(verdict.worst)
    said = "-"
    if verdict.witness is not None:
        place = ", ".join(f"{key}={shortened(str(found))}" for key, found in verdict.witness.place.items())
        said = f"{verdict.witness.clause} | {place}"
    return f"{name} | {verdict.holds} | {verdict.instances} | {value} | {said}"


@contextmanager
def recorded(checker: str, *modules: ModuleType) -> Iterator[list[tuple[str, Verdict]]]:
    """Compare the verdicts that are put on the list, each with a name, with those on record for a checker, and the
    bounds that tallies made meanwhile by its modules compare with."""
    found: list[tuple[str, Verdict]] = []
    bounds: set[str] = set()

    def tally(clause: str, relation: Relation, bound: mpq | Real) -> Tally:
        bounds.add(f"bound | {clause} | {relation} {value_of(bound)}")
        return Tally(clause, relation, bound)

    with pytest.MonkeyPatch.context() as patch:
        for module in modules:
            if hasattr(module, "Tally"):
                patch.setattr(module, "Tally", tally)
        yield found
    lines = [*sorted(bounds), *(line_of(name, verdict) for name, verdict in found)]
    path = FOLDER / f"{checker}.txt"
    if "RECORD" in os.environ:
        FOLDER.mkdir(exist_ok=True)
        path.write_text("".join(f"{line}\n" for line in lines), encoding="utf-8")
    assert lines == path.read_text(encoding="utf-8").splitlines()
