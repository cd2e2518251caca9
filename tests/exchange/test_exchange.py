"""Formats of others: what is written is read back as the same thing, by us and by the real libraries."""

import json
import math
from pathlib import Path

import ezdxf
import families
import geopandas
import meshio
import pytest
import shapely
import shapely.geometry
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from exactmesh.api import mesh
from exactmesh.errors import FormatError, GeometryError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.decimals import decimal_of, nearest_decimal, nearest_double, rounded
from exactmesh.io.export import export_mesh, export_pslg
from exactmesh.io.geo_interface import geo_from_pslg, pslg_from_geo, pslg_from_wkb
from exactmesh.io.parts import parts_of
from exactmesh.io.read import read_pslg
from exactmesh.io.read_faces import read_faces
from exactmesh.io.svg_path import pslg_from_svg
from exactmesh.measure.foreign import measure_foreign, pslg_mfs
from exactmesh.planar.faces import domain_of, doubled_walk_area
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg, polygon

SQUARE = polygon([(0, 0), (8, 0), (8, 8), (0, 8)])
RING = Pslg(SQUARE.vertices + polygon([(2, 2), (2, 5), (5, 5), (5, 2)]).vertices,
            (*SQUARE.edges, (4, 5), (5, 6), (6, 7), (7, 4)), (Point(mpq(3), mpq(3)),))
