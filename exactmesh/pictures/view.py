"""From exact points to places in a panel: a window of the plane, and what falls into it.

The window is exact, so a picture a billionth of the input wide is as sharp as one of all of it. What reaches far out of
the window is cut off, exactly: viewers of pictures compute with few digits.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.numbers.rational import decimal_text
from exactmesh.pictures.scene import Key, Layer, Panel, Place

# The window's margin, in pixels, and the least height of a panel.
MARGIN = 14.0
_LEAST = 40.0
# Coordinates this many times the window's size away from the plane's origin leave floats too few digits for axes.
_FAR = 2.0**36
_DIGITS = 25
# How deep a point is inside each side of a box, given by its lower left and upper right corner.
_Box = tuple[Point, Point]
_SIDES: tuple[Callable[[Point, _Box], mpq], ...] = (
    lambda p, box: p.x - box[0].x, lambda p, box: box[1].x - p.x,
    lambda p, box: p.y - box[0].y, lambda p, box: box[1].y - p.y)


@dataclass(frozen=True, slots=True)
class View:
    """The rectangle from `low` to `high`, drawn `width` by `height` pixels with `scale` pixels a unit of length."""

    low: Point
    high: Point
    width: float
    height: float
    scale: mpq
    is_part: bool

    def place(self, p: Point) -> Place:
        """Return where a point is drawn."""
        return (float((p.x - self.low.x) * self.scale), float((self.high.y - p.y) * self.scale))

    def places(self, points: Iterable[Point]) -> list[Place]:
        """Return where points are drawn."""
        x, y, scale = self.low.x, self.high.y, self.scale
        return [(float((p.x - x) * scale), float((y - p.y) * scale)) for p in points]

    def holds(self, place: Place) -> bool:
        """Return whether a place is in the panel."""
        return 0 <= place[0] <= self.width and 0 <= place[1] <= self.height

    def shown(self, points: Sequence[Point]) -> "Callable[[Sequence[int]], bool] | None":
        """Return whether a polygon of points, given by numbers, can be in a window; None when all of them are."""
        if not self.is_part:
            return None
        # A bit for each side of the window that a point is beyond: a polygon all beyond one side is not seen.
        beyond = [(x < 0) | (x > self.width) << 1 | (y < 0) << 2 | (y > self.height) << 3
                  for x, y in self.places(points)]

        def is_shown(cycle: Sequence[int]) -> bool:
            common = 15
            for v in cycle:
                common &= beyond[v]
            return not common

        return is_shown

    def misses(self, places: Sequence[Place]) -> bool:
        """Return whether a polygon's places all lie on one side of a window; never for a view of all."""
        if not self.is_part:
            return False
        xs, ys = [x for x, _ in places], [y for _, y in places]
        return max(xs) < 0 or min(xs) > self.width or max(ys) < 0 or min(ys) > self.height

    def polygon(self, corners: Sequence[Point]) -> tuple[Place, ...]:
        """Return a polygon's places, less what is far outside of a window; nothing when all of it is."""
        places = tuple(map(self.place, corners))
        if self.misses(places):
            return ()
        if not self.is_part or self._is_near(places):
            return places
        box = self._far_box()
        cut = list(corners)
        for depth in _SIDES:
            cut = list(_cut(cut, [depth(p, box) for p in cut]))
        return tuple(map(self.place, cut))

    def segment(self, a: Point, b: Point) -> tuple[Place, ...]:
        """Return a segment's places, less what is far outside of a window; nothing when all of it is."""
        places = (self.place(a), self.place(b))
        if self.misses(places):
            return ()
        if not self.is_part or self._is_near(places):
            return places
        box = self._far_box()
        first, last = mpq(0), mpq(1)
        for depth in _SIDES:
            start, end = depth(a, box), depth(b, box)
            if start < 0 and end < 0:
                return ()
            if start < 0:
                first = max(first, start / (start - end))
            elif end < 0:
                last = min(last, start / (start - end))
        if first >= last:
            return ()
        return tuple(self.place(Point(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))) for t in (first, last))

    def segments(self, ends: Iterable[tuple[Point, Point]]) -> tuple[tuple[Place, ...], ...]:
        """Return the places of segments, without those outside of a window."""
        return tuple(found for a, b in ends if (found := self.segment(a, b)))

    def panel(self, step: str, title: str, layers: Iterable[Layer], keys: Iterable[Key] = ()) -> Panel:
        """Return a panel of layers made by this view."""
        try:
            left, top, unit = float(self.low.x), float(self.high.y), float(1 / self.scale)
            is_far = max(abs(left), abs(top)) > _FAR * unit * max(self.width, self.height) or not unit
        except OverflowError:
            is_far, unit = True, 1.0
        if is_far:
            return Panel(step, title, self.width, self.height, tuple(layers), tuple(keys), 0.0, self.height, 1.0,
                         (f"(x - {decimal_text(self.low.x, _DIGITS)}) / {decimal_text(1 / self.scale, 6)}",
                          f"(y - {decimal_text(self.low.y, _DIGITS)}) / {decimal_text(1 / self.scale, 6)}"))
        return Panel(step, title, self.width, self.height, tuple(layers), tuple(keys), left, top, unit)

    def _is_near(self, places: Iterable[Place]) -> bool:
        return all(-self.width <= x <= 2 * self.width and -self.height <= y <= 2 * self.height for x, y in places)

    def _far_box(self) -> _Box:
        across, up = self.high.x - self.low.x, self.high.y - self.low.y
        return Point(self.low.x - across, self.low.y - up), Point(self.high.x + across, self.high.y + up)


def view_of(points: Sequence[Point], size: float = 1000.0) -> View:
    """Return a view of all points, its longer side `size` pixels. Raises `InputError` when there are none."""
    if not points:
        raise InputError("there is nothing to draw: no vertices")
    xs, ys = [p.x for p in points], [p.y for p in points]
    return _view(Point(min(xs), min(ys)), Point(max(xs), max(ys)), size, False)


def window(low: Point, high: Point, size: float = 1000.0) -> View:
    """Return a view of a rectangle; raises `InputError` when it is empty."""
    if not (low.x < high.x and low.y < high.y):
        raise InputError(f"the window from {low} to {high} is empty")
    return _view(low, high, size, True)


def around(centre: Point, reach: mpq, size: float = 1000.0) -> View:
    """Return a view of the square of half-width `reach` > 0 about a point."""
    return window(Point(centre.x - reach, centre.y - reach), Point(centre.x + reach, centre.y + reach), size)


def _view(low: Point, high: Point, size: float, is_part: bool) -> View:
    across, up = high.x - low.x, high.y - low.y
    reach = max(across, up) or mpq(1)
    scale = mpq(size) / reach
    if not is_part:
        pad_x, pad_y = (max(mpq(MARGIN), (mpq(_LEAST) - side * scale) / 2) / scale for side in (across, up))
        low, high = Point(low.x - pad_x, low.y - pad_y), Point(high.x + pad_x, high.y + pad_y)
    return View(low, high, float((high.x - low.x) * scale), float((high.y - low.y) * scale), scale, is_part)


def _cut(corners: Sequence[Point], depths: Sequence[mpq]) -> Iterator[Point]:
    """Yield the corners of the part of a convex polygon where the depth is not negative."""
    for i, (p, depth) in enumerate(zip(corners, depths, strict=True)):
        before, earlier = corners[i - 1], depths[i - 1]
        if (depth < 0) != (earlier < 0):
            t = earlier / (earlier - depth)
            yield Point(before.x + t * (p.x - before.x), before.y + t * (p.y - before.y))
        if depth >= 0:
            yield p
