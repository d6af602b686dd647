"""elastic-plastic: a driven mass on an elastic-plastic element; written by ``nonsmooth generate``."""
