"""A branch as rows and events for users, in SI units."""

import math

import numpy as np

from ..results.branch import BranchEvent
from ..results.family import FamilyRow
from ..scenes.case import index_of
from ..stability.stability import of_monodromy
from .events.locate import Found
from .piece import Piece
from .place import Place


def row_of(piece: Piece, place: Place, regular: bool = True) -> FamilyRow:
    """Return an orbit of a branch as a row; without multipliers where it is not regular."""
    cell, units = piece.cell, piece.case.units
    nonnegative = np.maximum(piece.durations(place.y), 0.0)  # at an event one is rounding
    durations = tuple(map(float, nonnegative * units.time)) * cell.cells
    extremes = place.extremes
    if cell.sign < 0:
        greatest = np.maximum(extremes[:, 1], -extremes[:, 0])
        extremes = np.column_stack([-greatest, greatest])
    names = enumerate(("displacement", "velocity"))
    ends = {name: tuple(extremes[j] * units.of_motion(j)) for j, name in names}
    multipliers, stable = None, None
    matrix, size = piece.maps(place)
    if regular and np.isfinite(matrix).all() and np.isfinite(size).all():
        stability = of_monodromy(cell, matrix, size)
        multipliers, stable = tuple(map(complex, stability.multipliers)), stability.stable
    turn = float(place.y[-2]) % (2 * math.pi) if cell.forced else None
    strobe = None if turn is None else _at_phase_zero(piece, place, turn)
    return FamilyRow(
        piece.value(place.y), "ok", math.fsum(durations), turn, durations, ends, None, 0, True,
        motion=piece.course.motion, multipliers=multipliers, stable=stable,
        strobe=strobe,
    )  # fmt: skip


def _at_phase_zero(piece: Piece, place: Place, turn: float) -> tuple[float, float]:
    """Return displacement and velocity where the phase of the forcing is 0, in SI units."""
    case, durations = piece.equations(place.y), piece.durations(place.y)
    forcing = index_of(piece.case, str(piece.case.scene.frequency))
    omega = piece.numbers(place.y)[forcing]
    t, sign = -turn % (2 * math.pi) / omega, 1
    if piece.cell.sign < 0 and t > durations.sum():
        t, sign = t - float(durations.sum()), -1
    starts = np.concatenate([[0.0], np.cumsum(durations)])
    p = min(int(np.searchsorted(starts, t, "right")) - 1, len(durations) - 1)
    x, v = piece.course.moving_at(case, place.y[:-1], p, t - float(starts[p]))
    units = piece.case.units
    return sign * x * units.length, sign * v * units.of_motion(1)


def event_of(event: Found) -> BranchEvent:
    """Return what happens on a branch as users read it."""
    course, p = event.piece.course, event.phase
    phase = None if p is None else course.order.steps[p].called(course.base.phases)
    return BranchEvent(event.kind, event.value, course.motion, phase, event.estimate)
