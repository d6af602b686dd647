"""Orbits and sweeps of scenes as tables, captions."""
