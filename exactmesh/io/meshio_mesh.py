"""Meshes in the files that meshio reads and writes: VTU, VTK, OBJ, OFF, STL, gmsh and others. Needs meshio.

Points are doubles, taken at their exact value, in the plane z = 0. Faces are triangles, or polygons where vertices lie
on their sides; lines and points in a file are its boundary marks and no faces, and are skipped.
"""

import contextlib
import io
import tempfile
from pathlib import Path
from typing import Any

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.library import library
from exactmesh.io.triangle_ele import Faces
from exactmesh.numbers.rational import rational_from_float
from exactmesh.planar.mesh import Mesh

# Formats of meshio with cells of any number of corners.
POLYGONS = (".vtu", ".vtk", ".obj")
_SKIPPED = ("vertex", "line", "line3")


def extensions() -> tuple[str, ...]:
    """Return the extensions of files that meshio knows."""
    return tuple(library("meshio", "formats").extension_to_filetypes)


def faces_from_meshio(path: str) -> tuple[tuple[Point, ...], Faces]:
    """Return the vertices on a face and the faces of a file, as they are written.

    Raises `InputError` when meshio cannot read it, or it has points outside the plane z = 0 or other cells.
    """
    meshio = library("meshio", "formats")
    try:
        with contextlib.redirect_stdout(io.StringIO()):  # it prints warnings there
            found = meshio.read(path)
    except (meshio.ReadError, OSError, ValueError, KeyError, IndexError, AssertionError, SystemExit) as error:
        raise InputError(f"meshio cannot read it: {str(error) or type(error).__name__}") from None
    faces: list[tuple[int, ...]] = []
    for block in found.cells:
        if block.type in ("triangle", "quad", "polygon"):
            faces += [tuple(map(int, cell)) for cell in block.data]
        elif block.type not in _SKIPPED:
            raise FormatError("", f"cells of type {block.type} are no faces of a plane mesh")
    if not faces:
        raise FormatError("", "there are no triangles in it")
    vertices = tuple(_point(row, index) for index, row in enumerate(found.points))
    if not all(0 <= v < len(vertices) for face in faces for v in face):
        raise FormatError("", "a face has a vertex that does not exist")
    return vertices, tuple(faces)


def meshio_from_mesh(mesh: Mesh, extension: str) -> bytes:
    """Return a file of the format that an extension, such as `.vtu`, names; coordinates are written as doubles.

    Raises `InputError` when meshio refuses, or a face has vertices on its sides and the format has triangles only.
    """
    meshio = library("meshio", "formats")
    sizes = sorted({len(face) for face in mesh.faces})
    if sizes != [3] and extension not in POLYGONS:
        raise InputError(f"{extension} holds triangles with three vertices only: mesh with --kind proper, or write "
                         f"{', '.join(POLYGONS)}")
    blocks = [("triangle" if size == 3 else "polygon", [face for face in mesh.faces if len(face) == size])
              for size in sizes]
    made = meshio.Mesh([(float(p.x), float(p.y), 0.0) for p in mesh.vertices], blocks)
    with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):  # it prints warnings there
        path = Path(folder, "mesh" + extension)
        try:
            meshio.write(path, made)
        except (meshio.WriteError, KeyError, ValueError, IndexError) as error:
            raise InputError(f"meshio cannot write {extension}: {error}") from None
        return path.read_bytes()


def _point(row: Any, index: int) -> Point:
    if any(float(z) != 0 for z in row[2:]):
        raise FormatError(f"point {index}", "lies outside the plane z = 0")
    return Point(*(rational_from_float(float(value), f"point {index}") for value in row[:2]))
