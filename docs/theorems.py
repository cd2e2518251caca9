"""Pages that mkdocs builds from the ledger of claims: one for each theorem, and the errata of the paper."""

import json
import re
from itertools import groupby
from typing import Any

from mkdocs.structure.files import File, Files

from exactmesh.claims.claim import Claim
from exactmesh.claims.status import Entry, ledger
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.io.export import export_pslg
from exactmesh.io.read import read_pslg
from exactmesh.proofs.problem import Theorem
from exactmesh.proofs.registry import theorems
from exactmesh.report_ledger import entry_text
from exactmesh.search.catalogue import CATALOGUE

# Beyond this ratio of its sides a picture is a line.
_SLENDER = 200


def on_files(files: Files, config: Any) -> Files:
    """Add the generated pages."""
    entries = ledger()
    pages = [(chapter, list(group)) for chapter, group in groupby(
        sorted(entries, key=lambda entry: _chapters().index(_chapter(entry.claim))), key=lambda e: _chapter(e.claim))]
    index = ["# Theorems\n", "A page for each statement of the paper, and for the construction that repairs it. What "
             "is said here of a claim was computed when this page was built.\n"]
    for chapter, group in pages:
        slug = re.sub(r"\W+", "-", chapter.lower())
        counts = {status: sum(entry.status == status for entry in group)
                  for status in ("proved", "holds", "refuted", "open")}
        index.append(f"- [{chapter}](theorems/{slug}.md): " + ", ".join(
            f"{count} {status}" for status, count in counts.items() if count))
        files.append(File.generated(config, f"theorems/{slug}.md", content=_page(chapter, group)))
    files.append(File.generated(config, "theorems.md", content="\n".join(index) + "\n"))
    files.append(File.generated(config, "errata.md", content=_errata(entries)))
    return files


def _chapters() -> list[str]:
    return ["Abstract and section 1", "Table 1", "Lemma 1", "Lemma 2", "Lemma 3", "Theorem 1: the Interior",
            "Theorem 1: the Tube", "Theorem 1", "Theorem 2", "Theorem 3", "Section 5", "Appendix A",
            "The repaired construction"]


def _chapter(claim: Claim) -> str:
    place = claim.paper
    if place.startswith("repaired"):
        return "The repaired construction"
    if "Tube" in place:
        return "Theorem 1: the Tube"
    if place.startswith("Section 2"):
        return "Theorem 1: the Interior"
    if place.startswith("section 5"):
        return "Section 5"
    if place in ("Abstract", "section 1"):
        return "Abstract and section 1"
    return next(chapter for chapter in _chapters() if place.startswith(chapter))


def _page(chapter: str, entries: list[Entry]) -> str:
    parts = [f"# {chapter}\n"]
    finds = [json.loads(CATALOGUE.path(name).read_text(encoding="utf-8")) for name in CATALOGUE.names()]
    for entry in entries:
        claim = entry.claim
        parts.append(f"## {claim.says}\n\n```text\n{entry_text(entry)}\n```\n")
        if claim.check is not None:
            parts.append(f"Checked by `{claim.check.__module__}.{claim.check.__qualname__}`.\n")
        parts += [f"{theorem.shows.capitalize()}: {theorem.says} ({len(theorem.problems)} problems in exact algebra: "
                  f"`exactmesh prove {claim.id}`){_rests_on(theorem)}\n"
                  for theorem in theorems() if theorem.claim == claim.id]
        parts += [f"Worst found, {find['worst']} ({find['target'][1]}, {find['target'][2]}): `{find['command']}`\n"
                  for find in finds if find["target"][0] == claim.id]
        witnesses = dict.fromkeys(judged.witness for judged in entry.judged if judged.witness)
        parts += [f"The input `{name}`:\n\n{_picture(name)}\n" for name in witnesses]
    return "\n".join(parts)


def _rests_on(theorem: Theorem) -> str:
    return f", with {', '.join(f'`{claim}`' for claim in theorem.claims)}" if theorem.claims else ""


def _picture(name: str) -> str:
    pslg = read_pslg(str(WITNESSES.path(name))).pslg
    spans = [max(values) - min(values) for values in zip(*pslg.vertices, strict=True)]
    if max(spans) > _SLENDER * min(spans):
        return f"It has {len(pslg.vertices)} vertices, and is too slender to be drawn."
    svg = export_pslg(pslg, ".svg")[0].files[".svg"].decode()
    # Without its own style sheet, which would hold for the whole page.
    return re.sub(r"<style>.*?</style>", "", svg).replace("<svg ", '<svg class="witness" ').replace("\n", "")


def _errata(entries: list[Entry]) -> str:
    parts = ["# Errata of the paper\n", "Statements that are false of the published construction, or of the figures "
             "they speak of. Each has an exact witness, and a command that shows it.\n"]
    parts += [f"## {entry.claim.says}\n\n```text\n{entry_text(entry)}\n```\n"
              for entry in entries if entry.status == "refuted"]
    return "\n".join(parts)
