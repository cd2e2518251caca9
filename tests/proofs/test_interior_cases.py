"""The proof of the Interior against the steps: trapezoids of which nothing is known but the invariants it is given."""

import importlib
import random
from collections import Counter
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from constructions import point
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.constants import FEATURE_SQUARED, GAP, LEVEL, LEVEL_EDGE, SEPARATION, WEDGE_HEIGHTS
from exactmesh.steps.interior import triangulate_interior
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.patch_check import check_feature
from exactmesh.steps.records import Offset, Trapezoid, Trapezoidation

SIDES = ((1, 1), (1, -1), (-1, 1), (-1, -1))


@pytest.fixture
def interior(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(str(Path(exactmesh.__file__).parents[1] / "proofs_checks"))
    return importlib.import_module("repaired_interior")


class TestCases:
    def test_every_kind_of_trapezoid_has_its_lemmas(self, interior: Any) -> None:
        found = Counter(leaf for case in interior.cases() for leaf in interior.leaves(case))
        assert found == interior.LEAVES and len(found) == 15

    def test_differences_that_contradict_each_other(self, interior: Any) -> None:
        assert interior.possible([("a", "b", 1, False), ("b", "c", -2, False), ("c", "a", 1, False)])
        assert not interior.possible([("a", "b", 1, False), ("b", "c", -2, True), ("c", "a", 1, False)])
        assert not interior.possible([("a", "b", 0, True), ("b", "a", 0, False)])
        assert not interior.possible([("a", "a", 0, True)]) and interior.possible([])

    def test_without_the_rule_for_corners_there_is_no_lemma(self, interior: Any, monkeypatch: pytest.MonkeyPatch
                                                           ) -> None:
        of_wedge = interior.of_wedge

        def no_corners(case: Any, s: int, t: int) -> Any:
            bare = interior.Case(dict.fromkeys(case.vertex, False), case.apex, case.lean, case.wedge, case.left)
            return of_wedge(bare, s, t)

        monkeypatch.setattr(interior, "of_wedge", no_corners)
        with pytest.raises(AssertionError):
            Counter(leaf for case in interior.cases() for leaf in interior.leaves(case))

    def test_without_i5_there_is_no_lemma(self, interior: Any, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(interior, "has_vertex", lambda case, t: True)
        with pytest.raises(AssertionError):
            Counter(leaf for case in interior.cases() for leaf in interior.leaves(case))


class Model:
    """A trapezoid: `x[s, t]` the corners, `vertex[s, t]` which are vertices, `side[t]` the T-vertices."""

    def __init__(self, source: random.Random) -> None:
        self.source = source
        self.height = LEVEL * source.choice((1, 1, 1, 2, 3, 6))
        h, pick = self.height, source.choice
        lean = {s: self.about(h * pick((0, mpq(1, 10), mpq(1, 2), 1, 2, 3, 10, 60))) * pick((-1, 1)) for s in (1, -1)}
        left = mpq(0)
        width = self.about(pick((SEPARATION, GAP, h, 4 * h, 30 * h)))
        at = pick((1, -1))
        self.x = {(1, at): left, (-1, at): left + width, (1, -at): left + lean[1], (-1, -at): left + width + lean[-1]}
        self.vertex = {place: pick((True, False)) for place in SIDES}
        self.side: dict[int, list[mpq]] = {1: [], -1: []}
        if source.random() < 0.15:
            self.x[-1, -at] = self.x[1, -at]
        for t in (1, -1):
            if self.x[1, t] == self.x[-1, t]:
                self.vertex[1, t] = self.vertex[-1, t] = True
            elif source.random() < 0.75:
                self.side[t] = self.t_vertices(t)

    def about(self, value: mpq) -> mpq:
        """Return a number that is often the given one."""
        return mpq(value) * self.source.choice((1, 1, mpq(self.source.randint(1000, 2500), 1000)))

    def t_vertices(self, t: int) -> list[mpq]:
        """Return T-vertices for a side: as dense as may be, or with gaps, from where they may begin or a wedge ends."""
        pick, h = self.source.choice, self.height
        low, high = self.x[1, t], self.x[-1, t]
        x = pick((low + LEVEL_EDGE, low + GAP, low + SEPARATION, self.x[1, -t] - 2 * h, self.x[1, -t] - 3 * h,
                  self.x[-1, -t], self.x[-1, -t] + 2 * h, (low + high) / 2))
        found: list[mpq] = []
        for _ in range(pick((1, 1, 2, 3, 5, 12))):
            if low < x < high:
                found.append(x)
            x += GAP if self.source.random() < 0.7 else self.about(h)
        return found

    def corner(self, s: int, t: int) -> Point:
        """Return a corner."""
        return point(self.x[s, t], self.y(t))

    def y(self, t: int) -> mpq:
        """Return the height of a side."""
        return self.height if t > 0 else mpq(0)

    def edge(self, s: int) -> tuple[Point, Point]:
        """Return the edge of a leg, which goes on for a level where a corner is no vertex."""
        top, bottom = self.corner(s, 1), self.corner(s, -1)
        on = (top.x - bottom.x) * LEVEL / self.height
        return (bottom if self.vertex[s, -1] else point(bottom.x - on, bottom.y - LEVEL),
                top if self.vertex[s, 1] else point(top.x + on, top.y + LEVEL))

    def is_allowed(self) -> bool:
        """Return whether the invariants hold: I2, I4, I5 and that this is a trapezoid."""
        return all(self.is_allowed_on(t) for t in (1, -1)) and any(
            self.x[1, t] != self.x[-1, t] for t in (1, -1))

    def is_allowed_on(self, t: int) -> bool:
        """Return whether they hold on one side."""
        low, high = self.x[1, t], self.x[-1, t]
        if low > high or not (self.vertex[1, t] or self.vertex[-1, t] or self.side[t]):
            return False
        if low == high:
            return True
        for s in (1, -1):
            vertices = [point(x, self.y(t)) for x in self.side[t]]
            if self.vertex[-s, t]:
                vertices.append(self.corner(-s, t))
            if any(segment_distance_squared(v, *self.edge(s)) < SEPARATION**2 for v in vertices):
                return False
            if self.vertex[s, t] and self.side[t]:
                gap = abs(self.x[s, t] - self.side[t][0 if s > 0 else -1])
                # A short level edge is at a corner whose leg leans to its side.
                least = LEVEL_EDGE if s * (self.x[s, -t] - self.x[s, t]) >= 0 else GAP
                if gap < least:
                    return False
        # Two vertices on a level are apart as from edges.
        return high - low >= SEPARATION

    def made(self) -> tuple[Offset, Trapezoidation, list[Point]]:
        """Return the records of the one trapezoid."""
        names: dict[Point, int] = {}
        places = [self.corner(*place) for place in SIDES]
        t_vertices = [point(x, self.y(t)) for t in (1, -1) for x in self.side[t]]
        of_q = [*(p for p, place in zip(places, SIDES, strict=True) if self.vertex[place]), *t_vertices]
        ends = [p for p, place in zip(places, SIDES, strict=True) if not self.vertex[place]]
        for p in (*of_q, *ends):
            names.setdefault(p, len(names))
        first = len(set(of_q))
        tl, bl, tr, br = (names[p] for p in places)
        top, bottom = (tuple(names[point(x, self.y(t))] for x in self.side[t]) for t in (1, -1))
        z = Trapezoid(0, int(self.height / LEVEL), 0, 1, bl, br, tr, tl, bottom, top)
        offset = Offset(0, (), (), (), (), (), ())
        return offset, Trapezoidation(first, (), (), (z,)), list(names)


def models(seed: int, count: int) -> list[Model]:
    """Return random models that obey the invariants."""
    source = random.Random(seed)
    found: list[Model] = []
    while len(found) < count:
        model = Model(source)
        if model.is_allowed():
            found.append(model)
    return found


def line_distance_squared(p: Point, a: Point, b: Point) -> mpq:
    """Return the squared distance of p from the line of a and b."""
    return doubled_area(p, a, b) ** 2 / ((a.x - b.x) ** 2 + (a.y - b.y) ** 2)


def assert_as_the_proof_has_it(us: Sequence[Point], a: Point, b: Point) -> None:
    """What `pieces` is given of a piece."""
    reach = WEDGE_HEIGHTS * abs(a.y - us[0].y)
    gaps = [right.x - left.x for left, right in pairwise(us)]
    assert all(gap >= GAP for gap in gaps[1:-1])
    ends = ((us[0], us[1], a, b, 1), (us[-1], us[-2], b, a, -1))
    good = [abs(end.x - beside.x) >= GAP or line_distance_squared(beside, near, end) >= SEPARATION**2
            for end, beside, near, _, _ in ends]
    # A single gap is at the end that has a leg.
    assert all(good) or (len(us) == 2 and any(good))
    assert all(s * (near.x - beside.x) <= reach for _, beside, near, _, s in ends)
    if a != b and b.x - a.x < GAP:
        off = [line_distance_squared(far, near, end) >= SEPARATION**2 for end, _, near, far, _ in ends]
        outwards = us[0].x <= a.x and us[-1].x >= b.x and b.x - a.x >= SEPARATION
        assert any(off) or outwards


@pytest.mark.parametrize("seed", range(6))
def test_what_obeys_the_invariants_keeps_a_fifth_of_a_level(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = Counter[str]()
    add = PatchBuilder.add_one_sided

    def watched(mesh: PatchBuilder, t_side: Sequence[int], a: int, b: int) -> None:
        if len(t_side) > 1:
            assert_as_the_proof_has_it([mesh.points[v] for v in t_side], mesh.points[a], mesh.points[b])
            seen["pieces"] += 1
        add(mesh, t_side, a, b)

    monkeypatch.setattr(PatchBuilder, "add_one_sided", watched)
    for model in models(seed, 150):
        offset, trapezoidation, points = model.made()
        patch = triangulate_interior(offset, trapezoidation, points)
        verdict = check_feature(patch, [*points, *patch.points])
        assert verdict.holds and verdict.worst is not None and verdict.worst >= FEATURE_SQUARED, vars(model)
        seen["feet"] += bool(patch.on_edge)
        seen["clean"] += not (model.side[1] or model.side[-1])
    assert min(seen[name] for name in ("pieces", "feet", "clean")) > 5
