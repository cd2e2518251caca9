"""The editor's server: exact answers, and nothing for strangers."""

import http.client
import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from editing import Served, children, editor, is_alive, polygon_json, started

from exactmesh.claims.run import Run
from exactmesh.io.pslg_json import pslg_from_json
from exactmesh.planar.pslg import polygon

SQUARE = polygon_json(("0", "0"), ("3", "0"), ("3", "3"), ("0", "3"))
# The repaired construction needs some seconds for this comb, more than the limit below.
SLOW = polygon_json(*[(str(x), "0" if i in (0, 299) else str(10 + 3 * (i % 2) + i % 7))
                      for i, x in enumerate([0, *range(0, 298), 297])])


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Served]:
    folder = tmp_path_factory.mktemp("edit")
    with editor("-o", str(folder / "saved.json"), "--time-limit", "20") as running:
        yield running


def test_the_answer_is_that_of_the_library(served: Served) -> None:
    parts = served.parts(SQUARE, claims=True)
    assert [part["part"] for part in parts] == ["input", "repaired", "paper", "end"]
    square = polygon([(0, 0), (3, 0), (3, 3), (0, 3)])
    assert parts[0]["sizes"][0]["squared"] == "9"
    for part, name in ((parts[1], "repaired"), (parts[2], "paper")):
        run = Run(square, name)
        document = part["document"]
        assert document["x"][:4] == ["0", "3", "3", "0"] and document["vertices"] == len(run.mesh.vertices)
        assert [tuple(face) for face in document["faces"]] == list(run.mesh.faces)
        assert document["degradation"]["squared"] == str(run.verification.degradation_squared)
        assert len(document["claims"]) > 15
    quick = served.parts(SQUARE)
    assert [part["part"] for part in quick] == ["input", "repaired", "end"] and quick[1]["document"]["claims"] == []


@pytest.mark.parametrize("pslg, message, place", [
    (polygon_json(("0", "0"), ("4", "4"), ("4", "0"), ("0", "4")), "edges 0 (0, 1) and 2 (2, 3) cross at (2, 2)",
     {"edges": [[0, 1], [2, 3]], "at": ["2", "2"]}),
    (polygon_json(("0", "0"), ("4", "0"), ("2", "0"), ("2", "3")), "", None),
    (polygon_json(("0", "0"), ("4", "0"), ("0", "0"), ("2", "3")), "vertices 0 and 2 coincide at (0, 0)",
     {"vertices": [0, 2], "at": ["0", "0"]}),
    (polygon_json(("0", "0"), ("4", "0"), ("4", "3"), ("2", "0"), ("0", "3")),
     "vertex 3 lies on edge 0 (0, 1) at (2, 0)", {"vertices": [3], "edges": [[0, 1]], "at": ["2", "0"]}),
    ({**SQUARE, "edges": [[0, 1]]}, "the edges enclose nothing: there is no bounded face to mesh", None),
    ({**SQUARE, "holes": [["3", "1"]]}, "hole point 0 at (3, 1) lies on edge 1 (1, 2): it must lie inside a face",
     {"at": ["3", "1"]}),
    ({**SQUARE, "edges": [[0, 9]]}, "edges[0][1]: vertex 9 does not exist (there are 4)", None),
    (polygon_json(("0", "0"), ("1e9999", "0"), ("1", "1")), "vertex 1: the editor takes coordinates of up to 4096 bits",
     None),
    ({**SQUARE, "vertices": [["0", "0"]] * 1001}, "the editor takes up to 1000 vertices, not 1001", None),
    (7, "an object of format 'exactmesh-pslg/1' is expected, not the number 7", None)])
def test_what_is_no_polygon_is_told_with_its_place(served: Served, pslg: object, message: str, place: object) -> None:
    parts = served.parts(pslg)
    assert [part["part"] for part in parts] == ["error", "end"]
    assert message in parts[0].pop("message")
    parts[0].pop("part")
    if message:
        assert parts[0] == (place or {})


def test_what_the_paper_does_not_cover_is_refused_by_name(served: Served) -> None:
    ring = polygon_json(("0", "0"), ("9", "0"), ("9", "9"), ("0", "9"), ("3", "3"), ("6", "3"), ("6", "6"), ("3", "6"))
    ring["edges"] = [[i, (i + 1) % 4] for i in range(4)] + [[4 + i, 4 + (i + 1) % 4] for i in range(4)]
    parts = served.parts(ring, claims=True)
    assert parts[2] == {"part": "paper", "refused": "the paper's construction is for one simple polygon; this input is "
                        "more than that"}


def test_saving_writes_the_named_file(served: Served) -> None:
    status, body = served.ask("POST", "/save", json.dumps(SQUARE).encode())
    saved = pslg_from_json(Path(json.loads(body)["saved"]).read_text(encoding="utf-8"))
    assert status == 200 and saved.edges == ((0, 1), (1, 2), (2, 3), (3, 0))
    assert served.ask("POST", "/save", b'{"format": "exactmesh-pslg/1"}')[0] == 400


