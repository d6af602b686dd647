"""A motion from phase to phase over arrays: plain Python, or compiled by numba.

`rules` has the phases of a cell as arrays.  `bounds` has the Taylor coefficients of an event
function and a bound of the remainder, `zeros` the first zero of a polynomial, `locate` the
first event of a phase, `chatter` the end of infinitely many switches, `switches` the phase that
follows, `clock` the angle of the forcing.  `step` follows one phase, `run` a whole motion.
"""
