"""The first event of a phase, which no step can pass over.

A form is at least its Taylor polynomial minus a bound of the remainder, so it has no zero
before this lower bound has one.  A step goes to the first zero of the bound; the state there
comes from the exact flow since the start of the phase, not from the polynomial.  Near an event
the steps converge as fast as Newton's method.  A form that falls below zero by no more than its
rounding error only touches it: that is no event.  A form that vanishes at the start of a phase,
as that of the event which began it, is divided by the power of time with which it vanishes.
"""

from collections.abc import Sequence
from math import isfinite
from typing import NamedTuple

from ...flow.responses import state_at
from ...scenes.cell import Form
from .bounds import TERMS, Equation, Local, bound, local, taylor, window
from .zeros import NARROW, Polynomial, first_zero

#: Machine epsilon.
EPS = 2.0**-52

#: Rounding error of a derivative, relative to the sum of the moduli of its terms.
NOISE = 64 * EPS

#: The shortest time, without units, on which a form is examined.
SHORTEST = 1e-280

#: Steps after which the search in a phase is given up; about ten are usual for a period.
MOST_STEPS = 100_000

#: How a phase ended: by an event, cut off at the end of its time, beyond the range of float64,
#: or after too many steps of the search.
EVENT, CUT, BEYOND, LOST = range(4)


class Reached(NamedTuple):
    """The end of a phase: its duration `s`, and the state there, before the switch.

    `how` is `EVENT`, `CUT`, `BEYOND` or `LOST`; `form` is the index of the form that vanishes.
    """

    s: float
    x: float
    v: float
    how: int
    form: int


def sign_after(at: Local, form: Form, zero: bool) -> int:
    """Return the sign of a form just after a state: that of its first nonzero derivative.

    `zero`: the form is known to vanish at the state, whatever the rounding.
    """
    values, sizes = taylor(at, form)
    leading = _leading(values, sizes, zero)
    if leading == TERMS:
        return 0
    return 1 if values[leading] > 0 or (leading == 1 and _touch(values, sizes) > 0) else -1


def _touch(values: tuple[float, ...], sizes: tuple[float, ...]) -> float:
    """Return a time after which a form that is zero and falls is positive again.

    It is 0 where the form falls below zero by more than its rounding error.  Otherwise float64
    cannot tell a passage from a tangency, and it counts as touching.
    """
    slope, curvature, third = values[1], values[2], values[3]
    if not slope < 0 < curvature:
        return 0.0
    risen = -4 * slope / curvature
    touches = -slope * risen / 8 <= NOISE * sizes[0] and abs(third) * risen <= curvature
    return risen if touches else 0.0


def _leading(values: tuple[float, ...], sizes: tuple[float, ...], zero: bool) -> int:
    """Return the order of the first derivative above rounding; `TERMS` if there is none."""
    for j in range(1 if zero else 0, TERMS):
        if abs(values[j]) > NOISE * sizes[j]:
            return j
    return TERMS


def first_event(
    phase: Equation, x: float, v: float, angle: float, placed: bool,
    forms: Sequence[Form], zeros: Sequence[bool], most: float,
) -> Reached:  # fmt: skip
    """Return the first zero of any of some forms, and the state there.

    Parameters
    ----------
    placed : bool
        Whether the displacement at the start is exact to its own rounding.
    forms : sequence of Form
        Linear event functions, none negative just after the start.
    zeros : sequence of bool
        Which of the forms are known to vanish at the start.
    most : float
        Time at which the search ends.
    """
    s, at_x, at_v, omega = 0.0, x, v, phase.omega
    widest, largest = window(phase, omega), _largest(forms)
    for _ in range(MOST_STEPS):
        at = local(phase, at_x, at_v, angle + omega * s, placed and s == 0)
        if not isfinite(largest * sum(at.sizes)):
            return Reached(s, at_x, at_v, BEYOND, 0)
        step, nearest = min(widest, most - s), -1
        for index in range(len(forms)):
            safe = _safe(at, forms[index], step, zeros[index] and s == 0)
            if safe < step:
                step, nearest = safe, index
        at_zero = nearest >= 0 and step <= 4 * EPS * s
        if at_zero:
            end = s + _last_correction(at, forms[nearest], s)
        else:
            end = most if nearest < 0 and s + step >= most else s + step
        new_x, new_v = state_at(phase, x, v, angle, omega, end)
        if not (isfinite(new_x) and isfinite(new_v)):
            return Reached(s, at_x, at_v, BEYOND, 0)
        s, at_x, at_v = end, new_x, new_v
        if at_zero or s == most:
            return Reached(s, at_x, at_v, EVENT if at_zero else CUT, nearest)
    return Reached(s, at_x, at_v, LOST, 0)


def _largest(forms: Sequence[Form]) -> float:
    """Return the largest modulus of a coefficient of some forms; 1 at least."""
    largest = 1.0
    for form in forms:
        for i in range(4):
            largest = max(largest, abs(form[i]))
    return largest


def _last_correction(at: Local, form: Form, s: float) -> float:
    """Return the last Newton correction of a located zero, of either sign; 0 if it is large."""
    values, _ = taylor(at, form)
    step = -values[0] / values[1] if values[1] != 0 else 0.0
    return step if abs(step) <= 1e-9 * s else 0.0


def _safe(at: Local, form: Form, most: float, zero: bool) -> float:
    """Return a time, up to `most`, before which a form has no zero."""
    values, sizes = taylor(at, form)
    leading = _leading(values, sizes, zero)
    if leading == TERMS:  # the form is identically zero
        return most
    if values[leading] < 0 and most >= SHORTEST:
        return min(most, _touch(values, sizes)) if leading == 1 else 0.0
    while most >= SHORTEST:
        powers = _from_below(values, bound(at, form, most), most)
        for _ in range(leading):
            _, b, c, d, e, f, g = powers
            powers = (b, c, d, e, f, g, 0.0)
        falls, size = 0.0, powers[0]
        for power in powers[1:]:
            falls -= 0.0 if power >= 0 else power
            size += abs(power)
        if powers[0] > falls:
            return most
        root = first_zero(powers) if isfinite(size) else 0.0
        if root > 0:
            return min(root, 1.0) * most
        most *= NARROW  # a zero this near, or overflow: a shorter interval
    return most


def _from_below(values: tuple[float, ...], rest: float, s: float) -> Polynomial:
    """Return a lower bound of a form within a time `s`: powers of time / s on [0, 1]."""
    a, b, c, d, e, f = values
    s2 = s * s / 2
    s3, s4 = s2 * s / 3, s2 * s / 3 * s / 4
    return a, b * s, c * s2, d * s3, e * s4, f * (s4 * s / 5), -rest * (s4 * s / 5 * s / 6)
