"""Pictures of inputs and meshes: well-formed whatever the name and the coordinates, with everything in its place."""

import re
from fractions import Fraction
from itertools import pairwise

import families
import pytest
from constructions import HALL, graph, point
from drawn import count, one, panels, paths, root_of, texts
from gmpy2 import mpq

from exactmesh.api import Meshing, mesh, verify
from exactmesh.errors import InputError
from exactmesh.numbers.rational import sqrt_text
from exactmesh.pictures.draw import picture_of_faces, picture_of_input, picture_of_mesh, picture_of_run, svg_from_mesh
from exactmesh.pictures.palette import FEATURE_FILLS, MAKERS, tint
from exactmesh.pictures.svg import svg_text
from exactmesh.pictures.view import view_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])
INPUTS = {"square": SQUARE, "hall": HALL} | {name: (families.ALL_SMALL | families.SMALL_PSLGS)[name] for name in (
    "triangle", "tiny", "huge", "far away", "30 digits", "sliver with bends", "convex spike 1e-6", "random pslg 1",
    "square and two points", "two squares")}
RESULTS = {name: mesh(pslg) for name, pslg in INPUTS.items()}


def drawn(pslg: Pslg, result: Meshing) -> str:
    return svg_from_mesh(pslg, result.mesh, result.verification)


@pytest.mark.parametrize("name", INPUTS)
def test_pictures_are_well_formed_and_finite(name: str) -> None:
    text = drawn(INPUTS[name], RESULTS[name])
    root = root_of(text)
    assert text.endswith("</svg>\n") and not re.search(r"\b(nan|inf)\b", text, re.IGNORECASE)
    left, low, width, height = map(float, root.attrib["viewBox"].split())
    assert (left, low) == (0, 0) and 0 < width <= 1100 and 0 < height <= 2500
    for panel in panels(root):
        frame = next(element for element in panel if element.get("class") == "frame")
        reach = max(float(frame.attrib["width"]), float(frame.attrib["height"]))
        # Near shapes may stick out of a window, by less than its size on either side.
        places = [z for part in panel.iter() if part.tag.endswith("path") and part.get("class")
                  for path in paths(panel, part.attrib["class"]) for chain in path.chains for place in chain
                  for z in place]
        assert places and -reach - 1 <= min(places) and max(places) <= 2 * reach + 1


@pytest.mark.parametrize("name", INPUTS)
def test_vertices_edges_and_faces_are_all_drawn(name: str) -> None:
    pslg, result = INPUTS[name], RESULTS[name]
    whole = panels(root_of(drawn(pslg, result)))[0]
    assert count(whole, "given") == len(pslg.vertices)
    assert count(whole, "steiner") == len(result.mesh.vertices) - len(pslg.vertices)
    shown = [path for rank in range(len(FEATURE_FILLS)) for path in paths(whole, f"feature-{rank}")]
    assert sum(len(path.chains) for path in shown) == len(result.mesh.faces)
    assert all(len(chain) == 3 for path in shown for chain in path.chains) and all(all(p.closed) for p in shown)
    assert count(whole, "input") == len(pslg.edges) and not any(one(whole, "input").closed)
    on_sides = {v for face in result.mesh.faces for v in oracle_on_sides(result.mesh, face)}
    assert count(whole, "t-vertex") == count(whole, "t-vertex-rim") == len(on_sides)


def oracle_on_sides(made: Mesh, face: tuple[int, ...]) -> list[int]:
    """Return the vertices of a face at which it goes straight on, from the definition."""
    found = []
    for i, v in enumerate(face):
        a, b, c = (made.vertices[u] for u in (face[i - 1], v, face[(i + 1) % len(face)]))
        if (b.x - a.x) * (c.y - b.y) == (b.y - a.y) * (c.x - b.x):
            found.append(v)
    return found


