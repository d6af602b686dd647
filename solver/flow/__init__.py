"""Exact motion: the flow of a linear phase in closed form, and the orbit made of phases."""
