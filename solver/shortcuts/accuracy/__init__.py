"""Errors and estimates of the paper's methods, rates of convergence."""
