"""The numeric stage: from the generated kernels to orbits of any scene.

In the order in which a solution runs through them: `case` (parameters, the scene in numbers,
its kernels), `iteration` (starts, Newton's method), `orbit` (the result, and whether it is
one), `flow` (the exact orbit), `accuracy` (errors and their estimate); `solve`, `sweep` and
`family` join them, and `trade` says which order a tolerance or a budget comes to.

Never imports SymPy or `codegen`.
"""
