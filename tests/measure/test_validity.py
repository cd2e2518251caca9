"""`verify_mesh` against the oracle: sound meshes of every kind, and more ways to harm them than clauses."""

import random
from collections.abc import Callable
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any, TypeAlias

import families
import oracle
import pytest
import test_oracle
from gmpy2 import mpq

import exactmesh
from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.cycles import directed_edges, sides
from exactmesh.planar.faces import domain_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge, Pslg

Places: TypeAlias = list[tuple[Any, Any]]
Faces: TypeAlias = tuple[tuple[int, ...], ...]
TINY = mpq(1, 10**30)


def points(places: Any) -> tuple[Point, ...]:
    return tuple(Point(mpq(x), mpq(y)) for x, y in places)


def cycle(n: int, first: int = 0) -> list[Edge]:
    return [(first + i, first + (i + 1) % n) for i in range(n)]


@dataclass(frozen=True)
class Case:
    """An input and a mesh of it, judged by `verify_mesh` and by the oracle."""

    pslg: Pslg
    mesh: Mesh

    def verify(self) -> Verification:
        return verify_mesh(domain_of(self.pslg), self.mesh)

    def oracle(self) -> list[str]:
        return oracle.check_mesh(self.pslg.vertices, self.pslg.edges, self.pslg.holes, self.mesh.vertices,
                                 self.mesh.faces, self.mesh.kind)

    def judged(self) -> set[str]:
        """Assert that both agree, on the degradation too; return the clauses that are violated."""
        found, violations = self.verify(), self.oracle()
        assert found.valid == (not violations), (found.violations, violations)
        assert found.valid == (not found.violations)
        assert (found.kind, found.faces) == (self.mesh.kind, len(self.mesh.faces))
        assert found.steiner == len(self.mesh.vertices) - len(self.pslg.vertices)
        if found.valid:
            self.check_measures(found)
        else:
            assert found.mesh_mfs is None and found.degradation_squared is None
        return {violation.clause for violation in found.violations}

    def check_measures(self, found: Verification) -> None:
        """Assert the feature sizes of a valid mesh, and that the witnesses have them."""
        assert found.input_mfs is not None and found.mesh_mfs is not None
        assert found.input_mfs.squared == oracle.mfs_squared(self.pslg.vertices, self.pslg.edges)
        assert found.degradation_squared == oracle.degradation_squared(
            self.pslg.vertices, self.pslg.edges, self.mesh.vertices, self.mesh.faces)
        at, (a, b) = self.mesh.vertices, found.mesh_mfs.feature
        assert found.mesh_mfs.vertex not in (a, b)
        assert segment_distance_squared(at[found.mesh_mfs.vertex], at[a], at[b]) == found.mesh_mfs.squared

    def with_mesh(self, **changes: Any) -> "Case":
        return replace(self, mesh=replace(self.mesh, **changes))

    def with_vertex(self, v: int, x: Any, y: Any) -> "Case":
        at = list(self.mesh.vertices)
        at[v] = Point(mpq(x), mpq(y))
        return self.with_mesh(vertices=tuple(at))

    def with_more(self, *places: tuple[Any, Any]) -> "Case":
        return self.with_mesh(vertices=self.mesh.vertices + points(places))

    def with_face(self, f: int, *faces: tuple[int, ...]) -> "Case":
        """Return the case with face f replaced by others."""
        return self.with_mesh(faces=self.mesh.faces[:f] + faces + self.mesh.faces[f + 1:])

    def without(self, *numbers: int) -> "Case":
        return self.with_mesh(faces=tuple(face for f, face in enumerate(self.mesh.faces) if f not in numbers))


def case(places: Places, edges: list[Edge], more: Places, faces: Faces, kind: Any,
         holes: Places | None = None) -> Case:
    """Return an input and the mesh with its vertices and `more`."""
    pslg = Pslg(points(places), tuple(edges), points(holes or []))
    return Case(pslg, Mesh(kind, pslg.vertices + points(more), faces))


def made(pslg: Pslg) -> Case:
    """Return an input with the mesh that the construction makes of it."""
    return Case(pslg, exactmesh.mesh(pslg).mesh)


# --- sound meshes by hand ---

SQUARE: Places = [(0, 0), (4, 0), (4, 4), (0, 4)]
RING: Places = [(0, 0), (6, 0), (6, 6), (0, 6), (2, 2), (4, 2), (4, 4), (2, 4)]
RINGS = [*cycle(4), *cycle(4, 4)]
BETWEEN: Faces = ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 6, 5), (2, 3, 6), (3, 7, 6), (3, 0, 7), (0, 4, 7))
WITHIN: Faces = ((4, 5, 6), (4, 6, 7))
# A dangling edge from corner 0 to 4, an isolated vertex 5, and an edge 2-6 and a vertex 7 outside.
MIXED: Places = [*SQUARE, (1, 1), (2, 3), (5, 5), (9, 9)]
MIXED_FACES: Faces = ((0, 1, 4), (1, 5, 4), (1, 2, 5), (2, 3, 5), (3, 4, 5), (3, 0, 4))

