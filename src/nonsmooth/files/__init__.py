"""Orbits, sweeps, families and modes as files: `save` and `load` are in ``api``."""
