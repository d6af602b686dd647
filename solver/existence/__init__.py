"""Lists of all exact orbits of a case, and reasons why there is none."""
