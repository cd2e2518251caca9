"""Decision procedures for real polynomial constraints, each in a process of its own: z3 and cvc5, where installed.

A worker reads scripts, one JSON string a line, and writes an answer a line. It is ended when it overstays its time.
"""

import importlib.util
import json
import select
import subprocess
import sys
from types import TracebackType
from typing import Any, Self

ENGINES = ("z3", "cvc5")
# What a worker may overstay the time it was given: to start, and to notice.
_GRACE = 10.0


def installed(engine: str) -> bool:
    """Return whether an engine can be used."""
    return importlib.util.find_spec(engine) is not None


class Engine:
    """A running engine; use it in a `with` statement."""

    def __init__(self, name: str, seconds: float) -> None:
        self.name, self.seconds = name, seconds
        self._worker: subprocess.Popen[str] | None = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
                 ) -> None:
        self._stop()

    def answer(self, script: str) -> str:
        """Return `unsat`, `sat`, `unknown`, `timeout`, or `error: ...`, which is not an answer."""
        if self._worker is None or self._worker.poll() is not None:
            self._worker = subprocess.Popen([sys.executable, "-m", __name__, self.name, str(self.seconds)],
                                            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        stdin, stdout = self._worker.stdin, self._worker.stdout
        if stdin is None or stdout is None:
            return "error: no pipe"
        stdin.write(json.dumps(script) + "\n")
        stdin.flush()
        if not select.select([stdout], [], [], self.seconds + _GRACE)[0]:
            self._stop()
            return "timeout"
        line = stdout.readline().strip()
        return line or "error: the engine stopped"

    def _stop(self) -> None:
        if self._worker is not None:
            self._worker.kill()
            self._worker.wait()
            self._worker = None


def _z3(script: str, seconds: float) -> str:
    import z3
    solver = z3.SolverFor("QF_NRA")
    solver.set("timeout", int(seconds * 1000))
    solver.from_string(script)
    result = str(solver.check())
    return "timeout" if result == "unknown" and solver.reason_unknown() in ("timeout", "canceled") else result


def _cvc5(script: str, seconds: float) -> str:
    import cvc5
    solver = cvc5.Solver()
    solver.setOption("tlimit-per", str(int(seconds * 1000)))
    solver.setOption("nl-cov", "true")
    parser = cvc5.InputParser(solver)
    parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, script, "problem")
    result = ""
    while not (command := parser.nextCommand()).isNull():
        result += str(command.invoke(solver, parser.getSymbolManager()))
    return "timeout" if result.startswith("unknown") else result.strip()


def _serve(engine: str, seconds: float) -> None:
    solve: dict[str, Any] = {"z3": _z3, "cvc5": _cvc5}
    for line in sys.stdin:
        try:
            answer = solve[engine](json.loads(line), seconds)
        except Exception as error:
            answer = f"error: {error}".replace("\n", " ")
        print(answer, flush=True)


if __name__ == "__main__":
    _serve(sys.argv[1], float(sys.argv[2]))
