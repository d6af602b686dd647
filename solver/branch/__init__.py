"""Branches: how an orbit changes along a parameter, and where it ends."""
