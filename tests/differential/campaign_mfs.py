"""Compare the exact mfs with GEOS's minimum clearance: python tests/differential/campaign_mfs.py --seed N --count N.

Both are the least distance between a vertex and a vertex or edge that does not contain it. GEOS computes it in doubles;
docs/differential.md proves that its result is off by less than 2**-48 times the diagonal of the bounding box, where no
product over- or underflows, as here. Any result beyond that is an outlier: a fault of one of the two, or of the proof.
Every 50th input is also measured by brute force. Exit status 0 when there is no outlier and no difference.
"""

import argparse
import random
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from math import cos, isqrt, sin
from pathlib import Path

import shapely

sys.path.append(str(Path(__file__).parent.parent))

import oracle

from exactmesh.geometry.point import Point
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.numbers.rational import rational_from_float, sqrt_text
from exactmesh.planar.pslg import Pslg

TOLERANCE = Fraction(1, 2**48)
UNIT = Fraction(1, 2**53)

Place = tuple[float, float]


@dataclass(frozen=True)
class Drawing:
    """Chains of places; a chain of one place is a point. `polygon`: the first is a shell, the others are holes."""

    chains: tuple[tuple[Place, ...], ...]
    polygon: bool = False

    def geometry(self) -> shapely.Geometry:
        if self.polygon:
            return shapely.Polygon(self.chains[0], self.chains[1:])
        parts = [shapely.Point(chain[0]) if len(chain) == 1 else shapely.LineString(chain) for chain in self.chains]
        return parts[0] if len(parts) == 1 else shapely.GeometryCollection(parts)

    def pslg(self) -> Pslg:
        """Return vertices and edges; equal places are one vertex. They may cross: the mfs does not mind."""
        number: dict[Place, int] = {}
        edges: dict[tuple[int, int], None] = {}
        for chain in self.chains:
            ends = [number.setdefault(place, len(number)) for place in chain]
            for u, v in zip(ends, ends[1:] + ends[:1] if self.polygon else ends[1:], strict=False):
                if u != v:
                    edges[min(u, v), max(u, v)] = None
        return Pslg(tuple(Point(rational_from_float(x), rational_from_float(y)) for x, y in number), tuple(edges))


# --- inputs: random, and degenerate on purpose ---


def _lattice(source: random.Random) -> Drawing:
    size = source.choice((2, 3, 5, 20))
    return Drawing((tuple((float(source.randrange(size)), float(source.randrange(size)))
                          for _ in range(source.randrange(3, 12))),), True)


def _random_polygon(source: random.Random) -> Drawing:
    count, angle = source.randrange(3, 40), 0.0
    ring = []
    for _ in range(count):
        angle += 6.28 / count
        radius = source.uniform(0.1, 1)
        ring.append((radius * cos(angle), radius * sin(angle)))
    return Drawing((tuple(ring),), True)


def _lines_and_points(source: random.Random) -> Drawing:
    scale = 10.0 ** source.randrange(-5, 6)
    chains = [tuple((source.uniform(-scale, scale), source.uniform(-1, 1))
                    for _ in range(source.choice((1, 1, 2, 3, 9)))) for _ in range(source.randrange(1, 12))]
    return Drawing(tuple(chains))


def _thin_pentagon(source: random.Random) -> Drawing:
    """A pentagon that is almost a segment, far away or turned, so that distances are differences of large numbers."""
    height, length = 2.0 ** -source.randrange(10, 48), 2.0 ** source.randrange(0, 10)
    dx, dy = source.choice(((1, 0), (3, 4), (1, 1), (-2, 7)))
    ring = []
    for t, h in ((0, 0), (0.3, -1), (1, 0.25), (0.6, 2), (0.2, 1)):
        t, h = t * length, h * height * source.uniform(0.5, 1)
        ring.append((t * dx - h * dy, t * dy + h * dx))
    return Drawing((tuple(ring),), True)


def _spike(source: random.Random) -> Drawing:
    """Two long edges that nearly meet, and vertices nearly on them."""
    length = 2.0 ** source.randrange(5, 60)
    tip = source.uniform(-1, 1)
    ring = [(0.0, 0.0), (length, tip), (source.uniform(0, 1), 2.0 ** -source.randrange(20))]
    ring.insert(2, (length / 3, tip / 3 + 2.0 ** -source.randrange(1, 40)))
    return Drawing((tuple(ring),), True)


