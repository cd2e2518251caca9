"""Witnesses: small exact inputs, each of which refutes a claim of the paper; re-checked by the tests."""

from exactmesh.io.shelf import Shelf

WITNESSES = Shelf(__name__, ".json", "witness")
