"""The symbols in which a scene is written: time, state, forcing."""

import sympy as sp

t, x, v, a = sp.symbols("t x v a", real=True)

#: ``cos(Omega t + phi)``, of amplitude one; ``t = 0`` at the first switch, ``phi`` unknown.
forcing = sp.Symbol("forcing", real=True)

#: What is not a parameter, with its unit.
STATE_UNITS = {x: "m", v: "m/s", a: "m/s^2", forcing: "", t: "s"}
