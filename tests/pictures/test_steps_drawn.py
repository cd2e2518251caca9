"""Every step of every construction has a panel with all that the step made."""

import xml.etree.ElementTree as ET
from math import hypot

import pytest
from constructions import HALL
from drawn import count, one, panels, paths, root_of, texts

from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.pictures.curve import near, span
from exactmesh.pictures.draw import picture_of_run
from exactmesh.pictures.mpl import image_bytes
from exactmesh.pictures.steps import PHASES, makers_of, quasi_trapz, spokes, step_names, steps_in_turn
from exactmesh.pictures.svg import svg_text
from exactmesh.pictures.view import view_of
from exactmesh.planar.pslg import polygon
from exactmesh.steps.curve_view import rings_of

# Wide and narrow arcs, fans, quasi-trapz of every sort.
ROOM = polygon([(0, 0), (5, 1), (11, 0), (11, 6), (8, 6), (7, 3), (6, 6), (4, 6), (0, 3)], "room")
PAPER, REPAIRED, CLASSIC = Run(ROOM, "paper"), Run(ROOM, "repaired"), Run(ROOM, "classic", "classic")


def step(run: Run, name: str) -> ET.Element:
    root = root_of(svg_text(picture_of_run(run, name)))
    (panel,) = panels(root)[:1]
    return panel


def test_the_steps_are_those_of_the_construction() -> None:
    assert step_names(PAPER) == ("P", "P2", "P3", "P4", "P5", "P6", "phase1", "phase2", "phase3", "phase4", "tube",
                                 "mesh")
    assert step_names(REPAIRED) == ("P", "Q", "trapezoids", "interior", "tube", "mesh")
    assert step_names(CLASSIC) == ("P", "mesh")
    assert set(step_names(PAPER)) - set(steps_in_turn(PAPER)) == {"tube"}
    for run, wrong in ((PAPER, "Q"), (REPAIRED, "P4"), (CLASSIC, "tube"), (REPAIRED, "")):
        with pytest.raises(InputError, match="has no step"):
            picture_of_run(run, wrong)


@pytest.mark.parametrize("run", [PAPER, REPAIRED, CLASSIC], ids=lambda run: run.construction)
def test_all_steps_in_one_picture(run: Run) -> None:
    root = root_of(svg_text(picture_of_run(run, "all")))
    assert [g.get("data-step") for g in panels(root)] == list(steps_in_turn(run))
    assert all(count(g, "input") == len(ROOM.edges) for g in panels(root))


def test_p2_has_a_segment_an_edge_and_an_arc_a_reflex_vertex() -> None:
    panel = step(PAPER, "P2")
    view = view_of(ROOM.vertices)
    assert count(panel, "p2") == len(ROOM.edges)
    rings = rings_of(PAPER.paper.shape, PAPER.paper.curve)
    reflex = [corner for ring in rings for corner in ring if corner.record.arc]
    assert len(reflex) == len(paths(panel, "p2-arc")) == 2
    # Each chord of an arc lies on the circle of radius mfs/4 about its corner.
    radius = float(PAPER.mfs.squared) ** 0.5 / 4 * float(view.scale)
    for corner, path in zip(reflex, paths(panel, "p2-arc"), strict=True):
        x, y = view.place(corner.p)
        assert all(abs(hypot(px - x, py - y) - radius) < 0.02 for chain in path.chains for px, py in chain)
        ends = [path.chains[0][0], path.chains[-1][-1]]
        assert [hypot(px - view.place(near(end))[0], py - view.place(near(end))[1]) < 0.02
                for (px, py), end in zip(ends, corner.record.arc or (), strict=True)] == [True, True]


def test_spans_of_arcs() -> None:
    spans = [span(corner) for ring in rings_of(PAPER.paper.shape, PAPER.paper.curve) for corner in ring
             if corner.record.arc]
    # Edges of slopes 1/5 and -1/6 turn by atan(11/29); slopes of 3 and -3 by 180 degrees less 2 atan(1/3).
    assert spans == pytest.approx([20.7723, 143.1301], abs=1e-4)


