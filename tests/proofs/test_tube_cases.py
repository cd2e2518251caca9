"""The split into cases of `repaired.tube-feature`: every face that the steps emit has a case of the script, and the
hypotheses of its problems are true of it.

Quadrilaterals lie as in the script: e from A = (0,0) to B = (L,0), e' above it. All groupings of few apexes are made on
purpose; widths, slopes and places of the ends are random, often at their bounds.
"""

import importlib
import itertools
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from constructions import face_feature_squared
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry.point import Point
from exactmesh.geometry.predicates import doubled_area
from exactmesh.steps.constants import FEATURE, LEVEL, LEVEL_EDGE, THICKNESS_MAX
from exactmesh.steps.frame import Frame, frame_of
from exactmesh.steps.nested import nested_below
from exactmesh.steps.one_sided import _centred, triangulate_one_sided
from exactmesh.steps.records import Piece

SCRIPTS = Path(exactmesh.__file__).parents[1] / "proofs_checks"
G, T = LEVEL, THICKNESS_MAX
# A case: the beginnings of the ids of its problems, with values for their variables.
Leaf = tuple[str, dict[str, mpq]]


@pytest.fixture(scope="module")
def statements() -> Iterator[list[Any]]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(SCRIPTS))
        yield importlib.import_module("repaired_tube").STATEMENTS


class Strip(NamedTuple):
    """e' as its vertices, and the length of e."""

    side: tuple[Point, ...]
    length: mpq

    @property
    def low(self) -> mpq:
        return min(self.side[0].y, self.side[-1].y)

    @property
    def slope(self) -> mpq:
        first, last = self.side[0], self.side[-1]
        return (last.y - first.y) / (last.x - first.x)

    def frame(self) -> Frame:
        return frame_of(self.side, Point(mpq(0), mpq(0)), Point(self.length, mpq(0)))

    def mirrored(self) -> "Strip":
        return Strip(tuple(Point(self.length - v.x, v.y) for v in reversed(self.side)), self.length)

    def is_lawful(self, steepest: mpq = mpq(1, 2)) -> bool:
        """Return whether the ends are where `PLACES` says, and the slope is no steeper."""
        return abs(self.slope) <= steepest and all(
            first.x >= -T and last.x > 0 and last.x**2 + last.y**2 >= (1 - T)**2 and G <= first.y <= T
            and (first.x >= 0 or first.x**2 + first.y**2 <= T**2)
            for strip in (self, self.mirrored()) for first, last in [(strip.side[0], strip.side[-1])])


def name(strip: Strip, v: int) -> str:
    m = len(strip.side) - 1
    return "apex" if v < 0 else "A" if v == m + 1 else "B" if v == m + 2 else "v"


def leaves(strip: Strip, piece: Piece) -> Iterator[list[Leaf]]:
    """Yield the cases of each face; a face at B is looked at in the mirror."""
    m = len(strip.side) - 1
    mirror = {m + 1: m + 2, m + 2: m + 1, **{j: m - j for j in range(m + 1)}}
    flipped = strip.mirrored()
    for face in piece.faces:
        found = list(cases(strip, face, piece.steiner))
        if not found:
            found = list(cases(flipped, tuple(mirror.get(v, v) for v in reversed(face)), tuple(
                Point(strip.length - v.x, v.y) for v in piece.steiner)))
        yield found


