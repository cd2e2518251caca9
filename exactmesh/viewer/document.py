"""What a page draws, as JSON. Exact numbers are texts; the page makes floats of them to draw, and nothing else."""

import json
from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

from gmpy2 import mpq

from exactmesh.io.text import printable
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text, text_from_rational
from exactmesh.numbers.root import root_expression
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Edge
from exactmesh.viewer.marks import Marks
from exactmesh.viewer.stages import Stage
from exactmesh.viewer.subject import ClaimRecord, Subject

# Faces are shaded by halves of the reference size: at least all of it, 1/2, 1/4, .. and below the last.
SHADES = 7
_DIGITS = 8


def document_of(subject: Subject) -> dict[str, object]:
    """Return the JSON object of a subject."""
    mesh, extra = subject.mesh, subject.stages.extra
    features, t_vertices = _faces(mesh)
    known = [squared for squared in features if squared is not None]
    reference = subject.input_mfs.squared if subject.input_mfs is not None else max(known, default=mpq(1))
    return {
        "title": printable(subject.title),
        "kind": mesh.kind,
        "given": subject.given,
        "x": [*(text_from_rational(p.x) for p in mesh.vertices), *(point.near[0] for point in extra)],
        "y": [*(text_from_rational(p.y) for p in mesh.vertices), *(point.near[1] for point in extra)],
        "vertices": len(mesh.vertices),
        "extra": [point.exact for point in extra],
        "faces": list(mesh.faces),
        "features": [None if squared is None else text_from_rational(squared) for squared in features],
        "shades": [_shade(squared, reference) for squared in features],
        "reference": "mfs of the input" if subject.input_mfs is not None else "largest feature size of a face",
        "t_vertices": t_vertices,
        "sizes": [*size_of("input", subject.input_mfs), *size_of("mesh", subject.mesh_mfs)],
        "degradation": _root(subject.degradation_squared),
        "claims": [_claim(claim, subject) for claim in subject.claims],
        "stages": [_stage(stage) for stage in subject.stages.stages],
    }


def json_text(document: Mapping[str, object]) -> str:
    """Return a document as JSON that can stand in a script element: nothing in it ends or begins one."""
    return json.dumps(document, separators=(",", ":")).replace("<", "\\u003c")


def _faces(mesh: Mesh) -> tuple[list[mpq | None], list[int]]:
    """Return the squared feature size of each face, None where it is no triangle, and the T-vertices."""
    features: list[mpq | None] = []
    t_vertices: set[int] = set()
    for cycle in mesh.faces:
        corners = corners_of(mesh.vertices, cycle)
        if isinstance(corners, NotTriangle):
            features.append(None)
            continue
        features.append(face_feature_squared(mesh.vertices, cycle, corners))
        if len(cycle) > 3:
            t_vertices.update(v for place, v in enumerate(cycle) if place not in corners)
    return features, sorted(t_vertices)


def _shade(squared: mpq | None, reference: mpq) -> int:
    """Return 0 for a feature size of the reference or more, one more for each halving; -1 where there is none."""
    if squared is None:
        return -1
    return next((k for k in range(SHADES - 1) if squared * 4**k >= reference), SHADES - 1)


def _root(squared: mpq | None) -> dict[str, str] | None:
    if squared is None:
        return None
    return {"squared": text_from_rational(squared), "exact": root_expression(squared),
            "decimal": sqrt_text(squared, _DIGITS)}


def size_of(whose: str, nearest: Nearest | None) -> Iterable[dict[str, object]]:
    """Yield a feature size with its witness, or nothing."""
    if nearest is not None:
        yield {"of": whose, **(_root(nearest.squared) or {}), "vertex": nearest.vertex, "feature": nearest.feature}


def _claim(claim: ClaimRecord, subject: Subject) -> dict[str, object]:
    witness = claim["witness"]
    place = witness if isinstance(witness, Mapping) else {}
    return {**{name: claim[name] for name in ("id", "paper", "statement", "bound", "instances", "holds", "worst")},
            "clause": str(place.get("clause", "")),
            "place": [[name, _text(value)] for name, value in place.items() if name != "clause"],
            "marks": _marks(subject.places.marks(place))}


def _text(value: object) -> str:
    return ", ".join(map(str, value)) if isinstance(value, list | tuple) else str(value)


def _marks(marks: Marks) -> dict[str, object]:
    return {"vertices": marks.vertices, "edges": marks.edges, "cycles": marks.cycles,
            "points": [[text_from_rational(p.x), text_from_rational(p.y)] for p in marks.points]}


def _stage(stage: Stage) -> dict[str, object]:
    return {"name": stage.name, "says": stage.says, "edges": _flat(stage.edges), "cycles": stage.cycles,
            "old": [[run.start, run.stop] for run in stage.old], "new": [[run.start, run.stop] for run in stage.new],
            "arcs": stage.arcs}


def _flat(edges: Sequence[Edge]) -> list[int]:
    return list(chain.from_iterable(edges))
