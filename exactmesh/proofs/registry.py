"""The proofs that come along: files of certificates, and what re-checking them shows of each claim.

The files are in `certificates/` beside this module in an installed package, in `proofs_checks/certificates/` in a
source tree. A claim counts as proved when, in some theorem about the sentence itself, every problem has a certificate
and guards that pass now, and so have the claims that it rests on.
"""

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from exactmesh.proofs.certificate import Refused
from exactmesh.proofs.problem import Group, Problem, Theorem, group_from_json

_HERE = Path(__file__).parent
_PLACES = (_HERE / "certificates", _HERE.parents[1] / "proofs_checks" / "certificates")


def files() -> list[Path]:
    """Return the files of certificates, sorted."""
    return next((found for place in _PLACES if (found := sorted(place.glob("*.json")))), [])


@cache
def groups() -> tuple[Group, ...]:
    """Return all groups; raises `Refused` when a file is malformed."""
    loaded = []
    for path in files():
        try:
            loaded.append(group_from_json(json.loads(path.read_text(encoding="utf-8"))))
        except (OSError, ValueError) as error:
            raise Refused(f"{path.name}: {error}") from error
    return tuple(loaded)


def theorems() -> Iterator[Theorem]:
    """Yield all theorems; their problems may be of several groups."""
    for group in groups():
        yield from group.theorems


@cache
def problems() -> dict[str, Problem]:
    """Return all problems by id; raises `Refused` when two have the same."""
    found: dict[str, Problem] = {}
    for group in groups():
        for problem in group.problems:
            if problem.id in found:
                raise Refused(f"two problems are called {problem.id}")
            found[problem.id] = problem
    return found


@cache
def trouble(problem: str) -> str:
    """Return why a problem is not proved, nothing when its certificate and guards pass."""
    if problem not in problems():
        return "there is no such problem"
    try:
        problems()[problem].check_certificate()
        problems()[problem].check_guards()
    except Refused as error:
        return str(error)
    return ""


def stands(theorem: Theorem) -> bool:
    """Return whether every problem of the theorem passes, and is not a refutation where the theorem is a proof, and the
    claims that it rests on are proved."""
    if not theorem.problems or any(trouble(problem) for problem in theorem.problems):
        return False
    if not all(is_proved(claim) for claim in theorem.claims):
        return False
    return theorem.shows in ("refuted", "part") or all(problems()[p].expected == "proved" for p in theorem.problems)


def is_proved(claim: str) -> bool:
    """Return whether certificates prove the claim as the ledger has it."""
    return _shown(claim, "claim")


def is_proved_of_repaired(claim: str) -> bool:
    """Return whether certificates prove the claim of runs of the repaired construction."""
    return _shown(claim, "repaired")


def is_refuted(claim: str) -> bool:
    """Return whether certificates refute the claim as the ledger has it."""
    return _shown(claim, "refuted")


def _shown(claim: str, shows: str) -> bool:
    return any(theorem.shows == shows and theorem.claim == claim and stands(theorem) for theorem in theorems())
