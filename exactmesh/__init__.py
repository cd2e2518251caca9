"""exactmesh: triangulations that provably keep the minimum feature size, on exact numbers.

>>> import exactmesh
>>> square = exactmesh.polygon([(0, 0), (4, 0), (4, 4), (0, 4)])
>>> result = exactmesh.mesh(square)
>>> result.holds, result.verification.valid
(True, True)
"""

import importlib
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from exactmesh.api import Meshing, ifs, mesh, mfs, optimized, plot, read, verify
    from exactmesh.errors import ConstructionFailed, FormatError, GeometryError, InputError
    from exactmesh.geometry.point import Point
    from exactmesh.measure.mfs import Nearest
    from exactmesh.measure.validity import Verification, Violation
    from exactmesh.measure.verdict import Verdict, Witness
    from exactmesh.planar.mesh import Mesh
    from exactmesh.planar.pslg import Pslg, polygon

__version__ = "0.1.0"

__all__ = [
    "ConstructionFailed", "FormatError", "GeometryError", "InputError", "Mesh", "Meshing", "Nearest", "Point", "Pslg",
    "Verdict", "Verification", "Violation", "Witness", "__version__", "ifs", "mesh", "mfs", "optimized", "plot",
    "polygon", "read", "verify",
]

# Where each name is found. They are imported when they are first used: a command needs few of them. Inputs and meshes
# come by way of the functions, which teach them to be drawn in notebooks.
_HOMES = {
    "api": ("Mesh", "Meshing", "Pslg", "ifs", "mesh", "mfs", "optimized", "plot", "polygon", "read", "verify"),
    "errors": ("ConstructionFailed", "FormatError", "GeometryError", "InputError"),
    "geometry.point": ("Point",), "measure.mfs": ("Nearest",), "measure.validity": ("Verification", "Violation"),
    "measure.verdict": ("Verdict", "Witness"),
}


def __getattr__(name: str) -> object:
    for home, names in _HOMES.items():
        if name in names:
            return getattr(importlib.import_module(f"exactmesh.{home}"), name)
    raise AttributeError(f"module 'exactmesh' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)
