"""How the figures come about from the pieces: an animation, and a sheet to print and cut. For looking at only.

The animation is one SVG that needs nothing else: each piece turns about the mean of its corners while that moves along
a straight line, from figure to figure and back to the first.
"""

from math import atan2, degrees

from exactmesh.dissection.picture import Place, box, colour, room, rounded
from exactmesh.dissection.records import Dissection

_SIZE, _GAP = 600.0, 60.0
_SECONDS_MOVING, _SECONDS_RESTING = 3.0, 1.5
_PAPER_WIDTH, _PAPER_HEIGHT, _PAPER_MARGIN = 210.0, 297.0, 12.0


def animation_from_dissection(dissection: Dissection) -> str:
    """Return an SVG in which the pieces move from figure to figure, for ever."""
    figures = [[rounded(piece.polygons[figure]) for piece in dissection.pieces]
               for figure in range(len(dissection.scales))]
    boxes = [box(polygons) for polygons in figures]
    scale = _SIZE / max(max(right - left, top - low) for left, low, right, top in boxes)
    width = max(right - left for left, _, right, _ in boxes) * scale + 2 * _GAP
    height = max(top - low for _, low, _, top in boxes) * scale + 2 * _GAP
    # Every figure is drawn about the middle of the picture; y points down in it.
    middles = [((left + right) / 2, (low + top) / 2) for left, low, right, top in boxes]
    rests = len(figures)
    total = rests * (_SECONDS_MOVING + _SECONDS_RESTING)
    times = [(i * (_SECONDS_MOVING + _SECONDS_RESTING) + rest) / total
             for i in range(rests) for rest in (0.0, _SECONDS_RESTING)] + [1.0]
    timing = f'dur="{total:g}s" repeatCount="indefinite" keyTimes="{";".join(f"{t:.5f}" for t in times)}"'
    body = []
    for number, piece in enumerate(dissection.pieces):
        placed = [[((x - mx) * scale + width / 2, height / 2 - (y - my) * scale) for x, y in polygons[number]]
                  for polygons, (mx, my) in zip(figures, middles, strict=True)]
        centres = [_mean(places) for places in placed]
        # In the picture, where y points down, a turn to the left is a negative angle.
        angles = [0.0, *(-degrees(atan2(float(m.c.interval().low), float(m.a.interval().low))) for m in piece.motions)]
        body.append(_moving(placed[0], number, centres, _without_jumps(angles), timing))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.2f} {height:.2f}">\n'
            f"<title>{len(dissection.pieces)} pieces, assembled</title><style>svg {{ background: #fff }} "
            "path { stroke: #14202e; stroke-width: 0.4; stroke-linejoin: round }</style>\n"
            + "\n".join(body) + "\n</svg>\n")


def cut_sheet_from_dissection(dissection: Dissection) -> str:
    """Return an A4 page with the first figure to cut along its lines, numbered, and small pictures of the others."""
    figures = [[rounded(piece.polygons[figure]) for piece in dissection.pieces]
               for figure in range(len(dissection.scales))]
    inner = _PAPER_WIDTH - 2 * _PAPER_MARGIN
    body = _sheet(figures[0], _PAPER_MARGIN, _PAPER_MARGIN, inner, inner)
    key = inner / (len(figures) - 1) - 4
    for i, polygons in enumerate(figures[1:]):
        body += _sheet(polygons, _PAPER_MARGIN + i * (key + 4), inner + 2 * _PAPER_MARGIN, key,
                       _PAPER_HEIGHT - inner - 3 * _PAPER_MARGIN)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{_PAPER_WIDTH:g}mm" height="{_PAPER_HEIGHT:g}mm" '
            f'viewBox="0 0 {_PAPER_WIDTH:g} {_PAPER_HEIGHT:g}">\n<title>Cut sheet of {len(dissection.pieces)} pieces'
            "</title><style>path { fill: none; stroke: #000; stroke-width: 0.15 } text { text-anchor: middle; "
            "dominant-baseline: central; font-family: sans-serif }</style>\n" + "\n".join(body) + "\n</svg>\n")


def _sheet(polygons: list[list[Place]], x: float, y: float, width: float, height: float) -> list[str]:
    """Return the numbered outlines of pieces, fitted into a rectangle of the page."""
    left, low, right, top = box(polygons)
    scale = min(width / (right - left), height / (top - low))
    body = []
    for number, polygon in enumerate(polygons):
        places = [(x + (px - left) * scale, y + (top - py) * scale) for px, py in polygon]
        body.append(f'<path d="{_path(places)}"/>')
        centre = _mean(places)
        size = min(4.0, room(places, centre))
        if size >= 0.5:
            body.append(f'<text x="{centre[0]:.3f}" y="{centre[1]:.3f}" font-size="{size:.2f}">{number}</text>')
    return body


def _moving(places: list[Place], number: int, centres: list[Place], angles: list[float], timing: str) -> str:
    """Return one piece about the origin, within its turn, within its way."""
    x, y = centres[0]
    moves = [f"{cx:.3f} {cy:.3f}" for cx, cy in centres for _ in range(2)] + [f"{x:.3f} {y:.3f}"]
    turns = [f"{angle:.4f}" for angle in angles for _ in range(2)] + [f"{_nearest(0.0, angles[-1]):.4f}"]
    path = _path([(px - x, py - y) for px, py in places])
    return (f'<g><animateTransform attributeName="transform" type="translate" values="{";".join(moves)}" {timing}/>'
            f'<path fill="{colour(number)}" d="{path}"><animateTransform attributeName="transform" type="rotate" '
            f'values="{";".join(turns)}" {timing}/></path></g>')


def _without_jumps(angles: list[float]) -> list[float]:
    """Return the angles, each plus full turns so that it differs from the last by half a turn at most."""
    found = angles[:1]
    for angle in angles[1:]:
        found.append(_nearest(angle, found[-1]))
    return found


def _nearest(angle: float, to: float) -> float:
    return angle + 360 * round((to - angle) / 360)


def _mean(places: list[Place]) -> Place:
    return sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places)


def _path(places: list[Place]) -> str:
    return "M" + "L".join(f"{x:.3f} {y:.3f}" for x, y in places) + "Z"
