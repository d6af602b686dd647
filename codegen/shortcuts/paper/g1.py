"""Stage 2e: the one C1 function ``g1`` of (12), its inner products and its tail.

Input: the oscillator, the Fourier series, the slip moments.
Output: what `hb_c1` (Section 3.2) needs: ``g1`` through the equation of motion, tested by
each harmonic and by itself, and the harmonics that ``g1`` itself contains.

Everything is derived for ``G = g1/(T s**3)``, the same function in smoothstep form: the
printed cubic cancels catastrophically when ``s = T - t1`` is much smaller than ``T``.

The kernel replaces ``G`` by its tail, ``G`` without its own first N harmonics.  Both span
the same space with those harmonics, so the orbit is the same; but ``G`` differs from them
by a tail of order ``N**(-5/2)`` only, and with ``G`` itself the equations are nearly
dependent.
"""

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp

from ...system import ClosedForm, DerivationError, require_zero
from . import fourier
from .inner_product import FREQUENCY, j, n, omega_0
from .oscillator import PHASES, SLIP, T, dimensionless, t, t1
from .slip_moments import (
    TABLES,
    bessel_forms,
    by_time,
    legendre_coefficients,
    moment_forms,
    moments,
    s,
    z,
)

u = sp.Symbol("u", real=True)

#: Equation (12) as printed, in stick and in slip.
G1_STICK = (t1 - T) ** 3 * t
G1_SLIP = (
    -2 * T * t**3
    + 3 * T * (t1 + T) * t**2
    + (2 * t1**3 - (t1 + T) ** 3) * t
    - t1**2 * T * (t1 - 3 * T)
)

#: ``g1 = SCALE * G``, and ``G`` in smoothstep form with ``u = (t - t1)/s``.
SCALE = T * (T - t1) ** 3
SCALE_S = T * s**3
SMOOTHSTEP = u**2 * (3 - 2 * u)
G_STICK = -t / T
G_SLIP = SMOOTHSTEP.subs(u, (t - t1) / (T - t1)) - t / T


def check_g1() -> None:
    """Check by SymPy that (12) is periodic and C1, and that it is a smoothstep.

    Raises
    ------
    DerivationError
        Naming the property that fails.
    """
    claims = []
    for order, name in enumerate(("g1", "the velocity of g1")):
        stick, slip = G1_STICK.diff(t, order), G1_SLIP.diff(t, order)
        claims.append((f"{name} is periodic", stick.subs(t, 0) - slip.subs(t, T)))
        claims.append((f"{name} is continuous at t1", (stick - slip).subs(t, t1)))
    claims.append(("smoothstep form in stick", G1_STICK - SCALE * G_STICK))
    claims.append(("smoothstep form in slip", G1_SLIP - SCALE * G_SLIP))
    claims.append(("g1 has no acceleration in stick", G1_STICK.diff(t, 2)))
    require_zero(claims)


def _in_u(expression: sp.Expr) -> sp.Expr:
    """Return an expression in ``t`` as one in ``u``, ``s`` and ``T``, over slip."""
    return sp.expand(expression.subs(t, t1 + s * u).subs(t1, T - s))


@cache
def g_in_slip() -> sp.Expr:
    """Return ``G`` in slip as a polynomial in ``u``."""
    return _in_u(G_SLIP)


@cache
def through_motion() -> sp.Expr:
    """Return ``G'' + omega_n**2 G`` in slip, a cubic in ``u``; in stick it is zero."""
    return sp.collect(_in_u(SLIP.residual(G_SLIP) - fourier.forcing()), u)


def slip_integral(polynomial: sp.Expr) -> sp.Expr:
    """Return the integral over slip of a polynomial in ``u``."""
    return sp.expand(s * sp.integrate(sp.expand(polynomial), (u, 0, 1)))