def test_p3_p4_and_p5_have_all_their_vertices() -> None:
    made = PAPER.paper
    total = len(made.p4.x)
    assert count(step(PAPER, "P3"), "p3") == count(step(PAPER, "P3"), "p3-vertex") == total
    p4 = step(PAPER, "P4")
    assert count(p4, "ring") == count(p4, "offset") == total and count(p4, "level") > 20
    p5 = step(PAPER, "P5")
    assert count(p5, "trapezoid") + count(p5, "trapezoid-t") == len(made.trapezoidation.trapezoids)
    assert count(p5, "trapezoid-t") == sum(bool(z.top or z.bottom) for z in made.trapezoidation.trapezoids) > 0
    assert count(p5, "chord") == len(made.trapezoidation.points) and count(p5, "t-vertex") == 2


def test_p6_and_the_phases_have_all_their_faces() -> None:
    made = PAPER.paper
    assert sum(count(step(PAPER, "P6"), f"feature-{rank}") for rank in range(7)) == len(made.interior.faces)
    for number in range(1, 5):
        panel = step(PAPER, f"phase{number}")
        for phase, (of, _, _) in PHASES.items():
            assert count(panel, f"phase-{phase}") == (made.tube.phase.count(phase) if of <= number else 0)
    assert {phase for phase in PHASES if made.tube.phase.count(phase)} == set(PHASES)
    first = step(PAPER, "phase1")
    assert count(first, "quasi-trapz") == len(quasi_trapz(PAPER)) == len(ROOM.edges)
    # Two ends an edge; at all corners but the wide one the spokes of two edges are one.
    assert count(first, "spoke") == len(spokes(PAPER)) == len(ROOM.edges) + 1
    assert count(step(PAPER, "phase2"), "rectangle") == 4 * len(made.tube.rectangles) == 4


def test_repaired_steps_have_all_their_faces() -> None:
    made = REPAIRED.repaired
    assert count(step(REPAIRED, "Q"), "ring") == len(made.offset.x)
    panel = step(REPAIRED, "trapezoids")
    assert count(panel, "trapezoid") + count(panel, "trapezoid-t") == len(made.trapezoidation.trapezoids)
    for name, patch in (("interior", made.interior), ("tube", made.tube)):
        assert sum(count(step(REPAIRED, name), f"feature-{rank}") for rank in range(7)) == len(patch.faces)


@pytest.mark.parametrize("run", [PAPER, REPAIRED, CLASSIC], ids=lambda run: run.construction)
def test_vertices_are_coloured_by_who_placed_them(run: Run) -> None:
    made = makers_of(run)
    assert [v for numbers in made.values() for v in numbers] == list(range(len(run.mesh.vertices)))
    panel = step(run, "mesh")
    for maker, numbers in made.items():
        assert count(panel, maker) == len(numbers)
    if run.construction == "paper":
        assert len(made["chord"]) == len(run.paper.trapezoidation.points)
        assert len(made["interior"]) == len(run.paper.interior.points)


def test_a_domain_with_everything_has_all_steps() -> None:
    run = Run(HALL, "repaired")
    root = root_of(svg_text(picture_of_run(run, "all")))
    assert len(panels(root)) == 6 and texts(root, "panel-title")[1].startswith("Q: ")


def test_a_grid_of_too_many_lines_is_left_out() -> None:
    long = Run(polygon([(0, 0), (1, 0), (1, 1000), (0, 1000)]), "repaired")
    assert paths(step(long, "Q"), "level") == [] and one(step(REPAIRED, "Q"), "level").chains


def test_steps_through_matplotlib() -> None:
    assert image_bytes(picture_of_run(PAPER, "P4"), "png").startswith(b"\x89PNG")
