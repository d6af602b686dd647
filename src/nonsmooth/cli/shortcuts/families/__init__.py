"""``sweep --vary``: orbits along a parameter, in chunks that are kept."""
