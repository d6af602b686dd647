"""A periodic orbit of a scene, and whether it is one: motion, extremes, demands."""