def _by_harmonic(table: int) -> sp.Expr:
    """Return ``int_slip (G'' + omega_n**2 G) f(j omega_0 t) dt``, f cos (0) or sin (1)."""
    coefficients = legendre_coefficients(through_motion(), u)
    if not coefficients.keys() <= TABLES.keys():
        degrees = ", ".join(map(str, sorted(coefficients.keys() - TABLES.keys())))
        raise DerivationError(
            f"(14) needs moments of degree {degrees}: see slip_moments.TABLES"
        )
    return sp.Add(*(c * TABLES[l][table][j] for l, c in coefficients.items()))


@cache
def by_one() -> sp.Expr:
    """Return the inner product of `through_motion` with 1."""
    return slip_integral(through_motion())


@cache
def by_sine() -> sp.Expr:
    """Return the inner product of `through_motion` with the sine ``j``."""
    return _by_harmonic(1)


@cache
def by_cosine() -> sp.Expr:
    """Return the inner product of `through_motion` with the cosine ``j``."""
    return _by_harmonic(0)


@cache
def by_g1() -> sp.Expr:
    """Return the inner product of `through_motion` with ``G``."""
    return slip_integral(through_motion() * g_in_slip())


def check_symmetry() -> None:
    """Check that (14) has the column of ``c1`` as its row: the Galerkin form is symmetric.

    The row tests a harmonic's residual with ``G``, in stick and in slip; the column tests
    the residual of ``G``, which vanishes in stick, with the harmonic.

    Raises
    ------
    DerivationError
        If a coefficient of (14) differs from the coefficient of ``c1`` in (6) or (7).
    """
    through = SLIP.residual(G_SLIP) - fourier.forcing()
    for name, wave in (("sines", fourier.SINE), ("cosines", fourier.COSINE)):
        stick, slip = (part.subs(FREQUENCY) for part in fourier.homogeneous(wave))
        row = sp.integrate(sp.expand(stick * G_STICK), (t, 0, t1))
        row += sp.integrate(sp.expand(slip * G_SLIP), (t, t1, T))
        column = sp.integrate(sp.expand(through * wave.subs(FREQUENCY)), (t, t1, T))
        require_zero([(f"coefficient of the {name} in (14)", row - column)])


@cache
def acceleration_of_g() -> Mapping[int, sp.Expr]:
    """Return the acceleration ``(6 - 12 u)/s**2``, of slip alone, in Legendre polynomials."""
    return MappingProxyType(legendre_coefficients(_in_u(G_SLIP.diff(t, 2)), u))


@cache
def mean() -> sp.Expr:
    """Return twice the mean of ``G`` over the period, its constant harmonic."""
    in_stick = sp.integrate(G_STICK, (t, 0, t1)).subs(t1, T - s)
    return sp.expand(2 / T * (in_stick + slip_integral(g_in_slip())))


def _harmonic_of_g1(table: int) -> sp.Expr:
    """Return a harmonic by parts, twice over the period: ``-2/T <G'', f>/(j omega_0)**2``."""
    parts = acceleration_of_g().items()
    by_parts = sp.Add(*(c * TABLES[l][table][j] for l, c in parts))
    return sp.expand(-2 / T * by_parts / (j * omega_0).subs(FREQUENCY) ** 2)


@cache
def sine_of_g1() -> sp.Expr:
    """Return the sine harmonic ``j`` of ``G``."""
    return _harmonic_of_g1(1)


@cache
def cosine_of_g1() -> sp.Expr:
    """Return the cosine harmonic ``j`` of ``G``."""
    return _harmonic_of_g1(0)


def check_harmonics() -> None:
    """Check `sine_of_g1`, `cosine_of_g1` against the integrals over both phases.

    Raises
    ------
    DerivationError
        If a harmonic of ``G`` differs from ``2/T <G, f>``.
    """
    for name, table, harmonic in (("sine", 1, sine_of_g1()), ("cosine", 0, cosine_of_g1())):
        wave = (fourier.SINE, fourier.COSINE)[1 - table].subs(n, j).subs(FREQUENCY)
        direct = sp.integrate(G_STICK * wave, (t, 0, t1))
        direct += sp.integrate(sp.expand(G_SLIP * wave), (t, t1, T))
        moment = moments(1)[table].subs(z, sp.pi * j * s / T)
        closed = harmonic.subs(TABLES[1][table][j], moment).subs(s, T - t1)
        require_zero([(f"{name} of g1", sp.expand_trig(2 / T * direct - closed))])


