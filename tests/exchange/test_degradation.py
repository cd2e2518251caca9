"""`exactmesh degradation` and `exactmesh convert`, on meshes by a real mesher and on harmed ones."""

import json
from pathlib import Path

import meshio
import numpy
import pytest
import triangle
from gmpy2 import mpq

from exactmesh import cli
from exactmesh.api import mesh
from exactmesh.geometry.point import Point
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.measure.foreign import measure_foreign
from exactmesh.planar.faces import domain_of
from exactmesh.planar.pslg import Pslg, polygon

LONG = polygon([(0, 0), (16, 0), (16, 1), (8, 1), (0, 1)])
SIXTHS = polygon([(0, 0), (1, 0), ("1/3", "1/3"), (0, 1)])


def by_triangle(pslg: Pslg, switches: str) -> tuple[list[Point], list[tuple[int, ...]]]:
    made = triangle.triangulate({"vertices": [[float(p.x), float(p.y)] for p in pslg.vertices],
                                 "segments": [list(edge) for edge in pslg.edges]}, switches)
    points = [Point(*(mpq(*float(value).as_integer_ratio()) for value in row)) for row in made["vertices"]]
    return points, [tuple(map(int, row)) for row in made["triangles"]]


@pytest.mark.parametrize("switches, kind", [("p", "classic"), ("pq30", "internal"), ("pYYq20", "proper")])
def test_a_real_mesher(switches: str, kind: str) -> None:
    points, faces = by_triangle(LONG, switches)
    shuffled = numpy.random.default_rng(3).permutation(len(points))
    place = {int(v): i for i, v in enumerate(shuffled)}
    measured = measure_foreign(domain_of(LONG), [points[v] for v in shuffled],
                               [tuple(place[v] for v in face)[::-1] for face in faces])
    assert measured.mesh.kind in (kind, "classic") and measured.missing == ()
    if measured.verification.valid:
        assert measured.graph.nearest and measured.degradation_squared
        assert measured.degradation_squared == measured.verification.degradation_squared >= 1
    if kind == "classic":
        # The midway vertex sees the opposite side at distance 1, a diagonal no nearer than a fraction.
        assert measured.verification.valid and measured.on_boundary == 0
    if kind == "internal":
        assert measured.on_boundary > 0


def test_what_is_no_mesh_of_the_input() -> None:
    good = mesh(LONG, kind="proper").mesh
    domain = domain_of(LONG)
    whole = measure_foreign(domain, good.vertices, good.faces)
    assert whole.verification.valid and whole.graph.nearest == whole.verification.mesh_mfs
    holed = measure_foreign(domain, good.vertices, good.faces[:-1])
    assert not holed.verification.valid and holed.graph.nearest is not None
    doubled = measure_foreign(domain, good.vertices, (*good.faces, good.faces[0]))
    assert not doubled.verification.valid
    moved = list(good.vertices)
    moved[1] = Point(mpq(3), mpq(5))
    crossed = measure_foreign(domain, moved, good.faces)
    assert 1 in crossed.missing and crossed.graph.nearest is None and crossed.graph.crossing
    assert crossed.degradation_squared is None


def write(folder: Path, pslg: Pslg) -> str:
    path = folder / "input.json"
    path.write_text(json_from_pslg(pslg))
    return str(path)


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = write(tmp_path, LONG)
    points, faces = by_triangle(LONG, "p")
    meshio.write(tmp_path / "t.msh", meshio.Mesh([(float(p.x), float(p.y), 0) for p in points],
                                                 [("triangle", faces)]))
    assert cli.main(["degradation", source, str(tmp_path / "t.msh"), "--quiet"]) == 0
    out = capsys.readouterr().out
    assert out.startswith("valid classic mesh: 3 faces") and out.endswith("vertices added on edges of the input: 0\n")
    assert cli.main(["degradation", source, str(tmp_path / "t.msh"), "--json", "--quiet"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["valid"] and record["in_doubles"] is None and record["added_on_edges"] == 0
    assert record["graph"]["degradation_squared"] == record["degradation_squared"]


def test_coordinates_that_are_no_doubles(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = write(tmp_path, SIXTHS)
    (tmp_path / "m.json").write_text(json_from_mesh(mesh(SIXTHS, kind="proper").mesh))
    assert cli.main(["convert", "--mesh", str(tmp_path / "m.json"), "-o", str(tmp_path / "m.vtu"), "--quiet"]) == 0
    capsys.readouterr()
    status = cli.main(["degradation", source, str(tmp_path / "m.vtu"), "--json", "--quiet"])
    record = json.loads(capsys.readouterr().out)
    assert not record["valid"] and 2 in record["missing_vertices"]
    assert record["in_doubles"]["valid"] == (status == 0)


def test_convert_says_what_rounding_does(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = write(tmp_path, SIXTHS)
    assert cli.main(["convert", source, "-o", str(tmp_path / "out.wkt"), "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    assert cli.main(["convert", source, "-o", str(tmp_path / "out.wkt")]) == 0
    out = capsys.readouterr().out.splitlines()
    assert out[0] == "1 point was rounded"
    assert out[1].startswith("before: mfs 0.") and out[2].startswith("after: mfs 0.")
    assert (tmp_path / "out.wkt").read_text().startswith("POLYGON ((")
    assert cli.main(["convert", source, "--to", "dxf", "-o", "-"]) == 0
    streams = capsys.readouterr()
    assert "SECTION" in streams.out and "rounded" in streams.err
    assert cli.main(["convert", source, "-o", str(tmp_path / "out.poly"), "--pslg", source]) == 2
    assert "--pslg is for --mesh" in capsys.readouterr().err
    assert cli.main(["convert", source, "-o", str(tmp_path / "out.exe")]) == 2
    assert not (tmp_path / "out.exe").exists()


def test_two_files_for_triangle(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = write(tmp_path, LONG)
    (tmp_path / "m.json").write_text(json_from_mesh(mesh(LONG, kind="proper").mesh))
    assert cli.main(["convert", "--mesh", str(tmp_path / "m.json"), "-o", str(tmp_path / "m.1.ele")]) == 0
    assert (tmp_path / "m.1.node").exists()
    capsys.readouterr()
    cli.main(["degradation", source, str(tmp_path / "m.1.ele"), "--json", "--quiet"])
    assert json.loads(capsys.readouterr().out)["missing_vertices"] == []


def test_files_that_triangle_itself_reads(tmp_path: Path) -> None:
    source = write(tmp_path, LONG)
    (tmp_path / "m.json").write_text(json_from_mesh(mesh(LONG, kind="proper").mesh))
    for arguments in ([source, "-o", str(tmp_path / "long.poly")],
                      ["--mesh", str(tmp_path / "m.json"), "-o", str(tmp_path / "long.1.ele")]):
        assert cli.main(["convert", *arguments, "--quiet"]) == 0
    graph = triangle.loads(poly=(tmp_path / "long.poly").read_text())
    assert {tuple(row) for row in graph["vertices"].tolist()} == {(float(p.x), float(p.y)) for p in LONG.vertices}
    assert {frozenset(row) for row in graph["segments"].tolist()} == {frozenset(edge) for edge in LONG.edges}
    read = triangle.loads(node=(tmp_path / "long.1.node").read_text(), ele=(tmp_path / "long.1.ele").read_text())
    faces = mesh(LONG, kind="proper").mesh.faces
    assert [tuple(row) for row in read["triangles"].tolist()] == list(faces)
