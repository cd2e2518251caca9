"""A picture through matplotlib: on axes of one's own, or as PNG and PDF. Imported when it is asked for.

On axes a panel has the coordinates of the plane, so that one's own things can be drawn over it; a plane too far from
its origin for floats is shifted and scaled, which the axes' names say.
"""

import io
from typing import TYPE_CHECKING, Any, Literal

from exactmesh.errors import InputError
from exactmesh.pictures.palette import FAINT, INK, PAPER
from exactmesh.pictures.scene import Area, Dots, Key, Label, Layer, Lines, Panel, Place, Scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FORMATS = ("png", "pdf")
_DPI = 100.0
# A pixel of the panel in points, of which there are 72 an inch.
_POINT = 72.0 / _DPI
_LEGEND, _TITLE = 0.24, 0.5
_SIDES: dict[str, Literal["left", "center", "right"]] = {"start": "left", "middle": "center", "end": "right"}


def load() -> Any:
    """Return `matplotlib`; raises `InputError`, which names the extra, where there is none."""
    try:
        import matplotlib
    except ImportError as error:
        raise InputError("PNG, PDF and axes need matplotlib: pip install 'exactmesh[plot]' (SVG needs nothing)"
                         ) from error
    return matplotlib


def draw_panel(panel: Panel, axes: "Axes", legend: bool = True) -> None:
    """Draw a panel on axes, in coordinates of the plane; raises `InputError` without matplotlib."""
    load()
    from matplotlib.patches import Patch

    def plane(place: Place) -> Place:
        return panel.left + place[0] * panel.unit, panel.top - place[1] * panel.unit

    share = _share(panel, axes)
    for depth, layer in enumerate(panel.layers):
        _draw(layer, axes, plane, share, depth)
    left, low = plane((0.0, panel.height))
    right, top = plane((panel.width, 0.0))
    axes.set_xlim(left, right)
    axes.set_ylim(low, top)
    axes.set_aspect("equal")
    if panel.offset is not None:
        axes.set_xlabel(panel.offset[0])
        axes.set_ylabel(panel.offset[1])
    if panel.title:
        axes.set_title(panel.title, fontsize=9, loc="left")
    if legend and panel.keys:
        handles = [Patch(visible=False) if key.look == "none" else _handle(key) for key in panel.keys]
        axes.legend(handles, [key.text for key in panel.keys], fontsize=7, loc="upper center",
                    bbox_to_anchor=(0.5, -0.06), ncol=3, frameon=False)


def image_bytes(scene: Scene, form: str) -> bytes:
    """Return the picture, less its caption, as the bytes of a PNG or PDF file, the same ones each time.

    Raises `InputError` without matplotlib.
    """
    matplotlib = load()
    from matplotlib.figure import Figure
    from matplotlib.patches import Patch

    across = max(sum(p.width for p in row) + 30 * len(row) for row in scene.rows)
    heights = [max(p.height for p in row) + 34 for row in scene.rows]
    width = max(across, 640.0) / _DPI
    lines = -(-len(scene.keys) // max(1, int(width * _DPI / 250)))
    below = _LEGEND * lines + 0.1
    height = sum(heights) / _DPI + _TITLE + below
    # Without the user's style sheets, so that one picture has one look.
    with matplotlib.rc_context(matplotlib.rcParamsDefault | {"pdf.compression": 6, "svg.hashsalt": "exactmesh"}):
        figure = Figure(figsize=(width, height), dpi=_DPI, facecolor=PAPER)
        figure.text(0.02, 1 - 0.3 / height, scene.title, fontsize=11, weight="bold", color=INK)
        y = height - _TITLE
        for row, tall in zip(scene.rows, heights, strict=True):
            x = 0.15
            for panel in row:
                size = panel.width / _DPI, panel.height / _DPI
                axes = figure.add_axes((x / width, (y - 0.25 - size[1]) / height, size[0] / width, size[1] / height))
                draw_panel(panel, axes, legend=False)
                axes.set_xticks([])
                axes.set_yticks([])
                for spine in axes.spines.values():
                    spine.set_color(FAINT)
                x += size[0] + 0.3
            y -= tall / _DPI
        if scene.keys:
            handles = [Patch(visible=False) if key.look == "none" else _handle(key) for key in scene.keys]
            figure.legend(handles, [key.text for key in scene.keys], loc="lower left", fontsize=8, frameon=False,
                          ncol=max(1, int(width * _DPI / 250)),
                          bbox_to_anchor=(0.01, 0))
        stream = io.BytesIO()
        # What would differ from day to day, or from version to version, stays out.
        metadata = {"CreationDate": None, "Producer": None, "Creator": None} if form == "pdf" else {"Software": None}
        figure.savefig(stream, format=form, dpi=_DPI, metadata=metadata, facecolor=PAPER)
    return stream.getvalue()


def _share(panel: Panel, axes: "Axes") -> float:
    """Return how much of its intended size the panel gets on the axes."""
    box = axes.get_window_extent()
    figure = axes.get_figure()
    dpi = figure.get_dpi() if figure is not None and hasattr(figure, "get_dpi") else _DPI
    return float(min(box.width / panel.width, box.height / panel.height) * _DPI / dpi)


def _draw(layer: Layer, axes: "Axes", plane: Any, share: float, depth: int) -> None:
    from matplotlib.collections import LineCollection, PolyCollection
    from matplotlib.patheffects import withStroke

    size = _POINT * share
    match layer:
        case Area():
            axes.add_collection(PolyCollection([[plane(p) for p in polygon] for polygon in layer.polygons],
                                               facecolors=layer.fill, edgecolors=layer.stroke,
                                               linewidths=layer.width * size, zorder=1 + depth, label="_" + layer.name))
        case Lines():
            dash = [length / layer.width for length in layer.dash]
            axes.add_collection(LineCollection([[plane(p) for p in chain] for chain in layer.chains],
                                               colors=layer.stroke, linewidths=layer.width * size, zorder=1 + depth,
                                               linestyles=(0, dash) if dash else "solid", label="_" + layer.name))
        case Dots():
            places = [plane(p) for p in layer.places]
            axes.scatter([x for x, _ in places], [y for _, y in places], s=(2 * layer.radius * size) ** 2,
                         c=layer.fill, linewidths=0, zorder=1 + depth, label="_" + layer.name)
        case Label():
            x, y = plane(layer.place)
            ha = _SIDES[layer.anchor]
            text = axes.text(x, y, layer.text, color=layer.fill, fontsize=max(layer.size * size, 7), ha=ha,
                             zorder=1 + depth, clip_on=True)
            text.set_path_effects([withStroke(linewidth=2.5, foreground=PAPER)])


def _handle(key: Key) -> Any:
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    match key.look:
        case "area":
            return Patch(facecolor=key.colour, edgecolor=INK, linewidth=0.3)
        case "dot":
            return Line2D([], [], color=key.colour, marker="o", linestyle="none", markersize=5)
        case "ring":
            return Line2D([], [], color=key.colour, marker="o", linestyle="none", markersize=6, fillstyle="none")
    return Line2D([], [], color=key.colour, linestyle="--" if key.look == "dashes" else "-")
