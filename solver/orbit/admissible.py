"""Whether a solution of the equations is an orbit: the inequalities that they leave out.

The equations of a cell, exact or of an expansion, have roots that are not a motion of the
oscillator: a state on the wrong side of a limit, an event crossed from beyond it, a phase of no
duration.  Each demand of a phase is followed over the phase through its critical points, and
must fall where the event that ends the phase is the end of the demand.
"""

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from ..arrays import Vector
from ..bodies.laws import places
from ..scenes.cell import Form
from . import chebyshev
from .condition import moved_times
from .crossings import met_before
from .forms import scale_of, value, value_at, vanishes_by_event
from .motion import LOOK, Motion, OrbitPhase
from .transients import cuts

#: How far below 0 rounding may bring a demand, relative to its scale.
ROUNDING = 1e-9

#: The same for one mass, relative to the sum of the moduli of the demand's terms.
OF_TERMS = 1e-13

#: Shortest phase, relative to the cell; without a forcing also to the unit of time, as all may
#: shrink at once.  A phase that shrinks to nothing solves the equations of many scenes; its
#: computed duration is a rounding error of either sign.
SHORTEST = 1e-10

#: Duration, relative to the same, below which the effect of rounding on it is estimated.
SHORT = 1e-6

#: Largest displacement or velocity that is said to be 0, relative to that of the motion.
NOTHING = 1e-12

#: What the violation of a demand that holds nowhere in its phase begins with.
THROUGHOUT = "throughout"

#: Unit roundoff of float64.
ROUNDOFF = float(np.finfo(float).eps) / 2

#: Largest bound of the rounding error of a duration, relative to it.  That of one mass is above
#: 1: the bound also counts terms that are exact.
UNKNOWN, UNKNOWN_OF_BODY = 1.3, 0.3

#: Range of the mean velocity in a held phase, relative to the prescribed one.  An expansion of
#: low order shortens such a phase; nothing but a spurious root makes it much longer.
HELD = (0.5, 3.0)

#: Differences of times and states, relative to the period and to their extremes, below which
#: parts of an orbit are the same: between distinct orbits they are larger.
SAME = 1e-6

#: ``allowed(p, form)``: how far below 0 a demand on phase p may be, relative to its scale.  It
#: is at least `ROUNDING`, and called only for demands that are further below 0 than that.
Allowance = Callable[[int, Form], float]


class Undecided(str):
    """Why float64 cannot decide whether a solution is an orbit; it is then not returned."""

    __slots__ = ()


def only_rounding(p: int, form: Form) -> float:
    """Allow rounding errors."""
    return ROUNDING


def violations(
    orbit: Motion, allowed: Allowance = only_rounding, unmet: float = 0.0
) -> tuple[str, ...]:
    """Return the demands that an orbit violates, in words with SI units; empty if none.

    Parameters
    ----------
    allowed : callable
        How far below 0 a demand may fall; `allowance` has those for expansions.
    unmet : float
        For equations that do not impose the event of the first phase: the value that its event
        function may have at its end, relative to that at its begin.  Else 0.
    """
    durations = orbit.cell_durations
    total, unit = float(np.sum(durations)), orbit.case.units.time
    reasons = [
        f"{phase.name} lasts {s * unit:.6g} s of {total * unit:.6g} s: it has no duration"
        for phase, s in zip(orbit.cell.phases, durations, strict=True)
        if not s > SHORTEST * _long(orbit) > 0
    ]
    if reasons or not np.isfinite(durations).all():
        return tuple(reasons) or ("the durations are not finite",)
    undetermined = _undetermined(orbit)
    if undetermined:
        return undetermined
    if _is_still(orbit):
        return ("nothing moves beyond rounding: it is a rest",)
    if unmet:
        reasons += _unmet(orbit, unmet)
        allowed = _with_unmet(orbit, allowed, unmet)
    for p, phase in enumerate(orbit.cell.phases):
        reasons += _held(orbit, p)
        for words, form in phase.demands:
            reasons += _demand(orbit, p, words, form, allowed)
        for words, form in phase.switch_demands:
            reasons += _at_switch(orbit, p, words, form, allowed)
        if not any(vanishes_by_event(orbit, p, form) for _, form in phase.demands):
            reasons += _too_late(orbit, p, allowed)
    return tuple(reasons) or _repeated(orbit)


def _long(orbit: Motion) -> float:
    """Return a duration that is not short, without units: of the cell or, unforced, of 1."""
    total = float(orbit.cell_durations.sum())
    return total if orbit.cell.forced else max(total, 1.0)


