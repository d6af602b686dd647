"""Sections 3.1 and 3.2 in half of their unknowns: the orbit is odd about mid-stick."""
