"""Kernels of the three methods, a module each, written by ``nonsmooth generate``."""
