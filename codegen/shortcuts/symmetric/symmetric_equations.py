"""The equations of `hb_symmetric` as a reader is shown them, dimensionless.

Input: the closed forms of `symmetry` and `odd_functions`.
Output: what is solved in place of the systems of Sections 3.1 (K = 0) and 3.2 (K = 1, and
more C1 functions than the paper has).
"""

import sympy as sp

from ...system import Equation, Inner
from ..paper import fourier
from ..paper.hb import frequency_row
from ..paper.inner_product import C, N, j, k, n, omega_0
from ..paper.oscillator import T, V, omega_n, t, t1, x_s
from ..paper.slip_moments import s
from . import symmetry
from .odd_functions import DRIFT, in_slip, l, q_above, q_below, q_here, v
from .symmetry import tau

i, K = sp.symbols("i K", integer=True, positive=True)
m = sp.Symbol("m", integer=True, nonnegative=True)
b, c, a = (sp.IndexedBase(name, real=True) for name in "bca")
gamma, h, phi, psi = (sp.IndexedBase(name) for name in ("gamma", "h", "phi", "psi"))
M, P, Q, Z = (sp.IndexedBase(name) for name in ("M", "P", "Q", "z"))
x, y, R = (sp.Function(name) for name in "xyR")

#: C1 function ``i`` at the time ``tau``, its acceleration, and its tail: what its own first
#: N harmonics leave of it.
g, A, f = (sp.IndexedBase(name) for name in "gAf")

END = t1 / 2

#: A sine at the end of stick.
WAVE_AT_END = symmetry.SINE.subs(tau, END)

STICK_T, SLIP_T = "0 <= t < t1", "t1 <= t < T"
EACH = "i = 1, ..., K"

#: Coefficients of the C1 functions in (6).
FORCE = ("through_motion_1", "through_motion")


def rate_at_end() -> sp.Expr:
    """Return the derivative of a sine at the end of stick."""
    return symmetry.SINE.diff(tau).subs(tau, END)


def _series(wave: sp.Expr, tail: sp.Expr) -> sp.Expr:
    """Return the expansion with these waves and tails."""
    return sp.Sum(wave * b[n], (n, 1, N)) + sp.Sum(c[i] * tail, (i, 1, K))


def _tail(function: sp.Expr, wave: sp.Expr) -> sp.Expr:
    """Return what is left of a C1 function without its harmonics."""
    return function - sp.Sum(gamma[i, n] * wave, (n, 1, N))


def _functions() -> tuple[Equation, ...]:
    """Return the C1 functions, their harmonics and their tails."""
    shape = (N + 1) ** (i - 1) * v * (1 - v**2) ** (i - 1)
    odd, parts = 2 * m + 1, (m, 0, i - 1)
    integrated = q_below() * P[l - 2] + q_here() * P[l] + q_above() * P[l + 2]
    moment = sp.Integral(P[l] * sp.sin(k * omega_0 * tau), (t, t1, T))
    bessel = (-1) ** (k + m) * s * sp.Function("j_l")(Z[k])
    harmonic = -2 / T * sp.Sum(a[i, m] * M[odd, j], parts) / (j * omega_0) ** 2
    at_end = ("at_end_of_stick",)
    return (
        Equation(
            "",
            "acceleration of C1 function i in slip; P_l(v)",
            (A[i], shape, sp.Sum(a[i, m] * P[odd], parts)),
            EACH,
            ("squared", "accelerations"),
        ),
        Equation(
            "",
            "it in slip",
            (g[i], sp.Sum(a[i, m] * Q[odd], parts)),
            SLIP_T,
            ("legendre_parts",),
        ),
        Equation("", "it in stick", (g[i], a[i, 0] * DRIFT * tau), STICK_T, ("drift",)),
        Equation(
            "", "P_l integrated twice", (Q[l], integrated), "l = 3, 5, ...", ("in_legendre",)
        ),
        Equation(
            "12",
            "the paper's, but for a factor and a constant",
            (Q[1], in_slip(1)),
            SLIP_T,
            ("drift_in_slip",),
        ),
        Equation(
            "",
            "half angle of harmonic k in slip",
            (Z[k], k * omega_0 * s / 2),
            "",
            ("half_slip_angle",),
        ),
        Equation(
            "",
            "moments, by the spherical Bessel function",
            (M[l, k], moment, bessel),
            "l = 2 m + 1",
            (
                *(f"spherical_bessel_{part}" for part in ("0", "1", "next")),
                "spherical_bessel",
                "moment",
                "slip_moments",
            ),
        ),
        Equation(
            "",
            "harmonics of C1 function i",
            (gamma[i, j], harmonic),
            "",
            ("harmonic", "harmonics"),
        ),
        Equation("", "its tail", (f[i], _tail(g[i], symmetry.SINE))),
        Equation(
            "",
            "its tail at t1",
            (phi[i], _tail(a[i, 0] * DRIFT * END, WAVE_AT_END)),
            "",
            at_end,
        ),
        Equation(
            "",
            "the velocity of its tail at t1",
            (psi[i], _tail(a[i, 0] * DRIFT, rate_at_end())),
            "",
            at_end,
        ),
        Equation(
            "",
            "its tail in (6)",
            (h[i, j], sp.Integral(f[i] * symmetry.TEST, (t, t1, T))),
            "",
            (*FORCE, "through_harmonics", "tails"),
        ),
    )


