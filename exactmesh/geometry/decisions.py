"""How many decisions float filters made, and how many were left to exact arithmetic.

Filters note what they do under a name; counts are of this process and only grow. Nothing is decided by them.
"""

from dataclasses import dataclass


@dataclass(slots=True)
class Count:
    """Decisions `by_floats`, and those made `exactly`."""

    by_floats: int = 0
    exactly: int = 0


_COUNTS: dict[str, Count] = {}


def note(what: str, total: int, exactly: int) -> None:
    """Count `total` decisions of one sort, of which a number were made exactly."""
    count = _COUNTS.setdefault(what, Count())
    count.by_floats += total - exactly
    count.exactly += exactly


def decisions() -> dict[str, Count]:
    """Return the counts so far, by name."""
    return {what: Count(count.by_floats, count.exactly) for what, count in sorted(_COUNTS.items())}


def forget() -> None:
    """Begin to count anew."""
    _COUNTS.clear()
