"""What a verdict rests on: the files that run when it is made, with their lines, from the sources that are installed.

A base has a few modules at its root; the rest follows from their imports, those inside functions included, those for
type checkers alone left out. Modules from elsewhere than the standard library are named and not counted.
"""

import ast
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path

_PACKAGE = "exactmesh"
_ROOT = Path(__file__).parent


@dataclass(frozen=True, slots=True)
class Base:
    """The trusted base of one kind of verdict: `files` are paths from the package's folder with their lines."""

    name: str
    verdict: str
    files: tuple[tuple[str, int], ...]
    libraries: tuple[str, ...]

    @property
    def lines(self) -> int:
        """How many lines there are in all files."""
        return sum(lines for _, lines in self.files)


# Name, what rests on it, and the modules at its root; `*` stands for the checkers of all steps.
_BASES = (
    ("check.py", "a certificate is accepted: exactmesh check, python check.py", ("check",)),
    ("check.c", "a certificate is accepted, without Python: check.c", ("check.c",)),
    ("mfs", "an exact minimum feature size: exactmesh mfs", ("measure.mfs", "planar.faces")),
    ("verify", "a mesh is valid, and its degradation: exactmesh verify", ("measure.validity", "planar.faces")),
    ("reading", "what the exact files say, for mfs and verify", ("io.pslg_json", "io.mesh_json")),
    ("steps", "each claim about a step of a construction, on a run", ("steps.*_check",)),
    ("dissection", "a dissection is one: exactmesh verify-dissection", ("dissection.verify",)),
    ("proofs", "a claim is proved, as re-checked: exactmesh prove --fast", ("proofs.certificate",)),
)


def trusted_bases() -> tuple[Base, ...]:
    """Return the trusted base of each kind of verdict."""
    return tuple(_base(*given) for given in _BASES)


def trust_text(bases: Sequence[Base], files: bool = True) -> str:
    """Return a table of the bases, with their files or without."""
    lines = []
    for base in bases:
        besides = ", ".join(base.libraries) or "nothing besides"
        lines.append(f"{base.lines:6}  {base.name}: {base.verdict} ({besides})")
        if files:
            lines += [f"{count:10}  {_PACKAGE}/{path}" for path, count in base.files]
    return "\n".join(lines)


def trust_value(bases: Sequence[Base]) -> list[dict[str, object]]:
    """Return the bases as JSON has them."""
    return [{"base": base.name, "verdict": base.verdict, "lines": base.lines, "libraries": list(base.libraries),
             "files": [{"path": f"{_PACKAGE}/{path}", "lines": lines} for path, lines in base.files]}
            for base in bases]


def _base(name: str, verdict: str, roots: Sequence[str]) -> Base:
    found: set[Path] = set()
    libraries: set[str] = set()
    waiting = [path for root in roots for path in _sources(root)]
    while waiting:
        path = waiting.pop()
        if path in found:
            continue
        found.add(path)
        if path.suffix == ".py":
            for module in _imports(path):
                if module.partition(".")[0] == _PACKAGE:
                    waiting += _run_by(module)
                else:
                    libraries.add(module.partition(".")[0])
    files = sorted((path.relative_to(_ROOT).as_posix(), len(path.read_text(encoding="utf-8").splitlines()))
                   for path in found)
    return Base(name, verdict, tuple(files), tuple(sorted(libraries - sys.stdlib_module_names)))


def _sources(root: str) -> list[Path]:
    """Return the files of a root: a module or a pattern of modules, or a file that is no module."""
    if root.endswith(".c"):
        return [_ROOT / root]
    return sorted(_ROOT.glob(root.replace(".", "/") + ".py"))


@cache
def _imports(path: Path) -> tuple[str, ...]:
    """Return the modules that a file imports, at any time."""
    found: list[str] = []
    waiting: list[ast.AST] = [ast.parse(path.read_text(encoding="utf-8"))]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.If) and isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING":
            waiting += node.orelse
            continue
        waiting += ast.iter_child_nodes(node)
        if isinstance(node, ast.Import):
            found += [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module:
            found += [f"{node.module}.{alias.name}" for alias in node.names]
    return tuple(found)


def _run_by(module: str) -> list[Path]:
    """Return the files that run when a name, of a module of the package or a module itself, is imported."""
    parts = module.split(".")[1:]
    found = []
    for depth in range(len(parts) + 1):
        place = _ROOT.joinpath(*parts[:depth])
        found += [path for path in (place / "__init__.py", place.with_suffix(".py")) if path.is_file() and (
            depth or path.name == "__init__.py")]
    return found
