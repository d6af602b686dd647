"""backlash: a driven mass with play on both sides of its spring; written by ``nonsmooth generate``."""
