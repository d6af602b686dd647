"""dry-friction, sliding: a driven mass with dry friction; written by ``nonsmooth generate``."""
