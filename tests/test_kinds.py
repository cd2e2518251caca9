"""Every kind of mesh: claims, laws, the oracle, and domains that a kind does not admit."""

import random
from fractions import Fraction
from typing import get_args

import families
import oracle
import pytest
from constructions import HALL, graph
from gmpy2 import mpq

from exactmesh.api import Meshing, ifs, mesh, meshing_of, verify
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.errors import InputError
from exactmesh.planar.mesh import Kind
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.constants import LEVEL, MERGE, TRIM

WALL = Fraction(1, 10**6)
# One of each family, whose domain lies on one side of every edge.
ONE_SIDED: dict[str, Pslg] = {name: families.ALL_SMALL[name] for name in (
    "triangle", "triangle with vertices on its sides", "unit square", "13-gon", "midway 100", "comb 5",
    "comb 8 doubling", "comb 10 nearly level", "spike room", "l-shape 44", "rectangular spiral", "convex spike 1e-6",
    "reflex notch 1e-6", "sliver with bends", "star 12", "staircase", "grid 24", "growth 24", "monotone 24",
    "partition 24", "two-opt 24", "turned comb", "tiny")} | {
    "holes": families.polygon_with_holes(2, 1, 1),
    "nested rings": families.nested_rings(5, 1, True),
    "walls of a map": families.thin_walls(families.grid_map(3, 2, 1, Fraction(1, 2)), WALL),
    "walls of a tree": families.thin_walls(families.boxed_tree(3, 3, 1), WALL),
    "walls of segments": families.thin_walls(families.random_segments(7, 7, 2), WALL),
    "slits": families.slits(4, 2),
    "walled spiral": families.walled_spiral(1, WALL, 10),
    "ledges": families.spike_with_ledges(3, 2),
    "points": graph([(0, 0), (9, 0), (9, 9), (0, 9), (4, 4), (4, 5)], [(0, 1), (1, 2), (2, 3), (3, 0)]),
}
TWO_SIDED = {"hall": HALL, "map": families.grid_map(3, 3, 1), "wheel": families.wheel(7),
             "tree": families.boxed_tree(3, 2, 1)}
# The laws take a dozen meshes for each input.
CHOSEN = ["comb 5", "l-shape 44", "growth 24", "two-opt 24", "holes", "walls of a tree", "slits", "points"]
REPAIRED: tuple[Kind, ...] = ("nonproper", "proper", "internal")
# The flattest triangle that columns may leave: its legs are MERGE and TRIM long.
WORST_SQUARED = (MERGE**2 + TRIM**2) / (MERGE * TRIM) ** 2


def made(pslg: Pslg, kind: Kind) -> Meshing:
    """Return the mesh of that kind, on which every claim holds."""
    result = mesh(pslg, "classic" if kind == "classic" else "repaired", kind)
    assert [j.claim.id for j in result.judgements if not j.verdict.holds] == []
    assert result.holds and result.verification.valid and result.verification.kind == result.mesh.kind == kind
    return result


def squares(pslg: Pslg, kind: Kind) -> tuple[mpq | None, mpq | None]:
    """Return both squared degradations."""
    verification = made(pslg, kind).verification
    return verification.degradation_squared, verification.ifs_degradation_squared


def claims_of(kind: Kind, construction: ConstructionName = "repaired") -> set[str]:
    """Return the ids of the claims judged on a mesh of an L."""
    return {j.claim.id for j in mesh(families.l_shape(5), construction, kind).judgements}


# --- every kind on every domain ---


@pytest.mark.parametrize("kind", get_args(Kind))
@pytest.mark.parametrize("name", ONE_SIDED)
def test_every_kind_on_every_family(name: str, kind: Kind) -> None:
    pslg = ONE_SIDED[name]
    result = made(pslg, kind)
    assert result.mesh.vertices[: len(pslg.vertices)] == pslg.vertices
    assert verify(pslg, result.mesh) == result.verification
    assert kind == "nonproper" or {len(face) for face in result.mesh.faces} == {3}
    assert kind != "classic" or len(result.mesh.vertices) == len(pslg.vertices)
    assert (result.verification.ifs_degradation_squared is None) == (kind != "internal")


@pytest.mark.parametrize("name", ONE_SIDED)
def test_the_internal_degradation_stays_below_what_the_design_expects(name: str) -> None:
    _, squared = squares(ONE_SIDED[name], "internal")
    assert squared is not None and squared <= WORST_SQUARED * (1 + mpq(1, 10**5)) < 23**2


