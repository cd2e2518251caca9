"""What is measured straight from the definitions: feature sizes, mesh validity. Knows no construction."""
