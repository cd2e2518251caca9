"""Valid triples of files, PSLG, mesh and certificate, and what is true of any triple.

A triple is held as parsed JSON. `harm` spoils it; hashes are made right again when it becomes bytes.

`truth` decides without the checkers and without the certificate's faces whether what a checker says of a triple is
true: `verify_mesh`, which sweeps, and for small meshes the brute force of `oracle`.
"""

import copy
import hashlib
import json
import random
from collections.abc import Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Any
from unittest.mock import patch

import families
import oracle
from constructions import HALL

from exactmesh.certificate.files import certificate_text
from exactmesh.claims.run import Run
from exactmesh.errors import InputError
from exactmesh.io.mesh_json import json_from_mesh, mesh_from_json
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.measure.mfs import minimum_feature_size
from exactmesh.measure.validity import verify_mesh
from exactmesh.planar.faces import Subdivision, domain_of
from exactmesh.planar.mesh import Kind, Mesh
from exactmesh.planar.pslg import Pslg
from exactmesh.repaired import construct

BRUTE_FORCE_FACES = 120


@dataclass
class Triple:
    """Three parsed files, and how they become bytes."""

    pslg: Any
    mesh: Any
    certificate: Any
    source: random.Random

    def files(self, keep_hashes: bool = False) -> list[bytes]:
        """Return the files; hashes are made right unless they are to be kept."""
        pslg, mesh = (json.dumps(value).encode() for value in (self.pslg, self.mesh))
        if not keep_hashes and isinstance(self.certificate, dict):
            self.certificate["pslg_sha256"] = hashlib.sha256(pslg).hexdigest()
            self.certificate["mesh_sha256"] = hashlib.sha256(mesh).hexdigest()
        return [pslg, mesh, json.dumps(self.certificate).encode()]

    # --- parts, by the numbering of the certificate ---

    @property
    def given(self) -> int:
        return len(self.pslg["vertices"])

    @property
    def watched(self) -> int:
        return len(self.mesh["vertices"])

    def vertex(self, v: int) -> list[str]:
        """Return the coordinates of a vertex, to be changed in place."""
        found: list[str] = self.mesh["vertices"][v] if v < self.watched else (
            self.certificate["vertices"][v - self.watched])
        return found

    def place(self, v: int) -> oracle.Place:
        return oracle.place(self.vertex(v))

    def put(self, v: int, x: Fraction, y: Fraction) -> None:
        self.vertex(v)[:] = [str(x), str(y)]

    def all_faces(self) -> list[list[int]]:
        return [*self.mesh["faces"], *self.certificate["faces"]]

    def a_list(self) -> list[list[int]]:
        """Return the faces of the mesh or of the rest."""
        found: list[list[int]] = self.source.choice([self.mesh["faces"], self.certificate["faces"]])
        return found

    def a_face(self) -> list[int]:
        return self.source.choice(self.a_list())

    def replace_vertex(self, old: int, new: int) -> None:
        """Put one index in the place of another, in all faces."""
        for face in self.all_faces():
            face[:] = [new if v == old else v for v in face]


def triple_of(pslg: Pslg, kind: Kind, rest: str = "") -> Triple:
    """Return a valid triple; the rest is meshed, whether it needs to be or not, when `rest` is "meshed"."""
    run = Run(pslg, "classic" if kind == "classic" else "repaired", kind)
    files = json_from_pslg(pslg).encode(), json_from_mesh(run.mesh).encode()
    with patch("exactmesh.certificate.make.classic_mesh", _meshed) if rest else nullcontext():
        text = certificate_text(*files, run.subdivision, run.mesh, run.verification)
    return Triple(json.loads(files[0]), json.loads(files[1]), json.loads(text), random.Random(0))


def _meshed(complement: Subdivision) -> Mesh:
    """Return a mesh with Steiner vertices where the maker of certificates asks for one without."""
    nearest = minimum_feature_size(complement.pslg)
    assert nearest is not None
    return construct(complement, nearest.squared).mesh


def _square(holes: bool) -> Pslg:
    ring = families.ring([(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)])
    edges = [(i, (i + 1) % 4) for i in range(4)] + [(4 + i, 4 + (i + 1) % 4) for i in range(4)]
    return Pslg(ring.vertices, tuple(edges), (families.Point(families.mpq(9, 2), families.mpq(4)),) if holes else ())


