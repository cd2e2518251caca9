"""Inputs that are known to be hard, and random ones: what searches draw from and tests are made of.

`shapes` are polygons of one shape each, `random_polygons` random ones, `domains` have holes, slits, isolated points;
`changes` turn an input into another one.
"""
