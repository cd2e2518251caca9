"""A certificate belongs to two files, byte by byte: its text is made here, and checked before anyone sees it."""

import hashlib
import io
from collections.abc import Callable

from exactmesh import check
from exactmesh.certificate.make import certificate_of
from exactmesh.certificate.record import json_from_certificate
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.io.read import read_bytes
from exactmesh.io.text import printable
from exactmesh.measure.validity import Verification
from exactmesh.planar.faces import Subdivision
from exactmesh.planar.mesh import Mesh

NO_LIMITS = check.Limits(1 << 62, 1 << 62, 1 << 62)
_MEND = "give --pslg P: the input is written there for the checkers"


def pslg_bytes(path: str, sha256: str) -> bytes:
    """Return the bytes of the input file, whose hash is known.

    Raises `InputError` when they cannot be had, or are not what the checkers read: a strict exactmesh-pslg/1.
    """
    if path == "-":
        raise InputError(f"a certificate needs an input that is a file; {_MEND}")
    data = read_bytes(path)
    if hashlib.sha256(data).hexdigest() != sha256:
        raise InputError(f"{printable(path)}: the input is not this file alone, or it has changed; {_MEND}")
    try:
        check.read_object(check.Tokens(io.BytesIO(data), "PSLG", NO_LIMITS), check.PSLG)
    except check.Refused as refused:
        raise InputError(f"{printable(path)}: not an exactmesh-pslg/1 that the checkers read ({refused}); {_MEND}"
                         ) from None
    return data


def certificate_text(pslg_data: bytes, mesh_data: bytes, subdivision: Subdivision, mesh: Mesh,
                     verification: Verification, progress: Callable[[str], None] = lambda step: None) -> str:
    """Return the text of a certificate of the mesh in `mesh_data` for the PSLG in `pslg_data`, once it is accepted.

    Raises what `certificate_of` raises, and `ConstructionFailed` when `check.py` refuses the certificate.
    """
    certificate = certificate_of(subdivision, mesh, verification, hashlib.sha256(pslg_data).hexdigest(),
                                 hashlib.sha256(mesh_data).hexdigest(), progress)
    text = json_from_certificate(certificate)
    progress("certificate: check")
    valid, line = check.check(io.BytesIO(pslg_data), io.BytesIO(mesh_data), io.BytesIO(text.encode()), NO_LIMITS)
    if not valid:
        raise ConstructionFailed("certificate", line)
    return text
