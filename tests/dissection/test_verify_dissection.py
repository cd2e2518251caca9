"""The checker refuses what is harmed, with the clause, and does not know how dissections are made."""

import ast
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import families
import pytest
import sympy
from dissections import KNOWN, TRIANGLE, dissected, rectangle
from gmpy2 import mpq

from exactmesh.dissection import verify
from exactmesh.dissection.dissection_json import dissection_from_json, json_from_dissection
from exactmesh.dissection.records import Dissection, Motion, Piece, Vector
from exactmesh.dissection.verify import DissectionVerdict, Refusal, verify_dissection
from exactmesh.errors import FormatError, InputError
from exactmesh.numbers.algebraic import Real, sqrt

FIGURES = KNOWN["square to rectangle"]
GOOD = dissected("square to rectangle").dissection
ZERO, ONE = Real(0), Real(1)


def with_piece(number: int, change: Callable[[Piece], Piece]) -> Dissection:
    pieces = list(GOOD.pieces)
    pieces[number] = change(pieces[number])
    return replace(GOOD, pieces=tuple(pieces))


def with_motion(**fields: Callable[[Motion], Real]) -> Dissection:
    return with_piece(3, lambda piece: replace(piece, motions=(
        piece.motions[0]._replace(**{name: change(piece.motions[0]) for name, change in fields.items()}),)))


def moved(piece: Piece, x: Real) -> Piece:
    """Return a piece shifted in both figures, with the motion that fits: only the tiling suffers."""
    motion = piece.motions[0]
    polygons = tuple(tuple(Vector(p.x + x, p.y) for p in polygon) for polygon in piece.polygons)
    # q + x = M (p + x e) + t' with t' = t + x e - x M e.
    return Piece(polygons, (motion._replace(x=motion.x + x - motion.a * x, y=motion.y - motion.c * x),))


def star(piece: Piece) -> Piece:
    """Return a pentagram: every corner turns left, the sides go round twice."""
    ring = [(0, 3), (-3, 1), (-2, -2), (2, -2), (3, 1)]
    corners = tuple(Vector(Real(x), Real(y)) for x, y in (ring[2 * i % 5] for i in range(5)))
    return Piece((corners, corners), (shifted(0, 0),))


def mirrored(piece: Piece) -> Piece:
    """Return a piece whose second polygon is its mirror image, with the reflection as its motion."""
    polygon = piece.polygons[0]
    return Piece((polygon, tuple(Vector(-p.x, p.y) for p in polygon)),
                 (Motion(-ONE, Real(0), Real(0), ONE, Real(0), Real(0)),))


