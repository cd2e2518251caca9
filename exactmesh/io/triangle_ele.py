"""Read and write Triangle's `.ele` with its `.node` (Shewchuk, https://www.cs.cmu.edu/~quake/triangle.ele.html).

    .node       <count> [2] [attributes] [markers 0/1]      <index> <x> <y> [attributes] [marker]
    .ele        <count> [3 or 6] [attributes]               <index> <corner> <corner> <corner> [...]

Of triangles with six nodes the corners, which come first, are read.
"""

from collections.abc import Callable

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.triangle_poly import Lines, node_lines, points_from_node
from exactmesh.planar.mesh import Mesh

Faces = tuple[tuple[int, ...], ...]


def triangles_from_ele(ele: str, node_text: Callable[[], str]) -> tuple[tuple[Point, ...], Faces]:
    """Return the vertices in a `.node` text and the triangles in an `.ele` text, as they are written.

    Raises `FormatError` naming the line.
    """
    vertices, first = points_from_node(node_text)
    lines = Lines(ele)
    given = lines.header("triangles", 3)
    count, size, attributes = given + [3, 0][len(given) - 1 :]
    if size not in (3, 6):
        raise FormatError(lines.place(), f"a triangle has 3 or 6 nodes, not {size}")
    faces = tuple(tuple(lines.index(token, first, len(vertices)) for token in tokens[1:4])
                  for tokens in lines.records("triangles", count, 1 + size, 1 + size + attributes))
    lines.finish()
    return tuple(vertices), faces


def ele_from_mesh(mesh: Mesh) -> tuple[str, str]:
    """Return the texts of an `.ele` and a `.node` file.

    Raises `FormatError` when a coordinate is no finite decimal, `InputError` when a face has more than three vertices.
    """
    for number, face in enumerate(mesh.faces):
        if len(face) != 3:
            raise InputError(f"face {number} has {len(face)} vertices: .ele holds triangles with three: mesh with "
                             "--kind proper")
    lines = [f"{len(mesh.vertices)} 2 0 0", *node_lines("vertices", mesh.vertices)]
    faces = [f"{len(mesh.faces)} 3 0", *(f"{i} {a} {b} {c}" for i, (a, b, c) in enumerate(mesh.faces))]
    return "\n".join(faces) + "\n", "\n".join(lines) + "\n"
