"""What a run is to do, as a record that names it in stores and travels to workers as JSON."""

import json
from collections.abc import Iterator
from dataclasses import asdict, dataclass, replace
from functools import lru_cache
from typing import Literal, NamedTuple, get_args

from exactmesh.errors import InputError
from exactmesh.search.families import DOMAINS, family_of
from exactmesh.search.lattice import Prefix, prefixes
from exactmesh.search.targets import Target, target_of

Strategy = Literal["exhaustive", "random", "climb", "anneal", "guided", "inputs"]
STRATEGIES: tuple[Strategy, ...] = get_args(Strategy)
# For each number of corners; a task should take longer than handing it out and storing its report.
_MOST_TASKS = 2000


class Task(NamedTuple):
    """A part of a run: `key` is unique in it; `payload` is the text of inputs, empty where the key says it all."""

    key: str
    payload: str = ""


@dataclass(frozen=True, slots=True)
class Spec:
    """Equal specs do equal work: nothing here depends on how many workers there are or how long they may take.

    `plugin` is the text of a plug-in file, so that workers elsewhere need no copy of it. `size` is the number of
    polygons of a random task, of steps of a local search, of examples of a guided one.
    """

    targets: tuple[tuple[str, str, str], ...]
    strategy: Strategy
    family: str
    parameters: tuple[tuple[str, int], ...] = ()
    plugin: str = ""
    seed: int = 0
    size: int = 0
    shard: tuple[int, int] = (0, 1)
    shrinks: bool = True

    def to_json(self) -> str:
        """Return the text that is the identity of the run."""
        return json.dumps(asdict(self), sort_keys=True)

    @classmethod
    def from_json(cls, text: str) -> "Spec":
        """Return the spec of a text made by `to_json`."""
        found = json.loads(text)
        return cls(**{**found, "targets": tuple(tuple(t) for t in found["targets"]), "shard": tuple(found["shard"]),
                      "parameters": tuple((name, value) for name, value in found["parameters"])})

    def target_records(self) -> tuple[Target, ...]:
        """Return the targets; raises `InputError` for what is unknown."""
        return tuple(target_of(*target) for target in self.targets)

    def checked(self) -> "Spec":
        """Return the spec with its defaults filled in; raises `InputError` when it cannot be run."""
        self.target_records()
        residue, modulus = self.shard
        if not 0 <= residue < modulus:
            raise InputError(f"--shard RES/MOD needs 0 <= RES < MOD, not {residue}/{modulus}")
        if self.strategy == "exhaustive":
            lattice_range(self)
        elif self.strategy != "inputs":
            family_of(self.family, dict(self.parameters), self.plugin)
            if not self.plugin and self.family in DOMAINS and all(run == "paper" for _, run, _ in self.targets):
                raise InputError(f"the family {self.family} is not of simple polygons, which is all that the paper's "
                                 "construction is for")
        defaults = {"random": 25, "climb": 120, "anneal": 120, "guided": 60}
        return replace(self, size=self.size or defaults.get(self.strategy, 1))


def lattice_range(spec: Spec) -> tuple[range, int, int, bool, bool]:
    """Return the numbers of corners, columns and rows, whether straight angles count, whether all images are judged."""
    if spec.family != "lattice":
        raise InputError("the exhaustive strategy is for --family lattice[:n=4,m=3] (and nmax, k, straight, images)")
    known = {"n": 4, "m": 3, "straight": 1, "images": 1}
    parameters = {**known, **dict(spec.parameters)}
    if unknown := sorted(set(parameters) - {*known, "nmax", "k"}):
        raise InputError(f"the family lattice has no parameter {unknown[0]!r}; it has n, nmax, m, k, straight, images")
    n, m = parameters["n"], parameters["m"]
    k = parameters.get("k", m)
    if n < 3 or m < 2 or k < 2:
        raise InputError("lattice polygons have n >= 3 corners on m >= 2 columns and k >= 2 rows of points")
    counts = range(n, max(n, parameters.get("nmax", n)) + 1)
    return counts, m, k, bool(parameters["straight"]), bool(parameters["images"])


@lru_cache(maxsize=4)
def prefix_groups(m: int, k: int) -> tuple[tuple[Prefix, ...], ...]:
    """Return all prefixes of lattice polygons, a group a task: each alone, or dealt out when there are very many."""
    every = tuple(prefixes(m, k))
    count = min(len(every), _MOST_TASKS)
    return tuple(every[i::count] for i in range(count))


def search_tasks(spec: Spec) -> Iterator[Task]:
    """Yield the tasks of a search in order: finitely many of an exhaustive one, of others without end."""
    residue, modulus = spec.shard
    if spec.strategy == "exhaustive":
        counts, m, k, _, _ = lattice_range(spec)
        for n in counts:
            for index in range(residue, len(prefix_groups(m, k)), modulus):
                yield Task(f"{n}:{index}")
        return
    index = residue
    while True:
        yield Task(str(index))
        index += modulus
