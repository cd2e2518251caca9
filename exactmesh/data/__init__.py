"""Example inputs that come with the package: real outlines, as GeoJSON in decimal degrees.

Source: Natural Earth 4.1.0 (public domain), as redistributed by world-atlas 2.0.2 in TopoJSON, which puts
coordinates on a grid of 100,000 x 100,000 steps. They are rounded to 4 decimals here, and the decimals that
are written are the exact input. Every outline is the largest ring of its country and one simple polygon (a
`Feature` with a `Polygon`); the few vertices where the quantised ring touched or crossed itself are left
out and counted in the file. `south-america` is a map (a `FeatureCollection`): countries that share a border
list the same points on it, so that the union of all rings is a PSLG.
"""

from exactmesh.io.shelf import Shelf

EXAMPLES = Shelf(__name__, ".geojson", "example")
