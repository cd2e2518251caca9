"""The results of proofs, as JSON and as text."""

import json
from collections import Counter
from collections.abc import Iterable, Sequence

from exactmesh.proofs.prove import Result, Summary

_SHOWS = {"claim": "proved", "corrected": "corrected form proved", "refuted": "refuted",
          "repaired": "proved of the repaired construction", "part": "part proved"}


def proofs_json(results: Iterable[Result]) -> str:
    """Return what `exactmesh prove --json` prints; `claims` are all that the problem serves, `claim` the first."""
    return json.dumps({"proofs": [
        {"claim": r.claims[0] if r.claims else r.group, "claims": list(r.claims), "problem": r.problem,
         "method": r.method, "result": r.result, "seconds": round(r.seconds, 3), "certificate": r.certificate,
         **({"detail": r.detail} if r.detail else {})} for r in results]}, indent=1)


def summary_text(found: Sequence[Summary], results: Sequence[Result]) -> str:
    """Return a table of the theorems, what is not proved, and the totals."""
    methods = list(dict.fromkeys(m for s in found for m in s.proved))
    rows = [("claim", *methods, "seconds", "result")]
    for s in found:
        total = len(s.theorem.problems)
        rows.append((s.theorem.claim, *(f"{s.proved.get(m, 0)}/{total}" for m in methods), f"{s.seconds:.1f}",
                     _SHOWS[s.theorem.shows] if s.stands else "NOT PROVED"))
    widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))]
    lines = ["  ".join(text.ljust(width) for text, width in zip(row, widths, strict=True)).rstrip() for row in rows]
    lines += [f"{r.problem}: {r.method}: {r.result} {r.detail}".rstrip() for r in results if r.result != r.expected]
    counts = Counter((r.method, r.result) for r in results)
    lines.append("; ".join(f"{method}: {count} {result}" for (method, result), count in counts.items()) or "no proofs")
    return "\n".join(lines)


def contradiction(results: Iterable[Result]) -> bool:
    """Return whether a proof that the tree claims fails."""
    return any(r.contradicts for r in results)
