"""Tables of the paper, recomputed: inputs, rows, exact checks, fits, and how they are shown."""
