"""Make a certificate of a mesh: tile the rest of a box around it, and state what follows.

In      a subdivided PSLG, a mesh that was verified, the hashes of the two files.
Out     `Certificate`.
Raises  `InputError` for an internal mesh or one that is not valid.
Check   `exactmesh/check.py`, `exactmesh/check.c`; docs/certificate.md proves that what they accept is true.

Around each vertex of the mesh there must be room for a disc as large as the bound claims. The faces of the mesh leave
it by definition of their feature size. The rest, outside and holes, is first triangulated without new vertices; where
that leaves too little room it is meshed by the repaired construction, which leaves about a fifth of the input's mfs, or
optimised where the mesh has more.
"""

from collections.abc import Callable, Iterator, Sequence

from gmpy2 import isqrt, mpq

from exactmesh.certificate.locate import faces_around
from exactmesh.certificate.record import Certificate
from exactmesh.classic import classic_mesh
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.distance import distance_squared, segment_distance_squared
from exactmesh.geometry.point import Point
from exactmesh.measure.face_feature import NotTriangle, corners_of, face_feature_squared
from exactmesh.measure.validity import Verification
from exactmesh.numbers.rational import decimal_text, sqrt_below, text_from_rational
from exactmesh.optimize.optimize import optimize
from exactmesh.planar.bounding_box import with_bounding_box
from exactmesh.planar.cycles import Cycle, directed_edges, sides
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.mesh import Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import construct

_DIGITS = 12
_TARGET_BITS = 24
# The share of the squared mfs that the repaired construction leaves as room, about.
_CONSTRUCTION_LEAVES = mpq(1, 25)


def certificate_of(subdivision: Subdivision, mesh: Mesh, verification: Verification, pslg_sha256: str,
                   mesh_sha256: str, progress: Callable[[str], None] = lambda step: None) -> Certificate:
    """Return a certificate that `mesh` is a mesh of the domain of `subdivision` and keeps a feature size."""
    if mesh.kind == "internal":
        raise InputError("internal meshes split edges of the input: certificates are for the other kinds")
    nearest, least = verification.input_mfs, verification.mesh_mfs
    if not verification.valid or nearest is None or least is None:
        raise InputError("a mesh that is not valid has no certificate")
    points, faces, bound = _rest(subdivision, mesh, nearest.squared, least.squared, progress)
    degradation = nearest.squared / bound
    return Certificate(
        pslg_sha256, mesh_sha256, text_from_rational(bound), _root_text(bound), text_from_rational(nearest.squared),
        (nearest.vertex, *nearest.feature), text_from_rational(degradation), _root_text(degradation, up=True),
        points[len(mesh.vertices) :], faces, tuple(faces_around(subdivision.pslg.holes, points, faces)))


def _rest(subdivision: Subdivision, mesh: Mesh, mfs_squared: mpq, enough: mpq, progress: Callable[[str], None]
          ) -> tuple[tuple[Point, ...], tuple[Cycle, ...], mpq]:
    """Return all points, the faces of the rest, and the squared room that all faces leave to the mesh's vertices.

    There cannot be more room than the mesh's mfs, which is `enough`.
    """
    progress("certificate: triangulation")
    complement = domain_of(_complement(subdivision, mesh))
    watched, given = len(mesh.vertices), len(subdivision.pslg.vertices)
    room = _least_room(mesh.vertices, mesh.faces, watched)

    def placed(rest: Mesh) -> tuple[tuple[Point, ...], tuple[Cycle, ...], mpq]:
        faces = tuple(tuple(v if v < given else v + watched - given for v in face) for face in rest.faces)
        points = mesh.vertices + rest.vertices[given:]
        return points, faces, min(room, _least_room(points, faces, watched))

    first = placed(classic_mesh(complement))
    if first[2] == enough:
        return first
    try:
        second = placed(_meshed(complement, mfs_squared, enough, lambda step: progress(f"certificate: {step}")))
    except ConstructionFailed:
        return first  # less room, but room
    return max(first, second, key=lambda made: made[2])


