"""Polygons of one shape each, known to be hard: combs, spirals, spikes, slivers, long rooms.

Corners are rational and listed counter-clockwise; a function depends on its arguments only. Nothing is validated here.
"""

from collections.abc import Callable
from fractions import Fraction
from itertools import accumulate

from gmpy2 import mpq

from exactmesh.families.build import SHARP, Number, Pair, near_circle, ring
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.constants import LEVEL


def regular_polygon(n: int) -> Pslg:
    """Return n >= 3 rational points exactly on the unit circle, near the vertices of the regular n-gon.

    The angle is reduced to [-pi/4, pi/4] by exact quarter turns; there the point is
    ((1-t^2)/(1+t^2), 2t/(1+t^2)), with t the tangent of half the angle rounded to a multiple of 1/(64 n).
    Vertex 0 is (1, 0).
    """
    return ring(near_circle(n), f"regular {n}-gon")


def rectangle_with_two_midway_vertices(r: Number) -> Pslg:
    """Return the r x 1 rectangle, r > 1, with two vertices midway along its lower side, 1 apart (n = 6).

    Mitchell's example (Bern, Dobkin and Eppstein 1995): every classic triangulation degrades by about r/2.
    """
    middle = mpq(r) / 2
    half = mpq(1, 2)
    return ring([(0, 0), (middle - half, 0), (middle + half, 0), (r, 0), (r, 1), (0, 1)],
                f"rectangle {r} x 1 with two midway vertices")


def comb(teeth: int, floor: Number | None = None, spacing: str = "even", level_difference: Number = 0,
         depth: Number = 3) -> Pslg:
    """Return a room with one long floor and `teeth` >= 1 teeth that end at height 1 (n = 2 teeth + 3).

    The teeth hang from a ceiling at height 1 + `depth`. `floor` is the floor's length, 2 teeth + 2 when left
    out. The tips stand evenly ("even"), at gaps that repeat 1, 5, 2, 11 ("uneven") or at gaps that double
    ("doubling"), scaled to the floor. The tips lie at 1 plus a multiple 0, 3, 1, 4, 2, 0, ... of
    `level_difference`: 0 puts all on one level, 1e-6 on five nearly equal levels.
    """
    widths: dict[str, Callable[[int], int]] = {
        "even": lambda i: 1, "uneven": lambda i: (1, 5, 2, 11)[i % 4], "doubling": lambda i: 2**i}
    ends = list(accumulate(map(widths[spacing], range(teeth + 1))))
    length = mpq(2 * teeth + 2 if floor is None else floor)
    unit = length / ends[-1]
    tips = [unit * end for end in ends[:-1]]
    top = 1 + mpq(depth)
    corners: list[Pair] = [(0, 0), (length, 0), (length, top)]
    for i in range(teeth - 1, -1, -1):
        corners.append((tips[i], 1 + mpq(level_difference) * (3 * i % 5)))
        corners.append(((tips[i] + tips[i - 1]) / 2 if i else 0, top))
    return ring(corners, f"comb of {teeth} teeth, {spacing}, floor {length}, difference {level_difference}")


def spike_room(length: Number) -> Pslg:
    """Return the room [0, length] x [0, 2], length >= 3, with one spike from the ceiling to (3/2, 1)."""
    return ring([(0, 0), (length, 0), (length, 2), (2, 2), (mpq(3, 2), 1), (1, 2), (0, 2)],
                f"room of length {length} with a spike")


def l_shape(length: Number) -> Pslg:
    """Return the hexagon (0,1), (2,1), (2,0), (L,0), (L,2), (0,2), L > 2: the paper's P6 degrades with L."""
    return ring([(0, 1), (2, 1), (2, 0), (length, 0), (length, 2), (0, 2)], f"L of length {length}")


