"""What one would otherwise write, or install: harmonic balance, and shooting by RK4."""

import logging
import warnings
from collections.abc import Callable
from importlib.util import find_spec

import numba
import numpy as np
from scipy.linalg import eigh, toeplitz
from scipy.sparse import csr_array

from .problem import FORCE, GAP, OF_MASS, OF_STIFFNESS, OMEGA, STOP, Row

#: Samples of a period for each harmonic.
SAMPLES = 16

#: From how much larger an orbit harmonic balance starts.
LARGER = 1.1

#: Steps of Newton's method, and the change at which it ends.
MOST, SETTLED = 40, 1e-13


def _compliances(row: Row, harmonics: int) -> np.ndarray:
    """Return what the end answers to a force at the end, at 0 to `harmonics` times Omega."""
    squares, modes = eigh(row.matrices[2], row.matrices[0])
    turn = 1j * OMEGA * np.arange(harmonics + 1)[:, None]
    return (
        modes[-1] ** 2 / (squares + turn * (OF_MASS + OF_STIFFNESS * squares) + turn**2)
    ).sum(1)


def _first(row: Row, harmonics: int) -> np.ndarray:
    """Return the Fourier coefficients of the end on the exact orbit, made larger."""
    t = np.arange(64 * harmonics) / (64 * harmonics) * row.period
    orbit = row.orbit
    x = orbit.displacement((t - row.times[2] / OMEGA) % row.period)
    return LARGER * np.fft.rfft(x)[: harmonics + 1] / len(t)


def switches(X: np.ndarray) -> np.ndarray:
    """Return the times at which a Fourier series crosses the gap."""
    h = np.arange(len(X))

    def value(t: np.ndarray, derivative: int) -> np.ndarray:
        factors = X * np.where(h, 2, 1) * (1j * OMEGA * h) ** derivative
        return (np.exp(1j * OMEGA * np.outer(t, h)) @ factors).real

    period = 2 * np.pi / OMEGA
    t = np.linspace(0, period, SAMPLES * len(X), endpoint=False)
    inside = value(t, 0) > GAP
    found = []
    for begins in (True, False):
        change = np.flatnonzero((np.roll(inside, -1) != inside) & (inside != begins))
        if len(change) != 1:
            return np.full(3, np.nan)
        at = t[change] + t[1] / 2
        for _ in range(8):
            at = at - (value(at, 0) - GAP) / value(at, 1)
        found.append(float(at[0]))
    touch = (found[1] - found[0]) % period
    return np.array([touch, period - touch, OMEGA * found[0]])


def aft(row: Row) -> Callable[[int], np.ndarray]:
    """Return harmonic balance condensed to the contact: FFT, Newton, analytical Jacobian."""

    def solve(harmonics: int) -> np.ndarray:
        H, S = harmonics, SAMPLES * harmonics
        answer = _compliances(row, 2 * H)[: H + 1]
        X, forced = starts[H].copy(), np.zeros(H + 1, dtype=complex)
        forced[1] = answer[1] * FORCE / 2
        both = np.concatenate([answer[:0:-1].conj(), answer])
        for _ in range(MOST):
            x = np.fft.irfft(X, S) * S
            pressed = x > GAP
            force = np.fft.rfft(-STOP * (x - GAP) * pressed)[: H + 1] / S
            R = X - forced - answer * force
            c = np.fft.rfft(pressed)[: 2 * H + 1] * STOP / S
            J = np.eye(2 * H + 1) + both[:, None] * toeplitz(c, c.conj())
            step = np.linalg.solve(J, np.concatenate([R[:0:-1].conj(), R]))[H:]
            X = X - step
            if np.abs(step).max() <= SETTLED:
                return X
        return np.full(H + 1, np.nan)

    starts = {H: _first(row, H) for H in HARMONICS}
    return solve


#: Harmonics of the condensed method; of pyHarm, whose matrices are full, unknowns at most.
HARMONICS, UNKNOWNS = (5, 10, 20, 50, 100, 200, 400), 1500


