"""What the viewer's page is given: exact numbers, and where things are, checked against the library and by hand."""

import json
import re
from collections.abc import Mapping
from typing import Any

import families
import pytest
from gmpy2 import mpq
from pages import L_SHAPE, grid_mesh

from exactmesh.api import meshing_of
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.errors import FormatError, InputError
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.strict_json import parse_json
from exactmesh.measure.face_feature import face_witness
from exactmesh.numbers.rational import rational_from_text
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg, polygon
from exactmesh.report import report_json
from exactmesh.viewer.document import document_of, json_text
from exactmesh.viewer.marks import Marks, Places
from exactmesh.viewer.page import viewer_page
from exactmesh.viewer.report_file import ReportFile, report_from_value
from exactmesh.viewer.stages import stages_of
from exactmesh.viewer.subject import run_for, subject_of_mesh, subject_of_run

INPUTS: list[tuple[Pslg, ConstructionName, Kind]] = [
    (L_SHAPE, "repaired", "nonproper"), (L_SHAPE, "paper", "nonproper"), (L_SHAPE, "paper", "proper"),
    (families.comb(5), "repaired", "nonproper"), (families.comb(5), "repaired", "proper"),
    (families.comb(5), "paper", "nonproper"), (families.nested_rings(3), "repaired", "nonproper"),
    (families.comb(4), "repaired", "internal"), (polygon([(0, 0), (5, 0), (2, 3)]), "repaired", "nonproper"),
    (L_SHAPE, "classic", "classic")]


@pytest.mark.parametrize("pslg, construction, kind", INPUTS)
def test_every_number_is_the_library_s(pslg: Pslg, construction: ConstructionName, kind: Kind) -> None:
    run = Run(pslg, construction, kind)
    document: dict[str, Any] = json.loads(json_text(document_of(subject_of_run(run, "t", True))))
    mesh, verification = run.mesh, run.verification
    count = len(mesh.vertices)
    assert [rational_from_text(x) for x in document["x"][:count]] == [p.x for p in mesh.vertices]
    assert [rational_from_text(y) for y in document["y"][:count]] == [p.y for p in mesh.vertices]
    assert [tuple(face) for face in document["faces"]] == list(mesh.faces) and document["kind"] == kind
    features = [face_witness(mesh.vertices, face).squared for face in mesh.faces]
    assert [rational_from_text(text) for text in document["features"]] == features
    ratios = [run.mfs.squared / squared for squared in features]
    assert document["shades"] == [next(k for k in range(7) if k == 6 or ratio <= 4**k) for ratio in ratios]
    assert rational_from_text(document["sizes"][0]["squared"]) == run.mfs.squared
    if verification.valid:
        assert rational_from_text(document["degradation"]["squared"]) == verification.degradation_squared
        assert rational_from_text(document["sizes"][1]["squared"]) == verification.mesh_mfs.squared
    assert (document["degradation"] is not None) == (len(document["sizes"]) == 2) == verification.valid
    assert document["given"] == len(pslg.vertices)
    assert [claim["id"] for claim in document["claims"]] == [j.claim.id for j in meshing_of(run).judgements]


@pytest.mark.parametrize("pslg, construction, kind", INPUTS)
def test_stages_build_the_mesh_and_speak_of_things_that_are_there(pslg: Pslg, construction: ConstructionName, kind: Kind
                                                                  ) -> None:
    run = Run(pslg, construction, kind)
    found = stages_of(run)
    count = len(run.mesh.vertices) + len(found.extra)
    for stage in found.stages:
        assert all(0 <= v < count for edge in stage.edges for v in edge)
        assert all(0 <= v < count for cycle in stage.cycles for v in cycle)
        assert all(0 <= v < count for arc in stage.arcs for v in arc)
    assert found.stages[0].name == "Input" and found.stages[0].edges == pslg.edges
    assert found.stages[-1].new == (range(len(run.mesh.faces)),)
    if len(found.stages) == 2:
        return
    made = found.stages[-2]
    bare = len(run.repaired.shape.triangles) if construction == "repaired" else 0
    faces = sorted(f for run_ in made.old + made.new for f in run_)
    assert faces == list(range(bare, len(run.mesh.faces)))  # each face once, but for bare triangles, which are no step
    seen: set[int] = set()
    for stage in found.stages[:-1]:
        assert {f for run_ in stage.old for f in run_} == seen & {f for run_ in stage.old for f in run_}
        new = {f for run_ in stage.new for f in run_}
        assert not new & seen
        seen |= new


