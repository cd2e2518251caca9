"""Convex regions bounded by lines, cut exactly.

A region keeps its lines beside its corners, and a new corner is the meeting point of two given lines: so every
coordinate lies in the field of two lines, however often a region is cut.
"""

from typing import Any, NamedTuple

from exactmesh.dissection.records import Vector
from exactmesh.numbers.algebraic import Real
from exactmesh.numbers.interval import sign_of


class Line(NamedTuple):
    """The line a x + b y + c = 0."""

    a: Real
    b: Real
    c: Real


class Region(NamedTuple):
    """Corners of a strictly convex polygon, counter-clockwise; `lines[i]` holds the side from corner i to i + 1."""

    corners: tuple[Vector, ...]
    lines: tuple[Line, ...]


def side(line: Line, p: Vector) -> int:
    """Return the sign of a p.x + b p.y + c, from intervals unless it may be zero."""
    return sign_of(_value, line.a, line.b, line.c, p.x, p.y)


def meeting_point(k: Line, m: Line) -> Vector:
    """Return the common point of two lines; raises `ZeroDivisionError` when they are parallel."""
    over = 1 / (k.a * m.b - k.b * m.a)
    return Vector((k.b * m.c - k.c * m.b) * over, (k.c * m.a - k.a * m.c) * over)


def split(region: Region, line: Line) -> tuple[Region | None, Region | None]:
    """Return the parts of a region where the line's form is negative and where it is positive, None if empty."""
    signs = [side(line, p) for p in region.corners]
    if min(signs) >= 0:
        return None, region
    if max(signs) <= 0:
        return region, None
    meeting: dict[int, Vector] = {}
    count = len(signs)
    for i in range(count):
        if signs[i] * signs[(i + 1) % count] < 0:
            meeting[i] = meeting_point(region.lines[i], line)
    return _part(region, line, [-s for s in signs], meeting), _part(region, line, signs, meeting)


def _part(region: Region, line: Line, signs: list[int], meeting: dict[int, Vector]) -> Region:
    """Return the part where `signs` are positive: where it leaves, `line` becomes the next side."""
    corners: list[Vector] = []
    lines: list[Line] = []
    count = len(signs)
    for i, (p, own) in enumerate(zip(region.corners, region.lines, strict=True)):
        after = signs[(i + 1) % count]
        if signs[i] > 0 or (signs[i] == 0 and after > 0):
            corners.append(p)
            lines.append(own)
        elif signs[i] == 0:
            corners.append(p)
            lines.append(line)
        if i in meeting:
            corners.append(meeting[i])
            lines.append(line if signs[i] > 0 else own)
    return Region(tuple(corners), tuple(lines))


def _value(a: Any, b: Any, c: Any, x: Any, y: Any) -> Any:
    return a * x + b * y + c
