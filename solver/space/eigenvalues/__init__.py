"""Eigenvalues with the attachment by a scalar equation; exact ones; proved bounds."""
