"""Eigenvalues: the attachment as a scalar equation, exact ones, proved bounds."""
