"""Local optimisation of a mesh: the degradation first, then the number of Steiner vertices; every step is exact."""
