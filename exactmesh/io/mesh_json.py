"""The output format `exactmesh-mesh/1`.

Read here: keys, types, the kind, scalars and index ranges. Not checked: whether the faces are a
triangulation, or have as many vertices as the kind says, which is for the verifier to report.
"""

from collections.abc import Iterator

from exactmesh.errors import FormatError
from exactmesh.io.as_written import mesh_as_written
from exactmesh.io.json_fields import each, fields, point, point_row, row_parts, vertex_index
from exactmesh.io.strict_json import Json, described, parse_json
from exactmesh.planar.mesh import KINDS, Kind, Mesh

FORMAT = "exactmesh-mesh/1"


def mesh_from_json(text: str) -> Mesh:
    """Return the mesh of a file's text; raises `FormatError` naming the place, such as `faces[5][2]`."""
    quick = mesh_as_written(text)
    return mesh_from_value(parse_json(text)) if quick is None else quick


def mesh_from_value(value: Json) -> Mesh:
    """Return the mesh of a parsed file; raises `FormatError` naming the place."""
    found = fields(value, FORMAT, ("kind", "vertices", "faces"))
    kind = _kind(found["kind"])
    vertices = each(found["vertices"], "vertices", point)
    count = len(vertices)
    return Mesh(kind, vertices, each(found["faces"], "faces", lambda face: _face(face, count)))


def json_from_mesh(mesh: Mesh) -> str:
    """Return the text of a file that is read back as the same mesh."""
    return "".join(json_parts_from_mesh(mesh))


def json_parts_from_mesh(mesh: Mesh) -> Iterator[str]:
    """Yield `json_from_mesh` in parts: the text of a large mesh need not be in memory at once."""
    yield f'{{"format": "{FORMAT}",\n "kind": "{mesh.kind}",\n "vertices": '
    yield from row_parts(map(point_row, mesh.vertices))
    yield ',\n "faces": '
    yield from row_parts(f"[{', '.join(map(str, face))}]" for face in mesh.faces)
    yield "}\n"


def _kind(value: Json) -> Kind:
    for kind in KINDS:
        if value == kind:
            return kind
    raise FormatError("kind", f"one of {', '.join(KINDS)} is expected, not {described(value)}")


def _face(value: Json, count: int) -> tuple[int, ...]:
    if isinstance(value, list) and len(value) < 3:
        raise FormatError("", f"a face has at least three vertices, not {len(value)}")
    return each(value, "", lambda index: vertex_index(index, count))
