"""impact: a driven mass that bounces off a stop; written by ``nonsmooth generate``."""
