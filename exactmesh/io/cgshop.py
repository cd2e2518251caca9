"""Read and write instances and solutions of the CG:SHOP 2025 challenge (minimum non-obtuse triangulations).

An instance has points with integer coordinates, a `region_boundary` of their indices, counter-clockwise, and
`additional_constraints`, pairs of indices. A solution adds Steiner points, with coordinates that are integers or
fractions "p/q", and lists all edges; its faces are what the edges enclose.
"""

import json
from collections.abc import Iterable

from gmpy2 import mpq

from exactmesh.errors import FormatError, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.json_fields import each, edge, rows, scalar, vertex_index
from exactmesh.io.strict_json import Json, described
from exactmesh.planar.cycles import sides
from exactmesh.planar.faces import subdivide
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Edge, Pslg

INSTANCE, SOLUTION = "CG_SHOP_2025_Instance", "CG_SHOP_2025_Solution"


def is_instance(value: Json) -> bool:
    """Whether a parsed file is an instance."""
    return isinstance(value, dict) and "region_boundary" in value


def is_solution(value: Json) -> bool:
    """Whether a parsed file is a solution."""
    return isinstance(value, dict) and value.get("content_type") == SOLUTION


def pslg_from_instance(value: Json) -> Pslg:
    """Return the PSLG of a parsed instance; raises `FormatError` naming the place."""
    if not isinstance(value, dict):
        raise FormatError("", f"an object is expected, not {described(value)}")
    points = _points(value, "points_x", "points_y")
    count = len(points)
    boundary = each(_member(value, "region_boundary"), "region_boundary", lambda index: vertex_index(index, count))
    if len(set(boundary)) < 3 or len(set(boundary)) < len(boundary):
        raise FormatError("region_boundary", "three distinct points or more are expected, none twice")
    extra = each(value.get("additional_constraints", []), "additional_constraints", lambda pair: edge(pair, count))
    present = {frozenset(side) for side in sides(boundary)}
    edges = (*sides(boundary), *(pair for pair in _once(extra) if frozenset(pair) not in present))
    name = value.get("instance_uid", "")
    if not isinstance(name, str):
        raise FormatError("instance_uid", f"a string is expected, not {described(name)}")
    return Pslg(points, edges, name=name)


def instance_from_pslg(pslg: Pslg) -> str:
    """Return the text of an instance.

    Raises `InputError` when a coordinate is no integer, or the domain is not the inside of one simple ring.
    """
    for v, point in enumerate(pslg.vertices):
        if any(value.denominator != 1 for value in point):
            raise InputError(f"vertex {v} at {point}: a CG:SHOP instance has integer coordinates")
    subdivision = subdivide(pslg)
    outside = subdivision.faces[0]
    walk = [subdivision.half_edges.origin[h] for inner in outside.inner for h in inner]
    if pslg.holes or outside.isolated or len(outside.inner) != 1 or len(set(walk)) < max(3, len(walk)):
        raise InputError("a CG:SHOP instance is one simple polygon, without holes and with all else inside")
    boundary = tuple(reversed(walk))  # the walk has the unbounded face on its left
    on_boundary = {frozenset(side) for side in sides(boundary)}
    extra = [pair for pair in pslg.edges if frozenset(pair) not in on_boundary]
    return "{" + ",\n ".join([
        f'"content_type": "{INSTANCE}"', f'"instance_uid": {json.dumps(pslg.name or "exactmesh")}',
        f'"num_points": {len(pslg.vertices)}', *_coordinates("points", pslg.vertices),
        f'"region_boundary": [{", ".join(map(str, boundary))}]', f'"num_constraints": {len(extra)}',
        f'"additional_constraints": {rows(f"[{u}, {v}]" for u, v in extra)}']) + "}\n"


def mesh_from_solution(value: Json, pslg: Pslg, kind: Kind = "proper") -> Mesh:
    """Return the mesh whose edges a parsed solution lists, for the points of its instance.

    Raises `FormatError` naming the place, `GeometryError` when the edges cross, and `InputError` when a face has
    something inside.
    """
    if not isinstance(value, dict):
        raise FormatError("", f"an object is expected, not {described(value)}")
    vertices = pslg.vertices + _points(value, "steiner_points_x", "steiner_points_y")
    count = len(vertices)
    edges = each(_member(value, "edges"), "edges", lambda pair: edge(pair, count))
    subdivision = subdivide(Pslg(vertices, _once(edges)))
    faces = []
    for face in subdivision.faces[1:]:
        cycle = tuple(subdivision.half_edges.origin[h] for h in face.outer or ())
        if face.inner or face.isolated:
            raise InputError(f"edges: the face {cycle} has edges or points inside: this is no mesh")
        faces.append(cycle)
    return Mesh(kind, vertices, tuple(faces))


def solution_from_mesh(mesh: Mesh, pslg: Pslg) -> str:
    """Return the text of a solution: all edges of the mesh and of the input. Nothing is rounded."""
    steiner = mesh.vertices[len(pslg.vertices) :]
    edges = {(min(side), max(side)) for face in mesh.faces for side in sides(face)}
    edges |= {(min(pair), max(pair)) for pair in pslg.edges}
    return "{" + ",\n ".join([
        f'"content_type": "{SOLUTION}"', f'"instance_uid": {json.dumps(pslg.name or "exactmesh")}',
        *_coordinates("steiner_points", steiner),
        f'"edges": {rows(f"[{u}, {v}]" for u, v in sorted(edges))}']) + "}\n"


def _coordinates(name: str, points: tuple[Point, ...]) -> list[str]:
    def written(value: mpq) -> str:
        return str(value) if value.denominator == 1 else f'"{value}"'

    return [f'"{name}_{axis}": [{", ".join(written(p[i]) for p in points)}]' for i, axis in enumerate("xy")]


def _once(pairs: Iterable[Edge]) -> tuple[Edge, ...]:
    """Return each edge once, whichever way round it is given."""
    return tuple({frozenset(pair): pair for pair in pairs}.values())


def _points(value: dict[str, Json], x: str, y: str) -> tuple[Point, ...]:
    xs, ys = (each(_member(value, key), key, scalar) for key in (x, y))
    if len(xs) != len(ys):
        raise FormatError(y, f"{len(xs)} numbers are expected, as in {x}, not {len(ys)}")
    return tuple(map(Point, xs, ys))


def _member(value: dict[str, Json], key: str) -> Json:
    if key not in value:
        raise FormatError("", f"the key {key!r} is missing")
    return value[key]
