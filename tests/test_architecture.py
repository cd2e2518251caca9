"""Imports go down only: each layer knows the ones below it, and checkers do not know what they check."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import exactmesh

ROOT = Path(exactmesh.__file__).parent
# A module may import what has a lower rank, and its own folder. `errors` and `data` are below everything.
RANKS = {
    "errors": 0, "numbers": 1, "geometry": 2, "planar": 3, "measure": 4, "io": 5, "data": 6, "steps": 6, "proofs": 6,
    "families": 7, "optimize": 8, "pictures": 8.5,
    "repaired": 7, "paper": 7, "classic": 7, "check": 0, "certificate": 9, "claims": 8, "api": 9, "report": 10,
    "report_ledger": 11, "report_foreign": 11, "search": 14, "dissection": 15, "reproduce": 15.5, "bench": 16,
    "viewer": 16, "progress": 1, "collector": 0, "trust": 1, "commands": 19,
    "__init__": 12, "cli": 20, "__main__": 21,
}
# Rooms at one height that do not know each other, beyond what the ranks say.
FORBIDDEN = {
    "steps": {"io", "data", "progress", "proofs"}, "claims": {"api", "report", "cli"},
    "measure": {"steps", "claims", "repaired", "paper", "io"},
    "io": {"steps", "claims", "repaired", "paper", "api", "report"},
}
BUILDERS = {"quad", "nested", "one_sided", "frame", "heights", "pieces"}


def name_of(path: Path) -> str:
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" and len(parts) > 2 else parts)


MODULES = {name_of(path): path for path in sorted(ROOT.rglob("*.py"))}


def tree(module: str) -> ast.Module:
    return ast.parse(MODULES[module].read_text(encoding="utf-8"))


def imported(module: str) -> Iterator[str]:
    """Yield the modules of the package that a module imports, anywhere in it, for use at run time or not."""
    for node in ast.walk(tree(module)):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            base = "relative" if node.level else node.module or ""
            names = [f"{base}.{alias.name}" if f"{base}.{alias.name}" in MODULES else base for alias in node.names]
        else:
            continue
        for name in names:
            if name.startswith("relative"):
                yield name
            elif name == "exactmesh":
                yield "exactmesh.__init__"
            elif name.startswith("exactmesh."):
                yield name


IMPORTS = {module: sorted(set(imported(module)) - {module}) for module in MODULES}


def room(module: str) -> str:
    return module.split(".")[1] if "." in module else module


def test_something_is_looked_at() -> None:
    assert len(MODULES) > 50 and sum(map(len, IMPORTS.values())) > 200
    assert "exactmesh.steps.pieces" in IMPORTS["exactmesh.steps.patch_builder"]
    assert "exactmesh.measure.verdict" in IMPORTS["exactmesh.steps.offset_check"]


@pytest.mark.parametrize("module", MODULES)
def test_every_module_has_a_place(module: str) -> None:
    assert room(module) in RANKS, f"{room(module)} needs a rank in this test"


@pytest.mark.parametrize("module", MODULES)
def test_every_module_says_what_it_is_for(module: str) -> None:
    text = ast.get_docstring(tree(module))
    assert text and len(text.splitlines()[0]) > 10


@pytest.mark.parametrize("module", MODULES)
def test_imports_go_down_only(module: str) -> None:
    here = room(module)
    for name in IMPORTS[module]:
        there = room(name)
        assert there == here or RANKS[there] < RANKS[here], f"{module} imports {name}"
        assert there not in FORBIDDEN.get(here, set()), f"{module} imports {name}"


@pytest.mark.parametrize("module", MODULES)
def test_imports_are_absolute_and_of_modules_that_exist(module: str) -> None:
    assert set(IMPORTS[module]) <= set(MODULES)


def test_only_the_command_line_imports_the_package_itself() -> None:
    # For its version; the modules below import the module that owns a name.
    users = {module for module, names in IMPORTS.items() if "exactmesh.__init__" in names}
    assert users <= {"exactmesh.commands.parser"}


def test_there_is_no_cycle() -> None:
    done: set[str] = set()
    # The package itself is imported for its version only, by the parser.
    left = {module: set(names) - {"exactmesh.__init__"} for module, names in IMPORTS.items()}
    del left["exactmesh.__init__"]
    while left:
        ready = {module for module, names in left.items() if done.issuperset(names)}
        assert ready, f"a cycle among {sorted(left)}"
        done |= ready
        left = {module: names for module, names in left.items() if module not in ready}


def reached(module: str) -> set[str]:
    """Return all modules that a module imports, directly or not."""
    found: set[str] = set()
    waiting = [module]
    while waiting:
        for name in IMPORTS.get(waiting.pop(), ()):
            if name not in found:
                found.add(name)
                waiting.append(name)
    return found


@pytest.mark.parametrize("module", [module for module in MODULES if module.endswith("_check")])
def test_a_checker_does_not_reach_what_it_checks(module: str) -> None:
    below = reached(module)
    assert module.removesuffix("_check") not in below
    assert not below & {f"exactmesh.steps.{name}" for name in BUILDERS}


@pytest.mark.parametrize("module", [module for module in MODULES if room(module) == "measure"])
def test_verification_knows_no_construction(module: str) -> None:
    assert {room(name) for name in reached(module)} <= {"measure", "planar", "geometry", "numbers", "errors"}


@pytest.mark.parametrize("module", [module for module in MODULES if room(module) in ("numbers", "geometry")])
def test_the_kernel_stands_alone(module: str) -> None:
    assert {room(name) for name in reached(module)} <= {"geometry", "numbers", "errors"}


def test_half_edges_know_no_coordinates() -> None:
    assert "exactmesh.geometry" not in {name.rpartition(".")[0] for name in IMPORTS["exactmesh.planar.half_edges"]}
