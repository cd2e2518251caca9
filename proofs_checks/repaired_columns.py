"""Prove that in internal meshes two kinds of polygons between columns keep g/5, a part of
`repaired.internal-degradation`.

Given   a room: its columns are 0.075 at most from upright (`MERGE`); neighbours on a chord are 0.0688 apart or more
        (`repaired.level-edge`; T-vertices 0.15, new vertices 0.075). In the Tube columns are upright on e.
Claim   room     between two columns from chord to chord: the diagonal from bottom left to top right
        tube     between two columns onto an edge of P, W >= 0.06 apart: the diagonal from the lower end on e'
Method  combinations, a problem a height.
Tight   a room of least width and height keeps 0.058.
By hand what is in neither this script nor `repaired_columns_legs` (a chord and one leg, steps), nor in
        `repaired_columns_tube` (the Tube): polygons with more parts, which is why no claim follows.
"""

from gmpy2 import mpq
from kit import Hint, Theorem, at_least, main, spot
from repaired_clean import heights
from repaired_tube import within

from exactmesh.proofs.polynomial import variables
from exactmesh.steps.constants import FEATURE, LEVEL, LEVEL_EDGE, MERGE, THICKNESS_MAX

b, l, r, t, u, H, W = variables("b l r t u H W")  # noqa: E741
SOME = Hint(degrees=(2, 3, 4, 5, 6))
COLUMNS = (at_least(b, LEVEL_EDGE), at_least(b + r - l, LEVEL_EDGE), *within(l, -MERGE, MERGE),
           *within(r, -MERGE, MERGE), at_least(H, LEVEL))
ROOM = heights("columns.room-below", "BL, BR, TR = (b + r, H)", COLUMNS,
               (spot(0, 0), spot(b, 0), spot(b + r, H)), FEATURE, SOME)
ROOM += heights("columns.room-above", "BL, TR, TL = (l, H)", COLUMNS,
                (spot(0, 0), spot(b + r, H), spot(l, H)), FEATURE, SOME)
UPRIGHT = (at_least(W, mpq(6, 100)), *within(t, LEVEL, THICKNESS_MAX), *within(u, t, THICKNESS_MAX))
TUBE = heights("columns.tube-below", "two feet, and (0, t) above the first", UPRIGHT,
               (spot(0, 0), spot(W, 0), spot(0, t)), FEATURE, SOME)
TUBE += heights("columns.tube-above", "the second foot, (W, u) above it, (0, t)", UPRIGHT,
                (spot(W, 0), spot(W, u), spot(0, t)), FEATURE, SOME)
STATEMENTS = [*ROOM, *TUBE]

GROUP = "columns"
THEOREMS = [Theorem(
    "repaired.internal-degradation", "part", "polygons between columns from chord to chord keep g/5",
    tuple(statement.id for statement in STATEMENTS),
    "`quad` takes the better diagonal. Polygons with parts of legs or steps are no part of this; nor is it proved how "
    "near neighbours on a leg are.",
    "0.058, at the least width and height")]

if __name__ == "__main__":
    main(GROUP, THEOREMS, STATEMENTS)
