"""Check a find again, from its file text and in another process, before anything is called a counterexample.

    python -m exactmesh.search.recheck < finds.jsonl

The file of the figure is read back as that figure, which is planar by brute force, and the claim's checker, started
afresh, returns the same outcome and the same exact value. Then, as far as there are independent roads:

stand-alone checker     for claims on the degradation and the validity of the finished mesh: the mesh is read back from
                        its own file, a certificate of it is accepted by `exactmesh/check.py`, and the degradation is
                        the same by `second.py`
second implementation   the exact value is the same by `second.py`, which shares no code with the claim's checker
claim checker           neither of these: nothing but the claim's own checker agrees, which a find says plainly
"""

import json
import subprocess
import sys
import threading
from collections.abc import Mapping
from fractions import Fraction
from types import TracebackType
from typing import Any, NamedTuple, Self

from exactmesh.certificate.files import certificate_text
from exactmesh.claims.run import REPAIRED_STEPS, Run
from exactmesh.errors import ConstructionFailed, InputError
from exactmesh.geometry.point import Point
from exactmesh.io.mesh_json import json_from_mesh
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.planar.cycles import sides
from exactmesh.search.collect import evaluation_json
from exactmesh.search.figure import Figure, is_planar
from exactmesh.search.second import Made, Place, agree, has_road, second_value
from exactmesh.search.targets import Target, target_of
from exactmesh.steps.records import Patch

_SECONDS = 300
# Beyond this many vertices in the mesh or the figure, comparing all with all takes too long.
_ALL_PAIRS = 1500
_VALIDITY = ("theorem-1.triangulation", "theorem-2.triangulation")
_ON_MESH = ("theorem-1.feature-size", "theorem-1.degradation", "repaired.degradation", "repaired.proper-degradation",
            "repaired.proper-degradation-22", "degradation", "proper-degradation", "theorem-1.steiner-count",
            "repaired.steiner-count", "coarse.degradation", "coarse.steiner-count", "steiner-per-vertex", *_VALIDITY)


class Answer(NamedTuple):
    """Whether the check agrees with a find, and in words what agrees or what differs."""

    agrees: bool
    says: str


class Checker:
    """A process of its own that checks finds one after the other; started when it is first asked, anew when it fails.

    Use it in a `with` statement.
    """

    def __init__(self) -> None:
        self._process: subprocess.Popen[str] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
                 ) -> None:
        self._stop()

    def check(self, find: Mapping[str, Any]) -> Answer:
        """Return the answer of the process, which has `_SECONDS` for it."""
        if self._process is None:
            # A session of its own: Ctrl-C is for the search, which ends this process by closing its input.
            self._process = subprocess.Popen([sys.executable, "-m", "exactmesh.search.recheck"], text=True,
                                             stdin=subprocess.PIPE, stdout=subprocess.PIPE, start_new_session=True)
        process = self._process
        if process.stdin is None or process.stdout is None:
            raise AssertionError("both were asked for")
        clock = threading.Timer(_SECONDS, process.kill)
        clock.start()
        try:
            process.stdin.write(json.dumps(find) + "\n")
            process.stdin.flush()
            line = process.stdout.readline()
        except BrokenPipeError:
            line = ""
        finally:
            clock.cancel()
        if line:
            return Answer(*json.loads(line))
        self._stop()
        return Answer(False, f"the checking process died, or gave no answer in {_SECONDS} seconds")

    def _stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.communicate()
            self._process = None


