"""Ask z3 and cvc5 for every problem that changed since its answers were recorded, and record them in answers.json.

    python proofs_checks/answers.py [SECONDS]     what an engine gets for a problem (default: 30)

Recorded answers are for readers and for the test that two roads agree; no status of a claim rests on them.
"""

import hashlib
import json
import sys
from pathlib import Path

from exactmesh.proofs.engines import ENGINES, Engine
from exactmesh.proofs.registry import problems

PATH = Path(__file__).parent / "answers.json"


def main(seconds: float) -> None:
    """Bring the file up to date."""
    old = json.loads(PATH.read_text(encoding="utf-8")) if PATH.exists() else {}
    new: dict[str, dict[str, str]] = {}
    with Engine(ENGINES[0], seconds) as first, Engine(ENGINES[1], seconds) as second:
        for problem in sorted(problems().values(), key=lambda p: p.id):
            script = problem.smt_lib()
            digest = hashlib.sha256(script.encode()).hexdigest()[:16]
            if old.get(problem.id, {}).get("sha256") == digest:
                new[problem.id] = old[problem.id]
                continue
            new[problem.id] = {"sha256": digest, **{e.name: e.answer(script) for e in (first, second)}}
            print(problem.id, *(new[problem.id][name] for name in ENGINES), flush=True)
    PATH.write_text(json.dumps(new, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 30)
