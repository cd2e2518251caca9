"""Exact inputs for tests: the families of the package under one name, and collections of them.

Every function returns a `Pslg` with rational coordinates and depends on its arguments only: random families
take a seed. Polygons are listed counter-clockwise unless a docstring says otherwise. Nothing here validates
its result; `test_families.py` does.

Collections    ALL_SMALL, SMALL_PSLGS, issue_list
"""

from fractions import Fraction

from gmpy2 import mpq

from exactmesh.families.build import SHARP, Number, Pair, cycle, ring
from exactmesh.families.changes import (
    big_coordinates,
    mirrored,
    moved_by,
    reversed_orientation,
    rotated,
    scaled,
    translated,
    with_collinear_vertices,
    with_start,
)
from exactmesh.families.domains import (
    boxed_tree,
    grid_map,
    nested_rings,
    polygon_with_holes,
    random_pslg,
    random_segments,
    thin_walls,
    wheel,
)
from exactmesh.families.random_polygons import KINDS, random_simple_polygon, slits, spike_with_ledges
from exactmesh.families.shapes import (
    comb,
    convex_spike,
    curved_spiral,
    l_shape,
    leaning_strip,
    rectangle_with_two_midway_vertices,
    rectangular_spiral,
    reflex_notch,
    regular_polygon,
    sliver,
    spike_room,
    staircase,
    star,
    walled_spiral,
)
from exactmesh.geometry.point import Point
from exactmesh.planar.pslg import Pslg

__all__ = [
    "ALL_SMALL", "KINDS", "SHARP", "SMALL_PSLGS", "Fraction", "Number", "Pair", "Point", "big_coordinates",
    "boxed_tree", "comb", "convex_spike", "curved_spiral", "grid_map", "issue_list", "l_shape", "leaning_strip",
    "mirrored", "moved_by", "mpq", "nested_rings", "polygon_with_holes", "random_pslg", "random_segments",
    "random_simple_polygon", "rectangle_with_two_midway_vertices", "rectangular_spiral", "reflex_notch",
    "regular_polygon", "reversed_orientation", "ring", "rotated", "scaled", "slits", "sliver", "spike_room",
    "spike_with_ledges", "staircase", "star", "thin_walls", "translated", "walled_spiral", "wheel",
    "with_collinear_vertices", "with_start",
]


def _small() -> dict[str, Pslg]:
    base = {
        "triangle": ring([(0, 0), (4, 0), (1, 3)]),
        "triangle with vertices on its sides": with_collinear_vertices(ring([(0, 0), (4, 0), (1, 3)]), 2),
        "square": regular_polygon(4),
        "unit square": ring([(0, 0), (1, 0), (1, 1), (0, 1)]),
        "pentagon": regular_polygon(5),
        "hexagon": regular_polygon(6),
        "13-gon": regular_polygon(13),
        "40-gon": regular_polygon(40),
        "midway 3": rectangle_with_two_midway_vertices(3),
        "midway 100": rectangle_with_two_midway_vertices(100),
        "comb 1": comb(1),
        "comb 5": comb(5),
        "comb 12 long floor": comb(12, 500),
        "comb 8 uneven": comb(8, 60, "uneven"),
        "comb 8 doubling": comb(8, 600, "doubling"),
        "comb 10 nearly level": comb(10, 40, "even", SHARP),
        "comb 9 uneven nearly level": comb(9, 70, "uneven", SHARP),
        "spike room": spike_room(1000),
        "l-shape 44": l_shape(44),
        "rectangular spiral": rectangular_spiral(3),
        "curved spiral": curved_spiral(2, 12),
        "convex spike 1e-6": convex_spike(),
        "convex spike 1e-2": convex_spike(Fraction(1, 100)),
        "reflex notch 1e-6": reflex_notch(),
        "reflex notch 1e-2": reflex_notch(Fraction(1, 100)),
        "sliver": sliver(1000),
        "sliver with bends": sliver(10**6, SHARP, 9),
        "star 5": star(5),
        "star 12": star(12),
        "staircase": staircase(9),
        "flat staircase": staircase(8, 100, Fraction(1, 7)),
    }
    for kind in KINDS:
        for n in (4, 9, 24, 50):
            base[f"{kind} {n}"] = random_simple_polygon(n, 1, kind)
    ell, tooth = l_shape(20), comb(4, 30, "uneven")
    changed = {
        "30 digits": big_coordinates(random_simple_polygon(30, 2, "growth"), 1),
        "30 digits comb": big_coordinates(tooth, 2),
        "tiny": scaled(tooth, Fraction(1, 10**30)),
        "huge": scaled(ell, 10**30),
        "far away": translated(ell, 10**12, Fraction(-(10**12), 7)),
        "turned l-shape": rotated(ell, Fraction(1, 3)),
        "turned comb": rotated(tooth, Fraction(17, 1000)),
        "slightly turned comb": rotated(tooth, SHARP),
        "mirrored": mirrored(tooth),
        "reversed": reversed_orientation(tooth),
        "started elsewhere": with_start(tooth, 5),
        "collinear vertices": with_collinear_vertices(tooth, 3),
        "collinear vertices on a turned l-shape": with_collinear_vertices(rotated(ell, Fraction(2, 7)), 4),
    }
    return base | changed