CLASSIC = case(SQUARE, cycle(4), [], ((0, 1, 2), (0, 2, 3)), "classic")
PROPER = case(SQUARE, cycle(4), [(2, 2)], ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)), "proper")
NONPROPER = case(SQUARE, cycle(4), [(2, 2)], ((0, 1, 2, 4), (0, 4, 3), (4, 2, 3)), "nonproper")
WALL = case(SQUARE, [*cycle(4), (0, 2)], [], ((0, 1, 2), (0, 2, 3)), "classic")
HOLE = case(RING, RINGS, [], BETWEEN, "classic", [(3, 3)])
FILLED = case(RING, RINGS, [], BETWEEN + WITHIN, "classic")
MIDDLE = case(RING, RINGS, [], WITHIN, "classic", [(1, 1)])
DANGLING = case(MIXED, [*cycle(4), (0, 4), (2, 6)], [], MIXED_FACES, "classic")
# Steiner vertices on the boundary, on a wall between two faces (both sides), on a dangling edge (both sides).
SPLIT = case(SQUARE, cycle(4), [(2, 0)], ((0, 4, 3), (4, 1, 2), (4, 2, 3)), "internal")
SPLIT_TWICE = case(SQUARE, cycle(4), [(1, 0), (3, 0)], ((0, 4, 3), (4, 5, 3), (5, 1, 2), (5, 2, 3)), "internal")
SPLIT_WALL = case(SQUARE, [*cycle(4), (0, 2)], [(2, 2)], ((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)), "internal")
SPLIT_DANGLING = case(
    [*SQUARE, (2, 2)], [*cycle(4), (0, 4)], [(1, 1)],
    ((0, 1, 5), (5, 1, 4), (1, 2, 4), (2, 3, 4), (4, 3, 5), (5, 3, 0)), "internal")
SPLIT_HOLE = case(RING, RINGS, [(3, 2)], (*BETWEEN[:1], (1, 5, 8), (1, 8, 4), *BETWEEN[2:]), "internal", [(3, 3)])
PLAIN_INTERNAL = replace(PROPER, mesh=replace(PROPER.mesh, kind="internal"))
MADE = made(families.ALL_SMALL["convex spike 1e-2"])
MADE_PSLG = made(families.SMALL_PSLGS["square and two points"])
TWO_SQUARES = made(families.SMALL_PSLGS["two squares"])

SOUND = {"classic": CLASSIC, "proper": PROPER, "nonproper": NONPROPER, "wall": WALL, "hole": HOLE, "filled": FILLED,
         "middle": MIDDLE, "dangling": DANGLING, "split": SPLIT, "split twice": SPLIT_TWICE,
         "split wall": SPLIT_WALL, "split dangling": SPLIT_DANGLING, "split hole": SPLIT_HOLE,
         "internal without": PLAIN_INTERNAL, "made": MADE, "made of a pslg": MADE_PSLG, "two squares": TWO_SQUARES}


@pytest.mark.parametrize("name", SOUND)
def test_sound_meshes_are_valid_with_the_oracles_degradation(name: str) -> None:
    assert SOUND[name].judged() == set()


@pytest.mark.parametrize("name", [n for n, p in families.ALL_SMALL.items() if len(p.vertices) <= 24]
                         + ["random pslg 4", "map 0", "map 2"])
def test_what_the_construction_makes_is_valid(name: str) -> None:
    assert made((families.ALL_SMALL | families.SMALL_PSLGS)[name]).judged() == set()


def test_degradation_of_internal_meshes_counts_the_whole_mesh() -> None:
    found = SPLIT.verify()
    assert found.degradation_squared == 5  # the corner (0, 0) is 8/sqrt(20) from the edge (2, 0), (0, 4)
    # Outside, a notch: the Steiner vertex on one of its walls is nearer to the other than any input vertex is.
    notch = case([(-9, -9), (9, -9), (9, 9), (1, 9), (0, 0), (-1, 9), (-9, 9)], cycle(7), [("1/9", 1)],
                 ((0, 1, 4), (1, 7, 4), (1, 2, 7), (2, 3, 7), (0, 4, 5), (0, 5, 6)), "internal")
    assert notch.judged() == set()
    found = notch.verify()
    edges = oracle.mesh_edges(notch.mesh.faces, notch.pslg.edges) - {(3, 4)}
    assert found.mesh_mfs is not None
    assert found.mesh_mfs.squared == oracle.mfs_squared(notch.mesh.vertices, edges) < Fraction(1, 10)


def test_the_nearest_pair_may_lie_outside_the_domain() -> None:
    # Two isolated vertices; an edge beside the corner (0, 0), which a mesh of the inside does not see.
    pair = case([*SQUARE, (6, 1), (6, "9/8")], cycle(4), [], CLASSIC.mesh.faces, "classic")
    beside = [*SQUARE, ("-1/9", -1), ("-1/9", 5)]
    for given, squared in [(pair, Fraction(1, 64)),
                           (case(beside, [*cycle(4), (4, 5)], [], CLASSIC.mesh.faces, "classic"), Fraction(1, 81)),
                           (case(beside, [*cycle(4), (4, 5)], [(2, 0)],
                                 ((0, 6, 3), (6, 1, 2), (6, 2, 3)), "internal"), Fraction(1, 81))]:
        assert given.judged() == set()
        found = given.verify()
        assert found.mesh_mfs is not None and found.mesh_mfs.squared == squared
        assert found.degradation_squared == 1


