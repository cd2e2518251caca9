"""Let the tests import the helper modules `families` and `oracle` that lie beside this file."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
