"""The minimum feature size (mfs) of a PSLG, exactly, with its witness.

mfs is the least distance between a vertex and a feature, an edge or a vertex, that does not contain it. Distances
between two vertices decide only where one of them is isolated or the two are an edge by themselves; everywhere else
an edge at the other vertex is at least as near.
"""

from dataclasses import dataclass

import numpy as np
from gmpy2 import mpq

from exactmesh.geometry.distance import segment_distance_squared
from exactmesh.measure.candidates import nearest_candidates
from exactmesh.planar.pslg import Edge, Pslg

# So few pairs are decided exactly in less time than it takes to find the near ones.
_FEW = 150


@dataclass(frozen=True, slots=True)
class Nearest:
    """The nearest pair: `squared` distance of `vertex` from `feature`, which is an edge, or a vertex twice over."""

    squared: mpq
    vertex: int
    feature: Edge

    @property
    def is_vertex_pair(self) -> bool:
        """Whether the feature is a vertex."""
        return self.feature[0] == self.feature[1]


def minimum_feature_size(pslg: Pslg) -> Nearest | None:
    """Return the squared minimum feature size of `pslg` and a pair that has it; None when there is no pair.

    Edges may cross: the definition does not mind. Among equally near pairs, edges come before vertices and lower
    indices first.
    """
    count = len(pslg.vertices)
    ends = np.array(pslg.edges, dtype=np.int64).reshape(-1, 2)
    degree = np.bincount(ends.ravel(), minlength=count)
    alone = ends[(degree[ends] == 1).all(axis=1)]
    points_only = np.concatenate((np.flatnonzero(degree == 0), alone.ravel()))
    features = np.concatenate((ends, np.column_stack((points_only, points_only))))
    best: tuple[mpq, int, int] | None = None
    if count * len(features) <= _FEW:
        candidates = [(v, f) for f, pair in enumerate(features.tolist()) for v in range(count) if v not in pair]
    else:
        candidates = nearest_candidates(pslg.vertices, features)
    for vertex, feature in candidates:
        a, b = features[feature].tolist()
        squared = segment_distance_squared(pslg.vertices[vertex], pslg.vertices[a], pslg.vertices[b])
        key = (squared, feature, vertex)
        if best is None or key < best:
            best = key
    if best is None:
        return None
    a, b = features[best[1]].tolist()
    return Nearest(best[0], best[2], (a, b))