# --- harm, with the clause it breaks ---

HARMED: dict[str, tuple[Case, str]] = {
    # vertices
    "input vertex moved": (CLASSIC.with_vertex(1, 4 + TINY, 0), "input-vertices"),
    "input vertices exchanged": (CLASSIC.with_mesh(vertices=points([SQUARE[1], SQUARE[0], *SQUARE[2:]])),
                                 "input-vertices"),
    "input vertices turned, faces too": (
        CLASSIC.with_mesh(vertices=points([*SQUARE[1:], SQUARE[0]]), faces=((3, 0, 1), (3, 1, 2))), "input-vertices"),
    "input vertex missing": (CLASSIC.with_mesh(vertices=points(SQUARE[:3]), faces=((0, 1, 2),)), "input-vertices"),
    "no vertices": (CLASSIC.with_mesh(vertices=(), faces=()), "input-vertices"),
    "input vertex outside the domain moved": (DANGLING.with_vertex(7, 9, 9 + TINY), "input-vertices"),
    "isolated input vertex moved, mesh sound": (DANGLING.with_vertex(5, 2, "31/10"), "input-vertices"),
    "Steiner vertex onto another": (
        PROPER.with_more((2, 2)).with_face(0, (0, 1, 5)), "repeated-vertex"),
    "Steiner vertex onto an input vertex": (PROPER.with_vertex(4, 4, 0), "repeated-vertex"),
    "a second vertex at a place, unused": (PROPER.with_more((2, 2)), "repeated-vertex"),
    "slit with doubled vertices": (
        PROPER.with_more((2, 2), (0, 0)).with_mesh(
            faces=((0, 1, 4), (1, 2, 4), (2, 3, 5), (3, 0, 5))), "repeated-vertex"),
    "slit with a doubled input vertex": (
        case(SQUARE, cycle(4), [(4, 4)], ((0, 1, 2), (0, 4, 3)), "nonproper"), "repeated-vertex"),
    # face shapes
    "flipped face": (PROPER.with_face(0, (4, 1, 0)), "face-shape"),
    "all faces flipped": (PROPER.with_mesh(faces=tuple(f[::-1] for f in PROPER.mesh.faces)), "face-shape"),
    "swapped indices": (NONPROPER.with_face(0, (0, 1, 4, 2)), "face-shape"),
    "T-vertex listed out of order": (
        case(SQUARE, cycle(4), [(1, 1), (3, 3)], ((0, 1, 2, 4, 5), (0, 4, 3), (4, 5, 3), (5, 2, 3)), "nonproper"),
        "face-shape"),
    "Steiner vertex off its side by a tiny step": (NONPROPER.with_vertex(4, 2 + TINY, 2), "face-shape"),
    "quadrilateral": (NONPROPER.with_mesh(faces=((0, 1, 2, 3),)), "face-shape"),
    "pentagon with a reflex corner": (
        case([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], cycle(5), [], ((0, 1, 2, 3, 4),), "nonproper"), "face-shape"),
    "flat face": (NONPROPER.with_mesh(faces=(*NONPROPER.mesh.faces, (0, 4, 2))), "face-shape"),
    "face of two vertices": (CLASSIC.with_mesh(faces=(*CLASSIC.mesh.faces, (0, 1))), "face-shape"),
    "face of one vertex": (CLASSIC.with_mesh(faces=(*CLASSIC.mesh.faces, (0,))), "face-shape"),
    "empty face": (CLASSIC.with_mesh(faces=(*CLASSIC.mesh.faces, ())), "face-shape"),
    "vertex twice in a face": (CLASSIC.with_face(0, (0, 1, 1, 2)), "face-shape"),
    "triangle run twice": (CLASSIC.with_mesh(kind="nonproper").with_face(0, (0, 1, 2, 0, 1, 2)), "face-shape"),
    # indices and kinds
    "index beyond the vertices": (PROPER.with_face(0, (0, 1, 5)), "face-index"),
    "negative index": (PROPER.with_face(0, (0, 1, -1)), "face-index"),
    "negative indices throughout": (
        PROPER.with_mesh(faces=tuple(tuple(-1 if v == 4 else v for v in f) for f in PROPER.mesh.faces)), "face-index"),
    "unknown kind": (CLASSIC.with_mesh(kind="best"), "kind"),
    "nonproper called proper": (NONPROPER.with_mesh(kind="proper"), "face-size"),
    "nonproper called internal": (NONPROPER.with_mesh(kind="internal"), "face-size"),
    "nonproper called classic": (
        case([*SQUARE, (2, 2)], cycle(4), [], NONPROPER.mesh.faces, "classic"), "face-size"),
    "classic with a Steiner vertex": (PROPER.with_mesh(kind="classic"), "steiner"),
    # adjacency
    "face twice": (PROPER.with_mesh(faces=(*PROPER.mesh.faces, PROPER.mesh.faces[0])), "overlap"),
    "face twice, from another vertex": (PROPER.with_mesh(faces=(*PROPER.mesh.faces, (1, 4, 0))), "overlap"),
    "every face twice": (PROPER.with_mesh(faces=PROPER.mesh.faces * 2), "overlap"),
    "two triangulations at once": (
        CLASSIC.with_mesh(faces=(*CLASSIC.mesh.faces, (0, 1, 3), (1, 2, 3))), "overlap"),
    "two faces overlap, the area is right": (CLASSIC.with_face(0, (1, 2, 3)), "boundary"),
    "face missing inside": (
        case(SQUARE, cycle(4), [(1, 1), (2, 1), (1, 2)],
             ((0, 1, 5), (0, 5, 4), (1, 2, 5), (2, 6, 5), (2, 3, 6), (3, 0, 6), (0, 4, 6)), "proper"), "boundary"),
    "face missing at the boundary": (PROPER.without(2), "input-edge"),
    "faces missing at a dangling edge": (DANGLING.without(0, 5), "input-edge"),
    "no faces": (PROPER.with_mesh(faces=()), "input-edge"),
    "a part of the domain without faces": (
        TWO_SQUARES.with_mesh(faces=tuple(f for f in TWO_SQUARES.mesh.faces
                                          if all(TWO_SQUARES.mesh.vertices[v].x < 3 for v in f))), "input-edge"),
    "two vertices merged": (
        MADE.with_mesh(faces=tuple(tuple(8 if v == 9 else v for v in f) for f in MADE.mesh.faces)), "overlap"),
    "T-vertex not listed": (NONPROPER.with_face(0, (0, 1, 2)), "boundary"),
    "diagonals crossing without a vertex": (CLASSIC.with_mesh(faces=((0, 1, 2), (1, 2, 3))), "boundary"),
    # the domain
    "fan through a hole": (
        HOLE.with_mesh(faces=(*HOLE.mesh.faces, *WITHIN)), "boundary"),
    "hole filled, the rest left empty": (HOLE.with_mesh(faces=WITHIN), "boundary"),
    "hole instead of the face around it": (MIDDLE.with_mesh(faces=BETWEEN), "boundary"),
    "exterior quadrangle": (
        case([(0, 0), (4, 0), (4, 4), (2, 1), (0, 4)], cycle(5), [],
             ((0, 1, 3), (1, 2, 3), (0, 3, 4), (2, 4, 3)), "classic"), "boundary"),
    "exterior face with a vertex of its own": (
        PROPER.with_more((9, 2)).with_mesh(faces=(*PROPER.mesh.faces, (2, 1, 5))), "boundary"),
    "face far outside": (
        PROPER.with_more((10, 0), (11, 0), (10, 1)).with_mesh(faces=(*PROPER.mesh.faces, (5, 6, 7))), "boundary"),
    "a sphere outside": (
        PROPER.with_more((10, 0), (11, 0), (10, 1)).with_mesh(
            faces=(*PROPER.mesh.faces, (5, 6, 7), (7, 6, 5))), "face-shape"),
    "input edge crossed by an edge": (WALL.with_mesh(faces=((0, 1, 3), (1, 2, 3))), "input-edge"),
    "input edge inside a face": (
        case([(0, 0), (4, 0), (0, 4), (2, 0), (0, 2)], [(0, 3), (3, 1), (1, 2), (2, 4), (4, 0), (3, 4)], [],
             ((0, 3, 1, 2, 4),), "nonproper"), "input-edge"),
    "dangling edge crossed": (
        DANGLING.with_mesh(faces=((0, 1, 5), (1, 2, 5), (2, 3, 5), (3, 0, 5))), "input-edge"),
    "vertex on an input edge": (SPLIT.with_mesh(kind="proper"), "input-edge"),
    "vertex on an input edge, listed as a T-vertex": (
        CLASSIC.with_mesh(kind="nonproper").with_more((2, 0)).with_face(0, (0, 4, 1, 2)), "input-edge"),
    "vertex on a wall": (SPLIT_WALL.with_mesh(kind="proper"), "input-edge"),
    # use
    "unused Steiner vertex": (PROPER.with_more((7, 7)), "unused-vertex"),
    "unused Steiner vertex in a face": (PROPER.with_more((2, 1)), "unused-vertex"),
    "unused Steiner vertex on an edge": (PROPER.with_more((1, 1)), "unused-vertex"),
    "unused Steiner vertex on the boundary": (PROPER.with_more((1, 0)), "unused-vertex"),
    "isolated vertex not used": (
        DANGLING.with_mesh(faces=((0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4))), "unused-vertex"),
    "isolated vertex on an edge of the mesh": (
        case([*SQUARE, (2, 2)], cycle(4), [], ((0, 1, 2), (0, 2, 3)), "classic"), "unused-vertex"),
    # internal meshes
    "internal: input vertex missing": (
        SPLIT.with_mesh(vertices=points(SQUARE[:3]), faces=((0, 1, 2),)), "input-vertices"),
    "internal: off the boundary by a tiny step": (SPLIT.with_vertex(4, 2, TINY), "input-edge"),
    "internal: beyond the boundary by a tiny step": (SPLIT.with_vertex(4, 2, -TINY), "input-edge"),
    "internal: piece of the boundary missing": (SPLIT.without(0), "input-edge"),
    "internal: gap inside a side": (SPLIT_TWICE.without(1), "input-edge"),
    "internal: unlisted vertex on the boundary": (
        SPLIT.with_mesh(faces=((0, 1, 2), (0, 2, 3))), "unused-vertex"),
    "internal: vertex of another face on the boundary edge of a face": (
        case(SQUARE, [*cycle(4), (0, 2)], [(2, 2)], ((0, 1, 2), (2, 3, 4), (3, 0, 4)), "internal"), "boundary"),
    "internal: a wall split on both sides at different places": (
        case(SQUARE, [*cycle(4), (0, 2)], [(1, 1), (2, 2)],
             ((0, 1, 4), (1, 2, 4), (2, 3, 5), (3, 0, 5)), "internal"), "boundary"),
    "internal: a dangling edge split on one side": (
        SPLIT_DANGLING.with_mesh(faces=((0, 1, 4), *SPLIT_DANGLING.mesh.faces[2:])), "boundary"),
    "internal: faces on both sides of the boundary": (
        SPLIT.with_more((2, -2)).with_mesh(faces=(*SPLIT.mesh.faces, (4, 0, 5), (1, 4, 5))), "boundary"),
    "internal: hole filled": (
        SPLIT_HOLE.with_mesh(faces=(*SPLIT_HOLE.mesh.faces, (4, 8, 7), (8, 5, 6), (8, 6, 7))), "boundary"),
    "internal: edge back and forth on the boundary": (
        SPLIT_TWICE.with_mesh(faces=((0, 5, 3), (5, 4, 3), (4, 1, 2), (4, 2, 3))), "face-shape"),
}