@pytest.mark.parametrize("name", INPUTS)
def test_both_witnesses_are_drawn_with_their_distances(name: str) -> None:
    pslg, result = INPUTS[name], RESULTS[name]
    whole = panels(root_of(drawn(pslg, result)))[0]
    found = result.verification
    assert found.input_mfs is not None and found.mesh_mfs is not None
    for kind, word, nearest in (("input-witness", "input", found.input_mfs), ("witness", "mesh", found.mesh_mfs)):
        (chain,) = one(whole, kind).chains
        assert len(chain) == 2
        assert texts(whole, f"{kind}-label") == [f"mfs of the {word} {sqrt_text(nearest.squared, 6)}"]


def test_a_pair_too_near_to_be_seen_is_shown_again_from_near_by() -> None:
    pslg = families.ALL_SMALL["convex spike 1e-6"]
    result = mesh(pslg)
    root = root_of(drawn(pslg, result))
    whole, *close = panels(root)
    assert len(close) == 2 and count(whole, "witness-circle") == 1
    for panel, kind in zip(close, ("input-witness", "witness"), strict=True):
        ((x0, y0), (x1, y1)) = one(panel, kind).chains[0]
        # An eighth of the panel, which is 500 wide, and in its middle.
        assert 60 < ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5 < 65
        assert abs((x0 + x1) / 2 - 250) < 1 and abs((y0 + y1) / 2 - 250) < 1


def test_the_witness_runs_from_the_vertex_to_the_foot() -> None:
    # An isolated vertex 1 above the floor of a square of side 4, which is drawn 1000 wide, with a margin of 14.
    pslg = graph([(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)], SQUARE.edges)
    root = root_of(drawn(pslg, mesh(pslg)))
    assert one(panels(root)[0], "input-witness").chains == [[(514.0, 764.0), (514.0, 1014.0)]]


def test_y_grows_upwards() -> None:
    root = root_of(svg_text(picture_of_input(graph([(0, 0), (4, 0), (0, 2)]))))
    assert one(root, "given").chains == [[(14.0, 514.0)], [(1014.0, 514.0)], [(14.0, 14.0)]]


def test_isolated_vertices_and_marks_of_holes_are_drawn() -> None:
    root = root_of(svg_text(picture_of_input(HALL)))
    assert count(root, "isolated") == 2 and count(root, "hole") == len(HALL.holes) == 1


def test_faces_have_the_colours_of_their_features() -> None:
    # Triangles of heights 4, 1 and 1/10 in a graph whose mfs is said to be 2.
    points = tuple(point(x, y) for x, y in ((0, 0), (10, 0), (5, 4), (5, -1), (15, "1/10"), (10, -10)))
    made = Mesh("nonproper", points, ((0, 1, 2), (0, 3, 1), (0, 1, 4)))
    found = verify(SQUARE, mesh(SQUARE).mesh)
    assert found.input_mfs is not None and found.input_mfs.squared == 16
    root = root_of(svg_text(picture_of_mesh(Pslg(points, ()), made, found, view=view_of(points))))
    # 4 over 4 is 1; 1 over 4 is a quarter; the height of the third is 10/sqrt(15^2 + 0.1^2) * 1/10, below 4/32.
    assert [rank for rank in range(7) if paths(root, f"feature-{rank}")] == [0, 2, 6]


@pytest.mark.parametrize("name", [
    "a < b & c > d", "]]>", '"quoted" \'twice\'', "<script>alert(1)</script>", "&amp;", "tab\tand\nline", "ß 𝒳 漢",
    "nul \x00 bell \x07 escape \x1b", "lone \ud800 surrogates \udfff", "not characters \ufffe \uffff", "",
])
def test_names_are_escaped(name: str) -> None:
    pslg = Pslg(SQUARE.vertices, SQUARE.edges, name=name)
    text = drawn(pslg, RESULTS["square"])
    text.encode("utf-8")
    title = root_of(text).find("{http://www.w3.org/2000/svg}title")
    assert title is not None and title.text is not None
    shown = re.sub("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]", "\ufffd", name)
    assert title.text.startswith(f"{shown}: 10 faces" if name else "10 faces")


