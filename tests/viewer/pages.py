"""What the tests of the viewer's page share: inputs, and looks into its pixels."""

import base64
import io
from pathlib import Path
from typing import Any

from gmpy2 import mpq
from PIL import Image, ImageChops

from exactmesh.claims.run import ConstructionName, Run
from exactmesh.geometry.point import Point
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg, polygon
from exactmesh.viewer.document import document_of
from exactmesh.viewer.page import viewer_page
from exactmesh.viewer.subject import subject_of_run

L_SHAPE = polygon([(0, 0), (4, 0), (4, 1), (2, 1), (2, 3), (0, 3)], "L")
Pixel = tuple[int, int, int]


def run_page(folder: Path, pslg: Pslg = L_SHAPE, construction: ConstructionName = "repaired") -> str:
    """Write the page of a run with its steps; return its address."""
    document = document_of(subject_of_run(Run(pslg, construction), "a title", True))
    return page_file(folder, document)


def page_file(folder: Path, document: Any) -> str:
    """Write the page of a document; return its address."""
    path = folder / "page.html"
    path.write_text(viewer_page(document), encoding="utf-8")
    return path.as_uri()


def grid_mesh(side: int) -> Mesh:
    """Return 2 side^2 triangles on a lattice whose points are moved a little, by a rule."""
    points = [Point(mpq(97 * i + (31 * i * j + 7 * j) % 41, 97), mpq(97 * j + (17 * i + 29 * i * j) % 43, 97))
              for j in range(side + 1) for i in range(side + 1)]
    faces = []
    for j in range(side):
        for i in range(side):
            a = j * (side + 1) + i
            b, c, d = a + 1, a + side + 1, a + side + 2
            faces += [(a, b, d), (a, d, c)]
    return Mesh("proper", tuple(points), tuple(faces))


def picture(page: Any, canvas: str = "top") -> Image.Image:
    """Return the pixels of one of the drawing's canvases after its next frame."""
    data = page.evaluate("""name => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(
        () => done(document.querySelector(`canvas.${name}`).toDataURL()))))""", canvas)
    return Image.open(io.BytesIO(base64.b64decode(data.partition(",")[2]))).convert("RGBA")


def place_of(page: Any, vertex: int) -> tuple[float, float]:
    """Return where a vertex of the mesh is drawn, in pixels of the drawing."""
    x, y = page.evaluate("""v => [viewer.view.camera.toScreenX(viewer.scene.x[v]),
                                  viewer.view.camera.toScreenY(viewer.scene.y[v])]""", vertex)
    return x, y


def colour_of(page: Any, name: str) -> Pixel:
    """Return a colour of the style sheet."""
    look_up = "name => getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim()"
    text = page.evaluate(look_up, name)
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def camera(page: Any, view: str = "viewer.view") -> dict[str, float]:
    """Return the camera's place and scale."""
    found: dict[str, float] = page.evaluate(f"(({{x, y, scale}}) => ({{x, y, scale}}))({view}.camera)")
    return found


def near(pixel: tuple[int, ...], colour: Pixel, tolerance: int = 24) -> bool:
    """Return whether a pixel is of a colour, and not transparent."""
    return pixel[3] > 100 and all(abs(a - b) <= tolerance for a, b in zip(pixel, colour, strict=False))


def differ(a: Image.Image, b: Image.Image) -> bool:
    """Return whether any pixel differs."""
    return ImageChops.difference(a, b).getbbox(alpha_only=False) is not None
