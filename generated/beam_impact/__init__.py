"""beam-impact: a steel cantilever with a mass at its tip that bounces off a rigid stop; written by ``nonsmooth generate``."""
