"""Events in a step of a branch: in which order, where, and the orbits there."""
