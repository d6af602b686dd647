"""Kernels, a folder for each scene, written by ``nonsmooth generate``."""
