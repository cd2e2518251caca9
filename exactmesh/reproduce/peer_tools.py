"""Other meshers, each behind one function, run in a process of its own: they may crash, hang or be missing.

A mesher gets doubles and returns doubles; what they are worth is measured elsewhere. `Tool.mesh` raises `Unfit` when
the mesher cannot take such an input.
"""

import importlib
import multiprocessing
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from time import process_time
from typing import Any, Literal

Triangle = tuple[int, int, int]
Ring = list[int]


class Unfit(ValueError):
    """The mesher is not made for such an input."""


@dataclass(frozen=True, slots=True)
class Outline:
    """A domain in doubles: vertices, edges and hole points, and its faces as rings, the outer one first.

    `rings` is None when a face is not bounded by simple rings (loose edges, isolated vertices).
    """

    vertices: list[tuple[float, float]]
    edges: list[tuple[int, int]]
    holes: list[tuple[float, float]]
    rings: list[list[Ring]] | None

    def faces(self) -> list[list[Ring]]:
        """Return `rings`; raises `Unfit` when there are none."""
        if self.rings is None:
            raise Unfit("takes polygons with holes only")
        return self.rings


@dataclass(frozen=True, slots=True)
class Output:
    """What a mesher did; `vertices` and `triangles` are there when `status` is "made"."""

    status: Literal["made", "not installed", "not taken", "failed", "too slow"]
    message: str = ""
    seconds: float = 0.0
    vertices: tuple[tuple[float, float], ...] = ()
    triangles: tuple[Triangle, ...] = ()


Made = tuple[Sequence[Any], Sequence[Any]]


@dataclass(frozen=True, slots=True)
class Tool:
    """A mesher with its switches; `package` is what has to be installed."""

    name: str
    package: str
    mesh: Callable[[Outline], Made]


def _triangle(switches: str, outline: Outline) -> Made:
    import triangle

    given = {"vertices": outline.vertices, "segments": outline.edges}
    if outline.holes:
        given["holes"] = outline.holes
    made = triangle.triangulate(given, switches + "Q")
    return made["vertices"].tolist(), made["triangles"].tolist()


def _gmsh(whole_edges: bool, outline: Outline) -> Made:
    import gmsh

    faces = outline.faces()
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        if whole_edges:
            gmsh.option.setNumber("Mesh.MeshSizeExtendFromBoundary", 0)
        add = gmsh.model.geo
        points = [add.addPoint(x, y, 0) for x, y in outline.vertices]
        lines: dict[tuple[int, int], int] = {}
        for u, v in outline.edges:
            lines[u, v] = add.addLine(points[u], points[v])
            lines[v, u] = -lines[u, v]
        for rings in faces:
            loops = [add.addCurveLoop([lines[u, v] for u, v in zip(ring, [*ring[1:], ring[0]], strict=True)])
                     for ring in rings]
            add.addPlaneSurface(loops)
        if whole_edges:
            for line in lines.values():
                if line > 0:
                    add.mesh.setTransfiniteCurve(line, 2)
        add.synchronize()
        gmsh.model.mesh.generate(2)
        tags, flat, _ = gmsh.model.mesh.getNodes()
        place = {tag: i for i, tag in enumerate(tags.tolist())}
        kinds, _, corners = gmsh.model.mesh.getElements(2)
        nodes = [place[tag] for kind, of_kind in zip(kinds, corners, strict=True) if kind == 2
                 for tag in of_kind.tolist()]
        spots = flat.tolist()
        return (list(zip(spots[::3], spots[1::3], strict=True)),
                list(zip(nodes[::3], nodes[1::3], nodes[2::3], strict=True)))
    finally:
        gmsh.finalize()


def _geos(outline: Outline) -> Made:
    import shapely

    index = {spot: i for i, spot in enumerate(outline.vertices)}
    triangles = []
    for rings in outline.faces():
        shell, *holes = ([outline.vertices[v] for v in ring] for ring in rings)
        made = shapely.constrained_delaunay_triangles(shapely.Polygon(shell, holes))
        triangles += [tuple(index[spot] for spot in part.exterior.coords[:3]) for part in made.geoms]
    return outline.vertices, triangles


def _earcut(outline: Outline) -> Made:
    import mapbox_earcut
    import numpy as np

    triangles = []
    for rings in outline.faces():
        names = [v for ring in rings for v in ring]
        ends = np.cumsum([len(ring) for ring in rings], dtype=np.uint32)
        flat = mapbox_earcut.triangulate_float64(np.array([outline.vertices[v] for v in names]), ends).tolist()
        triangles += [tuple(names[i] for i in flat[k : k + 3]) for k in range(0, len(flat), 3)]
    return outline.vertices, triangles


PEERS: tuple[Tool, ...] = (
    Tool("Triangle p", "triangle", partial(_triangle, "p")), Tool("Triangle pq", "triangle", partial(_triangle, "pq")),
    Tool("Triangle pqYY", "triangle", partial(_triangle, "pqYY")), Tool("gmsh", "gmsh", partial(_gmsh, False)),
    Tool("gmsh, edges whole", "gmsh", partial(_gmsh, True)), Tool("GEOS", "shapely", _geos),
    Tool("earcut", "mapbox_earcut", _earcut))


class Workshop:
    """A process in which meshers run; it is replaced when one of them crashes or takes more than `seconds`."""

    def __init__(self, seconds: float = 60.0, peers: Sequence[Tool] = PEERS) -> None:
        self._seconds = seconds
        self._peers = tuple(peers)
        self._process: BaseProcess | None = None
        self._link: Connection[Any, Any] | None = None

    def __enter__(self) -> "Workshop":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the process."""
        if self._process is not None and self._link is not None:
            self._process.kill()
            self._process.join()
            self._link.close()
        self._process = self._link = None

    def mesh(self, number: int, outline: Outline) -> Output:
        """Return what the mesher of that number makes of a domain."""
        if self._link is None:
            context = multiprocessing.get_context("spawn")
            self._link, theirs = context.Pipe()
            self._process = context.Process(target=_work, args=(theirs, self._peers), daemon=True)
            self._process.start()
            theirs.close()
            self._link.recv()  # it is ready: starting it is not the mesher's time
        self._link.send((number, outline))
        try:
            if self._link.poll(self._seconds):
                output: Output = self._link.recv()
                return output
            message = Output("too slow", f"more than {self._seconds:g} s")
        except (EOFError, ConnectionError):
            message = Output("failed", "crashed")
        self.close()
        return message


def _work(link: "Connection[Any, Any]", peers: tuple[Tool, ...]) -> None:
    link.send("ready")
    while True:
        try:
            number, outline = link.recv()
        except (EOFError, KeyboardInterrupt):
            return
        link.send(_run(peers[number], outline))


def _run(tool: Tool, outline: Outline) -> Output:
    try:
        importlib.import_module(tool.package)
    except (ImportError, OSError):  # a package may lack a library of the system
        return Output("not installed", f"{tool.package} is missing: pip install 'exactmesh[peers]'")
    start = process_time()
    try:
        vertices, triangles = tool.mesh(outline)
    except Unfit as unfit:
        return Output("not taken", str(unfit))
    except Exception as error:  # whatever a mesher raises is its own affair, and a row of the table
        return Output("failed", f"{type(error).__name__}: {error}"[:200])
    return Output("made", "", process_time() - start, tuple((float(x), float(y)) for x, y in vertices),
                  tuple((int(u), int(v), int(w)) for u, v, w in triangles))
