"""Pictures of dissections: every piece is there, and the animation rests in every figure."""

import re
import xml.etree.ElementTree as ElementTree
from itertools import pairwise
from math import cos, radians, sin

import pytest
from dissections import KNOWN, dissected

from exactmesh.dissection.assembly import animation_from_dissection, cut_sheet_from_dissection
from exactmesh.dissection.picture import svg_from_dissection

SVG = "{http://www.w3.org/2000/svg}"
NAMES = ["square to rectangle", "three", "hole", "far from the origin"]


def numbers(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"-?[0-9.]+", text)]


def pairs(text: str) -> list[tuple[float, float]]:
    flat = numbers(text)
    return list(zip(flat[::2], flat[1::2], strict=True))


@pytest.mark.parametrize("name", NAMES)
def test_all_pieces_are_drawn_in_every_figure(name: str) -> None:
    dissection = dissected(name).dissection
    count, figures = len(dissection.pieces), len(dissection.scales)
    for draw in (svg_from_dissection, cut_sheet_from_dissection):
        paths = list(ElementTree.fromstring(draw(dissection)).iter(f"{SVG}path"))
        assert len(paths) == count * figures
    # The same piece has the same colour in all figures, and neighbours in number have others.
    drawn = ElementTree.fromstring(svg_from_dissection(dissection)).iter(f"{SVG}path")
    colours = [path.get("fill") for path in drawn]
    assert colours[:count] * figures == colours and all(a != b for a, b in pairwise(colours))


@pytest.mark.parametrize("name", NAMES)
def test_the_animation_rests_in_every_figure(name: str) -> None:
    made = dissected(name)
    root = ElementTree.fromstring(animation_from_dissection(made.dissection))
    groups = list(root.iter(f"{SVG}g"))
    assert len(groups) == len(made.dissection.pieces)
    for figure in range(len(KNOWN[name])):
        offsets = []
        for group, piece in zip(groups, made.dissection.pieces, strict=True):
            moves = [pairs(value)[0] for value in group[0].get("values", "").split(";")]
            turns = numbers(group[1][0].get("values", ""))
            assert len(moves) == len(turns) == 2 * len(KNOWN[name]) + 1
            (x, y), angle = moves[2 * figure], radians(turns[2 * figure])
            assert moves[2 * figure] == moves[2 * figure + 1] and turns[2 * figure] == turns[2 * figure + 1]
            for (u, v), p in zip(pairs(group[1].get("d", "")), piece.polygons[figure], strict=True):
                place = x + cos(angle) * u - sin(angle) * v, y + sin(angle) * u + cos(angle) * v
                offsets.append((place, (float(p.x.decimal(15)), float(p.y.decimal(15)))))
        # All corners lie where the figure has them, up to one shift and one scale, with y down.
        (a, p), (b, q) = min(offsets, key=lambda o: o[1]), max(offsets, key=lambda o: o[1])
        scale = (b[0] - a[0]) / (q[0] - p[0])
        for place, exact in offsets:
            assert place[0] - a[0] == pytest.approx(scale * (exact[0] - p[0]), abs=0.02)
            assert place[1] - a[1] == pytest.approx(-scale * (exact[1] - p[1]), abs=0.02)
