"""The register of claims: statements with permanent ids, each tied to its checker."""
