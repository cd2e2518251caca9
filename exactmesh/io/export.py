"""Write PSLGs and meshes in other formats, chosen by the extension, and say what rounding does to them.

A format holds fractions, finite decimals or doubles. Coordinates that it cannot hold are rounded first, and the
feature size of what is written is measured exactly.
"""

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from gmpy2 import mpq

from exactmesh.errors import InputError
from exactmesh.io.cgshop import instance_from_pslg, solution_from_mesh
from exactmesh.io.decimals import nearest_decimal, nearest_double, rounded
from exactmesh.io.dxf import dxf_from_pslg
from exactmesh.io.geo_interface import wkb_from_pslg
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.meshio_mesh import extensions, meshio_from_mesh
from exactmesh.io.parts_text import geojson_from_mesh, geojson_from_pslg, wkt_from_pslg
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.svg_path import svg_from_pslg
from exactmesh.io.triangle_ele import ele_from_mesh
from exactmesh.io.triangle_poly import poly_from_pslg
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg


def _exact(value: mpq) -> mpq:
    return value


@dataclass(frozen=True, slots=True)
class Written:
    """Files to be written, by extension, and how many of the vertices and holes had to be rounded."""

    files: Mapping[str, bytes]
    rounded: int


@dataclass(frozen=True, slots=True)
class _Format:
    nearest: Callable[[mpq], mpq]
    write: Callable[[Pslg], str | bytes]


_GRAPHS = {
    ".json": _Format(_exact, json_from_pslg), ".poly": _Format(nearest_decimal, poly_from_pslg),
    ".geojson": _Format(nearest_decimal, geojson_from_pslg), ".wkt": _Format(nearest_decimal, wkt_from_pslg),
    ".svg": _Format(nearest_decimal, svg_from_pslg), ".wkb": _Format(nearest_double, wkb_from_pslg),
    ".dxf": _Format(nearest_double, dxf_from_pslg), ".cgshop": _Format(_exact, instance_from_pslg),
}


def export_pslg(pslg: Pslg, extension: str) -> tuple[Written, Pslg]:
    """Return a PSLG in the format of an extension, and the PSLG that is in it, which differs when it was rounded.

    Raises `InputError` for an unknown extension, and what the writers raise.
    """
    found = _GRAPHS.get(extension)
    if found is None:
        raise InputError(f"a PSLG is written as {', '.join(_GRAPHS)}, not {extension or 'a file without extension'}")
    held = replace(pslg, vertices=rounded(pslg.vertices, found.nearest), holes=rounded(pslg.holes, found.nearest))
    changed = sum(map(tuple.__ne__, pslg.vertices + pslg.holes, held.vertices + held.holes))
    return Written({extension: _bytes(found.write(held))}, changed), held


def export_mesh(mesh: Mesh, pslg: Pslg | None, extension: str) -> tuple[Written, Mesh]:
    """Return a mesh in the format of an extension, and the mesh that is in it, which differs when it was rounded.

    `.ele` comes with `.node`. A CG:SHOP solution, `.cgshop`, is of the instance `pslg`, and GeoJSON has a polygon for
    each face. Raises `InputError` for an unknown extension, and what the writers raise.
    """
    if extension == ".json":
        return Written({extension: _bytes(json_from_mesh(mesh))}, 0), mesh
    if extension == ".cgshop":
        if pslg is None:
            raise InputError("a CG:SHOP solution is of an instance: give it with --pslg")
        return Written({extension: _bytes(solution_from_mesh(mesh, pslg))}, 0), mesh
    if extension in (".ele", ".node", ".geojson"):
        held = replace(mesh, vertices=rounded(mesh.vertices, nearest_decimal))
        if extension == ".geojson":
            files = {extension: _bytes(geojson_from_mesh(held))}
        else:
            ele, node = ele_from_mesh(held)
            files = {".ele": _bytes(ele), ".node": _bytes(node)}
    elif extension in extensions():
        held = replace(mesh, vertices=rounded(mesh.vertices, nearest_double))
        files = {extension: meshio_from_mesh(held, extension)}
    else:
        known = ", ".join((".json", ".cgshop", ".ele", ".geojson", *extensions()))
        raise InputError(f"a mesh is written as {known}, not {extension or 'a file without extension'}")
    return Written(files, sum(map(tuple.__ne__, mesh.vertices, held.vertices))), held


def extension_of(path: str, given: str | None) -> str:
    """Return the extension that names the format: the one given, or that of the path, in small letters."""
    return ("." + given.lstrip(".") if given else os.path.splitext(path)[1]).lower()


def _bytes(content: str | bytes) -> bytes:
    return content.encode() if isinstance(content, str) else content
