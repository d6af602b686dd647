"""Modes of beams and strings with one attachment, by three expansions in space.

`structure` loads what was generated, `attached` adds numbers.  Each of `expansions` gives modes
of the bare structure; `eigenvalues` adds the attachment by one scalar equation with a bracket
for each root, solves the exact equation, and proves bounds.  Users call `modes` and
`convergence`.
"""
