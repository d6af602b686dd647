"""Newton's method over arrays: iterations, and the linear algebra of bands."""
