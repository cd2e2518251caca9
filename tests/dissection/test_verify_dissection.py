"""The checker refuses what is harmed, with the clause, and does not know how dissections are made."""

import ast
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
import sympy
from dissections import KNOWN, TRIANGLE, dissected, rectangle

from exactmesh.dissection import verify
from exactmesh.dissection.dissection_json import dissection_from_json, json_from_dissection
from exactmesh.dissection.records import Dissection, Motion, Piece, Vector
from exactmesh.dissection.verify import verify_dissection
from exactmesh.errors import FormatError, InputError
from exactmesh.numbers.algebraic import Real, sqrt

FIGURES = KNOWN["square to rectangle"]
GOOD = dissected("square to rectangle").dissection
ONE = Real(1)


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
    return Piece((corners, corners), (Motion(ONE, Real(0), Real(0), ONE, Real(0), Real(0)),))


def mirrored(piece: Piece) -> Piece:
    """Return a piece whose second polygon is its mirror image, with the reflection as its motion."""
    polygon = piece.polygons[0]
    return Piece((polygon, tuple(Vector(-p.x, p.y) for p in polygon)),
                 (Motion(-ONE, Real(0), Real(0), ONE, Real(0), Real(0)),))


TINY = sqrt(2) / 10**40
HARMS: dict[str, tuple[Callable[[], Dissection], str]] = {
    "a piece left out": (lambda: replace(GOOD, pieces=GOOD.pieces[1:]), "areas"),
    "a piece twice": (lambda: replace(GOOD, pieces=(*GOOD.pieces, GOOD.pieces[0])), "areas"),
    "one piece in place of another": (lambda: replace(
        GOOD, pieces=(*GOOD.pieces[:-2], moved(GOOD.pieces[-2], ONE), GOOD.pieces[-1])), "tiling"),
    "a piece moved by 1e-40": (lambda: with_piece(5, lambda piece: moved(piece, TINY)), "tiling"),
    "a corner moved by 1e-40": (lambda: with_piece(3, lambda piece: replace(piece, polygons=(piece.polygons[0], (
        Vector(piece.polygons[1][0].x + TINY, piece.polygons[1][0].y), *piece.polygons[1][1:])))), "image"),
    "a reflection": (lambda: with_piece(0, mirrored), "isometry"),
    "a magnified motion": (lambda: with_motion(a=lambda m: 2 * m.a, d=lambda m: 2 * m.d), "isometry"),
    "a shear": (lambda: with_motion(b=lambda m: m.b + 1), "isometry"),
    "a wrong translation": (lambda: with_motion(x=lambda m: m.x + TINY), "image"),
    "a clockwise piece": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=tuple(polygon[::-1] for polygon in piece.polygons))), "convex"),
    "a pentagram": (lambda: with_piece(2, star), "convex"),
    "a corner on a side": (lambda: with_piece(2, lambda piece: replace(piece, polygons=tuple(
        (polygon[0], Vector((polygon[0].x + polygon[1].x) / 2, (polygon[0].y + polygon[1].y) / 2), *polygon[1:])
        for polygon in piece.polygons))), "convex"),
    "two corners": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=tuple(polygon[:2] for polygon in piece.polygons))), "corners"),
    "unequal corners": (lambda: with_piece(2, lambda piece: replace(
        piece, polygons=(piece.polygons[0], piece.polygons[1][1:]))), "corners"),
    "no motion": (lambda: with_piece(1, lambda piece: replace(piece, motions=())), "figures"),
    "a polygon too many": (lambda: replace(GOOD, scales=(ONE, ONE, ONE)), "figures"),
    "another scale": (lambda: replace(GOOD, scales=(ONE, ONE + TINY)), "areas"),
    "a negative scale": (lambda: replace(GOOD, scales=(ONE, -ONE)), "scale"),
    "the first scaled": (lambda: replace(GOOD, scales=(sqrt(2), sqrt(2))), "scale"),
    "no pieces": (lambda: replace(GOOD, pieces=()), "areas"),
}


def test_what_is_to_be_harmed_is_sound() -> None:
    assert verify_dissection(FIGURES, GOOD).valid


@pytest.mark.parametrize("name", HARMS)
def test_what_is_harmed_is_refused(name: str) -> None:
    harm, clause = HARMS[name]
    refusal = verify_dissection(FIGURES, harm()).refusal
    assert refusal is not None and refusal.clause == clause and refusal.place


def test_other_polygons_are_refused() -> None:
    for figures, clause in (((FIGURES[1], FIGURES[0]), "tiling"), ((FIGURES[0], TRIANGLE), "tiling"),
                            ((rectangle(3), FIGURES[1]), "areas")):
        refusal = verify_dissection(figures, GOOD).refusal
        assert refusal is not None and refusal.clause == clause


def test_too_many_roots_are_no_verdict() -> None:
    # Both corners of a side move by sums that differ in twelve roots: its slope would be a quotient of these.
    many = sum((sqrt(p) for p in (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)), Real(0)) / 10**9
    zero = Real(0)

    def leaning(lean: Real) -> Dissection:
        corners = (Vector(zero, zero), Vector(Real(2), zero), Vector(2 + lean, Real(1)), Vector(lean, Real(1)))
        return Dissection((ONE, ONE), (Piece((corners, corners), (Motion(ONE, zero, zero, ONE, zero, zero),)),))

    with pytest.raises(InputError, match="cannot be judged: more than"):
        verify_dissection((rectangle(2), rectangle(2)), leaning(many))
    refusal = verify_dissection((rectangle(2), rectangle(2)), leaning(sqrt(2))).refusal
    assert refusal is not None and refusal.clause == "tiling"


def test_a_dissection_by_hand_is_accepted() -> None:
    # The 2 x 1 rectangle in two halves, one of them turned upside down in the other figure.
    zero = Real(0)

    def box(x: int, y: int) -> tuple[Vector, ...]:
        return tuple(Vector(Real(x + i), Real(y + j)) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1)))

    upright = Piece((box(0, 0), box(0, 0)), (Motion(ONE, zero, zero, ONE, zero, zero),))
    turned = Piece((box(1, 0), box(0, 1)[2:] + box(0, 1)[:2]), (Motion(-ONE, zero, zero, -ONE, Real(2), Real(2)),))
    figures = rectangle(2), rectangle(1, 2)
    assert verify_dissection(figures, Dissection((ONE, ONE), (upright, turned))).valid


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
