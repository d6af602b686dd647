"""Section 2 for the reader: equations (1) and (2), the two phases, the exact orbit.

Input: the data of `oscillator`.  Output: `equations`, printed before those of a method.
"""

import sympy as sp

from ...system import Equation
from .oscillator import (
    AMPLITUDE,
    F_N,
    PARAMETERS,
    PHASES,
    TRANSITION,
    M,
    T,
    V,
    alpha,
    exact_orbit,
    mu_k,
    omega_n,
    t,
    t1,
    x_0,
    x_s,
)

x = sp.Function("x")
K, A, F_f = sp.symbols("K A F_f", positive=True)
V_r = sp.Symbol("V_r", real=True)
TITLE = "The oscillator"


def equations() -> tuple[Equation, ...]:
    """Return (1), (2), the parameters, the phases, the transition and the exact orbit."""
    in_stiffness = {omega_n**2 * M: K}
    exact = exact_orbit()
    x_of_t = x(t)
    parameters = (
        Equation("", name, (symbol, PARAMETERS[symbol].subs(in_stiffness)))
        for name, symbol in (("centre of slip", x_s), ("displacement at t = 0", x_0))
    )
    phases = (
        Equation(
            "1",
            f"equation of motion in {phase.name}, its sides subtracted",
            (phase.residual(x_of_t), sp.Integer(0)),
            f"{phase.start} <= t < {phase.end}",
        )
        for phase in PHASES
    )
    sliding = -mu_k * F_N * sp.sign(V_r)
    friction = sp.Piecewise((K * x_of_t, sp.Eq(V_r, 0)), (sliding, True))
    motion = (x_of_t.diff(t, 2) + omega_n**2 * x_of_t, F_f / M)
    static = (x(t1), TRANSITION.subs(in_stiffness), x_s + A)
    amplitude = (A, sp.simplify(AMPLITUDE.subs(PARAMETERS).subs(in_stiffness)))
    shorter = {AMPLITUDE: A}
    return (
        Equation("1", "equation of motion", motion),
        Equation("2", "friction force, `|K x| <= mu_s F_N` in stick", (F_f, friction)),
        Equation("", "natural frequency", (omega_n, sp.sqrt(K / M))),
        *parameters,
        Equation("", "half the travel in stick", amplitude),
        *phases,
        Equation("", "stick ends at the static limit", static),
        Equation("", "exact orbit, stick phase", (x_of_t, exact.stick)),
        Equation("", "exact orbit, slip phase", (x_of_t, exact.slip.subs(shorter))),
        Equation("", "exact end of stick", (t1, exact.t1.subs(shorter))),
        Equation("", "exact period", (T, exact.T.subs(shorter))),
        Equation("", "the one parameter that remains", (alpha, omega_n * A / V)),
    )