@pytest.mark.parametrize("name", HARMED)
def test_harm_breaks_the_clause_it_should(name: str) -> None:
    harmed, clause = HARMED[name]
    assert clause in harmed.judged()


def test_every_clause_is_broken_by_some_harm() -> None:
    clauses = {clause for _, clause in HARMED.values()}
    assert clauses == {"kind", "input-vertices", "repeated-vertex", "face-index", "face-shape", "face-size", "steiner",
                       "overlap", "input-edge", "boundary", "unused-vertex"}


# Harm that one clause alone can see. `repeated-vertex` follows from the others and only says it better.
ALONE = {
    "unknown kind": "kind", "index beyond the vertices": "face-index", "input vertex moved": "input-vertices",
    "input vertex outside the domain moved": "input-vertices", "triangle run twice": "face-shape",
    "a sphere outside": "face-shape", "nonproper called proper": "face-size",
    "classic with a Steiner vertex": "steiner", "face twice": "overlap", "two triangulations at once": "overlap",
    "input edge crossed by an edge": "input-edge", "vertex on a wall": "input-edge", "fan through a hole": "boundary",
    "T-vertex not listed": "boundary", "face missing inside": "boundary",
    "internal: a wall split on both sides at different places": "boundary",
    "internal: faces on both sides of the boundary": "boundary",
    "unused Steiner vertex": "unused-vertex", "isolated vertex on an edge of the mesh": "unused-vertex"}


