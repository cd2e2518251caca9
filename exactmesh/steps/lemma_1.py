"""The paper's Lemma 1: where to put one vertex into a trapezoid so that the feature size at most halves.

Everything happens on the mid-height line, so only abscissae matter: those of the ends of the two parallel sides.
"""

from gmpy2 import mpq


def lemma_1_abscissa(bottom_left: mpq, bottom_right: mpq, top_left: mpq, top_right: mpq) -> mpq:
    """Return the abscissa of Lemma 1's vertex, which stands halfway between the parallel sides.

    When the shorter side, projected onto the longer one, fits into it, this is the middle of the shorter side.
    Otherwise both legs slant the same way, and it is the centre of the parallelogram that the shorter side sweeps
    with one end on the leg whose angle with it is obtuse.
    """
    if top_right - top_left < bottom_right - bottom_left:
        short, long = (top_left, top_right), (bottom_left, bottom_right)
    else:
        short, long = (bottom_left, bottom_right), (top_left, top_right)
    middle = (short[0] + short[1]) / 2
    if long[0] <= short[0] and short[1] <= long[1]:
        return middle
    width = short[1] - short[0]
    if long[0] > short[0]:
        # The long side lies to the right: the short one is swept along the left leg.
        return (middle + long[0] + width / 2) / 2
    return (middle + long[1] - width / 2) / 2
