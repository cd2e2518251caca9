"""The two readings of the paper's d3, and the rational granularity that stands for 1/(2 d3).

The paper gives 1/d3, the feature size of P3, once as (1/4) 2 sin(pi/8) and uses 4 sqrt 2 for d3 elsewhere. `Reading`
names the choice; lengths are in units of mfs(P).
"""

from dataclasses import dataclass
from typing import Literal

from gmpy2 import mpq

from exactmesh.numbers.algebraic import Real, sqrt

ReadingName = Literal["octagon", "tube"]


@dataclass(frozen=True, slots=True)
class Reading:
    """A reading of d3. `granularity` is a rational at most 1/(2 d3), the spacing of the grid in units of the mfs."""

    name: ReadingName
    inverse_d3: Real
    granularity: mpq


def sin_eighth() -> Real:
    """Return sin(pi/8) = sqrt(2 - sqrt 2)/2."""
    return (2 - sqrt(2)).sqrt() / 2


# 2/21 and 3/34 are the fractions of least denominator just below 1/(2 d3) that change no sentence of the paper: above
# 4/45 the Tube keeps its degradation below 45; the second reading's 1/(2 d3) is itself below 4/45.
READINGS: dict[ReadingName, Reading] = {
    "octagon": Reading("octagon", sin_eighth() / 2, mpq(2, 21)),
    "tube": Reading("tube", 1 / (4 * sqrt(2)), mpq(3, 34)),
}
