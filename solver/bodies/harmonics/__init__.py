"""Harmonics of the contact forces, alone or beside functions with breaks at the switches.

``force = sum f_h e^(i h w t) + sum c beta_n``.  Galerkin's rows: each harmonic of the force is
that of the force by the laws of the phases.  The response of the body to a harmonic is its
dynamic compliance; that to impulses and to functions with breaks has a closed form.  The factor
of a function is the jump of a derivative of the force at its switch, by the laws.  At given
times the system is linear, as in `force_series`, and its size does not depend on the body.
"""
