"""Certificates that we make: accepted, tight where they say so, and refused where they cannot be made."""

import hashlib
import io
import json
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any
from unittest.mock import patch

import families
import pytest
from constructions import HALL, point
from gmpy2 import mpq
from triples import BASES, base, triple_of

from exactmesh import check, cli
from exactmesh.certificate.files import certificate_text, pslg_bytes
from exactmesh.certificate.locate import faces_around
from exactmesh.certificate.make import _root_text, certificate_of
from exactmesh.certificate.part import check_part
from exactmesh.certificate.record import json_from_certificate
from exactmesh.claims.run import Run
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.predicates import orientation
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.planar.cycles import sides
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg

INPUTS = {name: pslg for name, pslg in (families.ALL_SMALL | families.SMALL_PSLGS | {"hall": HALL}).items()
          if len(pslg.vertices) <= 40}


@pytest.mark.parametrize("name", INPUTS)
@pytest.mark.parametrize("kind", ["nonproper", "classic"])
def test_a_certificate_is_accepted_and_bounds_the_degradation(name: str, kind: Kind) -> None:
    pslg = INPUTS[name]
    run = Run(pslg, "classic" if kind == "classic" else "repaired", kind)
    files = json_from_pslg(pslg).encode(), json_from_mesh(run.mesh).encode()
    text = certificate_text(*files, run.subdivision, run.mesh, run.verification)  # which checks it
    certificate = json.loads(text)
    assert run.verification.mesh_mfs is not None and run.verification.input_mfs is not None
    exact, bound = Fraction(run.verification.mesh_mfs.squared), Fraction(certificate["mfs_squared_at_least"])
    given = Fraction(run.verification.input_mfs.squared)
    assert Fraction(certificate["input_mfs_squared_at_most"]) == given
    # Exact, or at least the room that the repaired construction leaves around vertices of the input.
    assert bound == exact or Fraction(1, 36) * given <= bound < exact
    if kind == "nonproper":
        assert Fraction(certificate["degradation_at_most"]) <= Fraction(108, 5)


@pytest.mark.parametrize("pslg", [HALL, families.spike_room(9), families.SMALL_PSLGS["random pslg 3"]])
def test_proper_meshes_have_certificates(pslg: Pslg) -> None:
    files = triple_of(pslg, "proper").files()
    assert check.check(*map(io.BytesIO, files))[1].startswith("VALID proper mesh")


def test_the_rest_is_meshed_only_where_a_triangulation_leaves_too_little_room() -> None:
    assert len(base("square").certificate["vertices"]) == 4
    for name in ("growth, classic", "map 1, classic"):
        assert len(base(name).certificate["vertices"]) > 4


def test_a_rest_that_cannot_be_meshed_leaves_less_room_but_a_certificate() -> None:
    def fails(*args: object) -> None:
        raise ConstructionFailed("tube", None)

    run = _run(BASES["growth, classic"][0], "classic")
    with patch("exactmesh.certificate.make._meshed", fails):
        found = certificate_of(run.subdivision, run.mesh, run.verification, "", "")
    assert len(found.vertices) == 4
    assert Fraction(found.mfs_squared_at_least) < Fraction(base("growth, classic").certificate["mfs_squared_at_least"])