def cases(strip: Strip, face: tuple[int, ...], steiner: tuple[Point, ...]) -> Iterator[Leaf]:
    """Yield the problems about a face, as one that has A rather than B."""
    h, s = strip.low, strip.slope
    places = [*strip.side, Point(mpq(0), mpq(0)), Point(strip.length, mpq(0))]
    at = {v: places[v] if v >= 0 else steiner[-1 - v] for v in face}
    kinds = [name(strip, v) for v in face]
    vs, apexes = [v for v in face if v in range(len(strip.side))], [v for v in face if v < 0]
    match sorted(kinds):
        case ["A", "B", "v"]:
            yield "split", {"L": strip.length, "x": at[vs[0]].x, "y": at[vs[0]].y}
        case ["A", "v", "v"]:
            v, w = sorted(at[i] for i in vs)
            c = v.y - s * v.x
            if v.x >= 0:
                yield "fan-right", {"h": h, "x": v.x, "y": v.y, "s": s}
            else:
                assert strip.side[-1].x > 0 and c >= h
                assert strip.side[-1].x > 0
                yield "fan-over", {"h": h, "c": c}
            values = {"h": h, "s": s, "c": c, "q": w.x - v.x}
            yield "fan-apex", values
            for end in (v, w):
                yield "fan-ahead" if end.x >= 0 else "fan-behind", {**values, "x": end.x, "y": end.y}
        case ["apex", "v", "v"]:
            v, w = sorted(at[i] for i in vs)
            apex = at[apexes[0]]
            d = v.y + s * (apex.x - v.x) - apex.y
            yield "low-depth", {"h": h, "y": apex.y + d, "r": apex.y, "s": s}
            yield "low-tooth-apex", {"s": s, "d": d}
            yield "low-tooth-side", {"q": w.x - v.x, "s": s, "d": d, "p": apex.x - v.x}
            yield "low-tooth-side", {"q": w.x - v.x, "s": -s, "d": d, "p": w.x - apex.x}
        case ["apex", "apex", "v"]:
            (v,), (left, right) = (at[i] for i in vs), sorted(at[i] for i in apexes)
            p, q = v.x - left.x, right.x - v.x
            d, r = v.y - s * p - left.y, v.y + s * q - right.y
            there, back = {"p": p, "q": q, "s": s, "d": d, "r": r}, {"p": q, "q": p, "s": -s, "d": r, "r": d}
            yield "low-between-side", there
            yield "low-between-side", back
            yield "low-between-above", there if d >= r else back
        case ["A", "apex", "v"]:
            (v,), (apex,) = (at[i] for i in vs), (at[i] for i in apexes)
            values = {"h": h, "x": v.x, "y": v.y, "p": apex.x, "r": apex.y}
            yield "low-end-right." if v.x >= 0 else "low-end-left.", values
        case ["A", "B", *rest] if rest and set(rest) == {"apex"}:
            yield from top(strip, h, [at[i] for i in apexes])
        case ["A", "apex", "apex", *rest] if not rest or set(rest) == {"apex"}:
            yield from long(strip, h, [at[i] for i in apexes])


def leaders(strip: Strip, h: mpq) -> dict[str, mpq]:
    """Return the height of leaders, and T, in units of h."""
    return {"T": FEATURE / h, "c": mpq(4, 5) - strip.slope**2 / 10}


def top(strip: Strip, h: mpq, apexes: list[Point]) -> Iterator[Leaf]:
    z = max(apexes, key=lambda v: v.y)
    values = {**leaders(strip, h), "e": z.x / h, "D": strip.length / h}
    assert z.y == values["c"] * h
    yield "low-top.", values
    for member in apexes:
        if member != z:
            beside = member if member.x < z.x else Point(strip.length - member.x, member.y)
            middle = z if member.x < z.x else Point(strip.length - z.x, z.y)
            y = beside.x / middle.x
            assert beside.y == y * middle.y
            yield "low-top-below", {**values, "y": y}
            yield "low-top-member", {**values, "e": middle.x / h, "y": y}


