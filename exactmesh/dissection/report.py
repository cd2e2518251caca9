"""What the commands `dissect` and `verify-dissection` say, as text and as JSON."""

import json

from exactmesh.dissection.bound import CUTS_ON_A_VERTICAL, PIECES
from exactmesh.dissection.dissect import Dissected
from exactmesh.dissection.verify import DissectionVerdict
from exactmesh.numbers.rational import decimal_text, sqrt_text


def dissected_text(dissected: Dissected) -> str:
    """Return the counts of a dissection beside their bounds."""
    figures = dissected.figures
    lines = [f"pieces                 {len(dissected.dissection.pieces)}",
             f"cells of the strips    {' + '.join(map(str, dissected.cells))}, height {dissected.epsilon}",
             f"triangulations         {', '.join(dissected.kinds)}",
             f"cuts on a vertical     {dissected.cuts_on_a_vertical} (proved: at most {CUTS_ON_A_VERTICAL})",
             f"bound by cells         {dissected.strip_bound}"]
    if dissected.spread_bound is not None:
        n = " + ".join(str(figure.corners) for figure in figures)
        r = " + ".join(sqrt_text(figure.spread_squared, 4) for figure in figures)
        bound = decimal_text(dissected.spread_bound, 6)
        lines.append(f"bound by the spread    {bound} = {PIECES} x {len(figures)} x ({n}) x ({r})")
    for number, figure in enumerate(figures[1:], 2):
        if figure.scale != 1:
            lines.append(f"polygon {number} is scaled by {figure.scale} = {figure.scale.decimal()}")
    return "\n".join(lines)


def verdict_text(verdict: DissectionVerdict) -> str:
    """Return the verdict in lines."""
    if verdict.refusal is not None:
        place = ", ".join(f"{name} {value}" for name, value in verdict.refusal.place.items())
        return f"no dissection: the clause '{verdict.refusal.clause}' fails at {place}"
    lines = [f"a dissection into {verdict.pieces} pieces of area {verdict.areas[0]} in all"]
    lines += [f"polygon {number} is scaled by {scale} = {scale.decimal()}"
              for number, scale in enumerate(verdict.scales, 1) if scale != 1]
    return "\n".join(lines)


def verdict_json(verdict: DissectionVerdict) -> str:
    """Return what `exactmesh verify-dissection --json` prints."""
    refusal = verdict.refusal
    return json.dumps({
        "valid": verdict.valid, "pieces": verdict.pieces, "areas": [str(area) for area in verdict.areas],
        "scales": [str(scale) for scale in verdict.scales],
        "refusal": None if refusal is None else {"clause": refusal.clause, "place": dict(refusal.place)}})