TINY = sqrt(2) / 10**40
HARMS: dict[str, tuple[Callable[[], Dissection], str, dict[str, int]]] = {
    "a piece left out": (lambda: replace(GOOD, pieces=GOOD.pieces[1:]), "areas", {"figure": 0}),
    "a piece twice": (lambda: replace(GOOD, pieces=(*GOOD.pieces, GOOD.pieces[0])), "areas", {"figure": 0}),
    "one piece in place of another": (lambda: replace(
        GOOD, pieces=(*GOOD.pieces[:-2], moved(GOOD.pieces[-2], ONE), GOOD.pieces[-1])), "tiling", {"figure": 0}),
    "a piece moved by 1e-40": (lambda: with_piece(5, lambda piece: moved(piece, TINY)), "tiling", {"figure": 0}),
    "a corner moved by 1e-40": (lambda: with_piece(3, lambda piece: replace(piece, polygons=(piece.polygons[0], (
        Vector(piece.polygons[1][0].x + TINY, piece.polygons[1][0].y), *piece.polygons[1][1:])))), "image",
        {"piece": 3, "figure": 1, "corner": 0}),
    "a reflection": (lambda: with_piece(0, mirrored), "isometry", {"piece": 0, "figure": 1}),
    "a magnified motion": (lambda: with_motion(a=lambda m: 2 * m.a, d=lambda m: 2 * m.d), "isometry",
                           {"piece": 3, "figure": 1}),
    "a magnified rotation": (lambda: with_motion(a=lambda m: 2 * m.a, b=lambda m: 2 * m.b, c=lambda m: 2 * m.c,
                                                 d=lambda m: 2 * m.d), "isometry", {"piece": 3, "figure": 1}),
    "a shear": (lambda: with_motion(b=lambda m: m.b + 1), "isometry", {"piece": 3, "figure": 1}),
    "a stretch that keeps areas": (lambda: with_motion(a=lambda m: 2 * m.a, b=lambda m: m.b / 2, c=lambda m: 2 * m.c,
                                                       d=lambda m: m.d / 2), "isometry", {"piece": 3, "figure": 1}),
    "a skewed second axis": (lambda: with_motion(b=lambda m: m.b + m.a, d=lambda m: m.d + m.c), "isometry",
                             {"piece": 3, "figure": 1}),
    "a rotation but for one number": (lambda: with_motion(d=lambda m: m.d + TINY), "isometry",
                                      {"piece": 3, "figure": 1}),
    "a wrong translation upwards": (lambda: with_motion(y=lambda m: m.y - TINY), "image",
                                    {"piece": 3, "figure": 1, "corner": 0}),
    "a wrong translation": (lambda: with_motion(x=lambda m: m.x + TINY), "image",
                            {"piece": 3, "figure": 1, "corner": 0}),
    "a clockwise piece": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=tuple(polygon[::-1] for polygon in piece.polygons))), "convex", {"piece": 2}),
    "a pentagram": (lambda: with_piece(2, star), "convex", {"piece": 2}),
    "a corner on a side": (lambda: with_piece(2, lambda piece: replace(piece, polygons=tuple(
        (polygon[0], Vector((polygon[0].x + polygon[1].x) / 2, (polygon[0].y + polygon[1].y) / 2), *polygon[1:])
        for polygon in piece.polygons))), "convex", {"piece": 2}),
    "two corners": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=tuple(polygon[:2] for polygon in piece.polygons))), "corners", {"piece": 2}),
    "unequal corners": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=(piece.polygons[0], piece.polygons[1][1:]))), "corners", {"piece": 2}),
    "no motion": (lambda: with_piece(1, lambda piece: replace(piece, motions=())), "figures", {"piece": 1}),
    "a polygon too many": (lambda: replace(GOOD, scales=(ONE, ONE, ONE)), "figures", {"polygons": 2, "scales": 3}),
    "another scale": (lambda: replace(GOOD, scales=(ONE, ONE + TINY)), "areas", {"figure": 1}),
    "no scale": (lambda: replace(GOOD, scales=(ONE, ONE - ONE)), "scale", {"figure": 1}),
    "a polygon too few": (lambda: with_piece(4, lambda piece: replace(piece, polygons=piece.polygons[:1])), "figures",
                          {"piece": 4}),
    "a negative scale": (lambda: replace(GOOD, scales=(ONE, -ONE)), "scale", {"figure": 1}),
    "the first scaled": (lambda: replace(GOOD, scales=(sqrt(2), sqrt(2))), "scale", {"figure": 0}),
    "no pieces": (lambda: replace(GOOD, pieces=()), "areas", {"figure": 0}),
}


def test_what_is_to_be_harmed_is_sound() -> None:
    assert verify_dissection(FIGURES, GOOD).valid


@pytest.mark.parametrize("name", HARMS)
def test_what_is_harmed_is_refused(name: str) -> None:
    harm, clause, place = HARMS[name]
    verdict = verify_dissection(FIGURES, harm())
    assert verdict.refusal == Refusal(clause, place) and not verdict.valid


def test_other_polygons_are_refused() -> None:
    for figures, clause in (((FIGURES[1], FIGURES[0]), "tiling"), ((FIGURES[0], TRIANGLE), "tiling"),
                            ((rectangle(3), FIGURES[1]), "areas")):
        refusal = verify_dissection(figures, GOOD).refusal
        assert refusal is not None and refusal.clause == clause


