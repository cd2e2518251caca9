"""Search guided by `hypothesis.target`: the library mutates the examples whose score it is told is promising."""

from collections.abc import Callable
from math import atan2, log

from exactmesh.errors import InputError
from exactmesh.search.corners import is_simple
from exactmesh.search.figure import Figure
from exactmesh.search.targets import Evaluation


def require_hypothesis() -> None:
    """Raise `InputError`, saying what to install, when the library is not there."""
    try:
        import hypothesis  # noqa: F401
    except ImportError as error:
        raise InputError("--strategy guided needs the library hypothesis: pip install hypothesis") from error


def guide(see: Callable[[Figure], Evaluation], examples: int, seed: int, most: int = 12, size: int = 8) -> None:
    """Show `see` about `examples` polygons: points sorted by direction, on a grid whose gaps are drawn too.

    Scores are told as floats, the logarithm of the exact value: they guide what is tried next and decide nothing.
    Raises `InputError` without hypothesis.
    """
    require_hypothesis()
    from hypothesis import HealthCheck, Phase, given, settings, target
    from hypothesis import seed as seeded
    from hypothesis import strategies as st

    gaps = st.lists(st.integers(1, 200), min_size=size, max_size=size)
    corners = st.lists(st.tuples(st.integers(0, size), st.integers(0, size)), min_size=3, max_size=most, unique=True)

    @seeded(seed)
    @settings(max_examples=examples, database=None, deadline=None, suppress_health_check=list(HealthCheck),
              phases=(Phase.generate, Phase.target))
    @given(corners, gaps, gaps)
    def attempt(points: list[tuple[int, int]], columns: list[int], rows: list[int]) -> None:
        middle_x = sum(x for x, _ in points) / len(points)
        middle_y = sum(y for _, y in points) / len(points)
        points = sorted(points, key=lambda p: (atan2(p[1] - middle_y, p[0] - middle_x), p))
        polygon = tuple((sum(columns[:x]), sum(rows[:y])) for x, y in points)
        if is_simple(polygon) and (found := see(Figure.polygon(polygon))).rough:
            target(log(abs(found.rough)) * (1 if found.rough > 0 else -1), label="badness")

    attempt()
