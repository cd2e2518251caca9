"""Table 1, reproduced: rows of small sizes, verdicts that can fail, what is written, and the command."""

import csv
import io
import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import oracle
import pytest
from gmpy2 import mpq

from exactmesh import cli
from exactmesh.claims.run import Run
from exactmesh.commands import exit_status, reproduce
from exactmesh.measure.ifs import mesh_ifs
from exactmesh.measure.mfs import Nearest
from exactmesh.reproduce.families import FAMILIES
from exactmesh.reproduce.growth import fit, laws
from exactmesh.reproduce.plot import Panel, Series, svg_of
from exactmesh.reproduce.table1 import MADE, MAX_OPTIMAL, Made, Row, check, clause, table1_rows
from exactmesh.reproduce.text import table1_csv, table1_json, table1_svg, table1_text
from exactmesh.steps.shape import shape_of

REGULAR, RECTANGLE, FLOOR, COMB = FAMILIES
TINY = tuple(replace(family, short=sizes, more=()) for family, sizes in (
    (REGULAR, (4, 8, 12)), (RECTANGLE, (4, 10, 100)), (FLOOR, (3, 8, 16)), (COMB, (1, 4, 8))))
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture(scope="module")
def tiny() -> list[Row]:
    return list(table1_rows(families=TINY))


def row_of(rows: list[Row], family: str, size: int, made: Made) -> Row:
    (found,) = (row for row in rows if (row.family.name, row.size, row.made) == (family, size, made))
    return found


def harmed(row: Row, degradation_squared: mpq | None) -> Row:
    """Return the row as if its mesh had this degradation; None for a mesh that is not valid."""
    found = row.verification
    size = "ifs" if row.measure == "ifs" else "mfs"
    given = found.input_ifs if size == "ifs" else found.input_mfs
    assert given is not None
    mesh = None if degradation_squared is None else Nearest(given.squared / degradation_squared, 0, (1, 2))
    verification = replace(found, mesh_ifs=mesh) if size == "ifs" else replace(found, mesh_mfs=mesh)
    return replace(row, verification=verification)


# --- rows ---


def test_there_is_a_row_for_every_input_and_kind(tiny: list[Row]) -> None:
    assert [(row.family.name, row.size, row.made) for row in tiny] == [
        (family.name, size, made) for family in TINY for size in family.short for made in MADE]
    assert all(row.verification.valid for row in tiny)
    assert {(row.made, row.verification.kind) for row in tiny} == {
        ("classic", "classic"), ("optimal", "classic"), ("nonproper", "nonproper"), ("proper", "proper"),
        ("internal", "internal")}


@pytest.mark.parametrize("r", [3, 4, 10, 1000, 10**6])
def test_the_best_classic_mesh_of_a_rectangle(r: int) -> None:
    (row,) = table1_rows(("optimal",), families=(replace(RECTANGLE, short=(r,), more=()),))
    assert row.degradation_squared == mpq(r + 1, 2) ** 2 + 1 and row.verification.steiner == 0


