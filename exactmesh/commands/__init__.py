"""The commands, a module each. A module is imported when its command is chosen, so that each starts at once."""

MODULES = {
    "mfs": "size", "ifs": "size", "mesh": "mesh", "verify": "verify", "check": "check", "claims": "claims",
    "reproduce": "reproduce", "dissect": "dissect", "verify-dissection": "verify_dissection", "prove": "prove",
    "search": "search", "hits": "hits", "verify-run": "verify_run", "examples": "examples", "convert": "convert",
    "degradation": "degradation", "view": "view", "plot": "plot", "trust": "trust", "completion": "completion",
    "bench": "bench",
}
