"""Motion from a given state: the exact flow of each phase, from event to event.

`steps` goes from phase to phase over arrays; `bodies` has its counterparts for bodies.
`walk` makes a list of phases, `simulate` gives the motion of a case, and `settle` finds the
periodic motion to which it converges.
"""
