"""What the scripts share: points with polynomial coordinates, statements about distances, one way to run.

    python proofs_checks/lemma_1.py           re-check the certificates of one script, search those that are missing
    python proofs_checks/lemma_1.py --write   and write certificates/*.json and smt/*.smt2 anew
"""

import json
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from gmpy2 import mpq
from search import PLAIN, Hint, example_of, find

from exactmesh.proofs.certificate import Constraint, Refused
from exactmesh.proofs.polynomial import Polynomial, Scalar, polynomial
from exactmesh.proofs.problem import Group, Problem, Stronger, Theorem, group_from_json, json_from_group

HERE = Path(__file__).parent
FACTORS = tuple(Fraction(text) for text in ("101/100", "11/10", "5/4", "3/2", "2", "3", "5", "10", "100"))


class Spot(NamedTuple):
    """A point, or a vector, with polynomial coordinates."""

    x: Polynomial
    y: Polynomial

    def minus(self, other: "Spot") -> "Spot":
        return Spot(self.x - other.x, self.y - other.y)


def spot(x: Scalar, y: Scalar) -> Spot:
    """Return a point."""
    return Spot(polynomial(x), polynomial(y))


def cross(u: Spot, v: Spot) -> Polynomial:
    """Return the determinant of two vectors."""
    return u.x * v.y - u.y * v.x


def dot(u: Spot, v: Spot) -> Polynomial:
    """Return the scalar product of two vectors."""
    return u.x * v.x + u.y * v.y


def at_least(p: Scalar, q: Scalar = 0) -> Constraint:
    """Return p >= q."""
    return Constraint(polynomial(p) - q, ">=")


def more(p: Scalar, q: Scalar = 0) -> Constraint:
    """Return p > q."""
    return Constraint(polynomial(p) - q, ">")


def equal(p: Scalar, q: Scalar = 0) -> Constraint:
    """Return p == q."""
    return Constraint(polynomial(p) - q, "==")


@dataclass(frozen=True)
class Statement:
    """A problem to be: `conclude` gives the conclusion when the bound is multiplied by a factor, None where there is
    no bound to sharpen. `sharp` is a point to try against it first."""

    id: str
    says: str
    hypotheses: tuple[Constraint, ...]
    conclude: Callable[[Fraction], Constraint] | None
    hint: Hint = PLAIN
    sharpen: bool = True
    sharp: Mapping[str, str] | None = None
    true: bool = True


def states(id_: str, says: str, hypotheses: Iterable[Constraint], conclusion: Constraint | None,
           hint: Hint = PLAIN) -> Statement:
    """Return a statement without a bound that could be sharpened."""
    return Statement(id_, says, tuple(hypotheses), None if conclusion is None else lambda factor: conclusion, hint,
                     sharpen=False)


def bounded(id_: str, says: str, hypotheses: Iterable[Constraint], conclude: Callable[[Fraction], Constraint],
            hint: Hint = PLAIN, sharp: Mapping[str, str] | None = None) -> Statement:
    """Return a statement whose bound can be sharpened by a factor."""
    return Statement(id_, says, tuple(hypotheses), conclude, hint, sharp=sharp)


def refuted(id_: str, says: str, hypotheses: Iterable[Constraint], conclusion: Constraint,
            at: Mapping[str, str] | None = None) -> Statement:
    """Return a statement that is false, at the given point or at one to be found."""
    return Statement(id_, says, tuple(hypotheses), lambda factor: conclusion, sharpen=False, sharp=at, true=False)


def keeps_distance(id_: str, says: str, hypotheses: Sequence[Constraint], p: Spot, a: Spot, b: Spot,
                   bound_squared: Scalar, hint: Hint = PLAIN) -> list[Statement]:
    """Return that p keeps a distance from the segment a b, in three parts by where the foot of p is.

    `bound_squared` is the square of the distance. Where the foot cannot be, the statement becomes that it cannot.
    """
    along, to = b.minus(a), p.minus(a)
    foot, length = dot(to, along), dot(along, along)
    parts = (
        ("before", "the foot lies before the segment", (more(-foot),), dot(to, to), polynomial(1)),
        ("beyond", "the foot lies beyond the segment", (more(foot, length),), dot(p.minus(b), p.minus(b)),
         polynomial(1)),
        ("between", "the foot lies on the segment", (at_least(foot), at_least(length, foot)), cross(along, to)**2,
         length))
    return [Statement(f"{id_}.{name}", f"{says}; {where}", (*hypotheses, *extra),
                      lambda factor, d=d, unit=unit: at_least(d, square(factor) * bound_squared * unit), hint)
            for name, where, extra, d, unit in parts]