def long(strip: Strip, h: mpq, apexes: list[Point]) -> Iterator[Leaf]:
    # The apex farthest out is on A-F, F not before it; E is the next.
    *group, leader, apex = sorted(apexes)
    values = leaders(strip, h)
    assert leader.y == values["c"] * h
    f = apex.x / apex.y * leader.y
    e, d = leader.x / h, (f - leader.x) / h
    values |= {"e": e, "D": d, "x": apex.x / f}
    yield "low-long", values
    if e + d <= 1:
        yield "low-ratio-near", values
    yield "low-ratio-sum", values
    slope = abs(strip.slope)
    yield "low-sunk", {**values, "s": slope, "h": h}
    for member in group:
        y = member.x / leader.x
        assert member.y == y * leader.y
        # The rule of the groups, which is no problem: h/5 from the line A-F.
        assert (member.x * apex.y - member.y * apex.x)**2 * 25 >= h * h * (apex.x**2 + apex.y**2)
        aside = {**values, "v": 1 - y, "w": 1 - values["x"], "G": (apex.x - leader.x) / h}
        yield "low-member-end", aside
        if values["c"]**2 * aside["w"] >= e * aside["G"]:
            yield "low-member-foot", aside
            yield "low-member-apex", aside


def chosen(strip: Strip) -> Piece:
    """Return what the proof takes: a split when a fan takes all of e', else what is nested along e."""
    frame, m = strip.frame(), len(strip.side) - 1
    below = nested_below(frame)
    if below is None:
        at = m if strip.side[-1].x <= strip.low else 0
        assert at or strip.side[0].x >= strip.length - strip.low
        return Piece((*((j + 1, j, m + 1 if j < at else m + 2) for j in range(m)), (m + 2, at, m + 1)))
    return frame.piece(below.faces, below.steiner)


def assert_covered(strip: Strip, statements: list[Any], met: set[str]) -> None:
    assert strip.is_lawful()
    for found in leaves(strip, chosen(strip)):
        assert found
        for prefix, values in found:
            problems = [s for s in statements if s.id.startswith(f"slanted.{prefix}")]
            assert problems
            for problem in problems:
                # The parts of a distance by where the foot is exclude each other.
                where = {"before": 1, "beyond": 1, "between": 2}.get(problem.id.rpartition(".")[2], 0)
                for given in problem.hypotheses[: len(problem.hypotheses) - where]:
                    assert given.holds(values), (problem.id, str(given), values)
            met.add(prefix)


ROLES = {"split", "fan-right", "fan-over", "fan-apex", "fan-ahead", "fan-behind", "low-depth", "low-tooth-apex",
         "low-tooth-side", "low-between-side", "low-between-above", "low-end-right.", "low-end-left.", "low-top.",
         "low-top-below", "low-top-member", "low-long", "low-ratio-sum", "low-sunk", "low-member-end"}
# What no strip at random has: a member whose foot is between E and the apex, a leader within h of A below another.
RARE = {"low-member-foot", "low-member-apex", "low-ratio-near"}
PATTERNS = [pattern for count in range(4) for pattern in itertools.product((False, True), repeat=count)]


def grouped(left: tuple[bool, ...], right: tuple[bool, ...], fan: int) -> Strip:
    """Return a strip whose apexes beside the middle one, z, are in given groups: True begins a new one. `fan` more
    vertices lie near either end of e."""
    def side(pattern: tuple[bool, ...], reach: mpq) -> list[mpq]:
        x, found = reach, []
        for is_new in pattern:
            x = x / 3 if is_new else x * mpq(9, 10)
            found.append(x)
        return found
    h, reach = mpq(1, 4), mpq(400)
    # Where gaps are wide an apex is h/2 from the end of its gap that is nearer to z.
    xs = [*(x + h / 2 for x in reversed(side(left, reach))), reach - 2, reach + 2,
          *(2 * reach - x - h / 2 for x in side(right, reach))]
    near = [mpq(k, 8) - mpq(1, 8) for k in range(fan)]
    xs = [mpq(-1, 4), *near, *xs, *(2 * reach - x for x in reversed(near)), 2 * reach + mpq(1, 4)]
    return Strip(tuple(Point(x, h + x / 8000) for x in xs), 2 * reach)


