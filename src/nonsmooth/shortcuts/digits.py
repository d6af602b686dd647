"""Digits kept at the extremes: the stable forms and the printed ones, against the twin."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..solver.arrays import Matrix
from ..solver.no_orbit import NoOrbit
from ..solver.scaling import equilibrated
from ..solver.shortcuts.orbit import exact
from ..solver.shortcuts.orbit.oscillator import StickSlip
from ..solver.shortcuts.search import kernels
from ..solver.shortcuts.search.solve import solve
from . import printed
from .twin import PrecisionError, refine

#: Digits of the twin: enough to judge float64.
TWIN_DIGITS = 22

#: Largest error of ``t1`` and ``T``, as a part of ``T``, that the stable forms may have.
TARGETS = {"hb": 1e-12, "hb-c1": 1e-12, "c1": 1e-13}

#: Most iterations from the default start, those on the way to it included.
MOST_ITERATIONS = 12

ALPHAS = {
    "hb": (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0),
    "hb-c1": (0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0),
    "c1": (1e-6, 1e-4, 1e-2, 0.1, 1.0, 10.0, 1e2, 1e4, 1e6),
}
ORDERS = {
    "hb": (10, 20, 40, 80, 160),
    "hb-c1": (10, 20, 40, 80, 160),
    "c1": (1, 2, 3, 4, 5, 7, 10, 14, 20, 30, 40, 60),
}
#: One order far out for the Fourier series, where each cell takes ten seconds.
FAR_ALPHAS, FAR_ORDER = (0.01, 1.0, 30.0), 500

QUICK_ALPHAS = {"hb": (0.01, 1.0, 30.0), "hb-c1": (0.01, 1.0, 30.0), "c1": (1e-6, 1.0, 1e6)}
QUICK_ORDERS = {"hb": (10, 40), "hb-c1": (10, 40), "c1": (5, 10, 20, 60)}


@dataclass(frozen=True)
class Form:
    """How one form of the equations did.

    Parameters
    ----------
    status : str
        ``"ok"``, ``"no-orbit"``, ``"not-converged"``; for the printed form ``"helped"`` if
        it converged only when started from the orbit itself.
    error : float or None
        Largest error of ``t1`` and ``T`` against the twin, as a part of ``T``.
    condition : float or None
        Condition number of the Jacobian: scaled by rows and columns for the stable form,
        as it stands for the printed one.
    iterations : int
        Jacobians factorised.
    """

    status: str
    error: float | None
    condition: float | None
    iterations: int

    @property
    def digits(self) -> float | None:
        """Decimal digits of ``t1`` and ``T`` that are right; 16 is all that float64 has."""
        return None if self.error is None else -math.log10(max(self.error, 1e-16))


@dataclass(frozen=True)
class Cell:
    """One method at one alpha and order, by both forms."""

    method: str
    alpha: float
    order: int
    stable: Form
    printed: Form

    @property
    def met(self) -> bool:
        """Whether the stable form meets its target here, or has no orbit to find."""
        if self.stable.status == "no-orbit":
            return True
        enough = self.stable.iterations <= MOST_ITERATIONS
        return self.stable.error is not None and self.stable.error <= self.target and enough

    @property
    def target(self) -> float:
        """Largest error allowed, as a part of ``T``."""
        return TARGETS[self.method]


def lowest_order(method: str, alpha: float) -> int:
    """Return the order from which the target holds: for Fourier series, slip is resolved."""
    if method == "c1":
        return 1
    t1, T = exact.times(alpha)
    return max(10, math.ceil(2 * T / (T - t1)))


def cells(quick: bool = False) -> list[tuple[str, float, int]]:
    """Return the grid: methods, alphas, orders."""
    alphas, orders = (QUICK_ALPHAS, QUICK_ORDERS) if quick else (ALPHAS, ORDERS)
    grid = [
        (method, alpha, order)
        for method in TARGETS
        for alpha in alphas[method]
        for order in orders[method]
        if order >= lowest_order(method, alpha)
    ]
    far = [(method, alpha, FAR_ORDER) for method in ("hb", "hb-c1") for alpha in FAR_ALPHAS]
    return grid if quick else grid + far


def belt_at(alpha: float) -> StickSlip:
    """Return the default oscillator with the normal force that makes this alpha."""
    return StickSlip(
        mass=10, stiffness=1000, belt_speed=1, mu_s=0.5, mu_k=0.25, normal_force=400 * alpha
    )


def scaled_condition(J: Matrix) -> float:
    """Return the condition number of `J` with rows and columns scaled to the same size."""
    return float(np.linalg.cond(equilibrated(J)))


def measure(
    grid: Sequence[tuple[str, float, int]],
    progress: Callable[[Cell], None] = lambda cell: None,
) -> list[Cell]:
    """Measure both forms in every cell of `grid`, against the twin."""
    done = []
    for method, alpha, order in grid:
        cell = _measure(method, alpha, order)
        progress(cell)
        done.append(cell)
    return done


def _measure(method: str, alpha: float, order: int) -> Cell:
    belt = belt_at(alpha)
    try:
        orbit = solve(belt, method, order, many=True)
    except NoOrbit as finding:
        none = Form(finding.status, None, None, finding.iterations)
        return Cell(method, alpha, order, none, none)
    try:
        twin = refine(method, belt.alpha, orbit.unknowns, TWIN_DIGITS)
    except PrecisionError:
        lost = Form("not-converged", None, None, orbit.iterations)
        return Cell(method, alpha, order, lost, lost)

    def error(t1: float, T: float) -> float:
        differences = (abs(float(twin.t1 - t1)), abs(float(twin.T - T)))
        return max(differences) / float(twin.T)

    size = len(orbit.unknowns)
    J = np.empty((size, size))
    kernels.compiled(method).jacobian(belt.alpha, orbit.unknowns, J)
    t1, T = orbit.unknowns[-2:]
    stable = Form("ok", error(t1, T), scaled_condition(J), orbit.iterations)
    return Cell(
        method,
        alpha,
        order,
        stable,
        _printed(method, order, belt, orbit.t1, orbit.period, error),
    )


def _printed(
    method: str,
    order: int,
    belt: StickSlip,
    t1: float,
    period: float,
    error: Callable[[float, float], float],
) -> Form:
    """Solve the printed form, from the rough start, else from the orbit itself."""
    outcome, J = printed.solve(method, order, belt)
    status, iterations = "ok", outcome.iterations
    if not outcome.converged or abs(outcome.unknowns[-1] / period - 1) > 1e-3:
        outcome, J = printed.solve(method, order, belt, (t1, period))
        status = "helped" if outcome.converged else "not-converged"
    finite = bool(np.isfinite(J).all())
    condition = float(np.linalg.cond(J)) if finite else math.inf
    if status == "not-converged":
        return Form(status, None, condition, iterations)
    times = outcome.unknowns[-2:] / belt.time_unit
    return Form(status, error(*times), condition, iterations)
