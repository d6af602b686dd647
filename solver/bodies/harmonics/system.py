"""The equations of the harmonics of contact forces at given times; see the package."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ....generated import force_harmonics as formula
from ...arrays import Complex, Indices, Matrix, Vector
from ..part import kept_by_times, parts_of, shifts
from ..poles import Forms
from .frame import Frame, compliance, first_function, integrals, of_real, values
from .moving import Moving

if TYPE_CHECKING:
    from ...scenes.bodies.cell import BodyCell

#: Relative size of a response to constant forces that is taken as zero.
UNSEEN = 1e-7

#: Relative step of the difference quotient by the duration of a cell without a forcing.
STEP = 1e-5


@dataclass(frozen=True, eq=False)
class Evaluation:
    """The equations at given times; see `exact.Evaluation`.

    Parameters
    ----------
    residual, jacobian : ndarray
    unknowns : ndarray of complex
        The harmonics of the forces, by contact; the factors of `Frame.breaks`; the memory.
    frame : Frame
    """

    residual: Vector
    jacobian: Matrix
    unknowns: Complex
    frame: Frame


class Statement(NamedTuple):
    """Unknowns as combinations of forms at the start (0) or end (1) of a phase, and a constant.

    ``unknowns[place] = weights forms + constant``, summed over the statements of a place.
    """

    place: slice
    weights: Matrix
    forms: Forms
    phase: int
    side: int
    constant: float | Vector = 0.0


def _galerkin(frame: Frame) -> Complex:
    """Return the rows of the harmonics: of the force, minus those of the force by the laws.

    Functions and impulses are integrated by parts, as `codegen.galerkin.force_harmonics` says.
    """
    turns, b, T = frame.turns, frame.own.poles.b, frame.T
    J, contacts = len(turns), b.shape[1]
    rows = np.zeros((J, contacts, frame.size), dtype=complex)
    waves = np.einsum("jh,cd->jchd", np.eye(J), np.eye(contacts)).astype(complex)
    lags = np.arange(J) - np.arange(J)[:, None] + J - 1  # index in `steps` of a difference
    steps = (turns[1] - turns[0]) * np.arange(1 - J, J)
    breaks = slice(frame.waves, frame.memory.start)
    forced = np.array([b[:, q.contact] * (q.n > 0) for q in frame.breaks]).reshape(-1, len(b)).T
    for q, law in enumerate(frame.laws):
        overlaps = integrals(frame, q, steps)[lags]
        waves -= np.einsum("hcd,jh->jchd", compliance(frame, law), overlaps)
        by_pole = np.einsum("jm,cm->jcm", frame.above, law.poles)
        by_break = by_pole @ forced * frame.answers[q].by_waves(turns)[:, None, :]
        for side, z in enumerate(frame.answers[q].ends):
            wave = np.exp(-1j * turns * frame.ends[q + side])[:, None, None]
            by_break += (-1) ** side * wave * (by_pole @ z) / T
        rows[:, :, breaks] -= of_real(by_break)
        rows[:, :, frame.memory] -= integrals(frame, q, -turns)[:, None, None] * law.memory
    rows[:, :, : frame.waves] = waves.reshape(J, contacts, -1)
    waving = turns != 0  # the mean of a function is 0
    for i, (p, n, c) in enumerate(frame.breaks):
        if n:
            at_break = np.exp(-1j * turns[waving] * frame.ends[p])
            rows[waving, c, frame.waves + i] += formula.harmonic(turns[waving], n) * at_break
    return rows.reshape(J * contacts, -1)


def _driven(frame: Frame, angle: float) -> Complex:
    """Return the harmonics of the part of the laws by a forcing with initial phase `angle`."""
    drive = frame.angles[-1] - frame.angles[0]
    harmonics = np.zeros((len(frame.turns), frame.own.poles.b.shape[1]), dtype=complex)
    for q, law in enumerate(frame.laws):
        turned = np.exp(1j * angle) * law.turn / 2
        harmonics += integrals(frame, q, drive - frame.turns)[:, None] * turned
        harmonics += integrals(frame, q, -drive - frame.turns)[:, None] * turned.conj()
    return harmonics.ravel()


def _statements(cell: "BodyCell", frame: Frame) -> Iterator[Statement]:
    """Yield the equations of the factors of functions, the impulses and the memory."""
    layout, at, contacts = frame.own, frame.waves, frame.own.poles.b.shape[1]
    for p in range(len(frame.laws)):
        after, before = frame.laws[p], frame.laws[p - 1]
        sign, left = (1, p - 1) if p else (cell.sign, len(frame.laws) - 1)
        first = first_function(cell, p)
        for n in range(1, first + frame.functions if frame.functions else 1):
            if n >= first:
                block, size = slice(at, at + contacts), frame.T ** (n - 1) * np.eye(contacts)
                yield Statement(block, size, after, p, 0)
                yield Statement(block, -sign * size, before, left, 1)
                at += contacts
            after = layout.poles.rate(after, frame.laws[p])
            before = layout.poles.rate(before, frame.laws[left])
    for p, phase in enumerate(layout.phases):
        weights, block = phase.impulse[phase.hit], slice(at, at + len(phase.hit))
        yield Statement(block, weights[:, :-1], layout.velocity, p, 1, weights[:, -1])
        at += len(phase.hit)
    for i, memory in enumerate(cell.memory):
        row = np.eye(len(cell.memory))[i : i + 1]
        yield Statement(slice(at + i, at + i + 1), row, layout.setting, memory.phase, 0)


def _system(cell: "BodyCell", frame: Frame) -> tuple[Complex, Complex, Complex, Vector]:
    """Return matrix and right side of the unknowns' system, factors and constants of events."""
    A, right = np.eye(frame.size, dtype=complex), np.zeros(frame.size, complex)
    A[: frame.waves] = _galerkin(frame)
    alone = (
        integrals(frame, q, -frame.turns)[:, None] * law.constant
        for q, law in enumerate(frame.laws)
    )
    right[: frame.waves] = np.ravel(sum(alone)) + _driven(frame, frame.angles[0])
    for block, weights, forms, q, side, constant in _statements(cell, frame):
        rows, offsets = values(frame, forms, q, side)
        A[block] -= weights @ rows
        right[block] += weights @ offsets + constant
    ends = [values(frame, phase.event, p, 1) for p, phase in enumerate(frame.own.phases)]
    events = np.vstack([rows for rows, _ in ends])
    constants = np.concatenate([offsets for _, offsets in ends])
    slow, fixing = _fixing(cell, frame)
    A[slow] += fixing @ events
    right[slow] -= fixing @ constants
    return A, right, events, constants


