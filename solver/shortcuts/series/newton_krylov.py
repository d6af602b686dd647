"""Newton's method with GMRES for equations without a matrix; see `matrix_free`."""

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Vector
from ..search.newton import (
    CONVERGED,
    ITERATION_LIMIT,
    NO_DESCENT,
    OVERFLOW,
    REASONS,
    ROUNDOFF,
    SETTLED,
    SMALLEST_STEP,
    TOO_MANY,
    Outcome,
)
from .matrix_free import Linearised, Problem

#: GMRES: part of the residual that is left, and steps.
INNER_TOLERANCE, INNER_STEPS = 1e-8, 60


def solve(problem: Problem, start: Vector, limit: int = ITERATION_LIMIT) -> Outcome:
    """Solve the equations from `start`, by the rules of `newton.iterate`."""
    z = start.copy()
    driver = problem.kernel.functions  # compiled: those of `newton` are slow for many
    largest, longest_step = driver["largest"], driver["longest_step"]
    time_norm, step_norm = driver["time_norm"], driver["step_norm"]
    here = problem.at(z)
    damping, previous, correction = 1.0, np.inf, np.inf

    def end(status: int, iterations: int) -> Outcome:
        norm = largest(here.residual)
        done = status == CONVERGED
        return Outcome(z, done, iterations, float(correction), norm, REASONS[status])

    for iteration in range(1, limit + 1):
        step = -_krylov(here, len(z))
        length, correction = step_norm(step, z), time_norm(step, z)
        if not np.isfinite(length):
            return end(OVERFLOW, iteration)
        at_rest = correction <= ROUNDOFF or correction > 0.5 * previous
        if length <= SETTLED and at_rest:
            z = z + step
            return end(CONVERGED, iteration)
        previous = correction
        damping = min(1.0, 2.0 * damping, longest_step(step, z))
        while True:
            trial = z + damping * step
            there = problem.at(trial)
            simplified = here.precondition(there.residual)
            if length <= SETTLED and time_norm(simplified, z) <= ROUNDOFF:
                z, here = trial, there
                return end(CONVERGED, iteration)
            if length <= SETTLED or step_norm(simplified, z) <= (1 - damping / 4) * length:
                break
            damping /= 2
            if damping < SMALLEST_STEP:
                return end(NO_DESCENT, iteration)
        z, here = trial, there
    return end(TOO_MANY, limit)


def _krylov(here: Linearised, n: int) -> Vector:
    """Return the inverse of the Jacobian times the residual."""
    A = scipy.sparse.linalg.LinearOperator((n, n), matvec=here.product, dtype=float)
    P = scipy.sparse.linalg.LinearOperator((n, n), matvec=here.precondition, dtype=float)
    first = here.precondition(here.residual)
    found, _ = scipy.sparse.linalg.gmres(
        A, here.residual, x0=first, rtol=INNER_TOLERANCE, atol=0.0, M=P,
        restart=INNER_STEPS, maxiter=1,
    )  # fmt: skip
    return np.asarray(found)
