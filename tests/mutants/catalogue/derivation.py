"""Mistakes in the derivation: the closed forms and what is shown of them."""

from ..mutant import Mutant

SHOWN = ("tests/shown/test_equations_shown.py",)
KERNELS = ("tests/derivation/test_closed_forms.py",)
HALVED = ("tests/derivation/test_solved_equations.py",)
SECTION_2 = ("tests/shown/test_section2_shown.py",)


def _derived(what: str, file: str, old: str, new: str, tests: tuple[str, ...]) -> Mutant:
    """Return a mistake that is written into ``generated/``, if the derivation lets it pass."""
    return Mutant(what, f"codegen/shortcuts/{file}.py", old, new, tests, regenerate=True)


MUTANTS = (
    _derived(
        "(4): the friction force with the other sign",
        "paper/hb",
        "fourier.a0 * constant + phase.residual(sp.Integer(0))",
        "fourier.a0 * constant - phase.residual(sp.Integer(0))",
        SHOWN,
    ),
    _derived(
        "(8): the integral over stick is that over the period and slip",
        "paper/inner_product",
        "(_full_period(function, index) - _table(function, index))",
        "(_full_period(function, index) + _table(function, index))",
        KERNELS,
    ),
    _derived(
        "(8): the constant has no integral over the period",
        "paper/inner_product",
        "return T if index == 0 and function is sp.cos else sp.Integer(0)",
        "return sp.Integer(0)",
        KERNELS,
    ),
    _derived(
        "(10): the velocity of a sine with the other sign",
        "paper/fourier",
        "return SINE.diff(t).subs(t, 0)",
        "return -SINE.diff(t).subs(t, 0)",
        KERNELS,
    ),
    _derived(
        "(14): the mean of g1 without its part in stick",
        "paper/g1",
        "(in_stick + slip_integral(g_in_slip()))",
        "slip_integral(g_in_slip())",
        KERNELS,
    ),
    _derived(
        "(14): the inner product of g1 with the residual of another function",
        "paper/g1",
        "return slip_integral(through_motion() * g_in_slip())",
        "return slip_integral(through_motion() * SMOOTHSTEP)",
        KERNELS,
    ),
    _derived(
        "(14): the forcing with the other sign",
        "paper/hb_c1",
        "+ series + c1 * Hg - x_s * H0",
        "+ series + c1 * Hg + x_s * H0",
        SHOWN,
    ),
    _derived(
        "slip moments: sine and cosine of degree 1 and 3 exchanged",
        "paper/slip_moments",
        "return -sine * integral, cosine * integral",
        "return cosine * integral, -sine * integral",
        KERNELS,
    ),
    _derived(
        "slip moments: the derivative by T forgets the half angle",
        "paper/slip_moments",
        "for name in TIMES)",
        "for name in (s,))",
        ("tests/shown/test_jacobian_shown.py",),
    ),
    _derived(
        "(18): the line taken before slip instead of in it",
        "paper/c1",
        "load = _over_slip(rest.subs(t, t1 + tau)",
        "load = _over_slip(rest.subs(t, tau)",
        SHOWN,
    ),
    _derived(
        "(19): the belt moves for the time of stick alone",
        "paper/c1",
        "trial().subs(tau, s), START[e0] * T)",
        "trial().subs(tau, s), START[e0] * t1)",
        SHOWN,
    ),
    _derived(
        "Legendre polynomials: the norm of another degree",
        "paper/c1_legendre",
        "(1 / (2 * l + 1),)",
        "(1 / (2 * l + 3),)",
        KERNELS,
    ),
    _derived(
        "symmetric equations: harmonics of a C1 function with the other sign",
        "symmetric/symmetric_equations",
        "harmonic = -2 / T * sp.Sum",
        "harmonic = 2 / T * sp.Sum",
        HALVED,
    ),
    _derived(
        "symmetric equations: (9) with the sign of t = 0",
        "symmetric/symmetric_equations",
        "_series(WAVE_AT_END, phi[i]), -displacement)",
        "_series(WAVE_AT_END, phi[i]), displacement)",
        HALVED,
    ),
    _derived(
        "symmetric equations: sum and difference of the indices exchanged",
        "symmetric/symmetry",
        "SINE_BY_SINE = (C[j - n] - C[j + n]) / 2",
        "SINE_BY_SINE = (C[j + n] - C[j - n]) / 2",
        HALVED,
    ),
    _derived(
        "reduced: the series at u = 0 with the signs of u = 1",
        "reduced/c1_reduced",
        "return -_ratio(AT_0)",
        "return _ratio(AT_0)",
        HALVED,
    ),
    _derived(
        "(2): friction along the motion",
        "paper/section2",
        "sliding = -mu_k * F_N",
        "sliding = mu_k * F_N",
        SECTION_2,
    ),
    _derived(
        "Section 2: the exact slip is as long as that of the other branch",
        "paper/oscillator",
        "sp.pi + 2 * sp.atan",
        "sp.pi - 2 * sp.atan",
        SECTION_2,
    ),
)