# A hole that touches the outside at a vertex, a dangling edge, an edge in the hole, isolated vertices in and out.
MIXED = Pslg(tuple(Point(mpq(x), mpq(y)) for x, y in (
    (0, 0), (8, 0), (8, 8), (0, 8), (4, 2), (2, 4), (6, 7), (7, 7), (1, 5), (20, 20), (2, 2), ("5/2", "5/2"))),
    ((0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (4, 5), (5, 0), (2, 6), (10, 11)), (Point(mpq(3, 2), mpq(3, 2)),))
GRAPHS = {"square": SQUARE, "ring": RING, "mixed": MIXED}


def normal(pslg: Pslg) -> tuple[object, ...]:
    """Return what two PSLGs share that differ in the order of vertices and edges, the name and the hole points."""
    domain = domain_of(pslg)
    area = sum(doubled_walk_area(pslg, domain.half_edges, walk) for face in domain.domain for walk in face.walks)
    return (sorted(pslg.vertices), sorted(sorted((pslg.vertices[u], pslg.vertices[v])) for u, v in pslg.edges),
            len(domain.domain), area)


def back(pslg: Pslg, extension: str, folder: Path) -> Pslg:
    written, held = export_pslg(pslg, extension)
    path = folder / ("graph" + (".json" if extension == ".cgshop" else extension))
    path.write_bytes(written.files[extension])
    assert held == pslg or written.rounded
    return read_pslg(str(path)).pslg


@pytest.mark.parametrize("extension", [".json", ".poly", ".geojson", ".wkt", ".svg", ".wkb", ".dxf"])
@pytest.mark.parametrize("name", GRAPHS)
def test_graphs_are_read_back(name: str, extension: str, tmp_path: Path) -> None:
    pslg = GRAPHS[name]
    if name == "mixed" and extension in (".svg",):
        with pytest.raises(FormatError, match="on no edge"):
            export_pslg(pslg, extension)
        pslg = Pslg(pslg.vertices[:7] + pslg.vertices[10:], (*pslg.edges[:8], (7, 8)), pslg.holes)
    assert normal(back(pslg, extension, tmp_path)) == normal(pslg)


@pytest.mark.parametrize("kind", ["star", "growth", "partition"])
@pytest.mark.parametrize("extension", [".poly", ".geojson", ".wkt", ".svg", ".wkb", ".dxf", ".cgshop"])
def test_random_polygons_are_read_back(kind: str, extension: str, tmp_path: Path) -> None:
    pslg = families.random_simple_polygon(30, 5, kind)
    scale = math.lcm(*(int(value.denominator) for p in pslg.vertices for value in p))
    pslg = Pslg(tuple(Point(p.x * scale, p.y * scale) for p in pslg.vertices), pslg.edges)
    read = back(pslg, extension, tmp_path)
    assert normal(read) == normal(pslg)


def test_parts_of_a_face_that_touches_itself() -> None:
    parts = parts_of(MIXED)
    (exterior, hole), = parts.polygons
    assert set(exterior) == {0, 1, 2, 3} and set(hole) == {0, 4, 5}
    assert set(parts.lines) == {(2, 6), (10, 11)} and parts.points == (7, 8, 9)


def test_shapely_and_geopandas_see_the_same() -> None:
    shape = shapely.geometry.shape(geo_from_pslg(RING))
    assert shape.is_valid and shape.area == 64 - 9
    assert normal(pslg_from_geo(shape)) == normal(RING)
    frame = geopandas.GeoDataFrame(geometry=[shape])
    assert normal(pslg_from_geo(frame)) == normal(RING)
    assert normal(pslg_from_wkb(shapely.to_wkb(shape))) == normal(RING)
    assert normal(pslg_from_wkb(shapely.to_wkb(shape, hex=True).encode())) == normal(RING)
    tenth = shapely.geometry.Polygon([(0.1, 0), (1, 0), (0, 1)])
    assert pslg_from_geo(tenth).vertices[0].x == mpq(*(0.1).as_integer_ratio()) != mpq(1, 10)
    with pytest.raises(FormatError, match=r"not a|finite"):
        pslg_from_geo({"type": "Point", "coordinates": (math.nan, 0.0)})
    with pytest.raises(FormatError, match="not WKB"):
        pslg_from_wkb(b"\1nonsense")
    with pytest.raises(FormatError, match="empty"):
        pslg_from_wkb(shapely.to_wkb(shapely.Point()))


@given(st.fractions(max_denominator=10**30), st.integers(-40, 40))
def test_rounding_is_to_the_nearest(value: object, exponent: int) -> None:
    exact = mpq(value) * mpq(10) ** exponent
    decimal = nearest_decimal(exact)
    assert mpq(decimal_of(decimal)) == decimal
    assert abs(decimal - exact) <= abs(exact) * mpq(1, 10**16)
    assert nearest_decimal(decimal) == decimal
    assert nearest_double(exact) == mpq(*float(exact).as_integer_ratio())


def test_what_a_format_cannot_hold() -> None:
    with pytest.raises(FormatError, match="beyond the range"):
        nearest_double(mpq(10) ** 400)
    with pytest.raises(FormatError, match="v: 1/3 is no finite decimal"):
        decimal_of(mpq(1, 3), "v")
    third = polygon([(0, 0), ("1/3", 0), (0, 1)])
    with pytest.raises(InputError, match=r"vertex 1 .* integer"):
        export_pslg(third, ".cgshop")
    with pytest.raises(InputError, match="one simple polygon"):
        export_pslg(RING, ".cgshop")
    with pytest.raises(InputError, match=r"a PSLG is written as \.json"):
        export_pslg(SQUARE, ".doc")
    with pytest.raises(InputError, match=r"a mesh is written as \.json"):
        export_mesh(mesh(SQUARE).mesh, None, ".doc")
    with pytest.raises(InputError, match="with --pslg"):
        export_mesh(mesh(SQUARE).mesh, None, ".cgshop")
    with pytest.raises(GeometryError):
        export_pslg(polygon([(0, 0), (1, 1), (1, 0), (0, 1)]), ".wkt")


@pytest.mark.parametrize("extension", [".poly", ".geojson", ".wkt", ".svg", ".wkb", ".dxf"])
def test_rounding_is_told_and_measured(extension: str, tmp_path: Path) -> None:
    third = polygon([(0, 0), ("1/3", 0), ("1/3", "1/7"), (0, 1)])
    written, held = export_pslg(third, extension)
    assert written.rounded == 2 and held.vertices[0] == third.vertices[0]
    moved = list(zip(held.vertices, third.vertices, strict=True))[1:3]
    assert all(0 < abs(a.x - b.x) < mpq(1, 10**16) for a, b in moved)
    path = tmp_path / ("file" + extension)
    path.write_bytes(written.files[extension])
    assert normal(read_pslg(str(path)).pslg) == normal(held)
    before, after = pslg_mfs(third).nearest, pslg_mfs(held).nearest
    assert before and after and before.squared != after.squared


@pytest.mark.parametrize("text, message", [
    ("<svg><path d='M0 0C1 1 2 2 3 3'/></svg>", "C is not a straight line"),
    ("<svg><path d='M0 0L1'/></svg>", "followed by 2 numbers"),
    ("<svg><path d='5 5'/></svg>", "a command is expected"),
    ("<svg><path d='Z'/></svg>", "Z without a subpath"),
    ("<svg><g transform='scale(2)'/></svg>", r"svg/g\[0\]: a transform"),
    ("<svg><circle r='1'/></svg>", "circle is not made"),
    ("<svg><rect width='2' height='2' rx='1'/></svg>", "round corners"),
    ("<svg><rect width='2em' height='2'/></svg>", "@width: '2em' is not a finite decimal"),
    ("<svg><polygon points='1 2 3'/></svg>", "even number"),
    ("<svg><polygon points='0 0 1 1'/></svg>", "three distinct"),
    ("<svg", "not XML"), ("<html/>", "'html', not svg"), ("<svg/>", "no geometry"),
    ("<!DOCTYPE svg [<!ENTITY a 'b'>]><svg/>", "entities"),
])
def test_what_svg_refuses(text: str, message: str) -> None:
    with pytest.raises(FormatError, match=message):
        pslg_from_svg(text)


def test_svg_shapes() -> None:
    read = pslg_from_svg("""<?xml version="1.0"?><svg xmlns="http://www.w3.org/2000/svg"><!-- y points down -->
        <defs><path d="M0 0C1 1 1 1 1 1"/></defs><text>word</text>
        <g><rect x="0" y="0" width="8px" height="8"/></g>
        <path d="m10,0 h8v8h-8z m2,2l3,0 0,3-3,0z M30 0 H31"/>
        <line x1="40" x2="41.5" y2="1e1"/><polyline points="50,0 51,0 51,1"/></svg>""")
    assert Point(mpq(83, 2), mpq(-10)) in read.vertices
    domain = domain_of(read)
    assert sum(doubled_walk_area(read, domain.half_edges, walk) for face in domain.domain for walk in face.walks) == (
        2 * (64 + 64 - 9))
    assert len(read.edges) == 4 + 8 + 1 + 1 + 2


def test_dxf_by_ezdxf(tmp_path: Path) -> None:
    document = ezdxf.new()
    space = document.modelspace()
    space.add_lwpolyline([(0, 0), (8, 0), (8, 8), (0, 8)], close=True)
    space.add_polyline2d([(2, 2), (5, 2), (5, 5), (2, 5)], close=True)
    space.add_point((3, 3), dxfattribs={"layer": "hole"})
    space.add_text("skipped")
    path = tmp_path / "plan.dxf"
    document.saveas(path)
    assert normal(read_pslg(str(path)).pslg) == normal(RING)
    for add, message in ((lambda: space.add_circle((0, 0), 1), "CIRCLE .* straight"),
                         (lambda: space.add_lwpolyline([(0, 0, 1), (1, 1, 0)], format="xyb"), "bulge")):
        entity = add()
        document.saveas(path)
        with pytest.raises(FormatError, match=message):
            read_pslg(str(path))
        space.delete_entity(entity)
    path.write_text("0\nSECTION\nnonsense\n")
    with pytest.raises(InputError, match=r"plan\.dxf"):
        read_pslg(str(path))


def made(pslg: Pslg, kind: str = "proper") -> Mesh:
    return mesh(pslg, kind=kind).mesh  # type: ignore[arg-type]


@pytest.mark.parametrize("extension", [".vtu", ".vtk", ".obj", ".off", ".msh", ".ele", ".cgshop", ".json"])
def test_meshes_are_read_back(extension: str, tmp_path: Path) -> None:
    original = made(RING if extension != ".cgshop" else SQUARE)
    given_pslg = SQUARE if extension == ".cgshop" else RING
    written, held = export_mesh(original, given_pslg, extension)
    assert len(held.faces) == len(original.faces)
    for kind, data in written.files.items():
        path = tmp_path / ("mesh" + (".json" if kind == ".cgshop" else kind))
        path.write_bytes(data)
    vertices, faces = read_faces(str(path), given_pslg)
    measured = measure_foreign(domain_of(given_pslg), vertices, faces)
    exact = measure_foreign(domain_of(given_pslg), held.vertices, held.faces)
    assert measured.verification.valid == exact.verification.valid and measured.missing == ()
    assert measured.graph.nearest and exact.graph.nearest
    assert measured.graph.nearest.squared == exact.graph.nearest.squared
    if extension in (".cgshop", ".json"):
        assert measured.verification.valid
    if extension in (".vtu", ".vtk", ".obj", ".off", ".msh"):
        cells = sum(len(block.data) for block in meshio.read(tmp_path / ("mesh" + extension)).cells)
        assert cells == len(original.faces)


def test_polygons_where_vertices_lie_on_sides(tmp_path: Path) -> None:
    comb = families.comb(6)
    original = made(comb, "nonproper")
    assert any(len(face) > 3 for face in original.faces)
    for extension in (".ele", ".off", ".msh"):
        with pytest.raises(InputError, match="--kind proper"):
            export_mesh(original, None, extension)
    for extension in (".vtu", ".obj"):
        written, held = export_mesh(original, None, extension)
        path = tmp_path / ("mesh" + extension)
        path.write_bytes(written.files[extension])
        vertices, faces = read_faces(str(path))
        assert sorted(len(face) for face in faces) == sorted(len(face) for face in original.faces)
        assert set(vertices) == set(held.vertices)


def test_what_read_faces_refuses(tmp_path: Path) -> None:
    solid = meshio.Mesh([(0.0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [("tetra", [[0, 1, 2, 3]])])
    tilted = meshio.Mesh([(0.0, 0, 0), (1, 0, 0), (0, 1, 1)], [("triangle", [[0, 1, 2]])])
    for number, (bad, message) in enumerate(((solid, "type tetra"), (tilted, "outside the plane"))):
        path = tmp_path / f"{number}.vtu"
        meshio.write(path, bad)
        with pytest.raises(FormatError, match=message):
            read_faces(str(path))
    (tmp_path / "x.msh").write_text("nonsense")
    with pytest.raises(InputError, match="meshio cannot read it"):
        read_faces(str(tmp_path / "x.msh"))
    (tmp_path / "s.json").write_text(json.dumps({"content_type": "CG_SHOP_2025_Solution", "steiner_points_x": [],
                                                 "steiner_points_y": [], "edges": [[0, 9]]}))
    with pytest.raises(FormatError, match="without its instance"):
        read_faces(str(tmp_path / "s.json"))
    with pytest.raises(FormatError, match="vertex 9 does not exist"):
        read_faces(str(tmp_path / "s.json"), SQUARE)
    (tmp_path / "t.ele").write_text("1 3 0\n0 0 1 2\n")
    with pytest.raises(InputError, match=r"the vertices are in .*t\.node: no such file"):
        read_faces(str(tmp_path / "t.ele"))
    (tmp_path / "t.node").write_text("3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n")
    with pytest.raises(FormatError, match="vertex 0 does not exist"):
        read_faces(str(tmp_path / "t.ele"))
    (tmp_path / "t.ele").write_text("1 3 0\n1 1 2 3\n")
    assert read_faces(str(tmp_path / "t.ele"))[1] == ((0, 1, 2),)


@pytest.mark.parametrize("change, message", [
    ({"region_boundary": [0, 1]}, "three distinct"), ({"region_boundary": [0, 1, 7]}, "vertex 7 does not exist"),
    ({"points_y": [0]}, "3 numbers are expected"), ({"additional_constraints": [[0, 0]]}, "an edge needs two"),
    ({"instance_uid": 5}, "a string is expected"),
])
def test_what_an_instance_refuses(change: dict[str, object], message: str, tmp_path: Path) -> None:
    instance = {"instance_uid": "t", "num_points": 3, "points_x": [0, 4, 0], "points_y": [0, 0, 4],
                "region_boundary": [0, 1, 2], "num_constraints": 0, "additional_constraints": []}
    path = tmp_path / "i.json"
    path.write_text(json.dumps(instance))
    assert read_pslg(str(path)).pslg.vertices[1] == Point(mpq(4), mpq(0))
    path.write_text(json.dumps(instance | change))
    with pytest.raises(FormatError, match=message):
        read_pslg(str(path))


@settings(max_examples=25, deadline=None)
@given(st.integers(3, 12), st.integers(0, 10**6), st.sampled_from([".wkb", ".geojson", ".dxf", ".svg", ".poly"]))
def test_what_is_rounded_stays_near(tmp_path_factory: pytest.TempPathFactory, count: int, seed: int, extension: str
                                    ) -> None:
    pslg = families.random_simple_polygon(count, seed, "star")
    pslg = Pslg(tuple(Point(p.x / 3, p.y / 7) for p in pslg.vertices), pslg.edges)
    nearest = nearest_double if extension in (".wkb", ".dxf") else nearest_decimal
    expected = Pslg(rounded(pslg.vertices, nearest), pslg.edges)
    if pslg_mfs(expected).crossing:
        return
    assert normal(back(pslg, extension, tmp_path_factory.mktemp("r"))) == normal(expected)