def _tables(value: sp.Expr) -> list[sp.IndexedBase]:
    return [table for pair in TABLES.values() for table in pair if value.has(table)]


def through_tables(value: sp.Expr, time: sp.Symbol) -> sp.Expr:
    """Return the derivative of `value` by ``t1`` or ``T``, entries of tables included.

    The derivative of an entry is left as it is: it is tabulated, too.
    """
    inner = (value.diff(f[j]) * sp.Derivative(f[j], time) for f in _tables(value))
    return by_time(value, time) + sp.Add(*inner)


def _form(name: str, summary: str, value: sp.Expr) -> ClosedForm:
    """Return a closed form with its derivatives; a table's rows 1, 2 are its own."""
    tables = _tables(value)
    rows = {f[j]: f[0, j] for f in tables}
    for row, time in enumerate((t1, T), start=1):
        rows |= {sp.Derivative(f[j], time): f[row, j] for f in tables}
    values = (value, through_tables(value, t1), through_tables(value, T))
    values = tuple(v.xreplace(rows) for v in values)
    index = (j,) if tables else ()
    times = tuple(time for time in (T, s) if any(v.has(time) for v in values))
    return ClosedForm(name, summary, (*tables, *index, *times), values)


def _pointwise_forms() -> tuple[ClosedForm, ...]:
    """Return ``G`` and the residual (13) at one time, dimensionless, for emission."""
    y = sp.Function("y")(t)
    displacement, acceleration = sp.symbols("displacement acceleration", real=True)
    named = {y.diff(t, 2): acceleration, y: displacement}
    rate = sp.simplify(fourier.SINE.diff(t, 2) / fourier.SINE).subs(FREQUENCY)
    forms = [
        ClosedForm(
            "harmonic_acceleration",
            "Acceleration of harmonic n, as a multiple of its displacement.",
            (T, n),
            (rate,),
        ),
        ClosedForm(
            "g1_in_stick",
            "G of (12) in stick, and its acceleration.",
            (T, t),
            (G_STICK, G_STICK.diff(t, 2)),
        ),
        ClosedForm(
            "g1_in_slip",
            "G of (12) in slip at u = (t - t1)/s, and its acceleration.",
            (T, s, t, u),
            (SMOOTHSTEP - t / T, SMOOTHSTEP.diff(u, 2) / s**2),
        ),
    ]
    for phase in PHASES:
        value = dimensionless(phase.residual(y)).subs(named)
        summary = f"Residual (13) in {phase.name} of a motion, at one time."
        arguments = (acceleration, displacement)
        forms.append(ClosedForm(f"residual_in_{phase.name}", summary, arguments, (value,)))
    return tuple(forms)


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms that ``g1`` adds to those of the Fourier series."""
    by = "and its derivatives by t1 and T."
    return (
        *bessel_forms(),
        *moment_forms(),
        _form("g1_by_one", f"Coefficient of c1 in (5), {by}", dimensionless(by_one())),
        _form("g1_by_sine", f"Coefficient of c1 in (6), {by}", dimensionless(by_sine())),
        _form("g1_by_cosine", f"Coefficient of c1 in (7), {by}", dimensionless(by_cosine())),
        _form("g1_by_g1", f"Coefficient of c1 in (14), {by}", dimensionless(by_g1())),
        _form("g1_velocity", f"Velocity of G at t = 0, {by}", G_STICK.diff(t)),
        _form("mean_of_g1", f"Twice the mean of G, {by}", mean()),
        _form("sine_of_g1", f"Sine harmonic of G, {by}", sine_of_g1()),
        _form("cosine_of_g1", f"Cosine harmonic of G, {by}", cosine_of_g1()),
        *_pointwise_forms(),
    )
