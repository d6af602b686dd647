"""Modes of beams and strings with one attachment, by three expansions in space.

`structure` finds what was generated, `attached` puts numbers in, `sines`, `forced` and
`pieces` are the expansions, each a set of bare modes; `secular` attaches the attachment and
brackets every root, `exact` solves the characteristic equation, `bounds` proves how far a root
is off, and `modes` and `convergence` are what users call.
"""