def _near_line(source: random.Random) -> Drawing:
    """A vertex as near to an edge as doubles allow, beside others."""
    ax, ay, bx, by = (source.uniform(-1, 1) for _ in range(4))
    t = source.random()
    x, y = ax + t * (bx - ax), ay + t * (by - ay)
    return Drawing((((ax, ay), (bx, by)), ((x, y),), ((source.uniform(2, 3), source.uniform(2, 3)), (5.0, 5.0))))


def _grid(source: random.Random) -> Drawing:
    """Many ties, moved by tiny steps; more than 6 vertices in a chain, so that GEOS cuts it."""
    width, step = source.randrange(3, 9), source.choice((0.0, 2.0**-30, 2.0**-52))
    chains = [tuple((x + step * source.randrange(-3, 4), y + step * source.randrange(-3, 4)) for x in range(width))
              for y in range(source.randrange(1, 6))]
    return Drawing(tuple(chains))


def _far_apart(source: random.Random) -> Drawing:
    """Small clusters far from each other: the bounding boxes that GEOS prunes by lose what is small."""
    chains = []
    for _ in range(source.randrange(2, 7)):
        x, y = (source.uniform(-1, 1) * 2.0**source.randrange(0, 45) for _ in range(2))
        small = 2.0 ** -source.randrange(0, 20)
        chains.append(tuple((x + small * source.uniform(-1, 1), y + small * source.uniform(-1, 1))
                            for _ in range(source.choice((1, 2, 3, 8)))))
    return Drawing(tuple(chains))


def _holes(source: random.Random) -> Drawing:
    gap = 2.0 ** -source.randrange(1, 30)
    shell = ((0.0, 0.0), (8.0, 0.0), (8.0, 8.0), (0.0, 8.0))
    size = source.uniform(1, 3)
    holes = [((x + gap, y + gap), (x + size, y + gap), (x + size, y + size)) for x in (0.0, 4.0) for y in (0.0, 4.0)]
    return Drawing((shell, *holes[: source.randrange(1, 5)]), True)


def _repeated(source: random.Random) -> Drawing:
    """Places that come twice, there and back, vertices on edges: distance 0 where GEOS sees it exactly."""
    drawing = source.choice((_lattice, _grid, _random_polygon))(source)
    chain = list(drawing.chains[0])
    for _ in range(source.randrange(1, 4)):
        place = source.randrange(len(chain))
        chain.insert(place, chain[place - source.choice((0, 0, 1))])
    return Drawing((tuple(chain), *drawing.chains[1:]), drawing.polygon)


def _scaled(source: random.Random) -> Drawing:
    """Another drawing, larger or smaller by a power of two: no rounding."""
    drawing = source.choice((_random_polygon, _thin_pentagon, _lines_and_points, _spike))(source)
    factor = 2.0 ** source.choice((-120, -60, 60, 120))
    chains = (tuple((x * factor, y * factor) for x, y in chain) for chain in drawing.chains)
    return Drawing(tuple(chains), drawing.polygon)


KINDS: dict[str, Callable[[random.Random], Drawing]] = {
    "lattice polygons": _lattice, "random polygons": _random_polygon, "lines and points": _lines_and_points,
    "thin pentagons": _thin_pentagon, "spikes": _spike, "vertex near a line": _near_line, "grids": _grid,
    "far apart": _far_apart, "holes": _holes, "repeated points": _repeated, "scaled": _scaled}


def drawings(seed: int, count: int) -> Iterator[tuple[str, Drawing]]:
    """Yield `count` drawings, of each kind in turn, the same for the same seed."""
    names = list(KINDS)
    for number in range(count):
        name = names[number % len(names)]
        yield name, KINDS[name](random.Random(f"{seed} {number}"))


# --- comparison ---


@dataclass
class Compared:
    """What one input gave; `off` in units of 2**-53 times the diagonal, `relative` to the mfs."""

    is_within: bool
    off: float
    relative: float
    text: str