def _undetermined(orbit: Motion) -> tuple[str, ...]:
    """Return which phases are so short that their duration may be a rounding error."""
    durations, unit = orbit.cell_durations, orbit.case.units.time
    if durations.min() > SHORT * _long(orbit):
        return ()
    unknown = UNKNOWN_OF_BODY if orbit.case.scene.has_body else UNKNOWN
    with np.errstate(all="ignore"):
        moved = ROUNDOFF * moved_times(orbit, with_sums=True)
    return tuple(
        Undecided(f"{phase.name} lasts {s * unit:.6g} s, and rounding may be as much")
        for phase, s, change in zip(orbit.cell.phases, durations, moved, strict=False)
        if not change < unknown * s
    )


def _is_still(orbit: Motion) -> bool:
    """Whether a motion without a forcing is a rest, at which all equations hold to rounding."""
    if orbit.cell.forced:
        return False
    phases = orbit.cell.phases
    displacements = places(len(phases[0].jumps))[0]
    found = np.hstack([orbit.signals(p, LOOK)[displacements] for p in range(len(phases))])
    return bool(np.ptp(found, axis=1).max() <= NOTHING * np.abs(found).max())


def seen_violated(orbit: Motion) -> int:
    """Return how many demands are violated beyond rounding at one of the points of `LOOK`.

    This is far cheaper than `violations` where a phase has many waves, and implies them.
    """
    durations = orbit.cell_durations
    if not (np.isfinite(durations).all() and (durations > 0).all()):
        return 0
    return sum(
        float(value(orbit, p, form, LOOK).min()) < -ROUNDING * scale_of(orbit, p, form)
        for p, phase in enumerate(orbit.cell.phases)
        for _, form in phase.demands
    )


def _unmet(orbit: Motion, unmet: float) -> list[str]:
    """Return that the first phase ends further than `unmet` from its event, if it does."""
    phase = orbit.cell.phases[0]
    begin, end = value(orbit, 0, phase.event, np.array([0.0, 1.0]))
    off = float(end / begin) if begin else np.inf
    if abs(off) <= unmet:
        return []
    return [
        f"{phase.name} ends {abs(off):.3g} of its way {'before' if off > 0 else 'beyond'} its "
        f"event (allowed: {unmet:.3g})"
    ]


def _with_unmet(orbit: Motion, allowed: Allowance, unmet: float) -> Allowance:
    """Return an allowance raised to `unmet` for a demand that is the event of phase 0."""

    def allowed_with_unmet(p: int, form: Form) -> float:
        if p or not vanishes_by_event(orbit, p, form):
            return allowed(p, form)
        begin = value_at(orbit, p, form, 0.0)
        return max(allowed(p, form), unmet * abs(begin) / scale_of(orbit, p, form))

    return allowed_with_unmet


def _too_late(orbit: Motion, p: int, allowed: Allowance) -> list[str]:
    """Return that a phase passes its event before its end, if it does."""
    phase = orbit.cell.phases[p]
    u = met_before(orbit, p, ROUNDING)
    u = u if u is None else met_before(orbit, p, allowed(p, phase.event))
    if u is None:
        return []
    return [f"{phase.name} would end {_state(orbit, p, u)}: its event is met there"]


def _at_switch(orbit: Motion, p: int, words: str, form: Form, allowed: Allowance) -> list[str]:
    """Return how a demand at the end of a phase is violated, if it is."""
    scale, below = scale_of(orbit, p, form), -value_at(orbit, p, form, 1.0)
    if below <= ROUNDING * scale or below <= allowed(p, form) * scale:
        return []
    return [
        f"where {orbit.cell.phases[p].name} ends, not true that {words}: by "
        f"{below / scale:.3g} of its size {_state(orbit, p, 1.0)} "
        f"(allowed: {allowed(p, form):.2g})"
    ]


def _repeated(orbit: Motion) -> tuple[str, ...]:
    """Return that an orbit is several passages of a shorter one, if it is."""
    phases, cell = orbit.phases, orbit.cell
    for times in range(cell.cycles if cell.forced else len(phases), 1, -1):
        if len(phases) % times or (cell.forced and cell.cycles % times):
            continue
        later = len(phases) // times
        if not are_same(orbit, [*phases[later:], *phases[:later]]):
            continue
        if not cell.forced:
            return (f"it is an orbit of {later} phases, {times} times in a row",)
        count = cell.cycles // times
        cycles = f"{count} cycle{'s' if count > 1 else ''}"
        return (f"it is an orbit of {cycles} of the forcing, {times} times in a row",)
    return ()


