"""Motions as data: exact or by a method, their errors, and whether they are orbits."""
