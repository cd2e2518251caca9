"""The internal feature size: equal to brute force from the definition, and what it does and does not see."""

from collections.abc import Callable
from fractions import Fraction
from math import sqrt

import constructions
import families
import oracle
import pytest
from constructions import graph
from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.measure import ifs
from exactmesh.measure.face_feature import face_feature_squared
from exactmesh.measure.ifs import internal_feature_size, mesh_ifs, nearest_seen
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.planar.delaunay import constrained_delaunay
from exactmesh.planar.faces import domain_of, subdivide
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.planar.triangulation import triangulate

INPUTS = families.ALL_SMALL | families.SMALL_PSLGS | {"hall": constructions.HALL}
SQUARE = [(0, 0), (6, 0), (6, 6), (0, 6)]
RIM = [(0, 1), (1, 2), (2, 3), (3, 0)]


def brute_force(pslg: Pslg) -> Fraction:
    """Return the squared ifs from the definition: pairs from near to far, until a segment lies in a domain face."""
    places = [oracle.place(p) for p in pslg.vertices]
    triples = [oracle.triple(p) for p in places]
    domain = oracle.Domain(pslg.vertices, pslg.edges, pslg.holes)
    pairs = []
    for v, p in enumerate(places):
        # A segment along an edge is in the closure of a face when the edge is: its other end is looked at below.
        pairs += [(_square(p, q), v, q) for w, q in enumerate(places) if w != v]
        for a, b in pslg.edges:
            foot = _foot(p, places[a], places[b])
            if v not in (a, b) and foot is not None:
                pairs.append((_square(p, foot), v, foot))
    for square, v, q in sorted(pairs):
        p, end = places[v], oracle.triple(q)
        along = next((sorted((a, b)) for a, b in pslg.edges if v in (a, b) and q in (places[a], places[b])), None)
        if along is not None:
            if _borders(domain, places[along[0]], places[along[1]]):
                return square
            continue
        # The open segment meets no vertex and no edge, so it lies in one face, which its middle tells.
        if any(w != v and t != end and oracle.on_segment(t, triples[v], end) for w, t in enumerate(triples)):
            continue
        if any(v not in edge and not oracle.on_segment(end, triples[edge[0]], triples[edge[1]])
               and oracle.meet(triples[v], end, triples[edge[0]], triples[edge[1]]) for edge in pslg.edges):
            continue
        if domain.contains(((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)):
            return square
    raise AssertionError("no pair in the domain")


def _square(p: oracle.Place, q: oracle.Place) -> Fraction:
    return (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2


def _foot(p: oracle.Place, a: oracle.Place, b: oracle.Place) -> oracle.Place | None:
    """Return the foot of p on the segment a b when it lies in its interior."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy)
    return (a[0] + t * dx, a[1] + t * dy) if 0 < t < 1 else None


def _borders(domain: oracle.Domain, a: oracle.Place, b: oracle.Place) -> bool:
    """Return whether a domain face lies on either side of the edge a b, close to its middle."""
    others = [q for e in domain.edges if set(e) != {a, b} for q in e] + domain.points
    middle = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
    gap = min([_square(middle, q) for q in others if q not in (a, b)]
              + [_square(middle, foot) for e in domain.edges if set(e) != {a, b}
                 if (foot := _foot(middle, *e)) is not None] + [_square(a, b)])
    step = Fraction(1, 4) * gap / (gap + _square(a, b))
    normal = a[1] - b[1], b[0] - a[0]
    return any(domain.contains((middle[0] + s * step * normal[0], middle[1] + s * step * normal[1])) for s in (1, -1))


def found(pslg: Pslg) -> Nearest:
    """Return the ifs with its witness; the witness has the distance it claims."""
    nearest = internal_feature_size(domain_of(pslg))
    assert nearest is not None
    a, b = (pslg.vertices[v] for v in nearest.feature)
    assert nearest.squared == segment_distance_squared(pslg.vertices[nearest.vertex], a, b)
    assert nearest.vertex not in nearest.feature
    assert nearest.is_vertex_pair or nearest.feature in pslg.edges or nearest.feature[::-1] in pslg.edges
    return nearest


@pytest.mark.parametrize("name", INPUTS)
def test_equals_brute_force(name: str) -> None:
    assert oracle.exact(found(INPUTS[name]).squared) == brute_force(INPUTS[name])


@pytest.mark.parametrize("seed", range(300, 330))
def test_equals_brute_force_on_random_pslgs(seed: int) -> None:
    for pslg in (families.random_pslg(seed, 2), families.grid_map(3, 3, seed, Fraction(1, 2)),
                 families.random_simple_polygon(20, seed, "partition"),
                 families.random_simple_polygon(14, seed, "two-opt")):
        assert oracle.exact(found(pslg).squared) == brute_force(pslg)


@pytest.mark.parametrize("name", INPUTS)
def test_no_less_than_the_mfs_and_the_same_however_it_is_found(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    pslg = INPUTS[name]
    subdivision = domain_of(pslg)
    nearest, mfs = found(pslg), minimum_feature_size(pslg)
    assert mfs is not None and nearest.squared >= mfs.squared
    assert nearest_seen(pslg.vertices, triangulate(subdivision)) == nearest
    # Edges are cut before anything is seen through a side.
    monkeypatch.setattr(ifs, "_MANY", 0)
    assert internal_feature_size(subdivision) == nearest


@pytest.mark.parametrize("change", [lambda p: families.rotated(p, Fraction(3, 7)), families.mirrored,
                                    families.reversed_orientation, lambda p: families.translated(p, 10**9, 5)])
def test_motions_do_not_change_it(change: Callable[[Pslg], Pslg]) -> None:
    for name in ("hall", "comb 5", "partition 24", "random pslg 3"):
        assert found(change(INPUTS[name])).squared == found(INPUTS[name]).squared


def wedge(width: mpq) -> Pslg:
    """Return a square of side 10 with a notch from the left that is `width` wide at its mouth and 9 deep."""
    return families.ring([(0, 0), (10, 0), (10, 10), (0, 10), (0, 5 + width), (9, 5), (0, 5)])


def test_what_is_near_across_the_outside_does_not_count() -> None:
    narrow = wedge(mpq(1, 10**9))
    mfs = minimum_feature_size(narrow)
    assert mfs is not None and mfs.squared < mpq(1, 10**17)
    assert found(narrow) == Nearest(mpq(1), 5, (1, 2))


def test_a_spiral_with_thin_walls() -> None:
    # A corridor of width 2 along a wall, a hole, that is 1/1000 thick and pointed at both ends.
    d = mpq(1, 1000)
    wall = [(2, 2), (8, 2), (8, 8), (2, 8), (2, 4), (6, 4), (6, 6),
            (6 - d, 4 + d), (2 + d, 4 + d), (2 + d, 8 - d), (8 - d, 8 - d), (8 - d, 2 + d)]
    count = len(wall)
    room = families.ring([(0, 0), (10, 0), (10, 10), (0, 10)])
    pslg = Pslg(room.vertices + families.ring(wall).vertices,
                (*room.edges, *((4 + i, 4 + (i + 1) % count) for i in range(count))),
                (constructions.point("15999/2000", 5),))
    mfs = minimum_feature_size(pslg)
    assert mfs is not None and mfs.squared <= 2 * d * d
    assert found(pslg) == Nearest((2 - d) ** 2, 10, (13, 14))
    assert oracle.exact(found(pslg).squared) == brute_force(pslg)


def test_holes_shield_and_both_sides_of_a_dangling_edge_count() -> None:
    ring: list[tuple[int, int | str]] = [(1, 3), (5, 3), (5, "31/10"), (1, "31/10")]
    pslg = graph([*SQUARE, *ring], [*RIM, (4, 5), (5, 6), (6, 7), (7, 4)])
    assert found(pslg).squared == mpq(1, 100)
    # The ring above has sides of length 1/10; the next one has none, and is 1/10 thin only inside.
    sharp = graph([*SQUARE, (1, 3), (5, 3), (3, "31/10")], [*RIM, (4, 5), (5, 6), (6, 4)])
    assert found(Pslg(sharp.vertices, sharp.edges, (constructions.point(3, "151/50"),))).squared == 1
    assert found(sharp).squared == mpq(1, 100)
    for x, y in ((3, "29/10"), (3, "31/10")):
        beside = graph([*SQUARE, (0, 3), (5, 3), (x, y)], [(0, 1), (1, 2), (2, 3), (3, 4), (4, 0), (4, 5)])
        assert found(beside) == Nearest(mpq(1, 100), 6, (4, 5))


def test_faces_count_each_for_itself() -> None:
    # Two needles on one edge: their tips are 1/10 apart, each in the other's outside.
    pslg = graph([(0, 0), (10, 0), (5, 5), (5, -5), (5, "1/10"), (5, "-1/10")],
                 [(0, 1), (1, 2), (2, 0), (1, 3), (3, 0), (0, 4), (4, 1), (0, 5), (5, 1)])
    mfs = minimum_feature_size(pslg)
    assert mfs is not None and mfs.squared == found(pslg).squared == mpq(1, 100)
    hollow = Pslg(pslg.vertices, pslg.edges, tuple(constructions.point(5, y) for y in ("1/20", "-1/20")))
    assert found(hollow).squared == brute_force(hollow) > 10


def test_corners_of_one_vertex_are_no_pair() -> None:
    # The square's side is pinched: vertex 4 has two corners in the one face, on either side of the edge at it.
    pslg = graph([*SQUARE, (6, 3), (3, 3)], [(0, 1), (1, 4), (4, 2), (2, 3), (3, 0), (4, 5)])
    assert found(pslg).squared == 9


def test_isolated_vertices_and_single_edges() -> None:
    pair = graph([*SQUARE, (3, 3), (3, "7/2")], RIM)
    assert found(pair) == Nearest(mpq(1, 4), 5, (4, 4))
    assert found(Pslg(pair.vertices, (*pair.edges, (4, 5)))) == Nearest(mpq(1, 4), 5, (4, 4))


def test_equally_near_pairs() -> None:
    assert found(families.ALL_SMALL["unit square"]) == Nearest(mpq(1), 1, (0, 0))
    room = families.ring([(0, 0), (9, 0), (9, 4), (5, 4), (4, 1), (3, 4), (2, 1), (1, 4), (0, 4)])
    assert found(room) == Nearest(mpq(1), 4, (0, 1))


def test_without_a_domain_there_is_none() -> None:
    assert internal_feature_size(subdivide(graph([(0, 0), (1, 0), (5, 5)], [(0, 1)]))) is None


def test_below_the_resolution_of_floats() -> None:
    tiny = mpq(1, 10**40)
    room = families.ring([(0, 0), (10, 0), (10, 10), (6, 10), (5, tiny), (4, 10), (0, 10)])
    assert found(room) == Nearest(tiny * tiny, 4, (0, 1))
    two = Pslg((*room.vertices, *constructions.graph([(7, 1), (8, 1)]).vertices), room.edges)
    nearer = families.moved_by(
        two, lambda p: (p.x, p.y if p.y != 1 else tiny * (1 if p.x == 7 else mpq(999, 1000))), "")
    assert found(nearer) == Nearest(tiny * tiny * mpq(999, 1000) ** 2, 8, (0, 1))


def test_a_comb_with_a_long_floor_takes_linear_time(monkeypatch: pytest.MonkeyPatch) -> None:
    steps: list[int] = []
    look = ifs._Search._look_through

    def counted(search: ifs._Search, v: int, a: int, b: int) -> int:
        steps.append(look(search, v, a, b))
        return steps[-1]

    monkeypatch.setattr(ifs._Search, "_look_through", counted)
    comb = families.comb(1600, None, "uneven")
    nearest = found(comb)
    assert sum(steps) < 15 * len(comb.vertices)
    monkeypatch.setattr(ifs, "_MANY", 10**9)
    steps.clear()
    assert found(comb) == nearest
    assert sum(steps) > 60 * len(comb.vertices)


@pytest.mark.parametrize("name", ["hall", "comb 5", "random pslg 3", "map 1"])
def test_of_a_mesh_is_the_least_feature_of_its_faces(name: str) -> None:
    pslg = INPUTS[name]
    triangles = constrained_delaunay(domain_of(pslg)).triangles
    nearest = mesh_ifs(Mesh("classic", pslg.vertices, triangles))
    edges = {(min(t[i], t[i - 1]), max(t[i], t[i - 1])) for t in triangles for i in range(3)}
    as_graph = Pslg(pslg.vertices, tuple(sorted(edges)), pslg.holes)
    assert nearest is not None and oracle.exact(nearest.squared) == brute_force(as_graph)
    assert nearest.squared == min(face_feature_squared(pslg.vertices, t, (0, 1, 2)) for t in triangles)
    made = constructions.run(name)
    nonproper = mesh_ifs(made.construction.mesh)
    assert nonproper is not None and made.verification.mesh_mfs is not None
    assert nonproper.squared >= made.verification.mesh_mfs.squared


def test_of_what_is_no_mesh() -> None:
    assert mesh_ifs(Mesh("classic", (), ())) is None
    with pytest.raises(ValueError, match="face 0 has a fourth corner"):
        mesh_ifs(Mesh("classic", families.ALL_SMALL["unit square"].vertices, ((0, 1, 2, 3),)))


def test_the_mesh_of_a_polygon_keeps_no_more_than_the_polygon_has() -> None:
    for name in ("comb 5", "star 5", "growth 24"):
        subdivision = domain_of(INPUTS[name])
        nearest = mesh_ifs(Mesh("classic", INPUTS[name].vertices, constrained_delaunay(subdivision).triangles))
        assert nearest is not None and sqrt(nearest.squared) <= sqrt(found(INPUTS[name]).squared) * (1 + 1e-12)
