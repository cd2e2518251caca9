"""The verification and the checks of the steps of one run in several processes.

Processes are forked, so they share what the construction made; verdicts, which are small, are sent back. Where a system
cannot fork, nothing is done ahead. Verdicts are the same whatever the number of processes.
"""

import gc
import multiprocessing
import signal

from exactmesh.claims.repaired import STEP_CLAIMS
from exactmesh.claims.run import Run
from exactmesh.measure.validity import Verification
from exactmesh.measure.verdict import Verdict

# What is done by one process, the longest first; claims by the beginnings of their names.
_TASKS = (("",), ("repaired.offset-nesting",), ("repaired.trapezoidation", "repaired.chord-", "repaired.level-"),
          ("repaired.unit", "repaired.offset-thickness", "repaired.offset-reach", "repaired.offset-separation"),
          ("repaired.caps-", "repaired.edge-", "repaired.interior-", "repaired.tube-"))

# The run that forked processes find in their memory.
_runs: list[Run] = []


def verdicts_ahead(run: Run, jobs: int) -> dict[str, Verdict]:
    """Return the verdicts on the steps of the repaired construction by claim, and verify the mesh on the way.

    Empty when there is nothing to share out: one job, another construction, or no way to fork.
    """
    if jobs < 2 or run.construction != "repaired" or "fork" not in multiprocessing.get_all_start_methods():
        return {}
    run.progress("verification and checks")
    # Made once, before the processes part.
    _ = run.columns, run.chains
    _runs.append(run)
    gc.freeze()
    try:
        with multiprocessing.get_context("fork").Pool(min(jobs, len(_TASKS)), _begin) as pool:
            found: dict[str, Verdict] = {}
            for verification, verdicts in pool.imap_unordered(_do, range(len(_TASKS))):
                found |= verdicts
                if verification is not None:
                    vars(run)["verification"] = verification
            return found
    finally:
        gc.unfreeze()
        _runs.pop()


def _begin() -> None:
    """Leave interrupts to the first process, and pages of memory shared."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    gc.disable()


def _do(task: int) -> tuple[Verification | None, dict[str, Verdict]]:
    run = _runs[-1]
    run.progress = _silent
    if not task:
        return run.verification, {}
    return None, {claim.id: claim.check(run) for claim in STEP_CLAIMS
                  if claim.check is not None and claim.concerns(run) and claim.id.startswith(_TASKS[task])}


def _silent(step: str) -> None:
    """Report nothing."""
