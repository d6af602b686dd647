"""The verbs: solve, sweep, families; kernels, starts, continuation."""
