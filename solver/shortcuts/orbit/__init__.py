"""The paper's oscillator: its parameters, exact motion, orbits, what makes one admissible."""
