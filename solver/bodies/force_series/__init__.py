"""The force series of a body: contact forces in Legendre polynomials, answered by its poles."""
