"""Kernels, and scenes in numbers, written by ``nonsmooth generate``."""
