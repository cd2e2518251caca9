"""The command `search`."""

import argparse
import json

from exactmesh.commands.engine import add_engine, run_search
from exactmesh.commands.exit_status import FAILS, HOLDS
from exactmesh.commands.options import Subparsers, positive
from exactmesh.planar.mesh import KINDS
from exactmesh.search import show
from exactmesh.search.driver import totals, worst_text
from exactmesh.search.families import FAMILIES
from exactmesh.search.guided import require_hypothesis
from exactmesh.search.spec import STRATEGIES, Spec, search_tasks
from exactmesh.search.store import Store
from exactmesh.search.targets import OBJECTIVES, target_of
from exactmesh.search.verify_run import parsed_family


def add(commands: Subparsers) -> None:
    """Add the command to a parser's."""
    command = commands.add_parser("search", help="search for an input on which a claim fails or comes closest")
    command.add_argument("claim", metavar="CLAIM", help=f"a claim, or an objective: {', '.join(OBJECTIVES)}")
    command.add_argument("--construction", choices=("repaired", "paper", "classic", "coarse"))
    command.add_argument("--kind", choices=KINDS)
    command.add_argument("--strategy", choices=[name for name in STRATEGIES if name != "inputs"], default="climb",
                         help="exhaustive: all lattice polygons; random: figures of a family; climb, anneal: local "
                         "search from random starts; guided: hypothesis' target (default: climb)")
    command.add_argument("--family", metavar="NAME[:KEY=N,..]", default="stretched",
                         help=f"lattice:n=4,m=3, {', '.join(FAMILIES)}, or path.py:function (default: stretched)")
    command.add_argument("--seed", type=int, default=0)
    command.add_argument("--size", type=positive, default=0, help="figures, steps or examples of a task")
    command.add_argument("--shard", metavar="RES/MOD", type=_shard, default=(0, 1), help="only these tasks")
    command.add_argument("--stop-at-first", action="store_true", help="stop when the claim fails")
    command.add_argument("--export", metavar="DIR", help="write the finds of the store there as files and pictures")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    add_engine(command)
    command.set_defaults(run=_run)


def _run(args: argparse.Namespace) -> int:
    target = target_of(args.claim, args.construction, args.kind)
    if args.strategy == "guided":
        require_hypothesis()
    family, parameters, plugin = parsed_family(args.family)
    spec = Spec((target.key,), args.strategy, family, parameters, plugin, args.seed, args.size, args.shard).checked()
    with Store(args.store) as store:
        run = run_search(args, store, spec, search_tasks(spec), args.stop_at_first)
        found = totals(store, run)[target.key] if totals(store, run) else None
        finds = [find for find in store.finds() if (find["claim"], find["construction"], find["kind"]) == target.key]
        commands = show.export(finds, args.export) if args.export else []
        evaluated = store.evaluated(run)
    fails = any(find["label"] == "violation" and find["confirmed"] for find in finds)
    if args.json:
        print(json.dumps({"claim": target.claim.id, "construction": target.construction, "kind": target.kind,
                          "inputs": evaluated, "violations": found.violations if found else 0,
                          "instances": found.instances if found else 0,
                          "worst": json.loads(found.worst["shown"]).get("worst") if found and found.worst else None,
                          "finds": [show.find_record(find) for find in finds]}, indent=1))
    elif not args.quiet:
        print(f"{target.claim.id} ({target.construction}, {target.kind}): {evaluated} inputs in this run, "
              f"{found.violations if found else 0} violations, worst {worst_text(found.worst if found else None)}")
        if finds:
            print(show.finds_text(finds))
        print("\n".join(commands), end="\n" if commands else "")
    return FAILS if fails else HOLDS


def _shard(text: str) -> tuple[int, int]:
    residue, _, modulus = text.partition("/")
    if not (residue.isdecimal() and modulus.isdecimal() and int(residue) < int(modulus)):
        raise argparse.ArgumentTypeError(f"{text!r} is not RES/MOD with RES < MOD")
    return int(residue), int(modulus)
