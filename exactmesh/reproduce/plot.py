"""Log-log plots as plain SVG: for looking at, so values are rounded here and nowhere else."""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from math import ceil, floor, log10

_WIDTH, _HEIGHT = 460.0, 360.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 56.0, 24.0, 34.0, 42.0
_COLUMNS = 2
_STYLE = """
svg { background: #fff; font: 12px sans-serif; fill: #14202e }
.grid { stroke: #d8dee6; stroke-width: .8 } .frame { fill: none; stroke: #14202e }
.level { stroke: #8a8f98; stroke-dasharray: 5 4 } .level-name { fill: #5c626c; font-size: 10px }
.series polyline { fill: none; stroke-width: 1.8 } .heading { font-size: 14px; font-weight: bold }
"""


@dataclass(frozen=True, slots=True)
class Series:
    """A name and points (x, y), both positive."""

    name: str
    points: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class Panel:
    """One pair of axes; series of the same name have one colour in all panels."""

    title: str
    x_name: str
    series: tuple[Series, ...]


# Colour, dashes of the line and radius of the marks: series can be told apart without colour, and where they coincide.
_LOOKS = (("#c8102e", "none", "3"), ("#e08a00", "2 6", "6"), ("#1f6fd6", "none", "4"), ("#178a4c", "none", "2.5"),
          ("#7a3fb0", "6 4", "5"), ("#14202e", "1 3", "2"))


def svg_of(title: str, panels: Sequence[Panel], levels: Sequence[tuple[float, str]] = ()) -> str:
    """Return a picture of all panels with a legend; `levels` are heights marked in each, with a name.

    All panels have one range of heights, from whole power of ten to whole power of ten.
    """
    heights = [y for panel in panels for series in panel.series for _, y in series.points]
    heights += [y for y, _ in levels]
    y_range = _decades(heights)
    names = list(dict.fromkeys(series.name for panel in panels for series in panel.series))
    down = -(-len(panels) // _COLUMNS)
    width, height = _WIDTH * _COLUMNS, _HEIGHT * down + 60
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}">',
             f"<title>{escape(title)}</title><style>{_STYLE}</style>",
             f'<text class="heading" x="{_LEFT}" y="20">{escape(title)}</text>']
    for i, panel in enumerate(panels):
        across, line = i % _COLUMNS, i // _COLUMNS
        parts.append(f'<g transform="translate({across * _WIDTH:.0f} {line * _HEIGHT + 26:.0f})">')
        parts += _Axes(_decades([x for series in panel.series for x, _ in series.points]), y_range).panel(
            panel, levels, names)
        parts.append("</g>")
    return "\n".join([*parts, *_legend(names, height - 16), "</svg>", ""])


class _Axes:
    """A panel's scales: from exponents of ten to places."""

    def __init__(self, x_range: tuple[int, int], y_range: tuple[int, int]) -> None:
        self.x_range, self.y_range = x_range, y_range

    def panel(self, panel: Panel, levels: Sequence[tuple[float, str]], names: Sequence[str]) -> list[str]:
        """Return the elements of a panel."""
        parts = self._grid(panel)
        for value, name in levels:
            y = self._y(value)
            parts += [f'<path class="level" d="M{_LEFT} {y:.2f}H{_WIDTH - _RIGHT}"/>',
                      f'<text class="level-name" x="{_LEFT + 4}" y="{y - 3:.2f}">{escape(name)}</text>']
        for series in panel.series:
            places = [(self._x(x), self._y(y)) for x, y in series.points]
            colour, dashes, radius = _LOOKS[names.index(series.name) % len(_LOOKS)]
            line = " ".join(f"{x:.2f},{y:.2f}" for x, y in places)
            parts.append(f'<g class="series"><title>{escape(f"{panel.title}: {series.name}")}</title>'
                         f'<polyline points="{line}" stroke="{colour}" stroke-dasharray="{dashes}"/>')
            parts += [f'<circle cx="{x:.2f}" cy="{y:.2f}" r="{radius}" fill="none" stroke="{colour}"/>'
                      for x, y in places]
            parts.append("</g>")
        return parts

    def _grid(self, panel: Panel) -> list[str]:
        bottom, right = _HEIGHT - _BOTTOM, _WIDTH - _RIGHT
        parts = [f'<text x="{_LEFT}" y="{_TOP - 8}">{escape(panel.title)}</text>',
                 f'<text x="{right}" y="{bottom + 32}" text-anchor="end">{escape(panel.x_name)}</text>']
        for exponent in range(self.x_range[0], self.x_range[1] + 1):
            x = self._x(10.0**exponent)
            parts += [f'<path class="grid" d="M{x:.2f} {_TOP}V{bottom}"/>',
                      f'<text x="{x:.2f}" y="{bottom + 16}" text-anchor="middle">{_power(exponent)}</text>']
        for exponent in range(self.y_range[0], self.y_range[1] + 1):
            y = self._y(10.0**exponent)
            parts += [f'<path class="grid" d="M{_LEFT} {y:.2f}H{right}"/>',
                      f'<text x="{_LEFT - 6}" y="{y + 4:.2f}" text-anchor="end">{_power(exponent)}</text>']
        return [*parts, f'<rect class="frame" x="{_LEFT}" y="{_TOP}" width="{right - _LEFT}" '
                        f'height="{bottom - _TOP}"/>']

    def _x(self, value: float) -> float:
        low, high = self.x_range
        return _LEFT + (log10(value) - low) / (high - low) * (_WIDTH - _LEFT - _RIGHT)

    def _y(self, value: float) -> float:
        low, high = self.y_range
        return _HEIGHT - _BOTTOM - (log10(value) - low) / (high - low) * (_HEIGHT - _TOP - _BOTTOM)


def _legend(names: Sequence[str], y: float) -> list[str]:
    parts = []
    for i, name in enumerate(names):
        x = _LEFT + 150 * i
        colour, dashes, radius = _LOOKS[i % len(_LOOKS)]
        parts += [f'<path d="M{x:.0f} {y:.0f}h24" stroke="{colour}" stroke-width="1.8" '
                  f'stroke-dasharray="{dashes}"/>',
                  f'<circle cx="{x + 12:.0f}" cy="{y:.0f}" r="{radius}" fill="none" stroke="{colour}"/>',
                  f'<text x="{x + 30:.0f}" y="{y + 4:.0f}">{escape(name)}</text>']
    return parts


def _decades(values: Sequence[float]) -> tuple[int, int]:
    """Return the exponents of the powers of ten around all values, at least one apart."""
    if not values:
        return 0, 1
    low, high = floor(log10(min(values))), ceil(log10(max(values)))
    return low, max(high, low + 1)


def _power(exponent: int) -> str:
    return str(10**exponent) if 0 <= exponent <= 4 else f"1e{exponent}"