def _conditions() -> tuple[Equation, ...]:
    """Return (6), (14), (9), (10) about mid-stick."""
    force = _series(symmetry.SINE_BY_SINE, h[i, j])
    shared = {form.name: form for form in fourier.closed_forms()}
    displacement, velocity = shared["initial_state"].values
    zero = sp.Integer(0)
    return (
        Equation(
            "6",
            "orthogonality",
            (Inner(R(tau), symmetry.TEST), fourier.period_term() * b[j] + force, zero),
            "j = 1, ..., N",
            (
                *FORCE,
                "period_term",
                "sine_by_sine",
                "slip_part_by_times",
                "slip_product",
                "slip_part",
            ),
        ),
        Equation(
            "14",
            "orthogonal to the tails",
            (Inner(R(tau), f[i]), zero),
            EACH,
            ("harmonic_acceleration", "legendre_norm", "through_each_other", "tail_conditions"),
        ),
        Equation(
            "9",
            "displacement at t1; at t = 0 with the other sign",
            (y(END), _series(WAVE_AT_END, phi[i]), -displacement),
            "",
            ("initial_state",),
        ),
        Equation(
            "10",
            "velocity at t1, as at t = 0",
            (sp.Subs(y(tau).diff(tau), tau, END), _series(rate_at_end(), psi[i]), velocity),
            "",
            ("velocity_weight", "initial_state"),
        ),
        Equation(
            "",
            "(6) solved for b_j, as the kernel puts it into (9) and (10)",
            (b[j], -force / fourier.period_term()),
            "",
            ("residual",),
        ),
    )


def equations() -> tuple[Equation, ...]:
    """Return the definitions and the conditions, numbered as in the paper."""
    integral = sp.Integral(sp.cos(k * omega_0 * (t - END)), (t, t1, T))
    acceleration = y(tau).diff(tau, 2)
    return (
        Equation("", "dimensionless displacement", (y(tau), omega_n * (x(t) - x_s) / V)),
        Equation("", "time since mid-stick, in 1/omega_n as all times", (tau, t - END)),
        frequency_row(),
        Equation("", "slip duration", (s, T - t1)),
        Equation("", "time in slip, from -1 to 1", (v, (2 * tau - T) / s)),
        Equation(
            "11",
            "expansion, odd in tau",
            (y(tau), _series(symmetry.SINE, f[i])),
            "K = 0 is (3)",
        ),
        Equation(
            "13", "residual in stick", (R(tau), acceleration), STICK_T, ("residual_in_stick",)
        ),
        Equation(
            "13",
            "residual in slip",
            (R(tau), acceleration + y(tau)),
            SLIP_T,
            ("residual_in_slip",),
        ),
        *_functions(),
        Equation(
            "",
            "slip integral C_k, k != 0",
            (C[k], integral, symmetry.SLIP_COSINE),
            "",
            ("half_stick_angle", "slip_cosine", "slip_cosines"),
        ),
        Equation(
            "",
            "slip integral C_k, the diagonal",
            (C[0], symmetry.SLIP_COSINE_ZERO),
            "",
            ("slip_cosine_zero",),
        ),
        *_conditions(),
    )
