"""The repaired construction end to end: every claim on every family, the oracle, and what must not matter."""

import random
from fractions import Fraction

import families
import oracle
import pytest
from constructions import HALL, made_of
from gmpy2 import mpq

from exactmesh.api import Meshing, mesh, verify
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.constants import DESIGN_DEGRADATION, LEVEL

SMALL = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": HALL}
EVERYTHING = SMALL | {f"issue: {name}": pslg for name, pslg in families.issue_list().items()}
# Inputs for the laws: one of each family, holes, trees, isolated points, feet, T-vertices, ties.
CHOSEN = ["triangle with vertices on its sides", "unit square", "midway 100", "comb 5", "comb 8 doubling", "spike room",
          "l-shape 44", "convex spike 1e-6", "reflex notch 1e-2", "sliver with bends", "star 12", "staircase",
          "grid 24", "growth 24", "monotone 24", "partition 24", "two-opt 9", "two-opt 24", "turned comb",
          "random pslg 1", "random pslg 4", "random pslg 7", "map 0", "square and two points", "hall"]
# The oracle looks at all pairs; on more faces it takes seconds.
FACES_FOR_THE_ORACLE = 330


def broken(result: Meshing) -> list[str]:
    """Return the ids of the claims that fail, with their witnesses."""
    return [f"{j.claim.id}: {j.verdict.witness}" for j in result.judgements if not j.verdict.holds]


def degradation_squared(pslg: Pslg) -> mpq:
    """Return the squared degradation of the mesh of `pslg`, on which every claim holds."""
    result = mesh(pslg)
    assert broken(result) == []
    assert result.verification.degradation_squared is not None
    return result.verification.degradation_squared


def relabelled(pslg: Pslg, seed: int) -> Pslg:
    """Return `pslg` with vertices, edges and the ends of edges in random order."""
    source = random.Random(seed)
    order = list(range(len(pslg.vertices)))
    source.shuffle(order)
    new = {old: i for i, old in enumerate(order)}
    edges = [(new[u], new[v]) if source.random() < 0.5 else (new[v], new[u]) for u, v in pslg.edges]
    source.shuffle(edges)
    return Pslg(tuple(pslg.vertices[old] for old in order), tuple(edges), pslg.holes)


# --- every claim on every family ---


@pytest.mark.parametrize("name", EVERYTHING)
def test_every_claim_holds(name: str) -> None:
    pslg = EVERYTHING[name]
    result = mesh(pslg)
    assert broken(result) == [] and result.holds
    verification = verify(pslg, result.mesh)
    assert verification == result.verification
    assert verification.valid and verification.kind == "nonproper"
    assert verification.degradation_squared <= DESIGN_DEGRADATION**2 == mpq(108, 5) ** 2


def test_the_oracle_agrees_on_validity_and_degradation() -> None:
    compared = 0
    for name, pslg in SMALL.items():
        result = mesh(pslg)
        if len(result.mesh.faces) > FACES_FOR_THE_ORACLE:
            continue
        places, faces = result.mesh.vertices, result.mesh.faces
        assert oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, places, faces, "nonproper") == [], name
        squared = oracle.degradation_squared(pslg.vertices, pslg.edges, places, faces)
        assert squared == oracle.exact(result.verification.degradation_squared), name
        compared += 1
    assert compared >= 60


@pytest.mark.parametrize("name", CHOSEN)
def test_the_input_is_kept_and_nothing_is_put_on_its_edges(name: str) -> None:
    pslg = SMALL[name]
    made = mesh(pslg).mesh
    assert made.vertices[: len(pslg.vertices)] == pslg.vertices and made.kind == "nonproper"
    for p in made.vertices[len(pslg.vertices):]:
        at = oracle.triple(p)
        assert not any(oracle.on_segment(at, oracle.triple(pslg.vertices[u]), oracle.triple(pslg.vertices[v]))
                       for u, v in pslg.edges)


