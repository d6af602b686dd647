"""The cheapest method within a tolerance, the best within a time."""
