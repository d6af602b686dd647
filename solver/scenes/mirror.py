"""Mirror images of phases, and equivalence of forms."""

from itertools import chain
from math import frexp, isclose, ldexp
from typing import Any

from .bodies.cell import BodyPhase
from .cell import Form, Phase

#: Largest relative difference of numbers of phases, and of factors of forms, that is rounding.
ROUNDING = 1e-12


def mirror(phase: Phase) -> Phase:
    """Return the phase of the motion ``-x``, half a period of the forcing later."""
    turned: dict[str, Any] = {"f": -phase.f, "speed": -phase.speed, "d": -phase.d}
    if isinstance(phase, BodyPhase):
        turned["jumps"] = tuple((rho, -d) for rho, d in phase.jumps)
    return phase.with_forms(_mirrored, **turned)


def _mirrored(form: Form) -> Form:
    """Return a form of the mirror image: all signs change but that of the constant."""
    x, v, cos, constant, *factors = form
    return -x, -v, -cos, constant, *(-factor for factor in factors)


def same(one: Form, other: Form) -> bool:
    """Return whether two forms vanish at the same states: they are proportional.

    Each factor is compared relative to its own size, however small.

    Examples
    --------
    >>> same((1.0, 0.0, 0.0, -0.5), (-2.0, 0.0, 0.0, 1.0))
    True
    >>> same((1.0, 0.0, 0.0, -1e-300), (1.0, 0.0, 0.0, 1e-300))
    False
    >>> same((1.0, 0.0, 0.0, -1e300), (-2.0, 0.0, 0.0, 2e300))
    True
    """
    first, power = 0.0, 0
    for a, b in zip(one, other, strict=True):
        if (a == 0) != (b == 0):
            return False
        if a == 0:
            continue
        (p, of_one), (q, of_other) = frexp(a), frexp(b)  # no ratio overflows
        if first == 0:
            first, power = q / p, of_other - of_one
        ratio = ldexp(q / p, min(max(of_other - of_one - power, -4), 4))
        if not abs(ratio - first) <= ROUNDING * abs(first):
            return False
    return first != 0


def alike(one: Phase, other: Phase) -> bool:
    """Return whether two phases without a memory have the same motions."""

    def numbers(q: Phase) -> tuple[float, ...]:
        return q.m, q.c, q.k, q.f, q.g, q.held, q.speed, *chain.from_iterable(q.jumps)

    def close(a: float, b: float) -> bool:
        return isclose(a, b, rel_tol=ROUNDING)

    def laws(q: Phase) -> tuple[Form, ...]:
        return (q.event, *q.laws) if isinstance(q, BodyPhase) else (q.event,)

    forms, theirs = ([form for _, form in q.demands] for q in (one, other))
    return (
        all(map(close, numbers(one), numbers(other)))
        and len(forms) == len(theirs)
        and not (one.memory or other.memory)
        and all(map(same, laws(one), laws(other)))
        and all(any(same_demand(a, b) for b in theirs) for a in forms)
    )


def opposed(one: Phase, other: Phase) -> bool:
    """Return whether a demand of one phase is the opposite of a demand of another.

    Phases of the same equation are then two: the motion passes from one into the other where
    the demand vanishes.
    """
    return any(
        same(a, b) and all(p * q <= 0 for p, q in zip(a, b, strict=True))
        for _, a in one.demands
        for _, b in other.demands
    )


def same_demand(one: Form, other: Form) -> bool:
    """Return whether two forms are nonnegative at the same states."""
    return same(one, other) and all(a * b >= 0 for a, b in zip(one, other, strict=True))
