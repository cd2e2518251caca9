"""Sizes of numbers: linear in those of the input whatever its length, and refused when they are not."""

from dataclasses import replace
from pathlib import Path

import families
import pytest
from gmpy2 import mpq
from recorded import recorded

from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.steps import size_check
from exactmesh.steps.size_check import Bits, bits_of, check_sizes, limits

NAMES = ["comb 5", "turned comb", "random pslg 1", "map 1", "star 24", "partition 24", "reflex notch 1e-6", "30 digits"]


def verdict(made):
    return check_sizes(made.shape, made.offset, made.trapezoidation, made.interior, made.tube)


@pytest.mark.parametrize("name", NAMES)
def test_no_coordinate_is_longer_than_allowed(name):
    made = Run((families.ALL_SMALL | families.SMALL_PSLGS)[name]).repaired
    assert verdict(made).holds and verdict(made).instances == len(made.points)


def test_the_length_of_the_input_does_not_matter():
    bits = [bits_of(Run(families.random_simple_polygon(count, 1, "monotone")).repaired.tube.points)
            for count in (60, 600)]
    # More vertices make longer coordinates of the input, and come nearer to the worst case: no more than that.
    assert bits[1].denominator < 2 * bits[0].denominator


@pytest.mark.parametrize("part, slope, more", [
    ("offset", 8, 27), ("chords", 17, 59), ("interior", 1695, 5927), ("tube", 648, 2204)])
def test_the_bounds_are_linear_and_as_the_documents_say(part, slope, more):
    for b in (1, 36, 1000):
        assert max(getattr(limits(Bits(b, b)), part)) == slope * b + more
    assert f"{slope} b + {more}" in (Path(__file__).parents[2] / "docs" / "construction.md").read_text("utf-8")


def test_bits_are_those_of_the_longest_coordinate():
    points = [Point(mpq(-8), mpq(1, 3)), Point(mpq(5, 64), mpq(0))]
    assert bits_of(points) == (4, 7) and bits_of([]) == (1, 1)


@pytest.mark.parametrize("part", ["offset", "trapezoidation", "interior", "tube"])
def test_a_longer_coordinate_is_refused(part):
    made = Run(families.ALL_SMALL["turned comb"]).repaired
    record = getattr(made, part)
    first = record.points[0]
    for far in (Point(first.x + mpq(1, 2**100_000), first.y), Point(first.x, first.y + mpq(2) ** 100_000)):
        harmed = verdict(replace(made, **{part: replace(record, points=(far, *record.points[1:]))}))
        assert not harmed.holds and harmed.witness.clause == "coordinates are as short as their formulas"
        assert harmed.instances == harmed.witness.place["vertex"] + 1 == record.first + 1


def test_verdicts_say_all_there_is_to_say():
    with recorded("size", size_check) as lines:
        verdicts = []
        for name in NAMES:
            made = Run((families.ALL_SMALL | families.SMALL_PSLGS)[name]).repaired
            verdicts.append((name, verdict(made)))
            for part in ("offset", "trapezoidation", "interior", "tube"):
                record = getattr(made, part)
                far = Point(mpq(1, 2**200_000), mpq(0))
                harmed = replace(made, **{part: replace(record, points=(*record.points[:-1], far))})
                verdicts.append((f"{name}: {part}", verdict(harmed)))
        lines += verdicts


@pytest.mark.parametrize("part", ["offset", "trapezoidation", "interior", "tube"])
def test_the_bounds_themselves_are_allowed(part):
    made = Run(families.ALL_SMALL["turned comb"]).repaired
    most = getattr(limits(bits_of(made.shape.points)), "chords" if part == "trapezoidation" else part)
    record = getattr(made, part)
    for longer in (0, 1):
        for value in (mpq(2) ** (most.numerator - 1 + longer), mpq(1, 2 ** (most.denominator - 1 + longer))):
            far = Point(value, record.points[0].y)
            harmed = verdict(replace(made, **{part: replace(record, points=(far, *record.points[1:]))}))
            assert harmed.holds == (not longer)


@pytest.mark.parametrize("numerator, denominator, expected", [
    (100, 1, ((332, 231), (670, 568), (59300, 59189), (20177, 20066))),
    (1, 100, ((629, 627), (1264, 1261), (124046, 124034), (49976, 49964))),
    (40, 7, ((182, 147), (376, 340), (35018, 34967), (12515, 12464)))])
def test_numerators_and_denominators_count_apart(numerator, denominator, expected):
    assert limits(Bits(numerator, denominator)) == expected
