"""What is not the paper's own: the C1 series with other tests, and the idea in space."""

import nonsmooth as ns

from .case import Case
from .words import percent

#: The order at which both are compared: neither is at rounding where stick is not short.
EIGHT = 8

#: The structures that the paper names.
STRUCTURES = (
    "beam-rotational-spring",
    "beam-spring",
    "beam-mass",
    "beam-crack",
    "string-mass",
)

#: Method, order and forced modes of each column.
EXPANSIONS = {
    "16 sines": ("ritz", 16, None),
    "8 sines, 1 forced mode": ("ritz-ck", 8, 1),
    "8 sines, 2 forced modes": ("ritz-ck", 8, 2),
    "Cᵏ functions, N = 4": ("ck", 4, None),
}

#: Relative error of a frequency below which only rounding is seen.
LEAST = 1e-15


def other_tests(case: Case) -> str:
    """Return how far the period is off with the paper's tests, and with Legendre's."""
    errors = []
    for method in ("c1", "c1-tau"):
        try:
            orbit = case.orbit(method, EIGHT)
        except ns.NoOrbit as missing:
            return f"In this case {missing.reason}."
        errors.append(percent(abs(orbit.period / case.exact.period - 1)))
    theirs, ours = errors
    return f"At N = {EIGHT} the period is {theirs} off with its tests and {ours} with these."


def in_space() -> dict[str, tuple[str, int, list[str]]]:
    """Return title, class and errors of the lowest frequency of each structure, by its name."""
    found = {}
    for name in STRUCTURES:
        solved = [ns.modes(name, *expansion, count=1) for expansion in EXPANSIONS.values()]
        errors = [_shown(abs(modes[0].error)) for modes in solved]
        structure = solved[0].structure
        found[name] = (structure.title, structure.k, errors)
    return found


def _shown(error: float) -> str:
    if error < LEAST:
        return "rounding"
    return f"{error:.1e}" if error < 0.1 else f"{error:.0%}"