def test_too_many_roots_are_no_verdict() -> None:
    # Both corners of a side move by sums that differ in twelve roots: its slope would be a quotient of these.
    many = sum((sqrt(p) for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)), Real(0)) / 10**9

    def leaning(lean: Real) -> Dissection:
        corners = (Vector(ZERO, ZERO), Vector(Real(2), ZERO), Vector(2 + lean, Real(1)), Vector(lean, Real(1)))
        return Dissection((ONE, ONE), (Piece((corners, corners), (shifted(0, 0),)),))

    with pytest.raises(InputError, match=r"^the pieces cannot be judged: more than"):
        verify_dissection((rectangle(2), rectangle(2)), leaning(many))
    refusal = verify_dissection((rectangle(2), rectangle(2)), leaning(sqrt(2))).refusal
    assert refusal is not None and refusal.clause == "tiling"


def box(x: int, y: int, first: int = 0) -> tuple[Vector, ...]:
    """Return a unit square, its cycle begun at one of its corners."""
    ring = [Vector(Real(x + i), Real(y + j)) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return (*ring[first:], *ring[:first])


def shifted(x: int, y: int) -> Motion:
    return Motion(ONE, ZERO, ZERO, ONE, Real(x), Real(y))


def test_a_dissection_by_hand_is_accepted() -> None:
    # The 2 x 1 rectangle in two halves, one of them turned upside down in the other figure.
    upright = Piece((box(0, 0), box(0, 0)), (shifted(0, 0),))
    turned = Piece((box(1, 0), box(0, 1, 2)), (Motion(-ONE, ZERO, ZERO, -ONE, Real(2), Real(2)),))
    figures = rectangle(2), rectangle(1, 2)
    assert verify_dissection(figures, Dissection((ONE, ONE), (upright, turned))).valid


def test_pieces_that_tile_one_figure_only_are_refused_at_the_other() -> None:
    first = Piece((box(0, 0), box(0, 0)), (shifted(0, 0),))
    on_it = Piece((box(1, 0), box(0, 0)), (shifted(-1, 0),))
    steps: list[str] = []
    verdict = verify_dissection((rectangle(2), rectangle(2)), Dissection((ONE, ONE), (first, on_it)), steps.append)
    assert verdict.refusal == Refusal("tiling", {"figure": 1})
    assert steps[-2:] == ["tiling of polygon 1", "tiling of polygon 2"]


@pytest.mark.parametrize("first", range(4))
@pytest.mark.parametrize("away", [(2, 0), (1, 1), (5, 7), (0, 0)])
def test_boxes_beside_the_polygon_are_refused(first: int, away: tuple[int, int]) -> None:
    # All edges are level or upright, and whatever names numbers get, the two are never taken for each other.
    pieces = tuple(Piece((polygon,), ()) for polygon in (box(0, 0, first), box(*away)))
    assert verify_dissection((rectangle(2),), Dissection((ONE,), pieces)).refusal == Refusal("tiling", {"figure": 0})
    pieces = (pieces[0], Piece((box(1, 0),), ()))
    assert verify_dissection((rectangle(2),), Dissection((ONE,), pieces)).valid


@pytest.mark.parametrize(("name", "pieces", "shares"), [
    ("square to rectangle", 40, [0]), ("three", 74, [0]), ("four", 107, [0, 93])])
def test_a_verdict_tells_what_was_looked_at(name: str, pieces: int, shares: list[int]) -> None:
    made = dissected(name).dissection
    steps: list[str] = []
    verdict = verify_dissection(KNOWN[name], made, steps.append)
    count = len(KNOWN[name])
    assert verdict == DissectionVerdict(None, pieces, (mpq(4),) * count, (ONE,) * count) and verdict.valid
    assert steps == ["validation", *(f"pieces, {share} %" for share in shares),
                     *(f"tiling of polygon {figure + 1}" for figure in range(count))]


def test_polygons_are_tiled_at_their_scales() -> None:
    square = tuple(Vector(Real(x), Real(y)) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2)))
    piece, figures = Piece((square, square), (shifted(0, 0),)), (rectangle(2, 2), rectangle(1))
    assert verify_dissection(figures, Dissection((ONE, Real(2)), (piece,))) == DissectionVerdict(
        None, 1, (mpq(4), mpq(1)), (ONE, Real(2)))
    for scale in (1, 3, 4):
        verdict = verify_dissection(figures, Dissection((ONE, Real(scale)), (piece,)))
        assert verdict.refusal == Refusal("areas", {"figure": 1})