@pytest.mark.parametrize("kind", get_args(Kind))
def test_the_oracle_agrees(kind: Kind) -> None:
    compared = 0
    for name, pslg in ONE_SIDED.items():
        result = made(pslg, kind)
        places, faces = result.mesh.vertices, result.mesh.faces
        if len(faces) > 150:
            continue
        assert oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, places, faces, kind) == [], name
        # An internal mesh has parts of input edges for edges.
        before, after = (oracle.mfs_squared(pslg.vertices, pslg.edges), oracle.mfs_squared(
            places, oracle.mesh_edges(faces, () if kind == "internal" else pslg.edges)))
        assert before is not None and after is not None
        assert before / after == oracle.exact(result.verification.degradation_squared), name
        if kind == "internal":
            # The ifs of a mesh of triangles is the least of their heights.
            least = min(oracle.mfs_squared([places[v] for v in face], [(0, 1), (1, 2), (2, 0)]) or 0 for face in faces)
            size = ifs(pslg)
            assert size is not None
            assert oracle.exact(size.squared) / least == oracle.exact(result.verification.ifs_degradation_squared)
        compared += 1
    assert compared >= 8


# --- internal meshes ---


def test_walls_do_not_count() -> None:
    # The walls are 1e-6 thick; inside, nothing is nearer than the faces of the map.
    for name in ("walls of a map", "walls of a tree", "walls of segments", "slits", "walled spiral"):
        mfs_squared, ifs_squared = squares(ONE_SIDED[name], "internal")
        assert mfs_squared is not None and ifs_squared is not None and ifs_squared < 23**2
        size = made(ONE_SIDED[name], "internal").verification
        assert size.input_ifs is not None and size.input_mfs is not None
        assert size.input_ifs.squared > 10**5 * size.input_mfs.squared


@pytest.mark.parametrize("run, offset", [(8, 3), (20, 7), (50, 16), (50, 17), (100, 32), (1000, 312), (1000, 320)])
def test_a_strip_that_lies_close_between_two_chord_ends(run: int, offset: int) -> None:
    # Found by hill climbing, then by hand: chords of these strips begin under one edge of Q and end over the other,
    # 0.074 from it; with the sliver cut off at one end only the degradation was 65 for (1000, 312), 8 vertices.
    for start in (Fraction(501, 1000), Fraction(499, 1000), Fraction(6, 10)):
        strip = families.leaning_strip(run, offset, start)
        for other in (strip, families.mirrored(strip), families.ring([(-p.x, -p.y) for p in strip.vertices])):
            _, squared = squares(other, "internal")
            assert squared is not None and squared < 20**2


@pytest.mark.parametrize("seed", range(25))
def test_random_strips(seed: int) -> None:
    source = random.Random(f"strips {seed}")
    run = source.choice((3, 8, 30, 120, 3000))
    strip = families.leaning_strip(run, Fraction(run * source.randint(250, 480), 1000),
                                   Fraction(source.choice((501, 505, 530)), 1000), source.randint(1, 3))
    _, squared = squares(strip, "internal")
    assert squared is not None and squared <= WORST_SQUARED * (1 + mpq(1, 10**5))


@pytest.mark.parametrize("seed", range(20))
def test_random_walls(seed: int) -> None:
    source = random.Random(f"walls {seed}")
    base = (families.grid_map(2, 3, seed, Fraction(seed % 9 + 1, 10)), families.boxed_tree(3, 3, seed),
            families.random_segments(8, 4 + seed, seed), families.random_pslg(seed, 1))[seed % 4]
    pslg = families.rotated(families.thin_walls(base, Fraction(1, 10 ** source.choice((3, 6, 9)))), Fraction(seed, 9))
    _, squared = squares(pslg, "internal")
    assert squared is not None and squared <= WORST_SQUARED * (1 + mpq(1, 10**5))


@pytest.mark.parametrize("name", TWO_SIDED)
def test_a_domain_on_both_sides_of_an_edge_admits_no_internal_mesh(name: str) -> None:
    pslg = TWO_SIDED[name]
    with pytest.raises(InputError, match=r"edge \d+ \(\d+, \d+\) has the domain on both sides: internal meshes"):
        mesh(pslg, kind="internal")
    for kind in ("nonproper", "proper", "classic"):
        made(pslg, kind)


def test_the_edge_that_is_named_has_the_domain_on_both_sides() -> None:
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    rim = [(0, 1), (1, 2), (2, 3), (3, 0)]
    for corners, edges, named in (
            (square, [*rim, (0, 2)], r"edge 4 \(0, 2\)"),
            ([*square, (2, 1)], [(2, 4), *rim], r"edge 0 \(2, 4\)"),
            ([*square, (2, 1), (3, 1)], [rim[0], (5, 4), *rim[1:]], r"edge 1 \(5, 4\)")):
        with pytest.raises(InputError, match=named):
            mesh(graph(corners, edges), kind="internal")
    outside = graph([*square, (9, 9)], [*rim, (2, 4)])
    made(outside, "internal")


