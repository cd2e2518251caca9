"""A picture as SVG, without any library: one path for all shapes of one look, so that 100,000 faces make a few MB.

Looks are attributes, not a style sheet, and there are no ids: pictures can stand side by side in one page. The bytes
depend on the scene alone. Paths count in hundredths of a pixel, mostly relative to the place before.
"""

import re
from collections.abc import Iterable, Sequence

from exactmesh.pictures.palette import FAINT, INK, PAPER
from exactmesh.pictures.scene import Area, Dots, Key, Label, Layer, Lines, Panel, Place, Scene

_GAP = 26.0
_TITLE = 24.0
_LINE = 20.0
_FONT = 13.0
_FINE = 100
# Of running text, which is in lower case: narrower letters than elsewhere will do.
_KEY_LETTER = 0.48
_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def svg_text(scene: Scene) -> str:
    """Return the picture as the text of an SVG file."""
    rows = scene.rows
    across = max(max(map(_row_width, rows)) + 2 * _GAP, 460.0)
    heading = _wrapped(scene.title, across, 17.0) if scene.title else []
    y = _GAP + _LINE * len(heading) if heading else _GAP / 2
    body: list[str] = []
    for row in rows:
        x = _GAP
        top = y + (_TITLE if any(panel.title for panel in row) else 0.0)
        for panel in row:
            body += _panel(panel, x, top)
            x += panel.width + _GAP
        y = top + max(panel.height for panel in row) + _GAP
    legend, y = _legend(scene.keys, across, y)
    caption = [line for text in scene.caption for line in _wrapped(text, across, _FONT)]
    for line in caption:
        body.append(_text("caption", _GAP, y, line, INK, _FONT))
        y += _LINE
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_number(across)} {_number(y)}" '
             f'style="max-width:{_number(across)}px" font-family="sans-serif" font-size="{_number(_FONT)}" role="img">',
             f"<title>{escaped(scene.title)}</title>",
             f'<rect class="ground" width="{_number(across)}" height="{_number(y)}" fill="{PAPER}"/>']
    parts += [_text("heading", _GAP, _GAP + _LINE * i, line, INK, 15.0, weight="bold")
              for i, line in enumerate(heading)]
    return "\n".join([*parts, *body, *legend, "</svg>", ""])


def escaped(text: str) -> str:
    """Return a text as XML can hold it; what no XML can hold is replaced."""
    clean = _NOT_XML.sub("\ufffd", text)
    return clean.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def _row_width(row: Sequence[Panel]) -> float:
    return sum(panel.width for panel in row) + _GAP * (len(row) - 1)


def _wrapped(text: str, across: float, size: float) -> list[str]:
    room = max(20, int((across - 2 * _GAP) / (_KEY_LETTER * size)))
    lines, line = [], ""
    for word in text.split(" "):
        if line and len(line) + 1 + len(word) > room:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}" if line else word
    return [*lines, line] if line else lines


def _panel(panel: Panel, x: float, y: float) -> list[str]:
    width, height = _number(panel.width), _number(panel.height)
    parts = [f'<g class="panel" data-step="{escaped(panel.step)}">']
    if panel.title:
        room = max(10, int(panel.width / (_KEY_LETTER * _FONT)))
        title = panel.title if len(panel.title) <= room else panel.title[: room - 1] + "…"
        parts.append(_text("panel-title", x, y - 8, title, INK, _FONT))
    # An inner svg element cuts off what is outside of it.
    parts.append(f'<svg class="drawing" x="{_number(x)}" y="{_number(y)}" width="{width}" height="{height}" '
                 f'viewBox="0 0 {width} {height}" overflow="hidden">')
    parts.append(f'<g transform="scale({1 / _FINE:g})" fill="none" stroke-linejoin="round" stroke-linecap="round">')
    parts += [_path(layer) for layer in panel.layers if not isinstance(layer, Label)]
    parts.append("</g>")
    parts += [_label(layer) for layer in panel.layers if isinstance(layer, Label)]
    parts += ["</svg>", f'<rect class="frame" x="{_number(x)}" y="{_number(y)}" width="{width}" height="{height}" '
              f'fill="none" stroke="{FAINT}" stroke-width="0.8"/>', "</g>"]
    return parts