def test_an_invalid_mesh_is_drawn_without_its_feature_size() -> None:
    bad = Mesh("nonproper", SQUARE.vertices, ((0, 1, 2), (0, 2, 1), (0, 1, 9), (2, 2, 3), ()))
    verification = verify(SQUARE, bad)
    assert not verification.valid
    root = root_of(svg_text(picture_of_mesh(SQUARE, bad, verification)))
    (heading,) = texts(root, "heading")
    assert heading == "5 faces, 0 Steiner vertices, not valid"
    assert paths(root, "witness") == [] and len(paths(root, "input-witness")) == 1
    # One triangle, two that are none; a face that names vertex 9 of 4 is left out, and so is one of no vertices.
    assert count(root, "feature-1") == 1 and count(root, "no-triangle") == 2


def test_a_mesh_alone_shows_its_rim() -> None:
    made = RESULTS["hall"].mesh
    root = root_of(svg_text(picture_of_faces(made)))
    sides = [frozenset((f[i - 1], f[i])) for f in made.faces for i in range(len(f))]
    assert count(root, "rim") == sum(sides.count(side) == 1 for side in set(sides))
    assert count(root, "faces") == len(made.faces)


def test_the_same_input_gives_the_same_picture_at_any_scale() -> None:
    pslg = families.l_shape(20)
    found = set()
    for factor in (mpq(1), mpq(2) ** 60, mpq(2) ** -60, mpq(2) ** 2000, mpq(2) ** -2000):
        scaled = families.scaled(pslg, factor)
        bare = Pslg(scaled.vertices, scaled.edges)
        text = svg_text(picture_of_run(mesh(bare).run))
        found.add(re.sub(r"<text[^>]*>[^<]*</text>|<title>[^<]*</title>", "", text))
    assert len(found) == 1


def test_the_bytes_depend_on_the_input_alone() -> None:
    assert drawn(HALL, mesh(HALL)) == drawn(HALL, RESULTS["hall"])


def test_nothing_cannot_be_drawn() -> None:
    with pytest.raises(InputError, match="no vertices"):
        picture_of_input(Pslg((), ()))


def test_many_faces_stay_small_and_thin() -> None:
    # 20,000 triangles of a grid, made by hand: at most 40 bytes each.
    n = 100
    points = tuple(point(i, j) for j in range(n + 1) for i in range(n + 1))
    faces = tuple(face for j in range(n) for i in range(n) for a in [j * (n + 1) + i]
                  for face in ((a, a + 1, a + n + 2), (a, a + n + 2, a + n + 1)))
    made = Mesh("nonproper", points, faces)
    square = graph([(0, 0), (n, 0), (n, n), (0, n)])
    text = svg_text(picture_of_mesh(square, made, verify(SQUARE, mesh(SQUARE).mesh), view=view_of(points)))
    root = root_of(text)
    ranks = [rank for rank in range(7) for _ in paths(root, f"feature-{rank}")]
    assert sum(count(root, f"feature-{rank}") for rank in ranks) == 2 * n * n
    assert len(text) < 40 * len(faces) + 20 * len(points)
    assert 1 < float(one(root, f"feature-{ranks[0]}").attributes["stroke-width"]) < 60  # hundredths of a pixel


def test_colours_are_told_apart() -> None:
    # Light to dark, so that they are in order in grey as well.
    grey = [0.3 * int(c[1:3], 16) + 0.59 * int(c[3:5], 16) + 0.11 * int(c[5:], 16) for c in FEATURE_FILLS]
    assert all(a - b > 8 for a, b in pairwise(grey))
    assert len({MAKERS[m] for m in ("given", "offset", "chord", "interior", "tube")}) == 5
    assert tint("#000000", 1) == "#000000" and tint("#000000", 0) == "#ffffff" and tint("#ff0000", 0.5) == "#ff8080"


def test_fractions_are_places_too() -> None:
    pslg = graph([(0, 0), (str(Fraction(1, 3)), 0), (0, str(Fraction(1, 3)))])
    assert one(root_of(svg_text(picture_of_input(pslg))), "given").chains[1] == [(1014.0, 1014.0)]
