"""The paper's figures 1 to 10 from real runs, and a companion wherever what they show fails."""

import hashlib
import json
import os
from collections.abc import Callable, Iterable, Iterator, Sequence

from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.pictures.svg import svg_text
from exactmesh.planar.pslg import Pslg
from exactmesh.report import table
from exactmesh.reproduce.figure_boundary import figure_4, figure_4_fails, figure_5, figure_5_fails
from exactmesh.reproduce.figure_interior import figure_p5_fails, figure_p6_fails, figure_theorem_2_fails
from exactmesh.reproduce.figure_kit import Figure
from exactmesh.reproduce.figure_rectangles import figure_1, figure_2, figure_2_fails, figure_3, figure_3_fails
from exactmesh.reproduce.figure_tube import (
    figure_6,
    figure_7,
    figure_7_fails,
    figure_8,
    figure_8_fails,
    figure_9,
    figure_9_fails,
    figure_10,
    figure_10_fails,
)

# A companion's name ends in "-fails"; the last three have no figure in the paper.
FIGURES: dict[str, Callable[[], Figure]] = {
    "fig-01": figure_1, "fig-02": figure_2, "fig-02-fails": figure_2_fails, "fig-03": figure_3,
    "fig-03-fails": figure_3_fails, "fig-04": figure_4, "fig-04-fails": figure_4_fails, "fig-05": figure_5,
    "fig-05-fails": figure_5_fails, "fig-06": figure_6, "fig-07": figure_7, "fig-07-fails": figure_7_fails,
    "fig-08": figure_8, "fig-08-fails": figure_8_fails, "fig-09": figure_9, "fig-09-fails": figure_9_fails,
    "fig-10": figure_10, "fig-10-fails": figure_10_fails, "p5-fails": figure_p5_fails, "p6-fails": figure_p6_fails,
    "theorem-2-fails": figure_theorem_2_fails,
}


def figures(names: Iterable[str] = FIGURES, progress: Callable[[str], None] = lambda step: None) -> Iterator[Figure]:
    """Yield the figures of the given names; `progress` is told each. Raises `InputError` for an unknown name."""
    wanted = list(names)
    for name in wanted:
        if name not in FIGURES:
            raise InputError(f"there is no figure {name!r}; there are: {', '.join(FIGURES)}")
    for name in wanted:
        progress(name)
        yield FIGURES[name]()


def commands_of(figure: Figure) -> tuple[str, ...]:
    """Return the command that makes a figure, then those that draw its panels and judge its claims alone."""
    return (f"exactmesh reproduce figures --only {figure.name} -o DIR", *figure.commands)


def sha256_of(pslg: Pslg) -> str:
    """Return the hash of an input's file, as it is written beside the figures."""
    return hashlib.sha256(json_from_pslg(pslg).encode()).hexdigest()


def write_figures(found: Sequence[Figure], folder: str) -> None:
    """Write each figure as SVG, the inputs that they are of, and `figures.json` with captions, commands and hashes.

    The folder must exist, for the figures; the one for the inputs is made. Raises `InputError`.
    """
    inputs = {name: pslg for figure in found for name, pslg in figure.inputs.items()}
    if inputs:
        try:
            os.makedirs(os.path.join(folder, "inputs"), exist_ok=True)
        except OSError as error:
            raise InputError(f"{folder}: no folder can be made in it: {error.strerror or error}") from error
    for name, pslg in inputs.items():
        write_text(os.path.join(folder, "inputs", f"{name}.json"), json_from_pslg(pslg))
    for figure in found:
        write_text(os.path.join(folder, f"{figure.name}.svg"), svg_text(figure.scene))
    write_text(os.path.join(folder, "figures.json"), figures_json(found) + "\n")


def figures_json(found: Iterable[Figure]) -> str:
    """Return what is said of the figures."""
    return json.dumps({"figures": [
        {"name": figure.name, "paper": figure.paper, "title": figure.title, "file": f"{figure.name}.svg",
         "caption": list(figure.scene.caption), "commands": list(commands_of(figure)),
         "inputs": {f"inputs/{name}.json": sha256_of(pslg) for name, pslg in figure.inputs.items()},
         "refuted": list(figure.refuted)} for figure in found]}, indent=1)


def figures_text(found: Iterable[Figure]) -> str:
    """Return the names and titles of figures as a table."""
    rows = [("figure", "place", "claims refuted", "title")]
    rows += [(figure.name, figure.paper, str(len(figure.refuted) or "-"), figure.title) for figure in found]
    return table(rows, right=(2,))
