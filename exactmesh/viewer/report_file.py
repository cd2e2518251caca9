"""Read an `exactmesh-report/1` as far as the viewer shows it. It is shown, not believed: `mesh` and `verify` decide."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TypeVar, get_args

from gmpy2 import mpq

from exactmesh.claims.run import REPAIRED_STEPS, ConstructionName
from exactmesh.errors import FormatError
from exactmesh.io.read import blaming, bytes_at
from exactmesh.io.strict_json import Json, Number, described, parse_json
from exactmesh.io.text import text_from_bytes
from exactmesh.measure.mfs import Nearest
from exactmesh.numbers.rational import rational_from_text

FORMAT = "exactmesh-report/1"
T = TypeVar("T")
_INTEGER = re.compile(r"-?\d{1,18}", re.ASCII)


@dataclass(frozen=True, slots=True)
class ReportFile:
    """What a report says; `unit` is that of points in the witnesses, None when the report does not tell it."""

    mesh_sha256: str
    construction: ConstructionName | None
    given: int
    input_mfs: Nearest | None
    degradation_squared: mpq | None
    claims: tuple[Mapping[str, object], ...]
    unit: mpq | None


def read_report(path: str) -> ReportFile:
    """Return the report in a file, `-` for standard input; raises `InputError`, which begins with the path."""
    with blaming(path):
        return report_from_value(parse_json(text_from_bytes(bytes_at(path))))


def report_from_value(value: Json) -> ReportFile:
    """Return the report of a parsed file; raises `FormatError` naming the place, such as `claims[3].holds`."""
    if not isinstance(value, dict) or value.get("format") != FORMAT:
        raise FormatError("", f"an object of format {FORMAT!r} is expected, not {described(value)}")
    report = {name: _plain(item) for name, item in value.items()}
    mesh, sizes = _field(report, "mesh", dict), _field(report, "mfs_squared", dict)
    named = _field(report, "construction", str)
    construction = next((name for name in get_args(ConstructionName) if name == named), None)
    claims = tuple(_claim(claim, f"claims[{i}]") for i, claim in enumerate(_field(report, "claims", list)))
    given = _field(_field(report, "input", dict), "vertices", int, "input.")
    return ReportFile(
        _field(mesh, "sha256", str, "mesh."), construction, given,
        _nearest(sizes, _field(mesh, "vertices", int, "mesh.")),
        _rational(report.get("degradation_squared"), "degradation_squared"), claims, _unit(construction, claims))


def _plain(value: Json) -> object:
    """Return a JSON value with whole numbers as integers and other numbers as their texts."""
    match value:
        case Number(text):
            return int(text) if _INTEGER.fullmatch(text) else text
        case list():
            return [_plain(item) for item in value]
        case dict():
            return {name: _plain(item) for name, item in value.items()}
    return value


def _field(value: Mapping[str, object], name: str, kind: type[T], place: str = "") -> T:
    found = value.get(name)
    # A truth value is an integer to Python.
    if not isinstance(found, kind) or (kind is int and isinstance(found, bool)):
        raise FormatError(f"{place}{name}", f"a value of type {kind.__name__} is expected")
    return found


def _claim(value: object, place: str) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise FormatError(place, "an object is expected")
    for name in ("id", "paper", "statement", "bound"):
        _field(value, name, str, f"{place}.")
    _field(value, "instances", int, f"{place}.")
    _field(value, "holds", bool, f"{place}.")
    for name in ("worst", "witness"):
        if value.get(name) is not None:
            _field(value, name, dict, f"{place}.")
    if worst := value.get("worst"):
        for name in ("exact", "decimal"):
            _field(worst, name, str, f"{place}.worst.")
    return value


def _nearest(sizes: Mapping[str, object], count: int) -> Nearest | None:
    """Return the input's feature size with its witness, by vertices that a mesh of `count` vertices has."""
    squared = _rational(sizes.get("input"), "mfs_squared.input")
    if squared is None:
        return None
    witness = _field(sizes, "witness_input", dict, "mfs_squared.")
    vertex = witness.get("vertex")
    other = witness.get("other")
    feature = witness.get("edge", [other, other])
    numbers = [vertex, *feature] if isinstance(feature, list) else []
    inside = [v for v in numbers if isinstance(v, int) and 0 <= v < count]
    if len(numbers) != 3 or len(inside) != 3:
        raise FormatError("mfs_squared.witness_input", "a vertex and an edge, or another vertex, is expected")
    return Nearest(squared, inside[0], (inside[1], inside[2]))


def _rational(value: object, place: str) -> mpq | None:
    if value is None:
        return None
    if not isinstance(value, str):
        raise FormatError(place, "a string with a rational number is expected")
    return rational_from_text(value, place)


def _unit(construction: ConstructionName | None, claims: tuple[Mapping[str, object], ...]) -> mpq | None:
    """Return the unit of points in witnesses: the repaired construction's is in the witness of its first claim."""
    if construction not in REPAIRED_STEPS:
        return mpq(1)
    for claim in claims:
        witness = claim.get("witness")
        if claim["id"] == f"{construction}.unit" and isinstance(witness, dict) and isinstance(witness.get("unit"), str):
            return rational_from_text(witness["unit"], f"claims: {construction}.unit: witness.unit")
    return None
