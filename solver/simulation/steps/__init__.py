"""A motion from phase to phase over arrays: plain Python, or compiled by numba.

`rules` has the phases of a cell as arrays.  `bounds` has Taylor coefficients of an event's form
and a bound for what they leave out, `zeros` the first zero that a polynomial can have, `locate`
the first event of a phase, `switches` which phase follows, `clock` the angle of the forcing,
`step` does all that for a phase, and `run` as long as a motion lasts.
"""
