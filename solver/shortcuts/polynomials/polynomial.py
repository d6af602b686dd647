"""The motion of Section 3.3 from its unknowns: the polynomial (15), integrated twice.

Unknowns ``z``: the parts ``p_0..p_N`` of the slip acceleration in the shifted Legendre
polynomials ``P_n*(u)``, ``u = (t - t1)/s``, then ``t1, T``; dimensionless.
"""

import math

import numpy as np
from numpy.polynomial import legendre

from ...arrays import Vector
from ...scaling import product_of_powers
from ..orbit.oscillator import StickSlip


def evaluate(z: Vector, order: int, t: Vector, derivative: int, alpha: float) -> Vector:
    """Return the motion (16), or its first or second derivative, in ``[0, T)``.

    Stick is exact: ``y = -alpha + t``.  In slip the Legendre series, which keeps its
    digits, is integrated and summed, not the paper's monomials.
    """
    t1, T = z[-2:]
    s = T - t1
    integrations = 2 - derivative
    parts = legendre.legint(z[:-2], integrations, lbnd=-1, scl=0.5) if integrations else z[:-2]
    u = np.maximum(t - t1, 0.0) / s
    slip = s**integrations * legendre.legval(2 * u - 1, parts)
    line = (t - alpha, np.ones_like(t), np.zeros_like(t))[derivative]
    return line + np.where(t < t1, 0.0, slip)


def coefficients(z: Vector, order: int, belt: StickSlip) -> dict[str, object]:
    """Return the ``d_n`` of (15) in m/s**(n+2).

    ``P_n*(u)`` has the coefficient ``(-1)**(n+k) C(n, k) C(n+k, k)`` at ``u**k``.  These
    grow like 5.8**n and alternate: of the d_n at high order some digits are lost, of the
    orbit, which is not evaluated from them, none.  In units far from 1 s a coefficient of
    high order may be beyond float64, and is then infinite or zero.
    """
    s = float(z[-1] - z[-2])
    d = []
    for k in range(order + 1):
        terms = (
            z[n] * float((-1) ** (n + k) * math.comb(n, k) * math.comb(n + k, k))
            for n in range(k, order + 1)
        )
        scaled = math.fsum(terms), (s, -k), (belt.belt_speed, 1), (belt.time_unit, -1 - k)
        d.append(product_of_powers(*scaled))
    return {"d": d}
