"""Layers of a panel, from exact records: edges, faces by feature size, vertices by maker, distances, words.

Shapes of one look become one layer, so that a picture of many faces stays small. Lines and dots shrink with `grain`,
the height in pixels that half of the visible faces have at least.
"""

from collections.abc import Iterable, Mapping, Sequence
from math import atan2, cos, pi, sin, sqrt

from gmpy2 import mpq

from exactmesh.geometry.distance import distance_squared
from exactmesh.geometry.point import Point, dot, minus
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text
from exactmesh.pictures.faces import FaceLooks
from exactmesh.pictures.palette import (
    FEATURE_FILLS,
    FEATURE_NAMES,
    INK,
    MAKERS,
    NO_TRIANGLE,
    PAPER,
    RED,
    Maker,
)
from exactmesh.pictures.scene import LETTER, Area, Dots, Key, Label, Layer, Lines, Look, Panel, Place
from exactmesh.pictures.view import View
from exactmesh.planar.cycles import Cycle

EDGE = "#5d7390"
_DIGITS = 6
_MAKER_NAMES: dict[Maker, str] = {
    "given": "vertices of the input", "offset": "placed by the offset", "chord": "ends of chords",
    "interior": "placed in the Interior", "tube": "placed in the Tube", "steiner": "Steiner vertices"}
# Where a label may stand beside its place: along, down, anchor; the first that is free is taken.
_SPOTS: tuple[tuple[float, float, str], ...] = (
    (9, -8, "start"), (-9, -8, "end"), (9, 18, "start"), (-9, 18, "end"), (0, -16, "middle"), (0, 26, "middle"),
    (14, 5, "start"), (-14, 5, "end"), (24, -26, "start"), (-24, -26, "end"), (24, 36, "start"), (-24, 36, "end"))
_SHORT = 9.0
_CIRCLE = 7.0
_CHORDS = 12