@pytest.mark.parametrize("fan", range(3))
def test_all_groupings_of_few_apexes_have_their_cases(statements: list[Any], fan: int) -> None:
    met: set[str] = set()
    groupings = set()
    for left, right in itertools.product(PATTERNS, repeat=2):
        strip = grouped(left, right, fan)
        assert_covered(strip, statements, met)
        piece = chosen(strip)
        groupings.add((len(piece.steiner), tuple(sorted(sum(v < 0 for v in face) for face in piece.faces))))
    by_place = {"split", "fan-right", "fan-over", "fan-apex", "fan-ahead", "fan-behind", "low-end-right.",
                "low-end-left."}
    assert len(groupings) > 40 and met >= ROLES - by_place


def random_strip(source: random.Random) -> Strip | None:
    """Return a strip that is within the bounds, often at them, or None."""
    def value(low: mpq, high: mpq) -> mpq:
        return source.choice((low, high, low + (high - low) * mpq(source.randint(0, 1000), 1000)))
    count = source.choice((2, 2, 3, 4, 6, 12))
    gaps = [mpq(1198, 10000) * source.choice((mpq(1), mpq(source.randint(10, 30), 10),
                                              mpq(10) ** source.randint(0, source.choice((0, 1, 3)))))
            for _ in range(count)]
    start = source.choice((value(-T, mpq(3, 5)), mpq(source.randint(0, 4000), 10)))
    xs = [start, *(start + x for x in itertools.accumulate(gaps))]
    t, u = value(G, T), value(G, T)
    length = max(mpq(1), xs[-1] + source.choice((-T, value(-T, T), mpq(source.randint(1, 500), 10))),
                 start + source.choice((mpq(53, 100), mpq(1))))
    strip = Strip(tuple(Point(x, t + (u - t) * (x - start) / (xs[-1] - start)) for x in xs), length)
    return strip if strip.is_lawful() else None


def test_strips_at_random_have_their_cases(statements: list[Any]) -> None:
    source, met, seen = random.Random(2026), set[str](), 0
    while seen < 400:
        if (strip := random_strip(source)) is not None:
            seen += 1
            assert_covered(strip, statements, met)
            piece = triangulate_one_sided(strip.side, Point(mpq(0), mpq(0)), Point(strip.length, mpq(0)))
            assert value_of(strip, piece) >= FEATURE**2
    assert met - RARE == ROLES


def value_of(strip: Strip, piece: Piece) -> mpq:
    """Return the squared feature size of a triangulation."""
    points = [*strip.side, Point(mpq(0), mpq(0)), Point(strip.length, mpq(0)), *piece.steiner]
    count = len(strip.side) + 2
    return min(face_feature_squared(points, tuple(v if v >= 0 else count - 1 - v for v in face))
               for face in piece.faces)


F = FEATURE


def one_gap(strip: Strip) -> Iterator[tuple[tuple[int, int, int], list[Leaf]]]:
    """Yield the triangles over an e' without vertices that rises, and their cases: D, C, B, A, z are 0, 1, 2, 3, 4."""
    (a, t), (b, u) = strip.side
    d, r, length = b - a, u - t, strip.length
    x, right = length - a, length - b
    clean = {"X": x, "d": d, "r": r, "t": t}
    if r >= F or (100 * d <= mpq(535, 100) and x <= 2):
        names = ["one-near."]
        if r >= F:
            names = ["one-slanted.", "one-slanted-back" if d >= x else "one-slanted-bc-",
                     "one-slanted-bd-"]
            names = [name + ("wide" if d >= F else "steep") if name[-1] == "-" else name for name in names]
            if d <= F:
                names += [name.replace("steep", "far") for name in names if "steep" in name]
        yield (2, 1, 0), [(name, clean) for name in names]
        yield (3, 2, 0), [("split", {"L": length, "x": a, "y": t})]
        return
    z = centre_of(strip)
    below = ("one-below.", {"L": length, "x": z.x, "y": z.y})
    yield (3, 2, 4), [below]
    if 100 * d <= mpq(535, 100):
        # Bounds instead of roots: the length of e' and of the way to z are only compared with bounds.
        k = (2 * t + r) / (4 * d)
        assert z == Point((a + b) / 2 + r * k, (t + u) / 2 - d * k)
        assert k * k * (d * d + r * r) >= (G / 2)**2 and d * d + r * r >= LEVEL_EDGE**2
        shifted = {**clean, "x": r * k, "a": a}
        yield (4, 1, 0), [("one-shift", {**clean, "k": k})]
        yield (3, 4, 0), [("one-far-right", shifted)]
        yield (4, 2, 1), [("one-far-b.", shifted)]
        return
    yield (4, 1, 0), [("one-above.", clean)]
    yield (3, 4, 0), [("one-right" if a >= 0 else "one-left", {**clean, "a": a})]
    yield (4, 2, 1), [("one-right" if right >= 0 else "one-left", {"d": d, "r": -r, "t": u, "a": right})]


