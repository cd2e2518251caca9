"""The blocks that the proofs of tilings list make up the figures of Lemma 3 and Theorem 2, for many positions."""

import importlib
from bisect import bisect_right
from itertools import combinations, pairwise
from pathlib import Path
from types import ModuleType

import pytest
from gmpy2 import mpq

from exactmesh.steps.layered_rectangle import triangulate_in_layers
from exactmesh.steps.lemma_3 import Teeth, triangulate_rectangle
from exactmesh.steps.records import UnitPiece

Place = tuple[mpq, mpq]
Faces = set[frozenset[tuple[Place, Place]]]
POSITIONS = [(0, *inner, c) for c in range(2, 9) for n in range(1, c) for inner in combinations(range(1, c), n)]


@pytest.fixture
def blocks(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(str(Path(__file__).parents[2] / "proofs_checks"))
    return importlib.import_module("paper_tilings")


def face(places: list[Place]) -> frozenset[tuple[Place, Place]]:
    return frozenset(pairwise((*places, places[0])))


def made(piece: UnitPiece, positions: tuple[int, ...]) -> Faces:
    c = mpq(positions[-1])
    at = [(mpq(u), mpq(0)) for u in positions] + [(mpq(0), mpq(1)), (c, mpq(1))]
    new = [(p.x, p.y) for p in piece.steiner]
    return {face([at[v] if v >= 0 else new[-1 - v] for v in cycle]) for cycle in piece.faces}


def lemma_3(blocks: ModuleType, u: tuple[int, ...], retiled: bool) -> Faces:
    """Put the figure together from the blocks."""
    last, x = u[-2], [1]
    while 2 * x[-1] <= last:
        x.append(2 * x[-1])
    x = [*(v for v in x[:-1] if 2 * v <= last), last]
    left = [bisect_right(u, v) - 1 for v in x]
    foot = [u[j] == v for v, j in zip(x, left, strict=True)]
    corners = {"A": (mpq(0), mpq(1)), "C": (mpq(u[-1]), mpq(1))}
    faces: Faces = set()

    def add(cycles: list[tuple[str, ...]], at: dict[str, Place]) -> None:
        faces.update(face([at[name] for name in cycle]) for cycle in cycles)

    def ground(j: int) -> Place:
        return mpq(u[j]), mpq(0)

    def node(i: int) -> Place:
        return mpq(x[i]), mpq(1, 3)

    for j in range(len(u) - 1):
        above = [i for i in range(len(x)) if left[i] == j and not foot[i]]
        if above:
            add(blocks.gap([f"e{i}" for i in above]),
                {"p": ground(j), "q": ground(j + 1)} | {f"e{i}": node(i) for i in above})
    first = {"u0": ground(0), "E": node(0), **corners}
    add([("u0", "E", "A")], first)
    if foot[0]:
        add([("u0", "u1", "E")], first | {"u1": ground(left[0])})
    on_edge = [node(0)]
    for i in range(len(x) - 1):
        before = [f"s{k}" for k in range(len(on_edge) - 1)] + ["E"]
        at = dict(zip(before, on_edge, strict=True)) | corners | {"F": node(i + 1)}

        def along(v: mpq, i: int = i) -> Place:
            return v, 1 - v / x[i + 1] * mpq(2, 3)

        at["T"] = along(mpq(x[i]))
        if left[i] == left[i + 1] and not foot[i]:
            add([("A", *before, "T"), ("E", "F", "T")], at)
            names = ["T", "F"]
        else:
            start = left[i] + (not foot[i])
            teeth = left[i + 1] - start
            at |= {f"u{k}": ground(start + k) for k in range(teeth + 1)}
            at |= {f"a{k}": along(mpq(u[start + k] + u[start + k + 1], 2)) for k in range(teeth)}
            cycles, names = blocks.lemma_3(foot[i], foot[i + 1], teeth, retiled, before)
            add(cycles, at)
        on_edge = [at[name] for name in names]
    before = [f"s{k}" for k in range(len(on_edge) - 1)] + ["E"]
    add([("A", *before, "C"), ("l", "m", "E"), ("m", "C", "E")],
        dict(zip(before, on_edge, strict=True)) | corners | {"l": ground(-2), "m": ground(-1)})
    return faces


def layers(blocks: ModuleType, u: tuple[int, ...]) -> Faces:
    row = [(mpq(v), mpq(0)) for v in u[1:-1]]
    a, c = (mpq(0), mpq(1)), (mpq(u[-1]), mpq(1))
    rows = len(row).bit_length()
    faces = {face([(mpq(0), mpq(0)), row[0], a]), face([row[-1], (mpq(u[-1]), mpq(0)), c])}
    for number in range(1, rows):
        above = [(x, mpq(number, rows)) for x, _ in row[1::2]]
        at = {"A": a, "C": c} | {f"b{i}": p for i, p in enumerate(row)} | {f"a{i}": p for i, p in enumerate(above)}
        faces |= {face([at[name] for name in cycle]) for cycle in blocks.layers(len(row))}
        row = above
    return faces | {face([a, row[0], c])}


@pytest.mark.parametrize("teeth", ["midpoint", "retiled"])
def test_the_blocks_of_lemma_3(teeth: Teeth, blocks: ModuleType) -> None:
    for positions in POSITIONS:
        assert lemma_3(blocks, positions, teeth == "retiled") == made(
            triangulate_rectangle(positions, teeth), positions), positions


def test_the_strips_of_layers(blocks: ModuleType) -> None:
    for positions in POSITIONS:
        assert layers(blocks, positions) == made(triangulate_in_layers(positions), positions), positions
