"""Stage 2f: the orbit is odd about the middle of stick, and so are the equations.

Input: the phases of the oscillator and the Fourier series.
Output: the inner products (8) of sines of ``tau = t - t1/2``, the time since mid-stick: half
of the equations of `fourier`, in half of the unknowns.

About ``x_s`` the motion run backwards and turned over is a motion on the same belt: with
``y(tau)`` also ``-y(-tau)`` solves (1) and (2).  An odd motion needs no more than sines of
``tau``, its residual is odd, and the inner products with even test functions vanish.
"""

import sympy as sp

from ...system import ClosedForm, require_zero
from ..paper import fourier
from ..paper.inner_product import FREQUENCY, C, j, k, n, omega_0
from ..paper.oscillator import SLIP, STICK, T, t, t1

#: Time since the middle of stick, and the two phases in it.
tau = sp.Symbol("tau", real=True)
STICK_ENDS = (-t1 / 2, t1 / 2)
SLIP_ENDS = (t1 / 2, T - t1 / 2)

SINE = sp.sin(n * omega_0 * tau)
TEST = SINE.subs(n, j)

#: Half of the angle that harmonic ``k`` turns through in stick, and its sine, tabulated.
HALF_STICK = (k * omega_0 * t1 / 2).subs(FREQUENCY)
sin_k = sp.Symbol("sin_k", real=True)

#: ``C_k``: the integral of ``cos(k omega_0 tau)`` over slip, and that of the constant.
SLIP_COSINE = -T / (sp.pi * k) * sp.sin(HALF_STICK)
SLIP_COSINE_ZERO = T - t1

#: The integral over slip of two sines.
SINE_BY_SINE = (C[j - n] - C[j + n]) / 2

#: Slip part of (6): the integral over slip of a series times the sine ``j``; and the series
#: at the end of stick.  By ``t1`` both ends of slip move, by ``T`` also the time scale.
PART, AT_END, SINE_J = sp.symbols("part at_end sine_j", real=True)
PART_BY_T1 = -AT_END * SINE_J
PART_BY_T = PART / T + t1 / T * AT_END * SINE_J


def check_integrals() -> None:
    """Check ``C_k``, and the product of two sines, by SymPy's integrals.

    Raises
    ------
    DerivationError
        If a closed form differs from its integral.
    """
    wave = sp.cos(k * omega_0 * tau).subs(FREQUENCY)
    direct = sp.integrate(wave, (tau, *SLIP_ENDS))
    zero = sp.integrate(wave.subs(k, 0), (tau, *SLIP_ENDS))
    table = {C[i]: sp.cos(i * omega_0 * tau) for i in (j - n, j + n)}
    require_zero(
        [
            ("C_k about mid-stick", sp.expand_trig(sp.expand(direct - SLIP_COSINE))),
            ("C_0 about mid-stick", zero - SLIP_COSINE_ZERO),
            ("product of sines", sp.expand_trig(SINE * TEST - SINE_BY_SINE.xreplace(table))),
        ]
    )


def check_derivatives() -> None:
    """Check the derivatives of the slip part of (6), sine by sine.

    Raises
    ------
    DerivationError
        If the derivative of an integral over slip differs from what its ends say.
    """
    table = {C[i]: SLIP_COSINE.subs(k, i) for i in (j - n, j + n, 2 * j)}
    table[C[0]] = SLIP_COSINE_ZERO
    claims = []
    for name, entry in (("n != j", SINE_BY_SINE), ("n = j", SINE_BY_SINE.subs(n, j))):
        value = entry.xreplace(table)
        sines = [sp.sin(HALF_STICK.subs(k, i)) for i in (j, n if name == "n != j" else j)]
        at = {PART: value, AT_END: sines[1], SINE_J: sines[0]}
        for time, closed in ((t1, PART_BY_T1), (T, PART_BY_T)):
            difference = sp.expand_trig(sp.expand(value.diff(time) - closed.subs(at)))
            claims.append((f"slip part by {time}, {name}", difference))
    require_zero(claims)


def check_symmetry() -> None:
    """Check that an odd motion has an odd residual, and that even tests say nothing of it.

    Raises
    ------
    DerivationError
        If the residual of a sine has an even part, or an inner product with an even
        function does not vanish.
    """
    claims = []
    for phase, forcing in ((STICK, sp.Integer(0)), (SLIP, fourier.forcing())):
        through = phase.residual(SINE.subs(tau, t)) - forcing
        claims.append((f"residual of a sine in {phase.name}", through + through.subs(t, -t)))
    for even in (sp.Integer(1), sp.cos(j * omega_0 * tau)):
        product = (SINE * even).subs(FREQUENCY)
        for name, (start, end) in (("stick", STICK_ENDS), ("slip", SLIP_ENDS)):
            mirrored = product.subs(tau, start + end - tau)
            claims.append((f"sine by {even} in {name}", sp.expand_trig(product + mirrored)))
    require_zero(claims)


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of a sine series, for emission."""
    minus, plus = sp.symbols("C_minus C_plus", real=True)
    return (
        ClosedForm(
            "half_stick_angle",
            "Angle that the fundamental harmonic turns through in half of stick.",
            (T, t1),
            (HALF_STICK.subs(k, 1),),
        ),
        ClosedForm(
            "slip_cosine_zero",
            "C_0 about mid-stick.",
            (t1, T),
            (SLIP_COSINE_ZERO,),
        ),
        ClosedForm(
            "slip_cosine",
            "C_k about mid-stick, k >= 1.",
            (sin_k, k, T),
            (SLIP_COSINE.subs(sp.sin(HALF_STICK), sin_k),),
        ),
        ClosedForm(
            "sine_by_sine",
            "Coefficient of b_n in (6) about mid-stick, from C_{j - n} and C_{j + n}.",
            (minus, plus),
            (SINE_BY_SINE.xreplace({C[j - n]: minus, C[j + n]: plus}),),
        ),
        ClosedForm(
            "slip_part_by_times",
            "Derivatives of the slip part of (6) by t1 and T, coefficients held.",
            (PART, AT_END, SINE_J, t1, T),
            (PART_BY_T1, PART_BY_T),
        ),
    )
