"""Scenes of one mass as bodies of one degree of freedom: the same motion by other equations."""

import numpy as np

from nonsmooth.solver.bodies.laws import scales
from nonsmooth.solver.bodies.modal import Modal
from nonsmooth.solver.scenes.bodies.cell import NO_EQUATION, BodyCell, BodyPhase
from nonsmooth.solver.scenes.cell import Cell, Form, Memory, Phase
from nonsmooth.solver.simulation.bodies.state import BodyState
from nonsmooth.solver.simulation.steps.state import State


def wide(form: Form) -> Form:
    """Return a form with factors of the contact force and of the acceleration: none."""
    return (*form[:4], 0.0, 0.0, *form[4:])


def free_phase(cell: Cell) -> Phase:
    """Return the phase whose equation is that of the body."""
    return next(phase for phase in cell.phases if not phase.held)


def law(phase: Phase, base: Phase) -> Form:
    """Return what of an equation of motion is not in that of the body."""
    if phase.held:
        return (0.0, 0.0, 0.0, 0.0, 0.0, 1.0, *(0.0 for _ in phase.memory))
    part = base.m / phase.m
    moving = phase.k * part - base.k, phase.c * part - base.c, base.g - phase.g * part
    return (*moving, -phase.f * part, 1.0, 0.0, *(-part * h for h in phase.memory))


def as_body(cell: Cell) -> BodyCell:
    """Return the cell of a body of one mass with the laws that make it move as another cell."""
    base, one = free_phase(cell), np.ones((1, 1))
    body = Modal(
        np.array([base.k / base.m]), one * base.c / base.m, one / np.sqrt(base.m),
        np.array([base.g / np.sqrt(base.m)]), one / base.m, 0 * one, np.zeros(1, complex),
    )  # fmt: skip
    phases = []
    for phase in cell.phases:
        fields = vars(phase.with_forms(wide)) | NO_EQUATION
        fields["memory"] = (0.0,) * len(phase.memory)
        jumps = ((phase.rho, phase.d),)
        phases.append(BodyPhase(**fields, laws=(law(phase, base),), jumps=jumps))
    memory = tuple(Memory(q.name, q.phase, q.power, wide(q.value)) for q in cell.memory)
    return BodyCell(
        tuple(phases), cell.frequency, cell.sign, cell.k, cell.guess, cell.cycles, memory,
        cell.classes, body=body,
    )  # fmt: skip


def state_of(state: State, cell: BodyCell, mass: float) -> BodyState:
    """Return a state of one mass as that of the body."""
    w, root = float(scales(cell.body, cell.omega)[0]), np.sqrt(mass)
    y = (float(w * state.x * root), float(state.v * root))
    return BodyState(y, state.angle, memory=tuple(map(float, state.memory)))
