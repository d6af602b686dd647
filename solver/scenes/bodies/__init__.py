"""Bodies as they are loaded: matrices, cells, and what takes none."""
