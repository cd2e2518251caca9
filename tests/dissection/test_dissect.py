"""Dissections of known and random polygons: checked exactly, counted, and compared with rounded areas."""

import families
import pytest
from dissections import KNOWN, TRIANGLE, dissected, of_area, rectangle, shoelace, triangle
from gmpy2 import mpq
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon as Shape
from shapely.ops import unary_union

from exactmesh.dissection import bound, lower_bound
from exactmesh.dissection import dissect as module
from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.figure import MAX_FIGURES, MAX_VERTICES, domain_area
from exactmesh.dissection.verify import verify_dissection
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.point import Point
from exactmesh.numbers.algebraic import sqrt
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg


@pytest.mark.parametrize("name", KNOWN)
def test_known_pairs_are_dissected(name: str) -> None:
    made = dissected(name)
    verdict = verify_dissection(KNOWN[name], made.dissection)
    assert verdict.valid, verdict.refusal
    assert verdict.pieces == len(made.dissection.pieces) <= made.strip_bound
    assert made.spread_bound is not None and verdict.pieces <= made.spread_bound
    assert 0 <= made.cuts_on_a_vertical <= 3


@pytest.mark.parametrize("name", ["square to rectangle", "hole", "three", "hexagon to square"])
def test_another_library_finds_the_same_shapes(name: str) -> None:
    made = dissected(name)
    for figure, pslg in enumerate(KNOWN[name]):
        area = float(domain_area(domain_of(pslg))) * float(made.figures[figure].scale_squared)
        shapes = [[(float(p.x.decimal(17)), float(p.y.decimal(17))) for p in piece.polygons[figure]]
                  for piece in made.dissection.pieces]
        assert sum(shoelace(shape) for shape in shapes) == pytest.approx(area, rel=1e-12)
        assert unary_union([Shape(shape).buffer(1e-9) for shape in shapes]).area == pytest.approx(area, rel=1e-6)
        assert len(unary_union([Shape(shape).buffer(1e-9) for shape in shapes]).interiors) == len(pslg.holes)


def test_the_square_and_the_rectangle_have_few_pieces() -> None:
    assert len(dissected("square to rectangle").dissection.pieces) == 40
    assert dissected("square to rectangle").cells == (2, 2)


@pytest.mark.parametrize("kind", ["classic", "internal", "nonproper"])
def test_every_kind_of_triangulation_will_do(kind: str) -> None:
    figures = TRIANGLE, rectangle(2, 2)
    made = dissect(figures, kind=kind)  # type: ignore[arg-type]
    assert made.kinds == (kind, kind) and (made.spread_bound is None) == (kind != "nonproper")
    assert verify_dissection(figures, made.dissection).valid


def test_without_a_kind_there_are_at_most_as_many_cells_as_in_nonproper_meshes() -> None:
    figures = rectangle(2, 2), of_area(families.comb(3), mpq(4))
    assert sum(dissect(figures).cells) <= sum(dissect(figures, kind="nonproper").cells)


def test_two_random_polygons_of_20_vertices() -> None:
    first, second = families.random_simple_polygon(20, 1), families.random_simple_polygon(20, 2)
    second = of_area(second, domain_area(domain_of(first)))
    made = dissect((first, second))
    assert verify_dissection((first, second), made.dissection).valid


COORDINATES = st.integers(-6, 6)
CORNERS = st.tuples(COORDINATES, COORDINATES)


@given(st.tuples(CORNERS, CORNERS, CORNERS), st.tuples(CORNERS, CORNERS, CORNERS), st.booleans())
@settings(max_examples=25, deadline=None, suppress_health_check=list(HealthCheck))
def test_any_two_triangles(first: tuple[tuple[int, int], ...], second: tuple[tuple[int, int], ...], scale: bool
                           ) -> None:
    pslgs = [triangle(*first), triangle(*second)]
    turns = [(b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) for a, b, c in (first, second)]
    assume(all(abs(turn) >= 6 for turn in turns))
    if not scale:
        pslgs[1] = of_area(pslgs[1], mpq(abs(turns[0]), 2))
    made = dissect(pslgs, scale=scale)
    assert verify_dissection(pslgs, made.dissection).valid


def test_a_factor_that_is_a_square_root_is_exact() -> None:
    made = dissect((rectangle(3), rectangle(1)), scale=True)
    assert made.dissection.scales == (1, sqrt(3))
    assert verify_dissection((rectangle(3), rectangle(1)), made.dissection).valid


def test_the_lower_bound_of_the_square_and_the_rectangle() -> None:
    assert [lower_bound.fewest(r) for r in (1, 2, 3, 8, 9, 18, 100)] == [1, 1, 2, 2, 3, 3, 8]
    rows = list(lower_bound.rectangle_rows((2, 9, 32)))
    assert all(row.valid and row.fewest <= row.pieces <= row.strip_bound for row in rows)
    # Pieces grow as the square root: sixteen times the length, less than five times the pieces.
    assert rows[2].pieces < 5 * rows[0].pieces
    assert lower_bound.rectangles_text(rows).count("yes") == 3 and '"r": 9' in lower_bound.rectangles_json(rows)


# --- refusals ---


def test_unequal_areas_are_refused_with_both() -> None:
    with pytest.raises(InputError, match=r"areas differ: 4 \(polygon 1\) and 7/2 \(polygon 3\); --scale"):
        dissect((rectangle(4), rectangle(2, 2), rectangle(mpq(7, 2))))


@pytest.mark.parametrize("figures, reason", [
    ((rectangle(1),), "2 to"), ((rectangle(1),) * (MAX_FIGURES + 1), "2 to"),
    ((rectangle(1), families.regular_polygon(MAX_VERTICES + 1)), "at most 2000"),
    ((families.wheel(3), rectangle(1)), "both sides"),
    ((Pslg((*rectangle(3).vertices, Point(mpq(1), mpq(1, 2))), rectangle(3).edges), rectangle(3)), "isolated"),
    ((rectangle(10**8), rectangle(10**4, 10**4)), "at most 3000")])
def test_what_is_no_polygon_or_too_large_is_refused(figures: tuple[Pslg, ...], reason: str) -> None:
    with pytest.raises(InputError, match=reason):
        dissect(figures)


# --- guards are seen to fire ---


def test_too_many_pieces_fail() -> None:
    made = dissected("square to rectangle")
    with pytest.raises(ConstructionFailed, match="pieces by cells"):
        bound.require_bounds(made.figures, made.cells, made.strip_bound + 1, True)
    with pytest.raises(ConstructionFailed, match="pieces by spread"):
        bound.require_bounds(made.figures, (10**6, 10**6), 10**7, True)
    bound.require_bounds(made.figures, (10**6, 10**6), 10**7, False)


def test_too_many_cuts_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "CUTS_ON_A_VERTICAL", 2)
    with pytest.raises(ConstructionFailed, match="vertical"):
        dissect(KNOWN["square to rectangle"])


def test_the_bound_by_spread_is_the_stated_one() -> None:
    made = dissected("square to rectangle")
    # r is sqrt 2 for the square and sqrt 17 for the 4 x 1 rectangle.
    exact = 6875 * 2 * 8 * (sqrt(2) + sqrt(17))
    assert made.spread_bound is not None
    assert exact * (1 - mpq(1, 2**60)) < made.spread_bound <= exact


def test_progress_is_told() -> None:
    steps: list[str] = []
    dissect(KNOWN["triangle to square"], progress=steps.append)
    assert steps[0] == "validation" and "strips" in steps and any("overlay" in step for step in steps)
