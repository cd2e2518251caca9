"""The input format `exactmesh-pslg/1`.

Read here: keys, types, scalars and index ranges. Not checked: that the graph is planar, which is for
`exactmesh.planar.validate`.
"""

import json

from exactmesh.errors import FormatError
from exactmesh.io.as_written import pslg_as_written
from exactmesh.io.json_fields import each, edge, fields, point, point_rows, rows
from exactmesh.io.strict_json import Json, described, parse_json
from exactmesh.planar.pslg import Pslg

FORMAT = "exactmesh-pslg/1"


def pslg_from_json(text: str) -> Pslg:
    """Return the PSLG of a file's text; raises `FormatError` naming the place, such as `vertices[3][1]`."""
    quick = pslg_as_written(text)
    return pslg_from_value(parse_json(text)) if quick is None else quick


def pslg_from_value(value: Json) -> Pslg:
    """Return the PSLG of a parsed file; raises `FormatError` naming the place."""
    found = fields(value, FORMAT, ("vertices", "edges"), ("holes", "name"))
    vertices = each(found["vertices"], "vertices", point)
    count = len(vertices)
    edges = each(found["edges"], "edges", lambda pair: edge(pair, count))
    holes = each(found.get("holes", []), "holes", point)
    name = found.get("name", "")
    if not isinstance(name, str):
        raise FormatError("name", f"a string is expected, not {described(name)}")
    return Pslg(vertices, edges, holes, name)


def json_from_pslg(pslg: Pslg) -> str:
    """Return the text of a file that is read back as the same PSLG, its name included."""
    edges = rows(f"[{u}, {v}]" for u, v in pslg.edges)
    parts = [f'"format": "{FORMAT}"',
             f'"vertices": {point_rows(pslg.vertices)}',
             f'"edges": {edges}']
    if pslg.holes:
        parts.append(f'"holes": {point_rows(pslg.holes)}')
    if pslg.name:
        # Escaped to ASCII, because a JSON string may hold a lone surrogate, and UTF-8 may not.
        parts.append(f'"name": {json.dumps(pslg.name)}')
    return "{" + ",\n ".join(parts) + "}\n"
