"""Stage 3, Section 3.2: harmonic balance with one C1 function, equations (11) to (14).

Input: the Fourier series of `fourier` and the function ``g1`` of (12).
Output: `derive`, the record of the method.

The kernel works with ``G = g1/(T s**3)``, the same function in smoothstep form: the
printed cubic cancels catastrophically when ``s = T - t1`` is much smaller than ``T``.
"""

import sympy as sp

from . import fourier, hb
from .inner_product import FREQUENCY, N, j, k, n
from .oscillator import PHASES, SLIP, T, V, dimensionless, omega_n, t, t1, x_0, x_s
from .slip_moments import (
    TABLES,
    bessel_forms,
    legendre_coefficients,
    moment_forms,
    moments,
    s,
    by_time,
    with_derivatives,
)
from .slip_moments import definitions as moment_definitions
from .system import ClosedForm, Equation, GalerkinSystem, Inner, require_zero

c1 = sp.Symbol("c1", real=True)
u = sp.Symbol("u", real=True)
g1 = sp.Function("g1")(t)
R2 = sp.Function("R2")(t)

#: ``g1`` put through the left side of (1).
through_g1 = g1.diff(t, 2) + omega_n**2 * g1

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

#: ``H_0``, ``H^s_j``, ``H^c_j``, ``H_g``: ``g1`` through (1), tested by each function.
H0, Hg = sp.symbols("H_0 H_g", real=True)
Hs, Hc = sp.IndexedBase("H^s"), sp.IndexedBase("H^c")


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


#: ``G'' + omega_n**2 G`` in slip, a cubic in ``u``; in stick it is zero.
THROUGH_MOTION = sp.collect(_in_u(SLIP.residual(G_SLIP) - fourier.FORCING), u)


def _slip_mean(polynomial: sp.Expr) -> sp.Expr:
    return sp.expand(s * sp.integrate(sp.expand(polynomial), (u, 0, 1)))


def _by_harmonic(table: int) -> sp.Expr:
    """Return ``int_slip (G'' + omega_n**2 G) f(j omega_0 t) dt``, f cos (0) or sin (1)."""
    coefficients = legendre_coefficients(THROUGH_MOTION, u)
    return sp.Add(*(c * TABLES[l][table][j] for l, c in coefficients.items()))


#: Inner products of `THROUGH_MOTION` with each test function, in closed form.
BY_ONE = _slip_mean(THROUGH_MOTION)
BY_SINE = _by_harmonic(1)
BY_COSINE = _by_harmonic(0)
BY_G1 = _slip_mean(THROUGH_MOTION * _in_u(G_SLIP))