def checked(find: Mapping[str, Any]) -> Answer:
    """Return the answer to a find, here and now."""
    figure = Figure.from_json(find["figure"])
    text = json_from_pslg(figure.pslg())
    pslg = pslg_from_json(text)
    if not is_planar(figure) or Figure.of(pslg) != figure:
        return Answer(False, "the file is not that figure, or the figure is not planar")
    target = target_of(*find["target"])
    again = evaluation_json(target.evaluate(pslg))
    for name in ("outcome", "exact"):
        if again[name] != find[name]:
            return Answer(False, f"{name} is {again[name]}, not {find[name]}")
    run = Run(pslg, target.construction, target.kind)
    answer = Answer(True, "claim checker: agrees in a fresh process; there is no second implementation of this claim")
    if target.claim.id in _ON_MESH:
        answer = _certified(find, run, text)
    if answer.agrees and find["exact"] and has_road(target.claim.id):
        made = _made(figure, run, target)
        if max(len(made.points), len(made.mesh)) <= _ALL_PAIRS:
            value = second_value(target.claim.id, made)
            if value is None or not agree(value, find["exact"]):
                return Answer(False, f"the second implementation has another value than {find['exact']}")
            says = answer.says if target.claim.id in _ON_MESH else "second implementation"
            answer = Answer(True, f"{says}: the value is the same by Fractions, from the definition, all with all")
    return answer


def _certified(find: Mapping[str, Any], run: Run, text: str) -> Answer:
    """Return whether the stand-alone checker's word on the mesh is what the find says of it."""
    is_invalid = find["outcome"] == "violated" and not find["exact"]
    try:
        # Raises unless the stand-alone checker accepts the mesh and its certificate.
        certificate_text(text.encode(), json_from_mesh(run.mesh).encode(), run.subdivision, run.mesh, run.verification)
    except (ConstructionFailed, InputError) as error:
        why = error.place if isinstance(error, ConstructionFailed) else error
        return Answer(is_invalid, f"claim checker: no certificate of the mesh is accepted ({why})")
    return Answer(not is_invalid, "stand-alone checker: accepts a certificate of the mesh")


def _made(figure: Figure, run: Run, target: Target) -> Made:
    """Return the input and what the construction wrote down, as plain numbers."""
    points, edges = _places(run.pslg.vertices), run.pslg.edges
    if target.claim.id in _ON_MESH:
        value = json.loads(json_from_mesh(run.mesh))
        mesh = [(Fraction(x), Fraction(y)) for x, y in value["vertices"]]
        found = {(min(side), max(side)) for side in edges}
        found |= {(min(side), max(side)) for cycle in value["faces"] for side in sides(tuple(cycle))}
        corners = points if figure.is_polygon else []
        return Made(points, edges, corners=corners, mesh=mesh, mesh_edges=sorted(found),
                    corner_count=run.repaired.shape.corner_count if target.construction in REPAIRED_STEPS else 0)
    if target.construction == "paper":
        return _made_by_paper(points, run)
    made = run.repaired
    shape, q = made.shape, made.offset
    ends = _places(shape.points)
    return Made(
        points, edges, unit=_exact(shape.unit), q=_places(q.points), q_next=q.successors(),
        q_source=[None if h < 0 else (ends[shape.origin[h]], ends[shape.origin[h ^ 1]]) for h in q.source],
        interior=_faces(made.interior, made.points), tube=_faces(made.tube, made.points))


def _made_by_paper(points: list[Place], run: Run) -> Made:
    made = run.paper
    (walk,) = made.shape.faces[0]
    p4 = made.p4
    return Made(
        points, run.pslg.edges, corners=[points[made.shape.origin[h]] for h in walk], p4=_places(p4.points),
        p4_corner=[walk.index(corner) for corner in p4.corner], spacing=_exact(p4.spacing),
        interior=_faces(made.interior, made.points), tube=_faces(made.tube.patch, made.points))


def _faces(patch: Patch, points: tuple[Point, ...]) -> list[list[Place]]:
    places = _places(points)
    return [[places[v] for v in cycle] for cycle in patch.faces]


def _places(points: tuple[Point, ...]) -> list[Place]:
    return [(_exact(p.x), _exact(p.y)) for p in points]


def _exact(value: Any) -> Fraction:
    return Fraction(int(value.numerator), int(value.denominator))


def main() -> int:
    """Answer each find on standard input, one a line, by a line."""
    for line in sys.stdin:
        try:
            answer = checked(json.loads(line))
        except Exception as error:  # whatever it is, the find is not confirmed
            answer = Answer(False, f"the check fails: {type(error).__name__}: {error}"[:500])
        print(json.dumps(answer), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