def _named(inputs: dict[str, Pslg]) -> dict[str, Pslg]:
    """Give every input the name it is filed under."""
    return {name: Pslg(p.vertices, p.edges, p.holes, name=name) for name, p in inputs.items()}


ALL_SMALL: dict[str, Pslg] = _named(_small())
"""Simple polygons of at most 60 vertices, of every family."""

SMALL_PSLGS: dict[str, Pslg] = _named(
    {f"random pslg {seed}": random_pslg(seed, 2) for seed in range(8)}
    | {f"map {seed}": grid_map(4, 3, seed) for seed in range(3)}
    | {"turned pslg": rotated(random_pslg(20, 2), Fraction(1, 9)),
       "square and two points": Pslg(
           ring([(0, 0), (4, 0), (4, 4), (0, 4), (2, 2), (mpq(17, 8), 2)]).vertices, tuple(cycle(4))),
       "two squares": Pslg(ring([(0, 0), (2, 0), (2, 2), (0, 2), (5, 0), (6, 0), (6, 1), (5, 1)]).vertices,
                           (*cycle(4), (4, 5), (5, 6), (6, 7), (7, 4)))})
"""General PSLGs of at most about 60 vertices: holes, nested rings, trees, isolated points, maps."""


def issue_list() -> dict[str, Pslg]:
    """Return every family in representative sizes up to 200 vertices, simple polygons all."""
    found: dict[str, Pslg] = {}
    for n in (3, 4, 5, 6, 7, 8, 12, 17, 32, 64, 100, 200):
        found[f"regular {n}"] = regular_polygon(n)
    for r in (2, 3, 4, 10, 100, 10**4, 10**6):
        found[f"midway {r}"] = rectangle_with_two_midway_vertices(r)
    for teeth in (1, 2, 3, 10, 30, 98):
        for spacing in ("even", "uneven"):
            for difference in (0, SHARP):
                found[f"comb {teeth} {spacing} difference {difference}"] = comb(
                    teeth, 6 * (teeth + 1), spacing, difference)
        found[f"comb {teeth} long floor"] = comb(teeth, 10**4)
    found["comb 16 doubling"] = comb(16, 10**6, "doubling")
    for length in (3, 10, 10**3, 10**6):
        found[f"spike room {length}"] = spike_room(length)
        found[f"l-shape {length}"] = l_shape(length)
    for length in (44, 96, 192):
        found[f"l-shape {length}"] = l_shape(length)
    for turns in (1, 5, 24):
        found[f"rectangular spiral {turns}"] = rectangular_spiral(turns)
    for turns, per_turn in ((1, 12), (3, 16), (4, 24)):
        found[f"curved spiral {turns}"] = curved_spiral(turns, per_turn)
    for angle in (Fraction(1, 10), Fraction(1, 1000), SHARP):
        found[f"convex spike {angle}"] = convex_spike(angle)
        found[f"reflex notch {angle}"] = reflex_notch(angle)
    for bends in (0, 1, 10, 90):
        found[f"sliver {bends} bends"] = sliver(10**5, SHARP, bends)
    for spikes in (3, 5, 20, 100):
        found[f"star {spikes}"] = star(spikes)
    for steps in (1, 10, 99):
        found[f"staircase {steps}"] = staircase(steps)
        found[f"nearly flat staircase {steps}"] = staircase(steps, 10, SHARP)
    for kind in KINDS:
        for n, seed in ((10, 1), (40, 2), (100, 3), (200, 4)):
            found[f"{kind} {n}"] = random_simple_polygon(n, seed, kind)
    for name in ("comb 10 uneven difference 0", "growth 40", "partition 100", "l-shape 96",
                 "reflex notch 1/1000"):
        base = found[name]
        found |= {f"{name}, 30 digits": big_coordinates(base, 7),
                  f"{name}, scale 1e-30": scaled(base, Fraction(1, 10**30)),
                  f"{name}, turned": rotated(base, Fraction(2, 9)),
                  f"{name}, nearly unturned": rotated(base, SHARP),
                  f"{name}, far away": translated(base, 10**15, Fraction(-(10**15), 3)),
                  f"{name}, mirrored": mirrored(base),
                  f"{name}, reversed": reversed_orientation(base),
                  f"{name}, started elsewhere": with_start(base, len(base.vertices) // 2),
                  f"{name}, collinear vertices": with_collinear_vertices(base, 1)}
    return _named(found)
