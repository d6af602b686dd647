"""Sections 3.1 and 3.2 with very many harmonics: Newton-Krylov, matrix-free.

The equations are those of the generated kernel about mid-stick, and so are their closed
forms; but the slip part of (6) is applied by sine transforms instead of a matrix.  With
each row divided by its ``D_j`` the Jacobian is the identity, a compact part that lives in
the lowest harmonics, and a border for ``c_1``, ``t1``, ``T``: factorising the lowest and
the border, and taking the rest for the identity, leaves GMRES a few steps at any ``N``.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import scipy  # its parts are loaded where they are used

from ...arrays import Matrix, Vector
from ..search.kernels import Kernel
from .left_out import left_out
from .sine_products import from_grid, grid_size, on_grid, symbol

#: Harmonics whose coupling the preconditioner has: at least, at most, and by the highest
#: frequency in slip, 1, as a multiple of the fundamental one.
LOWEST, HIGHEST, PER_FREQUENCY = 64, 1000, 8


@dataclass(frozen=True)
class Linearised:
    """Residual and Jacobian at one iterate.

    Rows: (6) for each harmonic over ``D_j``, (14) over its largest coefficient, (9), (10).

    Parameters
    ----------
    residual : ndarray, shape (n,)
    product : callable
        ``product(step)``: the Jacobian times a step.
    precondition : callable
        ``precondition(r)``: the step that would remove ``r``, but for the coupling of the
        high harmonics.
    """

    residual: Vector
    product: Callable[[Vector], Vector]
    precondition: Callable[[Vector], Vector]


@dataclass(frozen=True)
class Problem:
    """One oscillator and one expansion, `terms` 0 or 1 C1 functions."""

    kernel: Kernel
    alpha: float
    terms: int
    N: int

    def at(self, z: Vector) -> Linearised:
        """Return the equations at the iterate `z`."""
        N, K, functions = self.N, self.terms, self.kernel.functions
        b, c, (t1, T) = z[:N], z[N:-2], z[-2:]
        points = grid_size(N)
        cosines, sines = functions["stick_waves"](N, t1, T)
        C = functions["slip_cosines"](N, t1, T, sines)[2 * N :]
        slip = symbol(C, points)
        D, D_T = functions["period_terms"](N, T)[:, 1:]
        M = functions["slip_moments"](2 * K, N, t1, T)
        gamma = functions["harmonics"](K, N, T, M)
        end, end_rate = functions["at_end_of_stick"](K, N, gamma, cosines, sines, t1, T)
        n, phi = np.arange(1, N + 1), functions["half_stick_angle"](T, t1)
        cosines, sines = cosines[1 : N + 1], sines[1 : N + 1]
        weight, weight_T = functions["velocity_weight"](T, n)

        # The slip part of (6): of the series beside g_1 itself, and of g_1.
        whole = b - c @ gamma[0]
        forces = np.empty((3, N))
        forces[0] = from_grid(slip * on_grid(whole, points), N)
        at_end = whole @ sines
        forces[1:] = functions["slip_part_by_times"](forces[0], at_end, sines, t1, T)
        h = np.zeros((K, N))
        if K:
            H = functions["through_harmonics"](K, N, t1, T, M)
            held = np.stack([D * gamma[0], D * gamma[1], D * gamma[2] + D_T * gamma[0]])
            h, beside = self._tails(c, H - held, gamma, slip)
            forces += beside
        response = -forces[0] / D
        sums = left_out(functions, N, t1, T) if K else None
        if sums is not None:
            h[0, : len(sums.by_sine)] = sums.by_sine

        start, velocity = functions["initial_state"](self.alpha)
        R = np.empty(N + K + 2)
        R[:N] = b - response
        R[-2] = start + response @ sines + c @ end[0]
        R[-1] = -velocity + response @ (weight * cosines) + c @ end_rate[0]
        if sums is not None:
            R[N] = (h[0] @ b) / sums.by_tail + c[0]

        # Columns of c, t1, T in the rows of (6), and the corner.
        columns = np.vstack([h, forces[1], forces[2]]) / D
        columns[-1] += response * D_T / D
        corner = np.zeros((K + 2, K + 2))
        if K:
            corner[:, 0] = 1.0, end[0, 0], end_rate[0, 0]
        # Responses held, (9) and (10) depend on t1 and T through phi, the tail and omega_0.
        by_phi = response @ (n * cosines), -response @ (weight * n * sines)
        corner[-2:, -2:] = np.outer(by_phi, (math.pi / T, -phi / T))
        corner[-2:, -2:] += np.vstack([end[1:] @ c, end_rate[1:] @ c])
        corner[-1, -1] += response @ (weight_T * cosines)
        ends = np.vstack([sines, weight * cosines])
        by_sine = h / sums.by_tail if sums is not None else h
        border = Border(columns, ends, by_sine, corner)

        def product(step: Vector) -> Vector:
            force = from_grid(slip * on_grid(step[:N], points), N)
            return border.product(step, force / D)

        return Linearised(R, product, self._preconditioner(C, D, border))

    def _tails(
        self, c: Vector, through: Vector, gamma: Vector, slip: Vector
    ) -> tuple[Matrix, Matrix]:
        """Return the coefficients of ``c`` in (6), and what ``g_1`` adds to the forces.

        through : ndarray, shape (3, K, N)
            ``g_1`` without what its harmonics have on the diagonal.
        """

        def in_slip(harmonics: Vector) -> Vector:
            return from_grid(slip * on_grid(harmonics, len(slip)), self.N)

        beside = c @ through
        beside[1] -= in_slip(c @ gamma[1])
        beside[2] -= in_slip(c @ gamma[2])
        return through[0] - in_slip(gamma[0, 0]), beside

    def _preconditioner(
        self, C: Vector, D: Vector, border: "Border"
    ) -> Callable[[Vector], Vector]:
        m = min(self.N, max(LOWEST, min(HIGHEST, int(PER_FREQUENCY * math.sqrt(-D[0] * C[0])))))
        j = np.arange(1, m + 1)
        entry = self.kernel.functions["sine_by_sine"]
        coupling = entry(C[np.abs(j[:, None] - j)], C[j[:, None] + j]) / D[:m, None]
        low = border.low(coupling)
        factors = scipy.linalg.lu_factor(low)

        def precondition(r: Vector) -> Vector:
            right = np.concatenate([r[:m], r[self.N :]])
            right[m : len(right) - 2] -= border.by_sine[:, m:] @ r[m : self.N]
            solved = scipy.linalg.lu_solve(factors, right)
            step = r.copy()
            step[:m], step[self.N :] = solved[:m], solved[m:]
            step[m : self.N] -= solved[m:] @ border.columns[:, m:]
            return step

        return precondition


@dataclass(frozen=True)
class Border:
    """Rows and columns of the Jacobian for ``c_1``, ``t1``, ``T``.

    Parameters
    ----------
    columns : ndarray, shape (K + 2, N)
        Of ``c_1``, ``t1``, ``T`` in the rows of (6).
    ends : ndarray, shape (2, N)
        Rows of (9) and (10): weights of the responses.
    by_sine : ndarray, shape (K, N)
        Row of (14); its derivatives by ``t1`` and ``T`` are left out.
    corner : ndarray, shape (K + 2, K + 2)
        Rows (14), (9), (10) by ``c_1``, ``t1``, ``T``, responses held.
    """

    columns: Matrix
    ends: Matrix
    by_sine: Matrix
    corner: Matrix

    def product(self, step: Vector, force: Vector) -> Vector:
        """Return the Jacobian times `step`; `force`: the slip part of (6) over ``D_j``."""
        N, K = self.columns.shape[1], len(self.by_sine)
        through = force + step[N:] @ self.columns
        last = self.corner @ step[N:]
        last[:K] += self.by_sine @ step[:N]
        last[K:] -= self.ends @ through
        return np.concatenate([step[:N] + through, last])

    def low(self, coupling: Matrix) -> Matrix:
        """Return the Jacobian of the lowest harmonics, the others eliminated uncoupled.

        coupling : ndarray, shape (m, m)
            The slip part of (6) over ``D_j`` among the lowest.
        """
        m, K = len(coupling), len(self.by_sine)
        result = np.empty((m + K + 2, m + K + 2))
        result[:m, :m] = np.eye(m) + coupling
        result[:m, m:] = self.columns[:, :m].T
        result[m : m + K, :m] = self.by_sine[:, :m]
        result[m + K :, :m] = -self.ends[:, :m] @ coupling
        result[m:, m:] = self.corner
        result[m : m + K, m:] -= self.by_sine[:, m:] @ self.columns[:, m:].T
        result[m + K :, m:] -= self.ends @ self.columns.T
        return result
