"""Mutation testing with mutmut: python tests/mutation/run.py [MODULE ...].

Each MODULE (all of `TARGETS` by default) is mutated in a copy of the tree, in a folder of its own, and the tests that
`TARGETS` names are run against each mutant. Prints the score of each module and the survivors with their changes.
The score is killed / all; a time-out counts as killed, a mutant that no test reaches as survived. Exit status 0 when
each module reaches `LEAST` percent.

--again goes on with a run that was interrupted, and retests its survivors: after tests were added and the module left
alone.
Needs the extra `mutation`.
"""

import argparse
import ast
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LEAST = 95
COPIED = ("exactmesh", "tests", "proofs_checks", "docs")

ALGEBRAIC = ("tests/numbers/test_algebraic.py", "tests/numbers/test_root.py", "tests/numbers/test_number_details.py")
COLUMNS = ("tests/geometry/test_balls.py", "tests/geometry/test_point_columns.py")
VALIDITY = ("tests/measure/test_validity.py", "tests/measure/test_verdict.py")
PROOFS = ("tests/proofs/test_certificates.py", "tests/proofs/test_proof_details.py")
STEPS = ("appendix_a", "lemma_1", "lemma_3", "mesh", "offset", "offset_curve", "p5", "paper_interior", "paper_tube",
         "patch", "shape", "size", "snap", "trapezoidation")
# The modules that verdicts rest on, each with the tests that are run against its mutants.
TARGETS: Mapping[str, Sequence[str]] = {
    "exactmesh/check.py": ("tests/certificate/test_check.py", "tests/certificate/test_check_details.py"),
    "exactmesh/numbers/rational.py": ("tests/numbers/test_rational.py", "tests/numbers/test_number_details.py"),
    **{f"exactmesh/numbers/{name}.py": ALGEBRAIC for name in (
        "algebraic", "interval", "nested", "radicals", "root", "surd_sum")},
    "exactmesh/numbers/separation.py": ("tests/numbers/test_separation.py", "tests/numbers/test_number_details.py"),
    "exactmesh/geometry/point.py": ("tests/geometry/test_distance.py", "tests/geometry/test_predicates.py"),
    "exactmesh/geometry/predicates.py": ("tests/geometry/test_predicates.py",),
    "exactmesh/geometry/distance.py": ("tests/geometry/test_distance.py",),
    "exactmesh/geometry/filtered.py": ("tests/geometry/test_filtered.py",),
    "exactmesh/geometry/incircle.py": ("tests/geometry/test_incircle.py",),
    **{f"exactmesh/geometry/{name}.py": COLUMNS for name in ("balls", "columns", "face_columns", "decisions")},
    "exactmesh/geometry/fixed_point.py": ("tests/geometry/test_fixed_point.py", "tests/measure/test_mesh_faces.py"),
    "exactmesh/planar/half_edges.py": ("tests/planar/test_half_edges.py",),
    "exactmesh/planar/faces.py": ("tests/planar/test_faces.py", "tests/planar/test_half_edges.py"),
    "exactmesh/planar/validate.py": ("tests/planar/test_validate.py",),
    "exactmesh/measure/verdict.py": ("tests/measure/test_verdict.py",),
    "exactmesh/measure/face_feature.py": ("tests/measure/test_face_feature.py",),
    "exactmesh/measure/validity.py": VALIDITY,
    "exactmesh/measure/mesh_faces.py": ("tests/measure/test_mesh_faces.py",),
    "exactmesh/proofs/certificate.py": PROOFS,
    "exactmesh/proofs/polynomial.py": PROOFS,
    "exactmesh/dissection/verify.py": ("tests/dissection/test_verify_dissection.py",),
    "exactmesh/certificate/record.py": ("tests/certificate/test_record.py",),
    **{f"exactmesh/steps/{name}_check.py": (f"tests/steps/test_{name}_check.py",) for name in STEPS},
    "exactmesh/steps/paper_tube_unsnapped_check.py": ("tests/steps/test_paper_tube_check.py",),
}
# Tests that are slow, read the source, or run it where mutmut is not installed.
LEFT_OUT = (
    *(f"tests/certificate/test_check.py::{name}" for name in (
        "test_it_is_short_and_imports_the_standard_library_only", "test_no_float_and_no_division_that_rounds_is_in_it",
        "test_no_function_reaches_itself", "test_it_runs_as_a_file_in_an_empty_folder",
        "test_a_standard_output_that_is_full_is_no_verdict", "test_no_clause_is_without_a_case",
        "test_it_is_checked_strictly_and_linted_like_the_rest")),
    *(f"tests/numbers/test_algebraic.py::TestLength::{name}" for name in (
        "test_thirty_thousand_additions_of_different_roots",
        "test_mixing_too_many_roots_is_refused_and_less_is_not")),
    "tests/numbers/test_separation.py::test_a_chain_of_thirty_thousand_additions",
    "tests/numbers/test_separation.py::test_the_bound_does_not_use_the_exact_types",
    *(f"tests/proofs/test_certificates.py::{name}" for name in (
        "test_the_checker_is_small_and_needs_no_solver", "test_the_recorded_answers_are_to_the_problems_as_they_are",
        "test_the_statements_of_the_scripts_are_those_of_the_files",
        "test_the_smt_lib_files_are_those_of_the_problems")),
    *(f"tests/steps/test_{name}_check.py::test_every_clause_fires" for name in (
        "offset", "patch", "shape", "trapezoidation")),
    *(f"tests/steps/test_{name}_check.py::test_every_clause_is_seen" for name in (
        "lemma_3", "paper_interior", "paper_tube")),
    "tests/steps/test_lemma_1_check.py::test_all_clauses_are_known",
    "tests/steps/test_mesh_check.py::test_every_clause_is_tested_above",
)
# conftest.py of the copy. mutmut runs pytest many times in one process, so nothing may be left in a cache from before
# the mutation, nor from another test, or mutmut would not see what a test calls; and Hypothesis must not take offence
# at being called again. Quick tests go first, and what is there when a session begins is kept from the garbage
# collector, which would take longer than the tests.
CONFTEST = """
import gc
import json
import sys
from pathlib import Path

from hypothesis import Phase, core, settings

core.fail_health_check = lambda *args: None
settings.register_profile("mutation", database=None, phases=[Phase.explicit, Phase.generate])
settings.load_profile("mutation")


def pytest_sessionstart():
    gc.freeze()


def pytest_collection_finish(session):
    session.caches = [value for name, module in list(sys.modules.items()) if name.partition(".")[0] == "exactmesh"
                      for value in list(vars(module).values()) if hasattr(value, "cache_clear")]


def pytest_runtest_setup(item):
    for cached in item.session.caches:
        cached.cache_clear()


def pytest_collection_modifyitems(items):
    if (stats := Path("mutmut-stats.json")).exists():
        seconds = json.loads(stats.read_text())["duration_by_test"]
        items.sort(key=lambda item: seconds.get(item.nodeid, 0))
"""
KILLED = {1, 3, -6, -11}  # a test failed, or pytest or the interpreter itself did
TIMED_OUT = {24, -24, 36, 152, 255}


