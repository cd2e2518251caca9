"""check.py in detail: the command line, limits to the unit, what a place is called, and the geometry by itself."""

import copy
import hashlib
import io
import itertools
import json
import random
import sys
from array import array
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from checkers import by_python
from triples import BASES, Triple, base

from exactmesh import check

# --- the command line ---


@pytest.fixture
def paths(tmp_path: Path) -> list[str]:
    """Return the paths of a valid triple."""
    found = []
    for name, data in zip(("pslg", "mesh", "certificate"), base("square").files(), strict=True):
        (tmp_path / name).write_bytes(data)
        found.append(str(tmp_path / name))
    return found


def refused_usage(args: Sequence[str], capsys: pytest.CaptureFixture[str]) -> str:
    """Return what is written on standard error about arguments that are refused."""
    with pytest.raises(SystemExit) as caught:
        check.main(args)
    assert caught.value.code == 2
    return capsys.readouterr().err


def test_one_line_and_the_status(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert check.main(paths) == 0
    t = base("square").certificate
    assert capsys.readouterr() == (
        f"VALID nonproper mesh: mfs_squared >= {t['mfs_squared_at_least']} (mfs >= {t['mfs_at_least']}), "
        f"degradation_squared <= {t['degradation_squared_at_most']} (degradation <= {t['degradation_at_most']})\n", "")
    assert check.main([paths[1], paths[0], paths[2]]) == 1
    assert capsys.readouterr() == ('INVALID format: PSLG: byte 11: "exactmesh-pslg/1" expected\n', "")
    assert check.main([paths[0], paths[0], paths[2]]) == 1
    assert capsys.readouterr() == ('INVALID format: MESH: byte 11: "exactmesh-mesh/1" expected\n', "")
    assert check.main([paths[0], paths[1], paths[1]]) == 1
    assert capsys.readouterr() == ('INVALID format: CERTIFICATE: byte 11: "exactmesh-certificate/1" expected\n', "")


def test_arguments_come_from_the_command_line(paths: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["check.py", *paths])
    assert check.main() == 0


def test_each_limit_is_that_of_its_option(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    size = Path(paths[0]).stat().st_size
    for option, line in ((f"--max-bytes={size - 1}", f"size: PSLG: more than {size - 1} bytes"),
                         ("--max-items=7", "size: PSLG: more than 7 items"),
                         ("--max-digits=0", "size: PSLG: byte 11: too long")):
        assert check.main([*paths, option]) == 1
        assert capsys.readouterr().out == f"INVALID {line}\n"


def test_a_limit_is_a_number_of_nine_digits_at_most(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    for option in ("bytes", "digits", "items"):
        assert check.main([*paths, f"--max-{option}", "999999999"]) == 0
        for text in ("1234567890", "-1", "1x", "x", ""):
            assert f"{text!r} is not a number of at most nine digits" in refused_usage(
                [*paths, f"--max-{option}={text}"], capsys)


def test_what_cannot_be_read_is_named(paths: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    for place in range(3):
        for path in (str(Path(paths[0]).parent), "missing", "a\0b"):
            assert check.main([*paths[:place], path, *paths[place + 1 :]]) == 2
            out, err = capsys.readouterr()
            assert out == "" and err.startswith("check: ") and err.count("\n") == 1
            assert path in err or "null" in err
    assert "the following arguments are required: CERTIFICATE" in refused_usage(paths[:2], capsys)


@pytest.mark.parametrize("error, status, line", [
    (MemoryError(), 2, "check: out of memory"), (KeyboardInterrupt(), 130, "check: interrupted")])
def test_trouble_is_one_line(error: BaseException, status: int, line: str, paths: list[str],
                             capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*args: object) -> tuple[bool, str]:
        raise error

    monkeypatch.setattr(check, "check", fails)
    assert check.main(paths) == status
    assert capsys.readouterr() == ("", f"{line}\n")


def test_the_verdict_is_out_before_the_program_ends(paths: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    class Full:
        """A standard output that takes nothing."""

        def write(self, text: str) -> int:
            return len(text)

        def flush(self) -> None:
            raise OSError("no space")

    monkeypatch.setattr(sys, "stdout", Full())
    assert check.main(paths) == 2


def test_help_says_what_is_needed(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", "200")
    with pytest.raises(SystemExit):
        check.main(["--help"])
    lines = [" ".join(line.split()) for line in capsys.readouterr().out.splitlines()]
    assert lines[0].endswith("[--max-bytes N] [--max-digits N] [--max-items N] PSLG MESH CERTIFICATE")
    assert {"Check a mesh and its certificate. Exit status: 0 valid, 1 invalid, 2 usage or unreadable file.",
            "PSLG exactmesh-pslg/1", "MESH exactmesh-mesh/1", "CERTIFICATE exactmesh-certificate/1",
            "--max-bytes N refuse a file with more bytes (default: 268435456)",
            "--max-digits N refuse a file with more digits (default: 4000)",
            "--max-items N refuse a file with more items (default: 20000000)"} <= set(lines)


# --- geometry, against fractions ---

Place = tuple[Fraction, Fraction]


def place(p: check.Point) -> Place:
    return Fraction(p[0], p[2]), Fraction(p[1], p[2])


def squared(t: Place, a: Place, b: Place) -> Fraction:
    """Return the squared distance of t from the segment a b: the nearest of its ends and the foot on its line."""
    step = b[0] - a[0], b[1] - a[1]
    length = step[0] ** 2 + step[1] ** 2
    along = ((t[0] - a[0]) * step[0] + (t[1] - a[1]) * step[1]) / length if length else Fraction(0)
    part = min(max(along, Fraction(0)), Fraction(1))
    return (a[0] + part * step[0] - t[0]) ** 2 + (a[1] + part * step[1] - t[1]) ** 2


GRID: list[check.Point] = [(x, y, 1) for x in range(-1, 3) for y in range(-1, 3)]
POINTS: list[check.Point] = [*GRID[::3], (1, 2, 3), (-5, 1, 2), (3, 3, 4), (1, 0, 2)]


def test_distances_are_those_of_segments() -> None:
    for t, a, b in itertools.product(POINTS, repeat=3):
        p, q = check.distance_squared(t, a, b)
        assert q > 0 and Fraction(p, q) == squared(place(t), place(a), place(b)), (t, a, b)


def test_turns_and_differences_have_the_signs_of_the_fractions() -> None:
    for a, b, c in itertools.product(POINTS, repeat=3):
        (ax, ay), (bx, by), (cx, cy) = map(place, (a, b, c))
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        assert check.turn(a, b, c) == area * a[2] * b[2] * c[2]
        assert check.minus(a, b) == ((ax - bx) * a[2] * b[2], (ay - by) * a[2] * b[2])


def test_a_point_over_one_denominator_is_the_point() -> None:
    for p, q, r, s in itertools.product((-3, 0, 2), (1, 4, 6), (-5, 0, 1), (1, 2, 6, 7)):
        found = check.point_of((p, q), (r, s))
        assert place(found) == (Fraction(p, q), Fraction(r, s)) and found[2] == q * s // check.gcd(q, s)


def sided(*places: tuple[int, int]) -> list[check.Point]:
    return [(x, y, 1) for x, y in places]


@pytest.mark.parametrize("cycle, corners", [
    (sided((0, 0), (1, 0), (0, 1)), [0, 1, 2]),
    (sided((0, 0), (0, 1), (1, 0)), []),
    (sided((0, 0), (1, 0), (2, 0)), []),
    (sided((0, 0), (1, 0), (2, 0), (0, 1)), [0, 2, 3]),
    (sided((1, 0), (2, 0), (0, 1), (0, 0)), [1, 2, 3]),
    (sided((0, 0), (2, 0), (1, 1), (0, 2), (0, 1)), [0, 1, 3]),
    (sided((0, 0), (1, 0), (1, 1), (0, 1)), []),  # four corners
    (sided((0, 0), (1, 0), (1, 0), (0, 1)), []),  # stands still
    (sided((0, 0), (1, 0), (1, 0), (2, 0), (0, 2)), []),
    (sided((0, 0), (2, 0), (1, 0), (0, 2)), []),  # turns back
    (sided((0, 0), (2, 0), (3, 0), (1, 0), (0, 2)), []),
    (sided((0, 0), (4, 0), (1, 1), (0, 4)), []),  # turns right
    (sided((0, 0), (1, 0), (2, 0), (1, 0)), []),
    (sided((0, 0), (3, 0), (0, 3), (0, 0), (3, 0), (0, 3)), [])])  # twice around
def test_a_face_has_three_left_turns_and_goes_straight_on_elsewhere(cycle: list[check.Point],
                                                                    corners: list[int]) -> None:
    assert check.corners_of(cycle) == corners


def room(cycle: Sequence[int], at: Sequence[check.Point], corners: Sequence[int], watched: int) -> Fraction | None:
    """Return the least squared distance that the clause `feature` looks at, by its words."""
    found = []
    places, count = [place(p) for p in at], len(at)
    for n, v in enumerate(cycle):
        if v < watched:
            for first, last in zip(corners, [*corners[1:], corners[0]], strict=True):
                side = [(first + k) % count for k in range((last - first) % count + 1)]
                if n not in side:
                    found.append(squared(places[n], places[first], places[last]))
            if count > 3:
                found += [squared(places[n], places[m], places[m]) for m in ((n - 1) % count, (n + 1) % count)]
    return min(found, default=None)


FACES = [
    sided((0, 0), (3, 0), (0, 2)), sided((0, 0), (1, 0), (3, 0), (0, 2)), sided((1, 0), (3, 0), (0, 2), (0, 0)),
    sided((0, 0), (3, 0), (0, 3), (0, 1)), sided((0, 0), (9, 0), (3, 6), (1, 8), (0, 9)),
    sided((0, 0), (2, 0), (6, 0), (4, 2), (0, 6), (0, 5), (0, 3)), sided((-9, 0), (9, 0), (4, 5), (0, 9)),
    sided((-8, 1), (-9, 0), (0, 0), (9, 0), (8, 1), (0, 9))]


@pytest.mark.parametrize("shape", range(len(FACES)))
def test_room_is_what_the_clause_says(shape: int) -> None:
    source = random.Random(shape)
    at = FACES[shape]
    count = len(at)
    for _ in range(60):
        turned = source.randrange(count)
        points = at[turned:] + at[:turned]
        cycle = source.sample(range(count + 2), count)
        corners = check.corners_of(points)
        assert len(corners) == 3
        for watched in range(count + 3):
            least = room(cycle, points, corners, watched)
            for bound in {Fraction(1, 9), least or Fraction(1), (least or 1) + Fraction(1, 10**9), Fraction(1000)}:
                fits = least is None or least >= bound
                assert check.has_room(cycle, points, corners, watched, bound.as_integer_ratio()) == fits


# --- the clauses that are about indices only, against their words ---


def a_checker(given: int, watched: int, extra: int, meshed: Sequence[Sequence[int]], rest: Sequence[Sequence[int]],
              edges: Sequence[Sequence[int]] = ()) -> check.Checker:
    """Return a checker of so many vertices, all at one place."""
    def cycles(rows: Sequence[Sequence[int]]) -> check.Cycles:
        return check.Cycles(array("q", [v for row in rows for v in row]),
                            array("q", [0, *itertools.accumulate(map(len, rows))]))

    one = check.Claim((1, 1), "1")
    points: list[check.Point] = [(0, 0, 1)]
    return check.Checker(
        check.Pslg(None, points * given, cycles(edges), [], "", ""),
        check.Mesh(None, "nonproper", points * watched, cycles(meshed), ""),
        check.Certificate(None, "", "", one, one, one, one, one, array("q"), array("q"), points * extra, cycles(rest),
                          ""))


def directed(rows: Sequence[Sequence[int]]) -> list[tuple[int, int]]:
    return [(row[k - 1], row[k]) for row in rows for k in range(len(row))]


def tiling_fault(watched: int, rows: Sequence[Sequence[int]]) -> str:
    """Return what `overlap` and `boundary` say, pair by pair of vertices."""
    times = Counter(directed(rows))
    for u, v in sorted({(min(edge), max(edge)) for edge in times}):
        there, back = times[u, v], times[v, u]
        if max(there, back) > 1:
            return f"overlap: edge {[u, v] if there else [v, u]}"
        if there + back == 1:
            a, b = (u, v) if there else (v, u)
            if (a - watched, b - watched) not in ((0, 1), (1, 2), (2, 3), (3, 0)):
                return f"boundary: edge {[a, b]}"
    return ""


def refusal(clause: Callable[[], object]) -> str:
    """Return how a clause refuses, "" when it does not."""
    try:
        clause()
    except check.Refused as refused:
        return str(refused)
    return ""


def some_rows(source: random.Random, size: int) -> list[list[int]]:
    return [source.sample(range(size), source.choice((3, 3, 3, 4))) for _ in range(source.randrange(1, 5))]


def boxes() -> Iterator[tuple[int, list[list[int]], list[list[int]]]]:
    """Yield vertices of the mesh and faces of mesh and rest, most of which are almost tilings of a box."""
    inner = [[0, 1, 2]]
    rest = [[3, 4, 0], [4, 1, 0], [4, 5, 1], [5, 2, 1], [5, 6, 2], [6, 0, 2], [6, 3, 0]]
    yield 3, inner, rest
    for k in range(len(rest)):
        yield 3, inner, rest[:k] + rest[k + 1 :]
        yield 3, inner, [*rest, rest[k]]
        yield 3, inner, [*rest, rest[k][::-1]]
        yield 3, [*inner, rest[k]], rest
        for u, v in itertools.combinations(range(8), 2):
            yield 3, inner, [[{u: v, v: u}.get(w, w) for w in row] if n == k else row for n, row in enumerate(rest)]
    source = random.Random(6)
    for _ in range(1500):
        size = source.choice((5, 6, 8))
        yield source.choice((0, 1, 2)), some_rows(source, size), some_rows(source, size)


def test_overlap_and_boundary_are_found_at_the_first_pair_of_vertices() -> None:
    seen: Counter[str] = Counter()
    for watched, meshed, rest in boxes():
        checker = a_checker(0, watched, 8, meshed, rest)
        expected = tiling_fault(watched, [*meshed, *rest])
        seen[expected.split(":")[0]] += 1
        assert refusal(checker.check_tiling) == expected
        if not expected:
            edges = [(checker.origin[h], checker.target(h)) for h in range(len(checker.origin))]
            for h, (u, v) in enumerate(edges):
                assert checker.twin[h] == (edges.index((v, u)) if (v, u) in edges else -1)
                row = [*meshed, *rest][checker.face_of[h]]
                assert (u, v) in directed([row])
            assert sorted(edges[h] for h in checker.sides) == [
                (watched + k, watched + (k + 1) % 4) for k in (0, 1, 2, 3)]
    assert min(seen[""], seen["overlap"], seen["boundary"]) > 0


def a_tiling(source: random.Random) -> list[list[int]]:
    """Return the faces of a box of corners 0 to 3, cut into triangles at random; the vertices go up to 8."""
    faces = [[0, 1, 2], [2, 3, 0]]
    for v in range(4, 9):
        a, b, c = faces.pop(source.randrange(len(faces)))
        faces += [[a, b, v], [b, c, v], [c, a, v]]
    source.shuffle(faces)
    return faces


def numbered(faces: Sequence[Sequence[int]], watched: int) -> list[list[int]]:
    """Return faces with the box after the `watched` other vertices."""
    return [[v + watched if v < 4 else v - 4 for v in face] for face in faces]


def reached_from(faces: Sequence[Sequence[int]], begin: int, walls: set[frozenset[int]]) -> set[int]:
    """Return the faces reached from one without crossing walls."""
    found, waiting = {begin}, [begin]
    while waiting:
        here = {frozenset(edge) for edge in directed([faces[waiting.pop()]])} - walls
        for face, row in enumerate(faces):
            if face not in found and here & {frozenset(edge) for edge in directed([row])}:
                found.add(face)
                waiting.append(face)
    return found


def test_borders_edges_and_regions_of_random_tilings() -> None:
    source = random.Random(66)
    seen: Counter[str] = Counter()
    for _ in range(250):
        rows = numbered(a_tiling(source), 5)
        split = source.randrange(1, len(rows))
        pairs = sorted({(min(edge), max(edge)) for edge in directed(rows)})
        inner = [pair for pair in pairs if pair[0] < 5]  # no side of the box is an edge of the input
        chosen = [list(source.sample(pair, 2)) for pair in source.sample(inner, source.randrange(1, len(inner)))]
        checker = a_checker(5, 5, 4, rows[:split], rows[split:], chosen)
        checker.check_tiling()
        assert refusal(checker.check_input_edges) == ""
        walls = {frozenset(edge) for edge in chosen}
        edges = [(checker.origin[h], checker.target(h)) for h in range(len(checker.origin))]
        assert [bool(mark) for mark in checker.is_input] == [frozenset(edge) in walls for edge in edges]
        first = next((edge for h, edge in enumerate(edges) if h < 3 * split and frozenset(edge) not in walls
                      and checker.twin[h] >= 3 * split), None)
        expected = f"border: edge {list(first)}" if first else ""
        seen[expected.split(":")[0]] += 1
        assert refusal(checker.check_border) == expected
        begin = source.randrange(len(rows))
        reached = bytearray(len(rows))
        checker.flood([begin], reached, 1)
        assert {face for face, mark in enumerate(reached) if mark == 1} == reached_from(rows, begin, walls)
        u, v = chosen[0]
        missing = next(pair for pair in itertools.combinations(range(9), 2) if pair not in pairs)
        for more, clause in (([v, u], "repeated-edge"), ([u, v], "repeated-edge"), (missing, "input-edge"),
                             (missing[::-1], "input-edge")):
            other = a_checker(5, 5, 4, rows[:split], rows[split:], [*chosen, more])
            other.check_tiling()
            assert refusal(other.check_input_edges) == f"{clause}: edge {len(chosen)}"
    assert seen["border"] > 20 and seen[""] > 0


def test_the_first_vertex_on_no_face_is_named() -> None:
    for meshed, rest, expected in (([[0, 1, 2]], [[3, 4, 5]], ""), ([[0, 1, 2]], [[3, 4, 4]], "vertex 5"),
                                   ([[1, 2, 2]], [[3, 4, 5]], "vertex 0"), ([[1, 2, 2]], [[3, 4, 4]], "vertex 0"),
                                   # Vertex 0 is given, and the rest will do; 1 and 2 are new ones of the mesh.
                                   ([[1, 2, 2]], [[0, 4, 5], [3, 4, 5]], ""), ([[0, 2, 2]], [[1, 4, 5], [3, 4, 5]],
                                                                               "vertex 1")):
        assert refusal(a_checker(1, 3, 3, meshed, rest).check_use) == (f"unused-vertex: {expected}" if expected else "")


def test_a_face_is_named_by_its_list() -> None:
    checker = a_checker(3, 3, 4, [[0, 1, 2], [0, 1, 2]], [[0, 1, 2]])
    assert [checker.named(face) for face in (0, 1, 2)] == ["mesh face 0", "mesh face 1", "rest face 0"]


def test_a_hole_point_is_in_its_closed_face_but_off_the_input() -> None:
    checker = a_checker(2, 3, 4, [[0, 1, 2]], [[3, 4, 5, 6]], [])
    # The triangle (0, 0), (4, 0), (0, 4), with the input's vertices at (0, 0) and (4, 0).
    checker.points = [(0, 0, 1), (4, 0, 1), (0, 4, 1), (0, 0, 1), (1, 0, 2), (2, 0, 1), (0, 2, 1)]
    checker.face_of = array("q", [0] * 3 + [1] * 4)
    for walls in itertools.product((0, 1), repeat=3):
        checker.is_input = bytearray([*walls, 0, 0, 0, 0])
        for x, y in itertools.product(range(-1, 11), repeat=2):
            p = (x, y, 2)
            inside = x >= 0 and y >= 0 and x + y <= 8
            on_wall = any(wall and on for wall, on in zip(walls, (y == 0, x + y == 8, x == 0), strict=True))
            at_given = (x, y) in ((0, 0), (8, 0))
            assert checker.is_inside(p, 0) == (inside and not on_wall and not at_given), (walls, p)
    # A side in two pieces, of which only the first is the input's: from (0, 0) to (1/2, 0).
    checker.is_input = bytearray([0, 0, 0, 1, 0, 0, 0])
    for p, expected in (((1, 0, 1), True), ((3, 0, 4), True), ((1, 0, 2), False), ((1, 0, 4), False),
                        ((2, 0, 1), True), ((0, 0, 1), False), ((0, 1, 1), True), ((1, 1, 1), True),
                        ((-1, 0, 1), False)):
        assert checker.is_inside(p, 1) == expected, p


# --- whole triples ---


def moved(t: Triple, shift: Fraction, factor: Fraction, up: Fraction = Fraction(0)) -> None:
    """Move all of a triple to the right by `shift` and up, then scale it."""
    for rows in (t.pslg["vertices"], t.mesh["vertices"], t.certificate["vertices"], t.pslg.get("holes", [])):
        rows[:] = [[str((Fraction(x) + shift) * factor), str((Fraction(y) + up) * factor)] for x, y in rows]
    for key, power in (("mfs_squared_at_least", 2), ("input_mfs_squared_at_most", 2), ("mfs_at_least", 1)):
        t.certificate[key] = str(Fraction(t.certificate[key]) * factor**power)


@pytest.mark.parametrize("name", ["square", "square, classic", "ring with a hole", "l-shape", "two points"])
def test_where_a_triple_lies_and_how_large_it_is_does_not_matter(name: str) -> None:
    left, right = (Fraction(base(name).certificate["vertices"][k][0]) for k in (0, 1))
    for shift, factor in ((Fraction(7, 3), Fraction(5, 11)), (-left, 1 / (right - left)), (-right, Fraction(10**9)),
                          (-left, Fraction(1, 10**9))):
        t = copy.deepcopy(base(name))
        moved(t, shift, factor)
        assert by_python(t.files())[0] == 0


def test_a_box_of_width_one() -> None:
    t = copy.deepcopy(base("square"))
    (left, low), (right, top) = (map(Fraction, t.certificate["vertices"][k]) for k in (0, 2))
    assert right - left == top - low
    moved(t, -left, 1 / (right - left), -low)
    assert t.certificate["vertices"][:4] == [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
    assert by_python(t.files())[0] == 0


def with_claims(**claims: str) -> tuple[int, str]:
    """Return the verdict on the square with other claims."""
    t = copy.deepcopy(base("square"))
    t.certificate.update(claims)
    return by_python(t.files())


def test_claims_are_judged_to_the_last_unit() -> None:
    t: dict[str, Any] = base("square").certificate
    bound, nearest = Fraction(t["mfs_squared_at_least"]), Fraction(t["input_mfs_squared_at_most"])
    tiny = Fraction(1, 10**30)
    assert with_claims(mfs_squared_at_least=str(bound / 10**30), mfs_at_least="0",
                       degradation_squared_at_most=str(nearest / bound * 10**30),
                       degradation_at_most=str(10**20))[0] == 0
    assert with_claims(mfs_squared_at_least="1/1000000", degradation_squared_at_most=str(10**6 * nearest),
                       mfs_at_least="1/1000", degradation_at_most=str(1000 * nearest))[0] == 0
    for key, exact, worse in (("degradation_squared_at_most", nearest / bound, -tiny),
                              ("input_mfs_squared_at_most", nearest, -tiny)):
        assert with_claims(**{key: str(exact)})[0] == 0
        assert with_claims(**{key: str(exact + worse)})[1].split(": ")[1].startswith(key)
    for key, least, step in (("mfs_at_least", bound, tiny), ("degradation_at_most", nearest / bound, -tiny)):
        # The nearest numbers with 40 digits on either side of the root.
        below = Fraction(check_root(least), 10**40)
        good, bad = (below, below + Fraction(1, 10**40)) if step > 0 else (below + Fraction(1, 10**40), below)
        if below**2 == least:
            good, bad = below, below + step
        extra = {"degradation_squared_at_most": str(nearest / bound)}
        assert with_claims(**{**extra, key: str(good)})[0] == 0
        assert with_claims(**{**extra, key: str(bad)}) == (1, f"INVALID claim: {key}")
    assert with_claims(mfs_at_least="-1/1000000000") == (1, "INVALID claim: mfs_at_least")
    assert with_claims(degradation_at_most="-1000000000") == (1, "INVALID claim: degradation_at_most")
    assert with_claims(mfs_squared_at_least="-1")[1] == "INVALID bound: mfs_squared_at_least is not positive"


def check_root(value: Fraction) -> int:
    """Return the floor of 10**40 times the root."""
    from math import isqrt

    return isqrt(value.numerator * 10**80 // value.denominator)


@pytest.mark.parametrize("name, line, change", [
    ("square", "format: CERTIFICATE: byte 53: an index expected",
     lambda t: t.certificate.__setitem__("witness", [1, -1, 0])),
    ("ring with a hole", "index: CERTIFICATE: hole_faces",
     lambda t: t.certificate.__setitem__("hole_faces", [len(t.certificate["faces"])])),
    # The vertex that the input has more is where the first corner of the box is.
    ("square, classic", "input-vertices: vertex 4",
     lambda t: t.pslg["vertices"].append(t.certificate["vertices"][0])),
    ("square", "box: CERTIFICATE: vertices", lambda t: t.certificate["vertices"][0].__setitem__(0, "-9"))])
def test_places_are_named(name: str, line: str, change: Callable[[Any], object]) -> None:
    t = copy.deepcopy(base(name))
    t.files()
    order = ("format", "witness")
    t.certificate = {key: t.certificate[key] for key in (*order, *(k for k in t.certificate if k not in order))}
    change(t)
    assert by_python(t.files()) == (1, f"INVALID {line}")


@pytest.mark.parametrize("name", ["ring with a hole", "ring with a hole, rest meshed"])
def test_the_faces_of_a_hole_are_named(name: str) -> None:
    t = copy.deepcopy(base(name))
    face = t.certificate["hole_faces"][0]
    t.pslg["holes"][0][0] = "1"
    assert by_python(t.files()) == (1, f"INVALID hole: hole 0: not inside rest face {face}")
    t.pslg["holes"].clear()
    t.certificate["hole_faces"].clear()
    walls = {frozenset(edge) for edge in t.pslg["edges"]}
    first = min(reached_from(t.certificate["faces"], face, walls))
    assert by_python(t.files()) == (1, f"INVALID domain: rest face {first}: neither outside nor in a hole")


@pytest.mark.parametrize("name", BASES)
def test_what_is_valid_is_accepted_and_a_face_with_four_vertices_is_not_proper(name: str) -> None:
    t = copy.deepcopy(base(name))
    long = [k for k, face in enumerate(t.certificate["faces"]) if len(face) > 3]
    if long and not t.certificate["hole_faces"]:
        t.certificate["faces"].insert(0, t.certificate["faces"].pop(long[0]))
    assert by_python(t.files())[0] == 0
    if four := [face for face in t.mesh["faces"] if len(face) == 4]:
        triangles = [face for face in t.mesh["faces"] if len(face) == 3]
        others = [face for face in t.mesh["faces"] if len(face) > 4]
        t.mesh.update(kind="proper", faces=[*triangles, four[0], *others, *four[1:]])
        assert by_python(t.files()) == (1, f"INVALID face-size: mesh face {len(triangles)}")


# --- reading ---

DOCUMENT = (b'{ "format" :"exactmesh-pslg/1",\n "holes":[["1/2","-.5"]] , "vertices": [["0", "-1/3"],[2, "1e1"],\r\n'
            b'\t["12","3/4"] , [ "7" , -8 ]], "edges": [[0, 1],[1,2], [ 2 , 3 ] ,[3, 10]],'
            b' "name": "a\\u00e9\\n\\\\"} \n')
READ = {"format": None, "holes": [(5, -5, 10)], "vertices": [(0, -1, 3), (2, 10, 1), (48, 3, 4), (7, -8, 1)],
        "name": "a\\u00e9\\n\\\\", "sha256": hashlib.sha256(DOCUMENT).hexdigest()}
ITEMS = 1 + 4 + 4 + 8


def read(data: bytes, **limits: int) -> dict[str, Any]:
    return check.read_object(check.Tokens(io.BytesIO(data), "PSLG", check.Limits(**limits)), check.PSLG)


def word(data: str, shape: str, **limits: int) -> str:
    """Return how a value is refused, "" when it is not."""
    tokens = check.Tokens(io.BytesIO(data.encode()), "FILE", check.Limits(**limits))
    return refusal(lambda: getattr(check, shape)(tokens))


@pytest.mark.parametrize("block", [1, 2, 5, 11, 1 << 16])
def test_a_document_is_read_whole_under_each_limit_that_it_keeps(block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check, "_BLOCK", block)
    for limits in ({}, {"bytes": len(DOCUMENT)}, {"items": ITEMS}, {"digits": 10}):
        found = read(DOCUMENT, **limits)
        edges = found.pop("edges")
        assert found == READ
        assert [edges[i].tolist() for i in range(len(edges))] == [[0, 1], [1, 2], [2, 3], [3, 10]]
    for n in range(len(DOCUMENT)):
        with pytest.raises(check.Refused, match=f"^size: PSLG: more than {n} bytes$"):
            read(DOCUMENT, bytes=n)
    for n in range(ITEMS):
        with pytest.raises(check.Refused, match=f"^size: PSLG: more than {n} items$"):
            read(DOCUMENT, items=n)


@pytest.mark.parametrize("data, line", [
    ("", "format: PSLG: byte 0: { expected"), ("[", "format: PSLG: byte 0: { expected"),
    ("{}", "format: PSLG: byte 1: another key expected"), (" { 5", "format: PSLG: byte 3: another key expected"),
    ('{"x": 1}', "format: PSLG: byte 1: another key expected"),
    ('{"name" "a"}', "format: PSLG: byte 8: : expected"),
    ('{"name": "a" "b"}', "format: PSLG: byte 13: , or } expected"),
    ('{"name": "a",}', "format: PSLG: byte 13: another key expected"),
    ('{"name": "a", "name": "b"}', "format: PSLG: byte 14: another key expected"),
    ('{"name": "a"} x', "format: PSLG: byte 14: a token expected"),
    ('{"name": "a"} {', "format: PSLG: byte 14: the end expected"),
    ('{"name": "a"}', "format: PSLG: no format"),
    ('{"name": 5}', "format: PSLG: byte 9: a string expected"),
    ('{"name": "a\\x"}', "format: PSLG: byte 9: a token expected"),
    ('{"name": "a\\u00g0"}', "format: PSLG: byte 9: a token expected"),
    ('{"name": "é"}', "format: PSLG: byte 9: a token expected"),
    ('{"name": "\t"}', "format: PSLG: byte 9: a token expected"),
    ('{"name": tru', "format: PSLG: byte 9: a token expected"),
    ('{"name": X}', "format: PSLG: byte 9: a token expected"),
    ('{"name": "a', "format: PSLG: byte 9: a token expected"),
    ('{"holes": [["1","2"],]}', "format: PSLG: byte 21: [ expected"),
    ('{"holes": [["1","2"] 5]}', "format: PSLG: byte 21: , or ] expected"),
    ('{"holes": [["1","2","3"]]}', "format: PSLG: byte 19: ] expected"),
    ('{"holes": [["1";"2"]]}', "format: PSLG: byte 15: a token expected"),
    ('{"holes": [["1" "2"]]}', "format: PSLG: byte 16: , expected"),
    ('{"holes": [["1/0","2"]]}', "format: PSLG: byte 12: a denominator that is not zero expected"),
    ('{"holes": [["2","1/0"]]}', "format: PSLG: byte 16: a denominator that is not zero expected"),
    ('{"edges": [0]}', "format: PSLG: byte 11: [ expected"),
    ('{"edges": [[01]]}', "format: PSLG: byte 12: an index expected"),
    ('{"edges": [["0"]]}', "format: PSLG: byte 12: an index expected"),
    ('{"edges": [[-0]]}', "format: PSLG: byte 12: an index expected"),
    ('{"edges": [[1000000000000000000]]}', "format: PSLG: byte 12: an index expected"),
    ('{"edges": [[0,]]}', "format: PSLG: byte 14: an index expected"),
    ('{"edges": [[0 1]]}', "format: PSLG: byte 14: , or ] expected"),
    ('{"edges": [[0', "format: PSLG: byte 13: , or ] expected")])
def test_a_refusal_names_the_byte_and_what_should_be_there(data: str, line: str,
                                                           monkeypatch: pytest.MonkeyPatch) -> None:
    for block in (1, 4, 1 << 16):
        monkeypatch.setattr(check, "_BLOCK", block)
        assert refusal(lambda: read(data.encode())) == line


def test_a_limit_of_bytes_holds_within_a_token_and_not_before_it(monkeypatch: pytest.MonkeyPatch) -> None:
    for n in range(8):
        for block in (1, 3, 1 << 16):
            monkeypatch.setattr(check, "_BLOCK", block)
            assert word('"abcdef"', "text", bytes=n) == f"size: FILE: more than {n} bytes"
    for size in (12, 30):
        assert refusal(lambda size=size: read(b'{"x": 1}' + b" " * 50, bytes=size)) == (
            "format: PSLG: byte 1: another key expected")


def test_a_file_without_optional_keys_has_their_defaults() -> None:
    found = read(b'{"edges": [], "format": "exactmesh-pslg/1", "vertices": []}')
    assert (found["holes"], found["name"], found["vertices"], len(found["edges"])) == ([], "", [], 0)


@pytest.mark.parametrize("text, value", [
    ("5", (5, 1)), ("-5", (-5, 1)), ("0", (0, 1)), ('"-5"', (-5, 1)), ('"+5/10"', (5, 10)), ('"-5/10"', (-5, 10)),
    ('"0.125"', (125, 1000)), ('"-.5"', (-5, 10)), ('"5."', (5, 1)), ('"-3e-7"', (-3, 10**7)), ('"3e-0"', (3, 1)),
    ('"12.50e1"', (1250, 10)), ('"12.5e1"', (125, 1)), ('"12.5e2"', (1250, 1)), ('"1.25e-1"', (125, 1000)),
    ('"007"', (7, 1)), ('"1E+2"', (100, 1)), ('"1e000000002"', (100, 1)),
    ('"12345678901234567890/7"', (12345678901234567890, 7)), (f'"{"9" * 599}"', (10**599 - 1, 1)),
    (f'"{"9" * 600}"', (10**600 - 1, 1)), (f'"{"9" * 601}"', (10**601 - 1, 1)),
    (f'"{"9" * 1801}/{"7" * 1300}"', (10**1801 - 1, 7 * (10**1300 - 1) // 9))])
def test_a_scalar_is_read_to_numerator_and_denominator(text: str, value: tuple[int, int]) -> None:
    for after in ("", " ", ","):
        tokens = check.Tokens(io.BytesIO((text + after).encode()), "FILE", check.DEFAULT)
        assert check.scalar(tokens) == value


@pytest.mark.parametrize("text, line", [
    ('"1" ', ""), ("1", "format: FILE: byte 0: a string expected"), (" x", "format: FILE: byte 1: a token expected"),
    ('"x"', "format: FILE: byte 0: a scalar expected"), ('""', "format: FILE: byte 0: a scalar expected"),
    ('"."', "format: FILE: byte 0: a scalar expected"), ("[", "format: FILE: byte 0: a scalar expected"),
    ("007", "format: FILE: byte 0: a scalar expected"),
    ('"1/0"', "format: FILE: byte 0: a denominator that is not zero expected")])
def test_what_a_claim_is(text: str, line: str) -> None:
    assert word(text, "claim") == line


def test_a_claim_keeps_its_spelling() -> None:
    for text in ("1", "0.50", "22/7", "+1e1"):
        found = check.claim(check.Tokens(io.BytesIO(f'"{text}",'.encode()), "FILE", check.DEFAULT))
        assert found.text == text and Fraction(*found.value) == Fraction(text)


@pytest.mark.parametrize("text, digits", [
    ('"123"', 3), ("-123", 3), ('"12.3"', 3), ('"1/123"', 3), ('"123/1"', 3), ('"1e2"', 3), ('"1e-2"', 3),
    ('"12e1"', 3), ('".12e-1"', 3), ('"0.1"', 2), ('"0003"', 4)])
def test_the_digits_of_a_scalar_are_counted(text: str, digits: int) -> None:
    assert word(text, "scalar", digits=digits) == ""
    assert word(text, "scalar", digits=digits - 1) == "size: FILE: byte 0: too long"
    row = f"[[0,{text}],[{text} , 0 ]]"
    assert word(row, "points", digits=digits) == ""
    assert word(row, "points", digits=digits - 1) == "size: FILE: byte 4: too long"
    both = f"[[{text}, {text}]]"
    assert word(both, "points", digits=digits) == ""
    assert word(both, "points", digits=digits - 1) == "size: FILE: byte 2: too long"


def test_an_exponent_has_nine_digits_at_most() -> None:
    assert word('"1e000000000"', "scalar") == ""
    assert word('"1e0000000000"', "scalar") == "size: FILE: byte 0: too long"
    assert word('"1e-0000000000"', "scalar") == "size: FILE: byte 0: too long"


def test_a_token_is_read_no_further_than_it_may_be() -> None:
    for digits in (4, 10):
        most = 2 * digits + 15
        assert word(f'"{"a" * most}"', "text", digits=digits) == ""
        assert word(f'"{"a" * (most + 1)}"', "text", digits=digits) == "size: FILE: byte 0: too long"
        assert word(f'[{"1" * (most + 1)}]', "indices", digits=digits) == "format: FILE: byte 1: an index expected"
        assert word(f'[{"1" * (most + 2)}]', "indices", digits=digits) == "size: FILE: byte 1: too long"


def test_points_are_the_same_however_their_rows_are_written() -> None:
    values = ["0", "-0", "5", "-7/3", "10/4", "22/7"]
    for x, y in itertools.product(values, repeat=2):
        for row in (f'["{x}", "{y}"]', f'["{x}","{y}"]', f'[ "{x}" ,"{y}" ]', f'["{x}",\n"{y}"]', f'["{x}",  "{y}"]'):
            for rows in (f"[{row}]", f"[{row}, {row}]", f"[\n{row},\n{row} ]"):
                found = check.points(check.Tokens(io.BytesIO(rows.encode()), "FILE", check.DEFAULT))
                assert len(found) == rows.count(row)
                assert {place(p) for p in found} == {(Fraction(x), Fraction(y))} and found[0][2] > 0


def test_cycles_are_the_same_however_their_rows_are_written() -> None:
    lists = [[0], [1, 2], [3, 40, 500], [10**18 - 1, 7], []]
    for a, b in itertools.product(lists, repeat=2):
        for rows in (json.dumps([a, b]), json.dumps([a, b], separators=(",", ":")), json.dumps([a, b], indent=1),
                     json.dumps([a, b]).replace(",", " ,")):
            count = 2 + len(a) + len(b)
            tokens = check.Tokens(io.BytesIO(rows.encode()), "FILE", check.Limits(items=count))
            found = check.cycles(tokens)
            assert [found[i].tolist() for i in range(len(found))] == [a, b] and tokens.items == count
            assert word(rows, "cycles", items=count - 1) == f"size: FILE: more than {count - 1} items"


@pytest.mark.parametrize("block", range(10, 60))
def test_rows_are_read_once_wherever_blocks_end(block: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check, "_BLOCK", block)
    between = ",\n" + 12 * " "
    places = [(k, -k) for k in range(40)]
    rows = f"[{between.join(json.dumps([str(x), str(y)]) for x, y in places)}]"
    tokens = check.Tokens(io.BytesIO(rows.encode()), "FILE", check.Limits(items=1000))
    assert check.points(tokens) == [(x, y, 1) for x, y in places] and tokens.items == 40
    lists = [[k, k + 1, k + 2] for k in range(40)]
    tokens = check.Tokens(io.BytesIO(f"[{between.join(map(str, lists))}]".encode()), "FILE", check.Limits(items=1000))
    found = check.cycles(tokens)
    assert [found[i].tolist() for i in range(len(found))] == lists and tokens.items == 160


def test_lists_without_items() -> None:
    for shape in ("points", "cycles", "indices"):
        for text in ("[]", " [ ]", "[\n]"):
            tokens = check.Tokens(io.BytesIO(text.encode()), "FILE", check.Limits(items=0))
            assert len(getattr(check, shape)(tokens)) == 0 and tokens.next() == b""
