"""The parser of the command line."""

import argparse
import importlib

import exactmesh
from exactmesh.commands import MODULES
from exactmesh.commands.help_examples import EXAMPLES


def parser_of(chosen: str = "") -> argparse.ArgumentParser:
    """Return the parser of the chosen command; of all commands if it is none, for help or a refusal."""
    parser = argparse.ArgumentParser(
        prog="exactmesh", description="Triangulate polygons and planar straight-line graphs with exact numbers so that "
        "the minimum feature size (mfs) is kept up to a constant factor, and check every step.",
        epilog="Exit status: 0 all that was asked for holds, 1 a claim fails, 2 usage or input refused, 130 "
        "interrupted. A FILE is exactmesh-pslg/1, GeoJSON, WKT, WKB, Triangle's .poly, SVG, DXF or a CG:SHOP instance; "
        "- is standard input.")
    parser.add_argument("--version", action="version", version=f"exactmesh {exactmesh.__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    for module in dict.fromkeys([MODULES[chosen]] if chosen in MODULES else MODULES.values()):
        importlib.import_module(f"exactmesh.commands.{module}").add(commands)
    helps = {action.dest: action.help or "" for action in commands._choices_actions}
    for name, command in commands.choices.items():
        width = max(len(line) for line, _ in EXAMPLES[name])
        shown = "\n".join(f"  {line:{width}}   {what}" for line, what in EXAMPLES[name])
        command.formatter_class = argparse.RawDescriptionHelpFormatter
        command.description = f"{shown}\n\n{command.description or helps[name]}"
    return parser
