"""Read SVG pictures back: paths by what they are of, with absolute places in pixels of their panels."""

import re
import xml.etree.ElementTree as ET
from typing import NamedTuple

SVG = "{http://www.w3.org/2000/svg}"
_TOKEN = re.compile(r"[mlhz]|-?\d+")


class Path(NamedTuple):
    """The chains of one path, in pixels, and whether each is closed."""

    chains: list[list[tuple[float, float]]]
    closed: list[bool]
    attributes: dict[str, str]


def root_of(text: str) -> ET.Element:
    """Return the root of a picture."""
    root = ET.fromstring(text)
    assert root.tag == f"{SVG}svg"
    return root


def panels(root: ET.Element, step: str | None = None) -> list[ET.Element]:
    """Return the panels, or those of one step."""
    found = [g for g in root.iter(f"{SVG}g") if g.get("class") == "panel"]
    return [g for g in found if step is None or g.get("data-step") == step]


def paths(element: ET.Element, name: str) -> list[Path]:
    """Return the paths of one class."""
    return [_read(path) for path in element.iter(f"{SVG}path") if path.get("class") == name]


def one(element: ET.Element, name: str) -> Path:
    """Return the only path of a class."""
    (found,) = paths(element, name)
    return found


def count(element: ET.Element, name: str) -> int:
    """Return the number of chains, polygons or dots of a class."""
    return sum(len(path.chains) for path in paths(element, name))


def texts(element: ET.Element, name: str) -> list[str]:
    """Return the texts of a class."""
    return [text.text or "" for text in element.iter(f"{SVG}text") if text.get("class") == name]


def _read(path: ET.Element) -> Path:
    tokens = _TOKEN.findall(path.attrib["d"])
    assert "".join(path.attrib["d"].split()) == "".join(tokens), "nothing else is in the path"
    chains: list[list[tuple[float, float]]] = []
    closed: list[bool] = []
    x = y = 0
    i = 0
    command = ""
    while i < len(tokens):
        if tokens[i] in "mlhz":
            command = tokens[i]
            i += 1
            if command == "z":
                closed[-1] = True
                x, y = (round(100 * place) for place in chains[-1][0])
                continue
        if command == "h":
            assert tokens[i] == "0"
            i += 1
            continue
        x, y = x + int(tokens[i]), y + int(tokens[i + 1])
        i += 2
        if command == "m":
            chains.append([])
            closed.append(False)
        chains[-1].append((x / 100, y / 100))
    return Path(chains, closed, dict(path.attrib))
