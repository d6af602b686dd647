"""beam-clearance: a steel cantilever with an elastic stop behind a gap at its tip; written by ``nonsmooth generate``."""
