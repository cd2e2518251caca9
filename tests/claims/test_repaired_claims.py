"""The claims of the repaired construction: permanent ids, honest records, and checkers that can fail."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import pytest
from constructions import HALL, graph
from families import ALL_SMALL, comb
from gmpy2 import mpq

from exactmesh.api import mesh
from exactmesh.claims.ledger import CLAIMS, judge
from exactmesh.claims.run import Run
from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import verify_mesh
from exactmesh.repaired import Construction
from exactmesh.steps.constants import GAP, LEVEL_EDGE
from exactmesh.steps.records import Patch, Trapezoid

# Permanent: an id is never changed, and a withdrawn one is never used again.
IDS = [
    "repaired.unit", "repaired.offset-thickness", "repaired.offset-reach", "repaired.offset-separation",
    "repaired.offset-nesting", "repaired.trapezoidation", "repaired.chord-gap", "repaired.level-edge",
    "repaired.chord-leg", "repaired.chord-touch", "repaired.chord-clearance", "repaired.caps-whole",
    "repaired.edge-gap",
    "repaired.interior-tiling", "repaired.interior-feature", "repaired.tube-tiling", "repaired.tube-feature",
    "repaired.tube-feature-45",
    "repaired.steiner-count", "repaired.degradation",
    "theorem-1.triangulation", "theorem-1.feature-size", "theorem-1.degradation",
]
COMB = ALL_SMALL["turned comb"]
FLOOR = comb(3)
Harm = Callable[[Run], None]


def run(pslg: Any) -> Run:
    """Return a run with every step done."""
    done = Run(pslg)
    assert done.verification.valid
    return done


def harmed(pslg: Any, harm: Harm) -> Run:
    done = run(pslg)
    harm(done)
    return done


def broken(done: Run) -> set[str]:
    return {j.claim.id for j in judge(done) if not j.verdict.holds}


# --- the register ---


def test_ids_are_unique() -> None:
    assert len({claim.id for claim in CLAIMS}) == len(CLAIMS)


def test_ids_are_permanent() -> None:
    judged = [j.claim.id for j in judge(run(COMB))]
    assert set(IDS) <= set(judged) and [i for i in judged if i.startswith("repaired.")][:19] == IDS[:19]


@pytest.mark.parametrize("claim", CLAIMS, ids=lambda claim: claim.id)
def test_records_say_what_they_must(claim: Any) -> None:
    assert claim.says and claim.paper and claim.id == claim.id.lower() and claim.id.count(".") == 1
    assert "\n" not in claim.says + claim.bound + claim.paper
    assert (claim.check is None) or claim.runs
    if claim.check is not None and claim.quantity != "truth":
        assert claim.bound


def test_verdicts_are_told_in_order_with_progress() -> None:
    told: list[str] = []
    result = mesh(COMB, progress=told.append)
    ids = [j.claim.id for j in result.judgements]
    assert [step for step in told if step in set(ids)] == ids
    assert [step for step in told if step not in set(ids)] == [
        "validation", "offset", "trapezoidation", "interior", "tube", "verification"]


@pytest.mark.parametrize("pslg", [COMB, HALL, ALL_SMALL["triangle"]], ids=["comb", "hall", "triangle"])
def test_all_hold_on_good_runs(pslg: Any) -> None:
    for judgement in judge(run(pslg)):
        verdict = judgement.verdict
        assert verdict.holds and (verdict.instances > 0 or verdict.worst is None)
        assert (judgement.claim.quantity == "truth" or verdict.instances == 0) == (verdict.worst is None)


def test_a_claim_without_instances_holds_and_says_so() -> None:
    found = {j.claim.id: j.verdict for j in judge(run(ALL_SMALL["triangle"]))}
    assert found["repaired.chord-gap"].instances == 0 and found["repaired.chord-gap"].holds


def test_corners_of_a_rhombus_that_snap_to_one_level_are_less_than_a_cap_apart() -> None:
    found = {j.claim.id: j.verdict for j in judge(run(graph([(0, 0), (1, 2), (0, 4), (-1, 2)])))}
    edge = found["repaired.level-edge"]
    assert edge.holds and edge.worst is not None and LEVEL_EDGE**2 < edge.worst < GAP**2 / 2


# --- harm ---


def rebuild(change: Callable[[Construction], Construction]) -> Harm:
    """Return a harm to the records of the steps alone."""
    def harm(done: Run) -> None:
        vars(done)["repaired"] = change(done.repaired)
    return harm


def part(name: str, **fields: Callable[[Any], Any]) -> Harm:
    """Return a harm to fields of one record."""
    def change(made: Construction) -> Construction:
        record = getattr(made, name)
        return replace(made, **{name: replace(record, **{f: to(getattr(record, f)) for f, to in fields.items()})})
    return rebuild(change)


def verified(**fields: Callable[[Any], Any]) -> Harm:
    """Return a harm to the verification alone."""
    def harm(done: Run) -> None:
        old = done.verification
        vars(done)["verification"] = replace(old, **{f: to(getattr(old, f)) for f, to in fields.items()})
    return harm


def without_a_face(done: Run) -> None:
    """Leave a face out of the mesh, and verify what is left."""
    made = done.repaired
    mesh_left = replace(made.mesh, faces=made.mesh.faces[1:])
    vars(done)["verification"] = verify_mesh(done.subdivision, mesh_left)


def moved(points: tuple[Point, ...], k: int, dx: Any, dy: Any) -> tuple[Point, ...]:
    p = points[k]
    return (*points[:k], Point(p.x + mpq(dx), p.y + mpq(dy)), *points[k + 1:])


def near(points: tuple[Point, ...], k: int, other: int) -> tuple[Point, ...]:
    """Move point k to a thousandth of its distance from another one."""
    p, q = points[k], points[other]
    return (*points[:k], Point(q.x + (p.x - q.x) / 1000, q.y + (p.y - q.y) / 1000), *points[k + 1:])


def needless_chord(done: Run) -> None:
    """Cut the one trapezoid of a rectangle by a chord without a vertex of Q."""
    made = done.repaired
    (z,) = made.trapezoidation.trapezoids
    low, high = made.points[z.bl], made.points[z.tr]
    first, y = made.trapezoidation.first, low.y + mpq(29, 125)
    cut = (Trapezoid(z.low, z.low + 1, z.left, z.right, z.bl, z.br, first + 1, first, z.bottom, ()),
           Trapezoid(z.low + 1, z.high, z.left, z.right, first, first + 1, z.tr, z.tl, (), z.top))
    chords = replace(made.trapezoidation, points=(Point(low.x, y), Point(high.x, y)), edge=(z.left, z.right),
                     trapezoids=cut)
    vars(done)["repaired"] = replace(made, trapezoidation=chords)


def t_vertex_at(share: Any) -> Harm:
    """Return a harm that moves a T-vertex along its side towards the left corner."""
    def change(made: Construction) -> Construction:
        z = next(z for z in made.trapezoidation.trapezoids if z.top or z.bottom)
        side, corner = (z.top, z.tl) if z.top else (z.bottom, z.bl)
        p, q = made.points[side[0]], made.points[corner]
        k = side[0] - made.offset.first
        points = moved(made.offset.points, k, (q.x - p.x) * (1 - mpq(share)), 0)
        return replace(made, offset=replace(made.offset, points=points))
    return rebuild(change)


def close_t_vertices(done: Run, joined: bool = False) -> None:
    """Move a T-vertex next to another vertex of Q on its side, one that an edge of Q joins to it or not."""
    made = done.repaired
    following = made.offset.successors()
    q = range(made.offset.first, made.trapezoidation.first)
    for z in made.trapezoidation.trapezoids:
        for row in ((z.bl, *z.bottom, z.br), (z.tl, *z.top, z.tr)):
            for u, v in pairwise(row):
                if len(row) > 2 and u in q and v in q:
                    k = (u if u in row[1:-1] else v) - made.offset.first
                    other = (v if u in row[1:-1] else u) - made.offset.first
                    if joined is not (following[k] == other or following[other] == k):
                        continue
                    points = near(made.offset.points, k, other)
                    vars(done)["repaired"] = replace(made, offset=replace(made.offset, points=points))
                    return
    raise AssertionError("no two vertices of Q on one side with a T-vertex")


def chord_end_near_an_end(made: Construction) -> Construction:
    chords, k = made.trapezoidation, made.trapezoidation.edge[0]
    a, p = made.offset.points[k], chords.points[0]
    there = Point(a.x + (p.x - a.x) / 1000, a.y + (p.y - a.y) / 1000)
    return replace(made, trapezoidation=replace(chords, points=(there, *chords.points[1:])))


def on_a_cap(made: Construction) -> Construction:
    cap = made.offset.source.index(-1)
    return replace(made, interior=replace(made.interior, on_edge=((cap, made.interior.first),)))


def flat_face(name: str) -> Harm:
    """Return a harm that moves a new vertex of a patch next to another vertex of one of its faces."""
    def change(made: Construction) -> Construction:
        patch: Patch = getattr(made, name)
        v = patch.first
        other = next(w for face in patch.faces if v in face for w in face if w != v)
        p, q = made.points[v], made.points[other]
        there = Point(q.x + (p.x - q.x) / 1000, q.y + (p.y - q.y) / 1000)
        return replace(made, **{name: replace(patch, points=(there, *patch.points[1:]))})
    return rebuild(change)


def degraded(squared: Any) -> Harm:
    def harm(done: Run) -> None:
        vars(done)["verification"] = replace(
            done.verification, mesh_mfs=Nearest(done.mfs.squared / mpq(squared), 0, (1, 2)))
    return harm


RECTANGLE = graph([(0, 0), (9, 0), (9, 4), (0, 4)])
HARMS: list[tuple[Any, Harm, str]] = [
    (COMB, part("shape", unit=lambda unit: unit * 2), "repaired.unit"),
    (COMB, part("offset", points=lambda points: moved(points, 0, 0, -1)), "repaired.offset-thickness"),
    (COMB, part("offset", points=lambda points: moved(points, 0, 1, 1)), "repaired.offset-reach"),
    (COMB, part("offset", points=lambda points: near(points, 0, 1)), "repaired.offset-separation"),
    (COMB, part("offset", points=lambda points: moved(points, 0, 0, "1/1000")), "repaired.offset-nesting"),
    (COMB, part("trapezoidation", trapezoids=lambda zs: zs[1:]), "repaired.trapezoidation"),
    (FLOOR, close_t_vertices, "repaired.chord-gap"),
    (HALL, partial(close_t_vertices, joined=True), "repaired.level-edge"),
    (HALL, t_vertex_at("1/1000"), "repaired.chord-leg"),
    (RECTANGLE, needless_chord, "repaired.chord-touch"),
    (COMB, rebuild(chord_end_near_an_end), "repaired.chord-clearance"),
    (COMB, rebuild(on_a_cap), "repaired.caps-whole"),
    (COMB, rebuild(chord_end_near_an_end), "repaired.edge-gap"),
    (COMB, part("interior", faces=lambda faces: faces[1:]), "repaired.interior-tiling"),
    (COMB, flat_face("interior"), "repaired.interior-feature"),
    (COMB, part("tube", faces=lambda faces: (*faces, faces[0])), "repaired.tube-tiling"),
    (COMB, flat_face("tube"), "repaired.tube-feature"),
    (COMB, flat_face("tube"), "repaired.tube-feature-45"),
    (COMB, verified(steiner=lambda _: 35 * 11 + 1), "repaired.steiner-count"),
    (COMB, degraded(mpq(108, 5) ** 2 + mpq(1, 10**30)), "repaired.degradation"),
    (COMB, without_a_face, "theorem-1.triangulation"),
    (COMB, degraded(2067), "theorem-1.feature-size"),
    (COMB, degraded(2025), "theorem-1.degradation"),
]


@pytest.mark.parametrize("pslg, harm, claim", HARMS, ids=[claim for _, _, claim in HARMS])
def test_every_claim_can_fail(pslg: Any, harm: Harm, claim: str) -> None:
    done = harmed(pslg, harm)
    assert claim in broken(done)
    verdict = next(j.verdict for j in judge(done) if j.claim.id == claim)
    assert verdict.witness is not None and verdict.witness.clause


def test_every_claim_is_harmed() -> None:
    assert [claim for _, _, claim in HARMS] == IDS
