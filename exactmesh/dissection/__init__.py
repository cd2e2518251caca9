"""Dissection of polygons of equal area into common pieces (paper, Section 5), exact, counted and checked."""