def test_a_size_that_the_outside_decides_is_met() -> None:
    # A hole that is 1/100 wide: the mfs is there, and the faces of the mesh have more.
    ring = families.ring([(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (4, Fraction(301, 100))])
    edges = (0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 4)
    certificate = triple_of(Pslg(ring.vertices, edges, (point(4, "1501/500"),)), "classic").certificate
    assert certificate["mfs_squared_at_least"] == certificate["input_mfs_squared_at_most"] == "1/10000"
    assert certificate["degradation_at_most"] == "1" and len(certificate["vertices"]) == 4


@pytest.mark.parametrize("name", BASES)
def test_the_text_is_stable_and_each_base_is_accepted(name: str) -> None:
    again = triple_of(*BASES[name])
    assert again.certificate == base(name).certificate
    assert check.check(*map(io.BytesIO, again.files()))[0]


def _run(pslg: Pslg, kind: Kind) -> Run:
    return Run(pslg, "classic" if kind == "classic" else "repaired", kind)


def test_internal_and_invalid_meshes_are_refused() -> None:
    square = BASES["square"][0]
    run = _run(square, "internal")
    with pytest.raises(InputError, match="internal"):
        certificate_of(run.subdivision, run.mesh, run.verification, "", "")
    good = _run(square, "classic")
    broken = replace(good.verification, violations=(*run.verification.violations, None))  # type: ignore[arg-type]
    with pytest.raises(InputError, match="not valid"):
        certificate_of(good.subdivision, good.mesh, broken, "", "")


def test_a_certificate_that_its_checker_refuses_is_never_handed_out() -> None:
    run = _run(BASES["square"][0], "classic")
    other = Mesh("classic", run.mesh.vertices, run.mesh.faces[:1])
    with pytest.raises(ConstructionFailed) as caught:
        certificate_text(json_from_pslg(run.pslg).encode(), json_from_mesh(other).encode(), run.subdivision, run.mesh,
                         run.verification)
    assert caught.value.step == "certificate" and str(caught.value.place).startswith("INVALID boundary")


@pytest.mark.parametrize("squared", [mpq(2), mpq(1), mpq(1, 3), mpq(10) ** 40 + 1, mpq(7, 10**31), mpq(100), mpq(99)])
def test_decimals_are_next_to_the_root_and_on_the_safe_side(squared: mpq) -> None:
    low, high = Fraction(_root_text(squared)), Fraction(_root_text(squared, up=True))
    exact = Fraction(squared)
    assert low**2 <= exact <= high**2
    assert low == high or (high - low) * 10**11 <= high
    assert (low == high) == (low**2 == exact)


def test_faces_around_agrees_with_trying_all() -> None:
    triple = base("ring with a hole")
    points = tuple(point(*at) for at in (*triple.mesh["vertices"], *triple.certificate["vertices"]))
    faces = tuple(map(tuple, triple.certificate["faces"]))
    wanted = [point(f"{x}/2", f"{y}/2") for x in range(-6, 24) for y in range(-6, 24)]
    found = faces_around(wanted, points, faces)
    for p, face in zip(wanted, found, strict=True):
        holding = [number for number, cycle in enumerate(faces) if all(
            orientation(points[u], points[v], p) >= 0 for u, v in sides(cycle))]
        assert face == (holding[0] if holding else -1)
    assert -1 in found and len(set(found)) > 5
    assert faces_around([], points, faces) == [] and faces_around(wanted[:1], points, ()) == [-1]


def test_no_hole_face_is_a_number_that_the_reader_refuses() -> None:
    certificate = base("ring with a hole").certificate
    assert certificate["hole_faces"] and min(certificate["hole_faces"]) >= 0
    assert set(certificate) == set(check.CERTIFICATE)


# --- a random part ---


@pytest.fixture
def on_disk(tmp_path: Path) -> Callable[[list[bytes]], list[str]]:
    """Return a function that writes three files and returns their paths."""
    def write(files: list[bytes]) -> list[str]:
        paths = [tmp_path / name for name in ("p.json", "m.json", "c.json")]
        for path, data in zip(paths, files, strict=True):
            path.write_bytes(data)
        return [str(path) for path in paths]
    return write


def test_a_random_part_without_fault_says_that_it_is_partial(on_disk: Any) -> None:
    for name in BASES:
        for chosen in (0, 1, 7, 10**6):
            valid, line = check_part(*on_disk(base(name).files()), chosen, 5)
            assert valid and line.startswith("PARTIAL no fault in") and "nothing is proved" in line


def test_a_random_part_of_all_faces_finds_local_faults(on_disk: Any) -> None:
    from harm import harmed

    kinds = {"face turned around": "face-shape", "face doubled": "overlap", "face dropped": "boundary",
             "edge of the input with one end": "", "hash changed": "hash", "truncated": "format",
             "bound doubled, degradation halved": "feature", "mesh scaled": "input-vertices",
             "vertex repeated in a face": "face-shape", "wrong type somewhere": ""}
    for kind, clause in kinds.items():
        for name in ("square", "ring with a hole", "map, classic"):
            files = harmed(name, kind, 1)
            assert files is not None
            valid, line = check_part(*on_disk(files), 10**6, 0)
            assert "\n" not in line
            if clause:
                assert not valid and line.startswith("INVALID") and clause in line, (kind, line)


def test_a_random_part_of_what_is_no_certificate_is_refused(on_disk: Any, tmp_path: Path) -> None:
    for junk in (b"", b"[]", b"{}", b"[" * 10**6, b'{"vertices": 5}', b"9" * 10**5, b"\xff"):
        valid, line = check_part(*on_disk([junk] * 3), 3, 0)
        assert not valid and line.startswith("INVALID")
    with pytest.raises(InputError, match="this is a directory"):
        check_part(str(tmp_path), str(tmp_path), str(tmp_path), 3, 0)


# --- the command line ---


Command = Callable[..., tuple[int, str, str]]


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Command:
    """Return a function that runs one command in an empty folder."""
    monkeypatch.chdir(tmp_path)

    def run(*args: str) -> tuple[int, str, str]:
        try:
            status = cli.main(args)
        except SystemExit as stop:
            status = int(stop.code or 0)
        captured = capsys.readouterr()
        return status, captured.out, captured.err
    return run


ROOM = "POLYGON((0 0, 9 0, 9 5, 5 5, 4 2, 3 5, 0 5, 0 0))"


def test_mesh_writes_a_certificate_that_check_accepts(command: Command) -> None:
    Path("in.json").write_text(json_from_pslg(HALL))
    assert command("mesh", "in.json", "-o", "m.json", "--certificate", "c.json", "--quiet")[0] == 0
    status, out, _ = command("check", "in.json", "m.json", "c.json")
    assert status == 0 and out.startswith("VALID nonproper mesh: mfs_squared >= ") and out.count("\n") == 1
    assert command("check", "m.json", "in.json", "c.json")[0] == 1
    status, out, _ = command("check", "in.json", "m.json", "c.json", "--random-part", "20", "--seed", "3")
    assert status == 0 and out.startswith("PARTIAL")
    status, out, _ = command("check", "in.json", "m.json", "c.json", "--max-digits", "1")
    assert status == 1 and out.startswith("INVALID size: PSLG")
    Path("m.json").write_text(Path("m.json").read_text().replace("31", "32", 1))
    for flags in ((), ("--random-part", "5")):
        status, out, _ = command("check", "in.json", "m.json", "c.json", *flags)
        assert (status, out) == (1, "INVALID hash: MESH\n")


def test_other_formats_and_boxes_need_the_input_written_for_the_checkers(command: Command) -> None:
    Path("room.wkt").write_text(ROOM)
    Path("in.json").write_text(json_from_pslg(HALL))
    Path("odd.json").write_text('{"format": "exactmesh-pslg/1", "edges": [[0, 1], [1, 2], [2, 0]], '
                                '"vertices": [[0, 0], [0.5, 0], [0, 1]]}')
    options = "-o", "m.json", "--certificate", "c.json", "--quiet"
    for args in (("room.wkt",), ("odd.json",), ("in.json", "--bounding-box", "1")):
        status, out, err = command("mesh", *args, *options)
        assert status == 2 and not out and "--pslg P" in err and err.count("\n") == 1
        assert not Path("m.json").exists() and not Path("c.json").exists()
        assert command("mesh", *args, *options, "--pslg", "p.json")[0] == 0
        assert command("check", "p.json", "m.json", "c.json")[0] == 0
        for path in ("m.json", "c.json", "p.json"):
            Path(path).unlink()


def test_certificates_that_cannot_be_are_refused_before_the_work(command: Command) -> None:
    Path("in.json").write_text(json_from_pslg(HALL))
    for args, word in (
            (("mesh", "in.json", "--certificate", "c.json"), "give -o"),
            (("mesh", "in.json", "-o", "m.json", "--certificate", "c.json", "--kind", "internal"), "internal"),
            (("mesh", "in.json", "-o", "x.json", "--certificate", "x.json"), "two results"),
            (("mesh", "-", "-o", "m.json", "--certificate", "c.json"), ""),
            (("check", "in.json", "in.json", "missing.json"), "missing.json"),
            (("check", "in.json", "in.json", "missing.json", "--random-part", "3"), "missing.json"),
            (("check", "in.json"), "required"), (("check", "a", "b", "c", "--random-part", "-1"), "nine digits")):
        status, out, err = command(*args)
        assert status == 2 and not out and word in err and "Traceback" not in err
    assert not list(Path().glob("[mcx].json"))


def test_the_bytes_that_are_hashed_are_those_that_were_read(tmp_path: Path) -> None:
    path = tmp_path / "in.json"
    data = json_from_pslg(HALL).encode()
    path.write_bytes(data)
    assert pslg_bytes(str(path), hashlib.sha256(data).hexdigest()) == data
    with pytest.raises(InputError, match="changed"):
        pslg_bytes(str(path), "0" * 64)
    with pytest.raises(InputError, match="this is a directory"):
        pslg_bytes(str(tmp_path), "")
    with pytest.raises(InputError, match="needs an input that is a file"):
        pslg_bytes("-", "")


def test_the_record_ends_with_a_line_feed_and_is_json() -> None:
    run = _run(BASES["square"][0], "classic")
    text = json_from_certificate(certificate_of(run.subdivision, run.mesh, run.verification, "a" * 64, "b" * 64))
    assert text.endswith("}\n") and json.loads(text)["mesh_sha256"] == "b" * 64


def test_verify_looks_at_a_certificate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pslg, mesh_file, certificate = (str(tmp_path / name) for name in ("p.json", "m.json", "c.json"))
    Path(pslg).write_text(json_from_pslg(families.ring([(0, 0), (4, 0), (4, 4), (0, 4)])))
    assert cli.main(["mesh", pslg, "-o", mesh_file, "--certificate", certificate, "--quiet"]) == 0
    files = ["verify", pslg, mesh_file, "--certificate", certificate]
    capsys.readouterr()
    assert cli.main([*files, "--random-part", "3", "--seed", "5"]) == 0
    assert capsys.readouterr().out.startswith("PARTIAL no fault in 3 of ")
    assert cli.main(files) == 0
    assert capsys.readouterr().out.startswith("VALID nonproper mesh")
    other = Path(mesh_file).read_text().replace("nonproper", "proper")
    Path(mesh_file).write_text(other)
    for more in ([], ["--random-part", "3"]):
        assert cli.main([*files, *more]) == 1
        assert capsys.readouterr().out == "INVALID hash: MESH\n"
    for wrong in (["--json"], ["--max-degradation", "3"], ["--bounding-box", "1"]):
        assert cli.main([*files, *wrong]) == 2 and "do not go with it" in capsys.readouterr().err
    assert cli.main(["verify", pslg, mesh_file, "--random-part", "3"]) == 2
    assert "give --certificate C" in capsys.readouterr().err
