"""Beams and strings with one attachment; written by ``nonsmooth generate``."""