@dataclass(frozen=True, slots=True)
class Outcome:
    """What became of the mutants of one module."""

    killed: int
    timed_out: int
    survivors: tuple[str, ...]

    @property
    def total(self) -> int:
        return self.killed + self.timed_out + len(self.survivors)

    @property
    def percent(self) -> float:
        return 100 * (self.killed + self.timed_out) / self.total


def settings(module: str, tests: Sequence[str], patience: float) -> str:
    """Return the pyproject.toml of the copy."""
    of_pytest = ["-p", "no:cacheprovider", *(f"--deselect={name}" for name in LEFT_OUT)]
    return f"""
[tool.pytest.ini_options]
testpaths = ["tests"]
addopts = "--strict-markers -p no:unraisableexception -p no:threadexception"

[tool.mutmut]
source_paths = ["exactmesh"]
only_mutate = ["{module}"]
also_copy = {json.dumps(["conftest.py", *COPIED[2:]])}
pytest_add_cli_args = {json.dumps(of_pytest)}
pytest_add_cli_args_test_selection = {json.dumps(list(tests))}
timeout_multiplier = {patience}
timeout_constant = 2.0
use_git_change_detection = false
"""


def without_caches(source: str) -> str:
    """Return the source with `@lru_cache(...) def f` made `def _f` and `f = lru_cache(...)(_f)`.

    mutmut leaves functions with decorators alone.
    """
    lines = source.split("\n")
    for node in reversed(ast.parse(source).body):
        if isinstance(node, ast.FunctionDef) and len(node.decorator_list) == 1:
            decorator = ast.unparse(node.decorator_list[0])
            if decorator.startswith("lru_cache"):
                lines.insert(node.end_lineno or 0, f"{node.name} = {decorator}(_{node.name})")
                lines[node.lineno - 1] = lines[node.lineno - 1].replace(f"def {node.name}", f"def _{node.name}")
                del lines[node.lineno - 2]
    return "\n".join(lines)


