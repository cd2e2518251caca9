"""`exactmesh-report/1`: what was checked in a run, as JSON and as text."""

import json
from collections.abc import Container, Iterable, Mapping, Sequence

from gmpy2 import mpq

from exactmesh.api import Meshing
from exactmesh.claims.claim import Claim, Judgement
from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import Verification
from exactmesh.measure.verdict import Verdict
from exactmesh.numbers.rational import sqrt_text, text_from_rational
from exactmesh.numbers.root import exact_text, number_text, root_expression, root_text
from exactmesh.planar.pslg import Pslg

_READABLE = 60


def report_json(pslg: Pslg, input_sha256: str, meshing: Meshing, mesh_sha256: str, construction: str) -> str:
    """Return the text of an `exactmesh-report/1` file; the hashes are those of the files' bytes."""
    mesh, verification = meshing.mesh, meshing.verification
    report = {
        "format": "exactmesh-report/1",
        "input": {"sha256": input_sha256, "vertices": len(pslg.vertices), "edges": len(pslg.edges)},
        "mesh": {"sha256": mesh_sha256, "kind": mesh.kind, "vertices": len(mesh.vertices),
                 "steiner": verification.steiner, "faces": verification.faces},
        "construction": construction,
        "mfs_squared": {
            "input": _squared(verification.input_mfs), "mesh": _squared(verification.mesh_mfs),
            "witness_input": _witness(verification.input_mfs), "witness_mesh": _witness(verification.mesh_mfs)},
        "degradation_squared": _text(verification.degradation_squared),
        **_internal(verification),
        "claims": [claim_json(judgement.claim, judgement.verdict) for judgement in meshing.judgements],
    }
    return json.dumps(report, indent=1) + "\n"


def size_json(name: str, nearest: Nearest | None) -> str:
    """Return what `exactmesh mfs --json` or `exactmesh ifs --json` prints; `name` is mfs or ifs."""
    decimal = None if nearest is None else sqrt_text(nearest.squared)
    return json.dumps({f"{name}_squared": _squared(nearest), "decimal": decimal, "witness": _witness(nearest)})


def verification_json(verification: Verification) -> str:
    """Return what `exactmesh verify --json` prints."""
    return json.dumps(verification_record(verification))


def verification_record(verification: Verification) -> dict[str, object]:
    """Return a verification as JSON can hold it."""
    return {
        "valid": verification.valid,
        "kind": verification.kind,
        "violations": [{"clause": v.clause, "place": dict(v.place)} for v in verification.violations],
        "mfs_squared": {"input": _squared(verification.input_mfs), "mesh": _squared(verification.mesh_mfs)},
        "degradation_squared": _text(verification.degradation_squared),
        **_internal(verification),
        "steiner": verification.steiner,
        "faces": verification.faces,
    }


def _internal(verification: Verification) -> dict[str, object]:
    """Return the fields that only internal meshes have."""
    if verification.kind != "internal":
        return {}
    return {"ifs_squared": {"input": _squared(verification.input_ifs), "mesh": _squared(verification.mesh_ifs)},
            "ifs_degradation_squared": _text(verification.ifs_degradation_squared)}


def size_text(name: str, nearest: Nearest | None) -> str:
    """Return a feature size, named mfs or ifs, and its witness in a line for reading."""
    if nearest is None:
        return f"{name}: none, there is no vertex with a feature that does not contain it"
    feature = f"vertex {nearest.feature[0]}" if nearest.is_vertex_pair else f"edge {nearest.feature}"
    return (f"{name} {sqrt_text(nearest.squared)}, squared exactly {_short(nearest.squared)}: "
            f"vertex {nearest.vertex} and {feature}")


