"""Planar straight-line graphs: their records, validation, half-edges and faces."""
