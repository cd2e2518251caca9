"""A process that evaluates polygons for the editor: requests in, a JSON object a line, parts of answers out.

An answer begins with the part "ready", once the process has started, and has the part "end" at last. It is a process of
its own so that an input that takes too long can be stopped; it ends when its input does.
"""

import json
import signal
import sys
import traceback
from collections.abc import Mapping

from exactmesh.errors import InputError
from exactmesh.io.strict_json import parse_json
from exactmesh.viewer.evaluate import evaluate


def main() -> None:
    """Answer requests {"pslg": .., "claims": true or false}, one after the other."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the server ends its workers
    for line in sys.stdin:
        _send({"part": "ready"})
        try:
            request = parse_json(line)
            if not isinstance(request, dict) or "pslg" not in request:
                raise InputError("a request is an object with a pslg")
            for part in evaluate(request["pslg"], request.get("claims") is True):
                _send(part)
        except InputError as error:
            _send({"part": "error", "message": str(error)})
            _send({"part": "end"})
        except Exception as error:  # a fault of ours: the person sees it, and the next request finds a worker
            traceback.print_exc()
            _send({"part": "error", "message": f"internal error: {error!r}"})
            _send({"part": "end"})


def _send(part: Mapping[str, object]) -> None:
    sys.stdout.write(json.dumps(part, separators=(",", ":")) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
