"""Kernels of the three methods, one module each, written by ``nonsmooth generate``."""
