"""The monodromy of one cell of an orbit, at the orbit's own times and states, and its checks.

It is the product over the phases of the flow's derivative and of the saltation at the switch
that ends the phase.  Neither Hill's determinant nor the Jacobian of an expansion gives it as
well: the first converges slowly or to a wrong limit where a derivative jumps, the second has
the error of the motion between the switches, which is larger than that of the times.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from ..arrays import Matrix, Vector
from ..flow import flow
from ..scenes.cell import Cell, Phase
from .linear_maps import Switch, contraction, determinant, rates, saltation, transition

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Rounding that a check allows, as a part of the size of what it adds.
ROUNDING = 1e-10

#: Least rate at which an event is crossed, as a part of the size of its terms.
TOUCH = 1e-12


class NoMultipliersError(ArithmeticError):
    """There are no multipliers: an event is touched and not crossed, or a check has failed."""


@dataclass(frozen=True)
class Monodromy:
    """What one cell makes of small perturbations of the state at its first switch.

    Parameters
    ----------
    matrix : ndarray, shape (n, n)
        Of the cell, before its motion is mirrored.
    size : ndarray, shape (n, n)
        The same product of absolute values: rounding errors are parts of it.
    forgotten : int
        How many multipliers are exactly 0: as many as the phase or the switch that forgets
        most; see `_forgotten`.
    """

    matrix: Matrix
    size: Matrix
    forgotten: int


def monodromy(motion: "Motion") -> Monodromy:
    """Return the monodromy of a cell of an orbit, checked.

    Raises
    ------
    NoMultipliersError
        If an event is touched and not crossed, or if a factor fails a check: the formula for
        the determinant or, without forcing, that the rate of the motion is mapped to itself.
    """
    cell, memory = motion.cell, motion.case.cell.memory
    starts, ends = _states(motion)
    count = 2 + len(memory)
    matrix, size, expected = np.eye(count), np.eye(count), 1.0
    for p, phase in enumerate(cell.phases):
        s = float(motion.cell_durations[p])
        switch = _switch(motion, p, starts, ends)
        if not abs(switch.approach) > TOUCH * switch.size:
            raise NoMultipliersError(
                f"the event that ends {phase.name} is touched, not crossed: "
                "perturbations are not mapped linearly"
            )
        slow = min(1.0, abs(switch.approach) / switch.size)
        forces = motion.case.cell.carrying(p).memory
        along, across = transition(phase, s, forces), saltation(switch)
        matrix = across @ along @ matrix
        size = np.abs(across) @ np.abs(along) @ size / slow
        expected *= contraction(phase, s) * determinant(switch)
        if not cell.forced:
            _check_rates(phase, starts[p], s, along, across, switch)
    _check_determinant(matrix, size, expected)
    return Monodromy(matrix, size, _forgotten(motion.case.cell))


def _forgotten(cell: Cell) -> int:
    """Return of how many parts of the state nothing is left at some place of a cell.

    A phase that is held forgets the velocity, at one place the displacement too; a switch
    forgets each constant that it sets.
    """
    places = range(len(cell.phases))
    held = (cell.phases[p].held + (cell.place(p) is not None) for p in places)
    sets = (sum(memory.phase == p for memory in cell.memory) for p in places)
    return max(*held, *sets)


def _states(motion: "Motion") -> tuple[Matrix, Matrix]:
    """Return displacement and velocity at the start and at the end of each phase."""
    both = np.array([0.0, 1.0])
    phases = range(len(motion.case.cell.phases))
    found = np.array([[motion.part(p, both, j) for j in (0, 1)] for p in phases])
    return found[:, :, 0], found[:, :, 1]


def _switch(motion: "Motion", p: int, starts: Matrix, ends: Matrix) -> Switch:
    """Return the switch at the end of a phase; the motion after it is not yet mirrored."""
    cell, raw = motion.cell, motion.case.cell
    phase, after = cell.phases[p], (p + 1) % len(cell.phases)
    sign = cell.sign if after == 0 else 1
    angle = motion.angle + cell.omega * float(np.sum(motion.cell_durations[: p + 1]))
    cosine, sine = np.cos(angle), np.sin(angle)
    ex, ev, ec, _ = phase.event
    speed = float(np.abs(motion.part(p, np.linspace(0.0, 1.0, 17), 1)).max())
    count = len(raw.memory)
    law, turning = np.diag([1.0, phase.rho, *[1.0] * count]), np.zeros(2 + count)
    for i, memory in enumerate(raw.memory):
        if memory.phase == after:
            vx, vv, vc, _ = memory.value
            law[2 + i] = [vx, vv * phase.rho, *[0.0] * count]
            turning[2 + i] = -vc * cell.omega * sine
    constant = np.zeros(count)
    before = rates(phase, ends[p], cosine)
    behind = sign * rates(cell.phases[after], starts[after], sign * cosine)
    return Switch(
        rates_before=np.append(before, constant),
        rates_after=np.append(behind, constant),
        law=law,
        gradient=np.array([ex, ev, *raw.carrying(p).event[4:]]),
        drift=float(-ec * cell.omega * sine),
        turning=turning,
        size=abs(ex) * speed + abs(ev) * _force(phase, ends[p]) + abs(ec) * cell.omega,
    )


def _force(phase: Phase, state: Vector) -> float:
    """Return the size of the acceleration of a phase: of its terms, added without sign."""
    x, v = np.abs(state)
    parts = abs(phase.f) + abs(phase.g) + abs(phase.c) * v + abs(phase.k) * x
    return 0.0 if phase.held else float(parts / phase.m)


def _check_rates(
    phase: Phase, start: Vector, s: float, along: Matrix, across: Matrix, switch: Switch
) -> None:
    """Check that phase and switch map the rate of the motion to that behind them: M F = F."""
    x, v = map(float, start)
    reached = np.array(flow.state_at(phase, x, v, 0.0, 0.0, s))
    constant = np.zeros(len(along) - 2)
    first, last = (np.append(rates(phase, q, 1.0), constant) for q in (start, reached))
    pairs = (
        (along, first, last),
        (across, switch.rates_before, switch.rates_after),
    )
    for matrix, rate, expected in pairs:
        off = np.abs(matrix @ rate - expected)
        allowed = ROUNDING * (np.abs(matrix) @ np.abs(rate) + np.abs(expected))
        if not (off <= allowed + ROUNDING * _force(phase, start)).all():
            raise NoMultipliersError(
                f"a check failed: the rate of the motion is not mapped to itself where "
                f"{phase.name} ends"
            )


def _check_determinant(matrix: Matrix, size: Matrix, expected: float) -> None:
    """Check the determinant against its formula: ``prod det S exp(-sum c s/m)``."""
    found = float(np.linalg.det(matrix))
    largest = _permanent(size)
    if not abs(found - expected) <= ROUNDING * largest:
        raise NoMultipliersError(
            f"a check failed: the determinant of the monodromy is {found:.6g}, expected "
            f"{expected:.6g} by its formula"
        )


def _permanent(matrix: Matrix) -> float:
    """Return the sum of the products that make a determinant, without signs."""
    if len(matrix) == 1:
        return float(matrix[0, 0])
    return sum(
        float(matrix[0, j]) * _permanent(np.delete(matrix[1:], j, axis=1))
        for j in range(len(matrix))
    )