def verification_text(verification: Verification) -> str:
    """Return the verdict on a mesh in a few lines for reading."""
    size = f"{verification.faces} faces, {verification.steiner} Steiner vertices"
    if not verification.valid:
        lines = [f"not a valid {verification.kind} mesh ({size}):"]
        lines += [f"  {v.clause}: {_place(v.place)}" for v in verification.violations[:20]]
        if (more := len(verification.violations) - 20) > 0:
            lines.append(f"  and {more} more")
        return "\n".join(lines)
    squared = verification.degradation_squared or mpq(0)
    internal = ""
    if (ifs_squared := verification.ifs_degradation_squared) is not None:
        internal = (f"ifs degradation {sqrt_text(ifs_squared)}, squared exactly {_short(ifs_squared)}\n"
                    f"input {size_text('ifs', verification.input_ifs)}\n"
                    f"mesh {size_text('ifs', verification.mesh_ifs)}\n")
    return (f"valid {verification.kind} mesh: {size}\n{internal}"
            f"degradation {sqrt_text(squared)}, squared exactly {_short(squared)}\n"
            f"input {size_text('mfs', verification.input_mfs)}\nmesh {size_text('mfs', verification.mesh_mfs)}")


def claims_text(judgements: Iterable[Judgement]) -> str:
    """Return a table of claims and verdicts for reading."""
    rows = [("claim", "bound", "worst", "instances", "")]
    rows += [(j.claim.id, j.claim.bound, _decimal(j.claim, j.verdict), str(j.verdict.instances),
              "holds" if j.verdict.holds else "FAILS") for j in judgements]
    return table(rows, right=(2, 3))


def table(rows: Sequence[Sequence[str]], right: Container[int]) -> str:
    """Return rows of cells in columns; those numbered in `right` are set flush right."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return "\n".join("  ".join(cell.rjust(width) if i in right else cell.ljust(width)
                               for i, (cell, width) in enumerate(zip(row, widths, strict=True))).rstrip()
                     for row in rows)


def failures_text(judgements: Iterable[Judgement]) -> str:
    """Return a line for each failing claim with its witness; empty when all hold."""
    lines = []
    for j in judgements:
        if not j.verdict.holds:
            witness = j.verdict.witness
            where = f": {witness.clause}: {_place(witness.place)}" if witness else ""
            lines.append(f"{j.claim.id} fails{where}")
    return "\n".join(lines)


def claim_json(claim: Claim, verdict: Verdict) -> dict[str, object]:
    """Return a claim with its verdict as it stands in a report."""
    worst = None
    if verdict.worst is not None:
        worst = {"exact": _exact(claim, verdict), "decimal": _decimal(claim, verdict)}
    witness = None if verdict.witness is None else {"clause": verdict.witness.clause, **verdict.witness.place}
    return {"id": claim.id, "paper": claim.paper, "statement": claim.says, "bound": claim.bound,
            "instances": verdict.instances, "holds": verdict.holds, "worst": worst, "witness": witness}


def _exact(claim: Claim, verdict: Verdict) -> str:
    worst = verdict.worst
    if worst is None:
        return ""
    if claim.quantity != "square":
        return exact_text(worst)
    return root_expression(worst) if worst >= 0 else f"-{root_expression(-worst)}"


def _decimal(claim: Claim, verdict: Verdict) -> str:
    worst = verdict.worst
    if worst is None:
        return ""
    if claim.quantity != "square":
        return number_text(worst)
    return root_text(worst) if worst >= 0 else f"-{root_text(-worst)}"


def _text(value: mpq | None) -> str | None:
    return None if value is None else text_from_rational(value)


def _squared(nearest: Nearest | None) -> str | None:
    return None if nearest is None else text_from_rational(nearest.squared)


def _witness(nearest: Nearest | None) -> dict[str, object] | None:
    if nearest is None:
        return None
    if nearest.is_vertex_pair:
        return {"vertex": nearest.vertex, "other": nearest.feature[0]}
    return {"vertex": nearest.vertex, "edge": list(nearest.feature)}


def _short(value: mpq) -> str:
    text = text_from_rational(value)
    return text if len(text) <= _READABLE else f"{text[:20]}... ({len(text)} characters, in full with --json)"


def _place(place: Mapping[str, object]) -> str:
    return ", ".join(f"{name} {value}" for name, value in place.items())