class Canvas:
    """The layers of one panel, as they come; the ones added later lie on top. `points`, `faces`: for the grain."""

    def __init__(self, view: View, points: Sequence[Point] = (), faces: Iterable[Cycle] = ()) -> None:
        self.view = view
        self.grain = _grain(view, points, faces)
        self.layers: list[Layer] = []
        self.keys: list[Key] = []
        self._taken: list[tuple[float, float, float, float]] = []

    @property
    def thin(self) -> float:
        """The width of a mesh edge."""
        return max(0.02, min(0.9, 0.07 * self.grain))

    @property
    def radius(self) -> float:
        """The radius of a vertex."""
        return max(0.3, min(3.2, 0.16 * self.grain))

    def panel(self, step: str, title: str) -> Panel:
        """Return what has been drawn."""
        return self.view.panel(step, title, self.layers, dict.fromkeys(self.keys))

    def edges(self, name: str, ends: Iterable[tuple[Point, Point]], stroke: str, width: float,
              dash: tuple[float, ...] = (), key: str = "") -> None:
        """Draw segments."""
        chains = self.view.segments(ends)
        if chains:
            self.layers.append(Lines(name, chains, stroke, width, dash))
            self._key("dashes" if dash else "line", stroke, key)

    def areas(self, name: str, polygons: Iterable[Sequence[Point]], fill: str, stroke: str = "none",
              width: float = 0.0, key: str = "") -> None:
        """Draw convex polygons."""
        drawn = tuple(places for polygon in polygons if (places := self.view.polygon(polygon)))
        if drawn:
            self.layers.append(Area(name, drawn, fill, stroke, width))
            self._key("area", fill, key)

    def features(self, points: Sequence[Point], looks: FaceLooks) -> None:
        """Draw faces, each in the colour of its feature size over that of the input, exactly.

        A face that is no triangle has a colour of its own.
        """
        shown = self.view.shown(points)
        groups: dict[int, list[Cycle]] = {}
        for cycle, rank in zip(looks.corners, looks.rank, strict=True):
            if shown is None or shown(cycle):
                groups.setdefault(rank, []).append(cycle)
        places = self.view.places(points)
        for rank in sorted(groups):
            name, fill, key = ("no-triangle", NO_TRIANGLE, "no triangle") if rank < 0 else (
                f"feature-{rank}", FEATURE_FILLS[rank], "")
            if self.view.is_part:
                self.areas(name, ([points[v] for v in cycle] for cycle in groups[rank]), fill, EDGE, self.thin, key)
            else:
                polygons = tuple(tuple([places[v] for v in cycle]) for cycle in groups[rank])
                self.layers.append(Area(name, polygons, fill, EDGE, self.thin))
                self._key("area", fill, key)
        if any(rank >= 0 for rank in groups):
            self.keys.append(Key("none", INK, "features of faces, over the input's mfs:"))
            self.keys += [Key("area", *entry) for entry in zip(FEATURE_FILLS, FEATURE_NAMES, strict=True)]

    def vertices(self, points: Sequence[Point], makers: Mapping[Maker, Iterable[int]], t_vertices: Iterable[int] = ()
                 ) -> None:
        """Draw vertices in the colours of who placed them; those on sides of faces are ringed."""
        ringed = self._inside(points[v] for v in t_vertices)
        if ringed:
            self.layers += [Dots("t-vertex", ringed, INK, 2.1 * self.radius),
                            Dots("t-vertex-rim", ringed, PAPER, 1.6 * self.radius)]
        for maker, numbers in makers.items():
            places = self._inside(points[v] for v in numbers)
            if places:
                self.layers.append(Dots(maker, places, MAKERS[maker], self.radius))
                self._key("dot", MAKERS[maker], _MAKER_NAMES[maker])
        if ringed:
            self._key("ring", INK, "T-vertices: on a side of a face")

    def dots(self, name: str, points: Iterable[Point], fill: str, radius: float, key: str = "") -> None:
        """Draw points."""
        places = self._inside(points)
        if places:
            self.layers.append(Dots(name, places, fill, radius))
            self._key("dot", fill, key)

    def nearest(self, points: Sequence[Point], nearest: Nearest, name: str = "witness", word: str = "",
                colour: str = RED) -> None:
        """Draw the segment that a feature size is the length of, with its length."""
        p = points[nearest.vertex]
        a, b = (points[v] for v in nearest.feature)
        self.distance(p, foot(p, a, b), f"{word + ' ' if word else ''}{sqrt_text(nearest.squared, _DIGITS)}", name,
                      colour)

    def distance(self, p: Point, q: Point, text: str, name: str = "witness", colour: str = RED) -> None:
        """Draw a segment with a text; a short one is circled as well."""
        chain = self.view.segment(p, q)
        if not chain:
            return
        self.layers.append(Lines(name, (chain,), colour, 2.6))
        (px, py), (qx, qy) = chain
        middle = ((px + qx) / 2, (py + qy) / 2)
        self._taken.append((min(px, qx) - 2, min(py, qy) - 2, max(px, qx) + 2, max(py, qy) + 2))
        if (px - qx) ** 2 + (py - qy) ** 2 < _SHORT**2:
            self.layers.append(Lines(f"{name}-circle", (_circle(middle, _CIRCLE),), colour, 1.6))
        self.note(middle if middle[0] > 0 else (px, py), text, colour, f"{name}-label")

    def angle(self, at: Point, p: Point, q: Point, text: str, colour: str = INK, radius: float = 24.0) -> None:
        """Mark the angle at a point between the directions of two others, less than half a turn."""
        x, y = self.view.place(at)
        first, last = (atan2(py - y, px - x) for px, py in map(self.view.place, (p, q)))
        turn = (last - first + pi) % (2 * pi) - pi
        angles = [first + turn * i / _CHORDS for i in range(_CHORDS + 1)]
        self.layers.append(Lines("angle", (tuple((x + radius * cos(z), y + radius * sin(z)) for z in angles),),
                                 colour, 1.2))
        middle, away = first + turn / 2, radius + 16
        self.word((x + away * cos(middle), y + away * sin(middle)), text, colour, 12)

    def note(self, place: Place, text: str, fill: str = INK, name: str = "note", size: float = 13.0) -> None:
        """Write beside a place, where there is room."""
        width, view = LETTER * size * len(text), self.view
        best: tuple[float, Label, tuple[float, float, float, float]] | None = None
        for rank, (along, down, anchor) in enumerate(_SPOTS):
            x, y = place[0] + along, place[1] + down
            left = x - {"start": 0.0, "middle": width / 2, "end": width}[anchor]
            # Pushed back into the panel, where it would stick out.
            moved = min(max(left, 3.0), max(3.0, view.width - width - 3.0))
            y = min(max(y, size), view.height - 5.0)
            box = (moved, y - size, moved + width, y + 3)
            hidden = sum(_overlap(box, other) for other in self._taken)
            cost = 10 * hidden + abs(moved - left) * 8 + rank
            if best is None or cost < best[0]:
                best = cost, Label(name, (moved, y), text, fill, "start", size), box
        if best is not None:
            self.layers.append(best[1])
            self._taken.append(best[2])

    def word(self, place: Place, text: str, fill: str = INK, size: float = 13.0, name: str = "note") -> None:
        """Write centred on a place, without looking for room."""
        width = LETTER * size * len(text)
        self.layers.append(Label(name, (place[0], place[1] + size / 3), text, fill, "middle", size))
        self._taken.append((place[0] - width / 2, place[1] - size, place[0] + width / 2, place[1] + size))

    def _inside(self, points: Iterable[Point]) -> tuple[Place, ...]:
        places = self.view.places(points)
        return tuple(filter(self.view.holds, places)) if self.view.is_part else tuple(places)

    def _key(self, look: Look, colour: str, text: str) -> None:
        if text:
            self.keys.append(Key(look, colour, text))


