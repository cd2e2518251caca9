"""Scores, moves, shrinking, families and the check of finds."""

import random
import subprocess
import sys
import time
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.claims.ledger import CLAIMS
from exactmesh.errors import InputError
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.search.collect import Collector, find_json
from exactmesh.search.corners import Corners, corners_of, is_simple, pslg_of
from exactmesh.search.families import FAMILIES, family_of, simple_sample
from exactmesh.search.moves import climb, move
from exactmesh.search.recheck import disagreement, plain_mfs_squared, recheck
from exactmesh.search.shrink import shrink
from exactmesh.search.small_mfs import small_mfs_squared
from exactmesh.search.spec import Spec
from exactmesh.search.targets import target_of
from exactmesh.search.work import run_task

LONG_ROOM: Corners = ((0, 0), (1, 0), (17, 0), (17, 1), (0, 1))
CORNER = st.tuples(st.integers(-9, 9), st.integers(-9, 9))


def sample(name: str, seed: int = 0, **parameters: int) -> Corners:
    polygon = simple_sample(family_of(name, parameters), random.Random(seed))
    assert polygon is not None
    return polygon


@given(st.lists(CORNER, min_size=3, max_size=8, unique=True))
@settings(max_examples=300, derandomize=True)
def test_small_mfs_and_simplicity_agree_with_the_product(corners: list[tuple[int, int]]) -> None:
    from exactmesh.planar.faces import domain_of

    try:
        domain_of(pslg_of(corners))
        valid = True
    except InputError:
        valid = False
    assert is_simple(corners) == valid
    if valid:
        nearest = minimum_feature_size(pslg_of(corners))
        assert nearest is not None and small_mfs_squared(corners) == nearest.squared


@pytest.mark.parametrize("name", FAMILIES)
def test_families_give_simple_polygons_and_repeat_themselves(name: str) -> None:
    for seed in range(20):
        polygon = sample(name, seed)
        nearest = minimum_feature_size(pslg_of(polygon))
        assert polygon == sample(name, seed) and is_simple(polygon)
        assert nearest is not None and small_mfs_squared(polygon) == nearest.squared


def test_speed_of_exact_scores() -> None:
    polygons = [sample("star", seed, n=12) for seed in range(100)]
    start = time.process_time()
    for polygon in polygons:
        small_mfs_squared(polygon)
    assert len(polygons) / (time.process_time() - start) > 2000
    collector = Collector([target_of("repaired.degradation")])
    start = time.process_time()
    for seed in range(30):
        collector.see(sample("star", seed, n=8))
    assert 30 / (time.process_time() - start) > 50


def test_moves_keep_polygons_simple_and_climbing_gets_worse() -> None:
    source, seen = random.Random(1), []
    target = target_of("degradation", "paper")

    def see(polygon: Corners) -> object:
        assert is_simple(polygon)
        seen.append(evaluation := target.evaluate(pslg_of(polygon)))
        return evaluation

    start = sample("stretched", 3)
    end = climb(start, see, 60, source)  # type: ignore[arg-type]
    assert not seen[0].is_worse_than(target.evaluate(pslg_of(end)))
    assert not any(one.is_worse_than(target.evaluate(pslg_of(end))) for one in seen)
    assert move(((0, 0), (1, 0), (0, 1)), source) is not None


def test_shrinking_keeps_the_property_and_gets_to_the_bottom() -> None:
    start = tuple((7 * x + 3, 5 * y) for x, y in LONG_ROOM)
    assert shrink(start, lambda polygon: True) == ((0, 0), (0, 1), (1, 0)) or len(shrink(start, lambda p: True)) == 3
    wide = shrink(start, lambda polygon: max(x for x, _ in polygon) >= 10)
    assert max(x for x, _ in wide) == 10 and len(wide) == 3
    assert shrink(start, lambda polygon: polygon == start) == start


def test_a_score_is_exact_and_the_direction_is_the_claims() -> None:
    evaluation = target_of("theorem-1.degradation", "paper").evaluate(pslg_of(LONG_ROOM))
    assert (evaluation.outcome, str(evaluation.value), evaluation.direction) == ("violated", "480649/225", 1)
    assert target_of("appendix-a.offset-edge-length").direction == -1
    # A polygon that is none is skipped, never scored.
    assert target_of("degradation").evaluate(pslg_of(((0, 0), (2, 2), (2, 0), (0, 2)))).outcome == "skipped"


def test_the_check_agrees_in_a_fresh_process_and_refuses_a_harmed_find() -> None:
    find = find_json(target_of("theorem-1.degradation", "paper"), LONG_ROOM, "violation")
    agrees, says = recheck(find)
    assert agrees and "stand-alone checker" in says
    assert "not 7" in disagreement({**find, "exact": "7"})
    assert "outcome" in disagreement({**find, "outcome": "holds"})
    assert "simple" in disagreement({**find, "corners": [[0, 0], [2, 2], [2, 0], [0, 2]]})
    agrees, says = recheck({**find, "target": ["no such claim", "paper", "nonproper"]})
    assert not agrees and "no such claim" in says


def test_the_plain_definition() -> None:
    assert plain_mfs_squared([(0, 0), (4, 0), (0, 3)], [(0, 1), (1, 2), (2, 0)]) * 25 == 144  # type: ignore[list-item]


@pytest.mark.parametrize(("strategy", "family", "parameters"), [
    ("random", "flat", ()), ("climb", "triangle", ()), ("anneal", "tour", (("n", 4),)), ("guided", "star", ()),
    ("exhaustive", "lattice", (("m", 3), ("n", 3)))])
def test_a_task_repeats_itself(strategy: str, family: str, parameters: tuple[tuple[str, int], ...]) -> None:
    spec = Spec((("section-2.p5-feature-size", "paper", "nonproper"),), strategy, family,  # type: ignore[arg-type]
                parameters, seed=5, size=8).checked()
    key = "3:18" if strategy == "exhaustive" else "2"
    assert Spec.from_json(spec.to_json()) == spec
    assert run_task(spec.to_json(), key) == run_task(spec.to_json(), key)


def test_plug_ins_and_refusals() -> None:
    text = "def thin(source, k=3):\n    return [(0, 0), (source.randint(5, 9), 0), ('1/2', k)]\n"
    assert simple_sample(family_of("thin", {"k": 2}, text), random.Random(0))[2] == (1, 4)  # type: ignore[index]
    with pytest.raises(InputError, match="no function"):
        family_of("thick", {}, text)
    with pytest.raises(InputError, match="cannot be run"):
        family_of("thin", {}, "import nothing_of_that_name")
    with pytest.raises(InputError, match="no parameter"):
        family_of("star", {"k": 1})
    with pytest.raises(InputError, match="no family"):
        family_of("cube", {})
    with pytest.raises(InputError, match="no search can settle"):
        target_of(next(claim.id for claim in CLAIMS if claim.check is None))
    with pytest.raises(InputError, match="is judged in runs"):
        target_of("repaired.degradation", "paper")


def test_guided_says_what_is_missing(tmp_path: Path) -> None:
    code = ("import sys; sys.modules['hypothesis'] = None\nfrom exactmesh.cli import main\n"
            "sys.exit(main(['search', 'degradation', '--strategy', 'guided', '--store', sys.argv[1]]))")
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path / "s.db")], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 2 and "pip install hypothesis" in done.stderr


def test_points_are_scaled_to_integers() -> None:
    assert corners_of([("1/2", 0), (1, "1/3"), (0, 1)]) == ((3, 0), (6, 2), (0, 6))