def test_a_bare_triangle_is_its_own_mesh() -> None:
    result = mesh(families.ALL_SMALL["triangle"])
    assert result.mesh.faces == ((0, 1, 2),) and result.verification.degradation_squared == 1


# --- what must not matter: the degradation stays exactly the same ---


@pytest.mark.parametrize("name", CHOSEN)
def test_orientation_start_and_labels_do_not_matter(name: str) -> None:
    pslg = SMALL[name]
    squared = degradation_squared(pslg)
    assert degradation_squared(families.reversed_orientation(pslg)) == squared
    for start in (1, len(pslg.vertices) // 2):
        assert degradation_squared(families.with_start(pslg, start)) == squared
    for seed in range(3):
        assert degradation_squared(relabelled(pslg, seed)) == squared


@pytest.mark.parametrize("name", CHOSEN)
def test_moving_by_whole_levels_does_not_matter(name: str) -> None:
    pslg = SMALL[name]
    squared = degradation_squared(pslg)
    unit = mesh_unit(pslg)
    for dx, levels in ((Fraction(17, 3), 1), (Fraction(-1, 7), -10**6), (10**9, 0), (0, 12345)):
        assert degradation_squared(families.translated(pslg, dx * unit, levels * LEVEL * unit)) == squared


def mesh_unit(pslg: Pslg) -> mpq:
    """Return the unit m of the construction: dyadic, 24 bits, at most the mfs."""
    return made_of(pslg).construction.shape.unit


@pytest.mark.parametrize("name", CHOSEN)
def test_scaling_by_a_power_of_two_does_not_matter(name: str) -> None:
    squared = degradation_squared(SMALL[name])
    for k in (-100, -1, 1, 77):
        assert degradation_squared(families.scaled(SMALL[name], mpq(2) ** k)) == squared


# --- what may change the mesh, but no claim ---


@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_at_every_scale(name: str) -> None:
    # The unit m has 24 bits: at another scale it is another fraction of the mfs, and Q lies elsewhere on the levels.
    for factor in (Fraction(3, 7), Fraction(10**9 + 7, 10), Fraction(1, 3)):
        assert mesh(families.scaled(SMALL[name], factor)).holds


@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_anywhere(name: str) -> None:
    unit = mesh_unit(SMALL[name])
    for share in (Fraction(1, 2), Fraction(1, 3), Fraction(99, 100)):
        assert mesh(families.translated(SMALL[name], 0, share * LEVEL * unit)).holds


@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_in_the_mirror(name: str) -> None:
    # The degradation may change: of several triangulations that are good enough the first is taken, and what comes
    # first on the left comes last in the mirror.
    assert mesh(families.mirrored(SMALL[name])).holds


def test_the_mirror_image_may_have_another_degradation() -> None:
    pslg = SMALL["l-shape 44"]
    assert degradation_squared(families.mirrored(pslg)) != degradation_squared(pslg)


@pytest.mark.parametrize("turn", [Fraction(1), Fraction(-1, 2), Fraction(1, 1000), Fraction(-3, 10**6), Fraction(7, 5)])
@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_at_every_angle(name: str, turn: Fraction) -> None:
    assert mesh(families.rotated(SMALL[name], turn)).holds


@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_with_vertices_on_the_edges(name: str) -> None:
    assert mesh(families.with_collinear_vertices(SMALL[name], 2)).holds


@pytest.mark.parametrize("seed", range(40))
def test_random_inputs(seed: int) -> None:
    source = random.Random(seed)
    kind = source.choice([*families.KINDS, "pslg", "map"])
    if kind == "pslg":
        pslg = families.random_pslg(1000 + seed, source.randint(1, 3))
    elif kind == "map":
        pslg = families.grid_map(4, 4, 1000 + seed, Fraction(source.randint(2, 9), 10))
    else:
        pslg = families.random_simple_polygon(source.randint(4, 60), 1000 + seed, kind)
    turned = families.rotated(pslg, Fraction(source.randint(-99, 99), source.choice((7, 10**3, 10**6))))
    assert broken(mesh(turned)) == []
