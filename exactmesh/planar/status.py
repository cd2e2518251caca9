"""The edges that a sweep line cuts, from below: a list in blocks, so that a change moves a few numbers only.

One list of all of them costs a sweep over n edges n^2 moves where the line cuts many of them at once, as in a star.
Each edge knows its block, so that what ends is found without a search.
"""

from collections.abc import Callable, Sequence

# Blocks are halved beyond this many edges.
_LONGEST = 128

Place = tuple[int, int]
_END: Place = (-1, 0)


class Status:
    """A sequence of edges with numbers below `count`. A `Place` is the number of a block and a place in it, of the end:
    behind all blocks. `_order` has the numbers of the blocks, none of them empty, and `_last` their last edges."""

    __slots__ = ("_blocks", "_home", "_last", "_order")

    def __init__(self, count: int) -> None:
        self._blocks: list[list[int]] = []
        self._order: list[int] = []
        self._last: list[int] = []
        self._home = [-1] * count

    def first(self, count_before: Callable[[Sequence[int]], int]) -> Place:
        """Return the place of the first edge that is not before something; `count_before` says how many edges of a part
        of the sequence are."""
        number = count_before(self._last) if len(self._order) > 1 else 0
        if number == len(self._order):
            return _END
        block = self._order[number]
        place = count_before(self._blocks[block])
        return (block, place) if place < len(self._blocks[block]) else _END

    def place(self, edge: int) -> Place:
        """Return the place of an edge of the sequence."""
        block = self._home[edge]
        return block, self._blocks[block].index(edge)

    def previous(self, at: Place) -> Place | None:
        """Return the place before a place; None at the beginning."""
        block, place = at
        if place:
            return block, place - 1
        number = len(self._order) if block < 0 else self._order.index(block)
        if not number:
            return None
        block = self._order[number - 1]
        return block, len(self._blocks[block]) - 1

    def before(self, at: Place) -> int:
        """Return the edge before a place, -1 at the beginning."""
        block, place = at
        if place:
            return self._blocks[block][place - 1]
        number = len(self._order) if block < 0 else self._order.index(block)
        return self._last[number - 1] if number else -1

    def run(self, at: Place, belongs: Callable[[int], bool]) -> tuple[list[int], int]:
        """Return the edges from a place on for as long as they belong, and the edge after them, -1 at the end."""
        block, place = at
        found: list[int] = []
        while block >= 0:
            edges = self._blocks[block]
            while place < len(edges):
                if not belongs(edges[place]):
                    return found, edges[place]
                found.append(edges[place])
                place += 1
            block, place = self._after(block), 0
        return found, -1

    def replace(self, at: Place, count: int, edges: Sequence[int]) -> None:
        """Put `edges` in the place of the `count` edges from a place on."""
        block, place = at
        if block < 0:
            if not edges:
                return
            if not self._order:
                self._insert(0, [])
            block = self._order[-1]
            place = len(self._blocks[block])
        here = self._blocks[block]
        left = place + count - len(here)
        here[place : place + count] = edges
        for edge in edges:
            self._home[edge] = block
        if left < 0 and len(here) <= _LONGEST:
            return
        # What follows comes once in many times: the last edge of a block changes, or there are too many of them.
        while left > 0:
            behind = self._after(block)
            gone = min(left, len(self._blocks[behind]))
            del self._blocks[behind][:gone]
            left -= gone
            self._settle(behind)
        self._settle(block)

    def _after(self, block: int) -> int:
        """Return the block after a block, -1 at the end."""
        number = self._order.index(block) + 1
        return self._order[number] if number < len(self._order) else -1

    def _settle(self, block: int) -> None:
        """Take away a block that has become empty, halve one that has become long, and note the last edge."""
        number, edges = self._order.index(block), self._blocks[block]
        if not edges:
            del self._order[number], self._last[number]
            return
        if len(edges) > _LONGEST:
            middle = len(edges) // 2
            behind = edges[middle:]
            del edges[middle:]
            self._insert(number + 1, behind)
            self._settle(self._order[number + 1])
            self._settle(block)
            return
        self._last[number] = edges[-1]

    def _insert(self, number: int, edges: list[int]) -> None:
        """Add a block, which has the given place in the order."""
        block = len(self._blocks)
        self._blocks.append(edges)
        self._order.insert(number, block)
        self._last.insert(number, -1)
        for edge in edges:
            self._home[edge] = block
