"""What is measured, one thing to a process: `python -m exactmesh.bench.worker TASK`, TASK and result being JSON.

make       write the input of a family to a file
pipeline   read it, and all stages up to the mesh that is written and read again: seconds of the process and of the
           clock for each, the greatest memory, how many decisions floats made, how many were exact
peer       one other program and what it is compared with, one after the other
"""

import json
import platform
import resource
import sys
import time
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from exactmesh.bench.inputs import FAMILIES
from exactmesh.bench.peers import PEERS
from exactmesh.claims.ledger import judge
from exactmesh.claims.run import Run
from exactmesh.geometry.decisions import decisions
from exactmesh.io.atomic import write_text
from exactmesh.io.mesh_json import json_parts_from_mesh
from exactmesh.io.pslg_json import json_from_pslg
from exactmesh.io.read import read_mesh, read_pslg

T = TypeVar("T")

STAGES = ("read", "validate", "mfs", "construct", "verify", "check", "write", "reread")
# What comes before a stage must be asked for as well.
WITHOUT_MESH = 3


class Clock:
    """Seconds by stage: of this process on the processor, and on the wall."""

    def __init__(self) -> None:
        self.cpu: dict[str, float] = {}
        self.wall: dict[str, float] = {}

    def __call__(self, stage: str, work: Callable[[], T]) -> T:
        """Return what `work` returns, and keep the time it takes."""
        cpu, wall = time.process_time(), time.perf_counter()
        result = work()
        self.cpu[stage], self.wall[stage] = time.process_time() - cpu, time.perf_counter() - wall
        return result


def memory() -> int:
    """Return the greatest memory that this process has had so far, in bytes."""
    status = Path("/proc/self/status")
    if status.exists():
        # What `getrusage` has on Linux may be that of the process which started this one.
        lines = [line for line in status.read_text(encoding="utf-8").splitlines() if line.startswith("VmHWM:")]
        if lines:
            return 1024 * int(lines[0].split()[1])
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else 1024 * peak


def make(task: Mapping[str, Any]) -> dict[str, object]:
    """Write the input of a family."""
    pslg = FAMILIES[task["family"]](task["n"])
    write_text(task["path"], json_from_pslg(pslg))
    return {"n": len(pslg.vertices)}


def pipeline(task: Mapping[str, Any]) -> dict[str, object]:
    """Measure the first `stages` stages on the file `path`; the mesh goes to `out`."""
    stages = STAGES[: task["stages"]]
    clock, before = Clock(), memory()
    pslg = clock("read", lambda: read_pslg(task["path"]).pslg)
    run = Run(pslg)
    clock("validate", lambda: run.subdivision)
    clock("mfs", lambda: run.mfs)
    result: dict[str, object] = {"n": len(pslg.vertices)}
    if "construct" in stages:
        mesh = clock("construct", lambda: run.mesh)
        verification = clock("verify", lambda: run.verification)
        judgements = clock("check", lambda: list(judge(run)))
        result |= {"holds": verification.valid and all(j.verdict.holds for j in judgements),
                   "mesh_vertices": len(mesh.vertices), "faces": len(mesh.faces)}
        clock("write", lambda: write_text(task["out"], json_parts_from_mesh(mesh)))
        del run, mesh, verification, judgements
        clock("reread", lambda: read_mesh(task["out"]))
    counts = {what: (count.by_floats, count.exactly) for what, count in decisions().items()}
    return result | {"cpu": clock.cpu, "wall": clock.wall, "memory": memory(), "memory_before": before,
                     "decisions": counts}


def peer(task: Mapping[str, Any]) -> dict[str, object]:
    """Measure another program, and what is compared with it, on the input of a family."""
    clock = Clock()
    pslg = FAMILIES[task["family"]](task["n"])
    ours, theirs = PEERS[task["peer"]].prepared(pslg)
    clock("ours", ours)
    clock("theirs", theirs)
    return {"n": len(pslg.vertices), "ours": clock.cpu["ours"], "theirs": clock.cpu["theirs"]}


def machine() -> str:
    """Return what the measurements are made on, in a line."""
    name = platform.processor() or platform.machine()
    cpuinfo, meminfo = Path("/proc/cpuinfo"), Path("/proc/meminfo")
    cores = total = ""
    if cpuinfo.exists():
        lines = cpuinfo.read_text(encoding="utf-8").splitlines()
        models = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
        name = models[0] if models else name
        cores = f", {len(models)} cores" if models else ""
    if meminfo.exists():
        total = f", {int(meminfo.read_text(encoding='utf-8').split()[1]) / 2**20:.0f} GiB"
    return f"{name}{cores}{total}, {platform.system()}, Python {platform.python_version()}"


_TASKS = {"make": make, "pipeline": pipeline, "peer": peer}

if __name__ == "__main__":
    given = json.loads(sys.argv[1])
    print(json.dumps(_TASKS[given["task"]](given)))
