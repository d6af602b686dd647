"""The first event of a phase, which no step can pass over.

From a state, a form is at least its Taylor polynomial less the bound for the rest: it has no
zero before that lower bound has one.  So far a step goes; the motion there is that of the exact
flow from the start of the phase, not of the polynomial.  Near an event these steps converge as
fast as Newton's do.  A form that falls below zero by no more than its rounding only touches it,
which is not an event.  A form that is zero at the start of a phase, as that of the event which
began it, is divided by time as often as it vanishes there.
"""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Vector
from ..flow import flow
from ..scenes.cell import Form, Phase
from .bounds import TERMS, Local, bound, local, taylor, window
from .zeros import DEPTH, first_zero

#: What of a derivative may be rounding, as a part of the size of its terms.
NOISE = 64 * float(np.finfo(float).eps)

#: A time, without units, in which nothing happens.
SHORTEST = 1e-280

#: Steps of one phase before a search is given up; some ten are usual for a period.
MOST_STEPS = 100_000


@dataclass(frozen=True)
class Reached:
    """Where a phase ends.

    Parameters
    ----------
    s : float
        How long it lasted.
    x, v : float
        The state there, before the switch.
    form : int or None
        Which of the forms vanishes; None if none did.
    ended : str
        Why it was not followed to the end of its time; empty if it was.
    """

    s: float
    x: float
    v: float
    form: int | None
    ended: str = ""


def sign_after(at: Local, form: Form, zero: bool = False) -> int:
    """Return the sign of a form just after a state: of its first derivative but zeros.

    Parameters
    ----------
    at : Local
    form : Form
    zero : bool
        Whether the form itself is known to be zero there, whatever rounding makes of it.
    """
    values, sizes = taylor(at, form)
    leading = _leading(values, sizes, zero)
    if leading == TERMS:
        return 0
    return 1 if values[leading] > 0 or (leading == 1 and _touch(values, sizes)) else -1


def _touch(values: Sequence[float], sizes: Sequence[float]) -> float:
    """Return a time after which a form that is zero, and falls, has risen again.

    It is 0 where the form falls below zero by more than its rounding: elsewhere it only
    touches zero, and nobody can tell whether it passes.
    """
    _, slope, curvature, third, *_ = values
    if not slope < 0 < curvature:
        return 0.0
    risen = -4 * slope / curvature
    touches = -slope * risen / 8 <= NOISE * sizes[0] and abs(third) * risen <= curvature
    return risen if touches else 0.0


def _leading(values: Sequence[float], sizes: Sequence[float], zero: bool) -> int:
    """Return the order of the first derivative that is not zero; `TERMS` if there is none."""
    pairs = list(zip(values, sizes, strict=True))[zero:]
    found = (j for j, (value, size) in enumerate(pairs, zero) if abs(value) > NOISE * size)
    return next(found, TERMS)


def first_event(
    phase: Phase, start: Vector, omega: float, angle: float, forms: Sequence[Form],
    most: float, zeros: Collection[int] = (), placed: bool = False,
) -> Reached:  # fmt: skip
    """Return where the first of some forms vanishes.

    Parameters
    ----------
    phase : Phase
        Which motion is followed.
    start : ndarray, shape (2,)
        Displacement and velocity at its start.
    omega, angle : float
        The forcing is ``cos(omega s + angle)``.
    forms : sequence of Form
        Each not negative just after the start.
    most : float
        Time after which the search ends.
    zeros : collection of int
        Which of the forms are known to be zero at the start.
    placed : bool
        Whether the displacement at the start is exact to its own rounding.
    """
    begin = float(start[0]), float(start[1])
    s, (x, v) = 0.0, begin
    widest = window(phase, omega)
    largest = max((abs(factor) for form in forms for factor in form), default=1.0)
    for _ in range(MOST_STEPS):
        at = local(phase, x, v, omega, angle + omega * s, placed and s == 0)
        if not math.isfinite(max(largest, 1.0) * sum(at.sizes)):
            return Reached(s, x, v, None, f"the motion in {phase.name} is beyond float64")
        step, nearest = _step(at, forms, min(widest, most - s), zeros if s == 0 else ())
        found = nearest is not None and step <= 4 * np.finfo(float).eps * s
        if found:
            end = s + _last_correction(at, forms[nearest], s)  # type: ignore[index]
        else:
            end = most if nearest is None and s + step >= most else s + step
        there = flow.state_at(phase, *begin, angle, omega, end)
        if not (math.isfinite(there[0]) and math.isfinite(there[1])):
            return Reached(s, x, v, None, f"the motion in {phase.name} is beyond float64")
        s, (x, v) = end, there
        if found or s == most:
            return Reached(s, x, v, nearest if found else None)
    words = f"no event was located in {phase.name} within {MOST_STEPS} steps"
    return Reached(s, x, v, None, words)


def _step(
    at: Local, forms: Sequence[Form], most: float, zeros: Collection[int]
) -> tuple[float, int | None]:
    """Return a time before which no form has a zero, and which may have one there."""
    step, nearest = most, None
    for index, form in enumerate(forms):
        safe = _safe(at, form, step, index in zeros)
        if safe < step:
            step, nearest = safe, index
    return step, nearest


def _last_correction(at: Local, form: Form, s: float) -> float:
    """Return Newton's last step to a zero that is within rounding, of either sign."""
    values, _ = taylor(at, form)
    step = -values[0] / values[1] if values[1] else 0.0
    return step if abs(step) <= 1e-9 * s else 0.0


def _safe(at: Local, form: Form, most: float, zero: bool) -> float:
    """Return a time before which a form has no zero; `most` if that is longer."""
    values, sizes = taylor(at, form)
    leading = _leading(values, sizes, zero)
    if leading == TERMS or most < SHORTEST:  # the form is zero all along
        return most
    if values[leading] < 0:
        return min(most, _touch(values, sizes)) if leading == 1 else 0.0
    powers, scale = [], 1.0
    for j, value in enumerate(values):
        powers.append(value * scale)
        scale *= most / (j + 1)
    powers.append(-bound(at, form, most) * scale)
    if powers[leading] > -sum(min(power, 0.0) for power in powers[leading + 1 :]):
        return most
    found = first_zero(powers[leading:]) if all(map(math.isfinite, powers)) else 0.0
    if found is None:
        return most
    if found == 0:  # an interval of the size of what is left
        return _safe(at, form, most * 2.0**-DEPTH, zero)
    return found * most
