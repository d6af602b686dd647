"""Correct digits of the times of an orbit in float64, at the extremes of a scene."""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..arrays import Vector
from ..exact import ExactOrbit, exact_orbit
from ..flow.exact_system import exact_kernel
from ..kernels import registry
from ..kernels.kernel import Kernel
from ..no_orbit import NoOrbit
from ..orbit.solution import attempt
from ..scaling import equilibrated
from ..scenes.case import Case
from ..scenes.cell import Cell
from ..scenes.methods import EXACT, about, in_order
from ..scenes.parameter_error import ParameterError
from ..solve import number_of_functions
from . import exact_balls
from .balls import Residual
from .bodies import exact as exact_bodies
from .bodies import force_series, harmonics
from .refine import PrecisionError, refine

#: Digits of the solution in balls: enough to judge float64.
DIGITS = 22

#: Largest error of the times allowed in float64, relative to the period; it is multiplied by
#: the condition number of the orbit, if that is above 1.
TARGET = 1e-13

#: Relative change of a parameter in central differences, whose error is its square.
STEP = 2.0**-17

#: Machine epsilon of float64.
EPSILON = float(np.finfo(float).eps)

#: Orders that are measured by default.
ORDERS: tuple[int, ...] = (5, 10, 20, 40)
QUICK_ORDERS: tuple[int, ...] = (10,)

#: Marks after digits: few by conditioning, lost, no orbit.
CONDITIONED, LOST, ABSENT = "c", "!", "-"


@dataclass(frozen=True)
class Kept:
    """The accuracy of one method at one extreme and order.

    Parameters
    ----------
    extreme : str
        The extreme in words; empty for the parameters as given.
    method : str
        Generic name; ``"exact"`` for the exact equations.
    order : int or None
        ``N``; None for the exact equations.
    status : str
        ``"ok"``, ``"no-orbit"``, ``"not-converged"``.
    error : float or None
        Largest error of a duration, and of the phase of the forcing over its angular
        frequency, against the same equations in balls; relative to the period.
    condition : float or None
        Condition number of the Jacobian with scaled rows and columns.
    orbit_condition : float or None
        Condition number of the orbit; see the function `condition`.
    iterations : int
        Jacobians formed.
    """

    extreme: str
    method: str
    order: int | None
    status: str
    error: float | None = None
    condition: float | None = None
    orbit_condition: float | None = None
    iterations: int = 0

    @property
    def digits(self) -> float | None:
        """Correct decimal digits of the times, at most 16."""
        return None if self.error is None else -math.log10(max(self.error, 1e-16))

    @property
    def target(self) -> float:
        """Largest error allowed, relative to the period."""
        return TARGET * max(1.0, self.orbit_condition or 1.0)

    @property
    def met(self) -> bool | None:
        """Whether the error is within the target; None where there is no orbit to measure."""
        return None if self.error is None else self.error <= self.target

    @property
    def conditioned(self) -> bool | None:
        """Whether the condition number of the method's own equations explains the error."""
        if self.error is None or self.condition is None:
            return None
        return bool(self.error <= EPSILON * self.condition)

    @property
    def lost(self) -> bool:
        """Whether more digits are lost than both condition numbers explain."""
        return self.met is False and not self.conditioned

    @property
    def words(self) -> str:
        """The digits as text, with a mark if the target is missed."""
        if self.digits is None:
            return ABSENT
        mark = LOST if self.lost else "" if self.met else CONDITIONED
        return f"{self.digits:.1f}{mark}"


def extremes(case: Case) -> tuple[tuple[str, Case], ...]:
    """Return a case and its extremes (other values of its parameters), each with its words.

    Raises
    ------
    ParameterError
        If a formula of an extreme has no value for these parameters, or one that is not a
        parameter of an oscillator.
    """
    labels = getattr(case.scene.module, "EXTREMES", ())
    try:
        values = case.scene.numbers("extremes", tuple(case.values.values())) if labels else ()
    except (ZeroDivisionError, OverflowError, ValueError) as error:
        raise ParameterError([f"extremes: no numbers for these parameters ({error})"]) from None
    return (
        ("", case),
        *(
            (label, Case(case.scene, dict(zip(case.values, numbers, strict=True)), case.cycles))
            for label, numbers in zip(labels, values, strict=True)
        ),
    )


def measure(
    case: Case,
    orders: Sequence[int] = ORDERS,
    methods: Sequence[str] | None = None,
    progress: Callable[[Kept], None] = lambda kept: None,
) -> list[Kept]:
    """Return the accuracy of each method at each extreme of a case.

    Parameters
    ----------
    case : Case
    orders : sequence of int
        ``N``; those below the lowest of a method count as not converged.
    methods : sequence of str, optional
        Generic names; all by default.
    progress : callable
        Called with each measurement.

    Raises
    ------
    ParameterError
        If parameters at an extreme are not those of an oscillator.
    """
    accuracies = []
    for words, extreme in extremes(case):
        for kept in at(words, extreme, orders, methods):
            progress(kept)
            accuracies.append(kept)
    return accuracies


