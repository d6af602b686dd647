"""Kernels of the paper's methods; written by ``nonsmooth generate``."""
