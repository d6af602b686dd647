"""Stage 1: the stick-slip oscillator of Section 2, as data.

Input: nothing but the equation of motion (1) and the friction law (2).
Output: `STICK` and `SLIP`, the two phases with their friction force; the unknown
times `t1` and `T`; the conditions that fix them; the exact orbit; and the change of
variables under which one number, `alpha`, remains.

The stiffness is written as ``K = M omega_n**2``, so that (1) has one frequency.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

import sympy as sp

t, t1, T = sp.symbols("t t1 T", positive=True)
M, V, F_N, mu_s, omega_n = sp.symbols("M V F_N mu_s omega_n", positive=True)
mu_k = sp.Symbol("mu_k", nonnegative=True)
x_s, x_0 = sp.symbols("x_s x_0", real=True)
alpha = sp.Symbol("alpha", positive=True)

K = M * omega_n**2

#: Centre of the slip motion and displacement at the start of stick, in the parameters.
PARAMETERS: Mapping[sp.Expr, sp.Expr] = MappingProxyType(
    {x_s: mu_k * F_N / K, x_0: (2 * mu_k - mu_s) * F_N / K}
)

#: Amplitude ``A`` of the cosine in slip: half the distance travelled in stick.
AMPLITUDE = x_s - x_0


@dataclass(frozen=True)
class Phase:
    """One phase of the motion: its interval and the friction force on the mass.

    ``sticking`` selects the branch of (2): ``F_f = K x`` in stick; in slip the mass is
    slower than the belt, ``V_r < 0``, so ``F_f = +mu_k F_N = K x_s``.
    """

    name: str
    start: sp.Expr
    end: sp.Expr
    sticking: bool

    def friction(self, x: sp.Expr) -> sp.Expr:
        """Friction force (2) for the displacement `x`, in N."""
        return K * x if self.sticking else K * x_s

    def residual(self, x: sp.Expr) -> sp.Expr:
        """Left side minus right side of (1) for the displacement ``x(t)``, in m/s**2."""
        return sp.expand(x.diff(t, 2) + omega_n**2 * x - self.friction(x) / M)


STICK = Phase("stick", sp.Integer(0), t1, sticking=True)
SLIP = Phase("slip", t1, T, sticking=False)
PHASES = (STICK, SLIP)

#: The unknown times: end of stick and period.
UNKNOWN_TIMES = (t1, T)

#: Stick ends at the static limit, ``K x(t1) = mu_s F_N``; solved for ``x(t1)``.
TRANSITION = mu_s * F_N / K


#: Displacement and velocity with which stick starts, at 0, and slip ends, at ``T``.
INITIAL_STATE = (x_0, V)


@dataclass(frozen=True)
class ExactOrbit:
    """The periodic orbit in closed form, phase by phase (Fig. 2)."""

    stick: sp.Expr
    slip: sp.Expr
    t1: sp.Expr
    T: sp.Expr


def exact_orbit() -> ExactOrbit:
    """Return the exact orbit: solve (1) in each phase and match at the transitions.

    Stick runs from ``x_0`` with velocity ``V``; slip starts at ``x_s + A`` with
    velocity ``V`` and ends when it is back at ``x_0 = x_s - A`` with velocity ``V``.
    """
    tau = t - t1
    stick_duration = 2 * AMPLITUDE / V
    slip_duration = (sp.pi + 2 * sp.atan(V / (omega_n * AMPLITUDE))) / omega_n
    slip = x_s + AMPLITUDE * sp.cos(omega_n * tau) + V / omega_n * sp.sin(omega_n * tau)
    return ExactOrbit(x_0 + V * t, slip, stick_duration, stick_duration + slip_duration)


#: Time in ``1/omega_n``, length in ``V/omega_n``, origin at ``x_s``: the equations below
#: keep their form, with these values.  Only ``alpha = omega_n A / V`` is left.
DIMENSIONLESS: Mapping[sp.Expr, sp.Expr] = MappingProxyType(
    {omega_n: sp.Integer(1), V: sp.Integer(1), x_s: sp.Integer(0), x_0: -alpha}
)


def dimensionless(expression: sp.Expr) -> sp.Expr:
    """Return `expression` in the units ``1/omega_n`` and ``V/omega_n`` about ``x_s``."""
    return expression.subs(dict(DIMENSIONLESS))


def to_dimensional(y: sp.Expr) -> sp.Expr:
    """Return ``x(t) = x_s + (V/omega_n) y(omega_n t)`` for a dimensionless ``y(t)``."""
    scaled = {time: omega_n * time for time in (t, t1, T)}
    back = {alpha: omega_n * AMPLITUDE / V}
    return x_s + V / omega_n * y.subs(scaled, simultaneous=True).subs(back)
