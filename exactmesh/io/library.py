"""Libraries that only some formats need: imported when such a file is met, and named when they are missing."""

import importlib
from typing import Any

from exactmesh.errors import InputError


def library(name: str, extra: str) -> Any:
    """Return the module `name`; raises `InputError` that says how to install it."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.partition(".")[0]
        raise InputError(f"this needs {package}: pip install 'exactmesh[{extra}]' ({error})") from error