def _fixing(cell: "BodyCell", frame: Frame) -> tuple[Indices, Complex]:
    """Return the indices of rows of forces, and the factors of the events added to them.

    They vanish on an orbit; see `layout.Phase`.  The rows are those of the mean forces, where
    displacements are not determined; and without a forcing of the first harmonics, which shift
    a motion in time: as forces that act at as many equal steps as there are events.
    """
    slow = [h for h, turn in enumerate(frame.turns) if fixes(cell, turn)]
    by_law = np.array([q.fixing / np.diag(q.direct) for q in frame.own.phases]).T
    contacts, count = by_law.shape
    rows = np.array([h * contacts + c for h in slow for c in range(contacts)], dtype=int)
    steps = np.exp(-1j * frame.turns[slow, None, None] * np.arange(count) / count)
    return rows, (steps * by_law / count).reshape(len(rows), count)


def fixes(cell: "BodyCell", turn: Any) -> bool:
    """Whether events are added to the rows of a harmonic ``h w T``: see `_fixing`."""
    is_mean = abs(float(turn)) < 1.0
    if cell.forced or is_mean:
        return is_mean and shifts(cell)[0].size > 0
    return abs(float(turn)) < 2 * math.pi + 1.0


def mean_fixes(cell: "BodyCell") -> bool:
    """Whether constant contact forces act on the directions that periodicity leaves open."""
    _, directions = shifts(cell)
    if not (directions.size and cell.forced and len(cell.phases) == 1):
        return True
    part, count = parts_of(cell)[0], len(cell.body.squares)
    force = np.vstack([np.zeros_like(cell.body.at), cell.body.at])
    drives = np.zeros((3, *force.shape), dtype=complex)
    drives[2] = part.flow.inverse @ force
    answer = (part.flow.basis @ part.flow.answered(drives, np.asarray(cell.duration))).real
    moved = directions.T @ part.switch.state[:, : 2 * count] @ answer
    return bool(cell.sign > 0 and np.abs(moved).max() > UNSEEN * np.abs(answer).max())


