"""Check the change of units from its definition; `shape.py` is not imported."""

from gmpy2 import mpq

from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.planar.pslg import Pslg
from exactmesh.steps.constants import UNIT_SLACK
from exactmesh.steps.records import Shape


def check_unit(pslg: Pslg, mfs_squared: mpq, shape: Shape) -> Verdict:
    """Return whether m <= mfs <= (1 + 1e-6) m and every point is the input's divided by m; the worst (mfs / m)^2."""
    for v, (given, scaled) in enumerate(zip(pslg.vertices, shape.points, strict=True)):
        if (scaled.x * shape.unit, scaled.y * shape.unit) != (given.x, given.y):
            return failed(v + 1, "points are the input's in units of m", vertex=v, at=str(scaled))
    ratio = mfs_squared / shape.unit**2
    if ratio < 1:
        return failed(len(pslg.vertices), "m <= mfs", unit=str(shape.unit), mfs_squared=str(mfs_squared))
    tally = Tally("mfs <= (1 + 1e-6) m", "<=", (1 + UNIT_SLACK) ** 2)
    tally.see(ratio, unit=str(shape.unit))
    return tally.verdict()
