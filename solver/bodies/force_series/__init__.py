"""The force series: contact forces in Legendre polynomials, the responses by poles."""
