"""Pictures of dissections as SVG: all figures side by side, pieces coloured alike and numbered.

For looking at: coordinates are rounded here.
"""

from math import cos, pi

from exactmesh.dissection.records import Dissection, Polygon

_SIZE = 600.0
_GAP = 30.0
# A number is drawn where its height fits into the piece this many times.
_LEAST_FONT, _MOST_FONT = 1.5, 14.0
_STYLE = ("svg { background: #fff; font-family: sans-serif } path { stroke: #14202e; stroke-width: STROKE; "
          "stroke-linejoin: round } text { text-anchor: middle; dominant-baseline: central; fill: #14202e }")

Place = tuple[float, float]


def svg_from_dissection(dissection: Dissection) -> str:
    """Return a picture of all figures, side by side, to one scale."""
    figures = [[rounded(piece.polygons[figure]) for piece in dissection.pieces]
               for figure in range(len(dissection.scales))]
    boxes = [box(polygons) for polygons in figures]
    scale = _SIZE / max(max(right - left, top - low) for left, low, right, top in boxes)
    height = max(top - low for _, low, _, top in boxes) * scale
    body: list[str] = []
    x = _GAP
    for polygons, (left, low, right, _) in zip(figures, boxes, strict=True):
        for number, polygon in enumerate(polygons):
            places = [((px - left) * scale + x, height - (py - low) * scale + _GAP) for px, py in polygon]
            body.append(_drawn(places, number))
        x += (right - left) * scale + _GAP
    stroke = max(0.1, min(0.8, 20 / max(1, len(dissection.pieces)) ** 0.5))
    style = _STYLE.replace("STROKE", f"{stroke:.2f}")
    head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {x:.2f} {height + 2 * _GAP:.2f}">\n'
            f"<title>{len(dissection.pieces)} pieces</title><style>{style}</style>\n")
    return head + "\n".join(body) + "\n</svg>\n"


def colour(number: int) -> str:
    """Return a light colour; neighbours in number differ."""
    hue = 2 * pi * (number * 0.61803398875 % 1)
    red, green, blue = (round(205 + 45 * cos(hue - shift)) for shift in (0, 2 * pi / 3, 4 * pi / 3))
    return f"#{red:02x}{green:02x}{blue:02x}"


def _drawn(places: list[Place], number: int) -> str:
    path = "L".join(f"{x:.3f} {y:.3f}" for x, y in places)
    (x, y), area = _centre(places)
    inside = room(places, (x, y))
    size = min(_MOST_FONT, inside)
    text = (f'<text x="{x:.2f}" y="{y:.2f}" font-size="{size:.2f}">{number}</text>'
            if size >= _LEAST_FONT and area else "")
    return f'<path fill="{colour(number)}" d="M{path}Z"/>{text}'


def rounded(polygon: Polygon) -> list[Place]:
    """Return the corners, rounded."""
    return [(float(p.x.interval().low), float(p.y.interval().low)) for p in polygon]


def box(polygons: list[list[Place]]) -> tuple[float, float, float, float]:
    """Return the left, low, right and top end of all."""
    xs = [x for polygon in polygons for x, _ in polygon]
    ys = [y for polygon in polygons for _, y in polygon]
    return min(xs), min(ys), max(xs), max(ys)


def _centre(places: list[Place]) -> tuple[Place, float]:
    """Return the mean of the corners, and whether there is room at all as the area."""
    count = len(places)
    return (sum(x for x, _ in places) / count, sum(y for _, y in places) / count), _area(places)


def _area(places: list[Place]) -> float:
    return abs(sum(x * v - y * u for (x, y), (u, v) in zip(places, places[1:] + places[:1], strict=True))) / 2


def room(places: list[Place], centre: Place) -> float:
    """Return the distance of the centre from the nearest side's line."""
    best = _SIZE
    for (x, y), (u, v) in zip(places, places[1:] + places[:1], strict=True):
        length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
        if length:
            best = min(best, abs((u - x) * (centre[1] - y) - (v - y) * (centre[0] - x)) / length)
    return best