@pytest.mark.parametrize("name", ALONE)
def test_some_harm_breaks_one_clause_alone(name: str) -> None:
    assert HARMED[name][0].judged() == {ALONE[name]}


@pytest.mark.parametrize("name", test_oracle.MESHES)
def test_the_meshes_that_the_oracle_accepts_are_accepted(name: str) -> None:
    given, degradation = test_oracle.MESHES[name]
    found = case(given.points, given.edges, given.mesh_points[len(given.points):], given.faces, given.kind,
                 given.holes)
    assert found.judged() == set() and found.verify().degradation_squared == degradation


@pytest.mark.parametrize("name", test_oracle.HARMED)
def test_the_meshes_that_the_oracle_refuses_are_refused(name: str) -> None:
    given, _ = test_oracle.HARMED[name]
    pslg = Pslg(points(given.points), tuple(given.edges), points(given.holes))
    try:
        domain_of(pslg)
    except exactmesh.InputError:
        return  # the harm is to the input: refused before any mesh is looked at
    assert Case(pslg, Mesh(given.kind, points(given.mesh_points), given.faces)).judged()


# --- places ---


@pytest.mark.parametrize(("name", "clause", "place"), [
    ("input vertex moved", "input-vertices", {"vertex": 1, "at": "(4, 0)"}),
    ("input vertex missing", "input-vertices", {"vertex": 3, "at": "(0, 4)"}),
    ("a second vertex at a place, unused", "repeated-vertex", {"vertex": 5, "other": 4, "at": "(2, 2)"}),
    ("flipped face", "face-shape", {"face": 0, "vertex": 4, "reason": "turns right"}),
    ("nonproper called proper", "face-size", {"face": 0, "vertices": 4}),
    ("classic with a Steiner vertex", "steiner", {"vertex": 4}),
    ("face twice, from another vertex", "overlap", {"edge": [1, 4], "face": 4, "other": 0}),
    ("T-vertex not listed", "boundary", {"edge": [2, 0], "face": 0}),
    ("fan through a hole", "boundary", {"edge": [4, 5], "face": 8}),
    ("vertex on an input edge", "input-edge", {"edge": [0, 1]}),
    ("unused Steiner vertex", "unused-vertex", {"vertex": 5}),
    ("isolated vertex not used", "unused-vertex", {"vertex": 5}),
    ("index beyond the vertices", "face-index", {"face": 0, "vertex": 5}),
    ("negative index", "face-index", {"face": 0, "vertex": -1}),
    ("unknown kind", "kind", {"kind": "best"}),
])
def test_a_violation_names_its_place(name: str, clause: str, place: dict[str, Any]) -> None:
    found = [(v.clause, dict(v.place)) for v in HARMED[name][0].verify().violations]
    assert (clause, place) in found


