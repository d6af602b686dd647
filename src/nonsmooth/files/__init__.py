"""Orbits, sweeps and families as files: `save` and `load` in ``api``, a module a format."""
