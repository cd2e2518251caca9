"""Read a mesh in any format as it is written: vertices and faces in the file's order, to be measured elsewhere."""

import os
from typing import Literal

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.cgshop import is_solution, mesh_from_solution
from exactmesh.io.mesh_json import mesh_from_value
from exactmesh.io.meshio_mesh import faces_from_meshio
from exactmesh.io.read import blaming, bytes_at, read_bytes
from exactmesh.io.strict_json import parse_json
from exactmesh.io.text import printable, text_from_bytes
from exactmesh.io.triangle_ele import Faces, triangles_from_ele
from exactmesh.planar.pslg import Pslg

_OURS = b'"exactmesh-mesh/'
_SOLUTION = b'"CG_SHOP_2025_Solution"'
# Files of other programs with these names have faces; what others hold, a PSLG or not, is for its reader to say.
_MESHES = (".ele", ".msh", ".vtu", ".vtk", ".obj", ".off", ".stl", ".ply", ".mesh", ".inp", ".xdmf")


def holds_mesh(path: str) -> Literal["ours", "foreign", ""]:
    """Return whether a file is a mesh: exactmesh-mesh/1, of another program, or (empty) none, as far as one can tell.

    Raises `InputError` when it cannot be read.
    """
    data = read_bytes(path)
    if _OURS in data:
        return "ours"
    return "foreign" if _SOLUTION in data or os.path.splitext(path)[1].lower() in _MESHES else ""


def read_faces(path: str, pslg: Pslg | None = None) -> tuple[tuple[Point, ...], Faces]:
    """Return the vertices and faces of exactmesh-mesh/1, Triangle's `.ele`, a CG:SHOP solution or a file for meshio.

    The vertices of an `.ele` file are in the `.node` file beside it; those of a solution begin with those of `pslg`.
    Raises `InputError` when the file cannot be read, `FormatError` when it is not what its name says.
    """
    extension = os.path.splitext(path)[1].lower()
    with blaming(path):
        if extension in (".ele", ".node"):
            node = os.path.splitext(path)[0] + ".node"

            def node_text() -> str:
                try:
                    return text_from_bytes(bytes_at(node))
                except InputError as error:
                    raise InputError(f"the vertices are in {printable(node)}: {error}") from error

            return triangles_from_ele(text_from_bytes(bytes_at(os.path.splitext(path)[0] + ".ele")), node_text)
        data = bytes_at(path)
        if data.lstrip()[:1] == b"{" or extension == ".json" or path == "-":
            value = parse_json(text_from_bytes(data))
            if not is_solution(value):
                mesh = mesh_from_value(value)
            elif pslg is None:
                raise FormatError("", "a CG:SHOP solution says nothing without its instance")
            else:
                mesh = mesh_from_solution(value, pslg)
            return mesh.vertices, mesh.faces
        return faces_from_meshio(path)
