"""Stage 2g: C1 functions ``g_l`` that are odd about mid-stick, for every odd ``l``.

Input: the slip moments and the twice integrated Legendre polynomials.
Output: what `hb_symmetric` needs of them, with the index ``l`` symbolic.

``g_l`` has the acceleration ``P_l*`` in slip and none in stick.  From ``l = 3`` on, ``P_l*``
integrated twice vanishes at both ends of slip with its slope, and ``g_l`` is zero in stick.
``P_1*`` integrated twice does not come back: a drift makes it periodic, and ``g_1`` is the
function (12) of the paper up to a factor and a constant.

    g_l = q_{l-2} P_{l-2}* + q_l P_l* + q_{l+2} P_{l+2}*  in slip,   drift tau  in stick

The kernel combines them into functions whose accelerations ``v (1 - v**2)**i`` join stick
ever more smoothly: with K of them the first jump that is left to the sines is that of the
derivative K + 2.  In (9) and (10) it is one of displacement or of velocity by turns, and the
period converges like ``N**-1`` (K = 0), ``N**-3`` (1, 2), ``N**-5`` (3, 4), ``N**-7`` (5, 6).
"""

from collections.abc import Iterator
from functools import cache

import sympy as sp

from ...system import ClosedForm, require_zero
from ..paper import g1
from ..paper.c1_legendre import n as degree
from ..paper.c1_legendre import twice
from ..paper.inner_product import FREQUENCY, j, k, omega_0
from ..paper.oscillator import T, t, t1
from ..paper.slip_moments import about_mid_slip, s, with_derivatives, z

l = sp.Symbol("l", integer=True, positive=True)
v = sp.Symbol("v", real=True)

#: ``j_{l-1}(z)``, ``j_l(z)``, and the sign ``(-1)**(k + (l - 1)/2)`` of a moment.
below, here, sign = sp.symbols("j_below j_here sign", real=True)

#: ``M_lk``: the integral over slip of ``P_l* sin(k omega_0 tau)``, for odd ``l``.
MOMENT = sign * s * here

#: The derivative of ``j_l(z)``.
BESSEL_SLOPE = below - (l + 1) * here / z


@cache
def _part(shift: int) -> sp.Expr:
    return sp.factor(s**2 * twice()[shift].subs(degree, l))


def q_below() -> sp.Expr:
    """Return ``q_{l-2}`` of ``g_l``; for ``l = 1`` there is none."""
    return _part(-2)


def q_here() -> sp.Expr:
    """Return ``q_l`` of ``g_l``."""
    return _part(0)


def q_above() -> sp.Expr:
    """Return ``q_{l+2}`` of ``g_l``."""
    return _part(2)


#: Slope of ``g_1`` in stick, and what it adds to ``q_1``.
DRIFT = s**2 / (6 * T)
Q_OF_DRIFT = DRIFT * s / 2

#: ``v**2 P_l`` in ``P_{l-2}``, ``P_l``, ``P_{l+2}``.
SQUARED = (
    l * (l - 1) / ((2 * l + 1) * (2 * l - 1)),
    (l + 1) ** 2 / ((2 * l + 1) * (2 * l + 3)) + l**2 / ((2 * l + 1) * (2 * l - 1)),
    (l + 1) * (l + 2) / ((2 * l + 1) * (2 * l + 3)),
)

M_j, M3_j = sp.symbols("M M3", real=True)

#: Sine harmonic ``j`` of ``g_l``: ``<g, f> = -<g'', f>/(j omega_0)**2`` over the period.
HARMONIC = -2 / T * M_j / (j * omega_0).subs(FREQUENCY) ** 2

#: ``g_l'' + g_l`` in slip tested by harmonic ``j``: by parts for ``l >= 3``, where nothing
#: is left at the ends; through ``M_1`` and ``M_3`` for ``l = 1``, where that would cancel.
THROUGH = M_j * (1 - 1 / (j * omega_0).subs(FREQUENCY) ** 2)


def through_1() -> sp.Expr:
    """Return the same for ``l = 1``."""
    return M_j * (1 + q_here().subs(l, 1) + Q_OF_DRIFT) + M3_j * q_above().subs(l, 1)


def in_slip(index: int) -> sp.Expr:
    """Return ``g_index`` in slip as a polynomial in ``v = 2 (tau - T/2)/s``."""
    parts = {index - 2: q_below(), index: q_here(), index + 2: q_above()}
    total = sum(q.subs(l, index) * sp.legendre(d, v) for d, q in parts.items() if d > 0)
    return sp.expand(total + (Q_OF_DRIFT * v if index == 1 else 0))


def check_functions() -> None:
    """Check by SymPy that the ``g_l`` are what the text above says.

    Raises
    ------
    DerivationError
        Naming the property that fails, and the index.
    """
    require_zero(_claims())