BASES: dict[str, tuple[Pslg, Kind] | tuple[Pslg, Kind, str]] = {
    "square": (families.ring([(0, 0), (4, 0), (4, 4), (0, 4)]), "nonproper"),
    "square, classic": (families.ring([(0, 0), (4, 0), (4, 4), (0, 4)]), "classic"),
    "ring with a hole": (_square(True), "nonproper"),
    "ring with a hole, classic": (_square(True), "classic"),
    "square in a square": (_square(False), "proper"),
    "hall, classic": (HALL, "classic"),
    "midway": (families.rectangle_with_two_midway_vertices(7), "nonproper"),
    "midway 100": (families.rectangle_with_two_midway_vertices(100), "nonproper", "meshed"),
    "growth, classic": (families.ALL_SMALL["growth 9"], "classic"),
    "l-shape": (families.l_shape(5), "proper"),
    "two squares": (families.SMALL_PSLGS["two squares"], "nonproper"),
    "two points": (families.SMALL_PSLGS["square and two points"], "nonproper"),
    "map, classic": (families.SMALL_PSLGS["map 0"], "classic"),
    "map 1, classic": (families.SMALL_PSLGS["map 1"], "classic"),
    "random, classic": (families.random_pslg(4, 2), "classic"),
    "rings, marked": (families.nested_rings(4, 1, marked=True), "classic"),
    "ring with a hole, rest meshed": (_square(True), "nonproper", "meshed"),
    "rings, marked, rest meshed": (families.nested_rings(4, 1, marked=True), "classic", "meshed"),
    "two squares, rest meshed": (families.SMALL_PSLGS["two squares"], "proper", "meshed"),
    "star": (families.star(3), "nonproper"),
    "reflex notch": (families.reflex_notch(families.Fraction(1, 100)), "nonproper"),
    "comb": (families.comb(1, 30), "nonproper", "meshed"),
    "room with a hole": (families.polygon_with_holes(1, 1, 3), "nonproper", "meshed"),
    "hall": (HALL, "nonproper"),
    "growth": (families.random_simple_polygon(12, 3, "growth"), "nonproper"),
    "30 digits": (families.big_coordinates(families.random_simple_polygon(9, 2, "monotone"), 1), "nonproper"),
    "tree": (families.boxed_tree(3, 3, 1), "classic"),
}


@cache
def base(name: str) -> Triple:
    """Return a valid triple by name; it is not to be changed."""
    return triple_of(*BASES[name])


# --- truth ---


def truth(files: Sequence[bytes]) -> str:
    """Return "" when all that an accepted triple states is true, else what is false."""
    try:
        pslg, mesh = pslg_from_json(files[0].decode()), mesh_from_json(files[1].decode())
        certificate = json.loads(files[2])
        verification = verify_mesh(domain_of(pslg), mesh)
    except InputError as error:
        return f"refused: {error}"
    if not verification.valid:
        return f"invalid: {verification.violations[0]}"
    if verification.mesh_mfs is None or verification.input_mfs is None:
        return "no feature size"
    of_mesh, of_input = Fraction(verification.mesh_mfs.squared), Fraction(verification.input_mfs.squared)
    if len(mesh.faces) <= BRUTE_FORCE_FACES:
        wrong = oracle.check_mesh(pslg.vertices, pslg.edges, pslg.holes, mesh.vertices, mesh.faces, mesh.kind)
        if wrong:
            return f"brute force: {wrong[0]}"
        if (of_input, of_mesh) != (oracle.mfs_squared(pslg.vertices, pslg.edges),
                                   oracle.mfs_squared(mesh.vertices, oracle.mesh_edges(mesh.faces, pslg.edges))):
            return "brute force: another feature size"
    stated = {key: Fraction(certificate[key]) for key in (
        "mfs_squared_at_least", "mfs_at_least", "input_mfs_squared_at_most", "degradation_squared_at_most",
        "degradation_at_most")}
    hashes = [hashlib.sha256(data).hexdigest() for data in files[:2]]
    claims = {
        "mfs_squared_at_least": 0 < stated["mfs_squared_at_least"] <= of_mesh,
        "mfs_at_least": stated["mfs_at_least"] >= 0 and stated["mfs_at_least"] ** 2 <= of_mesh,
        "input_mfs_squared_at_most": stated["input_mfs_squared_at_most"] >= of_input,
        "degradation_squared_at_most": stated["degradation_squared_at_most"] >= of_input / of_mesh,
        "degradation_at_most": stated["degradation_at_most"] >= 0 and stated["degradation_at_most"] ** 2
        >= of_input / of_mesh,
        "hashes": hashes == [certificate["pslg_sha256"], certificate["mesh_sha256"]]}
    return ", ".join(name for name, holds in claims.items() if not holds)


def harmless(name: str, seed: int) -> list[bytes]:
    """Return a valid triple written otherwise: faces in another order and turned, edges likewise, keys shuffled."""
    t = copy.deepcopy(base(name))
    t.source = random.Random(f"{name} {seed}")
    t.source.shuffle(t.mesh["faces"])
    order = list(range(len(t.certificate["faces"])))
    t.source.shuffle(order)
    t.certificate["faces"] = [t.certificate["faces"][i] for i in order]
    t.certificate["hole_faces"] = [order.index(i) for i in t.certificate["hole_faces"]]
    for face in t.all_faces():
        i = t.source.randrange(len(face))
        face[:] = face[i:] + face[:i]
    t.source.shuffle(t.pslg["edges"])
    for edge in t.pslg["edges"]:
        t.source.shuffle(edge)
    v, a, b = t.certificate["witness"]
    t.certificate["witness"] = [v, b, a]
    t.certificate["mfs_squared_at_least"] = str(
        Fraction(t.certificate["mfs_squared_at_least"]) * (1 - Fraction(1, 10**30)))
    t.certificate["mfs_at_least"] = "0"
    t.certificate["degradation_squared_at_most"] = str(
        Fraction(t.certificate["degradation_squared_at_most"]) * (1 + Fraction(1, 10**20)))
    t.certificate["degradation_at_most"] = str(Fraction(t.certificate["degradation_at_most"]) + 1)
    for name_of in ("pslg", "mesh", "certificate"):
        items = list(getattr(t, name_of).items())
        t.source.shuffle(items)
        setattr(t, name_of, dict(items))
    return t.files()
