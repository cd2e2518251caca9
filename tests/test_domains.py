"""Every domain: maps, rings, trees, wheels, points, holes, walls, boxes; every claim holds, the oracle agrees."""

from fractions import Fraction

import families
import oracle
import pytest
from constructions import HALL, graph, point
from gmpy2 import mpq

from exactmesh.api import Meshing, ifs, mesh, mfs, verify
from exactmesh.errors import GeometryError, InputError
from exactmesh.planar.bounding_box import with_bounding_box
from exactmesh.planar.faces import HoleOutside, NoDomain, domain_of
from exactmesh.planar.mesh import Kind
from exactmesh.planar.pslg import Pslg

TINY = Fraction(1, 10**9)
SMALL: dict[str, Pslg] = {
    "nested rings": families.nested_rings(4, 1),
    "nested rings, holes": families.nested_rings(5, 2, True),
    "holes": families.polygon_with_holes(2, 2, 1),
    "rings": families.polygon_with_holes(2, 1, 3, False),
    "wheel": families.wheel(20),
    "spokes": families.wheel(22, False),
    "tree": families.boxed_tree(4, 3, 1),
    "points": families.random_segments(7, 1, 2),
    "segments": families.random_segments(14, 24, 1),
    "lattice segments": families.random_segments(12, 16, 2, 6),
    "ledges": families.spike_with_ledges(3, 5),
    "map": families.grid_map(3, 3, 5, Fraction(1, 2)),
    "walls of a map": families.thin_walls(families.grid_map(2, 2, 4, Fraction(1, 2)), Fraction(1, 10**6)),
    "walls of a tree": families.thin_walls(families.boxed_tree(3, 3, 2), TINY),
    "walls of segments": families.thin_walls(families.random_segments(8, 9, 3), Fraction(1, 10**4)),
    "slits": families.slits(3, 1),
    "walled spiral": families.walled_spiral(1, TINY, 8),
    "two faces that meet at a vertex": graph(
        [(0, 0), (4, 1), (3, 4), (0, 3), (-4, 1), (-3, -3), (1, -4)], [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 5),
                                                                       (5, 6), (6, 0)]),
    "holes that meet the rim and each other": Pslg(
        graph([(0, 0), (4, 0), (9, 0), (9, 8), (0, 8), (5, 2), (3, 3), (6, 5), (4, 5)]).vertices,
        ((0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (1, 5), (5, 6), (6, 1), (5, 7), (7, 8), (8, 5)),
        (point(4, 2), point(5, 4))),
    "two points in a square": graph([(0, 0), (9, 0), (9, 9), (0, 9), (4, 4), (4, 5)], [(0, 1), (1, 2), (2, 3), (3, 0)]),
}
LARGE: dict[str, Pslg] = {
    "map of 200 faces": families.grid_map(14, 14, 3, Fraction(19, 20)),
    "60 holes": families.polygon_with_holes(10, 6, 2),
    "20 nested rings": families.nested_rings(20, 3),
    "tree of 200 vertices": families.boxed_tree(20, 10, 4),
    "100 points and few edges": families.random_segments(100, 5, 4),
    "subdivision with edges at any angle": families.random_segments(100, 220, 5),
    "turned spokes": families.rotated(families.wheel(40, False), Fraction(3, 7)),
}
KINDS: tuple[Kind, ...] = ("nonproper", "proper")
# The oracle looks at all pairs.
FACES_FOR_THE_ORACLE = 260
SQUARE = [(0, 0), (8, 0), (8, 8), (0, 8)]
RIM = [(0, 1), (1, 2), (2, 3), (3, 0)]


def whole(result: Meshing) -> Meshing:
    """Assert that every claim holds and that `verify` agrees."""
    assert [j.claim.id for j in result.judgements if not j.verdict.holds] == [] and result.holds
    assert result.verification.valid
    return result


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", SMALL | LARGE)
def test_every_claim_holds(name: str, kind: Kind) -> None:
    pslg = (SMALL | LARGE)[name]
    result = whole(mesh(pslg, kind=kind))
    assert verify(pslg, result.mesh) == result.verification and result.verification.kind == kind


@pytest.mark.parametrize("kind", KINDS)
def test_the_oracle_agrees(kind: Kind) -> None:
    compared = 0
    for name, pslg in SMALL.items():
        result = mesh(pslg, kind=kind)
        places, faces = result.mesh.vertices, result.mesh.faces
        if len(faces) > FACES_FOR_THE_ORACLE:
            continue
        assert oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, places, faces, kind) == [], name
        squared = oracle.degradation_squared(pslg.vertices, pslg.edges, places, faces)
        assert squared == oracle.exact(result.verification.degradation_squared), name
        compared += 1
    assert compared >= 10