def pyharm(row: Row) -> Callable[[int], np.ndarray] | None:
    """Return pyHarm's Newton method at one frequency, from its own linear start; or None."""
    if find_spec("pyHarm") is None:
        return None
    logging.disable(logging.INFO)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        from pyHarm.Maestro import Maestro

    def solve(harmonics: int) -> np.ndarray:
        M, C, K = row.matrices
        at = {"connect": {"row": [row.n - 1]}, "dirs": [0]}
        options = {"tol_residual": 1e-11, "tol_delta_x": 1e-11, "max_iter": MOST}
        study = {
            "study": "frf", "solver": "NewtonRaphson", "solver_options": options,
            "puls_inf": OMEGA, "puls_sup": OMEGA, "verbose": False,
        }  # fmt: skip
        made = Maestro(
            {
                "system": {"type": "Base", "nh": harmonics, "nti": SAMPLES * harmonics},
                "substructures": {"row": {"matrix": {"M": M, "C": C, "K": K}, "ndofs": 1}},
                "connectors": {
                    "gap": {"type": "PenaltyUnilateralGap", "g": GAP, "k": STOP, **at},
                    "force": {"type": "CosinusForcing", "amp": FORCE, **at},
                },
                "analysis": {"frf": study},
            }
        )
        made.nls["frf"].initialise()
        found = made.nls["frf"].SolList[0]
        if not found.flag_accepted:
            return np.full(harmonics + 1, np.nan)
        x = found.x[:-1].reshape(-1, row.n)[:, -1]
        return np.concatenate([x[:1], (x[1::2] - 1j * x[2::2]) / 2]).astype(complex)

    return solve


@numba.njit
def _rates(
    starts: np.ndarray, columns: np.ndarray, values: np.ndarray, X: np.ndarray
) -> np.ndarray:
    """Return ``A X`` of a matrix in compressed rows."""
    found = np.zeros_like(X)
    for i in range(len(X)):
        for at in range(starts[i], starts[i + 1]):
            value, j = values[at], columns[at]
            for k in range(X.shape[1]):
                found[i, k] += value * X[j, k]
    return found


@numba.njit
def _flow(
    starts: np.ndarray, columns: np.ndarray, values: np.ndarray, s: float, steps: int
) -> np.ndarray:
    """Return the flow of ``X' = A X`` over s by classical RK4 from the unit states."""
    X, h = np.eye(len(starts) - 1), s / steps
    for _ in range(steps):
        a = _rates(starts, columns, values, X)
        b = _rates(starts, columns, values, X + h / 2 * a)
        c = _rates(starts, columns, values, X + h / 2 * b)
        d = _rates(starts, columns, values, X + h * c)
        X = X + h / 6 * (a + 2 * b + 2 * c + d)
    return X


def shooting(row: Row) -> Callable[[int], np.ndarray]:
    """Return shooting with located switches: RK4 in each phase, Newton on two times."""
    n, period = row.n, row.period
    rows = [csr_array(row.generator(pressed)) for pressed in (True, False)]
    pressed, released = ((q.indptr, q.indices, q.data) for q in rows)

    @np.errstate(all="ignore")  # with too few steps it is unstable
    def off(z: np.ndarray, steps: int) -> np.ndarray:
        first = _flow(*pressed, z[0], steps // 4)
        whole = _flow(*released, period - z[0], steps) @ first
        waves = np.array([np.cos(z[1]), np.sin(z[1]), 1.0])
        own = slice(0, 2 * n)
        state = np.linalg.solve(np.eye(2 * n) - whole[own, own], whole[own, -3:] @ waves)
        return np.array([state[n - 1], first[n - 1] @ np.append(state, waves)]) - GAP

    def solve(steps: int) -> np.ndarray:
        z = row.rough[[0, 2]]
        R, J = off(z, steps), np.empty((2, 2))
        for i, q in enumerate(1e-6 * np.eye(2)):
            J[:, i] = (off(z + q, steps) - R) / 1e-6
        for _ in range(MOST):  # Broyden's method
            step = -np.linalg.solve(J, R)
            z = z + step
            if np.abs(step).max() <= SETTLED:
                break
            R = off(z, steps)
            J += np.outer(R, step) / (step @ step)
        return np.array([z[0], period - z[0], z[1]])

    return solve
