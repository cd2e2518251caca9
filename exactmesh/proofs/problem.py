"""A universally quantified inequality, written once: the source of its SMT-LIB file, its certificate, its guards."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from gmpy2 import mpq

from exactmesh.proofs.certificate import Constraint, Refused, constraint_from_text, refute, satisfy
from exactmesh.proofs.polynomial import Monomial, Polynomial

Point = Mapping[str, mpq]


@dataclass(frozen=True)
class Stronger:
    """A conclusion whose bound is `factor` times better than what is claimed, and a point `at` which it is false."""

    factor: str
    conclusion: Constraint
    at: Point


@dataclass(frozen=True)
class Problem:
    """For all reals that satisfy the hypotheses, the conclusion holds; no conclusion: the hypotheses contradict.

    `example` satisfies the hypotheses, so that the claim is not empty; `stronger` shows that it can fail.
    `certificate` refutes the hypotheses together with the negated conclusion, which is the last assumption; or it is a
    counterexample, a point that satisfies them all.
    """

    id: str
    says: str
    hypotheses: tuple[Constraint, ...]
    conclusion: Constraint | None
    example: Point | None = None
    stronger: Stronger | None = None
    certificate: Mapping[str, Any] | None = None

    def assumptions(self) -> tuple[Constraint, ...]:
        """Return what no real point satisfies if the claim is true."""
        return self.hypotheses if self.conclusion is None else (*self.hypotheses, self.conclusion.negated())

    def names(self) -> list[str]:
        """Return the variables, sorted."""
        return sorted(set().union(*(c.polynomial.names() for c in self.assumptions())))

    def smt_lib(self) -> str:
        """Return the SMT-LIB script whose answer is `unsat` when the claim is true, `sat` when it is false."""
        answer = "unsat: true for all reals" if self.expected == "proved" else "sat: false"
        lines = [f"; {self.id}: {self.says}", f"; {answer}", "(set-logic QF_NRA)"]
        lines += [f"(declare-const {name} Real)" for name in self.names()]
        lines += [f"(assert {_smt(c)})" for c in self.assumptions()]
        return "\n".join([*lines, "(check-sat)", ""])

    @property
    def expected(self) -> str:
        """What the certificate is meant to show: that the claim is "proved", or "refuted" by a point."""
        return "refuted" if self.certificate and self.certificate.get("kind") == "counterexample" else "proved"

    def check_certificate(self) -> None:
        """Return when the certificate proves the claim, or refutes it where that is expected; raises `Refused`."""
        if self.certificate is None:
            raise Refused("there is no certificate")
        if self.expected == "refuted":
            satisfy(self.assumptions(), self.certificate.get("at", {}))
        else:
            refute(self.assumptions(), self.certificate)

    def check_guards(self) -> None:
        """Return when the hypotheses are satisfiable and the stronger claim is false; raises `Refused`."""
        if self.example is not None and not all(c.holds(self.example) for c in self.hypotheses):
            raise Refused("the example does not satisfy the hypotheses")
        if self.conclusion is not None and self.example is None:
            raise Refused("there is no example of the hypotheses")
        if self.stronger is not None:
            if not all(c.holds(self.stronger.at) for c in self.hypotheses):
                raise Refused("the point against the stronger claim does not satisfy the hypotheses")
            if self.stronger.conclusion.holds(self.stronger.at):
                raise Refused("the stronger claim is not refuted")


@dataclass(frozen=True)
class Theorem:
    """What a set of problems shows of a claim of the ledger.

    `shows` is "claim" for the sentence as the ledger has it, "corrected" for its corrected form, "refuted" for its
    negation, "repaired" for the sentence in runs of the repaired construction, "part" when more is needed. `by_hand`
    is the argument from the sentence to the problems, which no program checks, `tight` what is known of the sharpness
    of the bound, with its exact instance. `claims` are those that have to be proved as well.
    """

    claim: str
    shows: str
    says: str
    problems: tuple[str, ...]
    by_hand: str
    tight: str = ""
    claims: tuple[str, ...] = ()


@dataclass(frozen=True)
class Group:
    """The theorems and problems of one script."""

    name: str
    theorems: tuple[Theorem, ...] = ()
    problems: tuple[Problem, ...] = field(default=())


def json_from_group(group: Group) -> dict[str, Any]:
    """Return the group as it is written to a file."""
    return {
        "format": "exactmesh-proofs/1", "name": group.name,
        "theorems": [{"claim": t.claim, "shows": t.shows, "says": t.says, "problems": list(t.problems),
                      "by_hand": t.by_hand, "tight": t.tight, **({"claims": list(t.claims)} if t.claims else {})}
                     for t in group.theorems],
        "problems": [{
            "id": p.id, "says": p.says, "hypotheses": [str(c) for c in p.hypotheses],
            "conclusion": None if p.conclusion is None else str(p.conclusion),
            "example": None if p.example is None else _texts(p.example),
            "stronger": None if p.stronger is None else {
                "factor": p.stronger.factor, "conclusion": str(p.stronger.conclusion), "at": _texts(p.stronger.at)},
            "certificate": p.certificate} for p in group.problems]}


def group_from_json(data: Mapping[str, Any]) -> Group:
    """Return the group in a file; raises `Refused` when it is malformed."""
    try:
        if data["format"] != "exactmesh-proofs/1":
            raise Refused("the format is not exactmesh-proofs/1")
        theorems = tuple(Theorem(t["claim"], t["shows"], t["says"], tuple(t["problems"]), t["by_hand"], t["tight"],
                                 tuple(t.get("claims", ())))
                         for t in data["theorems"])
        if twice := [t.claim for t in theorems if len(set(t.problems)) < len(t.problems)]:
            raise Refused(f"a problem is named twice for {twice[0]}")
        return Group(data["name"], theorems, tuple(_problem(p) for p in data["problems"]))
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise Refused(f"malformed file of proofs: {error}") from error


def _problem(data: Mapping[str, Any]) -> Problem:
    conclusion, example, stronger = data["conclusion"], data["example"], data["stronger"]
    return Problem(
        data["id"], data["says"], tuple(constraint_from_text(text) for text in data["hypotheses"]),
        None if conclusion is None else constraint_from_text(conclusion), None if example is None else _point(example),
        None if stronger is None else Stronger(stronger["factor"], constraint_from_text(stronger["conclusion"]),
                                               _point(stronger["at"])), data["certificate"])


def _texts(point: Point) -> dict[str, str]:
    return {name: str(value) for name, value in point.items()}


def _point(texts: Mapping[str, str]) -> dict[str, mpq]:
    return {name: mpq(text) for name, text in texts.items()}


def _smt(constraint: Constraint) -> str:
    relation = "=" if constraint.relation == "==" else constraint.relation
    return f"({relation} {_smt_polynomial(constraint.polynomial)} 0.0)"


def _smt_polynomial(p: Polynomial) -> str:
    terms = [_smt_term(monomial, c) for monomial, c in p.in_order()]
    return f"(+ {' '.join(terms)})" if len(terms) > 1 else (terms or ["0.0"])[0]


def _smt_term(monomial: Monomial, c: mpq) -> str:
    number = f"{abs(c.numerator)}.0" if c.denominator == 1 else f"(/ {abs(c.numerator)}.0 {c.denominator}.0)"
    factors = [number if c > 0 else f"(- {number})"]
    factors += [name for name, exponent in monomial for _ in range(exponent)]
    return f"(* {' '.join(factors)})" if len(factors) > 1 else factors[0]
