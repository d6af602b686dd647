"""Bodies with several degrees of freedom and a contact: exact orbits and the force series."""
