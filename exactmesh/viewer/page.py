"""One HTML file of templates, a style sheet, scripts and data: nothing is fetched, and nothing else can run in it."""

import base64
import hashlib
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path

from exactmesh.viewer.document import json_text

_FOLDER = Path(__file__).parent
_SHARED = ("rational.js", "box_tree.js", "camera.js", "raster.js", "scene.js", "painter.js", "view.js", "panels.js")


def viewer_page(document: Mapping[str, object]) -> str:
    """Return the page of a document."""
    title = str(document["title"])
    return _page("viewer.html", (*_SHARED, "viewer.js"), title, title, document, "'none'")


def editor_page(settings: Mapping[str, object]) -> str:
    """Return the editor's page, which talks to the server it comes from."""
    return _page("editor.html", (*_SHARED, "drawing.js", "editor.js"), "editor", "exactmesh editor", settings, "'self'")


def _page(panes: str, scripts: Sequence[str], title: str, heading: str, data: Mapping[str, object],
          connect: str) -> str:
    style = _asset("style.css")
    code = [_asset(name) for name in scripts]
    policy = (f"default-src 'none'; connect-src {connect}; style-src {_hash(style)}; "
              f"script-src {' '.join(map(_hash, code))}; base-uri 'none'; form-action 'none'")
    parts = {"policy": policy, "title": escape(title), "heading": escape(heading), "style": style,
             "data": json_text(data), "scripts": "\n".join(f"<script>{text}</script>" for text in code)}
    text = _asset("page.html").replace("{{panes}}", _asset(panes)).replace("{{zoom}}", _asset("zoom.html"))
    # One pass, so that what is put in is not searched for placeholders again.
    pieces = text.split("{{")
    return pieces[0] + "".join(parts[name] + rest for name, _, rest in (piece.partition("}}") for piece in pieces[1:]))


def _asset(name: str) -> str:
    return (_FOLDER / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    return f"'sha256-{base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()}'"
