"""How the constants of the offset, of the levels and of the faces are weighed against each other.

In a corridor of width 1 there is room for the Tube on either side, for two motions by half a level, and for what keeps
the sides of Q apart: 2 t + 2 g + F <= 1, t the least thickness of the Tube and g the spacing of the levels. The offset
body K1 is the octagon with the vertices (+-a, +-(t + g/2)) and (+-b, +-g/2), a = `flat`, b = `wide`, t = `crown` g. It
is K0 + S: K0 = conv{(+-a, +-t), (+-b, 0)} contains the disc of radius t, and S, the vertical segment of length g about
0, is what snapping may use up. Where many T-vertices face an empty side at distance h, no triangulation keeps more than
h/5, so t >= 5 f when every face is to keep f.

`REPAIRED` has t = g = 5 f: then trapezoids one level high are good as they are. `COARSE` has t = 2 g = 5 f: only those
two levels high are, and lower ones have to be merged with their neighbours (`clusters.py`).
"""

from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.steps.constants import FEATURE, FLAT, LEVEL, WIDE


@dataclass(frozen=True, slots=True)
class Balance:
    """Lengths are in units of mfs(P). `merges`: trapezoids are merged where a face keeps less than `feature`."""

    level: mpq
    crown: int
    flat: mpq
    wide: mpq
    feature: mpq
    merges: bool

    @property
    def feature_squared(self) -> mpq:
        """The squared feature size that every face is to keep."""
        return self.feature**2


REPAIRED = Balance(LEVEL, 1, FLAT, WIDE, FEATURE, merges=False)

_COARSE_LEVEL = mpq(723, 5000)
COARSE = Balance(_COARSE_LEVEL, 2, mpq(1, 8), mpq(199, 500), 2 * _COARSE_LEVEL / 5, merges=True)

# What the checkers assert of the coarse balance. rho = sqrt(a^2 + 9 g^2) = 0.45145.. is the reach of K2, and
# F = 1 - 2 rho = 0.09709.. the separation inside Q, both rounded to the safe side.
COARSE_THICKNESS_MAX = mpq(903, 2000)
COARSE_SEPARATION = mpq(97, 1000)
# A vertex of Q on a T-vertex's level is at least sqrt((1 - rho)^2 - 9 g^2) - a = 0.2107 from it, or both are one cap's.
COARSE_GAP = mpq(21, 100)
# Snapping levels an edge of at least 1 - 2 sqrt(a^2 + 25 g^2 / 4) = 0.2347 that rises by at most g.
COARSE_LEVEL_EDGE = mpq(9, 50)
COARSE_EDGE_GAP = mpq(18, 125)
# 5/(2 g) = 17.2891.., and room for m <= mfs.
COARSE_DEGRADATION = mpq(173, 10)
