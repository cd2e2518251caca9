"""The constants of the repaired construction, and the bounds its checkers assert. Lengths are in units of mfs(P).

`LEVEL` (g) is the spacing of the horizontal levels. The offset body K1 is the octagon with the vertices (+-a, +-3g/2)
and (+-b, +-g/2), a = `FLAT`, b = `WIDE`: it holds K0 + S, where K0 = conv{(+-a, +-g), (+-b, 0)} contains the disc of
radius g and S is the vertical segment of length g that snapping may use up. K2 = K1 + S is as far as anything
reaches, with radius rho, rho^2 = a^2 + (2g)^2; rho < b is false, so F = 1 - 2 rho is what two offsets leave between.
"""

from gmpy2 import mpq

LEVEL = mpq(29, 125)
FLAT = mpq(3, 40)
WIDE = mpq(817, 2000)

# Every face keeps at least this feature size; its inverse, 5/g = 21.5517, is the design value of the degradation.
FEATURE = LEVEL / 5
FEATURE_SQUARED = FEATURE * FEATURE

# The bounds asserted on every run (DESIGN numbers rounded to the safe side where they are irrational).
THICKNESS_MAX = mpq(4701, 10000)
SEPARATION = mpq(599, 10000)
GAP = 2 * FLAT
DESIGN_DEGRADATION = mpq(108, 5)
PAPER_DEGRADATION = mpq(45)
PAPER_FEATURE = mpq(22, 1000)
STEINER_PER_CORNER = 35

# Wedges are cut off where a leg lies under more than this many heights of the opposite side.
WEDGE_HEIGHTS = 2
