"""Sections 2, 3.1, 3.2 and 3.3 of the paper, with its own rows, numbers and functions."""