def centre_of(strip: Strip) -> Point:
    """Return z: half way to e at a right angle to e' where that is short, else straight down."""
    (a, t), (b, u) = strip.side
    if b - a > mpq(535, 10000):
        return Point((a + b) / 2, 3 * (t + u) / 20)
    share = (t + u) / 4 / (b - a)
    return Point((a + b) / 2 + share * (u - t), (t + u) / 4)


def random_gap(source: random.Random) -> Strip | None:
    """Return a strip without vertices on e', which rises, or None."""
    t = mpq(source.choice((2320, 4237, source.randint(2320, 4701))), 10000)
    u = t + mpq(source.choice((0, 440, 464, 600, source.randint(0, 2381))), 10000)
    start = source.choice((-T, mpq(source.randint(-470, 600), 1000), mpq(source.randint(0, 4000), 10)))
    width = source.choice((mpq(52, 1000), mpq(source.randint(20, 70), 1000), mpq(source.randint(20, 600), 1000),
                           mpq(source.randint(1, 50))))
    end = start + width
    length = max(mpq(1), end + source.choice((-T, mpq(source.randint(-470, 600), 1000), mpq(source.randint(1, 500)))),
                 start + mpq(source.randint(25, 60), 100))
    strip = Strip((Point(start, t), Point(end, u)), length)
    far = width**2 + (u - t)**2 >= LEVEL_EDGE**2
    return strip if far and strip.is_lawful(mpq(338, 100)) else None


def test_one_gap_is_a_diagonal_or_a_star(statements: list[Any]) -> None:
    source, met, seen = random.Random(7), set[str](), 0
    while seen < 1000:
        if (strip := random_gap(source)) is None:
            continue
        seen += 1
        outline = [*strip.side, Point(strip.length, mpq(0)), Point(mpq(0), mpq(0))]
        z = centre_of(strip)
        triangles = set()
        for triangle, leaves_of in one_gap(strip):
            triangles.add(triangle)
            for prefix, values in leaves_of:
                met.add(prefix)
                problems = [s for s in statements if s.id.startswith(f"slanted.{prefix}")]
                assert problems
                for problem in problems:
                    assert all(given.holds(values) for given in problem.hypotheses), (problem.id, values)
        areas = [doubled_area(*((*outline, z)[v] for v in triangle)) for triangle in triangles]
        whole = doubled_area(*outline[2::-1]) + doubled_area(outline[3], outline[2], outline[0])
        assert min(areas) > 0 and sum(areas) == whole
        if any(4 in triangle for triangle in triangles):
            assert z in stars(strip)
        assert value_of(strip, triangulate_one_sided(strip.side, outline[3], outline[2])) >= FEATURE**2
    assert met == {
        "one-slanted.", "one-slanted-back", "one-slanted-bc-wide", "one-slanted-bc-steep", "one-slanted-bc-far",
        "one-slanted-bd-wide", "one-slanted-bd-steep", "one-slanted-bd-far", "split", "one-near.", "one-shift",
        "one-far-right", "one-far-b.", "one-above.", "one-right", "one-left", "one-below."}


def stars(strip: Strip) -> list[Point]:
    """Return the places at which the step puts a vertex that is joined to all."""
    frame = strip.frame()
    return [place for candidate in _centred(frame) for place in frame.piece((), candidate.steiner).steiner]
