"""Pictures: of inputs, of every step of a construction, of meshes; as SVG, or through matplotlib."""