def test_a_polygon_may_lie_anywhere() -> None:
    pieces = tuple(Piece((box(x, -5),), ()) for x in (7, 8))
    figure = families.translated(rectangle(2), 7, -5)
    assert verify_dissection((figure,), Dissection((ONE,), pieces)) == DissectionVerdict(None, 2, (mpq(2),), (ONE,))


def test_a_triangle_is_a_piece_whatever_the_direction_of_its_sides() -> None:
    ring = ((0, 0), (3, 1), (2, 4), (1, 4), (-2, 4), (-3, 0), (-1, -2), (1, -2))
    for i, p in enumerate(ring):
        for j, q in enumerate(ring[:i]):
            for r in ring[:j]:
                corners = tuple(Vector(Real(x), Real(y)) for x, y in (r, q, p))
                convex = (q[0] - r[0]) * (p[1] - r[1]) > (q[1] - r[1]) * (p[0] - r[0])
                assert verify_dissection((rectangle(100),), Dissection((ONE,), (Piece((corners,), ()),))).refusal == (
                    Refusal("areas", {"figure": 0}) if convex else Refusal("convex", {"piece": 0}))


@pytest.mark.parametrize("name", ["square to rectangle", "three", "hexagon to square"])
def test_a_file_is_read_back_as_it_was(name: str) -> None:
    made = dissected(name).dissection
    assert dissection_from_json(json_from_dissection(made)) == made


def test_python_and_sympy_read_the_numbers() -> None:
    piece = dissected("hexagon to square").dissection.pieces[0]
    values = [value for polygon in piece.polygons for p in polygon for value in p]
    assert any(not value.is_rational() for value in values)
    for value in values:
        assert eval(str(value), {"sqrt": math.sqrt}) == pytest.approx(float(value.decimal(17)), abs=1e-12)
        assert abs(sympy.sympify(str(value)).evalf(30) - sympy.Float(value.decimal(30), 30)) < 1e-25


@pytest.mark.parametrize("old, new, place", [
    ('"scales": ["1"', '"scales": ["one"', "scales[0]"), ('"matrix": [[', '"matrix": [[], [', "pieces[0].motions[0]"),
    ('"translation"', '"translated"', "pieces[0].motions[0]"), ("dissection/1", "dissection/2", "format"),
    ('{"polygons": [[[', '{"polygons": [[[0.5, ', "pieces[0].polygons[0][0]"),
    ('{"polygons": [[["', '{"polygons": [[["sqrt(-1) + ', "pieces[0].polygons[0][0][0]"),
    ('"pieces"', '"parts"', "pieces"), ('"matrix": [[', '"matrix": [["1", "0"], [', "pieces[0].motions[0].matrix")])
def test_a_file_of_another_form_is_refused(old: str, new: str, place: str) -> None:
    text = json_from_dissection(replace(GOOD, pieces=GOOD.pieces[:1]))
    assert old in text
    with pytest.raises(FormatError) as caught:
        dissection_from_json(text.replace(old, new, 1))
    assert place in str(caught.value)


def test_the_checker_knows_no_construction() -> None:
    tree = ast.parse(Path(verify.__file__).read_text(encoding="utf-8"))
    names = {node.module for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    own = {name for name in names if name and name.startswith("exactmesh.")}
    assert {name for name in own if ".dissection." in name} == {"exactmesh.dissection.records"}
    assert {name.split(".")[1] for name in own} <= {"dissection", "errors", "numbers", "planar"}
