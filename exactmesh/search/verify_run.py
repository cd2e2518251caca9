"""Judge many claims on many inputs: files, folders, files of one polygon a line, and families."""

import hashlib
import json
import os
from collections.abc import Iterable, Iterator, Sequence

from exactmesh.claims.ledger import JUDGED
from exactmesh.errors import InputError
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.read import read_pslg
from exactmesh.io.text import printable
from exactmesh.search.spec import Spec, Task
from exactmesh.search.targets import OBJECTIVES, target_of

Target = tuple[str, str, str]
_LINES = 100
_FIGURES = 100
_CORNERS = 20_000
_SUFFIXES = (".json", ".geojson", ".wkt", ".poly", ".txt")


def chosen_targets(claims: str, construction: str, kind: str | None) -> tuple[Target, ...]:
    """Return the targets of a list of claims, or of `all` that concern the construction; `both` is both.

    Raises `InputError` for an unknown claim, or when nothing is left to judge.
    """
    wanted = ("repaired", "paper") if construction == "both" else (construction,)
    names = [claim.id for claim in JUDGED if claim.check] if claims == "all" else claims.split(",")
    found = []
    for name in names:
        claim = OBJECTIVES.get(name) or target_of(name).claim
        sort = kind or claim.kinds[0]
        found += [target_of(name, run, sort).key for run in wanted if run in claim.runs and sort in claim.kinds
                  and not (run == "paper" and sort == "internal")]
    if not found:
        raise InputError(f"none of these claims is judged in runs of the construction {' or '.join(wanted)}")
    return tuple(dict.fromkeys(found))


def files_in(inputs: Sequence[str]) -> Iterator[str]:
    """Yield files, and those of known suffixes in folders, however deep, sorted."""
    for name in inputs:
        if not os.path.isdir(name):
            yield name
            continue
        for folder, below, files in os.walk(name):
            below.sort()
            yield from (os.path.join(folder, file) for file in sorted(files) if file.endswith((*_SUFFIXES, ".jsonl")))


def input_tasks(inputs: Sequence[str], refused: list[str]) -> Iterator[Task]:
    """Yield one task a file, or for `_LINES` lines of a .jsonl file; `refused` gets a line for what cannot be read.

    A task's key is the hash of what it judges, so a file that has changed is judged anew.
    """
    for path in files_in(inputs):
        try:
            if path.endswith(".jsonl"):
                yield from _line_tasks(path)
            else:
                pslg = read_pslg(path).pslg
                named = json_from_pslg(type(pslg)(pslg.vertices, pslg.edges, pslg.holes, path))
                yield _task([named])
        except InputError as error:
            refused.append(str(error))


def family_spec(text: str, targets: tuple[Target, ...], seed: int, count: int, shrinks: bool) -> Spec:
    """Return the spec of `count` figures of a family written `name:parameter=value,...`, or `path.py:function`: a
    hundred a task, fewer of large ones."""
    family, parameters, plugin = parsed_family(text)
    figures = max(1, min(count, _FIGURES, _CORNERS // max(1, dict(parameters).get("n", 1))))
    strategy = "exhaustive" if family == "lattice" else "random"
    return Spec(targets, strategy, family, parameters, plugin, seed, figures, shrinks=shrinks).checked()  # type: ignore[arg-type]


def parsed_family(text: str) -> tuple[str, tuple[tuple[str, int], ...], str]:
    """Return the name, the parameters and the plug-in's text of a family on the command line."""
    plugin = ""
    if ".py:" in text:
        path, _, text = text.partition(".py:")
        try:
            with open(path + ".py", encoding="utf-8") as file:
                plugin = file.read()
        except (OSError, ValueError) as error:
            raise InputError(f"{printable(path)}.py: cannot be read: {error}") from error
    name, _, rest = text.partition(":")
    parameters = []
    for part in filter(None, rest.split(",")):
        key, _, value = part.partition("=")
        if not value.removeprefix("-").isdecimal() or len(value) > 12:
            raise InputError(f"--family: {part!r} is not NAME=WHOLE NUMBER")
        parameters.append((key, int(value)))
    return name, tuple(sorted(parameters)), plugin


def _line_tasks(path: str) -> Iterator[Task]:
    try:
        with open(path, encoding="utf-8") as file:
            lines: list[str] = []
            for number, line in enumerate(file, 1):
                if line.strip():
                    lines.append(_named_line(line, f"{path}:{number}"))
                if len(lines) == _LINES:
                    yield _task(lines)
                    lines = []
            if lines:
                yield _task(lines)
    except (OSError, ValueError) as error:
        raise InputError(f"{printable(path)}: {error}") from error


def _named_line(line: str, name: str) -> str:
    """Return one line, an exactmesh-pslg/1 object or a list of corners, as the text of a named input."""
    value = json.loads(line)
    if isinstance(value, list):
        count = len(value)
        value = {"format": "exactmesh-pslg/1", "vertices": value, "edges": [[i, (i + 1) % count] for i in range(count)]}
    if not isinstance(value, dict):
        raise ValueError(f"{name}: neither an object nor a list of corners")
    return json.dumps({**value, "name": name})


def _task(texts: Iterable[str]) -> Task:
    payload = json.dumps(list(texts))
    return Task(hashlib.sha256(payload.encode()).hexdigest(), payload)
