"""A branch as rows and events for users, in SI units."""

import math
from dataclasses import replace

import numpy as np

from ...generated.ck import F
from ..flow.exact_system import phase_numbers
from ..flow.flow import state_at
from ..results.branch import BranchEvent
from ..results.family import FamilyRow
from ..stability.monodromy import Monodromy, forgotten
from ..stability.stability import of_monodromy
from .extended import case_at
from .follow import Found
from .piece import Piece, Place


def row_of(piece: Piece, place: Place, regular: bool = True) -> FamilyRow:
    """Return an orbit of a branch as a row; without multipliers where it is not regular."""
    cell, units = piece.cell, piece.case.units
    count, more = len(cell.phases), len(cell.memory)
    found = np.maximum(place.y[2 * count + more :][:count], 0.0)  # at an event one is rounding
    durations = tuple(map(float, found * units.time)) * cell.cells
    extremes = place.extremes
    if cell.sign < 0:
        most = np.maximum(extremes[:, 1], -extremes[:, 0])
        extremes = np.column_stack([-most, most])
    names = enumerate(("displacement", "velocity"))
    ends = {name: tuple(extremes[j] * units.of_motion(j)) for j, name in names}
    multipliers, stable = None, None
    matrix, size = place.maps
    if regular and np.isfinite(matrix).all() and np.isfinite(size).all():
        own = of_monodromy(cell, Monodromy(matrix, size, forgotten(cell)))
        multipliers, stable = tuple(map(complex, own.multipliers)), own.stable
    turn = float(place.y[-2]) % (2 * math.pi) if cell.forced else None
    strobe = None if turn is None else _at_phase_zero(piece, place, turn)
    return FamilyRow(
        piece.value(place.y), "ok", math.fsum(durations), turn, durations, ends, None, 0, True,
        motion=piece.course.motion, multipliers=multipliers, stable=stable,
        strobe=strobe,
    )  # fmt: skip


def _at_phase_zero(piece: Piece, place: Place, turn: float) -> tuple[float, float]:
    """Return displacement and velocity where the phase of the forcing is 0, in SI units."""
    case, z, cell = case_at(piece.along, float(place.y[-1])), place.y[:-1], piece.cell
    count, omega = len(cell.phases), float(case[4][1])
    durations = z[2 * count + len(cell.memory) :][:count]
    t, sign = -turn % (2 * math.pi) / omega, 1
    if cell.sign < 0 and t > durations.sum():
        t, sign = t - float(durations.sum()), -1
    begun = np.concatenate([[0.0], np.cumsum(durations)])
    p = min(int(np.searchsorted(begun, t, "right")) - 1, count - 1)
    m, c, k, f, g = map(float, phase_numbers(case, z, p))
    speed = float(case[1][p, F])  # of a held phase
    phase = replace(cell.phases[p], m=m, c=c, k=k, f=f, g=g, speed=speed, memory=())
    angle = turn + omega * float(begun[p])
    x, v = state_at(
        phase, float(z[2 * p]), float(z[2 * p + 1]), angle, omega, t - float(begun[p])
    )
    units = piece.case.units
    return sign * x * units.length, sign * v * units.of_motion(1)


def event_of(found: Found) -> BranchEvent:
    """Return what happens on a branch as users read it."""
    course, p = found.piece.course, found.phase
    phase = None if p is None else course.name(course.order.steps[p])
    return BranchEvent(found.kind, found.value, course.motion, phase, found.estimate)
