"""`python -m exactmesh` is the command `exactmesh`."""

import sys

from exactmesh.cli import main

sys.exit(main())
