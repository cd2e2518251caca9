"""For checkers: the worst exact value of many, found with floats and missing none.

Only those values are taken exactly that floats with error bounds do not show to be better than another one.
"""

from collections.abc import Callable

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.balls import Balls, Floats, Ints
from exactmesh.geometry.decisions import note
from exactmesh.measure.verdict import Tally

Exactly = Callable[[int], mpq]
Place = Callable[[int], dict[str, object]]


class FilteredTally:
    """Shows a tally the first worst of many numbered values, which are offered in stretches and in any order.

    The least value is the worst for the relations >= and >, the greatest for <= and <.
    """

    def __init__(self, tally: Tally, what: str) -> None:
        self.tally, self.what = tally, what
        self.least_is_worst = tally.relation[0] == ">"
        self.bound = np.inf
        self.kept: list[tuple[Ints, Floats]] = []

    def offer(self, numbers: Ints, values: Balls) -> None:
        """Take values by their numbers; what may be the worst is kept."""
        ranked = values if self.least_is_worst else -values
        low, high = ranked.low(), ranked.high()
        if high.size:
            self.bound = float(np.fmin(self.bound, np.fmin.reduce(high)))
        keep = ~(low > self.bound)
        self.kept.append((numbers[keep], low[keep]))

    def see(self, exactly: Exactly, place: Place, count: int) -> None:
        """Show the tally the worst value and its place, as the last of `count` instances."""
        if not count:
            return
        numbers = np.sort(np.concatenate([kept[~(low > self.bound)] for kept, low in self.kept])).tolist()
        note(self.what, count, len(numbers))
        values = map(exactly, numbers)
        worst, first = (min if self.least_is_worst else max)(zip(values, numbers, strict=True), key=lambda v: v[0])
        self.tally.see(worst, **place(first))
        self.tally.instances += count - 1


def see_worst(tally: Tally, what: str, values: Balls, exactly: Exactly, place: Place) -> None:
    """Show the tally the first worst of the values; these are the instances 0, 1, .., which `exactly` returns."""
    filtered = FilteredTally(tally, what)
    filtered.offer(np.arange(len(values)), values)
    filtered.see(exactly, place, len(values))
