"""The minimum feature size (mfs) of a PSLG, exactly, with its witness.

mfs is the least distance between a vertex and a feature, an edge or a vertex, that does not contain it. Distances
between two vertices decide only where one of them is isolated or the two are an edge by themselves; everywhere else
an edge at the other vertex is at least as near.
"""

from collections import Counter
from dataclasses import dataclass

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
    degree = Counter(v for edge in pslg.edges for v in edge)
    lonely = [v for v in range(len(pslg.vertices)) if degree[v] == 0]
    pairs = [edge for edge in pslg.edges if degree[edge[0]] == degree[edge[1]] == 1]
    points_only = lonely + [v for edge in pairs for v in edge]
    features = list(pslg.edges) + [(v, v) for v in points_only]
    best: tuple[mpq, int, int] | None = None
    if len(pslg.vertices) * len(features) <= _FEW:
        candidates = [(v, f) for f, ends in enumerate(features) for v in range(len(pslg.vertices)) if v not in ends]
    else:
        candidates = nearest_candidates(pslg.vertices, features)
    for vertex, feature in candidates:
        a, b = features[feature]
        squared = segment_distance_squared(pslg.vertices[vertex], pslg.vertices[a], pslg.vertices[b])
        key = (squared, feature, vertex)
        if best is None or key < best:
            best = key
    return None if best is None else Nearest(best[0], best[2], features[best[1]])
