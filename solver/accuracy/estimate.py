"""Estimate of an orbit's error without the exact orbit: its difference from a better orbit.

The better orbit is by the method whose times converge fastest, started from the orbit's times,
at an order where it has nearly always converged.  Its own error, estimated by its change over a
few more orders, is added.  If that change is not much smaller than the first, as in a boundary
layer that no order resolves, the estimate is at least the error against the exact orbit.  If no
better orbit is found, that error is returned.  It always is for a body, each orbit of which is
compared with the exact one anyway: with lightly damped modes, a few more orders change little
and are as far off.

Rounding errors are added: the last correction of Newton's method, which may be small by chance,
and the effect of rounded parameters and residuals.  The latter is large where two orbits nearly
meet, or near a resonance with little damping; the condition number of the exact equations
bounds it.
"""

import math
from dataclasses import fields, replace

import numpy as np

from ..arrays import Vector
from ..kernels import registry
from ..orbit.condition import moved_times
from ..orbit.errors import Errors, difference, rounding_of_derivative
from ..orbit.motion import LOOK, Motion
from ..orbit.solution import Solution, attempt
from ..scenes.methods import FIRST

#: Order of the better orbit: the orbit's plus `MORE`, at least `LEAST`; at most `MOST` if the
#: orbit is by another method, whose errors are far larger.
MORE, LEAST, MOST = 4, 20, 60

#: Least rounding error of the times, relative to the period; factor of the last correction of
#: Newton's method; least rounding error of the derivative.
ROUNDING, CORRECTIONS, DERIVATIVE_ROUNDING = 2e-15, 4.0, 1e-14

#: Largest part of the first change that the second may be: if it is more, the orders converge
#: so slowly that their changes do not bound the error.
SLOW = 0.25

#: Differences of times and of the derivative below which two solutions are the same root: one
#: is an orbit if the other is, and need not be checked again.
SAME, SAME_DERIVATIVE = 1e-6, 1e-3

#: Machine epsilon of float64.
EPSILON = float(np.finfo(float).eps)

NOTHING = Errors(math.inf, math.inf, math.inf, math.inf)


def estimate(orbit: Solution) -> Errors:
    """Return the estimated errors of an orbit, without sign; infinite if unknown."""
    if orbit.case.scene.has_body:
        return _with_rounding(orbit, orbit, _against_the_exact_orbit(orbit))
    order = max(orbit.order + MORE, LEAST)
    if orbit.method != FIRST:
        order = min(order, MOST)
    better = _neighbour(orbit, order, orbit.admissible)
    further = better and _neighbour(better[0], order + MORE, True)
    if better is None or further is None:
        return _against_the_exact_orbit(orbit)
    change, further_change = _sizes(better[1]), _sizes(further[1])
    slow = bool((further_change > SLOW * change).any())
    least = _sizes(orbit.errors if slow else None)
    bare = np.maximum(change + further_change, least)
    return _with_rounding(orbit, better[0], Errors(*bare.tolist()))


def _sizes(errors: Errors | None) -> Vector:
    """Return errors as an array without signs; zeros for none."""
    names = [q.name for q in fields(Errors)]  # a subclass has more
    sizes = (0.0 if errors is None else abs(getattr(errors, name)) for name in names)
    return np.fromiter(sizes, dtype=float)


def _with_rounding(orbit: Solution, near: Motion, bare: Errors) -> Errors:
    """Return errors plus rounding errors, whose condition is computed at an accurate orbit."""
    error, shared = CORRECTIONS * orbit.outcome.correction, EPSILON * condition(near)
    free = 0.0 if orbit.case.cell.forced else shared  # a forcing makes the period known
    angle = 2 * math.pi * shared  # times are relative to the period, this is in radians
    if orbit.case.scene.has_body:  # its condition number includes both
        place = derivative = 0.0
    else:
        place, derivative = EPSILON * cancelled(near), EPSILON * rounding_of_derivative(near)
    return Errors(
        period=bare.period + error + max(ROUNDING, free),
        times=bare.times + error + max(ROUNDING, shared),
        discontinuous=bare.discontinuous + error + max(DERIVATIVE_ROUNDING, angle, derivative),
        switches=bare.switches + error + max(ROUNDING, shared, place),
    )


def cancelled(motion: Motion) -> float:
    """Return the cancellation of forces on a mass in the displacement: parts over the whole.

    Its rounding errors are larger by this factor.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> case = registry.load("dry-friction")(force=0.3001)  # hardly more than friction
    >>> f"{cancelled(exact_orbit(case)):.0e}"
    '2e+04'
    """
    part = whole = 0.0
    for p, phase in enumerate(motion.case.cell.phases):
        if phase.held:
            continue
        force, time = (abs(phase.f) + abs(phase.g)) / phase.m, motion.cell_durations[p]
        response = min(time**2 / 2, phase.m / abs(phase.k) if phase.k else math.inf)
        part = max(part, force * response)
        whole = max(whole, float(np.abs(motion.part(p, LOOK, 0)).max()))
    return part / whole if whole else 0.0


def _against_the_exact_orbit(orbit: Solution) -> Errors:
    """Return the errors against the exact orbit, without sign; infinite without one."""
    errors = orbit.errors
    if errors is None:
        return NOTHING
    return replace(errors, period=abs(errors.period))


def _neighbour(orbit: Solution, order: int, is_orbit: bool) -> tuple[Solution, Errors] | None:
    """Return an orbit of higher order from the times of an orbit, and their difference.

    It is by the method `FIRST` or, if that does not converge, by its functions of class C^1.
    A solution that is the same root as an orbit is one; any other must be admissible.
    """
    once = registry.class_one(orbit.case.scene, FIRST)
    for method in (FIRST, once) if orbit.method != once else (once,):
        if method is None:
            continue
        kernel = registry.quicker_kernel(orbit.case.scene, method, None, order)
        neighbour = attempt(kernel, orbit.case, order, orbit.times)
        if not neighbour.converged:
            continue
        change = difference(orbit, neighbour, max(order, orbit.order))
        if (is_orbit and _same(change)) or neighbour.admissible:
            return neighbour, change
    return None


def _same(change: Errors) -> bool:
    """Return whether the difference of two solutions is so small that they are one root."""
    return change.times <= SAME and change.discontinuous <= SAME_DERIVATIVE


def condition(motion: Motion) -> float:
    """Return Skeel's condition number of the exact equations, near one of their solutions.

    The largest over all times, relative to the period: relative rounding errors e of each term
    move no time by more than e times this; see `moved_times`.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> round(condition(exact_orbit(registry.load("impact")())), 1)
    5.3
    """
    cell, moved = motion.case.cell, moved_times(motion)
    if cell.forced:
        moved[-1] /= cell.omega
    return float(moved.max() / np.sum(motion.cell_durations)) / cell.cells
