"""The constants of the repaired construction, and the bounds its checkers assert. Lengths are in units of mfs(P).

`LEVEL` (g) is the spacing of the horizontal levels. The offset body K1 is the octagon with the vertices (+-a, +-3g/2)
and (+-b, +-g/2), a = `FLAT`, b = `WIDE`. It is K0 + S: K0 = conv{(+-a, +-g), (+-b, 0)} contains the disc of radius g,
and S, the vertical segment of length g about 0, is what snapping may use up on either side. Nothing reaches farther
from its source than K2 = K1 + S, whose radius is rho = sqrt(a^2 + 4 g^2) = 0.470022...; two offsets of features at
distance 1 therefore stay F = 1 - 2 rho = 0.05995... apart.
"""

from gmpy2 import mpq

LEVEL = mpq(29, 125)
FLAT = mpq(3, 40)
WIDE = mpq(817, 2000)

# Every face keeps at least this feature size; its inverse, 5/g = 21.5517, is what the degradation cannot exceed.
FEATURE = LEVEL / 5
FEATURE_SQUARED = FEATURE**2
# Above mfs/45, by more than what m may be below the mfs: what the paper's promise asks of the Tube.
TUBE_FEATURE = mpq(223, 10000)

# The unit m is a rational at most this much, relatively, below the mfs.
UNIT_SLACK = mpq(1, 10**6)

# rho and F, rounded to the safe side because they are irrational.
THICKNESS_MAX = mpq(4701, 10000)
SEPARATION = mpq(599, 10000)
# The least gap between two vertices of Q on one side of a chord, unless an edge joins them: the width of a flat cap.
GAP = 2 * FLAT
# The least length of a level edge of Q at a T-vertex: snapping may level the edge between two convex corners.
LEVEL_EDGE = mpq(43, 625)
# The same between vertices recorded on an edge of Q.
EDGE_GAP = mpq(67, 500)

# Room for m <= mfs above 5/g, and the two numbers the paper promises.
DESIGN_DEGRADATION = mpq(108, 5)
PAPER_DEGRADATION = mpq(45)
PAPER_FEATURE = mpq(22, 1000)
VERTICES_PER_CORNER = 35

# A proper mesh keeps max(21.6, 9 (1 + log2 n)), and has about one vertex more for each gap of a layered piece, of
# which there are at most 16 a corner.
PROPER_FACTOR = mpq(9)
# What is proved of every proper mesh: at most 22 (1 + log2 n).
PROPER_LOGARITHM = mpq(22)
PROPER_VERTICES_PER_CORNER = VERTICES_PER_CORNER + 16

# In internal meshes an edge across a trapezoid or the Tube ends at a vertex within this distance of its line.
MERGE = FLAT
# In internal meshes a chord ends where it comes as near as this to a shallow leg.
TRIM = mpq(57, 1000)

# A wedge is cut off where a leg lies under a side by more than this many heights of the trapezoid.
WEDGE_HEIGHTS = 2