def check_symmetry() -> None:
    """Check that (14) has the column of ``c1`` as its row: the Galerkin form is symmetric.

    The row tests a harmonic's residual with ``G``, in stick and in slip; the column tests
    the residual of ``G``, which vanishes in stick, with the harmonic.

    Raises
    ------
    DerivationError
        If a coefficient of (14) differs from the coefficient of ``c1`` in (6) or (7).
    """
    through = SLIP.residual(G_SLIP) - fourier.FORCING
    for name, wave in (("sines", fourier.SINE), ("cosines", fourier.COSINE)):
        stick, slip = (part.subs(FREQUENCY) for part in fourier.homogeneous(wave))
        row = sp.integrate(sp.expand(stick * G_STICK), (t, 0, t1))
        row += sp.integrate(sp.expand(slip * G_SLIP), (t, t1, T))
        column = sp.integrate(sp.expand(through * wave.subs(FREQUENCY)), (t, t1, T))
        require_zero([(f"coefficient of the {name} in (14)", row - column)])


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


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of Section 3.2, for emission."""
    by = "and its derivatives by t1 and T."
    return (
        *fourier.closed_forms(),
        *bessel_forms(),
        *moment_forms(),
        _form("g1_by_one", f"Coefficient of c1 in (5), {by}", dimensionless(BY_ONE)),
        _form("g1_by_sine", f"Coefficient of c1 in (6), {by}", dimensionless(BY_SINE)),
        _form("g1_by_cosine", f"Coefficient of c1 in (7), {by}", dimensionless(BY_COSINE)),
        _form("g1_by_g1", f"Coefficient of c1 in (14), {by}", dimensionless(BY_G1)),
        _form("g1_velocity", f"Coefficient of c1 in (10), {by}", G_STICK.diff(t)),
    )


def _jacobian() -> tuple[Equation, ...]:
    """Return the derivatives that ``c1`` and (14) add to those of the Fourier series."""
    rows = []
    for number, column in (("5", H0), ("6", Hs[j]), ("7", Hc[j]), ("14", Hg)):
        label = sp.Derivative(sp.Symbol(f"R_{number}"), c1, evaluate=False)
        rows.append(Equation("", f"({number}) by c1", (label, column)))
    for unknown, row in ((fourier.a0, H0 / 2), (fourier.a[n], Hs[n]), (fourier.b[n], Hc[n])):
        label = sp.Derivative(sp.Symbol("R_14"), unknown, evaluate=False)
        rows.append(Equation("", "(14) by the series", (label, row)))
    for l, tables in TABLES.items():
        if l == 0:
            continue
        for table, value in zip(tables, moments(l), strict=True):
            for time, derivative in zip((t1, T), with_derivatives(value)[1:], strict=True):
                label = sp.Derivative(table[k], time, evaluate=False)
                rows.append(Equation("", "time derivative", (label, derivative)))
    for name, value in ((H0, BY_ONE), (Hs[j], BY_SINE), (Hc[j], BY_COSINE), (Hg, BY_G1)):
        scale = SCALE_S**2 if name is Hg else SCALE_S
        for time in (t1, T):
            label = sp.Derivative(name, time, evaluate=False)
            sides = (label, through_tables(scale * value, time))
            rows.append(Equation("", "time derivative", sides))
    return tuple(rows)


def _definitions() -> tuple[Equation, ...]:
    moments = {
        H0: (Inner(through_g1, sp.Integer(1)), sp.factor(SCALE_S * BY_ONE)),
        Hs[j]: (Inner(through_g1, fourier.TEST["6"]), SCALE_S * BY_SINE),
        Hc[j]: (Inner(through_g1, fourier.TEST["7"]), SCALE_S * BY_COSINE),
        Hg: (Inner(through_g1, g1), SCALE_S**2 * BY_G1),
    }
    title = "g1 through (1), in slip"
    return tuple(Equation("", title, (h, *sides)) for h, sides in moments.items())


def _orthogonality() -> tuple[Equation, ...]:
    """Return (5), (6), (7) for ``R2`` and (14)."""
    rows = []
    columns = {"5": H0, "6": Hs[j], "7": Hc[j]}
    for number, column in columns.items():
        sides = (Inner(R2, fourier.TEST[number]), fourier.orthogonality(number) + c1 * column)
        where = "" if number == "5" else "j = 1, ..., N"
        title = f"({number}) for R2"
        rows.append(Equation(number, title, (*sides, sp.Integer(0)), where))
    forcing = fourier.FORCING * _slip_mean(_in_u(G_SLIP))
    require_zero([("forcing of (14)", forcing + x_s * BY_ONE)])
    series = sp.Sum(fourier.a[n] * Hs[n] + fourier.b[n] * Hc[n], (n, 1, N))
    closed = fourier.a0 * H0 / 2 + series + c1 * Hg - x_s * H0
    sides = (Inner(R2, g1), closed, sp.Integer(0))
    rows.append(Equation("14", "orthogonal to g1", sides))
    return tuple(rows)


def derive() -> GalerkinSystem:
    """Derive Section 3.2 from (1), (2) and the expansion (11) with ``g1`` of (12).

    Returns
    -------
    GalerkinSystem
        With the ``2 N + 4`` conditions (5), (6), (7), (14), (9), (10).

    Raises
    ------
    DerivationError
        If `g1` is not periodic, not C1, or not a smoothstep, or if (14) is not symmetric.
    """
    check_g1()
    check_symmetry()
    velocity = fourier.VELOCITY_AT_0 + c1 * G1_STICK.diff(t)
    displacement = fourier.DISPLACEMENT_AT_0 + c1 * G1_STICK.subs(t, 0)
    stick, slip = (f"{p.start} <= t < {p.end} ({p.name})" for p in PHASES)
    R1 = hb.R1
    return GalerkinSystem(
        method="hb-c1",
        section="3.2",
        title="Classical harmonic balance with one C1 term",
        unknowns="a0, a_1..a_N, b_1..b_N, c1 T (T - t1)**3, t1, T",
        equations=(
            Equation("11", "expansion", (hb.x(t), fourier.SERIES + c1 * g1)),
            Equation("12", "g1 in stick", (g1, G1_STICK, SCALE * G_STICK), stick),
            Equation("12", "g1 in slip", (g1, G1_SLIP, SCALE * (SMOOTHSTEP - t / T)), slip),
            Equation("", "time in slip", (u, (t - t1) / (T - t1))),
            Equation("13", "residual in stick", (R2, R1), stick),
            Equation("13", "residual in slip", (R2, R1 + c1 * through_g1), slip),
            *_orthogonality(),
            *fourier.definitions(),
            *_definitions(),
            *moment_definitions(),
            Equation("9", "displacement at t = 0", (hb.x(0), displacement, x_0)),
            Equation("10", "velocity at t = 0", (hb.v0, velocity, V)),
        ),
        jacobian=(*fourier.jacobian(), *_jacobian()),
        forms=closed_forms(),
    )
