"""Table 1 of the paper on inputs: every family in every size, meshed in every way, each degradation exact.

A row is judged by what the table says of its kind, exactly:

classic    degradation at least what *every* classic mesh of the input has (`Family.optimum`)
optimal    the same, and at most what the best one has; both from arguments, here against dynamic programming
nonproper  degradation at most 21.6
proper     degradation at most max(21.6, 9 (1 + log2 n))
internal   the mesh is proper, and the internal feature size degrades by less than 45

Not checked: the claims on the steps of each construction (`exactmesh mesh` does), only the finished mesh.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Literal, get_args

from gmpy2 import mpq

from exactmesh.claims.run import Run
from exactmesh.measure.validity import Verification
from exactmesh.measure.verdict import Verdict, Witness, failed
from exactmesh.planar.pslg import Pslg
from exactmesh.reproduce.families import FAMILIES, Family
from exactmesh.steps.constants import DESIGN_DEGRADATION, PAPER_DEGRADATION, PROPER_FACTOR
from exactmesh.steps.mesh_check import check_design_degradation, check_internal_degradation, check_proper_degradation

Made = Literal["classic", "optimal", "nonproper", "proper", "internal"]
MADE: tuple[Made, ...] = get_args(Made)
# Dynamic programming takes seconds beyond this, and `optimum` says what it would find.
MAX_OPTIMAL = 64


@dataclass(frozen=True, slots=True)
class Row:
    """One mesh of one input with `n` vertices. "optimal" is the best classic mesh, "classic" the constrained
    Delaunay triangulation; the others are by the repaired construction."""

    family: Family
    size: int
    n: int
    made: Made
    verification: Verification

    @property
    def measure(self) -> str:
        """The feature size that the kind is to keep: "ifs" for internal meshes, else "mfs"."""
        return "ifs" if self.made == "internal" else "mfs"

    @property
    def degradation_squared(self) -> mpq | None:
        """The exact square of the degradation of `measure`; None when the mesh is not valid."""
        found = self.verification
        return found.ifs_degradation_squared if self.measure == "ifs" else found.degradation_squared

    @property
    def place(self) -> int:
        """What growth is measured in: n, or r."""
        return self.family.place(self.size, self.n)


def table1_rows(made: Sequence[Made] = MADE, short: bool = False,
                progress: Callable[[str], None] = lambda step: None, families: Sequence[Family] = FAMILIES
                ) -> Iterator[Row]:
    """Yield the rows, family by family in rising size; `progress` is told each."""
    for family in families:
        for size in family.sizes(short):
            pslg = family.make(size)
            n = len(pslg.vertices)
            for kind in made:
                if kind == "optimal" and n > MAX_OPTIMAL:
                    continue
                progress(f"{family.name} {family.variable} = {size}, {kind}")
                yield Row(family, size, n, kind, _run(pslg, kind).verification)


def _run(pslg: Pslg, made: Made) -> Run:
    if made == "classic" or made == "optimal":
        return Run(pslg, "classic", "classic", optimal=made == "optimal")
    return Run(pslg, "repaired", made)


def check(row: Row) -> Verdict | None:
    """Return the verdict on a row, one instance; None when nothing is known to check it against."""
    if row.made == "nonproper":
        return check_design_degradation(row.verification)
    if row.made == "proper":
        # Each family is of single polygons, which have a corner for every vertex.
        return check_proper_degradation(row.verification, row.n)
    if row.made == "internal":
        return check_internal_degradation(row.verification)
    return _check_classic(row)


def clause(family: Family, made: Made) -> str:
    """Return what the rows of a family are checked against, for reading; empty for nothing."""
    if made == "nonproper":
        return f"<= {float(DESIGN_DEGRADATION)}"
    if made == "proper":
        return f"<= max({float(DESIGN_DEGRADATION)}, {PROPER_FACTOR} (1 + log2 n))"
    if made == "internal":
        return f"< {PAPER_DEGRADATION}"
    if not family.formula:
        return ""
    return f"{'>=' if made == 'classic' else '='} {family.formula}{', within the error' if family.within else ''}"


def _check_classic(row: Row) -> Verdict | None:
    squared = row.degradation_squared
    if squared is None:
        return failed(1, "the mesh is valid", violations=len(row.verification.violations))
    if row.family.optimum is None:
        return None
    low, high = row.family.optimum(row.size)
    holds = low <= squared and (row.made == "classic" or squared <= high)
    return Verdict(1, holds, squared, Witness(f"degradation {clause(row.family, row.made)}", {"size": row.size}))
