"""Periodic orbits of any generated scene: one solver for all of them, which names none.

In the order in which a solution runs through them: `library` finds a scene's generated
modules, `case` checks its parameters, `cell` has it in dimensionless numbers, `start` gives
rough times and the coefficients that go with them, `iteration` is Newton's method,
`admissible` tells an orbit from a spurious root, `orbit` is the result in SI units; `solve`
joins them.  `exact` does the same by the closed-form flow of each phase.

Never imports SymPy; imports numba only for a kernel that is asked for compiled.
"""