def prepare(folder: Path, module: str, patience: float) -> None:
    """Copy what is tested, and the tests."""
    folder.mkdir(parents=True, exist_ok=True)
    for name in COPIED:
        shutil.copytree(ROOT / name, folder / name, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
    source = folder / module
    source.write_text(without_caches(source.read_text(encoding="utf-8")), encoding="utf-8")
    configure(folder, module, patience)


def configure(folder: Path, module: str, patience: float) -> None:
    """Write what mutmut and pytest are to do in the copy."""
    (folder / "conftest.py").write_text(CONFTEST, encoding="utf-8")
    (folder / "pyproject.toml").write_text(settings(module, TARGETS[module], patience), encoding="utf-8")


def mutmut(folder: Path, *args: str) -> None:
    """Run mutmut in the copy; raises `CalledProcessError` when it fails."""
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONHASHSEED": "0",
                   "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    done = subprocess.run([sys.executable, "-c", "from mutmut.__main__ import cli; cli()", *args], cwd=folder,
                          env=environment, text=True, capture_output=True)
    if done.returncode:
        print(done.stdout[-3000:], done.stderr[-3000:], file=sys.stderr)
        done.check_returncode()


def outcome(folder: Path, module: str) -> Outcome:
    """Read what mutmut has written."""
    found = json.loads((folder / "mutants" / f"{module}.meta").read_text(encoding="utf-8"))["exit_code_by_key"]
    if not found:
        raise SystemExit(f"{module}: nothing to mutate")
    killed = [name for name, code in found.items() if code in KILLED]
    timed_out = [name for name, code in found.items() if code in TIMED_OUT]
    return Outcome(len(killed), len(timed_out), tuple(name for name in found if name not in {*killed, *timed_out}))


def changes(folder: Path, module: str, names: Sequence[str]) -> list[str]:
    """Return the lines that each mutant changes, as mutmut shows them."""
    script = ("import json, sys; from pathlib import Path; from mutmut.mutation.diff_apply import get_diff_for_mutant; "
              "names = json.load(sys.stdin); "
              "print(json.dumps([get_diff_for_mutant(name, path=Path(sys.argv[1])) for name in names]))")
    done = subprocess.run([sys.executable, "-c", script, module], cwd=folder, input=json.dumps(names), text=True,
                          capture_output=True, check=True)
    return ["\n".join(f"    {line}" for line in diff.splitlines()
                      if line[:1] in "+-" and line[:3] not in ("+++", "---")) for diff in json.loads(done.stdout)]


def tested(module: str, folder: Path, again: bool, children: int, patience: float) -> Outcome:
    """Return the outcome for one module; new unless `again`."""
    if again:
        old = outcome(folder, module).survivors
        for name in ("tests", "mutants/tests"):
            shutil.rmtree(folder / name, ignore_errors=True)
            shutil.copytree(ROOT / "tests", folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        (folder / "mutants" / "mutmut-stats.json").unlink(missing_ok=True)
        configure(folder, module, patience)
        if old:
            mutmut(folder, "run", "--max-children", str(children), *old)
    else:
        shutil.rmtree(folder, ignore_errors=True)
        prepare(folder, module, patience)
        mutmut(folder, "run", "--max-children", str(children))
    return outcome(folder, module)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("modules", nargs="*", metavar="MODULE", help="such as exactmesh/check.py")
    parser.add_argument("--folder", type=Path, default=ROOT / "build" / "mutation")
    parser.add_argument("--again", action="store_true", help="retest survivors")
    parser.add_argument("--children", type=int, default=1, help="processes at a time")
    parser.add_argument("--patience", type=float, default=4, help="time out after so many times what tests take (4)")
    args = parser.parse_args()
    if unknown := set(args.modules) - set(TARGETS):
        parser.error(f"no target: {', '.join(sorted(unknown))}")
    outcomes: list[Outcome] = []
    for module in args.modules or TARGETS:
        folder = args.folder / module.removesuffix(".py").replace("/", ".")
        found = tested(module, folder, args.again, args.children, args.patience)
        outcomes.append(found)
        print(f"{module}: {found.percent:.1f} % of {found.total}: {found.killed} killed, {found.timed_out} timed out, "
              f"{len(found.survivors)} survived", flush=True)
        for name, change in zip(found.survivors, changes(folder, module, found.survivors), strict=True):
            print(f"  {name}\n{change}", flush=True)
    return 0 if all(found.percent >= LEAST for found in outcomes) else 1


if __name__ == "__main__":
    sys.exit(main())
