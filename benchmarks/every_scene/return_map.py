"""The return map of any scene by RK4 with event location, and Newton's method on it; numba.

What an expert writes in an evening for one oscillator, for linear phases in general: fixed
steps of RK4, an event located by the cubic through both ends of a step and then by steps of
that length.  The map goes from the first switch to the next: there one event holds, so that one
coordinate of the state and, if something forces, the phase of the forcing are unknown.
Derivatives are differences.
"""

import math

import numba
import numpy as np

from ..scene_rivals import _hermite_root, _rk4
from .problem import STATE_OFF, Problem

#: Newton's method stops below this step; differences have this step.
SMALL = 1e-7

#: Steps of a phase, in those of a cell, beyond which there is no event.
TOO_LONG = 6

#: Columns of a phase: its equation, its event, its jump, and factors of a memory.
M, C, K, F, G, EX, EV, EC, E0, RHO, D, FM, EM = range(13)

njit = numba.njit(error_model="numpy")


def rows(which: Problem) -> np.ndarray:
    """Return the numbers of all phases, (P, 13)."""
    cell, found = which.case.cell, []
    for p in range(len(cell.phases)):
        phase = cell.carrying(p)
        memory, (ex, ev, ec, e0, *em) = phase.memory, phase.event
        numbers = (phase.m, phase.c, phase.k, phase.f, phase.g, ex, ev, ec, e0)
        force = sum(memory) if memory else 0.0
        found.append((*numbers, phase.rho, phase.d, force, sum(em)))
    if any(each.phase != 0 or each.value != (1, 0, 0, 0) for each in cell.memory):
        raise ValueError("a memory: expected the displacement where the first phase begins")
    return np.array(found, dtype=float)


@njit
def _event(row, w, x, v, turn):
    return row[EX] * x + row[EV] * v + row[EC] * math.cos(turn) + row[E0] + row[EM] * w


@njit
def _slope(row, w, x, v, turn, omega):
    a = (row[F] + row[FM] * w + row[G] * math.cos(turn) - row[C] * v - row[K] * x) / row[M]
    return row[EX] * v + row[EV] * a - row[EC] * omega * math.sin(turn)


@njit
def _step(row, w, x, v, turn, omega, h):
    f, g = row[F] + row[FM] * w, row[G]
    f0, f1, f2 = f, f, f
    if g != 0:
        f0 += g * math.cos(turn)
        f1 += g * math.cos(turn + omega * h / 2)
        f2 += g * math.cos(turn + omega * h)
    return _rk4(row[M], row[C], row[K], x, v, h, f0, f1, f2)


@njit
def _to_event(row, w, x, v, turn, omega, h, most):
    """Return the state before the switch that ends a phase, and how long the phase lasts."""
    x, v = _step(row, w, x, v, turn, omega, h)
    t = h
    e = _event(row, w, x, v, turn + omega * t)
    for _ in range(most):
        now = turn + omega * t
        ahead_x, ahead_v = _step(row, w, x, v, now, omega, h)
        after = _event(row, w, ahead_x, ahead_v, now + omega * h)
        if e * after <= 0:
            begins = h * _slope(row, w, x, v, now, omega)
            ends = h * _slope(row, w, ahead_x, ahead_v, now + omega * h, omega)
            part = h * _hermite_root(e, begins, after, ends)
            for _ in range(2):
                end_x, end_v = _step(row, w, x, v, now, omega, part)
                at = now + omega * part
                left = _event(row, w, end_x, end_v, at)
                part -= left / _slope(row, w, end_x, end_v, at, omega)
            end_x, end_v = _step(row, w, x, v, now, omega, part)
            return end_x, end_v, t + part
        x, v, t, e = ahead_x, ahead_v, t + h, after
    return math.nan, math.nan, math.nan


@njit
def _cell(phases, omega, sign, h, most, q, turn, durations):
    """Return the unknown coordinate a cell later; the durations are filled in."""
    last = phases[len(phases) - 1]
    cos = sign * math.cos(turn)
    if last[EV] == 0:
        x, v = -sign * (last[EC] * cos + last[E0]) / last[EX], q
    else:
        before = -(last[EX] * sign * q + last[EC] * cos + last[E0]) / last[EV]
        x, v = q, sign * (last[RHO] * before + last[D])
    w = x
    for p in range(len(phases)):
        row = phases[p]
        x, v, durations[p] = _to_event(row, w, x, v, turn, omega, h, most)
        v, turn = row[RHO] * v + row[D], turn + omega * durations[p]
    return sign * (v if last[EV] == 0 else x)


@njit
def fixed_point(phases, omega, sign, period, rough, q, turn, steps):
    """Return the times of the fixed point of the map; not a number if there is none.

    period : float
        Of the forcing, a cell of it; 0 if nothing forces.
    rough : float
        A duration of the cell that the number of steps is for.
    """
    many = len(phases)
    found, other = np.empty(many + (1 if period > 0 else 0)), np.empty(many)
    h, most = rough / steps, TOO_LONG * steps
    for _ in range(20):
        R1 = _cell(phases, omega, sign, h, most, q, turn, found) - q
        a = (
            _cell(phases, omega, sign, h, most, q + SMALL, turn, other) - q - SMALL - R1
        ) / SMALL
        if period == 0:
            step_q, step_turn = -R1 / a, 0.0
        else:
            R2 = np.sum(found[:many]) - period
            c = (np.sum(other) - period - R2) / SMALL
            b = _cell(phases, omega, sign, h, most, q, turn + SMALL, other) - q - R1
            b, d = b / SMALL, (np.sum(other) - period - R2) / SMALL
            step_q = (-d * R1 + b * R2) / (a * d - b * c)
            step_turn = (c * R1 - a * R2) / (a * d - b * c)
        q, turn = q + step_q, turn + step_turn
        if max(abs(step_q), abs(step_turn)) < SMALL:
            _cell(phases, omega, sign, h, most, q, turn, found)
            if period > 0:
                found[many] = turn
            return found
    return np.full(len(found), np.nan)


def arguments(which: Problem) -> tuple:
    """Return what `fixed_point` takes before the number of steps."""
    cell, phases, times = which.case.cell, rows(which), which.rough
    x, v = which.state
    q = STATE_OFF * (v if phases[-1, EV] == 0 else x)
    period, turn = (cell.duration, times[-1]) if cell.forced else (0.0, 0.0)
    rough = float(times[: len(phases)].sum())
    return phases, cell.omega, float(cell.sign), period, rough, q, float(turn)