def foot(p: Point, a: Point, b: Point) -> Point:
    """Return the point of the closed segment a b that is nearest to p."""
    along = minus(b, a)
    length_squared = distance_squared(a, b)
    if length_squared == 0:
        return a
    t = min(max(dot(minus(p, a), along) / length_squared, mpq(0)), mpq(1))
    return Point(a.x + t * along.x, a.y + t * along.y)


def _grain(view: View, points: Sequence[Point], faces: Iterable[Cycle]) -> float:
    """Return the median height in pixels of the faces that can be seen; that of the panel when there are none."""
    places = view.places(points)
    shown = view.shown(points)
    heights = []
    for cycle in faces:
        if len(cycle) > 2 and (shown is None or shown(cycle)):
            corners = [places[v] for v in cycle]
            area = longest = 0.0
            px, py = corners[-1]
            for x, y in corners:
                area += px * y - x * py
                longest = max(longest, (x - px) * (x - px) + (y - py) * (y - py))
                px, py = x, y
            heights.append(abs(area) / sqrt(longest) if longest else 0.0)
    return sorted(heights)[len(heights) // 2] if heights else min(view.width, view.height)


# A circle as a polygon that looks round at any size a picture has.
_ROUND = ((1.0, 0.0), (0.924, 0.383), (0.707, 0.707), (0.383, 0.924), (0.0, 1.0), (-0.383, 0.924), (-0.707, 0.707),
          (-0.924, 0.383), (-1.0, 0.0), (-0.924, -0.383), (-0.707, -0.707), (-0.383, -0.924), (0.0, -1.0),
          (0.383, -0.924), (0.707, -0.707), (0.924, -0.383), (1.0, 0.0))


def _circle(centre: Place, radius: float) -> tuple[Place, ...]:
    return tuple((centre[0] + radius * x, centre[1] + radius * y) for x, y in _ROUND)


def _overlap(a: tuple[float, float, float, float], b: tuple[float, float, float, float]) -> float:
    across = min(a[2], b[2]) - max(a[0], b[0])
    down = min(a[3], b[3]) - max(a[1], b[1])
    return across * down / 10 if across > 0 and down > 0 else 0.0
