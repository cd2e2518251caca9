"""What a checker returns: how much it saw, the worst exact value, and the place where it is or where a clause fails."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from gmpy2 import mpq

from exactmesh.numbers.algebraic import Real

Relation = Literal[">=", ">", "<=", "<", "=="]


@dataclass(frozen=True, slots=True)
class Witness:
    """A clause of the claim, and where: names such as `vertex`, `edge`, `face` with indices, `at` with a point."""

    clause: str
    place: Mapping[str, object]


@dataclass(frozen=True, slots=True)
class Verdict:
    """`worst` is in the unit of the claim (a square where the claim is about a length); None where there is no
    quantity. `witness` is the place of the worst value, or of the first failure. Ask `holds` by name."""

    instances: int
    holds: bool
    worst: mpq | Real | None = None
    witness: Witness | None = None

    def __bool__(self) -> bool:
        raise TypeError("a Verdict is not a truth value: ask verdict.holds")


@dataclass(slots=True)
class Tally:
    """Compares values with a bound as they are met and keeps the worst one.

    The worst value is the least for the relations >= and >, the greatest for <= and <, the farthest off for ==.
    """

    clause: str
    relation: Relation
    bound: mpq | Real
    instances: int = 0
    worst: mpq | Real | None = None
    place: Mapping[str, object] = field(default_factory=dict)

    def see(self, value: mpq | Real, **place: object) -> None:
        """Count one instance with the given value at the given place."""
        self.instances += 1
        if self.worst is None or self._is_worse(value, self.worst):
            self.worst, self.place = value, place

    def _is_worse(self, value: mpq | Real, than: mpq | Real) -> bool:
        if self.relation == "==":
            return bool(abs(value - self.bound) > abs(than - self.bound))
        return bool(value < than if self.relation[0] == ">" else value > than)

    def verdict(self) -> Verdict:
        """Return the verdict on all that was seen; a claim without instances holds."""
        if self.worst is None:
            return Verdict(0, True)
        holds = satisfies(self.worst, self.relation, self.bound)
        return Verdict(self.instances, holds, self.worst, Witness(self.clause, self.place))


def satisfies(value: mpq | Real, relation: Relation, bound: mpq | Real) -> bool:
    """Return whether `value relation bound`."""
    outcome = {">=": value >= bound, ">": value > bound, "<=": value <= bound, "<": value < bound,
               "==": value == bound}
    return bool(outcome[relation])


def failed(instances: int, clause: str, **place: object) -> Verdict:
    """Return the verdict that a clause fails at a place, the last of `instances` seen."""
    return Verdict(instances, False, None, Witness(clause, place))
