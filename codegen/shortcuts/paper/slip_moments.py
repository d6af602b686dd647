"""Stage 2c: shifted Legendre polynomials times harmonics, integrated over slip.

Input: an index ``l`` and the harmonic ``k``.
Output: ``int_{t1}^T P_l*(u) cos(k omega_0 t) dt`` and the same with the sine, where
``u = (t - t1)/s`` and ``s = T - t1``, through the spherical Bessel function ``j_l``.

Written as products of powers and trigonometric functions, as an integration by parts
gives them, these integrals lose about ``4 log10(1/(k omega_0 s))`` digits; so written
they lose none.  SymPy shows here that both are the same.
"""

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp

from ...system import ClosedForm, Equation, require_zero
from .inner_product import FREQUENCY, C, S, k, omega_0
from .oscillator import T, t1

#: Slip duration, and half the angle that harmonic ``k`` turns through in slip.
s, z = sp.symbols("s z", positive=True)
TIMES = {s: T - t1, z: (k * omega_0 * (T - t1) / 2).subs(FREQUENCY)}

sin_z, cos_z = sp.symbols("sin_z cos_z", real=True)
BESSEL = sp.symbols("j0:4", real=True)

_v = sp.Symbol("v", real=True)

#: Tables of the moments, by degree ``l``; ``l = 0`` is the ``C_k``, ``S_k`` of (8).
TABLES: Mapping[int, tuple[sp.IndexedBase, sp.IndexedBase]] = MappingProxyType(
    {0: (C, S)} | {l: (sp.IndexedBase(f"C{l}"), sp.IndexedBase(f"S{l}")) for l in (1, 3)}
)


@cache
def about_mid_slip(l: int) -> sp.Expr:
    """Return ``int_{-1/2}^{1/2} P_l(2 v) f(2 z v) dv``, ``f`` cos or sin by parity of `l`.

    It is ``(-1)**(l//2) j_l(z)``; SymPy integrates the left side and compares.
    """
    wave = sp.cos if l % 2 == 0 else sp.sin
    half = sp.Rational(1, 2)
    direct = sp.integrate(sp.legendre(l, 2 * _v) * wave(2 * z * _v), (_v, -half, half))
    bessel = (-1) ** (l // 2) * sp.jn(l, z)
    require_zero([(f"Legendre moment of degree {l}", direct - bessel)])
    return bessel


def moments(l: int) -> tuple[sp.Expr, sp.Expr]:
    """Return the cosine and the sine moment of degree `l`, in `s` and `z`.

    About mid-slip, ``t = T - s/2 + s v``, harmonic ``k`` is the wave of phase
    ``k omega_0 (T - s/2) = 2 pi k - z``.
    """
    phase = 2 * sp.pi * k - z
    cosine, sine = sp.expand_trig(sp.cos(phase)), sp.expand_trig(sp.sin(phase))
    integral = s * about_mid_slip(l)
    if l % 2 == 0:
        return cosine * integral, sine * integral
    return -sine * integral, cosine * integral


def legendre_coefficients(polynomial: sp.Expr, u: sp.Symbol) -> dict[int, sp.Expr]:
    """Return the coefficients of `polynomial` in ``P_l*(u) = P_l(2 u - 1)``, by `l`."""
    degree = int(sp.degree(polynomial, u))
    coefficients = {}
    for l in range(degree + 1):
        projected = sp.integrate(sp.expand(polynomial * sp.legendre(l, 2 * u - 1)), (u, 0, 1))
        coefficients[l] = sp.expand((2 * l + 1) * projected)
    return {l: value for l, value in coefficients.items() if value != 0}


def by_time(value: sp.Expr, time: sp.Symbol) -> sp.Expr:
    """Return the derivative by ``t1`` or ``T`` of a function of the times, `s` and `z`."""
    through = (value.diff(name) * sp.factor(TIMES[name].diff(time)) for name in TIMES)
    return value.diff(time) + sp.Add(*through)


def with_derivatives(value: sp.Expr) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Return `value` and its derivatives by ``t1`` and by ``T``."""
    return value, by_time(value, t1), by_time(value, T)


def moment_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of the moments of degree 1 and 3, for emission."""
    tabulated = {sp.sin(z): sin_z, sp.cos(z): cos_z}
    tabulated |= {sp.jn(l, z): symbol for l, symbol in enumerate(BESSEL)}
    angle = ClosedForm(
        "half_angle",
        "z_k: half the angle that harmonic k turns through in slip.",
        (T, k, s),
        (TIMES[z].subs(T - t1, s),),
    )
    forms = [angle]
    for l, tables in TABLES.items():
        if l == 0:
            continue
        used = (BESSEL[l - 1], BESSEL[l])
        for table, name, value in zip(tables, ("cosine", "sine"), moments(l), strict=True):
            summary = f"{table.label}_k, and its derivatives by t1 and T."
            values = tuple(v.subs(tabulated) for v in with_derivatives(value))
            arguments = (T, *used, cos_z, k, s, sin_z, t1, z)
            forms.append(ClosedForm(f"{name}_moment_{l}", summary, arguments, values))
    return tuple(forms)


def bessel_forms() -> tuple[ClosedForm, ...]:
    """Return ``j_0 .. j_3`` in elementary terms, good for ``z`` above ``l + 1``."""
    waves = {sp.sin(z): sin_z, sp.cos(z): cos_z}
    return tuple(
        ClosedForm(
            f"spherical_bessel_{l}",
            f"j_{l}(z) in elementary terms, for z >= {l + 1}; below, they cancel.",
            (cos_z, sin_z, z),
            (sp.expand(sp.expand_func(sp.jn(l, z))).subs(waves),),
        )
        for l in range(len(BESSEL))
    )


def definitions() -> tuple[Equation, ...]:
    """Return the moments as numbered statements, for the reader."""
    u = sp.Symbol("u", real=True)
    harmonic = omega_0 * k * (t1 + s * u)
    rows = [
        Equation("", "slip duration", (s, TIMES[s])),
        Equation("", "half angle of harmonic k in slip", (z, TIMES[z]), "", ("half_angle",)),
    ]
    for l, tables in TABLES.items():
        if l == 0:
            continue
        bessel = tuple(f"spherical_bessel_{degree}" for degree in (l - 1, l))
        for table, wave, value in zip(tables, (sp.cos, sp.sin), moments(l), strict=True):
            integrand = sp.legendre(l, 2 * u - 1) * wave(harmonic)
            sides = (table[k], s * sp.Integral(integrand, (u, 0, 1)), value)
            kind = "cosine" if wave is sp.cos else "sine"
            functions = (f"{kind}_moment_{l}", *bessel, "slip_moments")
            title = f"{kind} moment of the Legendre polynomial of degree {l} over slip"
            rows.append(Equation("", title, sides, functions=functions))
    return tuple(rows)