def _path(layer: Layer) -> str:
    match layer:
        case Area():
            data = _drawn(layer.polygons, closed=True)
            return (f'<path class="{layer.name}" fill="{layer.fill}" stroke="{layer.stroke}" '
                    f'stroke-width="{_number(layer.width * _FINE)}" d="{data}"/>')
        case Lines():
            dash = " ".join(_number(length * _FINE) for length in layer.dash)
            return (f'<path class="{layer.name}" stroke="{layer.stroke}" '
                    f'stroke-width="{_number(layer.width * _FINE)}"'
                    + (f' stroke-dasharray="{dash}"' if dash else "") + f' d="{_drawn(layer.chains, closed=False)}"/>')
        case Dots():
            # A line of no length with round ends is a dot.
            return (f'<path class="{layer.name}" stroke="{layer.fill}" '
                    f'stroke-width="{_number(2 * layer.radius * _FINE)}" d="{_dotted(layer.places)}"/>')
        case _:
            raise AssertionError("labels are no paths")


def _label(label: Label) -> str:
    return (f'<text class="{label.name}" x="{_number(label.place[0])}" y="{_number(label.place[1])}" '
            f'fill="{label.fill}" font-size="{_number(label.size)}" text-anchor="{label.anchor}" stroke="{PAPER}" '
            f'stroke-width="3.5" stroke-linejoin="round" paint-order="stroke">{escaped(label.text)}</text>')


def _legend(keys: Sequence[Key], across: float, y: float) -> tuple[list[str], float]:
    """Return the elements of the legend, in lines, and where the next thing can stand."""
    if not keys:
        return [], y
    parts = []
    x = _GAP
    for key in keys:
        indent = 0 if key.look == "none" else 28
        width = indent + len(key.text) * _KEY_LETTER * _FONT + 16
        if x > _GAP and x + width > across - _GAP / 2:
            x, y = _GAP, y + _LINE
        if indent:
            parts.append(_mark(key, x, y - 4))
        parts.append(_text("key", x + indent, y, key.text, INK, _FONT))
        x += width
    return parts, y + _LINE + 4


def _mark(key: Key, x: float, y: float) -> str:
    match key.look:
        case "area":
            return (f'<rect x="{_number(x)}" y="{_number(y - 6)}" width="22" height="12" fill="{key.colour}" '
                    f'stroke="{INK}" stroke-width="0.4"/>')
        case "dot":
            return f'<circle cx="{_number(x + 11)}" cy="{_number(y)}" r="4" fill="{key.colour}"/>'
        case "ring":
            return (f'<circle cx="{_number(x + 11)}" cy="{_number(y)}" r="4.5" fill="none" stroke="{key.colour}" '
                    f'stroke-width="1.6"/>')
    dash = ' stroke-dasharray="4 3"' if key.look == "dashes" else ""
    return (f'<path d="M{_number(x)} {_number(y)}h22" fill="none" stroke="{key.colour}" stroke-width="2.2"{dash}/>')


def _text(name: str, x: float, y: float, text: str, fill: str, size: float, weight: str = "normal") -> str:
    bold = f' font-weight="{weight}"' if weight != "normal" else ""
    return (f'<text class="{name}" x="{_number(x)}" y="{_number(y)}" fill="{fill}" '
            f'font-size="{_number(size)}"{bold}>{escaped(text)}</text>')


def _drawn(chains: Iterable[Sequence[Place]], closed: bool) -> str:
    parts: list[str] = []
    at = (0, 0)
    for chain in chains:
        places = [(round(x * _FINE), round(y * _FINE)) for x, y in chain]
        start = places[0]
        parts.append(f"m{_pair(start[0] - at[0], start[1] - at[1])}")
        at = start
        steps = []
        for place in places[1:]:
            steps.append((place[0] - at[0], place[1] - at[1]))
            at = place
        parts.append("l" + _joined(steps))
        if closed:
            parts.append("z")
            at = start
    return "".join(parts)


def _dotted(places: Iterable[Place]) -> str:
    parts = []
    x = y = 0
    for px, py in places:
        new_x, new_y = round(px * _FINE), round(py * _FINE)
        parts.append(f"m{_pair(new_x - x, new_y - y)}h0")
        x, y = new_x, new_y
    return "".join(parts)


def _joined(pairs: Iterable[tuple[int, int]]) -> str:
    return "".join(_pair(x, y) if x < 0 or not i else " " + _pair(x, y) for i, (x, y) in enumerate(pairs))


def _pair(x: int, y: int) -> str:
    return f"{x}{y}" if y < 0 else f"{x} {y}"


def _number(value: float) -> str:
    return f"{value:.2f}".rstrip("0").rstrip(".")
