"""The targets of mutation testing are there, and docs/mutation.md speaks of them and adds up."""

import ast
import re
import tomllib

import pytest
import run as mutation

DOCUMENT = (mutation.ROOT / "docs" / "mutation.md").read_text(encoding="utf-8")
ROW = re.compile(r"\| `(exactmesh/[a-z_/]+\.py)` \| (\d+) \| (\d+) \| (\d+) \| (\d+) \| (\d+\.\d) \|")
ROWS = {row[0]: (*map(int, row[1:5]), row[5]) for row in ROW.findall(DOCUMENT)}


@pytest.mark.parametrize("module", mutation.TARGETS)
def test_a_target_and_its_tests_are_there(module: str) -> None:
    assert (mutation.ROOT / module).is_file()
    assert mutation.TARGETS[module] and all((mutation.ROOT / tests).exists() for tests in mutation.TARGETS[module])


@pytest.mark.parametrize("name", mutation.LEFT_OUT)
def test_what_is_left_out_is_a_test(name: str) -> None:
    path, *parts = name.split("::")
    nodes: list[ast.stmt] = ast.parse((mutation.ROOT / path).read_text(encoding="utf-8")).body
    for part in parts:
        nodes = next(node.body for node in nodes
                     if isinstance(node, (ast.ClassDef, ast.FunctionDef)) and node.name == part)


def test_the_document_is_about_targets_and_its_counts_add_up() -> None:
    assert ROWS and set(ROWS) <= set(mutation.TARGETS)
    for module, (mutants, killed, timed_out, survived, percent) in ROWS.items():
        assert mutants == killed + timed_out + survived, module
        assert f"{100 * (killed + timed_out) / mutants:.1f}" == percent, module
        assert float(percent) >= mutation.LEAST, module


def test_each_survivor_is_listed_once_with_a_reason() -> None:
    listed = re.findall(r"^\| `([a-z_]+(?:\.[a-z_]+)*)\.([^`|]*)` \| `.+` \| (.+) \|$", DOCUMENT, re.MULTILINE)
    names = [f"{module}.{name}" for module, name, _ in listed]
    groups = re.findall(r"^\| `([a-z_0-9.]+)\.([^`.]+__mutmut_)` \| ([\d, ]+) \| .+ \|$", DOCUMENT, re.MULTILINE)
    names += [f"{module}.{name}{number}" for module, name, numbers in groups for number in numbers.split(", ")]
    assert len(names) == len(set(names)) and all(reason for *_, reason in listed)
    for module, (_, _, _, survived, _) in ROWS.items():
        dotted = module.removesuffix(".py").replace("/", ".")
        assert sum(name.rpartition(".")[0] == dotted for name in names) == survived, module


def test_the_settings_of_a_run_are_those_of_its_target() -> None:
    found = tomllib.loads(mutation.settings("exactmesh/check.py", ["tests/a.py"], 4))["tool"]["mutmut"]
    assert found["only_mutate"] == ["exactmesh/check.py"]
    assert found["pytest_add_cli_args_test_selection"] == ["tests/a.py"]


def test_cached_functions_are_made_plain_and_cached_all_the_same() -> None:
    source = (mutation.ROOT / "exactmesh/numbers/radicals.py").read_text(encoding="utf-8")
    made = mutation.without_caches(source)
    before, after = ast.parse(source), ast.parse(made)
    cached = {node.name: ast.unparse(node.decorator_list[0]) for node in before.body
              if isinstance(node, ast.FunctionDef) and node.decorator_list}
    assert cached and not any(node.decorator_list for node in after.body if isinstance(node, ast.FunctionDef))
    assigned = {node.targets[0].id: ast.unparse(node.value) for node in after.body
                if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)}
    for name, decorator in cached.items():
        assert assigned[name] == f"{decorator}(_{name})"
    plain = "def f(x):\n    return x\n"
    assert mutation.without_caches(plain) == plain
