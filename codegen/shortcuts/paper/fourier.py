"""Stage 2b: the Fourier series (3) and its inner products, closed in ``n`` and ``j``.

Input: the phases of the oscillator and the inner product (8).
Output: what `hb` (Section 3.1) and `hb_c1` (Section 3.2) share: the orthogonality
conditions (5), (6), (7) of a Fourier series, the closure (9), (10), their derivatives
and the closed forms that the kernels are made of.
"""

from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

import sympy as sp

from ...system import ClosedForm, Equation
from .inner_product import (
    FREQUENCY,
    C,
    Entry,
    N,
    S,
    SlipIntegral,
    cos_k,
    entry,
    inner_product,
    j,
    k,
    n,
    omega_0,
    sin_k,
    slip_cosine,
    slip_sine,
)
from .oscillator import INITIAL_STATE, SLIP, STICK, T, dimensionless, t, t1

a0 = sp.Symbol("a0", real=True)
a = sp.IndexedBase("a", real=True)
b = sp.IndexedBase("b", real=True)

CONSTANT = sp.Rational(1, 2)
SINE = sp.sin(n * omega_0 * t)
COSINE = sp.cos(n * omega_0 * t)

#: The right side of the expansion (3).
SERIES = a0 * CONSTANT + sp.Sum(a[n] * SINE + b[n] * COSINE, (n, 1, N))

#: Test functions of (5), (6), (7).
TEST = {"5": sp.Integer(1), "6": SINE.subs(n, j), "7": COSINE.subs(n, j)}


@cache
def forcing() -> sp.Expr:
    """Return what friction contributes to the residual in slip, ``-mu_k F_N / M``."""
    return SLIP.residual(sp.Integer(0))


