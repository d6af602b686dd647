"""dry-friction, two-stops: a driven mass with dry friction; written by ``nonsmooth generate``."""
