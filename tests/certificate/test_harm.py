"""A small campaign of harm, what does no harm, and that the judge of the campaign sees what is false."""

import copy
from collections.abc import Sequence
from pathlib import Path

import pytest
from campaign import fault, harmed_triples, run
from checkers import COMPILER, ByC, build, by_python
from harm import ALWAYS_WRONG, HARMS, KEEPS_HASHES, harmed
from triples import BASES, base, harmless, truth


def test_there_are_many_kinds_of_harm() -> None:
    assert len(HARMS) >= 25
    assert (ALWAYS_WRONG | KEEPS_HASHES).issubset(HARMS)
    applied = {kind for kind in HARMS for name in list(BASES) if harmed(name, kind, 0) is not None}
    assert applied == set(HARMS)


def test_a_campaign_finds_no_fault(tmp_path: Path) -> None:
    checkers = [by_python]
    by_c = ByC(build(tmp_path)) if COMPILER else None
    faults, table = run(2026, 450, [*checkers, by_c] if by_c else checkers)
    if by_c:
        by_c.close()
    assert faults == []
    assert "450 harmed of" in table and "all true" in table


def test_a_campaign_is_the_same_for_the_same_seed() -> None:
    first, second, other = (list(harmed_triples(seed, 95)) for seed in (5, 5, 6))
    assert first == second != other


@pytest.mark.parametrize("name", BASES)
def test_what_does_no_harm_is_accepted_and_true(name: str) -> None:
    for seed in (1, 2):
        files = harmless(name, seed)
        status, line = by_python(files)
        assert status == 0, line
        assert truth(files) == ""


def test_the_truth_is_seen_without_the_checkers() -> None:
    for name in ("square", "ring with a hole", "map, classic", "two points"):
        assert truth(base(name).files()) == ""
    for kind, word in (
            ("bound forged by one in the last place", "mfs_squared_at_least"), ("hash changed", "hashes"),
            ("degradation forged by one in the last place", "degradation_squared_at_most"),
            ("feature size of the input forged", "input_mfs_squared_at_most"),
            ("decimal forged by one in the last place", "_at_"), ("face turned around", ""),
            ("several faces of the mesh dropped", "invalid"), ("edge of the input doubled", "refused"),
            ("hole point added outside", "refused"), ("all mirrored: faces clockwise", "invalid")):
        found = [files for seed in range(6) if (files := harmed("two points", kind, seed)) is not None]
        verdicts = [truth(files) for files in found]
        assert any(verdicts) and all(word in verdict for verdict in verdicts if verdict), (kind, verdicts)


def test_the_campaign_would_tell_faults() -> None:
    good = base("square").files()
    line = by_python(good)
    assert fault("same number spelt otherwise", good, [line, line]) == ""
    assert "differ" in fault("face dropped", good, [line, (1, "INVALID x: y")])
    assert "always wrong" in fault("face doubled", good, [line])
    assert "no verdict" in fault("face dropped", good, [(0, "INVALID x: y")])
    assert "no verdict" in fault("face dropped", good, [(3, "Traceback")])

    def accepts_all(files: Sequence[bytes]) -> tuple[int, str]:
        return 0, "VALID"

    def crashes(files: Sequence[bytes]) -> tuple[int, str]:
        raise RecursionError("too deep")

    faults, table = run(1, 60, [accepts_all])
    assert len(faults) > 30 and "FAULTS" in table
    assert len(run(1, 5, [crashes])[0]) == 5


def test_faults_are_kept(tmp_path: Path) -> None:
    faults, _ = run(3, 3, [lambda files: (3, "")], tmp_path)
    assert len(faults) == 3 and len(list(tmp_path.iterdir())) == 9


def test_bases_are_left_alone_by_harm() -> None:
    before = copy.deepcopy(base("star"))
    for kind in HARMS:
        harmed("star", kind, 1)
    after = base("star")
    assert (before.pslg, before.mesh) == (after.pslg, after.mesh)
