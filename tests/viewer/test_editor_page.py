"""The editor's page in a real browser, with its server: every control is used."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from conftest import Opener
from editing import Served, editor
from gmpy2 import mpq
from pages import camera, colour_of, differ, near, picture

from exactmesh.claims.run import Run
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.planar.pslg import Pslg, polygon

VIEW = "editor.view"


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    with editor("-o", str(tmp_path_factory.mktemp("saved") / "polygon.json")) as running:
        yield running


class Hand:
    """Does in the page what a person does."""

    def __init__(self, page: Any, says: str = "exact") -> None:
        self.page = page
        self.top = page.locator("canvas.top")
        self.settled(says)

    def settled(self, says: str = "exact") -> None:
        """Wait until the server has said all there is to say of the polygon on the page."""
        self.page.locator('aside[data-stale="false"]').wait_for()
        assert self.said("state").startswith(says), self.said("state")

    def said(self, where: str) -> str:
        """Return the text of an element."""
        found: str = self.page.locator(f"#{where}").inner_text()
        return found

    def pslg(self) -> Pslg:
        """Return the polygon on the page."""
        return pslg_from_json(json.dumps(self.page.evaluate("editor.drawing.json()")))

    def place(self, x: float, y: float) -> tuple[float, float]:
        """Return the pixel of the drawing at a point of the plane."""
        place = """([x, y]) => [editor.view.camera.toScreenX(editor.frame.x(x)),
                                editor.view.camera.toScreenY(editor.frame.y(y))]"""
        px, py = self.page.evaluate(place, [str(x), str(y)])
        return px, py

    def at(self, x: float, y: float) -> tuple[float, float]:
        """Return the pixel of the window at a point of the plane."""
        box = self.top.bounding_box()
        px, py = self.place(x, y)
        return box["x"] + px, box["y"] + py

    def drag(self, start: tuple[float, float], *stops: tuple[float, float]) -> None:
        """Drag what is at a point of the plane along others."""
        self.page.mouse.move(*self.at(*start))
        self.page.mouse.down()
        for stop in stops:
            self.page.mouse.move(*self.at(*stop), steps=3)
        self.page.mouse.up()

    def click(self, x: float, y: float) -> None:
        """Click at a point of the plane."""
        self.page.mouse.click(*self.at(x, y))

    def button(self, name: str) -> None:
        """Press one of the page's buttons."""
        self.page.locator(f"#{name}").click()

    def keys(self, *names: str) -> None:
        """Press keys while the drawing has the focus."""
        self.top.focus()
        for name in names:
            self.page.keyboard.press(name)

    def is_exact_of(self, pslg: Pslg) -> None:
        """Check all numbers on the page against the library's."""
        sizes = self.said("mesh-sizes").replace("\n", " ")
        for name in ("repaired", "paper"):
            run = Run(pslg, name)
            assert f"squared {run.mfs.squared}" in self.said("input-sizes")
            shown = self.page.locator(f'[data-mesh="{name}"]').inner_text()
            assert f"squared {run.verification.degradation_squared}" in shown, (name, sizes)
            assert f"{len(run.mesh.faces)}, {run.verification.steiner} Steiner vertices" in shown
            failing = self.page.locator(f"#{name}-claims .fails").count()
            assert f"{failing} FAIL" in self.said(f"{name}-summary") or failing == 0


@pytest.fixture
def hand(open_page: Opener, served: Served) -> Hand:
    return Hand(open_page(served.url))


def test_dragging_a_vertex_updates_everything_exactly(hand: Hand) -> None:
    hand.is_exact_of(hand.pslg())
    before = picture(hand.page, "ground")
    hand.drag((4, 1), (3.6, 1.4), (3.4, 1.6), (3.1, 1.9))
    hand.settled()
    changed = polygon([(0, 0), (4, 0), (3, 2), (2, 1), (2, 3), (0, 3)])
    assert hand.pslg().vertices == changed.vertices
    hand.is_exact_of(changed)
    assert differ(before, picture(hand.page, "ground"))
    hand.button("undo")  # a drag is one change
    hand.settled()
    assert hand.pslg().vertices == polygon([(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)]).vertices
    hand.button("redo")
    hand.settled()
    assert hand.pslg().vertices == changed.vertices


