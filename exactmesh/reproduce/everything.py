"""Every table and figure, the paper's and ours, computed afresh for one page."""

import hashlib
import json
import platform
from collections.abc import Callable, Iterable, Iterator
from importlib.metadata import PackageNotFoundError, version

from exactmesh.claims.bounds import bounds
from exactmesh.claims.status import ledger
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.dissection.dissect import dissect
from exactmesh.dissection.lower_bound import LENGTHS, rectangle_rows, rectangle_to_square, rectangles_text
from exactmesh.dissection.picture import svg_from_dissection
from exactmesh.io.read import read_pslg
from exactmesh.pictures.svg import svg_text
from exactmesh.proofs import registry
from exactmesh.proofs.prove import prove, summaries
from exactmesh.proofs.report import contradiction
from exactmesh.report import table
from exactmesh.report_ledger import bounds_text, ledger_text
from exactmesh.reproduce.families import FAMILIES
from exactmesh.reproduce.figure_kit import Figure
from exactmesh.reproduce.figures import commands_of, figures, sha256_of
from exactmesh.reproduce.growth import laws
from exactmesh.reproduce.page import Picture, Section, page
from exactmesh.reproduce.peer_inputs import inputs
from exactmesh.reproduce.peers import peer_rows, rounded
from exactmesh.reproduce.peers_text import peers_text
from exactmesh.reproduce.spread import spread_inputs, spread_rows, spread_svg, spread_text
from exactmesh.reproduce.table1 import table1_rows
from exactmesh.reproduce.text import table1_svg, table1_text

Progress = Callable[[str], None]
_TITLE = "Meshes Preserving Minimum Feature Size, reproduced"
_LEAD = ("Every table and figure of the paper by Aloupis, Demaine, Demaine, Dujmovic and Iacono, and of exactmesh, "
         "computed by exact arithmetic. Each has the command that makes it and the hashes of its inputs.")
_SHORT_LENGTHS = tuple(length for length in LENGTHS if length <= 30)
# The dissection that is drawn.
_SHOWN_LENGTH = 5
_SHOWN = f"a dissection of the {_SHOWN_LENGTH} x 1 rectangle and the square of its area"
_PACKAGES = ("exactmesh", "gmpy2", "numpy")


def sections(short: bool, progress: Progress) -> Iterator[Section]:
    """Yield all results in turn; `short` leaves out large inputs. `progress` is told each step."""
    progress("bounds")
    yield Section("bounds", "The paper's numbers", ("exactmesh reproduce bounds",), bounds_text(list(bounds())),
                  about="Each number that the text states, beside its exact value in both readings of d3.")
    yield _table1(short, progress)
    yield _spread(progress)
    yield from _figures(progress)
    yield _ledger(progress)
    yield _proofs(progress)
    yield _dissection(short, progress)
    yield _peers(short, progress)


def report_page(found: Iterable[Section]) -> str:
    """Return the page of all results."""
    return page(_TITLE, _LEAD, versions(), list(found))


def report_json(found: Iterable[Section]) -> str:
    """Return all results for programs, without the pictures."""
    return json.dumps({"versions": versions(), "sections": [section.record() for section in found]}, indent=1) + "\n"


def versions() -> dict[str, str]:
    """Return the versions of what computed the results."""
    found = {"Python": f"{platform.python_version()} ({platform.python_implementation()})"}
    for name in _PACKAGES:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "not installed as a package"
    return found


def _table1(short: bool, progress: Progress) -> Section:
    rows = list(table1_rows(short=short, progress=progress, families=FAMILIES))
    found = laws(rows)
    hashes = {f"{family.name}, {family.variable} = {size}": sha256_of(family.make(size))
              for family in FAMILIES for size in family.sizes(short)}
    return Section("table1", "Table 1: degradations by kind of triangulation",
                   (f"exactmesh reproduce table1{' --short' if short else ''} -o DIR",), table1_text(rows, found),
                   (Picture(table1_svg(rows), "degradations by kind of mesh", is_plain=False),), hashes,
                   not any(law.failures for law in found))


def _spread(progress: Progress) -> Section:
    rows = list(spread_rows(progress))
    hashes = {pslg.name: sha256_of(pslg) for pslg in spread_inputs()}
    return Section("spread", "Degradation and spread", ("exactmesh reproduce spread",), spread_text(rows), (
        Picture(spread_svg(rows), "degradation and length", is_plain=False),), hashes,
                   about="The published construction degrades with the length of a room; the repaired one does not.")


def _figures(progress: Progress) -> Iterator[Section]:
    yield Section("figures", "Figures 1 to 10, and where they fail", ("exactmesh reproduce figures -o DIR",),
                  about="From real runs. A companion shows a refuted claim, its witness, and what the repaired "
                  "construction does in the same place.")
    for figure in figures(progress=progress):
        yield _figure(figure)


def _figure(figure: Figure) -> Section:
    hashes = {f"inputs/{name}.json": sha256_of(pslg) for name, pslg in figure.inputs.items()}
    return Section(figure.name, figure.title, commands_of(figure), "",
                   (Picture(svg_text(figure.scene), figure.title),), hashes, is_part=True)


def _ledger(progress: Progress) -> Section:
    hashes = {name: read_pslg(str(WITNESSES.path(name))).sha256 for name in WITNESSES.names()}
    return Section("claims", "The ledger of claims", ("exactmesh claims",), ledger_text(ledger(progress=progress)), (),
                   hashes, about="Every claim of the paper and of the repaired construction, with what is known of it: "
                   "judged afresh on every witness that comes along.")


def _proofs(progress: Progress) -> Section:
    results = list(prove(fast=True, progress=progress))
    rows: list[tuple[str, ...]] = [("claim", "certificates", "stands")]
    rows += [(found.theorem.claim, f"{sum(found.proved.values())}/{len(found.theorem.problems)}",
              "yes" if found.stands else "NO") for found in summaries(results)]
    hashes = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in registry.files()}
    return Section("proofs", "Proofs for all inputs", ("exactmesh prove --fast",), table(rows, right=(1,)), (), hashes,
                   not contradiction(results), "Certificates, re-checked by rational arithmetic alone.")


def _dissection(short: bool, progress: Progress) -> Section:
    lengths = _SHORT_LENGTHS if short else LENGTHS
    rows = list(rectangle_rows(lengths, progress))
    shown = dissect(rectangle_to_square(_SHOWN_LENGTH), scale=True)
    hashes = {pslg.name: sha256_of(pslg) for length in lengths for pslg in rectangle_to_square(length)}
    return Section("dissection", "Section 5: the square to the r x 1 rectangle", ("exactmesh reproduce dissection",),
                   rectangles_text(rows), (Picture(svg_from_dissection(shown.dissection), _SHOWN, is_plain=False),),
                   hashes, all(row.valid for row in rows))


def _peers(short: bool, progress: Progress) -> Section:
    rows = list(peer_rows(short, progress, inputs(short)))
    hashes = {f"{given.group}, {given.name}": sha256_of(rounded(given.make())) for given in inputs(short)}
    return Section("peers", "Other meshers on the same inputs",
                   (f"exactmesh reproduce peers{' --short' if short else ''} -o DIR",), peers_text(rows), (), hashes,
                   about="Of those that are installed. Their meshes are measured exactly; seconds differ from one time "
                   "to the next.")
