"""impact-two-sided: a driven mass that bounces between two stops; written by ``nonsmooth generate``."""
