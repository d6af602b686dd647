"""Residuals and Jacobians of any phases: loops around the closed forms of `generated`."""
