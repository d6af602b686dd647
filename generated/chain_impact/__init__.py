"""chain-impact: 5 masses in a row, the last of which bounces off a stop; written by ``nonsmooth generate``."""