@pytest.mark.parametrize("name", SMALL)
def test_a_tiny_feature_anywhere(name: str) -> None:
    # A vertex 1e-9 of the mfs away from the middle of an edge, beside it or in it as a bend.
    pslg = SMALL[name]
    u, v = (pslg.vertices[w] for w in pslg.edges[0])
    middle = point(*((a + b) / 2 + n * mpq(TINY) for a, b, n in ((u.x, v.x, u.y - v.y), (u.y, v.y, v.x - u.x))))
    last = len(pslg.vertices)
    beside = Pslg((*pslg.vertices, middle), pslg.edges, pslg.holes)
    bent = Pslg(beside.vertices, ((pslg.edges[0][0], last), (last, pslg.edges[0][1]), *pslg.edges[1:]), pslg.holes)
    for other in (beside, bent):
        whole(mesh(other))


@pytest.mark.parametrize("name", ["holes", "tree", "segments", "wheel", "walls of a tree",
                                  "holes that meet the rim and each other"])
def test_claims_hold_at_any_angle_and_scale(name: str) -> None:
    turned = families.rotated(SMALL[name], Fraction(-13, 9))
    for factor in (Fraction(1, 10**30), Fraction(10**30, 3)):
        for kind in KINDS:
            whole(mesh(families.scaled(turned, factor), kind=kind))


@pytest.mark.parametrize("seed", range(30))
def test_random_domains(seed: int) -> None:
    made = (families.grid_map(3, 4, seed, Fraction(1 + seed % 9, 10)), families.random_segments(12, 2 * seed, seed),
            families.boxed_tree(3, 4, seed), families.polygon_with_holes(2, 1, seed, seed % 4 > 0),
            families.spike_with_ledges(1 + seed % 5, seed))[seed % 5]
    whole(mesh(families.rotated(made, Fraction(seed, 7)), kind=KINDS[seed // 5 % 2]))


# --- the box ---


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["spokes", "segments", "holes", "two faces that meet at a vertex", "slits"])
def test_the_outside_is_meshed_up_to_a_box(name: str, kind: Kind) -> None:
    pslg = SMALL[name]
    boxed = with_bounding_box(pslg, mpq(3))
    result = whole(mesh(boxed, kind=kind))
    area = sum(oracle.polygon_area([result.mesh.vertices[v] for v in face]) for face in result.mesh.faces)
    xs, ys = ([v[i] for v in boxed.vertices] for i in (0, 1))
    holes = oracle.domain_area(pslg.vertices, pslg.edges) - oracle.domain_area(pslg.vertices, pslg.edges, pslg.holes)
    assert area == oracle.exact((max(xs) - min(xs)) * (max(ys) - min(ys))) - holes


def test_a_box_makes_a_domain_of_anything() -> None:
    for corners, edges in (([(1, 2)], []), ([(0, 0), (5, 1)], [(0, 1)]), ([(0, 0), (3, 1), (7, 0)], [(0, 1), (1, 2)])):
        boxed = with_bounding_box(Pslg(tuple(point(x, y) for x, y in corners), tuple(edges)), mpq(1, 3))
        for kind in KINDS:
            whole(mesh(boxed, kind=kind))


def test_the_box_of_points_alone_may_be_internal() -> None:
    boxed = with_bounding_box(Pslg((point(0, 0), point(3, 1)), ()), mpq(2))
    assert whole(mesh(boxed, kind="internal")).verification.ifs_degradation_squared is not None


# --- what is refused ---


def test_a_hole_point_on_an_edge_or_a_vertex() -> None:
    for at in ((4, 0), (8, 8), (0, 3)):
        with pytest.raises(GeometryError, match="hole point 0"):
            mesh(Pslg(graph(SQUARE).vertices, tuple(RIM), (point(*at),)))


def test_a_hole_point_outside() -> None:
    with pytest.raises(HoleOutside, match=r"hole point 1 at .* lies outside") as refused:
        mesh(Pslg(graph([*SQUARE, (1, 1), (7, 1), (4, 5)]).vertices, (*RIM, (4, 5), (5, 6), (6, 4)),
                  (point(4, 2), point(9, 9))))
    assert refused.value.hole == 1


@pytest.mark.parametrize("kind", ["nonproper", "proper", "internal", "classic"])
def test_no_domain(kind: Kind) -> None:
    construction = "classic" if kind == "classic" else "repaired"
    open_edges = graph([(0, 0), (5, 0), (5, 5), (9, 9)], [(0, 1), (1, 2)])
    with pytest.raises(NoDomain, match="enclose nothing"):
        mesh(open_edges, construction, kind)
    all_holes = Pslg(graph(SQUARE).vertices, (*RIM, (0, 2)), (point(6, 1), point(1, 6)))
    with pytest.raises(NoDomain, match="every bounded face holds a hole point"):
        mesh(all_holes, construction, kind)


def test_measures_of_what_has_no_domain() -> None:
    open_edges = graph([(0, 0), (5, 0), (5, 5), (9, 9)], [(0, 1), (1, 2)])
    nearest = mfs(open_edges)
    assert nearest is not None and nearest.squared == 25 and ifs(open_edges) is None
    with pytest.raises(InputError):
        verify(open_edges, mesh(HALL).mesh)


def test_two_holes_in_one_face_are_one() -> None:
    twice = Pslg(graph(SQUARE).vertices, (*RIM, (0, 2)), (point(6, 1), point(7, 1)))
    assert len(domain_of(twice).domain) == 1 and len(whole(mesh(twice)).mesh.faces) == 1
