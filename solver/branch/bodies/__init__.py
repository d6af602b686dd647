"""Branches of bodies of several degrees of freedom: their equations, and what is watched."""
