"""The poles of a phase of a body from a state on, and what is made of numbers by them.

Sums are in their order and powers are products, so that functions give the same bits as plain
Python and compiled by numba.
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
        In how many ways nothing holds the body.
    poles, start : ndarray of complex, shape (m,)
        Each pole, and what there is of it at first.
    drives, answers : ndarray of complex, shape (3, m)
        What drives each, by ``e^(i Omega t), e^(-i Omega t), 1``, and its steady answers.
    least : ndarray, shape (m,)
        How far each is from what drives it.
    """

    omega: float
    free: int
    poles: Complex
    start: Complex
    drives: Complex
    answers: Complex
    least: Vector


def value_of(row: Vector, Y: Vector) -> float:
    """Return a form of a state: as a sum in its order, compiled or not."""
    total = 0.0
    for i in range(len(row)):
        total += float(row[i]) * float(Y[i])
    return total


def size_of(row: Vector, Y: Vector) -> float:
    """Return what a form of a state is the sum of, added without sign."""
    total = 0.0
    for i in range(len(row)):
        total += abs(float(row[i]) * float(Y[i]))
    return total


def rounded(Y: Vector, n: int) -> Vector:
    """Return what the entries of a state of n coordinates are rounded by, over rounding.

    Cosine and sine are by the angle of the forcing, also where they are near 0.
    """
    found = np.zeros(len(Y))
    for i in range(len(Y)):
        found[i] = 1.0 if n <= i < n + 2 else Y[i]
    return found


def power_of(number: float, order: int) -> float:
    """Return a power as products: compiled or not, they are rounded in the same way."""
    found = 1.0
    for _ in range(order):
        found *= number
    return found


def modes_of(poles: Poles, omega: float, p: int, Y: Vector) -> Modes:
    """Return the poles of a phase from a state on."""
    count, n = int(poles.counts[p]), poles.bases.shape[1]
    turn = complex(float(Y[n]), float(Y[n + 1])) / 2
    start, drives = np.zeros(count, np.complex128), np.zeros((3, count), np.complex128)
    answers = np.zeros((3, count), np.complex128)
    for i in range(count):
        inputs, total, rest = poles.inputs[p, i], 0j, 0j
        for j in range(n):
            total += complex(poles.inverses[p, i, j]) * float(Y[j])
        for j in range(2, len(inputs)):
            rest += complex(inputs[j]) * float(Y[n + j])
        cosine, sine = complex(inputs[0]), complex(inputs[1])
        start[i] = total
        drives[0, i] = (cosine - 1j * sine) * turn
        drives[1, i] = (cosine + 1j * sine) * turn.conjugate()
        drives[2, i] = rest
        for k in range(3):
            answers[k, i] = complex(drives[k, i]) / complex(poles.apart[p, k, i])
    own, least = poles.values[p, :count], poles.least[p, :count]
    return Modes(omega, int(poles.free[p]), own, start, drives, answers, least)


def poles_at(modes: Modes, t: float) -> Complex:
    """Return the poles at a time from the beginning; shape (m,).

    Of one that is near to its drive for so long the steady answer has no digits.
    """
    found = np.zeros(len(modes.poles), np.complex128)
    turning = 1j * modes.omega
    wave = exp(turning * t)
    for i in range(len(found)):
        s, start = complex(modes.poles[i]), complex(modes.start[i])
        if modes.least[i] * t >= CLEAR:
            up, down = complex(modes.answers[0, i]), complex(modes.answers[1, i])
            one = complex(modes.answers[2, i])
            z = (start - up - down - one) * exp(s * t)
            found[i] = z + (up * wave + down * wave.conjugate() + one)
            continue
        z = start * exp(s * t)
        for k in range(3):
            q = turning if k == 0 else (-turning if k == 1 else 0j)
            z += complex(modes.drives[k, i]) * of_two(s, q, t)
            if i < modes.free:  # a place, which a velocity moves
                z += complex(modes.drives[k, modes.free + i]) * of_three(0j, 0j, q, t)
        if i < modes.free:
            z += complex(modes.start[modes.free + i]) * t
        found[i] = z
    return found


def state_at(poles: Poles, omega: float, p: int, Y: Vector, t: float) -> Vector:
    """Return y at a time from the state in which a phase begins."""
    z, found = poles_at(modes_of(poles, omega, p, Y), t), np.zeros(poles.bases.shape[1])
    for j in range(len(found)):
        found[j] = real_of(poles.bases[p, j], z)
    return found


def size_by_poles(poles: Poles, omega: float, p: int, row: Vector, Y: Vector) -> float:
    """Return what a form is the sum of by the poles of a phase, where that begins.

    More than by y where vectors are nearly one: it is located to the rounding of that.
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
    """Return the real part of a sum by poles."""
    total = 0.0
    for i in range(len(z)):
        factor, value = complex(factors[i]), complex(z[i])
        total += factor.real * value.real - factor.imag * value.imag
    return total
