"""Quicker ways to the orbits of the paper's oscillator, and everything that knows it."""