def test_strangers_get_nothing(served: Served) -> None:
    port = served.port
    assert served.ask("GET", f"/?token={served.token}", Host="evil.example")[0] == 421
    assert served.ask("GET", f"/?token={served.token}", Host=f"127.0.0.1.nip.io:{port}")[0] == 421
    assert served.ask("POST", "/evaluate", b"{}", Host=f"evil.example:{port}")[0] == 421
    assert served.ask("GET", "/")[0] == served.ask("GET", "/?token=x")[0] == 403
    assert served.ask("GET", "/", X_Exactmesh_Token="")[0] == 403
    for wrong in ("", "x", served.token[:-1]):
        assert served.ask("POST", "/evaluate", b"{}", X_Exactmesh_Token=wrong)[0] == 403
        assert served.ask("POST", "/save", b"{}", X_Exactmesh_Token=wrong)[0] == 403
    assert served.ask("GET", f"/?token={served.token}", Host=f"localhost:{port}")[0] == 200
    assert served.ask("GET", "/etc/passwd")[0] == served.ask("POST", "/", b"{}")[0] == 404
    with pytest.raises(OSError), socket.create_connection((socket.gethostbyname(socket.gethostname()), port), 2):
        if socket.gethostbyname(socket.gethostname()).startswith("127."):
            raise OSError("this machine has no address but the loopback one")


def test_bodies_are_limited(served: Served) -> None:
    for length, status in ((str((1 << 20) + 1), 413), ("9" * 30, 413), (None, 411), ("-1", 411), ("x", 411)):
        connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=20)
        connection.putrequest("POST", "/evaluate")
        connection.putheader("X-Exactmesh-Token", served.token)
        if length is not None:
            connection.putheader("Content-Length", length)
        connection.endheaders()
        assert connection.getresponse().status == status
        connection.close()
    assert served.ask("POST", "/evaluate", b"1" + b" " * ((1 << 20) - 1))[0] == 200
    assert served.ask("POST", "/evaluate", b"\xff")[0] == 400
    assert served.ask("PUT", "/evaluate", b"{}")[0] == 501
    status, body = served.ask("POST", "/evaluate", b"[1,\r\n2]")
    assert status == 200 and b"a request is an object with a pslg" in body


def test_headers_keep_the_page_to_itself(served: Served) -> None:
    connection = http.client.HTTPConnection("127.0.0.1", served.port, timeout=20)
    connection.request("GET", f"/?token={served.token}")
    answer = connection.getresponse()
    page = answer.read().decode()
    headers = {name: answer.headers[name] for name in ("X-Frame-Options", "Referrer-Policy", "Cache-Control")}
    connection.close()
    assert headers == {"X-Frame-Options": "DENY", "Referrer-Policy": "no-referrer", "Cache-Control": "no-store"}
    assert "default-src 'none'; connect-src 'self'" in page


def test_what_takes_too_long_is_stopped_and_the_next_is_answered() -> None:
    with editor("--time-limit", "1") as served:
        assert served.parts(SQUARE)[-1]["part"] == "end"  # started
        before = time.monotonic()
        assert served.parts(SLOW, claims=True)[-1] == {"part": "timeout", "seconds": 1}
        assert time.monotonic() - before < 10
        assert served.parts(SQUARE)[-1]["part"] == "end"


def test_a_newer_request_stops_the_older_one(served: Served) -> None:
    older: list[dict[str, object]] = []
    thread = threading.Thread(target=lambda: older.extend(served.parts(SLOW, claims=True)))
    thread.start()
    time.sleep(0.5)
    assert served.parts(SQUARE)[-1]["part"] == "end"
    thread.join(20)
    assert older[-1]["part"] == "superseded"
    assert served.parts(SQUARE)[-1]["part"] == "end"


def test_a_worker_that_dies_is_replaced(served: Served) -> None:
    for pid in children(served.process.pid):
        os.kill(pid, signal.SIGKILL)
    seen = [served.parts(SQUARE)[-1]["part"] for _ in range(3)]
    assert seen[-1] == "end" and set(seen) <= {"stopped", "end"}


def test_workers_end_with_the_server_however_it_ends() -> None:
    with started() as served:
        served.parts(SQUARE)
        workers = children(served.process.pid)
        assert len(workers) == 2  # one has answered, one stands by
        served.process.kill()
        served.process.wait()
        until = time.monotonic() + 20
        while any(map(is_alive, workers)) and time.monotonic() < until:
            time.sleep(0.05)
        assert [pid for pid in workers if is_alive(pid)] == []


def test_a_taken_port_is_told_in_a_line(served: Served) -> None:
    command = [sys.executable, "-m", "exactmesh", "view", "--edit", "--no-browser", "--port", str(served.port)]
    found = subprocess.run(command, capture_output=True, text=True, timeout=30, check=False)
    assert found.returncode == 2
    assert found.stderr == f"exactmesh: port {served.port}: cannot be listened on: Address already in use\n"
