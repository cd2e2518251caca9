"""Check the finished mesh: what the paper promises for every polygon, and what the repaired construction adds."""

from gmpy2 import mpq, mpz

from exactmesh.measure.validity import Verification
from exactmesh.measure.verdict import Tally, Verdict, failed
from exactmesh.steps.constants import (
    DESIGN_DEGRADATION,
    PAPER_DEGRADATION,
    PAPER_FEATURE,
    PROPER_FACTOR,
    PROPER_LOGARITHM,
    PROPER_VERTICES_PER_CORNER,
    VERTICES_PER_CORNER,
)

# log2 n is known to 2^-12: n^(2^12) has at most some ten thousand bits.
_LOG_BITS = 12


def check_valid(verification: Verification) -> Verdict:
    """Return whether the mesh is a valid one of its kind; one instance a face."""
    for violation in verification.violations:
        return failed(verification.faces, violation.clause, **violation.place)
    return Verdict(verification.faces, True)


def check_paper_degradation(verification: Verification) -> Verdict:
    """Return the verdict on the squared degradation against 45."""
    return _degradation(verification, Tally("degradation < 45", "<", PAPER_DEGRADATION**2))


def check_design_degradation(verification: Verification) -> Verdict:
    """Return the verdict on the squared degradation against 21.6."""
    return _degradation(verification, Tally("degradation <= 21.6", "<=", DESIGN_DEGRADATION**2))


def check_paper_feature(verification: Verification) -> Verdict:
    """Return the verdict on the squared mfs of the mesh, in units of the input's, against 0.022."""
    tally = Tally("mfs >= 0.022 mfs(P)", ">=", PAPER_FEATURE**2)
    degradation = verification.degradation_squared
    if degradation is None:
        return failed(1, "the mesh is valid", violations=len(verification.violations))
    tally.see(1 / degradation, **_place(verification))
    return tally.verdict()


def check_internal_degradation(verification: Verification) -> Verdict:
    """Return the verdict on the squared ifs degradation of an internal mesh against 45."""
    tally = Tally("ifs degradation < 45", "<", PAPER_DEGRADATION**2)
    nearest, degradation = verification.mesh_ifs, verification.ifs_degradation_squared
    if nearest is None or degradation is None:
        return failed(1, "the mesh is valid", violations=len(verification.violations))
    tally.see(degradation, vertex=nearest.vertex, edge=list(nearest.feature))
    return tally.verdict()


def check_proper_degradation(verification: Verification, corner_count: int) -> Verdict:
    """Return the verdict on the squared degradation of a proper mesh against max(21.6, 9 (1 + log2 n))."""
    bound = max(DESIGN_DEGRADATION, PROPER_FACTOR * (1 + _logarithm(corner_count)))
    return _degradation(verification, Tally("degradation <= max(21.6, 9 (1 + log2 n))", "<=", bound**2))


def check_proper_logarithm(verification: Verification, corner_count: int) -> Verdict:
    """Return the verdict on the squared degradation of a proper mesh against 22 (1 + log2 n)."""
    bound = PROPER_LOGARITHM * (1 + _logarithm(corner_count))
    return _degradation(verification, Tally("degradation <= 22 (1 + log2 n)", "<=", bound**2))


def _logarithm(n: int) -> mpq:
    """Return a rational less than 2^-12 below log2 n."""
    return mpq((mpz(n) ** (1 << _LOG_BITS)).bit_length() - 1, 1 << _LOG_BITS)


def check_vertex_count(verification: Verification, corner_count: int) -> Verdict:
    """Return the verdict on the number of Steiner vertices per corner of the input: 35, or 51 in a proper mesh."""
    limit = PROPER_VERTICES_PER_CORNER if verification.kind == "proper" else VERTICES_PER_CORNER
    tally = Tally(f"Steiner vertices <= {limit} a corner", "<=", mpq(limit))
    tally.see(mpq(verification.steiner, corner_count), steiner=verification.steiner, corners=corner_count)
    return tally.verdict()


def _degradation(verification: Verification, tally: Tally) -> Verdict:
    if verification.degradation_squared is None:
        return failed(1, "the mesh is valid", violations=len(verification.violations))
    tally.see(verification.degradation_squared, **_place(verification))
    return tally.verdict()


def _place(verification: Verification) -> dict[str, object]:
    nearest = verification.mesh_mfs
    if nearest is None:
        return {}
    if nearest.is_vertex_pair:
        return {"vertex": nearest.vertex, "other": nearest.feature[0]}
    return {"vertex": nearest.vertex, "edge": list(nearest.feature)}
