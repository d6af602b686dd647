"""The exact equations of a cell in ball arithmetic, by the matrix exponential of each phase.

They are independent of ``solver/flow``, whose closed forms in float64 they judge.  The state is
``y = (x, x', 1, cos, sin)``, with cosine and sine of the forcing, and a phase is ``y' = A y``.
"""

from collections.abc import Sequence
from typing import Any

from flint import arb, arb_mat

from ..scenes.cell import Cell, Form, Phase


def residual(cell: Cell, z: Sequence[Any], R: Any) -> None:
    """Fill R with the residuals of all conditions, in the order of ``flow.exact_system``."""
    count, memories = len(cell.phases), len(cell.memory)
    memory, durations = z[2 * count : 2 * count + memories], z[2 * count + memories :][:count]
    omega = arb(cell.omega)
    angle = z[-1] if cell.forced else arb(0)
    phases = cell.remembering(list(memory)).phases
    for p, phase in enumerate(phases):
        after = (p + 1) % count
        state = [z[2 * p], z[2 * p + 1], arb(1), angle.cos(), angle.sin()]
        for i, remembered in enumerate(cell.memory):
            if remembered.phase == p:
                R[3 * count + i] = memory[i] - _value(remembered.value, state)
        flow = (_generator(phase, omega) * durations[p]).exp()
        end = [row[0] for row in (flow * arb_mat([[q] for q in state])).tolist()]
        sign = cell.sign if after == 0 else 1
        R[2 * after] = z[2 * after] - sign * end[0]
        speed = arb(phase.rho) * end[1] + arb(phase.d)
        R[2 * after + 1] = z[2 * after + 1] - sign * speed
        R[2 * count + p] = _value(phase.event, end)
        angle = angle + omega * durations[p]
    if cell.forced:
        duration = 2 * arb.pi() * cell.cycles / omega / cell.cells
        R[3 * count + memories] = sum(durations, arb(0)) - duration


def _value(form: Form, state: Sequence[Any]) -> Any:
    """Return the value of a linear form in a state."""
    x, v, cos, constant = form
    return x * state[0] + v * state[1] + cos * state[3] + constant


def _generator(phase: Phase, omega: Any) -> Any:
    """Return the matrix A of ``y' = A y`` in a phase."""
    zero, m = arb(0), arb(phase.m)
    held = [zero] * 5
    free = [-arb(phase.k) / m, -arb(phase.c) / m, arb(phase.f) / m, arb(phase.g) / m, zero]
    first = [zero, zero, arb(phase.speed), zero, zero]
    return arb_mat(
        [
            first if phase.held else [zero, arb(1), zero, zero, zero],
            held if phase.held else free,
            [zero] * 5,
            [zero, zero, zero, zero, -omega],
            [zero, zero, zero, omega, zero],
        ]
    )
