"""Kernels: the equations of a scene by a method over arrays; starting values for Newton."""
