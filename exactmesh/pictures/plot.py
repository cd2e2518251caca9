"""`exactmesh.plot` and what notebooks show: a picture of whatever is given.

What draws is imported when something is drawn: this module is imported with the package.
"""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from exactmesh.pictures.scene import Scene

Drawable = Pslg | Mesh | Run
# Notebooks keep what they show: a mesh of more faces is shown by its input's outline.
_FACES_IN_A_NOTEBOOK = 20_000


def scene_of(thing: Drawable, step: str | None = None) -> "Scene":
    """Return a picture of a PSLG, of a mesh, or of one step of a run ("mesh" unless it is named)."""
    from exactmesh.pictures.draw import picture_of_faces, picture_of_input, picture_of_run

    match thing:
        case Pslg():
            return picture_of_input(thing)
        case Mesh():
            return picture_of_faces(thing)
    return picture_of_run(thing, step or "mesh")


def plot(thing: Drawable, ax: "Axes | None" = None, step: str | None = None) -> "Axes":
    """Draw a PSLG, a mesh, or a step of a run on matplotlib axes, new ones unless given; return the axes.

    Coordinates are those of the plane. Raises `InputError` without matplotlib, and for the step "all", which is
    no single drawing.
    """
    from exactmesh.pictures.mpl import draw_panel, load

    if step == "all":
        raise InputError('axes show one step: "all" is for `exactmesh plot`')
    load()
    if ax is None:
        import matplotlib.pyplot as plt

        _, ax = plt.subplots(figsize=(8, 8))
    draw_panel(scene_of(thing, step).panels[0], ax)
    return ax


def notebook_svg(thing: Drawable) -> str | None:
    """Return what a notebook shows as SVG; None, for its text instead, when there is nothing to draw."""
    from exactmesh.pictures.svg import svg_text

    many = len(thing.faces) if isinstance(thing, Mesh) else 0
    try:
        return None if many > _FACES_IN_A_NOTEBOOK else svg_text(scene_of(thing))
    except InputError:
        return None


def notebook_html(run: Run, summary: str) -> str:
    """Return what a notebook shows of a finished run: a picture and, below it, a line of text."""
    from exactmesh.pictures.svg import escaped, svg_text

    few = len(run.mesh.faces) <= _FACES_IN_A_NOTEBOOK
    return f"<figure>{svg_text(scene_of(run if few else run.pslg))}<figcaption>{escaped(summary)}</figcaption></figure>"


def attach(*classes: type[Pslg] | type[Mesh]) -> None:
    """Give classes of lower layers, which know no pictures, `_repr_svg_` and `plot`."""
    methods: dict[str, Callable[..., Any]] = {"_repr_svg_": notebook_svg, "plot": plot}
    for cls in classes:
        for name, method in methods.items():
            setattr(cls, name, method)
