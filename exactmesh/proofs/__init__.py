"""Proofs for all inputs: problems, certificates that rational arithmetic re-checks, and decision procedures."""