def are_same(orbit: Motion, phases: Sequence[OrbitPhase]) -> bool:
    """Return whether the phases of an orbit equal others up to rounding."""
    pairs = list(zip(orbit.phases, phases, strict=True))
    largest = max(abs(one.duration - other.duration) for one, other in pairs)
    if largest > SAME * orbit.period:
        return False
    x, v = (max(map(abs, ends)) for ends in orbit.extremes.values())
    return all(
        abs(one.displacement - other.displacement) <= SAME * x
        and abs(one.velocity - other.velocity) <= SAME * v
        for one, other in pairs
    )


def _held(orbit: Motion, p: int) -> list[str]:
    """Return that the mean velocity of a held phase is far from the prescribed one, if so."""
    phase, s = orbit.cell.phases[p], float(orbit.cell_durations[p])
    if not (phase.held and phase.speed):
        return []
    first, last = orbit.part(p, np.array([0.0, 1.0]), 0)
    mean = float(last - first) / s / phase.speed
    if HELD[0] <= mean <= HELD[1]:
        return []
    return [
        f"the mean velocity in {phase.name} is {mean:.3g} times that at which it is held: "
        "the order does not resolve the phase"
    ]


def _demand(orbit: Motion, p: int, words: str, form: Form, allowed: Allowance) -> list[str]:
    """Return how a demand is violated within a phase, if it is."""
    phase, scale = orbit.cell.phases[p], scale_of(orbit, p, form)
    signal = partial(value, orbit, p, form)
    if not np.isfinite(scale):
        return [Undecided(f"in {phase.name}, where {words}: the motion is not finite")]
    parts = chebyshev.pieces(signal, scale, cuts(orbit, p))
    if not all(part.resolved for part in parts):
        why = "the motion has more waves than can be followed, or is smaller than rounding"
        return [Undecided(f"in {phase.name}, where {words}: {why}")]
    points = chebyshev.candidates(parts)
    values = signal(points)
    worst = int(np.argmin(values))
    below, rounding = -float(values[worst]), _rounding_of(orbit, scale, values)
    if below > rounding and (allowed is only_rounding or below > allowed(p, form) * scale):
        where = _state(orbit, p, float(points[worst]))
        span = "in" if values.max() > rounding else THROUGHOUT
        return [
            f"{span} {phase.name}, not true that {words}: by {below / scale:.3g} of "
            f"its size {where} (allowed: {allowed(p, form):.2g})"
        ]
    if vanishes_by_event(orbit, p, form) and not _slope_at_end(orbit, p, form, parts) < 0:
        return [
            f"{phase.name} ends from beyond its limit ({words}) {_state(orbit, p, 1.0)}: "
            "its event is crossed in the wrong direction"
        ]
    return []


def _slope_at_end(orbit: Motion, p: int, form: Form, parts: list[chebyshev.Piece]) -> float:
    """Return the rate of a form where a phase ends, up to a positive factor.

    For one mass by the velocity there, as differences of values may all be rounding.
    """
    end = np.ones(1)
    if orbit.case.scene.has_body:
        return float(chebyshev.derivative_at(parts, end, 1)[0])
    v, a = (float(orbit.part(p, end, j)[0]) for j in (1, 2))
    sine = float(np.sin(orbit.angle_at(p, end))[0])
    return float(np.dot(form[:3], (v, a, -orbit.cell.omega * sine)))


def _rounding_of(orbit: Motion, scale: float, values: Vector) -> float:
    """Return how far below 0 rounding may bring a demand with these values on a phase.

    For one mass it is relative to the largest value: a demand may be a small difference of
    large terms.
    """
    if orbit.case.scene.has_body:
        return ROUNDING * scale
    return max(ROUNDING * float(np.abs(values).max()), OF_TERMS * scale)


def _state(orbit: Motion, p: int, u: float) -> str:
    """Return time and state at local time `u` of phase `p`, in words; 0 for rounding error."""
    units, at = orbit.case.units, np.array([u])
    t = (float(np.sum(orbit.cell_durations[:p])) + u * float(orbit.cell_durations[p])) * (
        units.time
    )
    phases, state = range(len(orbit.cell.phases)), []
    for j in (0, 1):
        size = max(float(np.abs(orbit.part(q, LOOK, j)).max()) for q in phases)
        here = float(orbit.part(p, at, j)[0])
        state.append(0.0 if abs(here) <= NOTHING * size else here * units.of_motion(j))
    x, v = state
    return f"at t = {t:.6g} s, where x = {x:.6g} m and x' = {v:.6g} m/s"
