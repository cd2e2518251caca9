"""The edges that a sweep line cuts, from below: a list in blocks, so that a change moves a few hundred numbers at most.

One list of all of them costs a sweep over n edges n^2 moves where the line cuts many of them at once, as in a star.
"""

from bisect import bisect_left
from collections.abc import Callable

# Blocks are halved beyond this many edges.
_LONGEST = 512

Place = tuple[int, int]


class Status:
    """A sequence of edges. A `Place` is a block and a place in it, of the end: behind the last block."""

    __slots__ = ("_blocks",)

    def __init__(self) -> None:
        self._blocks: list[list[int]] = []

    def first(self, height: Callable[[int], int]) -> Place:
        """Return the place of the first edge whose `height`, which rises along the sequence, is not negative."""
        blocks = self._blocks
        block = bisect_left(blocks, 0, key=lambda edges: height(edges[-1])) if len(blocks) > 1 else 0
        if block == len(blocks):
            return block, 0
        place = bisect_left(blocks[block], 0, key=height)
        return (block, place) if place < len(blocks[block]) else (block + 1, 0)

    def before(self, at: Place) -> int:
        """Return the edge before a place, -1 at the beginning."""
        block, place = at
        if place:
            return self._blocks[block][place - 1]
        return self._blocks[block - 1][-1] if block else -1

    def run(self, at: Place, belongs: Callable[[int], bool]) -> tuple[list[int], int]:
        """Return the edges from a place on for as long as they belong, and the edge after them, -1 at the end."""
        block, place = at
        found: list[int] = []
        while block < len(self._blocks):
            edges = self._blocks[block]
            while place < len(edges):
                if not belongs(edges[place]):
                    return found, edges[place]
                found.append(edges[place])
                place += 1
            block, place = block + 1, 0
        return found, -1

    def replace(self, at: Place, count: int, edges: list[int]) -> None:
        """Put `edges` in the place of the `count` edges from a place on."""
        blocks = self._blocks
        block, place = at
        if block == len(blocks):
            if not edges:
                return
            if blocks:
                block, place = block - 1, len(blocks[-1])
            else:
                blocks.append([])
        here = blocks[block]
        left = count - (len(here) - place)
        here[place : place + count] = edges
        while left > 0:
            behind = blocks[block + 1]
            gone = min(left, len(behind))
            del behind[:gone]
            left -= gone
            if not behind:
                del blocks[block + 1]
        if not here:
            del blocks[block]
        elif len(here) > _LONGEST:
            middle = len(here) // 2
            blocks[block : block + 1] = [here[:middle], here[middle:]]
