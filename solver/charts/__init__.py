"""Orbits over two parameters: continuation on a grid, and curves of events."""
