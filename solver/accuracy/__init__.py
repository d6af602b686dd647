"""Error estimates without the exact orbit, and rates of convergence."""
