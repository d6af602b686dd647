"""The numeric stage: from the generated kernels to orbits.

In the order in which a solution runs through them: `belt` (parameters), `kernels` (the
generated equations), `start` (first guess), `search` (ways to an orbit), `newton`,
`admissible` (is it an orbit?), `orbit` (the result, a `motion` in SI units), `errors`
(against `exact`); `solve` joins them, `sweep` does so for many orders.  `fourier` and
`polynomial` know how the unknowns of a method make a motion; `c1_roots` lists all solutions
of Section 3.3, isolated by `real_roots`; `batch` solves it for many alpha at once.

Never imports SymPy or `codegen`.
"""
