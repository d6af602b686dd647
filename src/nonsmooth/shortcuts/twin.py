"""The high-precision twin: the same equations in any number of digits.

The record that SymPy derived is evaluated a second time, in ball arithmetic (Arb, through
python-flint), and the orbit that float64 found is refined: the residual in high precision,
the step by the Jacobian in float64.  Each step gains about ten digits.  What is left is the
radius of the ball around each time: a difference from the exact orbit is computed anew with
more digits until its own ball is small against it.  It settles every dispute about float64.
"""

import math
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from flint import arb, ctx, fmpq

from ..codegen.shortcuts.precise import kernel
from ..solver.arrays import Vector
from ..solver.shortcuts.orbit.orbit import Orbit
from ..solver.shortcuts.orbit.oscillator import StickSlip
from ..solver.shortcuts.search import kernels

#: Digits that the reader may ask for.
FEWEST, MOST = 1, 1000

#: Digits of an error that are shown, where no fewer are asked for.
SHOWN_OF_ERROR = 20

#: Digits carried at first beyond those asked for: a guess, the balls ask for more.
GUARD = 25

#: Digits beyond which an error counts as zero; steps, beside one for each digit.
MOST_DIGITS, ITERATION_LIMIT = 10_000, 200


class PrecisionError(ArithmeticError):
    """The refinement did not converge: the float64 orbit was not an approximation of one."""


@contextmanager
def precision(digits: int) -> Iterator[None]:
    """Work with this many decimal digits, and restore the setting of python-flint."""
    before = ctx.dps
    ctx.dps = digits
    try:
        yield
    finally:
        ctx.dps = before


def numbers() -> dict[str, Any]:
    """Return what a kernel needs of ball arithmetic, at the precision in force."""
    return {
        "cos": lambda x: arb(x).cos(),
        "sin": lambda x: arb(x).sin(),
        "pi": arb.pi(),
        "rational": lambda p, q: arb(fmpq(p, q)),
    }


@cache
def _residual(method: str, digits: int) -> Any:
    """Return the residual of a kernel in ball arithmetic; `digits` are those in force."""
    return kernel(method, numbers())["residual"]


@dataclass(frozen=True)
class Twin:
    """Refined unknowns of a kernel.

    Parameters
    ----------
    unknowns : tuple of arb
        Coefficients, ``t1``, ``T``; dimensionless.  The radius of the times is what the last
        step and the rounding of the residual leave open; the coefficients are midpoints.
    iterations : int
        Evaluations of the residual in high precision.
    residual_norm : arb
        Maximum norm of the residual.
    """

    unknowns: tuple[Any, ...]
    iterations: int
    residual_norm: Any

    @property
    def t1(self) -> Any:
        """End of stick, dimensionless."""
        return self.unknowns[-2]

    @property
    def T(self) -> Any:
        """Period, dimensionless."""
        return self.unknowns[-1]


def refine(method: str, alpha: Any, start: Vector, digits: int) -> Twin:
    """Refine a float64 solution to `digits` digits of ``t1`` and ``T``, relative to ``T``.

    Parameters
    ----------
    method : {"hb", "hb-c1", "c1"}
        Section 3.1, 3.2 or 3.3.
    alpha : arb or float
        The parameter; a float stands for its exact binary value.
    start : ndarray
        Unknowns of the kernel as float64 found them.
    digits : int
        Decimal digits wanted.

    Raises
    ------
    PrecisionError
        If the steps do not get shorter.
    """
    working = digits + GUARD
    while working <= 4 * MOST_DIGITS:
        with precision(working):
            twin = _refine(method, arb(alpha), start, digits)
        if twin is not None:
            return twin
        working *= 2
    raise PrecisionError(f"{method}: {digits} digits are not had with {4 * MOST_DIGITS}")


def _refine(method: str, alpha: Any, start: Vector, digits: int) -> Twin | None:
    """Refine at the precision in force; None if its balls are too wide for `digits`."""
    residual = _residual(method, ctx.dps)
    z = np.array([arb(float(value)) for value in start], dtype=object)
    R = np.full(len(z), arb(0), dtype=object)
    J = np.empty((len(z), len(z)))
    kernels.compiled(method).jacobian(float(alpha), start, J)
    inverse = np.linalg.inv(J)
    goal = arb(10) ** -(digits + 2) * z[-1]
    shortest = arb("inf")
    for iteration in range(1, ITERATION_LIMIT + digits):
        residual(alpha, z, R)
        norm = max(abs(value.mid()) for value in R)
        # What the rounding of the residual moves the times by, and the step.
        rounding = max(value.rad() for value in R) * float(
            np.abs(inverse[-2:]).sum(axis=1).max()
        )
        if not rounding < goal / 10:
            return None
        scale = norm if norm != 0 else arb(1)
        step = inverse @ np.array([float((value / scale).mid()) for value in R])
        z = np.array(
            [(value - arb(float(s)) * scale).mid() for value, s in zip(z, step, strict=True)]
        )
        length = scale * float(np.abs(step[-2:]).max())
        if length < goal:
            radius = (length + rounding).upper()
            times = (arb(value, radius) for value in z[-2:])
            return Twin((*z[:-2], *times), iteration, norm)
        if not length < 4 * shortest:
            raise PrecisionError(f"{method}: the refinement does not converge")
        shortest = min(shortest, length)
    raise PrecisionError(f"{method}: no convergence within the limit of steps")