def test_an_index_beyond_any_machine_number_is_named() -> None:
    sound = SOUND[next(iter(SOUND))]
    found = sound.with_face(0, (0, 1, 2**70), (0, -(2**70), 1)).verify().violations
    assert [(v.clause, v.place["vertex"]) for v in found] == [("face-index", 2**70), ("face-index", -(2**70))]


# --- every face, every vertex ---


@pytest.mark.parametrize("name", SOUND)
def test_a_mesh_without_any_one_face_or_with_one_twice_is_refused(name: str) -> None:
    sound = SOUND[name]
    for f, face in enumerate(sound.mesh.faces):
        assert not sound.without(f).verify().valid
        assert "overlap" in {v.clause for v in sound.with_face(f, face, face).verify().violations}
        assert "face-shape" in {v.clause for v in sound.with_face(f, face[::-1]).verify().violations}


@pytest.mark.parametrize("name", SOUND)
def test_moving_an_input_vertex_by_a_tiny_step_is_refused(name: str) -> None:
    sound = SOUND[name]
    for v, p in enumerate(sound.pslg.vertices):
        found = sound.with_vertex(v, p.x, p.y - TINY).verify()
        assert "input-vertices" in {violation.clause for violation in found.violations}


def test_moving_a_t_vertex_by_a_tiny_step_across_its_side_is_refused() -> None:
    for sound in (MADE, NONPROPER):
        _, _, t_vertices = steiner_roles(sound)
        assert t_vertices
        for v in t_vertices:
            p = sound.mesh.vertices[v]
            moved = sound.with_vertex(v, p.x + TINY, p.y + 3 * TINY)
            assert "face-shape" in moved.judged()


def test_moving_a_corner_by_a_tiny_step_keeps_the_mesh_valid() -> None:
    moved = 0
    for v in steiner_roles(MADE)[1]:
        p = MADE.mesh.vertices[v]
        changed = MADE.with_vertex(v, p.x + TINY, p.y + 3 * TINY)
        moved += changed.judged() == set()
    assert moved > 0


def steiner_roles(sound: Case) -> tuple[set[int], set[int], set[int]]:
    """Return all Steiner vertices, those that are corners of all of their faces, and T-vertices."""
    at = sound.mesh.vertices
    every = set(range(len(sound.pslg.vertices), len(at)))
    straight = {face[i] for face in sound.mesh.faces for i in range(len(face))
                if oracle.turn(*(oracle.triple(at[face[(i + k) % len(face)]]) for k in (-1, 0, 1))) == 0}
    return every, every - straight, every & straight


# --- laws ---


def turned_faces(given: Case, source: random.Random) -> Case:
    faces = [face[(k := source.randrange(max(len(face), 1))):] + face[:k] for face in given.mesh.faces]
    source.shuffle(faces)
    return given.with_mesh(faces=tuple(faces))


def renumbered(given: Case, source: random.Random) -> Case:
    """Return the mesh with its Steiner vertices in another order."""
    first, count = len(given.pslg.vertices), len(given.mesh.vertices)
    steiner = list(range(first, count))
    source.shuffle(steiner)
    order = [*range(first), *steiner]
    new = {old: i for i, old in enumerate(order)}
    return given.with_mesh(vertices=tuple(given.mesh.vertices[old] for old in order),
                           faces=tuple(tuple(new[v] for v in face) for face in given.mesh.faces))


def scaled(given: Case, source: random.Random) -> Case:
    """Return the input and the mesh turned, shrunk and moved far away."""
    def image(p: Point) -> Point:
        x, y = (3 * p.x - 4 * p.y) * TINY, (4 * p.x + 3 * p.y) * TINY
        return Point(x + 10**20, y - mpq(1, 3))

    pslg = Pslg(tuple(map(image, given.pslg.vertices)), given.pslg.edges, tuple(map(image, given.pslg.holes)))
    return Case(pslg, replace(given.mesh, vertices=tuple(map(image, given.mesh.vertices))))


CALM = {name: harmed for name, (harmed, clause) in HARMED.items()
        if clause != "face-index" and len(harmed.mesh.vertices) >= len(harmed.pslg.vertices)}


@pytest.mark.parametrize("change", [turned_faces, renumbered, scaled])
@pytest.mark.parametrize("name", [*SOUND, *CALM])
def test_order_start_numbering_and_place_change_no_verdict(
        name: str, change: Callable[[Case, random.Random], Case]) -> None:
    given = (SOUND | CALM)[name]
    for seed in range(2):
        before, after = given.verify(), change(given, random.Random(seed)).verify()
        assert {v.clause for v in before.violations} == {v.clause for v in after.violations}
        assert before.degradation_squared == after.degradation_squared


