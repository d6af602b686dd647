"""Contact forces of a body by harmonics and functions with breaks, in balls."""

from collections.abc import Iterator
from itertools import chain
from typing import Any

import numpy as np
from flint import acb, arb

from ...bodies.force_series.layout import for_harmonics
from ...bodies.harmonics.system import fixes
from ...bodies.motion import Given
from .body import Balls, Forms, balls, conjugate, real, solved, statements
from .frame import Frame, of_real


def residual(given: Given, times: Any, R: Any) -> None:
    """Fill R with residuals of events and of the cell's duration; see ``bodies.harmonics``.

    Raises
    ------
    PrecisionError
        If poles cannot be distinguished.
    """
    frame, cell = Frame(given, np.array(times, dtype=object)), given.cell
    A = np.full((frame.size, frame.size), acb(0), dtype=object)
    right = np.full(frame.size, acb(0), dtype=object)
    A[: frame.waves], right[: frame.waves] = _galerkin(frame)
    equations = chain(_smooth(frame), statements(cell, frame.body, frame.values))
    for index, (row, offset) in enumerate(equations, frame.waves):
        A[index], right[index] = -row, offset
        A[index, index] += 1
    ends = []
    for p, phase in enumerate(cell.phases):
        (row,), (offset,) = frame.values(frame.body.event(phase), p, 1)
        for index, factor in _fixing(frame, p):
            A[index], right[index] = A[index] + factor * row, right[index] - factor * offset
        ends.append((row, offset))
    unknowns = solved(A, right[:, None])[:, 0]
    for p, (row, offset) in enumerate(ends):
        R[p] = acb(row @ unknowns).real + offset
    if cell.forced:
        R[frame.count] = sum(times[: frame.count], arb(0)) - frame.T


def _fixing(frame: Frame, p: int) -> Iterator[tuple[int, Any]]:
    """Yield rows of forces, and factors of an event added to them, which is 0 on orbits."""
    phase = for_harmonics(frame.cell).phases[p]
    factors = balls(phase.fixing / np.diag(phase.direct)) / frame.count
    for h, turn in enumerate(frame.turns):
        if fixes(frame.cell, turn):
            step = (acb(0, -1) * turn * p / frame.count).exp()
            yield from enumerate(factors * step, h * len(factors))


def _galerkin(frame: Frame) -> tuple[Balls, Balls]:
    """Return rows and right sides of the harmonics of: force less its law."""
    J, contacts, breaks = len(frame.turns), frame.cell.body.at.shape[1], len(frame.breaks)
    rows = np.full((J, contacts, frame.size), acb(0), dtype=object)
    right = np.full((J, contacts), acb(0), dtype=object)
    step = frame.turns[1] - frame.turns[0]
    turn = (acb(0, 1) * frame.angles[0]).exp() / 2
    for q, law in enumerate(frame.laws):
        compliance = frame.compliance(law)
        overlaps = {d: frame.integral(q, d * step) for d in range(1 - J, J)}
        by_break = np.full((J, contacts, breaks), acb(0), dtype=object)
        for h, eta in enumerate(frame.turns):
            for j in range(J):
                columns = slice(j * contacts, (j + 1) * contacts)
                rows[h, :, columns] -= compliance[j] * overlaps[j - h]
            wave = (acb(0, -1) * eta * frame.ends[q]).exp() * frame.lengths[q]
            by_break[h] = law.poles @ frame.pieces[q].by_wave(eta * frame.lengths[q]) * wave
            alone = frame.integral(q, -eta)
            rows[h, :, frame.memory :] -= law.memory * alone
            ahead, behind = (frame.integral(q, g * frame.drive - eta) for g in (1, -1))
            driven = law.turn * turn * ahead + conjugate(law.turn * turn) * behind
            right[h] += driven + law.constant * alone
        between = slice(frame.waves, frame.memory)
        rows[:, :, between] -= of_real(by_break)
    for h, eta in enumerate(frame.turns):
        for c in range(contacts):
            rows[h, c, h * contacts + c] += 1
        for i, (p, n, c) in enumerate(frame.breaks):
            if n and not eta.contains(0):  # the mean of a function is 0
                term = (acb(0, 1) * eta) ** -n * (acb(0, -1) * eta * frame.ends[p]).exp()
                rows[h, c, frame.waves + i] += term
    return rows.reshape(J * contacts, -1), right.ravel()


def _smooth(frame: Frame) -> Iterator[tuple[Balls, Any]]:
    """Yield each factor of a function with a break, a jump of a derivative: row, known part."""
    functions = frame.given.functions or 0
    for p in range(frame.count if functions else 0):
        sign, left = (1, p - 1) if p else (frame.cell.sign, frame.count - 1)
        after, before, first = frame.laws[p], frame.laws[left], max(frame.cell.classes[p], 1)
        for n in range(1, first + functions):
            if n >= first:
                rows, begins = frame.values(after, p, 0)
                ended, ends = frame.values(before, left, 1)
                size = frame.T ** (n - 1)
                yield from zip(
                    size * (rows - sign * ended), size * (begins - sign * ends), strict=True
                )
            after, before = _rate(frame, after, p), _rate(frame, before, left)


def _rate(frame: Frame, forms: Forms, p: int) -> Forms:
    """Return the derivatives of forms by time under the laws of a phase."""
    s, b, _ = frame.body.poles
    law, by_force = frame.laws[p], real(forms.poles @ b)
    poles, turn = forms.poles * s, acb(0, 1) * frame.body.omega * forms.turn
    return Forms(
        poles + by_force @ law.poles, turn + by_force @ law.turn, by_force @ law.constant,
        by_force @ law.memory, forms.direct,
    )  # fmt: skip
