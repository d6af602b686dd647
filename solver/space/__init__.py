"""Modes of beams and strings with one attachment, by three expansions in space.

`structure` says what was generated, `attached` puts numbers in. Each of `expansions` is a set
of modes of the bare structure; `eigenvalues` attaches the attachment by one scalar equation,
a bracket a root, solves the exact one, and proves bounds. Users call `modes`, and
`convergence`.
"""
