"""The paper's Theorem 2: a rectangle with vertices on one side, triangulated properly in layers (Fig. 2 B).

In      the occupied positions on the bottom side, as in `lemma_3.py`.
Out     `UnitPiece`, every face of three vertices.
Exact   rational.
Paper   each layer has half as many vertices as the one below; how the left and right ends are closed is not said. Here
        a layer has a vertex straight above every second inner vertex of the one below, layers are evenly spaced, and
        the ends of all layers are joined to the upper corners.
Check   `lemma_3_check.py`
"""

from collections.abc import Sequence
from itertools import pairwise

from gmpy2 import mpq

from exactmesh.geometry.point import Point
from exactmesh.steps.records import Cycle, UnitPiece


def triangulate_in_layers(positions: Sequence[int]) -> UnitPiece:
    """Return a proper triangulation of the rectangle; at least one inner position must be occupied."""
    m = len(positions) - 1
    if m < 2 or positions[0] != 0 or any(u >= v for u, v in pairwise(positions)):
        raise ValueError(f"positions must increase from 0 and have one inside, not {list(positions)}")
    left, right = m + 1, m + 2
    layers = [list(range(1, m))]
    x = {j: mpq(positions[j]) for j in layers[0]}
    count = (m - 1).bit_length()
    steiner: list[Point] = []
    faces: list[Cycle] = [(0, 1, left), (m - 1, m, right)]
    while len(below := layers[-1]) > 1:
        above = []
        for v in below[1::2]:
            steiner.append(Point(x[v], mpq(len(layers), count)))
            above.append(-len(steiner))
            x[above[-1]] = x[v]
        faces += _strip(below, above, left, right)
        layers.append(above)
    faces.append((left, layers[-1][0], right))
    return UnitPiece(tuple(faces), tuple(steiner))


def _strip(below: list[int], above: list[int], left: int, right: int) -> list[Cycle]:
    """Return the faces between two layers; above[i] stands over below[2 i + 1]."""
    faces: list[Cycle] = [(left, below[0], above[0])]
    for i, top in enumerate(above):
        faces.append((below[2 * i], below[2 * i + 1], top))
        if 2 * i + 2 < len(below):
            faces.append((below[2 * i + 1], below[2 * i + 2], top))
            if i + 1 < len(above):
                faces.append((below[2 * i + 2], above[i + 1], top))
    faces.append((above[-1], below[-1], right))
    return faces
