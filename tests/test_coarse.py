"""The coarse construction: what it is designed for holds on inputs of many kinds, and what breaks it is on record."""

from functools import cache
from pathlib import Path

import families
import pytest
from constructions import HALL
from gmpy2 import mpq

import exactmesh
from exactmesh.claims.claim import Judgement
from exactmesh.claims.coarse import COARSE_CLAIMS
from exactmesh.claims.ledger import CLAIMS, claim_by_id
from exactmesh.claims.repaired import REPAIRED_CLAIMS
from exactmesh.cli import main
from exactmesh.geometry.point import Point
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.measure.verdict import Verdict
from exactmesh.planar.pslg import Pslg
from exactmesh.search.targets import target_of
from exactmesh.steps.balance import COARSE, COARSE_DEGRADATION

# Isolated points in slanted boxes: what searches found, made as small as it would go.
_FIVE = ((3507500, 133441), (3700000, -83284), (3950000, -70784), (4900000, -23284), (5175000, -9534))
_FIVE_BOX = ((-500000, -2619434), (15150000, -2619434), (90150000, 1572266), (-500000, 1572266))
_SEVEN = ((37500000, -542013), (38500000, -552013), (52560000, -692613), (53565000, -702663), (54565000, -712663),
          (56065000, -191563), (56570000, -196613))
_SEVEN_BOX = ((-151000000, 445237), (272670000, 445237), (420170000, -3587013), (-1000000, -3587013))
BREAKS = {len(points): Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in points + box),
                            tuple((len(points) + i, len(points) + (i + 1) % 4) for i in range(4)))
          for points, box in ((_FIVE, _FIVE_BOX), (_SEVEN, _SEVEN_BOX))}

INPUTS = {
    "hall": HALL,
    "comb": families.comb(12, floor=400),
    "uneven comb": families.comb(6, spacing="doubling"),
    "staircase": families.staircase(7),
    "spike": families.convex_spike(),
    "notch": families.reflex_notch(),
    "midway": families.rectangle_with_two_midway_vertices(1000),
    "ledges": families.spike_with_ledges(5, 3),
    "slits": families.slits(4, 2),
    "tree": families.boxed_tree(4, 3, 1),
    "map": families.grid_map(3, 3, 2),
    "holes": families.polygon_with_holes(2, 1, 5),
    "growth": families.random_simple_polygon(40, 8),
}


def failing(judgements: tuple[Judgement, ...]) -> set[str]:
    return {judgement.claim.id for judgement in judgements if not judgement.verdict.holds}


@pytest.mark.parametrize("name", INPUTS)
def test_every_claim_holds(name: str) -> None:
    made = exactmesh.mesh(INPUTS[name], "coarse")
    assert {judgement.claim for judgement in made.judgements} == set(COARSE_CLAIMS)
    assert failing(made.judgements) == set() and made.verification.valid
    squared = made.verification.degradation_squared
    assert squared is not None and squared <= COARSE_DEGRADATION**2


def test_the_usual_construction_is_worse_where_slabs_are_thin() -> None:
    usual, coarse = (exactmesh.mesh(INPUTS["comb"], name).verification.degradation_squared
                     for name in ("repaired", "coarse"))
    assert usual is not None and coarse is not None
    assert coarse <= COARSE_DEGRADATION**2 < mpq(21) ** 2 < usual


@cache
def broken(points: int) -> exactmesh.Meshing:
    return exactmesh.mesh(BREAKS[points], "coarse")


@pytest.mark.parametrize("points", BREAKS)
def test_a_few_points_break_it(points: int) -> None:
    """Vertices of Q on three levels, sparse, below one empty chord: nested triangles have one base height only."""
    made = broken(points)
    assert made.verification.valid
    assert failing(made.judgements) == {"coarse.interior-feature", "coarse.degradation"}
    squared = made.verification.degradation_squared
    assert squared is not None and squared > COARSE_DEGRADATION**2
    # The break is in regions that find no better cluster: no face keeps less than thin trapezoids do by themselves.
    feature = next(one.verdict.worst for one in made.judgements if one.claim.id == "coarse.interior-feature")
    assert (COARSE.level / 5) ** 2 <= feature < COARSE.feature_squared
    assert exactmesh.mesh(BREAKS[points]).holds


def test_its_claims_are_those_of_the_repaired_one_and_no_part_of_the_ledger() -> None:
    names = {claim.id.removeprefix("coarse.") for claim in COARSE_CLAIMS}
    left_out = {claim.id for claim in REPAIRED_CLAIMS if claim.id.removeprefix("repaired.") not in names}
    # What is for other kinds, what is proved of the usual balance, and caps, on whose edges chords end here.
    assert {claim_by_id(name).id for name in left_out if "nonproper" in claim_by_id(name).kinds} <= {
        "repaired.caps-whole", "repaired.tube-feature-45", "repaired.proper-degradation",
        "repaired.proper-degradation-22"}
    assert not {claim.id for claim in CLAIMS} & {claim.id for claim in COARSE_CLAIMS}
    assert claim_by_id("coarse.degradation") in COARSE_CLAIMS


@pytest.mark.parametrize("name", ["interior-feature", "degradation", "offset-reach"])
def test_a_bound_of_its_own_is_what_decides(name: str) -> None:
    target = target_of(f"coarse.{name}", "coarse")
    run = broken(5).run
    own, usual = target.claim.check, claim_by_id(f"repaired.{name}").check
    assert own is not None and usual is not None
    verdict, other = own(run), usual(run)
    assert verdict.worst == other.worst and isinstance(verdict, Verdict)
    assert verdict.holds == (name == "offset-reach")
    assert verdict.witness is not None and other.witness is not None
    assert verdict.witness.place == other.witness.place and verdict.witness.clause != other.witness.clause


@pytest.mark.parametrize("kind", ["proper", "internal", "classic"])
def test_other_kinds_are_refused(kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "room.json"
    path.write_text(json_from_pslg(INPUTS["staircase"]))
    assert main(["mesh", str(path), "--construction", "coarse", "--kind", kind]) == 2
    assert capsys.readouterr().err == f"exactmesh: the coarse construction makes nonproper meshes, not {kind} ones\n"


def test_the_command_checks_and_certifies(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    room, mesh, certificate = (str(tmp_path / name) for name in ("room.json", "mesh.json", "certificate.json"))
    Path(room).write_text(json_from_pslg(INPUTS["comb"]))
    assert main(["mesh", room, "--construction", "coarse", "-o", mesh, "--certificate", certificate, "--quiet"]) == 0
    assert main(["check", room, mesh, certificate]) == 0
    assert main(["plot", room, "--construction", "coarse", "--step", "interior", "-o", str(tmp_path / "a.svg")]) == 0
    Path(room).write_text(json_from_pslg(BREAKS[5]))
    assert main(["mesh", room, "--construction", "coarse", "--quiet"]) == 1
    assert "coarse.degradation fails" in capsys.readouterr().err
    assert main(["mesh", room, "--construction", "coarse", "--optimize"]) == 2
