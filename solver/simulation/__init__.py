"""Motion from a given state: the exact flow of each phase, from event to event.

`steps` follows it from phase to phase over arrays, `bodies` has what is other for bodies,
`walk` makes a list of phases, `simulate` is the motion of a case, and `settle` finds the
periodic motion that it comes to.
"""
