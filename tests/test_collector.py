"""The collector is paused and goes on as before, without a walk over what was made meanwhile."""

import gc
from typing import Any

import pytest

from exactmesh.collector import collector_paused


class Knot:
    """Refers to itself."""

    def __init__(self) -> None:
        self.itself = self


def test_what_was_made_meanwhile_is_walked_with_all_else_only() -> None:
    walks: list[dict[str, Any]] = []

    def note(phase: str, info: dict[str, Any]) -> None:
        if phase == "start":
            walks.append(info)

    gc.collect()
    gc.callbacks.append(note)
    try:
        with collector_paused():
            assert not gc.isenabled()
            made = [Knot() for _ in range(20_000)]
        some = [[] for _ in range(5)]  # type: ignore[var-annotated]
        assert not walks and gc.isenabled() and len(made) + len(some) == 20_005
        del made
        assert gc.collect() >= 20_000
    finally:
        gc.callbacks.remove(note)


def test_it_stays_off_where_it_was_off_and_what_is_frozen_stays_frozen() -> None:
    gc.disable()
    try:
        with collector_paused():
            pass
        assert not gc.isenabled()
    finally:
        gc.enable()
    gc.freeze()
    try:
        frozen = gc.get_freeze_count()
        with pytest.raises(ValueError, match="as before"), collector_paused():
            raise ValueError("as before")
        assert gc.isenabled() and gc.get_freeze_count() == frozen > 0
    finally:
        gc.unfreeze()
