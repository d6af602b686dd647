"""The motion on a phase whose acceleration is a series of shifted Legendre polynomials."""

import numpy as np
from numpy.polynomial import legendre


def phase_motion(x, v, d, s, u, derivative):
    """Return displacement, velocity or acceleration on a phase.

    Parameters
    ----------
    x, v : float
        The state in which the phase begins.
    d : ndarray
        Coefficients of the acceleration; empty where there is none.
    s : float
        Duration of the phase.
    u : ndarray
        Local time, from 0 to 1.
    derivative : {0, 1, 2}
    """
    parts = d if len(d) else np.zeros(1)
    w = 2 * np.asarray(u) - 1
    if derivative == 2:
        return legendre.legval(w, parts)
    rate = s * legendre.legval(w, legendre.legint(parts, 1, lbnd=-1, scl=0.5))
    if derivative == 1:
        return v + rate
    twice = legendre.legint(parts, 2, lbnd=-1, scl=0.5)
    return x + s * v * np.asarray(u) + s * s * legendre.legval(w, twice)