# --- random changes, harmless ones among them: the oracle decides ---


def move_vertex(given: Case, source: random.Random) -> Case:
    v = source.randrange(len(given.mesh.vertices))
    p = given.mesh.vertices[v]
    step = source.choice([TINY, mpq(1, 100), mpq(1)])
    return given.with_vertex(v, p.x + step * source.randint(-1, 1), p.y + step * source.randint(-1, 1))


def move_onto_vertex(given: Case, source: random.Random) -> Case:
    u, v = source.sample(range(len(given.mesh.vertices)), 2)
    return given.with_vertex(u, *given.mesh.vertices[v])


def move_onto_edge(given: Case, source: random.Random) -> Case:
    at = given.mesh.vertices
    a, b = source.choice(list(sides(source.choice(given.mesh.faces))))
    return given.with_vertex(source.randrange(len(at)), (at[a].x + at[b].x) / 2, (at[a].y + at[b].y) / 2)


def drop_face(given: Case, source: random.Random) -> Case:
    return given.without(source.randrange(len(given.mesh.faces)))


def swap_in_face(given: Case, source: random.Random) -> Case:
    f = source.randrange(len(given.mesh.faces))
    face = list(given.mesh.faces[f])
    i, j = source.sample(range(len(face)), 2)
    face[i], face[j] = face[j], face[i]
    return given.with_face(f, tuple(face))


def relabel_in_face(given: Case, source: random.Random) -> Case:
    f = source.randrange(len(given.mesh.faces))
    face = list(given.mesh.faces[f])
    face[source.randrange(len(face))] = source.randrange(len(given.mesh.vertices))
    return given.with_face(f, tuple(face))


def merge_vertices(given: Case, source: random.Random) -> Case:
    a, b = source.choice(list(sides(source.choice(given.mesh.faces))))
    merged = tuple(tuple(b if v == a else v for v in face) for face in given.mesh.faces)
    return given.with_mesh(faces=tuple(face for face in merged if len(set(face)) == len(face)))


def split_face(given: Case, source: random.Random) -> Case:
    """Put a vertex into a face and join it to all on its boundary."""
    f = source.randrange(len(given.mesh.faces))
    face, at = given.mesh.faces[f], given.mesh.vertices
    middle = sum(at[v].x for v in face) / len(face), sum(at[v].y for v in face) / len(face)
    return given.with_more(middle).with_face(f, *((a, b, len(at)) for a, b in sides(face)))


def flip_edge(given: Case, source: random.Random) -> Case:
    """Exchange the diagonal of two triangles that share an edge."""
    owner, _ = directed_edges(given.mesh.faces)
    faces = given.mesh.faces
    shared = [(a, b) for a, b in owner if (b, a) in owner and len(faces[owner[a, b]]) == len(faces[owner[b, a]]) == 3]
    if not shared:
        return given
    a, b = source.choice(sorted(shared))
    f, g = owner[a, b], owner[b, a]
    c, d = (next(v for v in faces[h] if v not in (a, b)) for h in (f, g))
    both = given.with_mesh(faces=(*faces, (c, d, b), (d, c, a)))
    return both.without(f, g)


def split_edge(given: Case, source: random.Random) -> Case:
    """Put a vertex on an edge, and list it on both sides, on one, or cut the triangles beside it."""
    owner, _ = directed_edges(given.mesh.faces)
    a, b = source.choice(sorted(owner))
    at, new = given.mesh.vertices, len(given.mesh.vertices)
    how = source.choice(["listed", "one side", "cut", "cut one side"])
    faces: list[tuple[int, ...]] = []
    for face in given.mesh.faces:
        for u, v in ((a, b), (b, a)):
            if (u, v) in sides(face) and (u == a or "one side" not in how):
                start = face.index(u)
                turned = face[start:] + face[:start]
                if how in ("listed", "one side") or len(face) > 3:
                    faces.append((u, new, *turned[1:]))
                else:
                    faces += [(u, new, turned[2]), (new, v, turned[2])]
                break
        else:
            faces.append(face)
    part = source.choice([mpq(1, 2), mpq(1, 3), TINY])
    place = at[a].x + (at[b].x - at[a].x) * part, at[a].y + (at[b].y - at[a].y) * part
    return given.with_more(place).with_mesh(faces=tuple(faces))


def unlist_t_vertex(given: Case, source: random.Random) -> Case:
    long = [f for f, face in enumerate(given.mesh.faces) if len(face) > 3]
    if not long:
        return given
    f = source.choice(long)
    face = given.mesh.faces[f]
    i = source.randrange(len(face))
    return given.with_face(f, face[:i] + face[i + 1:])


def add_face(given: Case, source: random.Random) -> Case:
    return given.with_mesh(
        faces=(*given.mesh.faces, tuple(source.sample(range(len(given.mesh.vertices)), 3))))


def change_kind(given: Case, source: random.Random) -> Case:
    return given.with_mesh(kind=source.choice(["classic", "nonproper", "proper", "internal"]))


