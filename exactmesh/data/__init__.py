"""Example inputs that come with the package: real outlines, as GeoJSON in decimal degrees.

Source: Natural Earth 4.1.0 (public domain), as redistributed by world-atlas 2.0.2 in TopoJSON, which puts
coordinates on a grid of 100,000 x 100,000 steps. They are rounded to 4 decimals here, and the decimals that
are written are the exact input. Every outline is the largest ring of its country and one simple polygon (a
`Feature` with a `Polygon`); the few vertices where the quantised ring touched or crossed itself are left
out and counted in the file. `south-america` is a map (a `FeatureCollection`): countries that share a border
list the same points on it, so that the union of all rings is a PSLG.
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
