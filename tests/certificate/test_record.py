"""The text of a certificate, letter by letter."""

from gmpy2 import mpq

from exactmesh.certificate.record import Certificate, json_from_certificate
from exactmesh.geometry.point import Point


def test_a_certificate_is_written_key_by_key() -> None:
    certificate = Certificate(
        pslg_sha256="ab", mesh_sha256="cd", mfs_squared_at_least="1/4", mfs_at_least="0.5",
        input_mfs_squared_at_most="9", witness=(3, 1, 2), degradation_squared_at_most="36", degradation_at_most="6",
        vertices=(Point(mpq(-1), mpq(1, 2)), Point(mpq(2), mpq(3))), faces=((0, 1, 2), (5, 4, 3, 2)), hole_faces=(1, 0))
    assert json_from_certificate(certificate) == (
        '{"format": "exactmesh-certificate/1",\n "pslg_sha256": "ab",\n "mesh_sha256": "cd",\n'
        ' "mfs_squared_at_least": "1/4",\n "mfs_at_least": "0.5",\n "input_mfs_squared_at_most": "9",\n'
        ' "degradation_squared_at_most": "36",\n "degradation_at_most": "6",\n "witness": [3, 1, 2],\n'
        ' "hole_faces": [1, 0],\n "vertices": [\n  ["-1", "1/2"],\n  ["2", "3"]],\n'
        ' "faces": [\n  [0, 1, 2],\n  [5, 4, 3, 2]]}\n')