def test_what_crosses_is_refused_in_the_page_and_marked(hand: Hand) -> None:
    hand.drag((0, 0), (3, 2.5))
    hand.settled("edges ")
    assert "cross at" in hand.said("state") and "error" in hand.page.locator("#state").get_attribute("class")
    assert hand.said("input-sizes") == "" and hand.said("mesh-sizes") == ""
    x, y = hand.page.evaluate("editor.fault.at")
    red = colour_of(hand.page, "error")
    px, py = hand.place(x, y)
    assert near(picture(hand.page).getpixel((round(px), round(py) + 9)), red, 90)
    hand.keys("u")
    hand.settled()
    assert hand.page.evaluate("editor.fault") is None


def test_drawing_with_the_pointer_on_a_finer_lattice(hand: Hand) -> None:
    hand.button("clear")
    hand.settled("Draw a polygon.")
    assert hand.page.locator("#draw").get_attribute("aria-pressed") == "true"
    hand.page.locator("#spacing").fill("no")
    assert hand.page.locator("#spacing").get_attribute("aria-invalid") == "true"
    hand.page.locator("#spacing").fill("1/3")
    corners = [(0, 0), (4, 0), (4, 2.32), (0, 3)]
    for corner in corners:
        hand.click(*corner)
    hand.click(*corners[1])  # once is enough
    assert hand.page.locator("#close").is_enabled()
    hand.click(*corners[0])
    hand.settled()
    drawn = polygon([(0, 0), (4, 0), (4, "7/3"), (0, 3)])
    assert hand.pslg().vertices == drawn.vertices and hand.pslg().edges == drawn.edges
    hand.is_exact_of(drawn)
    assert hand.page.locator("#move").get_attribute("aria-pressed") == "true"


def test_drawing_and_changing_with_the_keyboard_alone(hand: Hand) -> None:
    hand.button("clear")
    hand.keys("m", "d")
    for keys in (("Enter",), (*["ArrowRight"] * 3, "Enter"), (*["ArrowUp"] * 2, "Enter"),
                 (*["ArrowUp"] * 2, "ArrowLeft", "Enter"), ("u",), (*["ArrowLeft"] * 2, "Enter"), ("c",)):
        hand.keys(*keys)
    hand.settled()
    drawn = hand.pslg()
    assert len(drawn.vertices) == len(drawn.edges) == 4
    hand.is_exact_of(drawn)
    hand.keys("n", "n", "p", "ArrowRight", "ArrowUp")
    hand.settled()
    moved = hand.pslg().vertices
    assert [a == b for a, b in zip(drawn.vertices, moved, strict=True)] == [False, True, True, True]
    assert (2 * moved[0].x).denominator == (2 * moved[0].y).denominator == 1
    assert (moved[0].x - drawn.vertices[0].x, moved[0].y - drawn.vertices[0].y) == (0.5, 0.5)
    hand.keys("i")
    hand.settled()
    assert len(hand.pslg().vertices) == 5
    middle = hand.pslg().vertices[4]
    assert 2 * middle.x == moved[0].x + moved[1].x and 2 * middle.y == moved[0].y + moved[1].y
    hand.keys("Delete", "u", "u", "r")
    hand.settled()
    assert len(hand.pslg().vertices) == 5
    hand.keys("Escape")
    before = camera(hand.page, VIEW)
    hand.keys("ArrowRight", "+")
    after = camera(hand.page, VIEW)
    assert after["x"] > before["x"] and after["scale"] > before["scale"]


def test_split_and_delete_keep_a_polygon(hand: Hand) -> None:
    hand.click(4, 1)
    hand.button("split")
    hand.settled()
    assert hand.pslg().vertices[6] == polygon([(3, 1), (0, 0), (1, 1)]).vertices[0] and len(hand.pslg().edges) == 7
    hand.button("delete")
    hand.settled()
    assert hand.pslg() == polygon([(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)])
    for left in (5, 4, 3, 0):
        hand.keys("p", "Delete")
        hand.settled("exact" if left else "Draw")
        assert len(hand.pslg().vertices) == len(hand.pslg().edges) == left


