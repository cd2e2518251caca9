"""Reading and writing files: the exact formats of `exactmesh`, and those it reads besides."""
