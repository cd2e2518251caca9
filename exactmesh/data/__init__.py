"""Example inputs that come with the package: real outlines, as GeoJSON in decimal degrees.

Source: Natural Earth (public domain), as redistributed in TopoJSON by world-atlas 2.0.2. Coordinates are
rounded to 4 decimals, and the decimals that are written are the exact input. Every outline is the largest
ring of its country and one simple polygon (a `Feature` with a `Polygon`); where the rounded ring touched
itself, the vertices that did so are left out and the file says how many. `south-america` is a map (a
`FeatureCollection`): countries that share a border list the same points on it, so that the union of all rings
is a PSLG.
"""

from importlib.resources import files
from pathlib import Path

from exactmesh.errors import InputError

_SUFFIX = ".geojson"


def example_names() -> tuple[str, ...]:
    """Return the names of the examples, sorted.

    >>> "luxembourg" in example_names()
    True
    """
    return tuple(sorted(entry.name.removesuffix(_SUFFIX)
                        for entry in files(__name__).iterdir() if entry.name.endswith(_SUFFIX)))


def example_path(name: str) -> Path:
    """Return the path of the GeoJSON file of the example `name`.

    Raises `InputError`, listing the names there are, when there is no such example.
    """
    names = example_names()
    if name not in names:
        raise InputError(f"there is no example {name!r}; there are: {', '.join(names)}")
    return Path(str(files(__name__).joinpath(name + _SUFFIX)))
