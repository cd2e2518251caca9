"""The repaired construction on named inputs, exact tiling by brute force, and the clauses a checker can name."""

import ast
import inspect
import random
from collections import Counter
from collections.abc import Sequence
from fractions import Fraction
from functools import cache
from itertools import pairwise
from types import ModuleType
from typing import Any, NamedTuple

import families
import oracle
from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import Nearest, minimum_feature_size
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import Construction, construct
from exactmesh.steps.constants import LEVEL
from exactmesh.steps.offset import offset
from exactmesh.steps.records import Offset, Shape, Trapezoidation
from exactmesh.steps.shape import shape_of


def point(x: int | str | Fraction, y: int | str | Fraction) -> Point:
    """Return an exact point."""
    return Point(mpq(x), mpq(y))


def graph(corners: Sequence[Sequence[int | str]], edges: Sequence[tuple[int, int]] = ()) -> Pslg:
    """Return a PSLG; without edges, the polygon with these corners."""
    cycle = tuple((i, (i + 1) % len(corners)) for i in range(len(corners)))
    return Pslg(tuple(point(x, y) for x, y in corners), tuple(edges) or cycle)


HALL = Pslg(
    tuple(point(x, y) for x, y in (
        (0, 0), (30, 1), (31, 9), (16, 8), (15, 5), (14, 8), (2, "19/2"),  # a room with a spike from the ceiling
        (4, 3), (5, 5), (7, "7/2"),                                        # a hole
        (10, 3), (12, 4),                                                  # a slit with two ends
        (20, 5), (24, "11/2"),                                             # two isolated vertices
        (28, "61/10"))),                                                   # the end of a dangling edge
    (*((i, (i + 1) % 7) for i in range(7)), (7, 8), (8, 9), (9, 7), (10, 11), (2, 14)),
    (point("16/3", 4),), "hall")
"""One face with every kind of corner: convex, reflex, of a hole, ends of slits, isolated."""


class Made(NamedTuple):
    """One input with every step of the repaired construction and the verification of the mesh."""

    subdivision: Subdivision
    mfs: Nearest
    construction: Construction
    verification: Verification


def made_of(pslg: Pslg) -> Made:
    """Return the steps of the construction on `pslg`."""
    subdivision = domain_of(pslg)
    nearest = minimum_feature_size(pslg)
    assert nearest is not None
    construction = construct(subdivision, nearest.squared)
    return Made(subdivision, nearest, construction, verify_mesh(subdivision, construction.mesh))


@cache
def run(name: str) -> Made:
    """Return the steps on `HALL` or on one of the families of small inputs, by name."""
    return made_of(HALL if name == "hall" else (families.ALL_SMALL | families.SMALL_PSLGS)[name])


def unit_shape(pslg: Pslg) -> Shape:
    """Return the shape of a PSLG that is given in units of its own mfs, or is taken to be."""
    return shape_of(domain_of(pslg), mpq(1))


def offset_of(pslg: Pslg) -> Offset:
    """Return the offset of a PSLG given in units of its mfs."""
    return offset(unit_shape(pslg))


def rings_on_levels(*rings: Sequence[tuple[Any, int]]) -> Offset:
    """Return rings of (x, level) as an `Offset` that comes from no polygon, numbered from 100."""
    flat = [p for ring in rings for p in ring]
    starts = [sum(map(len, rings[:i])) for i in range(len(rings) + 1)]
    count = len(flat)
    return Offset(100, tuple(mpq(x) for x, _ in flat), tuple(level for _, level in flat), tuple(range(count)),
                  tuple(range(count)), tuple(pairwise(starts)),
                  tuple(Point(mpq(x), (level + mpq(1, 2)) * LEVEL) for x, level in flat))


def points_of(q: Offset, chords: Trapezoidation) -> list[Any]:
    """Return the points of Q and the chord ends by number; those of P are all somewhere else."""
    return [Point(mpq(-999), mpq(-999))] * q.first + [*q.points, *chords.points]


def cycle_area(points: Sequence[Point], cycle: Sequence[int]) -> Fraction:
    """Return the signed area of a cycle."""
    return oracle.polygon_area([points[v] for v in cycle])


def untiled(points: Sequence[Point], outline: Sequence[int], faces: Sequence[Sequence[int]]) -> list[str]:
    """Return, in words, why the faces do not tile the simple polygon `outline`; [] when they do.

    Every face turns left at three vertices and goes straight on at the others, directed edges cancel to those of the
    outline, and areas add up.
    """
    found = []
    at = [oracle.triple(p) for p in points]
    for face in faces:
        turns = [oracle.turn(at[face[i - 1]], at[face[i]], at[face[(i + 1) % len(face)]]) for i in range(len(face))]
        if sorted(turns) != [0] * (len(face) - 3) + [1] * 3:
            found.append(f"{face} is no counter-clockwise triangle")
    sides = Counter((face[i - 1], face[i]) for face in faces for i in range(len(face)))
    found += [f"{side} is on two faces" for side, count in sides.items() if count > 1]
    open_sides = {side for side in sides if side[::-1] not in sides}
    wanted = {(outline[i - 1], outline[i]) for i in range(len(outline))}
    if open_sides != wanted:
        found.append(f"boundary differs at {open_sides ^ wanted}")
    if sum((cycle_area(points, face) for face in faces), Fraction(0)) != cycle_area(points, outline):
        found.append("areas do not add up")
    return found


def face_feature_squared(points: Sequence[Point], face: Sequence[int]) -> Fraction:
    """Return the squared feature size of one face from the definition, all vertices against all edges."""
    best = oracle.mfs_squared([points[v] for v in face], [(i - 1, i) for i in range(1, len(face))]
                              + [(len(face) - 1, 0)])
    assert best is not None
    return best


def clauses_of(checker: ModuleType) -> set[str]:
    """Return every clause the source of a checker can name: what it gives to `failed`, `Tally` and `Witness`, and
    the texts it returns."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(inspect.getsource(checker))):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            place = {"failed": 1, "Tally": 0, "Witness": 0}.get(node.func.id)
            texts = [] if place is None else node.args[place : place + 1]
        else:
            texts = [node.value] if isinstance(node, ast.Return) and node.value is not None else []
        found |= {text for node in texts if (text := _text(node)) is not None}
    return found


def _text(node: ast.expr) -> str | None:
    """Return a text as it stands in a source, with {} for what is put into it."""
    if isinstance(node, ast.JoinedStr):
        return "".join(_text(part) or "{}" for part in node.values)
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def lattice_polygon(n: int, size: int, seed: int) -> Pslg:
    """Return a random simple polygon, counter-clockwise, on a lattice of size x size points: straight angles, too."""
    source = random.Random(f"lattice {n} {size} {seed}")
    while True:
        corners = source.sample([(x, y) for x in range(size) for y in range(size)], n)
        pslg = families.ring(corners)
        try:
            domain_of(pslg)
        except InputError:
            continue
        return pslg if oracle.polygon_area(pslg.vertices) > 0 else families.ring(corners[::-1])
