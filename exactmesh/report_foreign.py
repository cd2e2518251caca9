"""Meshes from elsewhere and rounded files, as text and as JSON."""

import json

from exactmesh.measure.foreign import Foreign, Size
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import sqrt_text
from exactmesh.report import size_text, verification_record, verification_text


def rounded_text(count: int, before: Size, after: Size) -> str:
    """Return what rounding did to `count` vertices."""
    points = "1 point was" if count == 1 else f"{count} points were"
    return f"{points} rounded\nbefore: {_size(before)}\nafter: {_size(after)}"


def foreign_text(measured: Foreign, in_doubles: Foreign | None) -> str:
    """Return the measure of a mesh in a few lines for reading."""
    lines = [verification_text(measured.verification)]
    if not measured.verification.valid:
        lines.append(_graph(measured))
    if in_doubles is not None:
        lines.append("with the coordinates of both rounded to doubles: " + (
            "a valid mesh of the input" if in_doubles.verification.valid else "not a valid mesh of the input either"))
        lines += [verification_text(in_doubles.verification)] if in_doubles.verification.valid else []
    best = measured if in_doubles is None or not in_doubles.verification.valid else in_doubles
    lines.append(f"vertices added on edges of the input: {best.on_boundary}")
    return "\n".join(lines)


def foreign_json(measured: Foreign, in_doubles: Foreign | None) -> str:
    """Return what `exactmesh degradation --json` prints."""
    return json.dumps({**_record(measured), "in_doubles": None if in_doubles is None else _record(in_doubles)})


def _record(measured: Foreign) -> dict[str, object]:
    squared = measured.degradation_squared
    return {**verification_record(measured.verification),
            "graph": {"mfs_squared": _squared(measured.graph.nearest), "not_plane": measured.graph.crossing or None,
                      "degradation_squared": None if squared is None else str(squared)},
            "missing_vertices": list(measured.missing), "added_on_edges": measured.on_boundary}


def _graph(measured: Foreign) -> str:
    text = f"its edges: {_size(measured.graph)}"
    squared = measured.degradation_squared
    return text if squared is None else f"{text}\ndegradation, as far as there is one: {sqrt_text(squared)}"


def _size(size: Size) -> str:
    return f"no plane graph: {size.crossing}" if size.crossing else size_text("mfs", size.nearest)


def _squared(nearest: Nearest | None) -> str | None:
    return None if nearest is None else str(nearest.squared)
