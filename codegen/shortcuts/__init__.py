"""Other systems for the orbits of the paper's oscillator, and its own methods.

The paper's rows and its ``g1`` are derived here, and what is solved in their place because it
is quicker: half the unknowns by symmetry, one scalar equation, bands.
"""