def homogeneous(phi: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Return the residual (4) of the basis function `phi`, in stick and in slip.

    Only what is proportional to `phi`: the spring force has cancelled in stick.
    """
    return STICK.residual(phi), sp.expand(SLIP.residual(phi) - forcing())


@cache
def entries() -> Mapping[tuple[str, str], Entry]:
    """Return the inner products of each basis function's residual with each test function."""
    return MappingProxyType(
        {
            (name, number): entry(*homogeneous(phi), test)
            for name, phi in (("a0", CONSTANT), ("a", SINE), ("b", COSINE))
            for number, test in TEST.items()
        }
    )


#: What the kernel calls them.
NAMES = {
    ("a0", "5"): "constant_by_one",
    ("a", "5"): "sine_by_one",
    ("b", "5"): "cosine_by_one",
    ("a0", "6"): "constant_by_sine",
    ("a", "6"): "sine_by_sine",
    ("b", "6"): "cosine_by_sine",
    ("a0", "7"): "constant_by_cosine",
    ("a", "7"): "sine_by_cosine",
    ("b", "7"): "cosine_by_cosine",
}


def period_term() -> sp.Expr:
    """Return ``-(j omega_0)**2 T/2``, what the acceleration adds on the diagonal."""
    return entries()["a", "6"].diagonal_term


def orthogonality(number: str) -> sp.Expr:
    """Return the left side of (5), (6) or (7) in closed form, dimensional."""
    constant, sine, cosine = (entries()[name, number] for name in ("a0", "a", "b"))
    total = sp.Sum(a[n] * sine.generic + b[n] * cosine.generic, (n, 1, N))
    total += a0 * constant.generic + inner_product(sp.Integer(0), forcing(), TEST[number])
    if number != "5":
        total += a[j] * sine.diagonal_term + b[j] * cosine.diagonal_term
    return total


def functions(number: str) -> tuple[str, ...]:
    """Return the functions of the kernel that compute (5), (6) or (7)."""
    entries = tuple(name for key, name in NAMES.items() if key[1] == number)
    return (*entries, *(() if number == "5" else ("period_term",)), "fourier_product")


#: Left side of (9): displacement of the series at ``t = 0``.
DISPLACEMENT_AT_0 = a0 / 2 + sp.Sum(b[n], (n, 1, N))


@cache
def velocity_weight() -> sp.Expr:
    """Return the velocity of a sine at ``t = 0``."""
    return SINE.diff(t).subs(t, 0)


def velocity_at_0() -> sp.Expr:
    """Return the left side of (10): velocity of the series at ``t = 0``."""
    return sp.Sum(a[n] * velocity_weight(), (n, 1, N))


def definitions() -> tuple[Equation, ...]:
    """Return ``C_k`` and ``S_k``: the slip integrals that every condition refers to."""
    rows = []
    for integral, function in ((slip_cosine(), "slip_cosine"), (slip_sine(), "slip_sine")):
        symbol, name = integral.table[k], integral.table.label
        unevaluated = sp.Integral(integral.harmonic, (t, t1, T))
        sides = (symbol, unevaluated, integral.generic)
        rows.append(Equation("", f"slip integral {name}_k", sides, "k != 0", (function,)))
        zero = (integral.table[0], integral.zero)
        title = f"slip integral {name}_0, the diagonal"
        rows.append(Equation("", title, zero, functions=(f"{function}_zero",)))
    return tuple(rows)


def jacobian() -> tuple[Equation, ...]:
    """Return the derivatives of (5)-(7): by the coefficients, and what those by time need.

    The conditions are linear in the coefficients, in ``C_k`` and in ``S_k``: a derivative
    with respect to a coefficient is its entry, and the derivatives with respect to ``t1``
    and ``T`` are the same sums over the derivatives of ``C_k``, ``S_k``.
    """
    rows = []
    for (name, number), value in entries().items():
        unknown = {"a0": a0, "a": a[n], "b": b[n]}[name]
        label = sp.Derivative(sp.Symbol(f"R_{number}"), unknown, evaluate=False)
        where = "" if name == "a0" or number == "5" else "n != j"
        rows.append(Equation("", f"({number}) by {name}", (label, value.generic), where))
        if value.diagonal_term != 0 and where:
            label = sp.Derivative(sp.Symbol(f"R_{number}"), unknown.subs(n, j))
            rows.append(
                Equation("", f"({number}) by {name}, diagonal", (label, value.diagonal))
            )
    for integral in (slip_cosine(), slip_sine()):
        for time in (t1, T):
            label = sp.Derivative(integral.table[k], time, evaluate=False)
            rows.append(Equation("", "time derivative", (label, integral.generic.diff(time))))
    for time in (t1, T):
        term = period_term().subs(FREQUENCY)
        label = sp.Derivative(term, time, evaluate=False)
        rows.append(Equation("", "diagonal term", (label, term.diff(time))))
    return tuple(rows)


def closure_jacobian(velocity: sp.Expr) -> tuple[Equation, ...]:
    """Return the derivatives of (9) and (10) that are not zero.

    Parameters
    ----------
    velocity : Expr
        Left side of (10), which alone has the times.
    """
    derivatives = {
        ("9", a0): DISPLACEMENT_AT_0.diff(a0),
        ("9", b[n]): COSINE.subs(t, 0),
        ("10", a[n]): velocity_weight(),
        ("10", t1): velocity.subs(FREQUENCY).diff(t1),
        ("10", T): velocity.subs(FREQUENCY).diff(T),
    }
    return tuple(
        Equation(
            "",
            f"({number}) by {unknown}",
            (sp.Derivative(sp.Symbol(f"R_{number}"), unknown, evaluate=False), derivative),
        )
        for (number, unknown), derivative in derivatives.items()
        if derivative != 0
    )


def _integral_form(integral: SlipIntegral, name: str) -> ClosedForm:
    """Return ``C_k`` or ``S_k`` with its derivatives, in the tabulated cos_k, sin_k."""
    angle = (k * omega_0 * t1).subs(FREQUENCY)
    tabulated = {sp.cos(angle): cos_k, sp.sin(angle): sin_k}
    value = integral.generic
    values = (value, value.diff(t1), value.diff(T))
    return ClosedForm(
        name,
        f"{integral.table.label}_k of (8), k >= 1, and its derivatives by t1 and T.",
        (cos_k, sin_k, k, t1, T),
        tuple(sp.expand(v).subs(tabulated) for v in values),
    )


def _zero_form(integral: SlipIntegral, name: str) -> ClosedForm:
    values = (integral.zero, integral.zero.diff(t1), integral.zero.diff(T))
    summary = f"{integral.table.label}_0 of (8), and its derivatives by t1 and T."
    return ClosedForm(name, summary, (t1, T), values)


def _entry_form(name: str, key: tuple[str, str]) -> ClosedForm:
    value = dimensionless(entries()[key].generic)
    tables = tuple(table for table in (C, S) if value.has(table))
    indices = tuple(index for index in (j, n) if value.has(index))
    unknown = {"a0": "a0", "a": "a_n", "b": "b_n"}[key[0]]
    where = " for n != j" if len(indices) == 2 else ""
    summary = f"Coefficient of {unknown} in ({key[1]}){where}."
    return ClosedForm(name, summary, (*tables, *indices), (value,))


def closed_forms() -> tuple[ClosedForm, ...]:
    """Return the dimensionless closed forms of a Fourier series, for emission."""
    diagonal = period_term().subs(FREQUENCY)
    velocity = velocity_weight().subs(FREQUENCY)
    return (
        _zero_form(slip_cosine(), "slip_cosine_zero"),
        _zero_form(slip_sine(), "slip_sine_zero"),
        ClosedForm(
            "angle",
            "Angle omega_0 t of the fundamental harmonic at time t.",
            (T, t),
            ((omega_0 * t).subs(FREQUENCY),),
        ),
        _integral_form(slip_cosine(), "slip_cosine"),
        _integral_form(slip_sine(), "slip_sine"),
        ClosedForm(
            "period_term",
            "Acceleration on the diagonal of (6), (7), and its derivative by T.",
            (T, j),
            (diagonal, diagonal.diff(T)),
        ),
        *(_entry_form(name, key) for key, name in NAMES.items()),
        ClosedForm(
            "velocity_weight",
            "Coefficient of a_n in (10), and its derivative by T.",
            (T, n),
            (velocity, velocity.diff(T)),
        ),
        ClosedForm(
            "initial_state",
            "Right sides of (9) and (10): displacement and velocity at t = 0.",
            (sp.Symbol("alpha", positive=True),),
            tuple(map(dimensionless, INITIAL_STATE)),
        ),
    )
