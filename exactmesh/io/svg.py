"""Pictures as SVG: for looking at, so coordinates are rounded here and nowhere else."""

import re
from collections.abc import Iterable

from exactmesh.geometry.filtered import unit_floats
from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import Verification
from exactmesh.numbers.rational import sqrt_text
from exactmesh.planar.cycles import sides
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

_SIZE = 1000.0
_MARGIN = 20.0
_STYLE = """
svg { background: #fff; font: 14px sans-serif }
path { fill: none; stroke-linejoin: round; stroke-linecap: round; vector-effect: non-scaling-stroke }
.faces { fill: #eef3fa; stroke: #6b8cb5; stroke-width: STROKE }
.input { stroke: #14202e; stroke-width: 1.6 }
.witness { stroke: #c8102e; stroke-width: 3 }
.given { fill: #14202e } .steiner { fill: #1f6fd6 } .near { fill: #c8102e }
"""
_NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
# Lines of a mesh of more faces than this are drawn thinner, so that they do not fill the picture.
_FACES_AT_FULL_STROKE = 500
# Above this many vertices dots would hide the edges.
_DOTS = 2000


def svg_from_mesh(pslg: Pslg, mesh: Mesh, verification: Verification) -> str:
    """Return a picture of the mesh: the input bold, Steiner vertices blue, the nearest pairs of the input and of the
    mesh red, each with its distance."""
    xs, ys, _ = unit_floats(mesh.vertices)
    left, top = min(xs), max(ys)
    reach = max(max(xs) - left, top - min(ys)) or 1.0
    places = [((x - left) / reach * _SIZE + _MARGIN, (top - y) / reach * _SIZE + _MARGIN)
              for x, y in zip(xs, ys, strict=True)]
    width = max(x for x, _ in places) + _MARGIN
    height = max(y for _, y in places) + _MARGIN
    edges = {(min(side), max(side)) for cycle in mesh.faces for side in sides(cycle)}
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.2f} {height + 30:.2f}">',
        f"<title>{_title(pslg, verification)}</title>",
        f"<style>{_STYLE.replace('STROKE', _stroke(len(mesh.faces)))}</style>",
        f'<path class="faces" d="{_polygons(places, mesh.faces)}"/>',
        f'<path class="faces" d="{_lines(places, sorted(edges))}"/>',
        f'<path class="input" d="{_lines(places, pslg.edges)}"/>',
    ]
    if len(places) <= _DOTS:
        given = len(pslg.vertices)
        parts += [_dot(place, "given" if v < given else "steiner", 2.0) for v, place in enumerate(places)]
    for nearest in (verification.input_mfs, verification.mesh_mfs):
        if nearest is not None:
            parts += _witness(places, nearest)
    parts += [f'<text x="{_MARGIN}" y="{height + 18:.2f}">{_title(pslg, verification)}</text>', "</svg>", ""]
    return "\n".join(parts)


def _stroke(faces: int) -> str:
    return f"{0.6 * min(1.0, (_FACES_AT_FULL_STROKE / max(faces, 1)) ** 0.5):.3f}"


def _title(pslg: Pslg, verification: Verification) -> str:
    # A JSON name may hold control characters and lone surrogates; XML may not.
    name = _NOT_XML.sub("\ufffd", pslg.name).replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    text = f"{name + ': ' if name else ''}{verification.faces} faces, {verification.steiner} Steiner vertices"
    if verification.degradation_squared is not None:
        text += f", degradation {sqrt_text(verification.degradation_squared, 6)}"
    return text


def _polygons(places: list[tuple[float, float]], cycles: Iterable[tuple[int, ...]]) -> str:
    return "".join("M" + "L".join(_pair(places[v]) for v in cycle) + "Z" for cycle in cycles)


def _lines(places: list[tuple[float, float]], edges: Iterable[tuple[int, int]]) -> str:
    return "".join(f"M{_pair(places[u])}L{_pair(places[v])}" for u, v in edges)


def _pair(place: tuple[float, float]) -> str:
    return f"{place[0]:.2f} {place[1]:.2f}"


def _dot(place: tuple[float, float], kind: str, radius: float) -> str:
    return f'<circle class="{kind}" cx="{place[0]:.2f}" cy="{place[1]:.2f}" r="{radius}"/>'


def _witness(places: list[tuple[float, float]], nearest: Nearest) -> list[str]:
    (px, py), (ax, ay), (bx, by) = (places[v] for v in (nearest.vertex, *nearest.feature))
    length_squared = (bx - ax) ** 2 + (by - ay) ** 2
    t = ((px - ax) * (bx - ax) + (py - ay) * (by - ay)) / length_squared if length_squared else 0.0
    t = min(1.0, max(0.0, t))
    foot = (ax + t * (bx - ax), ay + t * (by - ay))
    # A label near the right border is set to the left of its vertex.
    x, anchor = (px - 6, "end") if px > 0.85 * _SIZE else (px + 6, "start")
    label = f'<text x="{x:.2f}" y="{py - 6:.2f}" text-anchor="{anchor}">{sqrt_text(nearest.squared, 6)}</text>'
    return [f'<path class="witness" d="M{_pair((px, py))}L{_pair(foot)}"/>', _dot((px, py), "near", 4.0), label]
