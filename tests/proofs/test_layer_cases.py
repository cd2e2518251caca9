"""The faces of layers are those that `repaired.proper-degradation-22` lists, and what it supposes of each is true.

Strips lie as in the script: the clean side from A = (0,0) to B = (D,0), the T-side above it.
"""

import importlib
import itertools
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry.point import Point
from exactmesh.steps.constants import LEVEL, THICKNESS_MAX
from exactmesh.steps.frame import frame_of
from exactmesh.steps.heights import height_squared
from exactmesh.steps.layers import layered_below, layered_trials
from exactmesh.steps.records import Piece

SCRIPTS = Path(exactmesh.__file__).parents[1] / "proofs_checks"
SPACING = mpq(503, 10000)
A = Point(mpq(0), mpq(0))
# A case: the beginning of the ids of its problems, with values for their variables in units of the spacing.
Leaf = tuple[str, dict[str, mpq]]


@pytest.fixture(scope="module")
def script() -> Iterator[Any]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(SCRIPTS))
        yield importlib.import_module("repaired_layers")


class Layers:
    """A layered strip: its rows from the T-side on, and what is between its fans."""

    def __init__(self, side: list[Point], length: mpq, reach: int, piece: Piece) -> None:
        self.side, self.length = side, length
        self.low = min(side[0].y, side[-1].y)
        self.slope = (side[-1].y - side[0].y) / (side[-1].x - side[0].x)
        heights = sorted({p.y for p in piece.steiner}, reverse=True)
        self.rows = [sorted(p.x for p in piece.steiner if p.y == y) for y in heights]
        self.k = self.low / (len(heights) + 1)
        assert heights == [self.low - i * self.k for i in range(1, len(heights) + 1)]
        self.start = max((j for j, p in enumerate(side) if p.x <= reach * self.low), default=0)
        self.end = min((j for j, p in enumerate(side) if p.x >= length - reach * self.low), default=len(side) - 1)
        self.unit = min(self.k, SPACING)
        names = [*(f"u{j}" for j in range(len(side))), "A", "B",
                 *(f"{heights.index(p.y)},{self.rows[heights.index(p.y)].index(p.x)}" for p in piece.steiner)]
        points = [*side, A, Point(length, mpq(0)), *piece.steiner]
        self.least = min(height_squared(*(points[v if v >= 0 else len(side) + 1 - v] for v in face))
                         for face in piece.faces if min(face) < 0)
        self.faces = sorted(sorted(names[v if v >= 0 else len(side) + 1 - v] for v in face) for face in piece.faces)


