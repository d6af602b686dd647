"""Orbits over two parameters: filled in on a grid, and the curves where something happens."""
