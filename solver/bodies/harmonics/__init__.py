"""Harmonics of the contact forces, alone or beside functions with breaks at the switches.

``force = sum f_h e^(i h w t) + sum c beta_n``; each harmonic of it is that of what the laws of
the phases make of the state: Galerkin's rows.  The body answers a harmonic by its dynamic
compliance; impulses, and functions with breaks, in closed form.  A function takes from the
harmonics the jump of a derivative, which the laws make of the state at the switch.  At given
times all this is linear, as in `series`, and its size does not depend on the body.
"""
