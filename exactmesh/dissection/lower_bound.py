"""The square to the r x 1 rectangle (paper, Section 5): pieces made beside the fewest there can be.

The square has the area r, so its diameter is sqrt(2 r), and no piece is wider. In the rectangle the pieces together
are as wide as r, so there are at least r / sqrt(2 r) = sqrt(r / 2) of them: Omega(sqrt r).
"""

import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from gmpy2 import isqrt

from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.verify import verify_dissection
from exactmesh.planar.pslg import Pslg, polygon

LENGTHS = (2, 3, 5, 7, 10, 15, 20, 30, 40, 50, 60, 70, 80, 90, 100)


@dataclass(frozen=True, slots=True)
class Row:
    """One rectangle; `fewest` is the least whole number that the lower bound allows."""

    length: int
    fewest: int
    pieces: int
    cells: tuple[int, ...]
    strip_bound: int
    valid: bool


def fewest(length: int) -> int:
    """Return the least m >= sqrt(length / 2)."""
    root = int(isqrt(length // 2))
    return root if 2 * root * root >= length else root + 1


def rectangle_to_square(length: int) -> tuple[Pslg, Pslg]:
    """Return the rectangle and a square, which is to be scaled."""
    return (polygon([(0, 0), (length, 0), (length, 1), (0, 1)], f"{length} x 1"),
            polygon([(0, 0), (1, 0), (1, 1), (0, 1)], "square"))


def rectangle_rows(lengths: Sequence[int] = LENGTHS, progress: Callable[[str], None] = lambda step: None
                   ) -> Iterator[Row]:
    """Yield the dissections of the rectangles, each checked."""
    for length in lengths:
        progress(f"{length} x 1")
        figures = rectangle_to_square(length)
        made = dissect(figures, scale=True)
        verdict = verify_dissection(figures, made.dissection)
        yield Row(length, fewest(length), len(made.dissection.pieces), made.cells, made.strip_bound, verdict.valid)


def rectangles_text(found: Sequence[Row]) -> str:
    """Return the table."""
    lines = ["square -> r x 1     pieces  at least sqrt(r/2)  pieces / sqrt(r)  bound by cells  checked"]
    for row in found:
        ratio = row.pieces / row.length**0.5
        lines.append(f"r = {row.length:<14} {row.pieces:7} {row.fewest:19} {ratio:17.2f} {row.strip_bound:15}  "
                     f"{'yes' if row.valid else 'NO'}")
    return "\n".join(lines)


def rectangles_json(found: Sequence[Row]) -> str:
    """Return the table as JSON."""
    return json.dumps({"rows": [{"r": row.length, "at_least": row.fewest, "pieces": row.pieces,
                                 "cells": list(row.cells), "bound": row.strip_bound, "valid": row.valid}
                                for row in found]})
