"""The first event of a phase, which no step can pass over.

From a state, a form is at least its Taylor polynomial less the bound for the rest: it has no
zero before that lower bound has one.  So far a step goes; the motion there is that of the exact
flow from the start of the phase, not of the polynomial.  Near an event these steps converge as
fast as Newton's do.  A form that is zero at the start of a phase, as that of the event which
began it, is divided by time as often as it vanishes there.
"""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from ..arrays import Vector
from ..case.cell import Form, Phase
from ..flow import flow
from .bounds import TERMS, Local, bound, local, taylor, window
from .zeros import first_zero

#: What of a derivative may be rounding, as a part of the size of its terms.
NOISE = 64 * float(np.finfo(float).eps)

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
        Which of the forms vanishes; None at the end of the time that was given.
    """

    s: float
    x: float
    v: float
    form: int | None


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
    return 0 if leading == TERMS else 1 if values[leading] > 0 else -1


def _leading(values: Sequence[float], sizes: Sequence[float], zero: bool) -> int:
    """Return the order of the first derivative that is not zero; `TERMS` if there is none."""
    pairs = list(zip(values, sizes, strict=True))[zero:]
    found = (j for j, (value, size) in enumerate(pairs, zero) if abs(value) > NOISE * size)
    return next(found, TERMS)


def first_event(
    phase: Phase, start: Vector, omega: float, angle: float, forms: Sequence[Form],
    most: float, zeros: Collection[int] = (),
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

    Raises
    ------
    ArithmeticError
        If the motion is not finite, or the search takes `MOST_STEPS`.
    """
    s, (x, v) = 0.0, map(float, start)
    widest = window(phase, omega)
    for _ in range(MOST_STEPS):
        at = local(phase, x, v, omega, angle + omega * s)
        step = min(widest, most - s)
        nearest = None
        for index, form in enumerate(forms):
            safe = _safe(at, form, step, s == 0 and index in zeros)
            if safe < step:
                step, nearest = safe, index
        if nearest is not None and step <= 4 * np.finfo(float).eps * s:
            s += _last_correction(at, forms[nearest], s)
            x, v = map(float, flow.end(phase, start, angle, omega, s).state)
            return Reached(s, x, v, nearest)
        if nearest is None and s + step >= most:
            s, nearest = most, -1
        else:
            s += step
        x, v = map(float, flow.end(phase, start, angle, omega, s).state)
        if not (math.isfinite(x) and math.isfinite(v)):
            raise ArithmeticError(f"the motion in {phase.name} is beyond float64")
        if nearest == -1:
            return Reached(s, x, v, None)
    raise ArithmeticError(f"no event was located in {phase.name} within {MOST_STEPS} steps")


def _last_correction(at: Local, form: Form, s: float) -> float:
    """Return Newton's last step to a zero that is within rounding, of either sign."""
    values, _ = taylor(at, form)
    step = -values[0] / values[1] if values[1] else 0.0
    return step if abs(step) <= 1e-9 * s else 0.0


def _safe(at: Local, form: Form, most: float, zero: bool) -> float:
    """Return a time before which a form has no zero; `most` if that is longer."""
    values, sizes = taylor(at, form)
    rest = bound(at, form, most)
    powers, scale = np.empty(TERMS + 1), 1.0
    for j, value in enumerate(values):
        powers[j] = value * scale
        scale *= most / (j + 1)
    powers[TERMS] = -rest * scale
    leading = _leading(values, sizes, zero)
    if leading == TERMS:  # the form is zero all along
        return most
    if powers[leading] < 0:
        return 0.0
    if powers[leading] > -np.minimum(powers[leading + 1 :], 0.0).sum():
        return most
    found = first_zero(powers[leading:])
    return most if found is None else found * most