def expected(it: Layers) -> Iterator[tuple[list[list[str]], list[list[Leaf]]]]:
    """Yield faces, and the cases one of which is to have all its hypotheses true."""
    u, rows, low, k = it.side, it.rows, it.low, it.k
    gaps = list(range(it.start, it.end))
    assert gaps and len(rows[0]) == len(gaps) and len(rows[-1]) == 1
    yield [[f"u{j}", f"u{j + 1}", "A"] for j in range(it.start)], []
    yield [[f"u{j}", f"u{j + 1}", "B"] for j in range(it.end, len(u) - 1)], []
    for i, j in enumerate(gaps):
        x, w = rows[0][i], u[j + 1].x - u[j].x
        d = u[j].y + it.slope * (x - u[j].x) - (low - k)
        yield [[f"u{j}", f"u{j + 1}", f"0,{i}"]], [[
            ("tooth", {"m": it.slope, "d": d, "W": w, "p": x - u[j].x}),
            ("tooth", {"m": -it.slope, "d": d, "W": w, "p": u[j + 1].x - x})]]
        if i:
            yield [[f"u{j}", f"0,{i - 1}", f"0,{i}"]], [[
                ("between", {"p": u[j].x - rows[0][i - 1], "q": x - u[j].x, "d": u[j].y - (low - k)})]]
    yield [[f"u{it.start}", "A", "0,0"]], [[end_case(u[it.start], rows[0][0], low - k)]]
    last, right = u[it.end], it.length
    yield [[f"u{it.end}", "B", f"0,{len(rows[0]) - 1}"]], [[
        end_case(Point(right - last.x, last.y), right - rows[0][-1], low - k)]]
    for r, (row, above) in enumerate(itertools.pairwise(rows)):
        high = low - (r + 2) * k
        assert len(above) == (len(row) + 1) // 2
        yield [["A", f"{r},0", f"{r + 1},0"]], [[("row", {"k": k, "e": high, "d": above[0] - row[0], "x": row[0]})]]
        yield [["B", f"{r},{len(row) - 1}", f"{r + 1},{len(above) - 1}"]], [[
            ("row", {"k": k, "e": high, "d": row[-1] - above[-1], "x": right - row[-1]})]]
        for i in range(len(row) // 2):
            x, y = row[2 * i], row[2 * i + 1]
            yield [[f"{r},{2 * i}", f"{r},{2 * i + 1}", f"{r + 1},{i}"]], [[
                ("tooth", {"m": mpq(0), "d": k, "W": y - x, "p": z}) for z in (above[i] - x, y - above[i])]]
        for i in range(2, len(row), 2):
            p, q, p_over, q_over = row[i - 1], row[i], above[i // 2 - 1], above[i // 2]
            v, w, vo, wo = f"{r},{i - 1}", f"{r},{i}", f"{r + 1},{i // 2 - 1}", f"{r + 1},{i // 2}"
            near = {"k": k, "d": q - p, "c": p - p_over, "b": q_over - q}
            far = {"k": k, "d": q - p, "c": q_over - q, "b": p - p_over}
            choices = [[v, w, vo], [w, wo, vo]], [[v, w, wo], [v, wo, vo]]
            made = [some for some in choices if all(sorted(face) in it.faces for face in some)]
            assert len(made) == 1
            yield made[0], [[("quad", near)], [("quad", far)]]
    yield [["A", "B", f"{len(rows) - 1},0"]], [[
        ("top", {"k": k, "x": x, "D": right}) for x in (rows[-1][0], right - rows[-1][0])]]


def end_case(v: Point, x: mpq, r: mpq) -> Leaf:
    if v.x >= 0:
        return "end-right.", {"x": v.x, "c": x - v.x, "r": r, "d": v.y - r}
    return "end-left.", {"x": -v.x, "p": x, "r": r, "d": v.y - r}


def holds(script: Any, leaf: Leaf, unit: mpq) -> bool:
    prefix, values = leaf
    values = {name: value if name == "m" else value / unit for name, value in values.items()}
    problems = [s for s in script.STATEMENTS if s.id.startswith(f"layers.{prefix}")]
    assert problems
    return all(given.holds(values) for problem in problems for given in problem.hypotheses)


def assert_covered(script: Any, it: Layers) -> set[str]:
    met = set()
    faces: list[list[str]] = []
    for made, choices in expected(it):
        faces += map(sorted, made)
        good = [leaves for leaves in choices if all(holds(script, leaf, it.unit) for leaf in leaves)]
        assert good or not choices, choices
        met |= {prefix for leaves in good for prefix, _ in leaves}
    assert sorted(faces) == it.faces and it.least >= (script.KEPT * it.unit) ** 2
    return met


def along_e(side: list[Point], length: mpq) -> Layers | None:
    """Return the layers of the Tube, None where fans take all."""
    frame = frame_of(side, A, Point(length, mpq(0)))
    below = layered_below(frame)
    return None if below is None else Layers(side, length, 1, frame.piece(below.faces, below.steiner))


def in_interior(side: list[Point], length: mpq) -> Layers:
    """Return the layers of the Interior."""
    frame = frame_of(side, A, Point(length, mpq(0)))
    trial = next(layered_trials(frame))
    return Layers(side, length, 2, frame.piece(trial.cycles, trial.steiner))


SMALL = (mpq(1198, 10000), mpq(1, 2), mpq(20))


@pytest.mark.parametrize("count", range(1, 6))
def test_all_patterns_of_few_gaps_in_the_tube(script: Any, count: int) -> None:
    source = random.Random(count)
    met: set[str] = set()
    patterns = list(itertools.product(SMALL, repeat=count)) * 9 if count < 5 else [
        tuple(source.choice(SMALL) for _ in range(source.randint(count, 40))) for _ in range(60)]
    for gaps in patterns[:300]:
        xs = [mpq(0), *itertools.accumulate(gaps)]
        first, last = (source.choice((-THICKNESS_MAX, mpq(-1, 10), mpq(0), mpq(1, 3), mpq(7), mpq(300)))
                       for _ in range(2))
        length = first + xs[-1] + last
        if length < 1:
            continue
        t, v = (source.choice((LEVEL, THICKNESS_MAX, mpq(1, 3))) for _ in range(2))
        if abs(v - t) * 2 > xs[-1]:
            v = t
        it = along_e([Point(first + x, t + (v - t) * x / xs[-1]) for x in xs], length)
        if it is not None:
            met |= assert_covered(script, it)
    assert met >= ({"tooth", "end-left.", "end-right.", "top"} | ({"between", "row", "quad"} if count > 3 else set()))


def test_strips_of_the_interior_at_random(script: Any) -> None:
    source, met, seen = random.Random(5), set[str](), 0
    while seen < 150:
        count = source.randint(1, 24)
        height = LEVEL * source.choice((1, 1, 2, 9))
        gaps = [source.choice((mpq(15, 100), mpq(1), mpq(source.randint(15, 4000), 100))) for _ in range(count)]
        xs = [mpq(0), *itertools.accumulate(gaps)]
        # T-vertices are 2 H at most beside the clean side, the ends of the T-side wherever.
        start = -xs[1] + source.choice((-2 * height, mpq(0), mpq(source.randint(0, 3000), 10)))
        side = [Point(start + x, height) for x in xs]
        length = side[-2].x + source.choice((-2 * height, mpq(0), mpq(source.randint(0, 3000), 10)))
        if length <= 4 * height or side[-1].x <= 2 * height or side[0].x >= length - 2 * height:
            continue
        it = in_interior(side, length)
        met |= assert_covered(script, it)
        seen += 1
    assert met == {"tooth", "between", "end-left.", "end-right.", "row", "quad", "top"}


def test_what_is_not_given_is_seen(script: Any) -> None:
    assert not holds(script, ("tooth", {"m": mpq(0), "d": mpq(1), "W": mpq(19, 10), "p": mpq(1)}), mpq(1))
    assert holds(script, ("tooth", {"m": mpq(0), "d": mpq(1), "W": mpq(2), "p": mpq(1)}), mpq(1))
    side = [Point(mpq(i), LEVEL) for i in range(1, 9)]
    it = along_e(side, mpq(9))
    assert it is not None
    it.faces = it.faces[1:]
    with pytest.raises(AssertionError):
        assert_covered(script, it)
