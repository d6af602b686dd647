"""The poles of a phase of a body as functions of time, from a state on.

Sums keep their order and powers are products: plain Python and numba then give the same bits.
"""

from typing import NamedTuple

import numpy as np

from ...arrays import Complex, Vector
from ...bodies.flow import CLEAR
from ...flow.divided import exp, of_three, of_two
from .phases import Poles


class Modes(NamedTuple):
    """The poles of a phase from a state on.

    Parameters
    ----------
    omega : float
    free : int
        The number of rigid-body modes.
    poles, start : ndarray of complex, shape (m,)
        The poles, and their initial values.
    drives, answers : ndarray of complex, shape (3, m)
        Factors of ``e^(i Omega t), e^(-i Omega t), 1`` that drive each pole, and its steady
        answers to these.
    least : ndarray, shape (m,)
        The distance of each pole from the nearest frequency that drives it.
    """

    omega: float
    free: int
    poles: Complex
    start: Complex
    drives: Complex
    answers: Complex
    least: Vector


def value_of(row: Vector, Y: Vector) -> float:
    """Return the value of a form, summed in order."""
    total = 0.0
    for i in range(len(row)):
        total += float(row[i]) * float(Y[i])
    return total


def size_of(row: Vector, Y: Vector) -> float:
    """Return the sum of the moduli of the terms of a form."""
    total = 0.0
    for i in range(len(row)):
        total += abs(float(row[i]) * float(Y[i]))
    return total


def rounding_of(row: Vector, Y: Vector, n: int) -> float:
    """Return the rounding error of a form of a state of n coordinates, in units of eps.

    Those of cosine and sine come from the angle of the forcing, also where they are near 0.
    """
    total = 0.0
    for i in range(len(row)):
        total += abs(float(row[i]) * (1.0 if n <= i < n + 2 else float(Y[i])))
    return total


def power_of(number: float, order: int) -> float:
    """Return a power by products."""
    power = 1.0
    for _ in range(order):
        power *= number
    return power


def modes_of(poles: Poles, omega: float, p: int, Y: Vector) -> Modes:
    """Return the poles of a phase from a state on."""
    count, n = int(poles.counts[p]), poles.bases.shape[1]
    forcing = complex(float(Y[n]), float(Y[n + 1])) / 2
    start, drives = np.zeros(count, np.complex128), np.zeros((3, count), np.complex128)
    answers = np.zeros((3, count), np.complex128)
    for i in range(count):
        inputs, total, constant = poles.inputs[p, i], 0j, 0j
        for j in range(n):
            total += complex(poles.inverses[p, i, j]) * float(Y[j])
        for j in range(2, len(inputs)):
            constant += complex(inputs[j]) * float(Y[n + j])
        cosine, sine = complex(inputs[0]), complex(inputs[1])
        start[i] = total
        drives[0, i] = (cosine - 1j * sine) * forcing
        drives[1, i] = (cosine + 1j * sine) * forcing.conjugate()
        drives[2, i] = constant
        for k in range(3):
            answers[k, i] = complex(drives[k, i]) / complex(poles.apart[p, k, i])
    values, least = poles.values[p, :count], poles.least[p, :count]
    return Modes(omega, int(poles.free[p]), values, start, drives, answers, least)


def wave_at(modes: Modes, t: float) -> complex:
    """Return ``e^(i Omega t)``."""
    return exp(1j * modes.omega * t)


def put_poles(modes: Modes, t: float, wave: complex, apart: Vector, values: Complex) -> None:
    """Fill in the values of the poles at a time, where `wave_at` is `wave`; shape (m,).

    For a pole near its drive not by the steady answer, which would lose digits.

    apart : ndarray, shape (m,)
        `Modes.least`, or infinity where the digits of a small change do not matter.
    """
    turning = 1j * modes.omega
    for i in range(len(values)):
        s, start = complex(modes.poles[i]), complex(modes.start[i])
        if float(apart[i]) * t >= CLEAR:
            up, down = complex(modes.answers[0, i]), complex(modes.answers[1, i])
            constant = complex(modes.answers[2, i])
            z = (start - up - down - constant) * exp(s * t)
            values[i] = z + (up * wave + down * wave.conjugate() + constant)
            continue
        z = start * exp(s * t)
        for k in range(3):
            q = turning if k == 0 else (-turning if k == 1 else 0j)
            z += complex(modes.drives[k, i]) * of_two(s, q, t)
            if i < modes.free:  # a place, which a velocity moves
                z += complex(modes.drives[k, modes.free + i]) * of_three(0j, 0j, q, t)
        if i < modes.free:
            z += complex(modes.start[modes.free + i]) * t
        values[i] = z


def state_at(poles: Poles, omega: float, p: int, Y: Vector, t: float) -> Vector:
    """Return y at a time t after the state Y in which a phase begins."""
    modes, y = modes_of(poles, omega, p, Y), np.zeros(poles.bases.shape[1])
    z = np.zeros(len(modes.poles), np.complex128)
    put_poles(modes, t, wave_at(modes, t), modes.least, z)
    for j in range(len(y)):
        y[j] = real_of(poles.bases[p, j], z)
    return y


def size_by_poles(poles: Poles, omega: float, p: int, row: Vector, Y: Vector) -> float:
    """Return the sum of the moduli of the terms of a form in the eigenbasis of a phase.

    Where eigenvectors are nearly parallel, it exceeds that of y, and limits the accuracy.
    """
    start, n = modes_of(poles, omega, p, Y).start, poles.bases.shape[1]
    total = size_of(row[n:], Y[n:])
    for i in range(len(start)):
        factor = 0j
        for j in range(n):
            factor += float(row[j]) * complex(poles.bases[p, j, i])
        total += abs(factor) * abs(start[i])
    return total


def real_of(factors: Complex, z: Complex) -> float:
    """Return ``Re sum factors z``."""
    total = 0.0
    for i in range(len(z)):
        factor, value = complex(factors[i]), complex(z[i])
        total += factor.real * value.real - factor.imag * value.imag
    return total
