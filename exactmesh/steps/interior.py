"""Triangulate the trapezoids: the Interior (in place of paper §2, P6).

In      `Offset`, `Trapezoidation`, and the points of all vertices so far.
Out     `Patch`: the faces, Steiner vertices and feet; `on_edge` has the feet with the edges of Q they lie on.
Exact   rational throughout: feet and Steiner vertices are given by rational rules, candidates measured exactly.
Paper   joins one vertex to the corners of every trapezoid and leaves T-vertices on its sides, which makes the
        degradation unbounded; here T-vertices are absorbed.
Check   `patch_check.py`

A trapezoid without T-vertices goes to `quad`. From any other one wedges are cut off (`wedges.py`). Then edges between
consecutive opposite T-vertices leave pieces with T-vertices on one side only. In the coarse balance what is too thin is
merged with what lies beside it (`merging.py`).
"""

from collections.abc import Sequence
from itertools import groupby

from exactmesh.geometry.point import Point
from exactmesh.steps.balance import REPAIRED, Balance
from exactmesh.steps.merging import merged_where_thin
from exactmesh.steps.patch_builder import PatchBuilder
from exactmesh.steps.records import Offset, Patch, Trapezoidation
from exactmesh.steps.wedges import BOTTOM, FLIPS, LEFT, RIGHT, TOP, Leftover


def triangulate_interior(offset: Offset, trapezoidation: Trapezoidation, points: Sequence[Point],
                         proper: bool = False, balance: Balance = REPAIRED) -> Patch:
    """Return the triangulation of all trapezoids; `points` has the vertices of P, Q and the chord ends."""
    mesh = PatchBuilder(points, proper, balance)
    of_q = range(offset.first, trapezoidation.first)
    for z in trapezoidation.trapezoids:
        if z.top or z.bottom:
            _triangulate(Leftover(mesh, of_q, z))
        else:
            mesh.add_quad((z.bl, z.br, z.tr, z.tl))
    patch = mesh.finished()
    if balance.merges:
        return merged_where_thin(patch, mesh.face_counts, offset, trapezoidation, points, balance)
    return patch


def _triangulate(rest: Leftover) -> None:
    for flip in FLIPS:
        rest.cut_wedge(flip)
    if rest.side[TOP] or rest.side[BOTTOM]:
        _absorb(rest)
    else:
        rest.mesh.add_quad([rest.corner[place] for place in
                            ((LEFT, BOTTOM), (RIGHT, BOTTOM), (RIGHT, TOP), (LEFT, TOP))])


def _absorb(rest: Leftover) -> None:
    """Close each run of T-vertices on one side by an edge to the next T-vertex on the other side."""
    left = {TOP: rest.corner[LEFT, TOP], BOTTOM: rest.corner[LEFT, BOTTOM]}
    # By abscissa; of two at one abscissa the upper one comes first.
    order = sorted((rest.x(v), -t, v) for t in (TOP, BOTTOM) for v in rest.side[t])
    runs = [(-negative, [v for _, _, v in run]) for negative, run in groupby(order, key=lambda item: item[1])]
    for i, (t, run) in enumerate(runs):
        # The first of a run may be the end of the edge that closed the last one.
        t_side = [left[t], *(v for v in run if v != left[t])]
        if i + 1 < len(runs):
            closing = runs[i + 1][1][0]
        else:
            t_side.append(rest.corner[RIGHT, t])
            closing = rest.corner[RIGHT, -t]
        rest.mesh.add_one_sided(t_side, left[-t], closing)
        left[t], left[-t] = t_side[-1], closing
