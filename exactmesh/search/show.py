"""Finds for people and programs: a table, JSON lines, files with pictures, and an HTML page."""

import json
import os
import shlex
from collections.abc import Iterable, Mapping
from html import escape
from typing import Any

from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.text import printable
from exactmesh.pictures.draw import svg_from_mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.report import table
from exactmesh.search.driver import worst_text
from exactmesh.search.figure import Figure
from exactmesh.search.spec import Spec
from exactmesh.search.targets import OBJECTIVES, target_of

Find = Mapping[str, Any]
_STYLE = ("body { font: 15px sans-serif; margin: 2em; max-width: 70em } svg { max-width: 36em; max-height: 24em } "
          "table { border-collapse: collapse } td, th { padding: .2em .8em; text-align: left; vertical-align: top; "
          "border-bottom: 1px solid #ccc } code { background: #eee } .no { color: #b00 }")


def command_of(spec: Spec) -> str:
    """Return the command that runs a spec, without limits of time and place."""
    family = spec.family + "".join(f"{',' if i else ':'}{name}={value}"
                                   for i, (name, value) in enumerate(spec.parameters))
    if spec.plugin:
        family = f"PLUGIN.py:{family}"
    if spec.strategy == "inputs" or len(spec.targets) > 1:
        return _verify_command(spec, json.loads(spec.family) if spec.strategy == "inputs" else [f"family:{family}"])
    claim, construction, kind = spec.targets[0]
    parts = ["exactmesh", "search", claim, "--construction", construction, "--kind", kind, "--strategy", spec.strategy,
             "--family", family, "--seed", str(spec.seed)]
    if spec.strategy != "exhaustive":
        parts += ["--size", str(spec.size)]
    if spec.shard != (0, 1):
        parts += ["--shard", "{}/{}".format(*spec.shard)]
    return shlex.join(parts)


def _verify_command(spec: Spec, inputs: list[str]) -> str:
    claims = ",".join(dict.fromkeys(claim for claim, _, _ in spec.targets))
    constructions = {construction for _, construction, _ in spec.targets}
    kinds = {kind for _, _, kind in spec.targets}
    parts = ["exactmesh", "verify-run", *inputs, "--claims", claims, "--construction",
             constructions.pop() if len(constructions) == 1 else "both", "--seed", str(spec.seed)]
    if len(kinds) == 1:
        parts += ["--kind", kinds.pop()]
    return shlex.join([*parts, *(["--shrink"] if spec.shrinks else [])])


def show_command(find: Find, path: str) -> str:
    """Return the command that shows a find whose polygon is in the file `path`."""
    claim, construction, kind = find["claim"], find["construction"], find["kind"]
    if claim in OBJECTIVES or kind != target_of(claim, construction).kind:
        return shlex.join(["exactmesh", "mesh", path, "--construction", construction, "--kind", kind])
    return shlex.join(["exactmesh", "claims", claim, "--on", path, "--construction", construction])


def find_name(find: Find) -> str:
    """Return the name of the files of a find."""
    return f"{find['claim']}-{find['construction']}-{find['kind']}-{find['id']}"


def find_record(find: Find) -> dict[str, object]:
    """Return a find as one JSON object."""
    spec = json.loads(find["spec"])
    shown = json.loads(find["shown"])
    return {"id": find["id"], "claim": find["claim"], "construction": find["construction"], "kind": find["kind"],
            "label": find["label"], "confirmed": bool(find["confirmed"]), "confirmation": find["confirmation"],
            "figure": json.loads(find["figure"]), "outcome": find["outcome"], "value": find["exact"],
            "worst": shown.get("worst"), "witness": shown.get("witness"), "error": shown.get("error"),
            "strategy": spec["strategy"], "family": spec["family"], "seed": spec["seed"], "task": find["task"],
            "version": find["version"], "found_by": find["command"],
            "shown_by": show_command(find, find_name(find) + ".json")}


def finds_text(finds: Iterable[Find]) -> str:
    """Return finds as a table."""
    rows = [("id", "claim", "construction", "label", "confirmed by", "points", "worst", "figure")]
    for find in finds:
        figure = figure_of(find)
        text = figure.text()
        rows.append((str(find["id"]), find["claim"], find["construction"], find["label"], confirmed_by(find),
                     str(len(figure.points)), worst_text(find), text if len(text) <= 60 else text[:57] + "..."))
    return table(rows, right=(0, 5))


def confirmed_by(find: Find) -> str:
    """Return in a word how far the independent check of a find goes."""
    return str(find["confirmation"]).partition(":")[0] if find["confirmed"] else "NOTHING"


def figure_of(find: Find) -> Figure:
    """Return the figure of a find."""
    return Figure.from_json(json.loads(find["figure"]))


def pslg_of_find(find: Find) -> Pslg:
    """Return the input of a find, named after it."""
    return figure_of(find).pslg(find_name(find))


def picture(find: Find) -> str:
    """Return the SVG of the mesh of a find, or of a classic mesh where the construction fails on it."""
    pslg = pslg_of_find(find)
    target = target_of(find["claim"], find["construction"], find["kind"])
    for run in (Run(pslg, target.construction, target.kind), Run(pslg, "classic", "classic")):
        try:
            return svg_from_mesh(pslg, run.mesh, run.verification)
        except Exception:  # a find may be an input on which the construction, or the program, fails
            continue
    return ""


def export(finds: Iterable[Find], folder: str) -> list[str]:
    """Write each find as a file and a picture into a folder; return the commands that show them."""
    try:
        os.makedirs(folder, exist_ok=True)
    except OSError as error:
        raise InputError(f"{printable(folder)}: no folder can be made: {error.strerror or error}") from error
    commands = []
    for find in finds:
        path = os.path.join(folder, find_name(find) + ".json")
        write_text(path, json_from_pslg(pslg_of_find(find)))
        write_text(path.removesuffix(".json") + ".svg", picture(find))
        commands.append(show_command(find, path))
    return commands


def html_page(finds: Iterable[Find], title: str) -> str:
    """Return a page with a picture and the facts of each find; it needs no other file."""
    parts = [page_head(title)]
    for find in finds:
        facts = [("worst", worst_text(find)), ("label", find["label"]), ("figure", find["figure"]),
                 ("independent check", find["confirmation"]), ("found by", find["command"]),
                 ("shown by", show_command(find, find_name(find) + ".json"))]
        rows = "".join(f"<tr><th>{name}</th><td>{escape(str(value))}</td></tr>" for name, value in facts)
        state = "" if find["confirmed"] else ' class="no"'
        parts.append(f"<h2{state}>{find['id']}. {escape(find['claim'])}, {find['construction']}, {find['kind']}</h2>"
                     f"<table>{rows}</table>{picture(find)}")
    return "\n".join([*parts, "</body></html>", ""])


def page_head(title: str) -> str:
    """Return the beginning of a page, up to its first heading."""
    return (f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{escape(title)}</title>'
            f"<style>{_STYLE}</style></head><body><h1>{escape(title)}</h1>")
