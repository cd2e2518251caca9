"""Check a find again, from its file text and in a process of its own, before anything is called a counterexample.

    python -m exactmesh.search.recheck < find.json

What agrees: the file of the polygon is read back as that polygon, which is simple by brute force; the claim's checker,
started afresh, returns the same outcome and the same exact value; and for claims on the finished mesh, the mesh is
read back from its own file, is valid for `exactmesh.verify`'s checker, which knows no construction, and its
degradation is the same from the definition: all vertices against all edges, with `fractions.Fraction`. A certificate of
the mesh is made and must be accepted by the stand-alone checker `exactmesh/check.py`.
"""

import json
import subprocess
import sys
from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from exactmesh.certificate.files import certificate_text
from exactmesh.claims.run import Run
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.measure.validity import verify_mesh
from exactmesh.planar.cycles import sides
from exactmesh.search.collect import evaluation_json
from exactmesh.search.corners import is_simple, pslg_of
from exactmesh.search.targets import target_of

_SECONDS = 300
# Claims judged on the finished mesh alone, by its degradation.
_ON_MESH = ("theorem-1.degradation", "theorem-1.feature-size", "repaired.degradation", "repaired.proper-degradation",
            "degradation", "proper-degradation")
_Pair = tuple[Fraction, Fraction]


def recheck(find: dict[str, Any]) -> tuple[bool, str]:
    """Return whether a fresh process agrees with a find, and what was looked at or what differs."""
    try:
        done = subprocess.run([sys.executable, "-m", "exactmesh.search.recheck"], input=json.dumps(find), text=True,
                              capture_output=True, timeout=_SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return False, f"no answer in {_SECONDS} seconds"
    if done.returncode:
        return False, f"the check fails: {done.stderr.strip()[-300:]}"
    answer = json.loads(done.stdout)
    return bool(answer["agrees"]), str(answer["says"])


def disagreement(find: dict[str, Any]) -> str:
    """Return what differs when a find is judged again, empty when nothing does."""
    corners = tuple((int(x), int(y)) for x, y in find["corners"])
    pslg = pslg_from_json(json_from_pslg(pslg_of(corners)))
    if not is_simple(corners) or tuple((int(p.x), int(p.y)) for p in pslg.vertices) != corners:
        return "the file is not that simple polygon"
    target = target_of(*find["target"])
    again = evaluation_json(target.evaluate(pslg))
    for name in ("outcome", "exact"):
        if again[name] != find[name]:
            return f"{name} is {again[name]}, not {find[name]}"
    if target.claim.id not in _ON_MESH:
        return ""
    run = Run(pslg, target.construction, target.kind)
    text = json_from_mesh(run.mesh)
    verification = verify_mesh(run.subdivision, run.mesh)
    if not verification.valid:
        return "" if find["outcome"] == "violated" else "the mesh is not valid"
    if run.kind != "internal":
        # Raises unless the stand-alone checker accepts the mesh.
        certificate_text(json_from_pslg(pslg).encode(), text.encode(), run.subdivision, run.mesh, verification)
    points, edges = _mesh_parts(text)
    own = [(i, (i + 1) % len(corners)) for i in range(len(corners))]
    at = [(Fraction(x), Fraction(y)) for x, y in corners]
    squared = plain_mfs_squared(at, own) / plain_mfs_squared(points, edges)
    stated = verification.degradation_squared
    return "" if squared == stated else f"the squared degradation is {squared} from the definition, not {stated}"


def plain_mfs_squared(points: Sequence[_Pair], edges: Sequence[tuple[int, int]]) -> Fraction:
    """Return the least squared distance of a vertex from an edge without it, by comparing all with all."""
    best: Fraction | None = None
    for u, v in edges:
        (ax, ay), (bx, by) = points[u], points[v]
        x, y = bx - ax, by - ay
        length = x * x + y * y
        for w, (px, py) in enumerate(points):
            if w in (u, v):
                continue
            t = min(Fraction(1), max(Fraction(0), (x * (px - ax) + y * (py - ay)) / length))
            squared = (px - ax - t * x) ** 2 + (py - ay - t * y) ** 2
            best = squared if best is None else min(best, squared)
    if best is None:
        raise ValueError("there is no vertex beside an edge")
    return best


def _mesh_parts(text: str) -> tuple[list[_Pair], list[tuple[int, int]]]:
    """Return vertices and edges of a mesh file, read without the product's mesh record."""
    value: Any = json.loads(text)
    points = [(Fraction(x), Fraction(y)) for x, y in value["vertices"]]
    edges = {(min(side), max(side)) for cycle in value["faces"] for side in sides(tuple(cycle))}
    return points, sorted(edges)


def main() -> int:
    """Read a find from standard input and write the answer."""
    find = json.load(sys.stdin)
    differs = disagreement(find)
    more = ", verifier, stand-alone checker, all vertex-edge pairs" if find["target"][0] in _ON_MESH else ""
    json.dump({"agrees": not differs, "says": differs or f"agrees in a fresh process: claim checker{more}"}, sys.stdout)
    return 0


if __name__ == "__main__":
    sys.exit(main())
