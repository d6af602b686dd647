"""Masses that are moved on by matrix exponentials: the state is q, q', cos, sin, 1."""

import numpy as np


def generator(M, K, C, forcing, omega: float, constant=0.0) -> np.ndarray:
    """Return A of ``X' = A X``, from matrices and what pulls by the cosine and always."""
    n, forcing = len(K), np.asarray(forcing)
    pulls = [forcing, 0 * forcing, constant + 0 * forcing]
    A = np.zeros((2 * n + 3, 2 * n + 3))
    A[:n, n : 2 * n] = np.eye(n)
    A[n : 2 * n] = np.linalg.solve(M, np.column_stack([-K, -C, *pulls]))
    A[-3, -2], A[-2, -3] = -omega, omega
    return A


def repeating(period: np.ndarray, angle: float) -> np.ndarray:
    """Return the state at an angle of the forcing that is there again a period later."""
    waves, own = np.array([np.cos(angle), np.sin(angle), 1.0]), slice(0, -3)
    closed = np.eye(len(period) - 3) - period[own, own]
    return np.concatenate([np.linalg.solve(closed, period[own, -3:] @ waves), waves])
