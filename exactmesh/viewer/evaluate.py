"""What the editor asks of a polygon, part by part, so that what is quick is seen first.

Parts are JSON objects with a `part`: "input" with the exact mfs, "repaired" and "paper" with a document each (see
`document.py`) or with `refused` or `failed` in its place, "error" where the input is none, "end" at last.
"""

from collections.abc import Iterator, Mapping

from exactmesh.claims.run import ConstructionName, Run
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.io.pslg_json import pslg_from_value
from exactmesh.io.strict_json import Json
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.planar import validate
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg
from exactmesh.viewer.document import document_of, size_of
from exactmesh.viewer.subject import subject_of_run

Part = Mapping[str, object]
# What is drawn by hand is small; beyond this the answer would come too late to be of use.
MAX_VERTICES = 1000
MAX_BITS = 4096


def evaluate(value: Json, with_claims: bool) -> Iterator[Part]:
    """Yield the parts of the answer for an exactmesh-pslg/1 as parsed JSON; errors of the input are parts too.

    Without claims, the mesh of the repaired construction is all that is made.
    """
    try:
        pslg = pslg_from_value(value)
        _refuse_big(pslg)
        domain_of(pslg)
    except InputError as error:
        yield {"part": "error", "message": str(error), **_place(error)}
        yield {"part": "end"}
        return
    yield {"part": "input", "sizes": list(size_of("input", minimum_feature_size(pslg)))}
    names: tuple[ConstructionName, ...] = ("repaired", "paper") if with_claims else ("repaired",)
    for name in names:
        yield {"part": name, **_made(pslg, name, with_claims)}
    yield {"part": "end"}


def _made(pslg: Pslg, name: ConstructionName, with_claims: bool) -> Part:
    try:
        return {"document": document_of(subject_of_run(Run(pslg, name), name, True, with_claims))}
    except InputError as error:
        return {"refused": str(error)}
    except ConstructionFailed as error:
        return {"failed": f"{error}: this is a counterexample to the construction, please report the input"}


def _refuse_big(pslg: Pslg) -> None:
    """Raise `InputError` for what cannot be answered while someone waits."""
    if len(pslg.vertices) > MAX_VERTICES:
        raise InputError(f"the editor takes up to {MAX_VERTICES} vertices, not {len(pslg.vertices)}")
    for v, p in enumerate(pslg.vertices):
        if max(part.bit_length() for c in p for part in (c.numerator, c.denominator)) > MAX_BITS:
            raise InputError(f"vertex {v}: the editor takes coordinates of up to {MAX_BITS} bits")


def _place(error: InputError) -> Part:
    """Return where the input breaks: vertices and edges by number, and the exact point."""
    match error:
        case validate.VerticesCoincide():
            found: dict[str, object] = {"vertices": [error.first, error.second]}
        case validate.VertexOnEdge():
            found = {"vertices": [error.vertex], "edges": [error.ends]}
        case validate.EdgesOverlap() | validate.EdgesCross():
            found = {"edges": list(error.ends)}
        case validate.HolePointOnBoundary():
            found = {}
        case _:
            return {}
    return {**found, "at": [str(error.at.x), str(error.at.y)]}
