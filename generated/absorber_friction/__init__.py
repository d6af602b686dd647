"""absorber-friction: a driven mass and a tuned absorber, with dry friction between them; written by ``nonsmooth generate``."""
