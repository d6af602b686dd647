"""The stability of an orbit in words and as a document."""

from typing import TYPE_CHECKING, Any

import numpy as np

from ...nearest import counted
from ..arrays import Complex
from .monodromy import NoMultipliersError
from .stability import ROUNDING

if TYPE_CHECKING:
    from ..orbit.motion import Motion

#: Multipliers of modulus above this are shown, and so many at least.
LARGE, FEW = 0.5, 8

#: The values of `stable` in words.
VERDICTS = {True: "stable", False: "unstable", None: "neither stable nor unstable to rounding"}

#: Meaning of a multiplier of 1.
NOT_ISOLATED = "a multiplier is 1: the orbit is not isolated to first order"


def in_words(motion: "Motion") -> str:
    """Return the multipliers of an orbit and whether it is stable, in one line.

    Examples
    --------
    >>> from nonsmooth.solver.kernels import registry
    >>> from nonsmooth.solver.exact import exact_orbit
    >>> in_words(exact_orbit(registry.load("impact")()))
    'multipliers 0.42775 +- 0.26638i of modulus 0.50391: stable'
    >>> in_words(exact_orbit(registry.load("stick-slip")()))
    'multiplier 0: stable'
    """
    try:
        values, stable = motion.multipliers, motion.stable
    except NoMultipliersError as error:
        return f"no multipliers: {error}"
    name = "multiplier" if len(values) == 1 else "multipliers"
    count = count_shown(values)
    large, smaller = values[:count], len(values) - count
    less = f" and {counted(smaller, 'smaller one')}" if smaller > 0 else ""
    verdict = VERDICTS[stable]
    if stable is None and (abs(values - 1) <= motion.stability.rounding).any():
        verdict += f"; {NOT_ISOLATED}"
    return f"{name} {_numbers([complex(value) for value in large])}{less}: {verdict}"


def count_shown(values: Complex) -> int:
    """Return the number of multipliers that are shown, the largest first."""
    return max(FEW, int((np.abs(values) > LARGE).sum()))


def _numbers(values: list[complex]) -> str:
    """Return multipliers as text: a pair once, with its modulus; rounding errors as 0.

    Examples
    --------
    >>> _numbers([0.5 + 0.5j, 0.5 - 0.5j, -9.9e-17 + 0j])
    '0.5 +- 0.5i of modulus 0.70711, 0'
    """
    parts = []
    for value in values:
        if abs(value) <= ROUNDING:
            parts.append("0")
        elif value.imag > 0:
            pair = f"{value.real:.5g} +- {value.imag:.5g}i"
            parts.append(f"{pair} of modulus {abs(value):.5g}")
        elif value.imag == 0:
            parts.append(f"{value.real:.5g}")
    return ", ".join(parts)


def document(motion: "Motion") -> dict[str, Any]:
    """Return the multipliers of an orbit and its verdict; None if there are none."""
    try:
        values, stable = motion.multipliers, motion.stable
    except NoMultipliersError:
        return without_multipliers()
    parts = [{"re": float(value.real), "im": float(value.imag)} for value in values]
    return {"multipliers": parts, "stable": stable}


def without_multipliers() -> dict[str, None]:
    """Return the same document without multipliers."""
    return {"multipliers": None, "stable": None}
