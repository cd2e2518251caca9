"""Figures: normal form, symmetries, and what is planar, against the sweep of the product."""

import random

import pytest
from families import SMALL_PSLGS
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.errors import GeometryError, InputError
from exactmesh.planar.faces import domain_of
from exactmesh.planar.validate import validate
from exactmesh.search.families import DOMAINS, FAMILIES, family_of, planar_sample
from exactmesh.search.figure import Figure, complexity, divided, images_of, is_planar, normal_form

POINT = st.tuples(st.integers(0, 4), st.integers(0, 4))


@st.composite
def graphs(draw: st.DrawFn) -> Figure:
    points = draw(st.lists(POINT, min_size=2, max_size=6))
    pair = st.tuples(st.integers(0, len(points) - 1), st.integers(0, len(points) - 1)).filter(lambda e: e[0] != e[1])
    return Figure(tuple(points), tuple(draw(st.lists(pair, max_size=6))), tuple(draw(st.lists(POINT, max_size=1))))


@given(graphs())
@settings(max_examples=400, derandomize=True)
def test_planar_is_what_the_sweep_says(figure: Figure) -> None:
    try:
        validate(figure.pslg())
        valid = True
    except GeometryError:
        valid = False
    assert is_planar(figure) == valid


@given(graphs(), st.integers(-5, 5), st.randoms(use_true_random=False))
@settings(max_examples=200, derandomize=True)
def test_the_normal_form_forgets_place_and_order(figure: Figure, shift: int, source: random.Random) -> None:
    order = list(range(len(figure.points)))
    source.shuffle(order)
    new = {old: i for i, old in enumerate(order)}
    other = Figure(tuple((figure.points[v][0] + shift, figure.points[v][1] - shift) for v in order),
                   tuple((new[v], new[u]) for u, v in reversed(figure.edges)),
                   tuple((x + shift, y - shift) for x, y in figure.holes))
    here = normal_form(figure)
    if is_planar(figure):
        assert here == normal_form(other) == normal_form(here)
        assert set(images_of(figure)) == set(images_of(next(images_of(other))))
    assert min(c for p in here.points for c in p) == 0


@pytest.mark.parametrize("name", SMALL_PSLGS)
def test_any_rational_input_is_a_figure_and_json_brings_it_back(name: str) -> None:
    figure = Figure.of(SMALL_PSLGS[name])
    assert Figure.from_json(figure.to_json()) == figure == Figure.of(figure.pslg())
    assert is_planar(figure) and not figure.is_polygon
    doubled = figure.at([(2 * x, 2 * y) for x, y in figure.places])
    assert divided(doubled) == divided(figure) and complexity(normal_form(figure)) < complexity(normal_form(doubled))


def test_a_single_cycle_is_a_polygon() -> None:
    square = Figure(((5, 5), (6, 6), (6, 5), (5, 6)), ((0, 2), (2, 1), (3, 1), (3, 0)))
    assert not square.is_polygon
    assert normal_form(square) == Figure.polygon(((0, 0), (1, 0), (1, 1), (0, 1)))
    # Two triangles are no polygon, nor is a square with a hole point in it.
    assert not normal_form(Figure(((0, 0), (1, 0), (0, 1), (5, 5), (6, 5), (5, 6)),
                                  ((0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3)))).is_polygon
    assert not normal_form(Figure(((0, 0), (3, 0), (0, 3)), ((0, 1), (1, 2), (2, 0)), ((1, 1),))).is_polygon


@pytest.mark.parametrize("name", FAMILIES)
def test_families_give_domains_and_repeat_themselves(name: str) -> None:
    for seed in range(6):
        figure = planar_sample(family_of(name, {}), random.Random(seed))
        assert figure is not None and figure == planar_sample(family_of(name, {}), random.Random(seed))
        domain_of(figure.pslg())  # raises unless it has a bounded face that is no hole
        assert name in DOMAINS or figure.is_polygon


def test_any_family_can_be_turned_cut_and_given_many_digits() -> None:
    plain = planar_sample(family_of("comb", {"teeth": 3}), random.Random(1))
    changed = planar_sample(family_of("comb", {"teeth": 3, "turned": 1, "cut": 1, "digits": 1}), random.Random(1))
    assert plain is not None and changed is not None and len(changed.points) == 2 * len(plain.points)
    assert all(len(str(c)) == 30 for p in changed.points for c in p)
    with pytest.raises(InputError, match="up to 3, not 7"):
        planar_sample(family_of("comb", {"spacing": 7}), random.Random(0))
