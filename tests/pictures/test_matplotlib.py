"""Pictures on matplotlib axes, as files, and in notebooks."""

import sys
from collections.abc import Iterator

import matplotlib
import pytest
from constructions import HALL
from drawn import count, root_of
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

import exactmesh
from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.pictures import plot as module
from exactmesh.pictures.draw import picture_of_run
from exactmesh.pictures.mpl import image_bytes

ROOM = exactmesh.polygon([(0, 0), (7, 0), (7, 3), (4, 3), (4, 1), (3, 3), (0, 3)], "room")
RESULT = exactmesh.mesh(ROOM)


@pytest.fixture(autouse=True)
def without_a_screen() -> Iterator[None]:
    matplotlib.use("Agg")
    yield
    import matplotlib.pyplot as plt

    plt.close("all")


def labelled(ax: object, name: str) -> list[object]:
    return [item for item in ax.collections if item.get_label() == "_" + name]  # type: ignore[attr-defined]


def test_axes_have_the_coordinates_of_the_plane() -> None:
    figure = Figure()
    ax = exactmesh.plot(ROOM, figure.add_subplot())
    (edges,) = labelled(ax, "input")
    assert isinstance(edges, LineCollection)
    drawn = {tuple(map(tuple, segment.round(9))) for segment in edges.get_segments()}
    assert drawn == {tuple((float(p.x), float(p.y)) for p in (ROOM.vertices[u], ROOM.vertices[v]))
                     for u, v in ROOM.edges}
    assert ax.get_aspect() == 1.0 and ax.figure is figure
    (low, high), (floor, top) = ax.get_xlim(), ax.get_ylim()
    assert low < 0 and high > 7 and floor < 0 and top > 3


def test_axes_show_all_faces_and_vertices() -> None:
    ax = RESULT.plot()
    polygons = [path for rank in range(7) for item in labelled(ax, f"feature-{rank}")
                if isinstance(item, PolyCollection) for path in item.get_paths()]
    assert len(polygons) == len(RESULT.mesh.faces)
    (dots,) = labelled(ax, "given")
    assert sorted(map(tuple, dots.get_offsets().round(9).tolist())) == sorted(  # type: ignore[attr-defined]
        (float(p.x), float(p.y)) for p in ROOM.vertices)
    assert any(text.get_text().startswith("mfs of the mesh") for text in ax.texts)
    assert ax.get_legend() is not None


def test_steps_and_things_that_can_be_drawn() -> None:
    for ax in (RESULT.plot(step="trapezoids"), exactmesh.plot(RESULT, step="Q"), exactmesh.plot(RESULT.mesh),
               ROOM.plot(), exactmesh.plot(HALL)):  # type: ignore[attr-defined]
        assert ax.collections
    for step in ("P2", "all"):
        with pytest.raises(InputError):
            RESULT.plot(step=step)


def test_a_plane_far_away_is_shifted_and_says_so() -> None:
    far = exactmesh.polygon([(10**20, 0), (10**20 + 4, 0), (10**20 + 4, 4)])
    ax = exactmesh.plot(far, Figure().add_subplot())
    assert ax.get_xlabel() == "(x - 99999999999999999999.944) / 0.004"
    assert exactmesh.plot(exactmesh.polygon([(0, 0), (f"1e{400}", 0), (0, 1)]), Figure().add_subplot()).get_xlabel()


@pytest.mark.parametrize("form", ["png", "pdf"])
def test_files_are_the_same_each_time(form: str) -> None:
    scene = picture_of_run(Run(ROOM, "paper"), "P5")
    with matplotlib.rc_context({"axes.facecolor": "black", "font.size": 30}):
        first = image_bytes(scene, form)
    assert first == image_bytes(scene, form)


def test_without_matplotlib_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(InputError, match=r"exactmesh\[plot\]"):
        exactmesh.plot(ROOM)


def test_notebooks_show_inputs_meshes_and_results() -> None:
    assert count(root_of(ROOM._repr_svg_()), "input") == 7  # type: ignore[attr-defined]
    assert count(root_of(RESULT.mesh._repr_svg_()), "faces") == len(RESULT.mesh.faces)  # type: ignore[attr-defined]
    html = RESULT._repr_html_()
    assert html.startswith("<figure><svg") and html.endswith("</figure>")
    assert "37 faces" in html and "claims, none failed" in html
    # Pages hold several pictures: a style sheet or an id of one would reach the others.
    assert "<style" not in html and " id=" not in html


def test_notebooks_show_no_more_than_they_can_keep(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_FACES_IN_A_NOTEBOOK", 5)
    assert RESULT.mesh._repr_svg_() is None  # type: ignore[attr-defined]
    assert count(root_of(RESULT._repr_html_().removeprefix("<figure>").partition("<figcaption>")[0]), "input") == 7
    assert exactmesh.Pslg((), ())._repr_svg_() is None  # type: ignore[attr-defined]


def test_a_failed_claim_is_counted_in_notebooks() -> None:
    room = exactmesh.polygon([(0, 1), (2, 1), (2, 0), (44, 0), (44, 2), (0, 2)])
    html = exactmesh.mesh(room, "paper")._repr_html_()
    assert "degradation 52.2031" in html and "none failed" not in html
