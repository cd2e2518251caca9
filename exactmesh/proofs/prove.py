"""Run the proofs that come along: certificates and guards by rational arithmetic, engines on the SMT-LIB scripts."""

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass

from exactmesh.errors import InputError
from exactmesh.proofs.certificate import Refused
from exactmesh.proofs.engines import ENGINES, Engine, installed
from exactmesh.proofs.problem import Group, Problem, Theorem
from exactmesh.proofs.registry import groups, is_proved, theorems

# What an engine says of the negated claim, as a result.
_RESULTS = {"unsat": "proved", "sat": "refuted", "timeout": "timeout", "unknown": "unknown"}


@dataclass(frozen=True, slots=True)
class Result:
    """What one method says of one problem.

    `result` is proved, refuted, timeout, unknown (the engine gave up), open (there is no certificate), failed (a
    certificate or guard is refused) or error (the engine did not take the script).
    """

    group: str
    problem: str
    claims: tuple[str, ...]
    method: str
    result: str
    seconds: float
    certificate: str | None
    detail: str = ""
    expected: str = "proved"

    @property
    def contradicts(self) -> bool:
        """Whether a method says the opposite of what the tree says, or a certificate or guard is refused."""
        return self.result == "failed" or (self.result in ("proved", "refuted") and self.result != self.expected)


@dataclass(frozen=True, slots=True)
class Summary:
    """A theorem: how many of its problems each method settles as expected, and whether it stands."""

    theorem: Theorem
    proved: dict[str, int]
    seconds: float
    stands: bool


def chosen(ids: Sequence[str]) -> list[tuple[Group, Problem, tuple[str, ...]]]:
    """Return the problems of the claims, groups or problems named, all without names, with the claims they serve.

    Raises `InputError` for a name that is none of these.
    """
    found: list[tuple[Group, Problem, tuple[str, ...]]] = []
    known: set[str] = set()
    for group in groups():
        for problem in group.problems:
            claims = tuple(dict.fromkeys(t.claim for t in theorems() if problem.id in t.problems))
            names = {group.name, problem.id, *claims}
            known |= names
            if not ids or names.intersection(ids):
                found.append((group, problem, claims))
    for wanted in ids:
        if wanted not in known:
            raise InputError(f"there is no proof of {wanted!r}; `exactmesh prove --fast` lists those there are")
    return found


def prove(ids: Sequence[str] = (), fast: bool = False, seconds: float = 30,
          progress: Callable[[str], None] = lambda step: None) -> Iterator[Result]:
    """Yield what each method says of each problem; with `fast`, certificates and guards only.

    Engines that are not installed are left out; each has at most `seconds` for a problem. Raises `InputError` for
    unknown ids and for seconds that are not between 0 and a day.
    """
    if not 0 < seconds <= 86400:
        raise InputError(f"an engine needs some seconds, at most a day of them, not {seconds}")
    with ExitStack() as stack:
        engines = [] if fast else [stack.enter_context(Engine(name, seconds)) for name in ENGINES if installed(name)]
        for group, problem, claims in chosen(ids):
            progress(problem.id)
            yield _certificate(group, problem, claims)
            for engine in engines:
                start = time.monotonic()
                answer = engine.answer(problem.smt_lib())
                yield Result(group.name, problem.id, claims, engine.name, _RESULTS.get(answer, "error"),
                             time.monotonic() - start, None, "" if answer in _RESULTS else answer, problem.expected)


def _certificate(group: Group, problem: Problem, claims: tuple[str, ...]) -> Result:
    start = time.monotonic()
    result, detail = "open" if problem.certificate is None else problem.expected, ""
    try:
        if problem.certificate is not None:
            problem.check_certificate()
        problem.check_guards()
    except Refused as error:
        result, detail = "failed", str(error)
    path = None if problem.certificate is None else f"proofs_checks/certificates/{group.name}.json"
    return Result(group.name, problem.id, claims, "certificate", result, time.monotonic() - start, path, detail,
                  problem.expected)


def summaries(results: Sequence[Result]) -> list[Summary]:
    """Return what the results show of each theorem all of whose problems are among them."""
    found = []
    for theorem in theorems():
        own = [r for r in results if r.problem in theorem.problems]
        if {r.problem for r in own} == set(theorem.problems):
            methods = sorted({r.method for r in own}, key=("certificate", *ENGINES).index)
            proved = {m: sum(r.method == m and r.result == r.expected for r in own) for m in methods}
            stands = (proved["certificate"] == len(theorem.problems)
                      and not any(r.contradicts for r in own) and all(is_proved(claim) for claim in theorem.claims))
            found.append(Summary(theorem, proved, sum(r.seconds for r in own), stands))
    return found