def test_the_paper_s_curves_are_there_in_expressions_and_decimals() -> None:
    found = stages_of(Run(L_SHAPE, "paper"))
    p2, p3 = found.stages[1], found.stages[2]
    assert len(p2.edges) == 6 and len(p2.arcs) == 1 and len(p3.edges) == 8
    middle = [point for point in found.extra if "sqrt" in point.exact[0]]
    assert len(middle) == 1 and middle[0].near[0].startswith("1.8232233047033631188997")  # 2 - sqrt(2)/8
    centre, start, end = p2.arcs[0]
    assert centre == 3
    first = len(Run(L_SHAPE, "paper").mesh.vertices)
    assert {found.extra[v - first].exact for v in (start, end)} == {("2", "3/4"), ("7/4", "1")}


def test_t_vertices_and_faces_that_are_no_triangles() -> None:
    square = polygon([(0, 0), (2, 0), (2, 2), (0, 2)]).vertices
    middle = polygon([(1, 0), (1, 1), (0, 0)]).vertices[:2]
    mesh = Mesh("nonproper", square + middle, ((0, 4, 1, 5), (1, 2, 5), (2, 3, 5), (3, 0, 5)))
    document = document_of(subject_of_mesh(mesh, None, None, "t"))
    assert document["t_vertices"] == [4] and document["features"] == ["1/2", "1", "1", "1"]
    broken = Mesh("nonproper", square, ((0, 1, 2, 3),))
    document = document_of(subject_of_mesh(broken, polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), None, "t"))
    assert document["features"] == [None] and document["shades"] == [-1]
    claims: Any = document["claims"]
    assert [(claim["id"], claim["holds"]) for claim in claims] == [("verification: face-shape", False)]
    assert claims[0]["marks"]["cycles"] == ((0, 1, 2, 3),) and claims[0]["place"][0] == ["face", "0"]


def test_without_an_input_sizes_come_from_the_definition() -> None:
    mesh = grid_mesh(4)
    document: Any = document_of(subject_of_mesh(mesh, None, None, "t"))
    least = min(face_witness(mesh.vertices, face).squared for face in mesh.faces)
    assert [size["of"] for size in document["sizes"]] == ["mesh"] and document["given"] is None
    assert rational_from_text(document["sizes"][0]["squared"]) == least
    assert document["reference"] == "largest feature size of a face" and document["degradation"] is None


def test_nothing_in_the_data_ends_the_script_element() -> None:
    text = json_text({"a": "</script><!--", "b": ["\u2028", "<"]})
    assert "<" not in text and json.loads(text) == {"a": "</script><!--", "b": ["\u2028", "<"]}
    page = viewer_page(document_of(subject_of_mesh(grid_mesh(1), None, None, "{{scripts}} & {{data}}</title>")))
    assert "<title>{{scripts}} &amp; {{data}}&lt;/title&gt; - exactmesh</title>" in page
    assert re.findall(r"""(?:src|href|url)\s*[=(]\s*["']?[^"'\s)]+""", page) == []
    assert "default-src 'none'; connect-src 'none'" in page and "unsafe" not in page


# --- marks ---

@pytest.mark.parametrize("pslg, construction, kind", INPUTS[:8])
def test_places_of_claims_are_found(pslg: Pslg, construction: ConstructionName, kind: Kind) -> None:
    subject = subject_of_run(Run(pslg, construction, kind), "t", True)
    told = ("vertex", "vertices", "other", "edge", "edge_of_q", "edge_of_p4", "vertex_of_q", "vertex_of_p4", "face",
            "trapezoid", "rectangle", "ring", "at")
    located = 0
    for claim in subject.claims:
        witness = claim["witness"]
        if isinstance(witness, Mapping) and any(name in witness for name in told):
            marks = subject.places.marks(witness)
            assert marks != Marks(), (claim["id"], witness)
            located += 1
            _agree(subject.mesh, marks, witness)
    assert located >= 2


def _agree(mesh: Mesh, marks: Marks, witness: Mapping[str, object]) -> None:
    """A point in a witness is one of the vertices in it, where it names any of these."""
    exact = re.fullmatch(r"\(-?\d+(/\d+)?, -?\d+(/\d+)?\)", str(witness.get("at", "")))
    names = {"vertices", "vertex_of_q", "vertex_of_p4", "edge_of_p4"} & set(witness)
    if exact and names:
        vertices = set(marks.vertices) | {v for edge in marks.edges for v in edge}
        assert set(marks.points) & {mesh.vertices[v] for v in vertices}, witness