def _meshed(complement: Subdivision, mfs_squared: mpq, enough: mpq, progress: Callable[[str], None]) -> Mesh:
    """Return a mesh of the rest with `enough` room, squared, as far as that can be had."""
    if enough <= _CONSTRUCTION_LEAVES * mfs_squared:
        return construct(complement, mfs_squared, progress).mesh
    made = optimize(complement, target=sqrt_below(mfs_squared / enough, _TARGET_BITS), progress=progress)
    if made.reason == "interrupted":
        raise KeyboardInterrupt
    return made.mesh


def _complement(subdivision: Subdivision, mesh: Mesh) -> Pslg:
    """Return the PSLG in a box with the domain as holes and the holes as domain.

    The box is about as far away as the input is long, so that triangles between them need not be thin; that is more
    than the mfs.
    """
    owner, _ = directed_edges(mesh.faces)
    half_edges = subdivision.half_edges
    inside = []
    for face in subdivision.domain:
        h = face.walks[0][0]
        cycle = mesh.faces[owner[half_edges.origin[h], half_edges.target(h)]]
        inside.append(_centroid([mesh.vertices[v] for v in cycle]))
    pslg = subdivision.pslg
    extent = max(max(p[axis] for p in pslg.vertices) - min(p[axis] for p in pslg.vertices) for axis in (0, 1))
    # Below the root by less than a part in 128, so above the extent.
    margin = sqrt_below(extent * extent * mpq(26, 25), 8)
    return with_bounding_box(Pslg(pslg.vertices, pslg.edges, tuple(inside)), margin)


def _centroid(points: list[Point]) -> Point:
    """Return the mean of the points: inside the face whose cycle they are."""
    return Point(sum((p.x for p in points), mpq(0)) / len(points), sum((p.y for p in points), mpq(0)) / len(points))


def _least_room(points: Sequence[Point], faces: Sequence[Cycle], watched: int) -> mpq:
    """Return the least squared distance, within a face, of one of the first `watched` vertices from the sides of the
    face that do not contain it and from its neighbours."""
    least = []
    for cycle in faces:
        corners = corners_of(points, cycle)
        if isinstance(corners, NotTriangle):
            raise AssertionError(f"{cycle} {corners.reason}: a verified face and the constructions' are triangles")
        if max(cycle) < watched:
            least.append(face_feature_squared(points, cycle, corners))
        elif min(cycle) < watched:
            least += _rooms(points, cycle, corners, watched)
    return min(least)


def _rooms(points: Sequence[Point], cycle: Cycle, corners: Sequence[int], watched: int) -> Iterator[mpq]:
    count = len(cycle)
    i, j, k = corners
    for first, last, other in ((i, j, k), (j, k, i), (k, i, j)):
        a, b, c = points[cycle[first]], points[cycle[last]], points[cycle[other]]
        if cycle[other] < watched:
            yield segment_distance_squared(c, a, b)
        for place in range(first + 1, last if last > first else last + count):
            if (v := cycle[place % count]) < watched:
                yield segment_distance_squared(points[v], b, c)
                yield segment_distance_squared(points[v], c, a)
    if count > 3:
        yield from (distance_squared(points[u], points[v]) for u, v in sides(cycle) if min(u, v) < watched)


def _root_text(squared: mpq, up: bool = False) -> str:
    """Return a decimal of at most 12 digits below the square root of `squared` > 0, or above it, and next to it."""
    shift = _DIGITS - 1
    # 10**shift * root has 12 digits once `shift` fits.
    while (root := _floor_root(squared, shift)) >= mpq(10) ** _DIGITS:
        shift -= 1
    while (root := _floor_root(squared, shift)) < mpq(10) ** (_DIGITS - 1):
        shift += 1
    value = mpq(root) / mpq(10) ** shift
    if up and value * value < squared:
        value += 1 / mpq(10) ** shift
    return decimal_text(value, _DIGITS)


def _floor_root(squared: mpq, shift: int) -> mpq:
    """Return floor(sqrt(squared) * 10**shift)."""
    scaled = squared * mpq(10) ** (2 * shift)
    return mpq(isqrt(scaled.numerator // scaled.denominator))
