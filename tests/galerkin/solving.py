"""Newton's method on coefficients and times, as small as it can be: for tests alone."""

import numpy as np

#: Of differences of order 8, and of those of order 2, for what takes long.
WEIGHTS, OF_TWO = (4 / 5, -1 / 5, 4 / 105, -1 / 280), (1 / 2,)


def times_of(kernel, z):
    """Return the durations and, where something forces, the phase of the forcing."""
    return z[len(z) - kernel.DURATIONS - kernel.FORCED :]


def residual(kernel, case, z):
    R = np.full(len(z), np.nan)
    kernel.residual(case, z, R)
    return R


def jacobian(kernel, case, z):
    J = np.full((len(z), len(z)), np.nan)
    kernel.jacobian(case, z, J)
    return J


def differences(function, at, step, weights=WEIGHTS):
    """Return the derivatives of an array by each entry of another, by differences."""
    found = []
    for change in step * np.eye(len(at)):
        sides = (
            w * (function(at + j * change) - function(at - j * change))
            for j, w in enumerate(weights, start=1)
        )
        found.append(sum(sides) / step)
    return found


def with_coefficients(kernel, case, order, times):
    """Return unknowns with these times and the coefficients that fit them best.

    The rows are scaled; those of the times alone, without coefficients, are left out.
    """
    z = np.zeros(kernel.size(order))
    z[len(z) - len(times) :] = times
    J, R = jacobian(kernel, case, z)[:, : len(z) - len(times)], residual(kernel, case, z)
    scale = np.abs(J).max(axis=1)
    kept = scale > 0
    rows, right = J[kept] / scale[kept, None], -R[kept] / scale[kept]
    z[: len(z) - len(times)] = np.linalg.lstsq(rows, right)[0]
    return z


def solve(kernel, case, order, times, steps=12):
    """Return the unknowns that solve the system, from rough times."""
    z = with_coefficients(kernel, case, order, np.asarray(times))
    for _ in range(steps):
        J = jacobian(kernel, case, z)
        scale = np.abs(J).max(axis=1, keepdims=True)
        change = np.linalg.solve(J / scale, -residual(kernel, case, z) / scale[:, 0])
        z = z + change
        if np.abs(times_of(kernel, change)).max() < 1e-14:
            break
    return z