@pytest.mark.parametrize("k", range(1, 13))
def test_the_best_classic_mesh_of_a_floor(k: int) -> None:
    (row,) = table1_rows(("optimal",), families=(replace(FLOOR, short=(k,), more=()),))
    assert row.degradation_squared == ((k + 2) // 2) ** 2 + 1


@pytest.mark.parametrize("n", [4, 5, 6, 7, 11, 32, 63])
def test_every_classic_mesh_of_a_regular_polygon_degrades_alike(n: int) -> None:
    assert REGULAR.optimum is not None
    low, high = REGULAR.optimum(n)
    for row in table1_rows(("classic", "optimal"), families=(replace(REGULAR, short=(n,), more=()),)):
        assert row.degradation_squared is not None
        assert low <= row.degradation_squared <= high < low * (1 + mpq(1, 10**8))


def test_exact_values_of_small_rows(tiny: list[Row]) -> None:
    # 5/g on all that needs a nested apex, and what the layers keep on the rectangle.
    assert row_of(tiny, "regular", 4, "classic").degradation_squared == 2
    assert row_of(tiny, "comb", 4, "optimal").degradation_squared == mpq(37, 4)
    for family, size in (("rectangle", 100), ("floor", 16), ("comb", 8)):
        assert row_of(tiny, family, size, "nonproper").degradation_squared == mpq(625, 29) ** 2


@pytest.mark.parametrize("made", ["classic", "nonproper", "proper"])
def test_the_oracle_agrees_on_the_degradation(tiny: list[Row], made: Made) -> None:
    for family in TINY:
        size = family.short[1]
        pslg = family.make(size)
        mesh = Run(pslg, "classic" if made == "classic" else "repaired", made).mesh
        squared = oracle.exact(oracle.degradation_squared(pslg.vertices, pslg.edges, mesh.vertices, mesh.faces))
        assert squared == row_of(tiny, family.name, size, made).degradation_squared


def test_on_the_convex_families_classic_meshes_degrade_the_ifs_as_much_as_the_mfs(tiny: list[Row]) -> None:
    for family in TINY[:3]:
        for size in family.short:
            mesh = Run(family.make(size), "classic", "classic").mesh
            inside, found = mesh_ifs(mesh), row_of(tiny, family.name, size, "classic").verification
            assert inside is not None and found.mesh_mfs is not None and inside.squared == found.mesh_mfs.squared


def test_a_corner_for_every_vertex() -> None:
    # The bound on proper meshes is in the number of corners; the row takes that of vertices.
    for family in TINY:
        run = Run(family.make(8))
        assert shape_of(run.subdivision, run.mfs.squared).corner_count == len(run.pslg.vertices)


def test_the_best_classic_mesh_is_left_out_of_large_inputs() -> None:
    families = (replace(FLOOR, short=(MAX_OPTIMAL - 4, MAX_OPTIMAL - 3), more=()),)
    told: list[str] = []
    assert [row.size for row in table1_rows(("optimal",), False, told.append, families)] == [MAX_OPTIMAL - 4]
    assert told == [f"floor k = {MAX_OPTIMAL - 4}, optimal"]


def test_short_means_fewer_sizes() -> None:
    family = replace(RECTANGLE, short=(4,), more=(10,))
    assert [row.size for row in table1_rows(("classic",), True, families=(family,))] == [4]
    assert [row.size for row in table1_rows(("classic",), False, families=(family,))] == [4, 10]


# --- verdicts ---


def test_every_row_holds_and_only_the_comb_is_left_unjudged(tiny: list[Row]) -> None:
    for row in tiny:
        verdict = check(row)
        if row.family.name == "comb" and row.made in ("classic", "optimal"):
            assert verdict is None and clause(row.family, row.made) == ""
        else:
            assert verdict is not None and verdict.holds and verdict.instances == 1
            assert clause(row.family, row.made)


@pytest.mark.parametrize("made, family, size, kept, broken", [
    ("nonproper", "comb", 4, mpq(108, 5) ** 2, mpq(108, 5) ** 2 + mpq(1, 10**30)),
    ("internal", "comb", 4, mpq(45) ** 2 - mpq(1, 10**30), mpq(45) ** 2),
    ("proper", "regular", 8, mpq(36) ** 2, mpq(36) ** 2 + mpq(1, 10**30)),
    ("proper", "regular", 4, mpq(27) ** 2, mpq(27) ** 2 + mpq(1, 10**30)),
    ("classic", "rectangle", 100, mpq(10**9), mpq(101, 2) ** 2 + 1 - mpq(1, 10**30)),
    ("optimal", "rectangle", 100, mpq(101, 2) ** 2 + 1, mpq(101, 2) ** 2 + 1 + mpq(1, 10**30)),
    ("optimal", "floor", 8, mpq(26), mpq(26) - mpq(1, 10**30)),
    ("classic", "regular", 12, mpq(10**9), mpq(149, 10)),
    ("optimal", "regular", 12, mpq(149282032302755, 10**13), mpq(14929, 1000)),
])
def test_a_verdict_fails_just_beyond_its_bound(tiny: list[Row], made: Made, family: str, size: int, kept: mpq,
                                               broken: mpq) -> None:
    row = row_of(tiny, family, size, made)
    for squared, holds in ((kept, True), (broken, False)):
        verdict = check(harmed(row, squared))
        assert verdict is not None and verdict.holds is holds and verdict.witness is not None


@pytest.mark.parametrize("made", MADE)
def test_a_mesh_that_is_not_valid_fails(tiny: list[Row], made: Made) -> None:
    rows = [harmed(row_of(tiny, family.name, family.short[0], made), None) for family in TINY]
    for law in laws(rows):
        assert law.holds is False and law.greatest is None and len(law.failures) == 1
        assert "the mesh is valid" in law.failures[0]
    assert "invalid" in table1_text(rows, laws(rows)) and "FAILS" in table1_text(rows, laws(rows))
    assert ElementTree.fromstring(table1_svg(rows)) is not None


def test_one_broken_row_breaks_its_law_alone(tiny: list[Row]) -> None:
    rows = [harmed(row, mpq(10**4)) if (row.family.name, row.size, row.made) == ("comb", 4, "internal") else row
            for row in tiny]
    broken = [law for law in laws(rows) if law.holds is False]
    assert [(law.family.name, law.made, law.rows) for law in broken] == [("comb", "internal", 3)]
    assert broken[0].failures == ("comb k = 4, internal: ifs degradation < 45",)
    assert broken[0].greatest == 10**4


# --- fits ---


def test_fits_find_the_laws_that_are_put_in() -> None:
    places = [4, 8, 16, 32, 64, 128]
    assert fit("classic", "n", [(x, 3.0 * x) for x in places]) == "n^1.000"
    assert fit("optimal", "r", [(x, 3.0 * x**0.5) for x in places]) == "r^0.500"
    # Only the larger half counts: 32, 64, 128.
    proper = [(x, 9.0 if x < 32 else 7.0 + 5 * (x.bit_length() - 1)) for x in places]
    assert fit("proper", "n", proper) == "+5.00 log2 n"
    assert fit("internal", "n", [(x, 21.0) for x in places]) == "x 1.000 at the last step"
    assert fit("nonproper", "n", [(4, 2.0), (8, 3.0)]) == "x 1.500 at the last step"


@pytest.mark.parametrize("points", [[], [(4, 2.0)], [(6, 2.0), (6, 3.0)]])
def test_there_is_no_fit_without_two_places(points: Any) -> None:
    assert [fit(made, "n", points) for made in MADE] == [""] * 5


# --- what is written ---


def test_the_csv_is_exact_and_complete(tiny: list[Row]) -> None:
    records = list(csv.DictReader(io.StringIO(table1_csv(tiny))))
    assert len(records) == len(tiny)
    for record, row in zip(records, tiny, strict=True):
        assert None not in record and None not in record.values()
        assert (record["family"], int(record["value"]), int(record["n"]), record["kind"], record["measure"]) == (
            row.family.name, row.size, row.n, row.made, row.measure)
        assert mpq(record["degradation_squared"]) == row.degradation_squared
        assert float(record["degradation"]) ** 2 == pytest.approx(float(mpq(record["degradation_squared"])), rel=1e-10)
        assert int(record["steiner"]) == row.verification.steiner
        assert mpq(record["input_error"]) == (mpq(1, 2**40) if row.family.name == "regular" else 0)
        assert record["holds"] == ("" if check(row) is None else "True")


def test_the_json_says_the_same(tiny: list[Row]) -> None:
    found = json.loads(table1_json(tiny, laws(tiny)))
    assert [mpq(record["degradation_squared"]) for record in found["rows"]] == [
        row.degradation_squared for row in tiny]
    assert len(found["laws"]) == 20 and {law["holds"] for law in found["laws"]} == {True, None}
    proper = next(law for law in found["laws"] if (law["family"], law["kind"]) == ("floor", "proper"))
    assert proper["paper"] == "O(log n)" and proper["rows"] == 3 and proper["failures"] == []


def test_the_text_shows_every_input_and_law(tiny: list[Row]) -> None:
    text = table1_text(tiny, laws(tiny))
    lines = text.splitlines()
    assert sum(line.endswith(" holds") for line in lines) == 18
    for family in TINY:
        for size in family.short:
            assert any(line.startswith(f"{family.name} ") and f"{family.variable} = {size} " in line for line in lines)
    assert "21.5517 +64" in text and "2^-40" in text


def series_in(text: str) -> dict[str, int]:
    """Return the names of the series in a picture, with the number of their marks."""
    found = {}
    for group in ElementTree.fromstring(text).iter(f"{SVG}g"):
        if group.get("class") == "series":
            title, line = group.find(f"{SVG}title"), group.find(f"{SVG}polyline")
            assert title is not None and title.text is not None and line is not None
            assert len((line.get("points") or "").split()) == len(group.findall(f"{SVG}circle"))
            found[title.text] = len(group.findall(f"{SVG}circle"))
    return found


def test_the_picture_holds_every_series(tiny: list[Row]) -> None:
    assert series_in(table1_svg(tiny)) == {f"{family.name}: {made}": 3 for family in TINY for made in MADE}


def test_marks_stand_where_the_scales_say() -> None:
    text = svg_of("a < b & c", [Panel("p", "x", (Series("s", ((1.0, 1.0), (10.0, 10.0), (100.0, 100.0))),))])
    root = ElementTree.fromstring(text)
    assert "a < b & c" in [element.text for element in root.iter(f"{SVG}title")]
    group = next(element for element in root.iter(f"{SVG}g") if element.get("class") == "series")
    x, y = zip(*((float(c.get("cx", "")), float(c.get("cy", ""))) for c in group.iter(f"{SVG}circle")), strict=True)
    assert x[1] - x[0] == pytest.approx(x[2] - x[1]) and y[0] - y[1] == pytest.approx(y[1] - y[2]) and y[0] > y[2]


def test_a_picture_of_nothing_is_a_picture() -> None:
    assert series_in(svg_of("", [Panel("p", "x", (Series("s", ()),))])) == {"p: s": 0}


# --- the command ---


@pytest.fixture
def few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let the command see tiny sizes only."""
    def rows(made: tuple[Made, ...], short: bool, progress: Any) -> Iterator[Row]:
        return table1_rows(made, short, progress, TINY)
    monkeypatch.setattr(reproduce, "table1_rows", rows)


def test_the_command_writes_three_files_and_prints_the_table(few: None, tmp_path: Path,
                                                             capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / "new" / "folder"
    assert cli.main(["reproduce", "table1", "--short", "-o", str(folder)]) == exit_status.HOLDS
    out, err = capsys.readouterr()
    assert err == "" and out == (folder / "table1.txt").read_text()
    assert {path.name for path in folder.iterdir()} == {"table1.txt", "table1.csv", "table1.svg"}
    assert len(list(csv.DictReader(io.StringIO((folder / "table1.csv").read_text())))) == 60
    assert len(series_in((folder / "table1.svg").read_text())) == 20


def test_the_command_prints_json_of_some_kinds(few: None, capsys: pytest.CaptureFixture[str]) -> None:
    assert cli.main(["reproduce", "table1", "--json", "--kinds", "proper,classic", "--quiet"]) == exit_status.HOLDS
    found = json.loads(capsys.readouterr().out)
    assert [record["kind"] for record in found["rows"]] == ["classic", "proper"] * 12
    assert {law["kind"] for law in found["laws"]} == {"classic", "proper"}


def test_the_command_fails_and_still_writes_when_a_verdict_fails(monkeypatch: pytest.MonkeyPatch, tmp_path: Path,
                                                                 capsys: pytest.CaptureFixture[str], tiny: list[Row]
                                                                 ) -> None:
    bad = harmed(row_of(tiny, "floor", 8, "nonproper"), mpq(500))
    monkeypatch.setattr(reproduce, "table1_rows", lambda *arguments: iter([bad]))
    assert cli.main(["reproduce", "table1", "-o", str(tmp_path)]) == exit_status.FAILS
    out, err = capsys.readouterr()
    assert "FAILS" in out and err == "floor k = 8, nonproper: degradation <= 21.6\n"
    (record,) = csv.DictReader(io.StringIO((tmp_path / "table1.csv").read_text()))
    assert record["holds"] == "False" and record["degradation_squared"] == "500"


@pytest.mark.parametrize("arguments, message", [
    (["table1", "-o", "-"], "needs a folder"),
    (["table1", "-o", "{file}/below"], "no folder can be made"),
    (["table1", "-o", "{file}"], "no folder can be made"),
])
def test_what_the_command_refuses(few: None, tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: list[str],
                                  message: str) -> None:
    (tmp_path / "file").write_text("")
    status = cli.main(["reproduce", *(argument.format(file=tmp_path / "file") for argument in arguments)])
    assert status == exit_status.REFUSED and message in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [["--short"], ["--kinds", "proper"], ["-o", "somewhere"]])
def test_what_is_for_table1_only(capsys: pytest.CaptureFixture[str], arguments: list[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        cli.main(["reproduce", "bounds", *arguments])
    assert "unrecognized arguments" in capsys.readouterr().err


@pytest.mark.parametrize("kinds", ["", "proper,", "best", "proper classic"])
def test_unknown_kinds_are_refused(kinds: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit, match="2"):
        cli.main(["reproduce", "table1", "--kinds", kinds])
    assert "choose from classic, optimal, nonproper, proper, internal" in capsys.readouterr().err
