"""impact-inelastic: a driven mass that hits a stop and rests on it; written by ``nonsmooth generate``."""
