"""Motion from a given state: the exact flow of each phase, from event to event.

`bounds` has Taylor coefficients of an event's form and a bound for what they leave out, `zeros`
the first zero that a polynomial can have, `locate` the first event of a phase, `machine` which
phase follows, `simulate` the motion, and `settle` the periodic motion that it comes to.
"""
