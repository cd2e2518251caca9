"""The command `claims`."""

import argparse
import json
import sys
from collections.abc import Sequence

from exactmesh import report
from exactmesh.claims.ledger import CLAIMS, claim_by_id, judge_one
from exactmesh.claims.run import ConstructionName, Run
from exactmesh.claims.status import Entry, ledger
from exactmesh.claims.witnesses import WITNESSES
from exactmesh.commands.construction import add_construction
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.limits import add_limits
from exactmesh.commands.options import Subparsers, add_quiet
from exactmesh.errors import InputError
from exactmesh.io.read import read_pslg
from exactmesh.paper import paper_options
from exactmesh.progress import Progress
from exactmesh.report_ledger import entry_text, ledger_json, ledger_text


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("claims", help="the ledger of claims, or one claim, or one judged on one input")
    command.add_argument("id", metavar="ID", nargs="?")
    on = command.add_mutually_exclusive_group()
    on.add_argument("--on", metavar="FILE", help="judge the claim on this input")
    on.add_argument("--witness", metavar="NAME", help="judge the claim on a witness that comes along")
    on.add_argument("--store", metavar="FILE", help="show what searches and verify-runs in this store say as well")
    add_construction(command, default=None)
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_quiet(command)
    add_limits(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    if args.id is None and (args.on or args.witness):
        raise InputError("which claim is to be judged? give its ID")
    chosen = CLAIMS if args.id is None else (claim_by_id(args.id),)
    with Progress(args.quiet) as progress:
        if not args.on and not args.witness:
            entries = ledger(chosen, progress)
            print(_shown(entries, args))
            return HOLDS
        claim = chosen[0]
        pslg = read_pslg(args.on or str(WITNESSES.path(args.witness))).pslg
        construction: ConstructionName = args.construction or (claim.runs or ("repaired",))[0]
        judgement = judge_one(claim, Run(pslg, construction, claim.kinds[0], paper_options(dict(args.paper)), progress))
    print(json.dumps(report.claim_json(claim, judgement.verdict)) if args.json else report.claims_text([judgement]))
    if not judgement.verdict.holds:
        print(report.failures_text([judgement]), file=sys.stderr)
    return HOLDS if judgement.verdict.holds else FAILS


def _shown(entries: Sequence[Entry], args: argparse.Namespace) -> str:
    """Return the ledger, or a claim, with what a store says where one is given."""
    lines: dict[str, list[str]] | None = None
    records: dict[str, list[dict[str, object]]] = {}
    if args.store:
        from exactmesh.search.evidence import evidence_in, evidence_lines, evidence_records
        from exactmesh.search.store import Store

        with Store(args.store, create=False) as store:
            found = evidence_in(store)
        lines = {entry.claim.id: evidence_lines(found, entry.claim.id) for entry in entries}
        for record in evidence_records(found):
            records.setdefault(str(record["id"]), []).append(record)
    if args.json:
        return ledger_json(entries, records)
    if args.id is None:
        return ledger_text(entries, lines)
    return entry_text(entries[0], (lines or {}).get(args.id, ()))
