"""Pictures: well-formed whatever the name and the coordinates, with everything in its place."""

import re
import xml.etree.ElementTree as ET
from fractions import Fraction

import families
import pytest
from constructions import HALL, graph
from gmpy2 import mpq

from exactmesh.api import Meshing, mesh, verify
from exactmesh.io.svg import svg_from_mesh
from exactmesh.numbers.rational import sqrt_text
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg

SVG = "{http://www.w3.org/2000/svg}"
SQUARE = graph([(0, 0), (4, 0), (4, 4), (0, 4)])
INPUTS = {"square": SQUARE, "hall": HALL} | {name: (families.ALL_SMALL | families.SMALL_PSLGS)[name] for name in (
    "triangle", "tiny", "huge", "far away", "30 digits", "sliver with bends", "convex spike 1e-6", "random pslg 1",
    "square and two points", "two squares")}


def picture(pslg: Pslg, result: Meshing | None = None) -> ET.Element:
    result = result or mesh(pslg)
    return ET.fromstring(svg_from_mesh(pslg, result.mesh, result.verification))


def of_class(root: ET.Element, name: str) -> list[ET.Element]:
    return [element for element in root.iter() if element.get("class") == name]


def named(name: str) -> Pslg:
    return Pslg(SQUARE.vertices, SQUARE.edges, name=name)


@pytest.mark.parametrize("name", INPUTS)
def test_pictures_are_well_formed_and_finite(name: str) -> None:
    pslg = INPUTS[name]
    result = mesh(pslg)
    text = svg_from_mesh(pslg, result.mesh, result.verification)
    root = ET.fromstring(text)
    assert root.tag == f"{SVG}svg" and text.endswith("</svg>\n")
    assert not re.search(r"\b(nan|inf)\b", text, re.IGNORECASE)
    left, low, width, height = map(float, root.attrib["viewBox"].split())
    assert (left, low) == (0, 0) and 0 < width <= 1040.01 and 0 < height <= 1070.01
    numbers = [float(x) for path in root.iter(f"{SVG}path") for x in re.findall(r"-?\d+\.\d+", path.attrib["d"])]
    assert numbers and min(numbers) >= 0 and max(numbers) <= max(width, height)


@pytest.mark.parametrize("name", INPUTS)
def test_vertices_edges_and_faces_are_all_drawn(name: str) -> None:
    pslg = INPUTS[name]
    result = mesh(pslg)
    root = picture(pslg, result)
    assert len(of_class(root, "given")) == len(pslg.vertices)
    assert len(of_class(root, "steiner")) == len(result.mesh.vertices) - len(pslg.vertices)
    faces, edges = of_class(root, "faces")
    assert faces.attrib["d"].count("Z") == len(result.mesh.faces)
    sides = {frozenset((f[i - 1], f[i])) for f in result.mesh.faces for i in range(len(f))}
    assert edges.attrib["d"].count("M") == len(sides)
    (given,) = of_class(root, "input")
    assert given.attrib["d"].count("M") == len(pslg.edges)


@pytest.mark.parametrize("name", INPUTS)
def test_both_witnesses_are_drawn_with_their_distances(name: str) -> None:
    pslg = INPUTS[name]
    result = mesh(pslg)
    root = picture(pslg, result)
    assert len(of_class(root, "witness")) == len(of_class(root, "near")) == 2
    texts = [element.text for element in root.iter(f"{SVG}text")]
    for nearest in (result.verification.input_mfs, result.verification.mesh_mfs):
        assert nearest is not None and sqrt_text(nearest.squared, 6) in texts


def test_the_witness_runs_from_the_vertex_to_the_foot() -> None:
    # An isolated vertex 1 above the floor of a square of side 4, which is drawn 1000 wide.
    root = picture(graph([(0, 0), (4, 0), (4, 4), (0, 4), (2, 1)], SQUARE.edges))
    assert of_class(root, "witness")[0].attrib["d"] == "M520.00 770.00L520.00 1020.00"


def test_y_grows_upwards() -> None:
    root = picture(graph([(0, 0), (4, 0), (0, 2)]))
    assert [(c.attrib["cx"], c.attrib["cy"]) for c in of_class(root, "given")] == [
        ("20.00", "520.00"), ("1020.00", "520.00"), ("20.00", "20.00")]


@pytest.mark.parametrize("name", [
    "a < b & c > d", "]]>", '"quoted" \'twice\'', "<script>alert(1)</script>", "&amp;", "tab\tand\nline", "ß 𝒳 漢",
    "nul \x00 bell \x07 escape \x1b", "lone \ud800 surrogates \udfff", "not characters \ufffe \uffff", "",
])
def test_names_are_escaped(name: str) -> None:
    pslg = named(name)
    result = mesh(pslg)
    text = svg_from_mesh(pslg, result.mesh, result.verification)
    text.encode("utf-8")
    title = ET.fromstring(text).find(f"{SVG}title")
    assert title is not None and title.text is not None
    shown = re.sub("[\x00-\x08\x0b\x0c\x0e-\x1f\ud800-\udfff\ufffe\uffff]", "\ufffd", name)
    assert title.text.startswith(f"{shown}: 10 faces" if name else "10 faces")


def test_large_meshes_have_no_dots() -> None:
    pslg = families.regular_polygon(400)
    corners = [(p.x, p.y) for p in pslg.vertices] + [(Fraction(i, 7000), Fraction(j, 7000))
                                                     for i in range(20) for j in range(20)]
    crowd = Pslg(graph(corners).vertices, pslg.edges)
    many = Mesh("nonproper", crowd.vertices * 3, ())
    root = ET.fromstring(svg_from_mesh(crowd, many, verify(SQUARE, mesh(SQUARE).mesh)))
    assert of_class(root, "given") == of_class(root, "steiner") == []


def test_an_invalid_mesh_is_drawn_without_its_feature_size() -> None:
    bad = Mesh("nonproper", SQUARE.vertices, ((0, 1, 2),))
    verification = verify(SQUARE, bad)
    assert not verification.valid
    root = ET.fromstring(svg_from_mesh(SQUARE, bad, verification))
    assert len(of_class(root, "witness")) == 1
    title = root.find(f"{SVG}title")
    assert title is not None and title.text == "1 faces, 0 Steiner vertices"


def test_the_same_input_gives_the_same_picture_at_any_scale() -> None:
    pslg = families.l_shape(20)
    texts = set()
    for factor in (mpq(1), mpq(2) ** 60, mpq(2) ** -60):
        scaled = families.scaled(pslg, factor)
        result = mesh(scaled)
        text = svg_from_mesh(Pslg(scaled.vertices, scaled.edges), result.mesh, result.verification)
        texts.add(re.sub(r"<text[^>]*>[^<]*</text>", "", text))
    assert len(texts) == 1
