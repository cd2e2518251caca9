"""The editor's server, for one person on one machine: it listens on the loopback address only.

A page elsewhere can make a browser send requests here, under another name for this machine too (DNS rebinding). So the
Host must be this server's own; everything needs the token, which only the address that was printed has; and what is
asked for is a header that other sites may not send. Bodies are limited, silent connections are dropped.
"""

import hmac
import json
import secrets
import sys
from collections.abc import Callable, Generator, Mapping
from contextlib import closing
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from urllib.parse import parse_qs, urlsplit

from exactmesh.errors import InputError
from exactmesh.io.atomic import write_text
from exactmesh.io.pslg_json import json_from_pslg, pslg_from_json
from exactmesh.io.text import text_from_bytes
from exactmesh.planar.pslg import Pslg
from exactmesh.viewer.page import editor_page
from exactmesh.viewer.workers import Workers

ADDRESS = "127.0.0.1"
MAX_BODY = 1 << 20
_IDLE_SECONDS = 30
_TOKEN_HEADER = "X-Exactmesh-Token"


class Editor(ThreadingHTTPServer):
    """The server; `url` is the address to open. `output` is the file that the page may save to, if any.

    Raises `InputError` when the port is taken or not to be had.
    """

    daemon_threads = True

    def __init__(self, pslg: Pslg, output: str | None, port: int, seconds: float) -> None:
        self.workers = Workers(seconds)  # first: where the port is refused, `server_close` is called
        try:
            super().__init__((ADDRESS, port), _Handler)
        except (OSError, OverflowError) as error:
            raise InputError(f"port {port}: cannot be listened on: {getattr(error, 'strerror', None) or error}"
                             ) from error
        self.token = secrets.token_urlsafe(24)
        self.output = output
        self.page = editor_page({
            "pslg": {"vertices": [[str(p.x), str(p.y)] for p in pslg.vertices], "edges": pslg.edges,
                     "holes": [[str(p.x), str(p.y)] for p in pslg.holes], "name": pslg.name},
            "token": self.token, "saves": output is not None})

    @property
    def url(self) -> str:
        """The address of the page, with the token."""
        return f"http://{ADDRESS}:{self.server_port}/?token={self.token}"

    def handle_error(self, request: object, client_address: object) -> None:
        """Say nothing of connections that end early; print what is a fault of ours."""
        if not isinstance(sys.exception(), OSError):
            super().handle_error(request, client_address)  # type: ignore[arg-type]

    def server_close(self) -> None:
        """Close the socket and end the workers."""
        super().server_close()
        self.workers.close()


class _Handler(BaseHTTPRequestHandler):
    """GET / is the page; POST /evaluate takes what a worker does, POST /save an exactmesh-pslg/1."""

    server: Editor
    protocol_version = "HTTP/1.1"
    server_version, sys_version = "exactmesh", ""
    timeout = _IDLE_SECONDS

    def do_GET(self) -> None:
        """Send the page to whoever has the token."""
        if not self._is_our_host():
            return
        address = urlsplit(self.path)
        if address.path != "/":
            self._refuse(HTTPStatus.NOT_FOUND, "there is nothing here")
        elif not self._knows(parse_qs(address.query).get("token", [""])[0]):
            self._refuse(HTTPStatus.FORBIDDEN, "open the address that exactmesh has printed, token included")
        else:
            self._send(HTTPStatus.OK, "text/html; charset=utf-8", self.server.page.encode())

    def do_POST(self) -> None:
        """Answer a request of the page."""
        actions: Mapping[str, Callable[[str], None]] = {"/evaluate": self._evaluate, "/save": self._save}
        if not self._is_our_host():
            return
        if self.path not in actions:
            self._refuse(HTTPStatus.NOT_FOUND, "there is nothing here")
            return
        if not self._knows(self.headers.get(_TOKEN_HEADER, "")):
            self._refuse(HTTPStatus.FORBIDDEN, "the token is missing or wrong")
            return
        body = self._body()
        if body is None:
            return
        try:
            actions[self.path](text_from_bytes(body))
        except InputError as error:
            self._refuse(HTTPStatus.BAD_REQUEST, str(error))

    def log_message(self, format: str, *args: object) -> None:
        """Say nothing: the terminal is for what concerns the person."""

    def _evaluate(self, text: str) -> None:
        """Send the parts of the answer, a JSON object a line, as they come."""
        # A line to the worker; in JSON line breaks stand between tokens only.
        parts = self.server.workers.answer(text.replace("\n", " ").replace("\r", " "))
        self.send_response(HTTPStatus.OK)
        self._headers("application/x-ndjson")
        self.send_header("Transfer-Encoding", "chunked")
        self.end_headers()
        self._stream(parts)

    def _stream(self, parts: Generator[Mapping[str, object], None, None]) -> None:
        try:
            with closing(parts):  # also when nobody waits for the rest
                for part in parts:
                    line = json.dumps(part, separators=(",", ":")).encode() + b"\n"
                    self.wfile.write(b"%x\r\n%b\r\n" % (len(line), line))
                    self.wfile.flush()
            self.wfile.write(b"0\r\n\r\n")
        except OSError:  # the page has gone, or asks for something newer
            self.close_connection = True

    def _save(self, text: str) -> None:
        if self.server.output is None:
            raise InputError("no file was named with -o: download the polygon instead")
        write_text(self.server.output, json_from_pslg(pslg_from_json(text)))
        self._send(HTTPStatus.OK, "application/json", json.dumps({"saved": self.server.output}).encode())

    def _is_our_host(self) -> bool:
        port = self.server.server_port
        if self.headers.get("Host") in (f"{ADDRESS}:{port}", f"localhost:{port}"):
            return True
        self._refuse(HTTPStatus.MISDIRECTED_REQUEST, "this server is for this machine only, under its own name")
        return False

    def _knows(self, token: str) -> bool:
        return hmac.compare_digest(token.encode(), self.server.token.encode())

    def _body(self) -> bytes | None:
        """Return the body; None when it was refused."""
        length = self.headers.get("Content-Length", "")
        if not (length.isascii() and length.isdecimal()):
            self._refuse(HTTPStatus.LENGTH_REQUIRED, "a length is needed")
        elif len(length) > len(str(MAX_BODY)) or int(length) > MAX_BODY:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, f"a request has up to {MAX_BODY} bytes")
        else:
            return self.rfile.read(int(length))
        return None

    def _refuse(self, status: HTTPStatus, reason: str) -> None:
        self.close_connection = True  # a body may be left unread
        self._send(status, "application/json", json.dumps({"error": reason}).encode())

    def _send(self, status: HTTPStatus, kind: str, body: bytes) -> None:
        self.send_response(status)
        self._headers(kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def _headers(self, kind: str) -> None:
        for name, value in (("Content-Type", kind), ("Cache-Control", "no-store"), ("X-Frame-Options", "DENY"),
                            ("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer"),
                            ("Content-Security-Policy", "frame-ancestors 'none'")):
            self.send_header(name, value)