def rectangular_spiral(turns: int) -> Pslg:
    """Return a corridor of width 1 between walls of thickness 1, wound `turns` times (n = 8 turns + 2)."""
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    segments = 4 * turns
    at = (0, 0)
    left: list[Pair] = []
    right: list[Pair] = []
    normals = [(-dy, dx) for dx, dy in directions]
    for i in range(segments + 1):
        into = normals[max(i - 1, 0) % 4]
        out = normals[min(i, segments - 1) % 4]
        # At an end the two normals agree and only one of them counts.
        nx, ny = into if into == out else (into[0] + out[0], into[1] + out[1])
        left.append((at[0] + mpq(nx, 2), at[1] + mpq(ny, 2)))
        right.append((at[0] - mpq(nx, 2), at[1] - mpq(ny, 2)))
        dx, dy = directions[i % 4]
        length = 2 * (i // 2 + 1)
        at = (at[0] + dx * length, at[1] + dy * length)
    return ring(right + left[::-1], f"rectangular spiral of {turns} turns")


def curved_spiral(turns: int, per_turn: int = 16) -> Pslg:
    """Return a corridor of width about 1 wound `turns` times, rational points on circles of growing radius.

    Position i of the 1 + turns * per_turn lies at the radii 2 + 2 i/per_turn and 3 + 2 i/per_turn along the
    directions of `regular_polygon(per_turn)`; n = 2 (1 + turns * per_turn).
    """
    directions = near_circle(per_turn)
    inner: list[Pair] = []
    outer: list[Pair] = []
    for i in range(turns * per_turn + 1):
        x, y = directions[i % per_turn]
        radius = 2 + Fraction(2 * i, per_turn)
        inner.append((x * radius, y * radius))
        outer.append((x * (radius + 1), y * (radius + 1)))
    return ring(outer + inner[::-1], f"curved spiral of {turns} turns")


def convex_spike(angle: Number = SHARP) -> Pslg:
    """Return a 4 x 4 square with a spike of base 1 and length 1/angle: its tip angle is about `angle`."""
    length = 1 / mpq(angle)
    return ring([(0, 0), (4, 0), (4, mpq(3, 2)), (4 + length, 2), (4, mpq(5, 2)), (4, 4), (0, 4)],
                f"convex spike of angle {angle}")


def reflex_notch(angle: Number = SHARP) -> Pslg:
    """Return a room of height 5 with a notch of base 1 and length 1/angle in its left wall."""
    length = 1 / mpq(angle)
    return ring([(0, 0), (length + 4, 0), (length + 4, 5), (0, 5), (0, 3), (length, mpq(5, 2)), (0, 2)],
                f"reflex notch of angle {angle}")


def sliver(length: Number, rise: Number = SHARP, bends: int = 0) -> Pslg:
    """Return a nearly horizontal strip of height 1 and this length: the ends of each piece differ by `rise`.

    `bends` = 0 gives the parallelogram (0,0), (length, rise), (length, 1 + rise), (0, 1); otherwise both long
    sides have that many vertices, alternately raised by `rise` and not (n = 4 + 2 bends).
    """
    count = bends + 1
    lower = [(mpq(length) * i / count, mpq(rise) * (i % 2)) for i in range(count + 1)]
    upper = [(x, y + 1) for x, y in reversed(lower)]
    return ring([*lower, *upper], f"sliver {length} x 1, rise {rise}, {bends} bends")


def star(n: int, inner: Number = Fraction(1, 8)) -> Pslg:
    """Return a star with n >= 3 spikes as long as the figure: radii 1 and `inner` in turn, 2 n vertices."""
    corners = [(x * r, y * r) for i, (x, y) in enumerate(near_circle(2 * n))
               for r in (Fraction(1) if i % 2 == 0 else Fraction(inner),)]
    return ring(corners, f"star of {n} spikes")


def staircase(steps: int, tread: Number = 1, riser: Number = 1) -> Pslg:
    """Return a staircase of `steps` >= 1 steps above a floor, highest at the left (n = 2 steps + 2)."""
    a, b = mpq(tread), mpq(riser)
    corners: list[Pair] = [(0, 0), (steps * a, 0)]
    for i in range(steps):
        corners += [((steps - i) * a, (i + 1) * b), ((steps - i - 1) * a, (i + 1) * b)]
    return ring(corners, f"staircase of {steps} steps, {tread} x {riser}")


def walled_spiral(turns: int, thickness: Number, per_turn: int = 16) -> Pslg:
    """Return a corridor of width about 1 wound around itself with a wall of this thickness between the turns."""
    directions = near_circle(per_turn)
    count = turns * per_turn
    outer: list[Pair] = []
    inner: list[Pair] = []
    for i in range(count + 1):
        x, y = directions[i % per_turn]
        radius = 2 + Fraction(i, per_turn)
        inner.append((x * radius, y * radius))
        outer.append((x * (radius + 1 - mpq(thickness)), y * (radius + 1 - mpq(thickness))))
    return ring([*outer, *inner[::-1]], f"walled spiral of {turns} turns")


def leaning_strip(run: Number, offset: Number, start: Number = Fraction(501, 1000), pieces: int = 1) -> Pslg:
    """Return a long strip of height just above 1 that rises by one level of the repaired construction per `run`.

    Below there are vertices every `run`, from `start` levels up, above as well but `offset` to the left (180 degrees
    all): both sides are snapped towards each other when the offset is a little above 0.31 run.
    """
    slope = LEVEL / mpq(run)
    low = mpq(start) * LEVEL
    inner = [k * mpq(run) for k in range(pieces + 1)]
    ends = [-3 * mpq(run)], [(pieces + 3) * mpq(run)]
    below, above = [*ends[0], *inner, *ends[1]], [*ends[0], *(x - mpq(offset) for x in inner), *ends[1]]
    height = 1 + slope**2
    return ring([*((x, low + slope * x) for x in below), *((x, low + slope * x + height) for x in above[::-1])],
                f"leaning strip, {run} a level, offset {offset}")