def test_the_mesh_drawn_its_step_and_a_claim_can_be_chosen(hand: Hand) -> None:
    page = hand.page
    options = page.locator("#step option").all_inner_texts()
    assert options == ["Input", "Q", "Trapezoids", "Interior", "Tube", "Mesh"]
    pictures = [picture(page, "ground")]
    page.locator("#step").select_option("Trapezoids")
    pictures.append(picture(page, "ground"))
    page.locator('input[value="paper"]').check()
    assert page.locator("#step").input_value() == "Mesh"
    pictures.append(picture(page, "ground"))
    page.locator('input[value="none"]').check()
    assert page.locator("#step").is_disabled()
    pictures.append(picture(page, "ground"))
    assert all(differ(a, b) for i, a in enumerate(pictures) for b in pictures[:i])
    before = camera(page, VIEW)
    page.locator("#repaired-claims .claim[data-claim='repaired.degradation']").click()
    assert page.locator('input[value="repaired"]').is_checked() and camera(page, VIEW) != before
    assert "the degradation is at most the design value" in hand.said("details")
    page.locator("#paper-claims .claim:has(.fails)").first.click()
    assert page.locator('input[value="paper"]').is_checked() and "FAILS" in hand.said("details")
    assert page.locator("[aria-current]").count() == 1
    hand.button("unchoose")
    assert page.locator("#chosen").is_hidden() and page.locator("[aria-current]").count() == 0
    hand.button("fit")
    hand.click(1, 1.6)
    assert hand.said("details").startswith("Face")
    hand.button("zoom-in")
    hand.button("zoom-out")
    assert camera(page, VIEW)["scale"] == pytest.approx(before["scale"])


def test_the_drawing_pans_and_tells_what_the_pointer_is_on(hand: Hand) -> None:
    before = camera(hand.page, VIEW)
    hand.drag((3, 2.25), (3.5, 2.5))
    after = camera(hand.page, VIEW)
    assert after["x"] < before["x"] and after["y"] < before["y"]
    hand.page.mouse.move(*hand.at(1.1, 0.9))
    said = hand.said("under")
    assert said.startswith("lattice point (1, 1) · face ") and "squared exactly" in said


def test_saving_downloading_and_the_theme(hand: Hand) -> None:
    hand.button("save")
    hand.page.locator("#state", has_text="saved to").wait_for()
    path = hand.said("state").removeprefix("saved to ")
    assert pslg_from_json(Path(path).read_text(encoding="utf-8")) == hand.pslg()
    with hand.page.expect_download() as waiting:
        hand.button("download")
    download = waiting.value
    assert download.suggested_filename == "polygon.json"
    assert pslg_from_json(Path(download.path()).read_text(encoding="utf-8")) == hand.pslg()
    before = picture(hand.page, "ground")
    hand.button("theme")
    assert differ(before, picture(hand.page, "ground"))


def test_a_polygon_that_takes_too_long_is_given_up_in_the_page(open_page: Opener, tmp_path: Path) -> None:
    corners = [(0, 0), (300, 0), *((300 - i, 10 + 3 * (i % 2) + i % 7) for i in range(301))]
    path = tmp_path / "slow.json"
    path.write_text(json_from_pslg(polygon(corners)), encoding="utf-8")
    with editor(str(path), "--time-limit", "1") as slow:
        hand = Hand(open_page(slow.url), "Stopped after 1 s")
        hand.page.locator("#save").wait_for(state="hidden")  # no file was named
        hand.button("clear")
        hand.keys("m")
        hand.settled("Draw a polygon.")


def test_the_lattice_suits_the_file(open_page: Opener, tmp_path: Path) -> None:
    path = tmp_path / "small.json"
    path.write_text(json_from_pslg(polygon([("7/3", 5), ("2.34", 5), ("2.335", "5.004")])), encoding="utf-8")
    with editor(str(path)) as small:
        hand = Hand(open_page(small.url))
        assert hand.page.locator("#spacing").input_value() == "1/2000"
        assert hand.pslg().vertices[0].x == mpq(7, 3)  # exact until it is moved
        hand.keys("n", "ArrowLeft")
        hand.settled()
        assert hand.pslg().vertices[0].x == mpq(4666, 2000)


def test_every_control_of_the_editor_has_a_name_and_shows_the_focus(hand: Hand) -> None:
    found = []
    for _ in range(40):
        hand.page.keyboard.press("Tab")
        name, label, visible = hand.page.evaluate("""() => {
            const e = document.activeElement, style = getComputedStyle(e);
            return [e.id || e.value || e.className,
                    e.getAttribute("aria-label") || e.labels?.[0]?.innerText || e.innerText,
                    style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2];
        }""")
        found.append(name)
        assert label and visible, name
    assert {"theme", "move", "draw", "clear", "spacing", "download", "save", "top", "fit", "step"} <= set(found)
