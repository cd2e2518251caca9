"""Table 1, reproduced, as text, CSV, JSON and a picture."""

import csv
import io
import json
import textwrap
from collections.abc import Sequence
from math import sqrt

from exactmesh.numbers.rational import sqrt_text, text_from_rational
from exactmesh.report import table
from exactmesh.reproduce.families import Family
from exactmesh.reproduce.growth import Law
from exactmesh.reproduce.plot import Panel, Series, svg_of
from exactmesh.reproduce.table1 import MADE, MAX_OPTIMAL, Row, check, clause
from exactmesh.steps.constants import DESIGN_DEGRADATION, PAPER_DEGRADATION

_DIGITS = 6
_WIDTH = 118
_COLUMNS = ("family", "parameter", "value", "n", "kind", "measure", "degradation_squared", "degradation", "steiner",
            "input_error", "check", "holds")
_NOTES = (
    "Degradations are exact and rounded only here; +s counts the Steiner vertices. They are of the mfs, for internal "
    "meshes of the ifs.",
    "classic: the constrained Delaunay triangulation. optimal: the best classic mesh, by dynamic programming, for "
    f"n <= {MAX_OPTIMAL}.",
    "A verdict is that of all rows, each checked exactly; the bound on classic holds of every classic mesh of the "
    "input. A fit is made with floats over the larger half of the sizes and decides nothing.",
    "The vertices of regular are rational points of the unit circle, within 2^-40 of those of the n-gon; all other "
    "inputs are exact.",
    "Omega(n + r) for classic meshes is Omega(n) on inputs with r = Theta(n) (regular, floor) and Omega(r) where n is "
    "6 (rectangle). These are convex, so ifs and mfs agree: their rows stand for both columns of the paper's table.",
    "Not shown: the paper's lower bound for proper meshes, whose inputs it does not give. comb and floor are hard for "
    "this construction; another might do better on them.",
)


def table1_text(rows: Sequence[Row], laws: Sequence[Law]) -> str:
    """Return the laws and the degradations as two tables, with notes."""
    lines: list[Sequence[str]] = [("family", "kind", "of", "paper", "rows", "greatest", "fit", "checked in every row",
                                   "verdict")]
    lines += [(law.family.name, law.made, law.measure, law.paper or "-", str(law.rows),
               "invalid" if law.greatest is None else sqrt_text(law.greatest, _DIGITS), law.fit, law.clause or "-",
               _verdict(law.holds)) for law in laws]
    made = [kind for kind in MADE if any(law.made == kind for law in laws)]
    cells: dict[tuple[Family, int, int], dict[str, str]] = {}
    for row in rows:
        cells.setdefault((row.family, row.size, row.n), {})[row.made] = _cell(row)
    sizes: list[Sequence[str]] = [("family", "size", "n", *made)]
    sizes += [(family.name, f"{family.variable} = {size}", str(n), *(found.get(kind, "") for kind in made))
              for (family, size, n), found in cells.items()]
    return "\n\n".join([table(lines, right=(4, 5)), table(sizes, right=(2, *range(3, 3 + len(made)))),
                        "\n".join(textwrap.fill(note, _WIDTH) for note in _NOTES)])


def table1_csv(rows: Sequence[Row]) -> str:
    """Return the rows as CSV; the degradation is exact as a square, and a decimal beside it."""
    stream = io.StringIO()
    writer = csv.DictWriter(stream, _COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(map(_record, rows))
    return stream.getvalue()


def table1_json(rows: Sequence[Row], laws: Sequence[Law]) -> str:
    """Return what `exactmesh reproduce table1 --json` prints."""
    return json.dumps({"rows": [_record(row) for row in rows], "laws": [
        {"family": law.family.name, "kind": law.made, "measure": law.measure, "paper": law.paper, "rows": law.rows,
         "greatest_squared": None if law.greatest is None else text_from_rational(law.greatest),
         "fit": law.fit, "check": law.clause, "holds": law.holds, "failures": list(law.failures)} for law in laws]},
        indent=1)


def table1_svg(rows: Sequence[Row]) -> str:
    """Return log-log plots of the degradation, one for each family, with a series for each kind."""
    panels: dict[str, dict[str, list[tuple[float, float]]]] = {}
    families: dict[str, Family] = {}
    for row in rows:
        families[row.family.name] = row.family
        series = panels.setdefault(row.family.name, {}).setdefault(row.made, [])
        if row.degradation_squared is not None:
            series.append((float(row.place), sqrt(float(row.degradation_squared))))
    levels = [(float(DESIGN_DEGRADATION), f"{float(DESIGN_DEGRADATION)}"), (float(PAPER_DEGRADATION),
                                                                            f"{PAPER_DEGRADATION}")]
    return svg_of("Degradation of feature size, by kind of mesh", [
        Panel(name, families[name].against, tuple(Series(kind, tuple(points)) for kind, points in found.items()))
        for name, found in panels.items()], levels)


def _cell(row: Row) -> str:
    squared = row.degradation_squared
    if squared is None:
        return "invalid"
    steiner = f" +{row.verification.steiner}" if row.made not in ("classic", "optimal") else ""
    return sqrt_text(squared, _DIGITS) + steiner


def _record(row: Row) -> dict[str, object]:
    squared, verdict = row.degradation_squared, check(row)
    return {
        "family": row.family.name, "parameter": row.family.variable, "value": row.size, "n": row.n, "kind": row.made,
        "measure": row.measure,
        "degradation_squared": None if squared is None else text_from_rational(squared),
        "degradation": None if squared is None else sqrt_text(squared),
        "steiner": row.verification.steiner, "input_error": text_from_rational(row.family.within),
        "check": clause(row.family, row.made), "holds": None if verdict is None else verdict.holds}


def _verdict(holds: bool | None) -> str:
    if holds is None:
        return "-"
    return "holds" if holds else "FAILS"