def square(factor: Fraction) -> mpq:
    """Return the square of a factor."""
    return mpq(factor) ** 2


def settle(statement: Statement, old: Problem | None) -> Problem:
    """Return the problem of a statement with what is found for it: a certificate, an example, how sharp it is."""
    hypotheses = statement.hypotheses
    conclusion = statement.conclude(Fraction(1)) if statement.conclude else None
    if old is not None and old.hypotheses == hypotheses and old.says == statement.says:
        same = old.conclusion == conclusion
        if same or (old.conclusion is None and old.certificate is not None):
            try:
                old.check_certificate()
                old.check_guards()
                if not statement.true or statement.sharp is None or (old.stronger and old.stronger.factor == "101/100"):
                    return old
            except Refused:
                pass
    problem = Problem(statement.id, statement.says, hypotheses, conclusion)
    if not statement.true:
        at = ({name: mpq(text) for name, text in statement.sharp.items()} if statement.sharp
              else example_of(problem.assumptions()))
        return problem if at is None else replace(problem, example=at, certificate={
            "kind": "counterexample", "at": {name: str(value) for name, value in at.items()}})
    if conclusion is not None:
        example = example_of(hypotheses)
        if example is None:
            bare = replace(problem, conclusion=None)
            certificate = find(bare.assumptions(), statement.hint)
            if certificate is not None:
                return replace(bare, certificate=certificate)
        problem = replace(problem, example=example)
        if statement.sharpen and example is not None and statement.conclude:
            problem = replace(problem, stronger=_sharpest(statement, hypotheses))
    return replace(problem, certificate=find(problem.assumptions(), statement.hint))


def _sharpest(statement: Statement, hypotheses: Sequence[Constraint]) -> Stronger | None:
    assert statement.conclude is not None
    for factor in FACTORS:
        stronger = statement.conclude(factor)
        if statement.sharp is not None:
            at = {name: mpq(text) for name, text in statement.sharp.items()}
            if all(c.holds(at) for c in hypotheses) and not stronger.holds(at):
                return Stronger(str(factor), stronger, at)
        found = example_of((*hypotheses, stronger.negated()), 5)
        if found is not None:
            return Stronger(str(factor), stronger, found)
    return None


def main(name: str, theorems: Iterable[Theorem], statements: Iterable[Statement]) -> None:
    """Settle all statements of a script, print how it went, and write the files when asked to."""
    path = HERE / "certificates" / f"{name}.json"
    old = {}
    if path.exists() and "--anew" not in sys.argv:
        old = {problem.id: problem for problem in group_from_json(json.loads(path.read_text())).problems}
    problems = []
    for statement in statements:
        problems.append(settle(statement, old.get(statement.id)))
        print(_line(problems[-1]), flush=True)
    # A script may name a lemma for several of its cases.
    once = tuple(replace(theorem, problems=tuple(dict.fromkeys(theorem.problems))) for theorem in theorems)
    group = Group(name, once, tuple(problems))
    missing = [problem.id for problem in problems if problem.certificate is None]
    print(f"{name}: {len(problems) - len(missing)} of {len(problems)} have certificates")
    if "--write" in sys.argv:
        path.parent.mkdir(exist_ok=True)
        path.write_text(json.dumps(json_from_group(group), indent=1) + "\n", encoding="utf-8")
        folder = HERE / "smt"
        folder.mkdir(exist_ok=True)
        for stale in {path.stem for path in folder.glob(f"{name}.*.smt2")} - {problem.id for problem in problems}:
            (folder / f"{stale}.smt2").unlink()
        for problem in problems:
            (folder / f"{problem.id}.smt2").write_text(problem.smt_lib(), encoding="utf-8")


def _line(problem: Problem) -> str:
    kind = problem.certificate["kind"] if problem.certificate else "NO CERTIFICATE"
    sharp = f"x {problem.stronger.factor} is false" if problem.stronger else ""
    empty = "" if problem.conclusion is not None else "cannot be"
    return f"{problem.id:60} {kind:14} {sharp}{empty}"
