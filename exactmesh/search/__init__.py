"""Search for polygons on which a claim fails or comes closest; every score is exact."""
