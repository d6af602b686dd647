"""The error of an orbit, estimated without the exact one: by the change to a better orbit.

The better orbit is that of the method whose times converge fastest, from the orbit's own times,
at an order where it has nearly always converged.  What it may be off by itself, the change to a
few orders more, is added.  Only where no better orbit is found, it is the error against the
exact one.  So it is of a body, whose every orbit is judged by that anyway: where modes hardly
damped ring on in a contact, a few orders more change little, and are as far off.

Rounding is added as well: what Newton's method left, and what all orders share.  Parameters and
residuals are rounded, and where two orbits nearly meet, or little damps a resonance, the orbit
answers to that by far more: the condition number of the exact equations says by how much.  The
last correction of Newton's method alone does not: it may be small by chance.
"""

import math
from dataclasses import replace

import numpy as np

from ..kernels import registry
from ..orbit.condition import moved_times
from ..orbit.errors import Errors, difference
from ..orbit.motion import LOOK, Motion
from ..orbit.solution import Solution, attempt
from ..scenes.methods import FIRST

#: The order of the better orbit: so many more than the orbit's, and no less than that; nor more
#: than that, where the orbit is of a method whose errors are far larger at any order.
MORE, LEAST, MOST = 4, 20, 60

#: Least rounding of the times, as a part of the period, beside the last corrections of Newton's
#: method; and of the derivative.
ROUNDING, CORRECTIONS, DERIVATIVE_ROUNDING = 2e-15, 4.0, 1e-14

#: Differences of times and of the derivative below which two solutions are the same root: one
#: is an orbit if the other is, and is not followed through its critical points again.
SAME, SAME_DERIVATIVE = 1e-6, 1e-3

#: What one rounding is, as a part of a number.
EPSILON = float(np.finfo(float).eps)

NOTHING = Errors(math.inf, math.inf, math.inf, math.inf)


def estimate(orbit: Solution) -> Errors:
    """Return the estimated errors of an orbit, without sign; infinite where none is known."""
    if orbit.case.scene.has_body:
        return _with_rounding(orbit, orbit, _against_the_exact_orbit(orbit))
    if FIRST not in registry.methods(orbit.case.scene):
        return _against_the_exact_orbit(orbit)
    order = max(orbit.order + MORE, LEAST)
    if orbit.method != FIRST:
        order = min(order, MOST)
    better = _neighbour(orbit, order, orbit.admissible)
    beyond = better and _neighbour(better[0], order + MORE, True)
    if better is None or beyond is None:
        return _against_the_exact_orbit(orbit)
    pairs = zip(*(vars(q).values() for q in (better[1], beyond[1])), strict=True)
    return _with_rounding(orbit, better[0], Errors(*(abs(a) + abs(b) for a, b in pairs)))


def _with_rounding(orbit: Solution, near: Motion, found: Errors) -> Errors:
    """Return errors with what rounding adds to them, by an orbit near to the exact one."""
    left, shared = CORRECTIONS * orbit.outcome.correction, EPSILON * condition(near)
    free = 0.0 if orbit.case.cell.forced else shared  # a forcing makes the period known
    turned = 2 * math.pi * shared  # times are parts of a period, and this of a radian
    there, derivative = (EPSILON * part for part in cancelled(near))
    return Errors(
        period=found.period + left + max(ROUNDING, free),
        times=found.times + left + max(ROUNDING, shared),
        discontinuous=found.discontinuous + left + max(DERIVATIVE_ROUNDING, turned, derivative),
        switches=found.switches + left + max(ROUNDING, shared, there),
    )


def cancelled(motion: Motion) -> tuple[float, float]:
    """Return how much larger the forces on a mass are than what they come to.

    That is rounded by their parts: the displacement over a phase, and the acceleration.  What
    forces a structure is made of is in its condition number alone.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> case = registry.load("dry-friction")(force=0.3001)  # hardly more than friction
    >>> [f"{part:.0e}" for part in cancelled(exact_orbit(case))]
    ['2e+04', '2e+03']
    """
    if motion.case.scene.has_body:
        return 0.0, 0.0
    parts, whole = np.zeros(2), np.zeros(2)
    for p, phase in enumerate(motion.case.cell.phases):
        if phase.held:
            continue
        force, time = (abs(phase.f) + abs(phase.g)) / phase.m, motion.cell_durations[p]
        answer = min(time**2 / 2, phase.m / abs(phase.k) if phase.k else math.inf)
        sizes = [float(np.abs(motion.part(p, LOOK, order)).max()) for order in (0, 2)]
        parts, whole = np.maximum(parts, (force * answer, force)), np.maximum(whole, sizes)
    there, force = (float(a / b) if b else 0.0 for a, b in zip(parts, whole, strict=True))
    return there, force


def _against_the_exact_orbit(orbit: Solution) -> Errors:
    """Return the errors themselves, where no better orbit says what they are."""
    found = orbit.errors
    if found is None:
        return NOTHING
    return replace(found, period=abs(found.period))


def _neighbour(orbit: Solution, order: int, is_orbit: bool) -> tuple[Solution, Errors] | None:
    """Return the orbit of the better method to which the times of an orbit lead, and how far.

    Where the conditions of that method are singular, by its functions of class C^1.  What is
    next to an orbit is one; anything else has to be admissible.
    """
    once = registry.class_one(orbit.case.scene, FIRST)
    for method in (FIRST, once) if orbit.method != once else (once,):
        if method is None:
            continue
        kernel = registry.quicker_kernel(orbit.case.scene, method, None, order)
        found = attempt(kernel, orbit.case, order, kernel.times(orbit.unknowns))
        if not found.converged:
            continue
        change = difference(orbit, found, max(order, orbit.order))
        if (is_orbit and _same(change)) or found.admissible:
            return found, change
    return None


def _same(change: Errors) -> bool:
    """Whether two solutions are so near to each other that either is an orbit if one is."""
    return change.times <= SAME and change.discontinuous <= SAME_DERIVATIVE


def condition(motion: Motion) -> float:
    """Return Skeel's condition number of the exact equations, near one of their solutions.

    That of the time that answers most, as a part of the period: if each term is rounded by a
    part e, no time moves by more than e times this; see `moved_times`.

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
