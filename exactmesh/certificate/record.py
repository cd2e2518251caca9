"""The record of a certificate, and its text: the format `exactmesh-certificate/1` of docs/certificate.md.

It is read by `exactmesh/check.py` and `exactmesh/check.c` alone, which share no code with this.
"""

from dataclasses import dataclass

from exactmesh.geometry.point import Point
from exactmesh.io.json_fields import point_rows, rows

FORMAT = "exactmesh-certificate/1"


@dataclass(frozen=True, slots=True)
class Certificate:
    """Claims about a mesh and what is needed to check them. Sizes are texts in the syntax of a scalar.

    `vertices` go on after the mesh's, the four corners of an upright box first; `faces` tile what the mesh leaves of
    the box. `witness` is a vertex and the two ends of an edge of the input, or twice another vertex. `hole_faces`
    holds, for each hole point of the input, the number of a face in `faces` with the point inside or on its boundary.
    """

    pslg_sha256: str
    mesh_sha256: str
    mfs_squared_at_least: str
    mfs_at_least: str
    input_mfs_squared_at_most: str
    witness: tuple[int, int, int]
    degradation_squared_at_most: str
    degradation_at_most: str
    vertices: tuple[Point, ...]
    faces: tuple[tuple[int, ...], ...]
    hole_faces: tuple[int, ...]


def json_from_certificate(certificate: Certificate) -> str:
    """Return the text of the file, which ends with a line feed."""
    texts = ("pslg_sha256", "mesh_sha256", "mfs_squared_at_least", "mfs_at_least", "input_mfs_squared_at_most",
             "degradation_squared_at_most", "degradation_at_most")
    faces = rows(f"[{', '.join(map(str, face))}]" for face in certificate.faces)
    parts = [f'"format": "{FORMAT}"',
             *(f'"{name}": "{getattr(certificate, name)}"' for name in texts),
             f'"witness": {list(certificate.witness)}',
             f'"hole_faces": {list(certificate.hole_faces)}',
             f'"vertices": {point_rows(certificate.vertices)}',
             f'"faces": {faces}']
    return "{" + ",\n ".join(parts) + "}\n"
