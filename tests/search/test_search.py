"""Scores, moves, shrinking, plug-ins and the check of finds."""

import random
import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.claims.ledger import CLAIMS
from exactmesh.errors import InputError
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar.faces import domain_of
from exactmesh.search.collect import find_json
from exactmesh.search.corners import is_simple
from exactmesh.search.families import family_of, planar_sample
from exactmesh.search.figure import Figure, is_planar, normal_form
from exactmesh.search.moves import climb, move
from exactmesh.search.recheck import Checker, checked
from exactmesh.search.shrink import shrink
from exactmesh.search.small_mfs import small_mfs_squared
from exactmesh.search.spec import Spec
from exactmesh.search.targets import Evaluation, target_of
from exactmesh.search.work import run_task

LONG_ROOM = Figure.polygon(((0, 0), (1, 0), (17, 0), (17, 1), (0, 1)))
BOW_TIE = Figure.polygon(((0, 0), (2, 2), (2, 0), (0, 2)))
CORNER = st.tuples(st.integers(-9, 9), st.integers(-9, 9))


def sample(name: str, seed: int = 0, **parameters: int) -> Figure:
    figure = planar_sample(family_of(name, parameters), random.Random(seed))
    assert figure is not None
    return figure


@given(st.lists(CORNER, min_size=3, max_size=8, unique=True))
@settings(max_examples=300, derandomize=True)
def test_small_mfs_and_simplicity_agree_with_the_product(corners: list[tuple[int, int]]) -> None:
    pslg = Figure.polygon(corners).pslg()
    try:
        domain_of(pslg)
        valid = True
    except InputError:
        valid = False
    assert is_simple(corners) == valid
    if valid:
        nearest = minimum_feature_size(pslg)
        assert nearest is not None and small_mfs_squared(corners) == nearest.squared


def test_moves_keep_polygons_simple_and_climbing_gets_worse() -> None:
    source = random.Random(1)
    seen: list[Evaluation] = []
    target = target_of("degradation", "paper")

    def see(figure: Figure) -> Evaluation:
        assert figure.is_polygon and is_simple(figure.points)
        seen.append(evaluation := target.evaluate(figure.pslg()))
        return evaluation

    start = sample("stretched", 3)
    end = target.evaluate(climb(start, see, 60, source).pslg())
    assert not any(one.is_worse_than(end) for one in seen)
    assert move(Figure.polygon(((0, 0), (1, 0), (0, 1))), source) is not None


def test_moves_of_other_figures_stay_planar_and_reach_everything() -> None:
    source = random.Random(2)
    shapes = set()
    figure = normal_form(sample("holes", 1, columns=1, rows=1))
    for _ in range(300):
        there = move(figure, source)
        assert there is not None and is_planar(there) and there == normal_form(there)
        degree = [sum(v in edge for edge in there.edges) for v in range(len(there.points))]
        shapes |= {("holes", len(there.holes))} | {("degree", d) for d in degree}
        figure = there if not there.is_polygon and len(there.edges) > 5 else figure
    assert shapes >= {("degree", 0), ("degree", 1), ("degree", 2), ("degree", 3), ("holes", 0), ("holes", 1)}


def test_shrinking_keeps_the_property_and_gets_to_the_bottom() -> None:
    start = Figure.polygon([(7 * x + 3, 5 * y) for x, y in LONG_ROOM.points])
    assert len(shrink(start, lambda figure: True).points) == 3
    wide = shrink(start, lambda figure: max(x for x, _ in figure.points) >= 10)
    assert max(x for x, _ in wide.points) == 10 and len(wide.points) == 3
    assert shrink(start, lambda figure: figure == start) == start


def test_shrinking_drops_what_a_domain_does_not_need() -> None:
    start = sample("pslg", 4, cells=2)
    assert not start.is_polygon and len(start.points) > 12
    with_hole = shrink(start, lambda figure: bool(figure.holes) and len(figure.points) >= 5)
    assert len(with_hole.points) == 5 and len(with_hole.edges) <= 3 and len(with_hole.holes) == 1
    ring = shrink(start, lambda figure: len(figure.edges) >= 3 and len(figure.points) >= 3)
    assert ring.is_polygon and len(ring.points) == 3  # a cycle is a polygon again


def test_a_score_is_exact_and_the_direction_is_the_claims() -> None:
    evaluation = target_of("theorem-1.degradation", "paper").evaluate(LONG_ROOM.pslg())
    assert (evaluation.outcome, str(evaluation.value), evaluation.direction) == ("violated", "480649/225", 1)
    assert target_of("appendix-a.offset-edge-length").direction == -1
    # What is no planar graph is skipped, never scored; so is what the construction is not for.
    assert target_of("degradation").evaluate(BOW_TIE.pslg()).outcome == "skipped"
    assert target_of("degradation", "paper").evaluate(sample("holes").pslg()).outcome == "skipped"
    assert target_of("degradation", "repaired").evaluate(sample("holes").pslg()).outcome == "holds"


