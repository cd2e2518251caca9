"""Every certificate in the tree re-checks, every guard fires, every harmed certificate is refused."""

import ast
import copy
import hashlib
import importlib
import json
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.claims.ledger import CLAIMS
from exactmesh.proofs import certificate, polynomial
from exactmesh.proofs.certificate import Refused, constraint_from_text, refute, satisfy
from exactmesh.proofs.engines import ENGINES
from exactmesh.proofs.problem import Group, Problem, Theorem, group_from_json, json_from_group
from exactmesh.proofs.registry import files, groups, problems, stands, theorems

ROOT = Path(exactmesh.__file__).parents[1]
PROBLEMS = [(group, problem) for group in groups() for problem in group.problems]
FILES = files()
IDS = {claim.id for claim in CLAIMS}


def constraints(*texts: str) -> list[certificate.Constraint]:
    return [constraint_from_text(text) for text in texts]


@pytest.mark.parametrize("group", groups(), ids=lambda group: group.name)
def test_every_certificate_and_guard_of_the_tree_passes(group: Group) -> None:
    for problem in group.problems:
        if problem.certificate is not None:
            problem.check_certificate()
        problem.check_guards()


@pytest.mark.parametrize("group", groups(), ids=lambda group: group.name)
def test_the_smt_lib_files_are_those_of_the_problems(group: Group) -> None:
    for problem in group.problems:
        path = ROOT / "proofs_checks" / "smt" / f"{problem.id}.smt2"
        assert path.read_text(encoding="utf-8") == problem.smt_lib()


def test_there_are_no_other_smt_lib_files_and_no_two_problems_of_one_name() -> None:
    names = [problem.id for _, problem in PROBLEMS]
    assert len(names) == len(set(names))
    assert {path.stem for path in (ROOT / "proofs_checks" / "smt").iterdir()} == set(names)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_files_survive_reading_and_writing(path: Path) -> None:
    data = json.loads(path.read_text(encoding="utf-8"))
    assert json_from_group(group_from_json(data)) == data and data["name"] == path.stem


def test_theorems_are_about_claims_of_the_ledger_and_problems_of_their_files() -> None:
    for theorem in theorems():
        assert theorem.claim in IDS, theorem.claim
        assert theorem.shows in ("claim", "corrected", "repaired", "refuted", "part") and theorem.by_hand
        assert set(problems()) >= set(theorem.problems)


def test_every_problem_serves_a_theorem() -> None:
    used = {problem for theorem in theorems() for problem in theorem.problems}
    assert {problem.id for _, problem in PROBLEMS} == used


def test_a_counterexample_is_a_point_that_satisfies_everything_and_proves_nothing() -> None:
    given = constraints("x > 0", "1 - x >= 0")
    satisfy(given, {"x": "1"})
    for bad in ({"x": "0"}, {"x": "2"}, {}, {"x": "a"}, {"y": "1"}, {"x": None}, ["x"]):
        with pytest.raises(Refused):
            satisfy(given, bad)  # type: ignore[arg-type]
    with pytest.raises(Refused):
        refute(given, {"kind": "counterexample", "at": {"x": "1"}})
    false = next(p for _, p in PROBLEMS if p.expected == "refuted")
    assert stands(Theorem("c", "refuted", "", (false.id,), "-"))
    assert not stands(Theorem("c", "claim", "", (false.id,), "-"))


def answers() -> dict[str, dict[str, str]]:
    data: dict[str, dict[str, str]] = json.loads((ROOT / "proofs_checks" / "answers.json").read_text(encoding="utf-8"))
    return data


def test_the_recorded_answers_are_to_the_problems_as_they_are() -> None:
    assert set(answers()) == {problem.id for _, problem in PROBLEMS}
    for _, problem in PROBLEMS:
        record = answers()[problem.id]
        assert record["sha256"] == hashlib.sha256(problem.smt_lib().encode()).hexdigest()[:16], problem.id
        expected = "unsat" if problem.expected == "proved" else "sat"
        said = {record[engine] for engine in ENGINES}
        # Two roads: the certificate, and at least one engine; none says the opposite.
        assert expected in said and said <= {expected, "timeout"}, problem.id


@pytest.mark.parametrize("script", sorted(p.stem for p in (ROOT / "proofs_checks").glob("*.py")
                                          if p.stem not in ("answers", "kit", "search")))