def _claims() -> Iterator[tuple[str, sp.Expr]]:
    """Yield each property, and what is zero if it holds."""
    for index in (1, 3, 5, 9):
        g, drift = in_slip(index), DRIFT if index == 1 else sp.Integer(0)
        slope = g.diff(v) * 2 / s
        yield f"acceleration of g_{index}", slope.diff(v) * 2 / s - sp.legendre(index, v)
        yield f"g_{index} at the end of stick", g.subs(v, -1) - drift * (T - s) / 2
        yield f"slope of g_{index} there", slope.subs(v, -1) - drift
    G = (g1.SMOOTHSTEP - t / T).subs(g1.u, (v + 1) / 2).subs(t, T - s / 2 + s * v / 2)
    paper = -(s**2) / 6 * (G + (T - s) / (2 * T))
    yield "g_1 is (12) but for a factor and a constant", in_slip(1) - paper
    for index in (1, 3, 8):
        parts = zip((index - 2, index, index + 2), SQUARED, strict=True)
        total = sum(q.subs(l, index) * sp.legendre(max(d, 0), v) for d, q in parts)
        yield f"v**2 P_{index}", total - v**2 * sp.legendre(index, v)
    for index in (1, 3):
        moment = about_mid_slip(index)
        slope = moment.diff(z) - BESSEL_SLOPE.subs(
            {below: sp.jn(index - 1, z), here: sp.jn(index, z), l: index}
        ) * (-1) ** (index // 2)
        yield f"derivative of j_{index}", slope
    for index in (3, 5):
        wave = sp.sin(2 * z * v / 2)
        direct = sp.integrate(in_slip(index).subs(s, 1) * wave, (v, -1, 1)) / 2
        parts = -about_mid_slip(index) / (2 * z) ** 2
        yield f"g_{index} by parts", direct - parts


def _through_bessel(value: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return `value` and its derivatives by ``t1`` and ``T``, through ``z`` too."""
    bessel = sp.Function("j_l")(z)
    opened = with_derivatives(value.subs(here, bessel))
    closed = {bessel.diff(z): BESSEL_SLOPE, bessel: here}
    return tuple(sp.factor(part.subs(closed)) for part in opened)


def _with_moments(value: sp.Expr) -> tuple[sp.Expr, ...]:
    """Return `value` and its derivatives; those of a moment are rows of its table."""
    tables = {M_j: sp.IndexedBase("M"), M3_j: sp.IndexedBase("M3")}
    values = with_derivatives(value)
    rows = []
    for row, part in enumerate(values):
        total = part.subs({name: table[0] for name, table in tables.items()})
        if row:
            total += sum(value.diff(name) * table[row] for name, table in tables.items())
        rows.append(sp.expand(total))
    return tuple(rows)


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the closed forms of the odd C1 functions, for emission."""
    by = "and its derivatives by t1 and T."
    M, M3 = sp.IndexedBase("M"), sp.IndexedBase("M3")
    angle = (k * omega_0 * s / 2).subs(FREQUENCY)
    return (
        ClosedForm(
            "half_slip_angle",
            "z_k: half the angle that harmonic k turns through in slip.",
            (T, k, s),
            (angle,),
        ),
        ClosedForm(
            "moment",
            f"M_lk from j_{{l-1}}(z_k), j_l(z_k), {by}",
            (T, below, here, k, l, s, sign, t1, z),
            _through_bessel(MOMENT),
        ),
        ClosedForm(
            "harmonic", f"Sine harmonic j of g_l, {by}", (M, T, j), _with_moments(HARMONIC)
        ),
        ClosedForm(
            "through_motion",
            f"Coefficient of c_l, l >= 3, in (6), {by}",
            (M, T, j),
            _with_moments(THROUGH),
        ),
        ClosedForm(
            "through_motion_1",
            f"Coefficient of c_1 in (6), {by}",
            (M, M3, T, s),
            _with_moments(through_1()),
        ),
        ClosedForm(
            "in_legendre",
            "q_{l-2}, q_l, q_{l+2} of g_l, and their derivatives by s.",
            (l, s),
            (
                q_below(),
                q_here(),
                q_above(),
                *(sp.diff(q, s) for q in (q_below(), q_here(), q_above())),
            ),
        ),
        ClosedForm("drift", f"Slope of g_1 in stick, {by}", (T, s), with_derivatives(DRIFT)),
        ClosedForm(
            "drift_in_slip",
            f"What the drift adds to q_1, {by}",
            (T, s),
            with_derivatives(Q_OF_DRIFT),
        ),
        ClosedForm(
            "squared",
            "v**2 P_l in P_{l-2}, P_l, P_{l+2}.",
            (l,),
            SQUARED,
        ),
        ClosedForm(
            "legendre_norm",
            "Integral over slip of P_l* squared, and its derivative by s.",
            (l, s),
            (s / (2 * l + 1), 1 / (2 * l + 1)),
        ),
    )
