"""What there is to look at: a mesh with whatever is known of it."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from gmpy2 import mpq

from exactmesh.claims.ledger import judge
from exactmesh.claims.run import REPAIRED_STEPS, ConstructionName, Run, construction_for
from exactmesh.errors import InputError
from exactmesh.geometry.point import Point
from exactmesh.io.text import printable
from exactmesh.measure.foreign import graph_mfs, in_order, measure_foreign
from exactmesh.measure.mfs import Nearest
from exactmesh.measure.validity import Verification, verify_mesh
from exactmesh.planar.cycles import Cycle
from exactmesh.planar.faces import domain_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.report import claim_json
from exactmesh.viewer.marks import Places
from exactmesh.viewer.report_file import ReportFile
from exactmesh.viewer.stages import Stages, stages_of, whole

ClaimRecord = Mapping[str, object]
_VIOLATIONS = 100


@dataclass(frozen=True, slots=True)
class Subject:
    """A mesh; `claims` are as in a report, `places` tells where their witnesses are.

    `given` is the number of vertices that are the input's, None when nothing tells it. `mesh_mfs` is None when there is
    nothing to say of it: the mesh is not valid, or its edges cross.
    """

    title: str
    mesh: Mesh
    given: int | None
    input_mfs: Nearest | None
    mesh_mfs: Nearest | None
    degradation_squared: mpq | None
    claims: tuple[ClaimRecord, ...]
    places: Places
    stages: Stages


def subject_of_run(run: Run, title: str, with_steps: bool, with_claims: bool = True) -> Subject:
    """Return the mesh of a run, verified, with the verdicts on its claims; raises what the steps raise."""
    claims = tuple(claim_json(judgement.claim, judgement.verdict) for judgement in judge(run)) if with_claims else ()
    unit = run.repaired.shape.unit if run.construction in REPAIRED_STEPS else mpq(1)
    stages = stages_of(run) if with_steps else whole(run.pslg, run.mesh)
    return _of_verification(run.pslg, run.mesh, run.verification, claims, Places(run.mesh, run.pslg.edges, unit, run),
                            stages, title)


def subject_of_mesh(mesh: Mesh, pslg: Pslg | None, report: ReportFile | None, title: str) -> Subject:
    """Return a mesh: with its input it is verified, with a report it has that report's claims.

    Raises `InputError` when `pslg` is none or encloses nothing.
    """
    claims = report.claims if report is not None else ()
    unit = report.unit if report is not None else None
    if pslg is not None:
        verification = verify_mesh(domain_of(pslg), mesh)
        return _of_verification(pslg, mesh, verification, _verdicts(verification) + claims,
                                Places(mesh, pslg.edges, unit), whole(pslg, mesh), title)
    return Subject(title, mesh, report.given if report is not None else None,
                   report.input_mfs if report is not None else None, graph_mfs(mesh.vertices, mesh.faces).nearest,
                   report.degradation_squared if report is not None else None, claims, Places(mesh, (), unit),
                   whole(None, mesh))


def subject_of_foreign(vertices: Sequence[Point], faces: Sequence[Cycle], pslg: Pslg | None, title: str) -> Subject:
    """Return a mesh made elsewhere, its faces turned counter-clockwise; with its input it is verified.

    With the input, vertices are numbered as exactmesh does: the input's first, whatever the file's order. Raises
    `InputError` when `pslg` is none or encloses nothing.
    """
    if pslg is None:
        points, cycles, _ = in_order(Pslg((), ()), vertices, faces)
        return subject_of_mesh(Mesh("nonproper", points, cycles), None, None, title)
    measured = measure_foreign(domain_of(pslg), vertices, faces)
    verification = measured.verification
    return Subject(title, measured.mesh, len(pslg.vertices), verification.input_mfs, measured.graph.nearest,
                   measured.degradation_squared, _verdicts(verification), Places(measured.mesh, pslg.edges),
                   whole(pslg, measured.mesh))


def run_for(pslg: Pslg, mesh: Mesh, report: ReportFile | None, progress: Callable[[str], None]) -> Run:
    """Return the run that made a mesh; raises `InputError` when it makes another one of that input."""
    construction: ConstructionName = (report.construction if report is not None and report.construction else
                                      construction_for(mesh.kind))
    run = Run(pslg, construction, mesh.kind, progress=progress)
    if run.mesh != mesh:
        raise InputError(f"the {construction} construction makes another {mesh.kind} mesh of that input: there are no "
                         "steps to show")
    return run


def _of_verification(pslg: Pslg, mesh: Mesh, verification: Verification, claims: tuple[ClaimRecord, ...],
                     places: Places, stages: Stages, title: str) -> Subject:
    return Subject(title or printable(pslg.name), mesh, len(pslg.vertices), verification.input_mfs,
                   verification.mesh_mfs, verification.degradation_squared, claims, places, stages)


def _verdicts(verification: Verification) -> tuple[ClaimRecord, ...]:
    """Return the verification's verdict in the form of claims, one for each violated clause."""
    says = f"the mesh is a valid {verification.kind} mesh of the input"
    if verification.valid:
        return (_verdict("verification", says, verification.faces, True, None),)
    return tuple(_verdict(f"verification: {violation.clause}", says, verification.faces, False,
                          {"clause": violation.clause, **violation.place})
                 for violation in verification.violations[:_VIOLATIONS])


def _verdict(name: str, says: str, instances: int, holds: bool, witness: Mapping[str, object] | None) -> ClaimRecord:
    return {"id": name, "paper": "exactmesh verify", "statement": says, "bound": "", "instances": instances,
            "holds": holds, "worst": None, "witness": witness}