def exact_times(alpha: Any) -> tuple[Any, Any]:
    """Return ``t1`` and ``T`` of the exact orbit, dimensionless, at the precision in force."""
    from ..codegen.shortcuts.paper.oscillator import DIMENSIONLESS, exact_orbit  # noqa: PLC0415
    from ..codegen.shortcuts.paper.oscillator import alpha as symbol  # noqa: PLC0415
    from ..codegen.shortcuts.precise import function  # noqa: PLC0415

    orbit = exact_orbit()
    values = tuple(time.subs(dict(DIMENSIONLESS)) for time in (orbit.t1, orbit.T))
    names = numbers() | {"atan": lambda x: arb(x).atan()}
    t1, T = function((symbol,), values, names)(arb(alpha))
    return t1, T


@dataclass(frozen=True)
class PreciseOrbit:
    """Period and end of stick of an orbit in many digits, as decimal strings.

    Parameters
    ----------
    digits : int
        Digits of `period` and `t1`; of the errors as many, but no more than 20.
    period, t1 : str
        In s.
    error_period, error_t1 : str
        ``T/T_exact - 1`` and ``t1/t1_exact - 1``.
    residual_norm : str
        Maximum norm of the dimensionless residual.
    iterations : int
        Evaluations of the residual in high precision.
    """

    digits: int
    period: str
    t1: str
    error_period: str
    error_t1: str
    residual_norm: str
    iterations: int


def _alpha_and_time(belt: StickSlip) -> tuple[Any, Any]:
    """Return ``alpha`` and ``1/omega_n`` in s, the parameters taken as exact binary numbers."""
    M, K = arb(belt.mass), arb(belt.stiffness)
    drop = (arb(belt.mu_s) - arb(belt.mu_k)) * arb(belt.normal_force)
    return drop / (K * M).sqrt() / arb(belt.belt_speed), (M / K).sqrt()


def precise(orbit: Orbit, digits: int) -> PreciseOrbit:
    """Return period and end of stick of `orbit` to `digits` digits.

    Raises
    ------
    ValueError
        If `digits` is not from 1 to 1000.
    PrecisionError
        If the refinement does not converge.
    """
    if not FEWEST <= digits <= MOST:
        raise ValueError(
            f"digits: got {digits!r}, expected a whole number from {FEWEST} to {MOST}"
        )
    few = min(digits, SHOWN_OF_ERROR)
    shown = {"period": digits, "t1": digits, "error_period": few, "error_t1": few}
    refined = digits + GUARD
    while refined <= MOST_DIGITS:
        values, twin = _times_and_errors(orbit, refined)
        if all(_is_sure(values[name], shown[name]) for name in shown):
            texts = {name: str(values[name].str(shown[name], radius=False)) for name in shown}
            norm = str(twin.residual_norm.str(3, radius=False))
            return PreciseOrbit(
                digits=digits, **texts, residual_norm=norm, iterations=twin.iterations
            )
        refined *= 2
    raise PrecisionError(f"{orbit.method}: its error is zero in {MOST_DIGITS} digits")


def _times_and_errors(orbit: Orbit, digits: int) -> tuple[dict[str, Any], Twin]:
    """Return times in s and their errors as balls, by the names of `PreciseOrbit`."""
    with precision(2 * digits + 100):  # so that nothing hangs on the parameters
        alpha, unit = _alpha_and_time(orbit.belt)
        twin = refine(orbit.method, alpha, orbit.unknowns, digits)
        t1, T = exact_times(alpha)
        return {
            "period": twin.T * unit,
            "t1": twin.t1 * unit,
            "error_period": (twin.T - T) / T,
            "error_t1": (twin.t1 - t1) / t1,
        }, twin


def _is_sure(value: Any, digits: int) -> bool:
    """Return whether the ball of `value` is small against it: its digits, and one more."""
    return bool(value.rel_accuracy_bits() > (digits + 1) * math.log2(10))
