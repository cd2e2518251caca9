"""A real browser for the viewer's tests.

The browser is the one that EXACTMESH_CHROMIUM names, or else a Chromium or Chrome on the path. Where there is none, or
no playwright, these tests fail if CI is set, and are skipped otherwise: nothing is skipped where it counts.
"""

import os
import shutil
from collections.abc import Iterator
from typing import Any

import pytest

_NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
_FLAGS = ("--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
          "--disable-component-update", "--disable-sync")


def _missing(what: str) -> None:
    reason = f"the viewer's tests need {what}"
    if os.environ.get("CI"):
        pytest.fail(reason)
    pytest.skip(reason)


def _executable() -> str | None:
    named = os.environ.get("EXACTMESH_CHROMIUM")
    return named or next((path for path in map(shutil.which, _NAMES) if path), None)


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    executable = _executable()
    if executable is None:
        _missing("Chromium: set EXACTMESH_CHROMIUM, or put it on the path")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _missing("the package playwright")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=list(_FLAGS))
        yield browser
        browser.close()


class Opener:
    """Opens pages; whatever a page writes to the console, throws, or asks of the network is collected."""

    def __init__(self, browser: Any) -> None:
        self.browser = browser
        self.contexts: list[Any] = []
        self.complaints: list[str] = []
        self.requests: list[str] = []

    def __call__(self, address: str, scheme: str = "light", **settings: Any) -> Any:
        size = {"width": 1200, "height": 800}
        settings = {"viewport": size, "color_scheme": scheme, "reduced_motion": "reduce", **settings}
        context = self.browser.new_context(**settings)
        self.contexts.append(context)
        context.set_default_timeout(15_000)
        page = context.new_page()
        page.on("console", lambda message: self.complaints.append(f"{message.type}: {message.text}"))
        page.on("pageerror", lambda error: self.complaints.append(f"thrown: {error}"))
        page.on("request", lambda request: self.requests.append(request.url))
        page.goto(address)
        return page


@pytest.fixture
def open_page(browser: Any) -> Iterator[Opener]:
    """Pages that are closed at the end; a page that has complained fails the test."""
    opener = Opener(browser)
    yield opener
    for context in opener.contexts:
        context.close()
    assert opener.complaints == []