def at(
    words: str, case: Case, orders: Sequence[int], methods: Sequence[str] | None = None
) -> Iterator[Kept]:
    """Yield the accuracy of the exact equations, then of each method, for one case."""
    names = in_order(registry.methods(case.scene) if methods is None else methods)
    try:
        exact = exact_orbit(case)
    except NoOrbit as finding:
        yield Kept(words, EXACT, None, finding.status, iterations=finding.iterations)
        for name in names:
            for order in orders:
                yield Kept(words, name, order, finding.status)
        return
    case, outcome, sensitive = exact.case, exact.outcome, condition(exact)
    kept = Kept(words, EXACT, None, "not-converged", None, None, sensitive, outcome.iterations)
    yield _against_balls(kept, case, exact_kernel(case.cell), case.cell, outcome.unknowns)
    for name in names:
        for order in orders:
            kept = Kept(words, name, order, "not-converged", orbit_condition=sensitive)
            yield _of_method(kept, exact, name, order)


def _of_method(measured: Kept, exact: ExactOrbit, method: str, order: int) -> Kept:
    """Return the accuracy of a method, started from the times of the exact orbit."""
    case = exact.case
    functions = number_of_functions(case, method, None)
    kernel = registry.kernel(case.scene, method, functions)
    if order < kernel.lowest:
        return measured
    outcome = attempt(kernel, case, order, exact.times, functions)
    measured = replace(measured, iterations=outcome.iterations)
    if not (outcome.converged and outcome.admissible):
        return measured
    return _against_balls(measured, case, kernel, kernel.given(case, order), outcome.unknowns)


def _against_balls(
    measured: Kept, case: Case, kernel: Kernel, arguments: Any, z: Vector
) -> Kept:
    """Return a measurement with the error of a solution of a kernel's equations, by balls."""
    z = _unknowns(case, kernel, z)
    J = np.empty((len(z), len(z)))
    kernel.jacobian(arguments, z, J)
    measured = replace(measured, condition=float(np.linalg.cond(equilibrated(J))))
    try:
        precise = refine(kernel, arguments, z, DIGITS, in_balls(case, measured.method))
    except PrecisionError:
        return measured
    errors = [float(abs(a - float(b))) for a, b in zip(precise, kernel.times(z), strict=True)]
    if case.cell.forced:
        errors[-1] /= case.cell.omega
    period = float(np.sum(kernel.split(z)[0])) * case.cell.cells
    return replace(measured, status="ok", error=max(errors) / period)


def _unknowns(case: Case, kernel: Kernel, z: Vector) -> Vector:
    """Return the unknowns of a kernel's residual: those of a body are the times alone."""
    return kernel.times(z) if case.scene.has_body else z


def in_balls(case: Case, method: str) -> Residual | None:
    """Return the residual of a method in balls; None if it is made from the kernel's source."""
    if not case.scene.has_body:
        return exact_balls.residual if method == EXACT else None
    if method == EXACT:
        return exact_bodies.residual
    return harmonics.residual if about(method).is_series else force_series.residual


def condition(orbit: ExactOrbit) -> float:
    """Return the condition number of the times of an orbit as functions of its parameters.

    The largest over times t of ``sum_p |p dt/dp| / T``: relative changes e of the parameters
    move a time by up to e times this, relative to the period T, in exact arithmetic too.  Times
    are durations, and the phase of the forcing over its angular frequency.  By the implicit
    function theorem on the exact equations, with central differences by the parameters.
    """
    case, kernel = orbit.case, exact_kernel(orbit.case.cell)
    z, numbers = _unknowns(case, kernel, orbit.outcome.unknowns), case.numbers
    J = np.empty((len(z), len(z)))
    kernel.jacobian(case.cell, z, J)
    changes = []
    for i, value in enumerate(numbers):
        near = (value * (1 + STEP), value * (1 - STEP))
        try:
            cells = [_with(case, i, each) for each in near]
        except ParameterError:  # a whole number, which is not rounded
            continue
        residuals = np.empty((2, len(z)))
        for cell, R in zip(cells, residuals, strict=True):
            kernel.residual(cell, z, R)
        changes.append((residuals[0] - residuals[1]) / (2 * STEP))
    rows = np.abs(J).max(axis=1)
    by_parameters = np.linalg.solve(J / rows[:, None], np.array(changes).T / rows[:, None])
    moved_by = np.abs(kernel.times(by_parameters)).sum(axis=1)
    if case.cell.forced:
        moved_by[-1] /= case.cell.omega
    period = float(np.sum(orbit.cell_durations)) * case.cell.cells
    return float(moved_by.max()) / period


def _with(case: Case, i: int, value: float) -> Cell:
    """Return the cell of a case with another value of parameter i, in the same units."""
    numbers = (*case.numbers[:i], value, *case.numbers[i + 1 :])
    return case.scene.cell(numbers, case.cycles, case.units)