def test_marks_from_a_report_alone_and_from_nonsense() -> None:
    mesh = Run(L_SHAPE).mesh
    places = Places(mesh, L_SHAPE.edges, mpq(2))
    assert places.marks({"vertex": 3, "edge": [1, 2]}) == Marks((3,), ((1, 2),))
    assert places.marks({"edge": 5}) == Marks(edges=((5, 0),))
    assert places.marks({"at": "(1/2, -3)"}).points == (polygon([(1, -6), (0, 0), (1, 0)]).vertices[0],)
    assert places.marks({"face": 0}) == Marks(cycles=(mesh.faces[0],))
    assert places.marks({"face": [1, 2, 3], "edge": ["(0, 1)", "(1, 0)"]}) == Marks(
        cycles=((1, 2, 3),), points=polygon([(0, 2), (2, 0), (1, 1)]).vertices[:2])
    nonsense: list[object] = [10**9, -1, True, None, "x", [1, "y"], [[1]], {"a": 1}, "(1, )", "(1/0, 2)", [1.5]]
    for name in ("vertex", "edge", "face", "edge_of_q", "trapezoid", "vertex_of_q", "rectangle", "ring", "at", "e"):
        for value in nonsense:
            assert places.marks({name: value}) == Marks(), (name, value)


# --- reports ---

def report_text(pslg: Pslg, construction: ConstructionName = "repaired") -> str:
    run = Run(pslg, construction)
    return report_json(pslg, "0" * 64, meshing_of(run), "1" * 64, construction)


def read(text: str) -> ReportFile:
    return report_from_value(parse_json(text))


def test_a_report_tells_what_it_was_made_of() -> None:
    run = Run(L_SHAPE)
    found = read(report_text(L_SHAPE))
    assert (found.mesh_sha256, found.construction, found.given) == ("1" * 64, "repaired", 6)
    assert found.input_mfs == run.mfs and found.unit == run.repaired.shape.unit
    assert found.degradation_squared == run.verification.degradation_squared
    assert [claim["id"] for claim in found.claims] == [judgement.claim.id for judgement in meshing_of(run).judgements]
    assert read(report_text(L_SHAPE, "paper")).unit == 1
    from_report = subject_of_mesh(run.mesh, None, found, "t")
    from_run = subject_of_run(run, "t", True)
    for claim in found.claims:
        witness = claim["witness"]
        if isinstance(witness, Mapping) and set(witness) & {"at", "vertex"}:
            one, other = from_report.places.marks(witness), from_run.places.marks(witness)
            assert one.points == other.points and one.vertices == other.vertices and one != Marks()


@pytest.mark.parametrize("path, value, message", [
    (("format",), "exactmesh-mesh/1", "an object of format 'exactmesh-report/1' is expected, not an object"),
    (("claims",), {}, "claims: a value of type list is expected"),
    (("claims", 2, "holds"), 1, "claims[2].holds: a value of type bool is expected"),
    (("claims", 2, "instances"), True, "claims[2].instances: a value of type int is expected"),
    (("claims", 1), 7, "claims[1]: an object is expected"),
    (("claims", 1, "worst"), "7", "claims[1].worst: a value of type dict is expected"),
    (("claims", 1, "worst", "exact"), 7, "claims[1].worst.exact: a value of type str is expected"),
    (("input", "vertices"), "6", "input.vertices: a value of type int is expected"),
    (("mesh", "sha256"), None, "mesh.sha256: a value of type str is expected"),
    (("mfs_squared", "input"), "x", "mfs_squared.input: 'x' is not an integer, a finite decimal or a fraction p/q"),
    (("mfs_squared", "input"), 1, "mfs_squared.input: a string with a rational number is expected"),
    (("mfs_squared", "witness_input"), {"vertex": 99999, "edge": [0, 1]},
     "mfs_squared.witness_input: a vertex and an edge, or another vertex, is expected"),
    (("mfs_squared", "witness_input"), {"vertex": 1},
     "mfs_squared.witness_input: a vertex and an edge, or another vertex, is expected")])
def test_a_report_with_a_fault_is_refused_by_place(path: tuple[str | int, ...], value: object, message: str) -> None:
    report = json.loads(report_text(L_SHAPE))
    inner = report
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    with pytest.raises(FormatError) as caught:
        read(json.dumps(report))
    assert str(caught.value) == message


def test_steps_are_shown_of_the_mesh_that_they_make_only() -> None:
    run = Run(L_SHAPE)
    assert run_for(L_SHAPE, run.mesh, None, lambda step: None).mesh == run.mesh
    assert run_for(L_SHAPE, Run(L_SHAPE, "paper").mesh, read(report_text(L_SHAPE, "paper")), lambda step: None
                   ).construction == "paper"
    other = Mesh("nonproper", run.mesh.vertices, run.mesh.faces[::-1])
    with pytest.raises(InputError, match="the repaired construction makes another nonproper mesh of that input"):
        run_for(L_SHAPE, other, None, lambda step: None)
    assert json_from_mesh(other) != json_from_mesh(run.mesh)
