"""What a picture is made of, whatever draws it: panels side by side, each with layers of shapes and a key.

Places are in pixels of the panel, x to the right and y down, already rounded to floats; widths and radii are pixels.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

Place = tuple[float, float]
# The width of a text is not known here; this many pixels a letter at size 1 are enough for sans-serif fonts.
LETTER = 0.53
Look = Literal["area", "line", "dashes", "dot", "ring", "none"]


@dataclass(frozen=True, slots=True)
class Area:
    """Polygons of one look, filled and outlined. `name` says what they are: it is the class of the SVG element."""

    name: str
    polygons: tuple[tuple[Place, ...], ...]
    fill: str
    stroke: str = "none"
    width: float = 0.0


@dataclass(frozen=True, slots=True)
class Lines:
    """Open chains of one look; `dash` has the lengths of dashes and gaps in pixels, none for a whole line."""

    name: str
    chains: tuple[tuple[Place, ...], ...]
    stroke: str
    width: float
    dash: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True)
class Dots:
    """Round dots of one look."""

    name: str
    places: tuple[Place, ...]
    fill: str
    radius: float


@dataclass(frozen=True, slots=True)
class Label:
    """A line of text with a white rim, beside `place`: `anchor` is the end of the text that is there."""

    name: str
    place: Place
    text: str
    fill: str
    anchor: Literal["start", "middle", "end"] = "start"
    size: float = 13.0


Layer = Area | Lines | Dots | Label


@dataclass(frozen=True, slots=True)
class Key:
    """An entry of the legend."""

    look: Look
    colour: str
    text: str


@dataclass(frozen=True, slots=True)
class Panel:
    """One drawing, `width` by `height` pixels.

    A place (x, y) is the point (`left` + x `unit`, `top` - y `unit`) of the plane, as far as floats can tell; `offset`
    is what must be added to these when the plane is too far from its origin for floats, as texts, else None.
    """

    step: str
    title: str
    width: float
    height: float
    layers: tuple[Layer, ...]
    keys: tuple[Key, ...] = ()
    left: float = 0.0
    top: float = 0.0
    unit: float = 1.0
    offset: tuple[str, str] | None = None


@dataclass(frozen=True, slots=True)
class Scene:
    """A picture: rows of panels, a legend of all their keys, and lines of text below."""

    title: str
    rows: tuple[tuple[Panel, ...], ...]
    caption: tuple[str, ...] = ()

    @property
    def panels(self) -> tuple[Panel, ...]:
        """All panels."""
        return tuple(panel for row in self.rows for panel in row)

    @property
    def keys(self) -> tuple[Key, ...]:
        """The keys of all panels, each once."""
        return tuple(dict.fromkeys(key for panel in self.panels for key in panel.keys))


def in_rows(panels: Sequence[Panel], columns: int) -> tuple[tuple[Panel, ...], ...]:
    """Return panels in rows of at most `columns`."""
    return tuple(tuple(panels[i : i + columns]) for i in range(0, len(panels), columns))
