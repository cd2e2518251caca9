"""The blocked list against a plain one, with blocks so short that every boundary is met."""

import random
from bisect import bisect_left

import pytest

from exactmesh.planar import status as module
from exactmesh.planar.status import Status


@pytest.mark.parametrize("longest", [1, 2, 3, 8, 512])
def test_any_run_of_changes_is_that_of_a_plain_list(longest: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_LONGEST", longest)
    source = random.Random(longest)
    status, plain = Status(), list[int]()
    for _ in range(3000):
        value = source.randrange(0, 10**6)
        low = bisect_left(plain, value)
        count = min(source.choice([0, 0, 1, 1, 2, 9, 30]), len(plain) - low)
        last = plain[low + count - 1] if count else None
        at = status.first(lambda edge, value=value: edge - value)  # type: ignore[misc]
        assert status.before(at) == (plain[low - 1] if low else -1)
        run, after = status.run(at, lambda edge, last=last: last is not None and edge <= last)  # type: ignore[misc]
        assert run == plain[low : low + count]
        assert after == (plain[low + count] if low + count < len(plain) else -1)
        upper = plain[low + count] if low + count < len(plain) else 10**6
        lower = plain[low - 1] if low else -1
        new = sorted({source.randrange(lower + 1, upper) for _ in range(source.choice([0, 1, 2, 20]))
                      if lower + 1 < upper})
        status.replace(at, count, new)
        plain[low : low + count] = new
        everything, end = status.run((0, 0), lambda edge: True)
        assert everything == plain and end == -1
    assert plain


def test_the_lookups_are_logarithmic() -> None:
    status = Status()
    for edge in range(20_000):
        status.replace(status.first(lambda e, edge=edge: e - edge), 0, [edge])  # type: ignore[misc]
    asked = 0

    def height(edge: int) -> int:
        nonlocal asked
        asked += 1
        return edge - 12_345

    at = status.first(height)
    assert status.before(at) == 12_344 and asked <= 20