def root_above(squared: Fraction) -> Fraction:
    """Return a rational above the square root, by less than a part in 2**60 of it."""
    shift = 60 + max(0, squared.denominator.bit_length() - squared.numerator.bit_length())
    return Fraction(isqrt((squared.numerator << 2 * shift) // squared.denominator) + 1, 1 << shift)


def brute_force(pslg: Pslg) -> Fraction | None:
    """Return the squared mfs as `oracle` has it; 0 when a vertex lies inside an edge, which there does not count."""
    at = [oracle.triple(p) for p in pslg.vertices]
    if any(oracle.on_segment(p, at[u], at[v]) for u, v in pslg.edges for w, p in enumerate(at) if w not in (u, v)):
        return Fraction(0)
    return oracle.mfs_squared(pslg.vertices, pslg.edges)


def compared(drawing: Drawing, clearance: float, with_oracle: bool = False) -> Compared:
    """Compare a clearance with the exact mfs, exactly; floats only say how far they are apart."""
    pslg = drawing.pslg()
    nearest = minimum_feature_size(pslg)
    if with_oracle:
        truth = brute_force(pslg)
        if truth != (None if nearest is None else Fraction(nearest.squared)):
            return Compared(False, 0, 0, f"brute force gives the square {truth}")
    if nearest is None or clearance == float("inf"):
        same = nearest is None and clearance == float("inf")
        return Compared(same, 0, 0, f"{clearance} against {nearest}")
    squared = Fraction(nearest.squared)
    sides = [max(p[axis] for p in pslg.vertices) - min(p[axis] for p in pslg.vertices) for axis in (0, 1)]
    diagonal = root_above(sum((Fraction(side) ** 2 for side in sides), Fraction(0)))
    found, room = Fraction(clearance), diagonal * TOLERANCE
    is_within = (found - room <= 0 or (found - room) ** 2 <= squared) and (found + room) ** 2 >= squared
    # |found - root| = |found^2 - squared| / (found + root)
    root = root_above(squared) if squared else Fraction(0)
    off = abs(found * found - squared) / (found + root) if found + root else Fraction(0)
    relative = off / root if root else Fraction(0)
    return Compared(is_within, float(off / (UNIT * diagonal)), float(relative),
                    f"{clearance!r} against {sqrt_text(nearest.squared, 17)}")


def by_geos(drawing: Drawing) -> float:
    return float(shapely.minimum_clearance(drawing.geometry()))


def run(seed: int, count: int, measure: Callable[[Drawing], float] = by_geos) -> tuple[list[str], str]:
    """Return the outliers among the clearances that `measure` finds, and a table."""
    rows = {name: [0, 0, 0.0, 0.0] for name in KINDS}
    worst: dict[str, tuple[float, str]] = {}
    outliers: list[str] = []
    for number, (name, drawing) in enumerate(drawings(seed, count)):
        result = compared(drawing, measure(drawing), number % 50 == 0)
        row = rows[name]
        row[0] += 1
        row[2], row[3] = max(row[2], result.off), max(row[3], result.relative)
        if result.relative > worst.get(name, (0.0, ""))[0]:
            worst[name] = result.relative, f"{result.text}: {drawing}"
        if not result.is_within:
            row[1] += 1
            outliers.append(f"{name}, {number}: {result.text}: {drawing}")
    lines = [" inputs outliers  off/(u diagonal)  relative  kind"]
    lines += [f"{n:7} {out:8} {off:17.3g} {relative:9.2g}  {name}" for name, (n, out, off, relative) in rows.items()]
    if worst:
        name = max(worst, key=lambda name: worst[name][0])
        lines.append(f"farthest off for its size ({worst[name][0]:.3g}): {worst[name][1]}")
    lines.append(f"{count} inputs, seed {seed}, GEOS {shapely.geos_version_string}: {len(outliers)} outliers")
    return outliers, "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, default=2000)
    args = parser.parse_args()
    begin = time.perf_counter()
    outliers, table = run(args.seed, args.count)
    print("\n".join([*outliers[:20], table, f"{time.perf_counter() - begin:.0f} s"]))
    return 1 if outliers else 0


if __name__ == "__main__":
    sys.exit(main())
