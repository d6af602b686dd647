"""What one period makes of small perturbations of the exact orbit, as a table."""

import cmath
from dataclasses import dataclass

from nonsmooth.solver.exact import ExactOrbit
from nonsmooth.solver.stability.in_words import in_words
from nonsmooth.solver.stability.monodromy import NoMultipliersError


@dataclass(frozen=True)
class Row:
    """A Floquet multiplier in words: its modulus, its argument, and what it does."""

    modulus: str
    argument: str
    stable: str


@dataclass(frozen=True)
class Multipliers:
    """The multipliers of an orbit.

    Parameters
    ----------
    rows : list of Row
        The largest modulus first; a pair is two rows.
    verdict : str
        Of the orbit; why there are no multipliers, where there are none.
    shift : bool
        Whether the multiplier 1 of a shift in time is left out.
    """

    rows: list[Row]
    verdict: str
    shift: bool


def multipliers(exact: ExactOrbit) -> Multipliers:
    """Return the multipliers of the exact orbit, each with its modulus and argument."""
    _, _, verdict = in_words(exact).partition(": ")
    try:
        found = exact.stability
    except NoMultipliersError:
        return Multipliers([], verdict, shift=False)
    rows = [_row(complex(value), found.rounding) for value in found.multipliers]
    return Multipliers(rows, verdict, shift=found.trivial_multiplier is not None)


def _row(value: complex, rounding: float) -> Row:
    """Return one multiplier; what rounding does not tell from modulus 1 is said to be so."""
    modulus = abs(value)
    if abs(modulus - 1) <= rounding:
        stable = "neither, to rounding"
    else:
        stable = "stable" if modulus < 1 else "unstable"
    argument = f"{cmath.phase(value):.5g}" if value else "none"
    return Row(f"{modulus:.5g}", argument.replace("-", "−"), stable)