def test_the_check_agrees_in_a_fresh_process_and_refuses_a_harmed_find() -> None:
    find = find_json(target_of("theorem-1.degradation", "paper"), LONG_ROOM, "violation")
    with Checker() as checker:
        answer = checker.check(find)
        assert answer.agrees and answer.says.startswith("stand-alone checker")
        answer = checker.check({**find, "target": ["no such claim", "paper", "nonproper"]})
        assert not answer.agrees and "no such claim" in answer.says
        assert checker.check(find).agrees  # it goes on after a failure
        assert checker._process is not None
        checker._process.kill()
        assert "died" in checker.check(find).says
        assert checker.check(find).agrees  # and is started anew
    assert "not 7" in checked({**find, "exact": "7"}).says
    assert "outcome" in checked({**find, "outcome": "holds"}).says
    assert "planar" in checked({**find, "figure": BOW_TIE.to_json()}).says


@pytest.mark.parametrize(("claim", "word"), [
    ("theorem-1.triangulation", "stand-alone checker"), ("section-2.p5-feature-size", "second implementation"),
    ("section-2.p3-separation", "claim checker")])
def test_a_find_says_who_confirms_it(claim: str, word: str) -> None:
    answer = checked(find_json(target_of(claim, "paper"), LONG_ROOM, "record"))
    assert answer.agrees and answer.says.startswith(word)


@pytest.mark.parametrize(("strategy", "family", "parameters"), [
    ("random", "flat", ()), ("climb", "triangle", ()), ("anneal", "tour", (("n", 4),)), ("guided", "star", ()),
    ("exhaustive", "lattice", (("m", 3), ("n", 3)))])
def test_a_task_repeats_itself(strategy: str, family: str, parameters: tuple[tuple[str, int], ...]) -> None:
    spec = Spec((("section-2.p5-feature-size", "paper", "nonproper"),), strategy, family,  # type: ignore[arg-type]
                parameters, seed=5, size=8).checked()
    key = "3:18" if strategy == "exhaustive" else "2"
    assert Spec.from_json(spec.to_json()) == spec
    assert run_task(spec.to_json(), key) == run_task(spec.to_json(), key)


@pytest.mark.parametrize("family", ["holes", "segments"])
def test_a_task_on_other_domains_repeats_itself(family: str) -> None:
    spec = Spec((("degradation", "repaired", "nonproper"),), "anneal", family, seed=5, size=6).checked()
    report = run_task(spec.to_json(), "1")
    assert report == run_task(spec.to_json(), "1") and int(str(report["evaluated"])) > 1


def test_plug_ins_and_refusals() -> None:
    text = "def thin(source, k=3):\n    return [(0, 0), (source.randint(5, 9), 0), ('1/2', k)]\n"
    drawn = planar_sample(family_of("thin", {"k": 2}, text), random.Random(0))
    assert drawn is not None and drawn.points[2] == (1, 4)
    with pytest.raises(InputError, match="no function"):
        family_of("thick", {}, text)
    with pytest.raises(InputError, match="cannot be run"):
        family_of("thin", {}, "import nothing_of_that_name")
    with pytest.raises(InputError, match="no parameter"):
        family_of("star", {"k": 1})
    for family, parameters, says in (
            ("growth", {"n": 2}, "at least 3 vertices"), ("tour", {"n": 9, "size": 1}, "no 9"),
            ("segments", {"points": 9, "size": 2}, "no 9"), ("comb", {"spacing": 9}, "up to 3"),
            ("wrong", {}, "cannot be drawn: ZeroDivisionError")):
        plugin = "def wrong(source):\n    return 1 / 0\n" if family == "wrong" else ""
        with pytest.raises(InputError, match=says):
            family_of(family, parameters, plugin)(random.Random(0))
    with pytest.raises(InputError, match="no family"):
        family_of("cube", {})
    with pytest.raises(InputError, match="no search can settle"):
        target_of(next(claim.id for claim in CLAIMS if claim.check is None))
    with pytest.raises(InputError, match="is judged in runs"):
        target_of("repaired.degradation", "paper")
    with pytest.raises(InputError, match="not of simple polygons"):
        Spec((("section-2.p5-feature-size", "paper", "nonproper"),), "random", "holes").checked()


def test_guided_says_what_is_missing(tmp_path: Path) -> None:
    code = ("import sys; sys.modules['hypothesis'] = None\nfrom exactmesh.cli import main\n"
            "sys.exit(main(['search', 'degradation', '--strategy', 'guided', '--store', sys.argv[1]]))")
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path / "s.db")], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 2 and "pip install hypothesis" in done.stderr