@kept_by_times(8)
def evaluated(cell: "BodyCell", order: int, functions: int, times: Vector) -> Evaluation:
    """Return residual, Jacobian and unknowns of the harmonics at given times.

    Parameters
    ----------
    cell : BodyCell
    order : int
        The highest harmonic.
    functions : int
        The number of functions with a break at each switch.
    times : ndarray
        Durations and, with a forcing, its phase.

    Raises
    ------
    numpy.linalg.LinAlgError
        If the system is singular, as it is at any times without `mean_fixes`.
    """
    if not mean_fixes(cell):
        raise np.linalg.LinAlgError
    count = len(cell.phases)
    T = cell.duration if cell.forced else float(times[:count].sum())
    frame = Frame(cell, order, functions, times, T)
    A, right, events, constant = _system(cell, frame)
    unknowns: Complex = np.asarray(np.linalg.solve(A, right), dtype=complex)
    residual: Vector = (events @ unknowns).real + constant
    moved, shifted = _moved(cell, frame, A, events, unknowns)
    by_times = np.zeros((count, len(times)))  # derivatives of switches and angle
    by_times[:-1, :count] = np.tri(count - 1, count) / T
    if cell.forced:
        by_times[-1, -1] = 1.0
    moved, shifted = moved @ by_times, shifted @ by_times
    if not cell.forced:  # by T as well, at fixed relative switches
        frames = (Frame(cell, order, functions, times, T * (1 + q)) for q in (STEP, -STEP))
        ahead, behind = (_system(cell, q) for q in frames)
        A_rate, rate, event_rate, constant_rate = (
            (a - b) / (2 * STEP * T) for a, b in zip(ahead, behind, strict=True)
        )
        moved += (A_rate @ unknowns - rate)[:, None]
        shifted += ((event_rate @ unknowns).real + constant_rate)[:, None]
    jacobian: Matrix = shifted - (events @ np.linalg.solve(A, moved)).real
    if cell.forced:
        residual = np.append(residual, times[:count].sum() - T)
        jacobian = np.vstack([jacobian, np.append(np.ones(count), 0.0)])
    return Evaluation(residual, jacobian, unknowns, frame)


def _moved(
    cell: "BodyCell", frame: Frame, A: Complex, events: Complex, unknowns: Complex
) -> tuple[Complex, Matrix]:
    """Return the derivatives of system and events by switches and angle, at fixed unknowns."""
    moving, (slow, fixing) = Moving(frame, unknowns), _fixing(cell, frame)
    rows, moved = A[: frame.waves].copy(), np.zeros((len(A), len(frame.laws)), dtype=complex)
    rows[slow] -= fixing @ events
    moved[: frame.waves, :-1] = moving.galerkin(rows)
    moved[: frame.waves, -1] = -_driven(frame, frame.angles[0] + np.pi / 2)
    for block, weights, forms, q, side, _ in _statements(cell, frame):
        moved[block] -= weights @ moving.of(forms, q, side)
    phases = enumerate(frame.own.phases)
    shifted = np.vstack([moving.of(phase.event, p, 1) for p, phase in phases])
    moved[slow] += fixing @ shifted
    return moved, shifted


def along(evaluation: Evaluation, p: int, u: Vector) -> Complex:
    """Return z of the whole motion at local times of phase p; shape (m, len(u))."""
    frame = evaluation.frame
    begin, end = frame.ends[p : p + 2]
    w = (end - begin) * np.asarray(u, dtype=float)
    harmonics = evaluation.unknowns[: frame.waves].reshape(len(frame.turns), -1)
    waves = np.exp(1j * frame.turns[:, None] * (begin + w))
    answered = np.einsum("jm,mc,jc->mj", frame.above, frame.own.poles.b, harmonics)
    factors = evaluation.unknowns[frame.waves : frame.memory.start].real
    return np.asarray(answered @ waves + np.tensordot(factors, frame.answers[p].at(w), 1))