def test_the_statements_of_the_scripts_are_those_of_the_files(script: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "proofs_checks"))
    module = importlib.import_module(script)
    group = next(group for group in groups() if group.name == module.GROUP)
    # Scripts may name a lemma for several cases; files name it once.
    assert list(group.theorems) == [replace(theorem, problems=tuple(dict.fromkeys(theorem.problems)))
                                    for theorem in module.THEOREMS]
    for problem, statement in zip(group.problems, module.STATEMENTS, strict=True):
        assert (problem.id, problem.says, problem.hypotheses) == (statement.id, statement.says, statement.hypotheses)
        conclusion = statement.conclude and statement.conclude(Fraction(1))
        # Where the hypotheses contradict each other there is no conclusion, which is more.
        assert problem.conclusion in (conclusion, None)


def test_every_whole_theorem_of_the_tree_stands() -> None:
    for theorem in theorems():
        assert theorem.shows == "part" or stands(theorem), theorem.claim


def harmed(node: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield copies of a certificate with one thing wrong each."""
    def copied() -> dict[str, Any]:
        return copy.deepcopy(node)
    if node.get("kind") == "combination":
        for k, (c, _, _) in enumerate(node["terms"]):
            bad = copied()
            bad["terms"][k][0] = str(-mpq(c))
            yield "sign", bad
            bad = copied()
            del bad["terms"][k]
            yield "term left out", bad
            bad = copied()
            bad["terms"][k][1] = [*bad["terms"][k][1], 99]
            yield "assumption from nowhere", bad
        bad = copied()
        bad["terms"][0][0] = str(mpq(bad["terms"][0][0]) * 2)
        if len(node["terms"]) > 1:
            yield "coefficient", bad
    elif node.get("kind") == "cases":
        for side in ("holds", "fails"):
            bad = copied()
            del bad[side]
            yield "case left out", bad
            for name, worse in harmed(node[side]):
                yield f"{side}: {name}", {**node, side: worse}
    elif node.get("kind") == "boxes":
        yield "box left out", {**node, "tree": node["tree"][:-1]}
        yield "box too many", {**node, "tree": [*node["tree"], 0]}
        yield "variable left out", {**node, "variables": node["variables"][1:]}


@pytest.mark.parametrize("group", groups(), ids=lambda group: group.name)
def test_the_checker_refuses_harmed_certificates(group: Group) -> None:
    count = 0
    for problem in group.problems[:: max(1, len(group.problems) // 20)]:
        for name, bad in list(harmed(dict(problem.certificate or {})))[:12]:
            with pytest.raises(Refused):
                refute(problem.assumptions(), bad)
                pytest.fail(f"{problem.id}: {name}")
            count += 1
    assert count


@pytest.mark.parametrize("group", groups(), ids=lambda group: group.name)
def test_no_certificate_proves_the_stronger_claim(group: Group) -> None:
    for problem in group.problems:
        if problem.stronger is not None and problem.certificate is not None:
            stronger = (*problem.hypotheses, problem.stronger.conclusion.negated())
            with pytest.raises(Refused):
                refute(stronger, problem.certificate)


SQUARE = constraints("x >= 0", "1 - x >= 0", "y >= 0", "1 - y >= 0")


def test_boxes_prove_and_leave_no_gap() -> None:
    given = [*SQUARE, *constraints("x*y - x - y - 1/100 >= 0")]
    refute(given, {"kind": "boxes", "variables": ["x", "y"], "tree": [4]})
    for tree in ([], [-1, 4], [-1, 4, 4, 4], [4, 4], [0], [-3, 4, 4], [5]):
        with pytest.raises(Refused):
            refute(given, {"kind": "boxes", "variables": ["x", "y"], "tree": tree})


@pytest.mark.parametrize("texts", [("x >= 0", "-x >= 0"), ("x >= 0", "1 - x > 0", "x**2 - x >= 0")])
def test_boxes_do_not_refute_what_is_satisfiable(texts: tuple[str, ...]) -> None:
    given = constraints(*texts)
    for leaf in range(len(given)):
        for tree in ([leaf], [-1, leaf, leaf]):
            with pytest.raises(Refused):
                refute(given, {"kind": "boxes", "variables": ["x"], "tree": tree})


def test_boxes_without_an_upper_bound() -> None:
    given = constraints("x - 2 >= 0", "3 - x**2 > 0")
    refute(given, {"kind": "boxes", "variables": ["x"], "tree": [1]})
    with pytest.raises(Refused):
        refute(constraints("x - 1 >= 0", "3 - x**2 > 0"), {"kind": "boxes", "variables": ["x"], "tree": [1]})
    with pytest.raises(Refused):
        refute(constraints("2 - x >= 0", "x**2 - 5 > 0"), {"kind": "boxes", "variables": ["x"], "tree": [1]})


def test_a_combination_needs_a_positive_term_and_the_right_relations() -> None:
    both = constraints("x > 0", "-x > 0")
    terms = [["1", [0], None], ["1", [1], None]]
    refute(both, {"kind": "combination", "terms": terms, "equalities": []})
    for given in (constraints("x >= 0", "-x >= 0"), constraints("x > 0", "-x - 1 > 0"), both[:1]):
        with pytest.raises(Refused):
            refute(given, {"kind": "combination", "terms": terms, "equalities": []})
    with pytest.raises(Refused):
        refute(both, {"kind": "combination", "terms": [["1", [0], "0"]], "equalities": []})
    refute(constraints("x - 1 >= 0", "x == 0"),
           {"kind": "combination", "terms": [["1", [0], None], ["1", [], None]], "equalities": [[1, "-1"]]})
    with pytest.raises(Refused):
        refute(constraints("x - 1 >= 0", "x >= 0"),
               {"kind": "combination", "terms": [["1", [0], None], ["1", [], None]], "equalities": [[1, "-1"]]})


def test_a_case_has_both_sides() -> None:
    given = constraints("x**2 - 1 > 0", "x + 1/2 > 0", "1/2 - x > 0")
    node = {"kind": "boxes", "variables": ["x"], "tree": [0]}
    refute(given, node)
    refute(given, {"kind": "cases", "on": "x >= 0", "holds": node, "fails": node})
    for bad in ({"on": "x >= 0", "holds": node}, {"on": "x == 0", "holds": node, "fails": node},
                {"on": "x", "holds": node, "fails": node}, {"on": "y >= 0", "holds": node, "fails": None}):
        with pytest.raises(Refused):
            refute(given, {"kind": "cases", **bad})


def test_malformed_certificates_are_refused() -> None:
    given = constraints("x > 0", "-x > 0")
    for bad in ({}, {"kind": "combination"}, {"kind": "combination", "terms": [[1]], "equalities": []},
                {"kind": "combination", "terms": [["1", [True], None]], "equalities": []},
                {"kind": "combination", "terms": [["1/0", [0], None]], "equalities": []},
                {"kind": "combination", "terms": [["1", [0], "x/y"]], "equalities": []},
                {"kind": "boxes", "variables": ["x"], "tree": "00"}):
        with pytest.raises(Refused):
            refute(given, bad)
    for text in ("x", "x >= 1", "x/y >= 0", "f(x) > 0", "x**y >= 0", "x**-1 >= 0", "1.5*x >= 0", "(" * 99 + " >= 0"):
        with pytest.raises(Refused):
            constraint_from_text(text)


def test_guards_refuse_an_empty_claim_and_a_stronger_one_that_is_true() -> None:
    data = {"id": "p", "says": "", "hypotheses": ["x >= 0"], "conclusion": "x + 1 > 0", "example": {"x": "1"},
            "stronger": None, "certificate": None}
    def problem(**changes: Any) -> Problem:
        return group_from_json({"format": "exactmesh-proofs/1", "name": "g", "theorems": [],
                                "problems": [{**data, **changes}]}).problems[0]
    problem().check_guards()
    problem(stronger={"factor": "2", "conclusion": "x - 1 > 0", "at": {"x": "0"}}).check_guards()
    for changes in ({"example": {"x": "-1"}}, {"example": None},
                    {"stronger": {"factor": "2", "conclusion": "x - 1 > 0", "at": {"x": "2"}}},
                    {"stronger": {"factor": "2", "conclusion": "x - 1 > 0", "at": {"x": "-1"}}}):
        with pytest.raises(Refused):
            problem(**changes).check_guards()


def test_the_checker_is_small_and_needs_no_solver() -> None:
    count = 0
    for module in (certificate, polynomial):
        text = Path(str(module.__file__)).read_text(encoding="utf-8")
        tree = ast.parse(text)
        documented = {line for node in ast.walk(tree) if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef))
                      if ast.get_docstring(node) for line in range(node.body[0].lineno, node.body[0].end_lineno + 1)}
        count += sum(bool(line.strip()) and k not in documented for k, line in enumerate(text.splitlines(), 1))
        names = {alias.name.split(".")[0] for node in ast.walk(tree) if isinstance(node, ast.Import)
                 for alias in node.names}
        names |= {str(node.module).split(".")[0] for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
        assert names <= {"ast", "collections", "dataclasses", "exactmesh", "gmpy2", "itertools", "math", "typing"}
    assert count <= 300
