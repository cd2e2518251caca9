"""Certificates: what lets a small program check a mesh without trusting the one that made it."""