def change_holes(given: Case, source: random.Random) -> Case:
    """Mark the face of the input that holds the middle of a random face of the mesh; leave the mesh."""
    at = [given.mesh.vertices[v] for v in source.choice(given.mesh.faces)]
    hole = Point(sum(p.x for p in at) / len(at), sum(p.y for p in at) / len(at))
    pslg = Pslg(given.pslg.vertices, given.pslg.edges, (hole,))
    try:
        domain_of(pslg)
    except exactmesh.InputError:
        return given
    return replace(given, pslg=pslg)


def forget_input_edge(given: Case, source: random.Random) -> Case:
    """Take an edge from the input; leave the mesh."""
    e = source.randrange(len(given.pslg.edges))
    pslg = Pslg(given.pslg.vertices, given.pslg.edges[:e] + given.pslg.edges[e + 1:], given.pslg.holes)
    try:
        domain_of(pslg)
    except exactmesh.InputError:
        return given
    return replace(given, pslg=pslg)


CHANGES = [move_vertex, move_onto_vertex, move_onto_edge, drop_face, swap_in_face, relabel_in_face, merge_vertices,
           split_face, flip_edge, split_edge, unlist_t_vertex, add_face, change_kind, change_holes, forget_input_edge]
STARTS = [SOUND[name] for name in SOUND if name not in ("made of a pslg",)]


@pytest.mark.parametrize("change", CHANGES)
def test_random_changes_are_judged_as_by_the_oracle(change: Callable[[Case, random.Random], Case]) -> None:
    for number, start in enumerate(STARTS):
        for seed in range(8):
            change(start, random.Random(f"{change.__name__} {number} {seed}")).judged()


def test_random_chains_of_changes_are_judged_as_by_the_oracle() -> None:
    # Only sound meshes are changed further, so the chains stray far from the first ones.
    gentle = [split_face, flip_edge, split_edge, change_kind, move_vertex, forget_input_edge]
    valid = 0
    for seed in range(300):
        source = random.Random(seed)
        given = source.choice(STARTS[:14])
        for _ in range(5):
            changed = source.choice(gentle)(given, source)
            if not changed.judged():
                given, valid = changed, valid + 1
    assert valid > 200


def violated(found: Verification, clause: str) -> list[dict[str, object]]:
    return [dict(violation.place) for violation in found.violations if violation.clause == clause]


@pytest.mark.parametrize("outside", [0, 1, 2])
def test_the_face_beyond_the_rim_is_the_one_that_is_shown_wherever_it_is_listed(outside: int) -> None:
    faces = [(0, 1, 2), (0, 2, 3)]
    faces.insert(outside, (1, 0, 4))
    found = case(SQUARE, cycle(4), [(2, -2)], tuple(faces), "proper").verify()
    assert {"edge": [1, 0], "face": outside} in violated(found, "boundary")
    assert {"edge": [0, 1], "face": 0 if outside else 1} not in violated(found, "boundary")


def test_an_input_vertex_that_is_missing_is_no_other_one() -> None:
    # Of three vertices, edges are numbered from * 3 + to: from 1 to the missing 3 would be from 2 to 0.
    square = case(SQUARE, [*cycle(4), (1, 3)], [], ((0, 1, 2),), "proper")
    found = square.with_mesh(vertices=square.mesh.vertices[:3]).verify()
    assert {"edge": [1, 3]} in violated(found, "input-edge") and {"edge": [3, 1]} in violated(found, "input-edge")
    assert {"edge": [2, 3]} in violated(found, "input-edge") and {"edge": [0, 1]} not in violated(found, "input-edge")


def test_an_internal_mesh_may_lack_an_input_vertex() -> None:
    square = case(SQUARE, cycle(4), [], ((0, 1, 2),), "internal")
    found = square.with_mesh(vertices=square.mesh.vertices[:3]).verify()
    assert violated(found, "input-edge") == [{"edge": [2, 3]}, {"edge": [3, 0]}]


def test_a_corner_of_the_domain_without_a_face_is_unused() -> None:
    found = case(SQUARE, cycle(4), [], ((0, 1, 2),), "proper").verify()
    assert violated(found, "unused-vertex") == [{"vertex": 3}]


def test_where_nothing_is_lost_the_witness_is_the_input_s() -> None:
    reverse = [(v, u) for u, v in cycle(3)]
    found = case([(0, 0), (4, 0), (1, 3)], reverse, [], ((0, 1, 2),), "classic").verify()
    assert found.valid and found.degradation_squared == 1 and found.mesh_mfs == found.input_mfs
    assert found.mesh_mfs is not None and tuple(found.mesh_mfs.feature) in reverse


def test_internal_feature_sizes_are_those_of_internal_meshes() -> None:
    # The sides of the square are 4 apart; its diagonal passes the corners at half its length.
    square = case(SQUARE, cycle(4), [], ((0, 1, 2), (0, 2, 3)), "internal")
    found = square.verify()
    assert found.valid and found.input_ifs is not None and found.mesh_ifs is not None
    assert (found.input_ifs.squared, found.mesh_ifs.squared, found.ifs_degradation_squared) == (16, 8, 2)
    for other in (square.with_mesh(kind="proper").verify(), square.without(1).verify()):
        assert (other.input_ifs, other.mesh_ifs, other.ifs_degradation_squared) == (None, None, None)
