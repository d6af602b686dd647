"""Mirror images of phases, and forms that say the same."""

from dataclasses import replace

import numpy as np

from .bodies.cell import BodyPhase
from .cell import Form, Phase

#: What may be rounding of the factors of a form, as a part of each.
ROUNDING = 1e-12


def mirror(phase: Phase) -> Phase:
    """Return the mirror image of a phase: the motion ``-x`` half a period of the forcing on."""
    there = phase.with_forms(_mirrored)
    there = replace(there, f=-phase.f, speed=-phase.speed, d=-phase.d)
    if isinstance(there, BodyPhase):
        there = replace(there, jumps=tuple((rho, -d) for rho, d in there.jumps))
    return there


def _mirrored(form: Form) -> Form:
    x, v, cos, constant, *others = form
    return -x, -v, -cos, constant, *(-factor for factor in others)


def same(one: Form, other: Form) -> bool:
    """Whether two forms vanish at the same states: their factors are in one proportion.

    Each factor counts, however small it is beside the others.

    Examples
    --------
    >>> same((1.0, 0.0, 0.0, -0.5), (-2.0, 0.0, 0.0, 1.0))
    True
    >>> same((1.0, 0.0, 0.0, -1e-300), (1.0, 0.0, 0.0, 1e-300))
    False
    >>> same((1.0, 0.0, 0.0, -1e300), (-2.0, 0.0, 0.0, 2e300))
    True
    """
    a, b = np.array(one), np.array(other)
    where = a != 0
    if not where.any() or (where != (b != 0)).any():
        return False
    (p, power), (q, other_power) = np.frexp(a[where]), np.frexp(b[where])  # no ratio overflows
    powers = other_power - power
    ratios = np.ldexp(q / p, np.clip(powers - powers[0], -4, 4))
    return bool((np.abs(ratios - ratios[0]) <= ROUNDING * np.abs(ratios[0])).all())


def is_image(one: Phase, other: Phase) -> bool:
    """Whether a phase without a memory is the mirror image of another."""

    def numbers(q: Phase) -> tuple[object, ...]:
        return q.m, q.c, q.k, q.f, q.g, q.held, q.speed, q.jumps

    def laws(q: Phase) -> tuple[Form, ...]:
        return (q.event, *q.laws) if isinstance(q, BodyPhase) else (q.event,)

    there = mirror(one)
    alike = numbers(there) == numbers(other) and all(map(same, laws(there), laws(other)))
    forms, others = ([form for _, form in q.demands] for q in (there, other))
    demands = all(any(_demand_the_same(a, b) for b in others) for a in forms)
    return alike and demands and len(forms) == len(others) and not (one.memory or other.memory)


def _demand_the_same(one: Form, other: Form) -> bool:
    """Whether two forms are not negative at the same states."""
    return same(one, other) and all(a * b >= 0 for a, b in zip(one, other, strict=True))
