"""Exact scalars: part of the trusted kernel."""
