"""Which exact orbits there are: lists of all of them, and why there is none."""