# --- what must not matter ---


@pytest.mark.parametrize("kind", REPAIRED[1:])
@pytest.mark.parametrize("name", CHOSEN)
def test_labels_scale_and_whole_levels_do_not_matter(name: str, kind: Kind) -> None:
    pslg = ONE_SIDED[name]
    both = squares(pslg, kind)
    run = Run(pslg, kind=kind)
    level = LEVEL * run.repaired.shape.unit
    order = list(range(len(pslg.vertices)))
    random.Random(name).shuffle(order)
    new = {old: i for i, old in enumerate(order)}
    shuffled = Pslg(tuple(pslg.vertices[v] for v in order), tuple((new[v], new[u]) for u, v in pslg.edges[::-1]),
                    pslg.holes)
    for other in (families.reversed_orientation(pslg), families.with_start(pslg, 3), shuffled,
                  families.scaled(pslg, mpq(2) ** -70), families.scaled(pslg, 2**33),
                  families.translated(pslg, Fraction(1, 7), 12345 * level)):
        assert squares(other, kind) == both


@pytest.mark.parametrize("kind", REPAIRED[1:])
@pytest.mark.parametrize("name", CHOSEN)
def test_claims_hold_at_every_angle_and_in_the_mirror(name: str, kind: Kind) -> None:
    pslg = ONE_SIDED[name]
    for turn in (Fraction(1), Fraction(1, 1000), Fraction(-7, 5)):
        made(families.rotated(pslg, turn), kind)
    for other in (families.mirrored(pslg), families.scaled(pslg, Fraction(10**30, 3)),
                  families.with_collinear_vertices(pslg, 2)):
        made(other, kind)


# --- the claims that are judged ---


def test_each_kind_has_its_claims() -> None:
    theorem = {kind: {id_ for id_ in claims_of(kind) if id_.startswith("theorem")} for kind in REPAIRED}
    assert theorem["nonproper"] == {"theorem-1.triangulation", "theorem-1.feature-size", "theorem-1.degradation"}
    assert theorem["proper"] == {"theorem-2.triangulation"}
    assert theorem["internal"] == {"theorem-3.triangulation"}
    bounds = {"nonproper": "repaired.degradation", "proper": "repaired.proper-degradation",
              "internal": "repaired.internal-degradation"}
    for kind in REPAIRED:
        found = claims_of(kind)
        assert bounds[kind] in found and not found & (set(bounds.values()) - {bounds[kind]})
        assert {"repaired.offset-separation", "repaired.trapezoidation", "repaired.interior-tiling"} <= found
        assert ("repaired.steiner-count" in found) == (kind != "internal")
    assert claims_of("classic", "classic") == {"section-1.classic-triangulation"}


def test_the_bound_of_a_proper_mesh_grows_with_the_logarithm() -> None:
    # A comb with all tips on one level needs rows upon rows of layers.
    roots = []
    for teeth in (4, 16, 64):
        pslg = families.comb(teeth)
        squared, _ = squares(pslg, "proper")
        assert squared is not None
        roots.append(float(squared) ** 0.5)
        assert squares(pslg, "nonproper")[0] <= mpq(108, 5) ** 2
    assert roots[0] < roots[1] < roots[2] < 9 * (1 + 7.04)


# --- what a construction does not make ---


@pytest.mark.parametrize("construction, kind, message", [
    ("classic", "proper", "the classic construction makes classic meshes, not proper ones"),
    ("classic", "nonproper", "makes classic meshes"),
    ("paper", "internal", "the paper construction makes nonproper and proper meshes, not internal ones"),
    ("paper", "classic", "not classic ones"),
    ("repaired", "classic", "the repaired construction makes nonproper, proper and internal meshes, not classic ones"),
])
def test_kinds_that_a_construction_does_not_make(construction: ConstructionName, kind: Kind, message: str) -> None:
    with pytest.raises(InputError, match=message):
        mesh(families.l_shape(5), construction, kind)


@pytest.mark.parametrize("kind", ["nonproper", "proper"])
@pytest.mark.parametrize("name", ["holes", "points", "walls of a tree", "nested rings"])
def test_the_paper_takes_simple_polygons_only(name: str, kind: Kind) -> None:
    with pytest.raises(InputError, match="simple polygon"):
        mesh(ONE_SIDED[name], "paper", kind)


def test_the_best_classic_mesh_of_what_is_no_simple_polygon() -> None:
    with pytest.raises(InputError, match="one simple polygon"):
        meshing_of(Run(ONE_SIDED["holes"], "classic", "classic", optimal=True))
    with pytest.raises(InputError, match="at most 200 vertices, not 201"):
        meshing_of(Run(families.random_simple_polygon(201, 1), "classic", "classic", optimal=True))
