"""The blocked list against a plain one, with blocks so short that every boundary is met."""

import random
from bisect import bisect_left

import pytest

from exactmesh.planar import status as module
from exactmesh.planar.status import Status


@pytest.mark.parametrize("longest", [1, 2, 3, 8, 128])
def test_any_run_of_changes_is_that_of_a_plain_list(longest: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_LONGEST", longest)
    source = random.Random(longest)
    status, plain = Status(10**6), list[int]()
    for _ in range(3000):
        value = source.randrange(0, 10**6)
        low = bisect_left(plain, value)
        count = min(source.choice([0, 0, 1, 1, 2, 9, 30]), len(plain) - low)
        last = plain[low + count - 1] if count else None
        at = status.first(lambda edges, value=value: bisect_left(edges, value))  # type: ignore[misc]
        assert status.before(at) == (plain[low - 1] if low else -1)
        if low < len(plain):
            assert status.place(plain[low]) == at
        previous = status.previous(at)
        assert previous == (status.place(plain[low - 1]) if low else None)
        run, after = status.run(at, lambda edge, last=last: last is not None and edge <= last)  # type: ignore[misc]
        assert run == plain[low : low + count]
        assert after == (plain[low + count] if low + count < len(plain) else -1)
        upper = plain[low + count] if low + count < len(plain) else 10**6
        lower = plain[low - 1] if low else -1
        new = sorted({source.randrange(lower + 1, upper) for _ in range(source.choice([0, 1, 2, 20]))
                      if lower + 1 < upper})
        status.replace(at, count, new)
        plain[low : low + count] = new
        everything, end = status.run(status.first(lambda edges: 0), lambda edge: True)
        assert everything == plain and end == -1
        for edge in source.sample(plain, min(3, len(plain))):
            assert status.first(lambda edges, edge=edge: bisect_left(edges, edge)) == status.place(  # type: ignore[misc]
                edge)
    assert plain


def test_the_lookups_are_logarithmic_and_in_few_parts() -> None:
    status = Status(20_000)
    for edge in range(20_000):
        status.replace(status.first(lambda edges, edge=edge: bisect_left(edges, edge)), 0, [edge])  # type: ignore[misc]
    parts = []

    def count_before(edges: object) -> int:
        parts.append(len(edges))  # type: ignore[arg-type]
        return bisect_left(edges, 12_345)  # type: ignore[call-overload, no-any-return]

    at = status.first(count_before)
    assert status.before(at) == 12_344 and len(parts) == 2 and parts[1] <= 128
    assert parts[0] <= 20_000 / 64 + 1
